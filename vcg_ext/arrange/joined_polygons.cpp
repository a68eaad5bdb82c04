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

// The faux edges of one operand, each once.
struct FauxEdges {
	std::vector<std::array<HalfEdge, 2>> pairs;
	std::vector<std::uint8_t> isFlat;  // per pair: both faces lie in one plane
};

// An edge with more than two faces has ends at which the operand is no manifold, and so has one at
// a border: between such vertices, all half-edges are looked at.
FauxEdges pairFauxEdges(const Arrangement& arrangement, OperandId operand) {
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
	FauxEdges found;
	forEachManifoldEdge(halfEdges, [&](const HalfEdge& a, const HalfEdge& b) {
		if (isFaux(mesh.faux[a.face], a.corner) && isFaux(mesh.faux[b.face], b.corner)) {
			found.pairs.push_back({a, b});
			found.isFlat.push_back(commonFront(mesh, {a.face}, {b.face}) > 0 ? 1 : 0);
		}
	});
	return found;
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
	for (const VertexId v : t) {
		if (orient3d(at(mesh.points, s[0]), at(mesh.points, s[1]), at(mesh.points, s[2]),
		             at(mesh.points, v)) != 0) {
			return 0;
		}
	}
	int front = 0;
	const int axis = projectionAxis(s, mesh.points, front);
	return front *
	       orient2d(at(mesh.points, t[0]), at(mesh.points, t[1]), at(mesh.points, t[2]), axis);
}

Status joinPolygons(Arrangement& arrangement, Monitor& monitor) {
	MeshArrays& mesh = arrangement.mesh;
	if (mesh.faux.empty()) {
		return {};
	}
	PerOperand<FauxEdges> found(mesh.operands().count());
	const int halves = threadsForHalves(mesh.triangles.size(), arrangement.options.threads);
	const Status status =
	    parallelFor(found.size(), 1, halves, monitor, [&](std::size_t begin, std::size_t end) {
		    for (std::size_t k = begin; k < end; ++k) {
			    const auto operand = makeId<OperandTag>(k);
			    found[operand] = pairFauxEdges(arrangement, operand);
		    }
	    });
	UnionFind polygons(mesh.triangles.size()), flat(mesh.triangles.size());
	mesh.faux.assign(mesh.triangles.size(), 0);
	Polygons& out = arrangement.polygons;
	for (const FauxEdges& edges : found) {
		for (std::size_t i = 0; i < edges.pairs.size(); ++i) {
			const auto& [a, b] = edges.pairs[i];
			polygons.unite(a.face, b.face);
			markFaux(mesh.faux[a.face], a.corner);
			markFaux(mesh.faux[b.face], b.corner);
			if (edges.isFlat[i] != 0) {
				flat.unite(a.face, b.face);
				out.flatEdges.push_back({VertexId{a.low}, VertexId{a.high}});
			}
		}
	}
	std::sort(out.flatEdges.begin(), out.flatEdges.end());
	out.polygon = roots(polygons);
	out.flat = roots(flat);
	return status;
}

}  // namespace index_boolean
