// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/mesh/folded_fans.h"

#include "vcg_ext/base/edge_table.h"
#include "vcg_ext/base/union_find.h"

#include <algorithm>

namespace index_boolean {

namespace {

Point normalOf(const MeshArrays& mesh, const Triangle& t) {
	const Point &a = at(mesh.points, t[0]), &b = at(mesh.points, t[1]), &c = at(mesh.points, t[2]);
	Point n{};
	for (std::size_t k = 0; k < 3; ++k) {
		const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
		n[k] = (b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i]);
	}
	return n;
}

bool pointApart(const Point& m, const Point& n) {
	return m[0] * n[0] + m[1] * n[1] + m[2] * n[2] < 0;
}

// The sides of an operand's faces that lie inside polygons; faces are counted from its first on.
std::vector<HalfEdge> innerSides(const MeshArrays& mesh, OperandId operand) {
	const std::uint32_t first = mesh.faceOffsets.begin(operand);
	std::vector<HalfEdge> sides;
	for (std::uint32_t f = first; f < mesh.faceOffsets.end(operand); ++f) {
		const Triangle& t = mesh.triangles[f];
		for (std::size_t i = 0; i < 3; ++i) {
			if (isFaux(mesh.faux[f], i)) {
				sides.push_back(makeHalfEdge(t[i].value, t[(i + 1) % 3].value, f - first, i));
			}
		}
	}
	return sides;
}

}  // namespace

std::size_t countFoldedFans(const MeshArrays& mesh, OperandId operand) {
	if (mesh.faux.empty()) {
		return 0;
	}
	const std::uint32_t firstFace = mesh.faceOffsets.begin(operand);
	UnionFind polygons(mesh.faceOffsets.size(operand));
	std::vector<std::uint32_t> folded;  // a face of each pair
	std::vector<HalfEdge> sides = innerSides(mesh, operand);
	forEachManifoldEdge(sides, [&](const HalfEdge& a, const HalfEdge& b) {
		polygons.unite(a.face, b.face);
		if (pointApart(normalOf(mesh, mesh.triangles[firstFace + a.face]),
		               normalOf(mesh, mesh.triangles[firstFace + b.face]))) {
			folded.push_back(a.face);
		}
	});
	for (std::uint32_t& face : folded) {
		face = polygons.find(face);
	}
	std::sort(folded.begin(), folded.end());
	return static_cast<std::size_t>(std::unique(folded.begin(), folded.end()) - folded.begin());
}

}  // namespace index_boolean
