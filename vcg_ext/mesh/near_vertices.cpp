// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/mesh/near_vertices.h"

#include "vcg_ext/exact/point_groups.h"

#include <algorithm>
#include <cmath>

namespace index_boolean {

namespace {

bool isFinite(const Point& p) {
	return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

// The vertices of an operand that its faces use and that are finite; ascending.
std::vector<VertexId> usedVertices(const MeshArrays& mesh, OperandId operand) {
	const std::uint32_t first = mesh.vertexOffsets.begin(operand);
	const std::uint32_t end = mesh.vertexOffsets.end(operand);
	std::vector<std::uint8_t> isUsed(end - first, 0);
	for (std::uint32_t f = mesh.faceOffsets.begin(operand); f < mesh.faceOffsets.end(operand);
	     ++f) {
		for (const VertexId v : mesh.triangles[f]) {
			if (v.value >= first && v.value < end) {
				isUsed[v.value - first] = 1;
			}
		}
	}
	std::vector<VertexId> used;
	for (std::uint32_t v = first; v < end; ++v) {
		if (isUsed[v - first] != 0 && isFinite(mesh.points[v])) {
			used.push_back({v});
		}
	}
	return used;
}

double distanceOf(const Point& a, const Point& b) {
	return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

// The refusal of an operand with groups that are too wide.
// \param used its vertices \param smallest of each one's group, an index of these \param wide of
// these, too
Status refuseWide(const MeshArrays& mesh, OperandId operand, const std::vector<VertexId>& used,
                  const std::vector<std::uint32_t>& smallest,
                  const std::vector<std::uint32_t>& wide) {
	Status status = statusOf(StatusCode::WeldTooWide);
	status.operand = numberOf(operand);
	status.count = wide.size();
	status.hasPlace = true;
	const auto placeOf = [&](std::uint32_t i) -> const Point& { return at(mesh.points, used[i]); };
	status.place = placeOf(*std::min_element(
	    wide.begin(), wide.end(), [&](auto a, auto b) { return placeOf(a) < placeOf(b); }));
	std::vector<std::uint8_t> isWide(mesh.vertexOffsets.size(operand), 0);
	const std::uint32_t first = mesh.vertexOffsets.begin(operand);
	for (std::size_t i = 0; i < used.size(); ++i) {
		if (std::binary_search(wide.begin(), wide.end(), smallest[i])) {
			isWide[used[i].value - first] = 1;
		}
	}
	const std::uint32_t firstFace = mesh.faceOffsets.begin(operand);
	for (std::uint32_t f = firstFace; f < mesh.faceOffsets.end(operand); ++f) {
		const Triangle& t = mesh.triangles[f];
		if (std::any_of(t.begin(), t.end(), [&](VertexId v) {
			    return v.value >= first && v.value - first < isWide.size() &&
			           isWide[v.value - first] != 0;
		    })) {
			status.faces.push_back(f - firstFace);
		}
	}
	return status;
}

Status weldOperand(double distance, OperandId operand, Monitor& monitor, MeshArrays& mesh,
                   VertexWeld& out) {
	const std::vector<VertexId> used = usedVertices(mesh, operand);
	Points points;
	points.reserve(used.size());
	std::transform(used.begin(), used.end(), std::back_inserter(points),
	               [&](VertexId v) { return at(mesh.points, v); });
	std::vector<std::uint32_t> smallest, wide;
	const Status status = inOrder(
	    [&] { return groupPoints(points, distance, monitor, smallest); },
	    [&] { return findWideGroups(points, smallest, distance, monitor, wide); },
	    [&] { return wide.empty() ? Status{} : refuseWide(mesh, operand, used, smallest, wide); });
	for (std::size_t i = 0; i < used.size() && status.ok(); ++i) {
		const Point& place = points[smallest[i]];
		if (points[i] != place) {
			at(mesh.points, used[i]) = place;
			++out.moved;
			out.largestMove = std::max(out.largestMove, distanceOf(points[i], place));
		}
	}
	return status;
}

}  // namespace

Status weldNearVertices(double distance, Monitor& monitor, MeshArrays& mesh, VertexWeld& out) {
	out = {};
	return forEachOperand(mesh.operands(), [&](OperandId operand) {
		return distance > 0 ? weldOperand(distance, operand, monitor, mesh, out) : Status{};
	});
}

}  // namespace index_boolean
