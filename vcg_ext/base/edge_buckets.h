// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the sides of faces; out: edge by edge, the sides that are on the same two vertices. For lists
// as long as a mesh, of which nothing but that is asked: sides go from their faces straight to
// where their edge's others are, without a list in between, and what the place tells is not
// stored.
#pragma once

#include "vcg_ext/base/edge_table.h"
#include "vcg_ext/base/huge_vector.h"
#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/base/status.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace index_boolean {

// A half-edge but for its lower vertex. `mark` is the caller's.
struct EdgeSide {
	std::uint32_t high;
	std::uint32_t face;
	std::uint8_t corner;
	bool forward;
	bool mark;

	// By edge, then by face, of sides with one lower vertex.
	std::uint64_t rank() const { return std::uint64_t{high} << 32U | face; }
};

// The sides of faces, by their lower vertex.
class EdgeBuckets {
public:
	// Lists the half-edges of all faces.
	// \param vertices  above all vertices
	// \param visitHalfEdges visitHalfEdges(f, visit): calls visit(halfEdge) for each half-edge of
	//                       face f, twice the same
	// \return Ok or Cancelled. Throws std::bad_alloc. Complexity: O(n + m + v) for m half-edges.
	template <class VisitHalfEdges>
	Status list(std::size_t faces, std::size_t vertices, VisitHalfEdges&& visitHalfEdges,
	            Monitor& monitor);

	// How many chunks forEachEdge has.
	std::size_t chunks() const { return chunkCount(ends_.size(), kVertices); }

	// Calls visit(chunk, first, last) for the sides of each edge, sorted by face; for the edges of
	// one chunk in their order, for chunks on several threads.
	// \return as parallelForChunks
	// Complexity: O(m) in parallel, as long as no vertex has very many edges; O(m log m) else.
	template <class Visit>
	Status forEachEdge(int threads, Monitor& monitor, Visit&& visit);

	// All of them, with the marks that were made.
	const HugeVector<EdgeSide>& sides() const { return sides_; }

private:
	static constexpr std::size_t kVertices = 1 << 12;  // of a chunk

	HugeVector<EdgeSide> sides_;
	std::vector<std::uint32_t> ends_;  // per vertex: of the sides that it is the lower vertex of
};

template <class VisitHalfEdges>
Status EdgeBuckets::list(std::size_t faces, std::size_t vertices, VisitHalfEdges&& visitHalfEdges,
                         Monitor& monitor) {
	constexpr std::size_t kGrain = 1 << 14;
	ends_.assign(vertices + 1, 0);  // begins, until the sides are there
	const auto count = [&](const HalfEdge& side) { ++ends_[side.low + 1]; };
	const auto write = [&](const HalfEdge& side) {
		sides_[ends_[side.low]++] = {side.high, side.face, side.corner, side.forward, false};
	};
	const auto visitAll = [&](const auto& visit) {
		return inOrderFor(faces, kGrain, monitor, [&](std::size_t begin, std::size_t end) {
			for (std::size_t f = begin; f < end; ++f) {
				visitHalfEdges(f, visit);
			}
		});
	};
	return inOrder([&] { return visitAll(count); },
	               [&] {
		               for (std::size_t v = 1; v <= vertices; ++v) {
			               ends_[v] += ends_[v - 1];
		               }
		               sides_.resizeForOverwrite(ends_.back());
		               return visitAll(write);
	               });
}

template <class Visit>
Status EdgeBuckets::forEachEdge(int threads, Monitor& monitor, Visit&& visit) {
	const auto byRank = [](const EdgeSide& a, const EdgeSide& b) { return a.rank() < b.rank(); };
	const auto visitChunk = [&](std::size_t chunk, std::size_t begin, std::size_t end) {
		for (std::size_t v = begin; v < end; ++v) {
			EdgeSide* first = sides_.data() + (v == 0 ? 0 : ends_[v - 1]);
			EdgeSide* const bucketEnd = sides_.data() + ends_[v];
			std::sort(first, bucketEnd, byRank);
			while (first != bucketEnd) {
				EdgeSide* const last = std::find_if(
				    first, bucketEnd, [&](const EdgeSide& s) { return s.high != first->high; });
				visit(chunk, first, last);
				first = last;
			}
		}
	};
	return parallelForChunks(ends_.size(), kVertices, threads, monitor, visitChunk);
}

}  // namespace index_boolean
