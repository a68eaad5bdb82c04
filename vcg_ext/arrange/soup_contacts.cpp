// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// To the search for wrong pairs the faces of all operands are one surface: what meets wrongly in it
// is what has to be cut.
#include "vcg_ext/arrange/soup_contacts.h"

#include "vcg_ext/arrange/wrong_pairs.h"
#include "vcg_ext/base/edge_table.h"
#include "vcg_ext/base/parallel.h"

#include <algorithm>

namespace index_boolean {

namespace {

bool areAllClosed(const Arrangement& arrangement) {
	return std::find(arrangement.closed.begin(), arrangement.closed.end(), false) ==
	       arrangement.closed.end();
}

// The same two edges have one name, whatever face is asked about first.
void nameSmallerEdgeFirst(PointName& name) {
	auto& ids = name.ids;
	if (name.kind == PointKind::EdgeEdge && std::pair(ids[2], ids[3]) < std::pair(ids[0], ids[1])) {
		std::swap(ids[0], ids[2]);
		std::swap(ids[1], ids[3]);
	}
}

void countSelfIntersecting(const std::vector<FacePair>& pairs, Arrangement& arrangement) {
	const MeshArrays& mesh = arrangement.mesh;
	std::vector<std::uint8_t> isConcerned(mesh.triangles.size(), 0);
	for (const FacePair& pair : pairs) {
		if (mesh.operandOf(pair.a) == mesh.operandOf(pair.b)) {
			at(isConcerned, pair.a) = at(isConcerned, pair.b) = 1;
		}
	}
	for (const OperandId operand : mesh.operands()) {
		const auto begin = isConcerned.begin();
		arrangement.selfIntersecting[operand] = static_cast<std::size_t>(
		    std::count(begin + mesh.faceOffsets.begin(operand),
		               begin + mesh.faceOffsets.end(operand), std::uint8_t{1}));
	}
}

// A face at an edge.
using EdgeFace = EdgeItem<FaceId>;

// Lists the edges between vertices that are shared by operands or not regular otherwise, with their
// faces.
Status listEdgesBetweenShared(const Arrangement& arrangement, Monitor& monitor,
                              std::vector<EdgeFace>& edges) {
	constexpr std::size_t kGrain = 1 << 16;
	const MeshArrays& mesh = arrangement.mesh;
	std::vector<std::uint8_t> isShared(mesh.points.size(), 0);
	for (const VertexId v : arrangement.nonManifold) {
		at(isShared, v) = 1;
	}
	return inOrderFor(
	    mesh.triangles.size(), kGrain, monitor, [&](std::size_t begin, std::size_t end) {
		    for (std::size_t f = begin; f < end; ++f) {
			    const Triangle& t = mesh.triangles[f];
			    for (std::size_t i = 0; i < 3; ++i) {
				    const VertexId from = t[i], to = t[(i + 1) % 3];
				    if (at(isShared, from) != 0 && at(isShared, to) != 0) {
					    edges.push_back(makeEdgeItem(from.value, to.value, makeId<FaceTag>(f)));
				    }
			    }
		    }
	    });
}

// Each of the faces at one edge, with the first one of another operand: which faces are touched
// does not depend on their numbers.
void addCommonEdge(const MeshArrays& mesh, const EdgeFace* begin, const EdgeFace* end,
                   std::vector<FacePair>& out) {
	const OperandId operand = mesh.operandOf(begin->item);
	const EdgeFace* const other = std::find_if(
	    begin, end, [&](const EdgeFace& e) { return mesh.operandOf(e.item) != operand; });
	for (const EdgeFace* e = begin; e != end && other != end; ++e) {
		const bool isOfFirst = mesh.operandOf(e->item) == operand;
		const auto [a, b] = std::minmax(e->item, isOfFirst ? other->item : begin->item);
		out.push_back({a, b});
	}
}

// Adds pairs of faces of different operands that have an edge in common.
Status addCommonEdges(const Arrangement& arrangement, Monitor& monitor,
                      std::vector<FacePair>& pairs) {
	std::vector<EdgeFace> edges;
	const MeshArrays& mesh = arrangement.mesh;
	const int threads = arrangement.options.threads;
	const auto before = [](const FacePair& p, const FacePair& q) {
		return p.a != q.a ? p.a < q.a : p.b < q.b;
	};
	const auto keyOf = [](const FacePair& pair) { return pair.a.value; };
	const auto isSame = [](const FacePair& p, const FacePair& q) {
		return p.a == q.a && p.b == q.b;
	};
	return inOrder([&] { return listEdgesBetweenShared(arrangement, monitor, edges); },
	               [&] { return sortByEdge(edges, mesh.points.size(), threads, monitor); },
	               [&] {
		               forEachSortedEdge(edges.data(), edges.data() + edges.size(),
		                                 [&](const EdgeFace* begin, const EdgeFace* end) {
			                                 addCommonEdge(mesh, begin, end, pairs);
		                                 });
		               return bucketSort(pairs, mesh.triangles.size(), keyOf, before, threads,
		                                 monitor);
	               },
	               [&] {
		               pairs.erase(std::unique(pairs.begin(), pairs.end(), isSame), pairs.end());
		               return Status{};
	               });
}

}  // namespace

Status findSoupContacts(Arrangement& arrangement, Monitor& monitor, Contacts& out) {
	const MeshArrays& mesh = arrangement.mesh;
	const FacesView faces{mesh.points, mesh.triangles.data(), mesh.triangles.size()};
	const WrongPairOptions options{arrangement.options.threads, areAllClosed(arrangement)};
	WrongPairs found;
	const Status status = inOrder(
	    [&] { return findWrongPairs(faces, options, monitor, found); },
	    [&] {
		    countSelfIntersecting(found.pairs, arrangement);
		    return addCommonEdges(arrangement, monitor, found.pairs);
	    },
	    [&] { return checkCounts(found.pairs.size(), 0, arrangement.options.mostElements); },
	    [&] { return findContacts(arrangement, found.pairs, monitor, out); });
	for (PointName& name : out.names) {
		nameSmallerEdgeFirst(name);
	}
	return status;
}

bool isOnEdge(const PointName& name, const std::array<VertexId, 2>& edge) {
	const std::uint32_t low = edge[0].value, high = edge[1].value;
	const auto& ids = name.ids;
	switch (name.kind) {
	case PointKind::Vertex:
		return ids[0] == low || ids[0] == high;
	case PointKind::OnEdge:
		return ids[0] == low || ids[0] == high || (ids[1] == low && ids[2] == high);
	case PointKind::EdgeEdge:
		return (ids[0] == low && ids[1] == high) || (ids[2] == low && ids[3] == high);
	case PointKind::EdgeFace:
		return ids[0] == low && ids[1] == high;
	case PointKind::FaceFaceFace:
		break;
	}
	return false;
}

std::array<VertexId, 2> edgeAlong(const MeshArrays& mesh, FacePair faces, const PointName& a,
                                  const PointName& b) {
	for (const FaceId face : {faces.a, faces.b}) {
		const Triangle& t = at(mesh.triangles, face);
		for (std::size_t i = 0; i < 3; ++i) {
			const auto [low, high] = std::minmax(t[i], t[(i + 1) % 3]);
			const std::array<VertexId, 2> edge{low, high};
			if (isOnEdge(a, edge) && isOnEdge(b, edge)) {
				return edge;
			}
		}
	}
	return {VertexId::none(), VertexId::none()};
}

}  // namespace index_boolean
