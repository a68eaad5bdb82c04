// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: triangles; out: their unmatched edges, from a sorted list of all half-edges.
#include "vcg_ext/mesh/unmatched_edges.h"

#include "vcg_ext/base/edge_table.h"
#include "vcg_ext/mesh/boundary_checksum.h"

#include <algorithm>

namespace index_boolean {

namespace {

std::uint32_t indexOf(VertexId vertex) { return vertex.value; }
std::uint32_t indexOf(std::uint32_t vertex) { return vertex; }

// \param begin, end triangles of either kind
template <class Corners>
std::vector<HalfEdge> halfEdgesOf(const Corners* begin, const Corners* end) {
	std::vector<HalfEdge> halfEdges;
	halfEdges.reserve(3 * static_cast<std::size_t>(end - begin));
	for (const Corners* t = begin; t != end; ++t) {
		for (std::size_t corner = 0; corner < 3; ++corner) {
			const std::uint32_t from = indexOf((*t)[corner]), to = indexOf((*t)[(corner + 1) % 3]);
			halfEdges.push_back(
			    makeHalfEdge(from, to, static_cast<std::size_t>(t - begin), corner));
		}
	}
	return halfEdges;
}

// Takes the half-edges [first, last) of one edge.
void judgeEdge(const HalfEdge* first, const HalfEdge* last, UnmatchedEdges& out) {
	const auto forward =
	    std::count_if(first, last, [](const HalfEdge& side) { return side.forward; });
	if (2 * forward == last - first) {
		return;
	}
	const bool border = (last - first) % 2 == 1;
	std::size_t& edges = border ? out.borderEdges : out.conflictingEdges;
	++edges;
	if (edges == 1 && (border || out.borderEdges == 0)) {
		out.firstEdge = {VertexId{first->low}, VertexId{first->high}};
	}
	std::for_each(first, last, [&out](const HalfEdge& side) { out.faces.push_back(side.face); });
}

}  // namespace

void findUnmatchedEdges(const Triangle* begin, const Triangle* end, UnmatchedEdges& out) {
	out = {};
	std::vector<HalfEdge> halfEdges = halfEdgesOf(begin, end);
	forEachEdge(halfEdges, [&out](auto first, auto last) {
		judgeEdge(&*first, &*first + (last - first), out);
	});
	std::sort(out.faces.begin(), out.faces.end());
	out.faces.erase(std::unique(out.faces.begin(), out.faces.end()), out.faces.end());
}

Status countUnmatchedEdges(const IndexTriangles& triangles, int threads, Monitor& monitor,
                           std::size_t& count) {
	count = 0;
	const IndexTriangle* const begin = triangles.data();
	const IndexTriangle* const end = begin + triangles.size();
	std::uint64_t sum = 0;
	const Status status = boundaryChecksum(begin, end, threads, monitor, sum);
	if (sum != 0) {
		UnmatchedEdges found;
		std::vector<HalfEdge> halfEdges = halfEdgesOf(begin, end);
		forEachEdge(halfEdges, [&found](auto first, auto last) {
			judgeEdge(&*first, &*first + (last - first), found);
		});
		count = found.borderEdges + found.conflictingEdges;
	}
	return status;
}

}  // namespace index_boolean
