// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Half-edges sorted by their edge: the two of a faux edge are neighbours in the list.
#include "vcg_ext/arrange/joined_polygons.h"

#include "vcg_ext/base/edge_table.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/base/union_find.h"
#include "vcg_ext/exact/exact_sign.h"

#include <algorithm>

namespace index_boolean {

namespace {

// Whether a half-edge, in a list sorted by edge, is the first of two that join their faces.
enum class Join : std::uint8_t { None, Bent, Flat };

// The half-edges of one operand that may join faces. An edge with more than two faces has ends at
// which the operand is no manifold, and so has one at a border: between such vertices, all
// half-edges are looked at.
std::vector<HalfEdge> listHalfEdges(const Arrangement& arrangement, OperandId operand) {
	const MeshArrays& mesh = arrangement.mesh;
	const std::vector<VertexId>& nonManifold = arrangement.nonManifold;
	const auto isOdd = [&](VertexId v) {
		return std::binary_search(nonManifold.begin(), nonManifold.end(), v);
	};
	std::vector<HalfEdge> halfEdges;
	for (std::size_t f = mesh.faceOffsets.begin(operand); f < mesh.faceOffsets.end(operand); ++f) {
		for (std::size_t i = 0; (mesh.faux[f] != 0 || !nonManifold.empty()) && i < 3; ++i) {
			const VertexId from = mesh.triangles[f][i];
			const VertexId to = mesh.triangles[f][(i + 1) % 3];
			if (isFaux(mesh.faux[f], i) || (isOdd(from) && isOdd(to))) {
				halfEdges.push_back(makeHalfEdge(from.value, to.value, f, i));
			}
		}
	}
	return halfEdges;
}

// What the i-th of the sorted half-edges is.
Join joinAt(const MeshArrays& mesh, const std::vector<HalfEdge>& sorted, std::size_t i) {
	const bool isFirst = i == 0 || !sorted[i - 1].sameEdge(sorted[i]);
	const bool hasMate = i + 1 < sorted.size() && sorted[i + 1].sameEdge(sorted[i]);
	if (!isFirst || !hasMate || (i + 2 < sorted.size() && sorted[i + 2].sameEdge(sorted[i]))) {
		return Join::None;
	}
	const HalfEdge &a = sorted[i], &b = sorted[i + 1];
	const bool joins = a.forward != b.forward && isFaux(mesh.faux[a.face], a.corner) &&
	                   isFaux(mesh.faux[b.face], b.corner);
	if (!joins) {
		return Join::None;
	}
	return commonFront(mesh, {a.face}, {b.face}) > 0 ? Join::Flat : Join::Bent;
}

// The axis along which all corners of two triangles have one coordinate, or -1.
int commonLevel(const MeshArrays& mesh, const Triangle& s, const Triangle& t) {
	for (int axis = 0; axis < 3; ++axis) {
		const auto k = static_cast<std::size_t>(axis);
		const double level = at(mesh.points, s[0])[k];
		const auto isLevel = [&](VertexId v) { return at(mesh.points, v)[k] == level; };
		if (std::all_of(s.begin(), s.end(), isLevel) && std::all_of(t.begin(), t.end(), isLevel)) {
			return axis;
		}
	}
	return -1;
}

int turnOf(const MeshArrays& mesh, const Triangle& t, int axis) {
	return orient2d(at(mesh.points, t[0]), at(mesh.points, t[1]), at(mesh.points, t[2]), axis);
}

std::vector<FaceId> roots(UnionFind& sets) {
	sets.flatten();
	std::vector<FaceId> result(sets.size());
	for (std::uint32_t i = 0; i < result.size(); ++i) {
		result[i] = {sets.root(i)};
	}
	return result;
}

}  // namespace

int commonFront(const MeshArrays& mesh, FaceId a, FaceId b) {
	const Triangle& s = at(mesh.triangles, a);
	const Triangle& t = at(mesh.triangles, b);
	if (const int level = commonLevel(mesh, s, t); level >= 0) {
		return turnOf(mesh, s, level) * turnOf(mesh, t, level);
	}
	for (const VertexId v : t) {
		if (orient3d(at(mesh.points, s[0]), at(mesh.points, s[1]), at(mesh.points, s[2]),
		             at(mesh.points, v)) != 0) {
			return 0;
		}
	}
	int front = 0;
	const int axis = projectionAxis(s, mesh.points, front);
	return front * turnOf(mesh, t, axis);
}

Status joinPolygons(Arrangement& arrangement, Monitor& monitor) {
	constexpr std::size_t kGrain = 1 << 12;
	MeshArrays& mesh = arrangement.mesh;
	if (mesh.faux.empty()) {
		return {};
	}
	const int threads = arrangement.options.threads;
	UnionFind polygons(mesh.triangles.size()), flat(mesh.triangles.size());
	std::vector<std::uint8_t> joining(mesh.triangles.size(), 0);
	Polygons& out = arrangement.polygons;
	const Status status = forEachOperand(mesh.operands(), [&](OperandId operand) {
		std::vector<HalfEdge> halfEdges = listHalfEdges(arrangement, operand);
		std::vector<Join> joins(halfEdges.size(), Join::None);
		const Status found =
		    inOrder([&] { return sortByEdge(halfEdges, mesh.points.size(), threads, monitor); },
		            [&] {
			            return parallelFor(halfEdges.size(), kGrain, threads, monitor,
			                               [&](std::size_t begin, std::size_t end) {
				                               for (std::size_t i = begin; i < end; ++i) {
					                               joins[i] = joinAt(mesh, halfEdges, i);
				                               }
			                               });
		            });
		for (std::size_t i = 0; i < joins.size() && found.ok(); ++i) {
			if (joins[i] == Join::None) {
				continue;
			}
			const HalfEdge &a = halfEdges[i], &b = halfEdges[i + 1];
			polygons.unite(a.face, b.face);
			markFaux(joining[a.face], a.corner);
			markFaux(joining[b.face], b.corner);
			if (joins[i] == Join::Flat) {
				flat.unite(a.face, b.face);
				out.flatEdges.push_back({VertexId{a.low}, VertexId{a.high}});
			}
		}
		return found;
	});
	mesh.faux = std::move(joining);
	if (!std::is_sorted(out.flatEdges.begin(), out.flatEdges.end())) {  // vertices in common
		std::sort(out.flatEdges.begin(), out.flatEdges.end());
	}
	out.polygon = roots(polygons);
	out.flat = roots(flat);
	return status;
}

}  // namespace index_boolean
