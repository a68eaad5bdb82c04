// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: half-edges of faces, or anything else that lies on edges, in any order; out: edge by edge,
// what is on the same two vertices. A sorted list is the whole table: what is asked is always asked
// of all edges at once.
#pragma once

#include "vcg_ext/base/bucket_sort.h"
#include "vcg_ext/base/groups.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace index_boolean {

// One side of a face, between the vertices low < high of any numbering.
struct HalfEdge {
	std::uint32_t low, high;
	std::uint32_t face;
	std::uint8_t corner;  // that it leaves
	bool forward;         // it runs from low to high

	// Whether both lie on the same two vertices.
	bool sameEdge(const HalfEdge& other) const { return low == other.low && high == other.high; }
	// By edge, then by face.
	friend bool operator<(const HalfEdge& a, const HalfEdge& b) {
		return a.low != b.low     ? a.low < b.low
		       : a.high != b.high ? a.high < b.high
		                          : a.face < b.face;
	}
};

// The side of a face that runs from one vertex to another.
// \param corner of the face, 0 to 2, that the side leaves
inline HalfEdge makeHalfEdge(std::uint32_t from, std::uint32_t to, std::size_t face,
                             std::size_t corner) {
	return {std::min(from, to), std::max(from, to), static_cast<std::uint32_t>(face),
	        static_cast<std::uint8_t>(corner), from < to};
}

// An item on the edge between the vertices low < high of any numbering.
template <class Item>
struct EdgeItem {
	std::uint32_t low, high;
	Item item;

	// Whether both lie on the same two vertices.
	bool sameEdge(const EdgeItem& other) const { return low == other.low && high == other.high; }
	// By edge, then by item.
	friend bool operator<(const EdgeItem& a, const EdgeItem& b) {
		return a.low != b.low     ? a.low < b.low
		       : a.high != b.high ? a.high < b.high
		                          : a.item < b.item;
	}
};

// An item on the edge between two vertices, whatever their order.
template <class Item>
EdgeItem<Item> makeEdgeItem(std::uint32_t from, std::uint32_t to, const Item& item) {
	return {std::min(from, to), std::max(from, to), item};
}

// Sorts half-edges, or items on edges, by edge as std::sort does, for any number of threads.
// \param vertexCount above all vertices
// \return Ok or Cancelled. Complexity: that of bucketSort.
template <class Entries>
Status sortByEdge(Entries& entries, std::size_t vertexCount, int threads, Monitor& monitor) {
	return bucketSort(
	    entries, vertexCount, [](const auto& entry) { return entry.low; }, std::less<>(), threads,
	    monitor);
}

// Calls visit(first, last) for the half-edges or items of each edge. \pre those of one edge are
// neighbours. Complexity: O(n).
template <class Iterator, class Visit>
void forEachSortedEdge(Iterator begin, Iterator end, Visit&& visit) {
	forEachGroup(
	    begin, end, [](const auto& a, const auto& b) { return a.sameEdge(b); }, visit);
}

// Sorts the half-edges by edge, then by face, and calls visit(first, last) for those of each edge.
// \param halfEdges a random-access array of HalfEdge
// Complexity: O(n log n).
template <class HalfEdges, class Visit>
void forEachEdge(HalfEdges& halfEdges, Visit&& visit) {
	std::sort(halfEdges.begin(), halfEdges.end());
	forEachSortedEdge(halfEdges.begin(), halfEdges.end(), visit);
}

// Calls visit(a, b) for the half-edges of each edge that has two, against each other, and no more.
// \pre those of one edge are neighbours. Complexity: O(n).
template <class HalfEdges, class Visit>
void forEachSortedManifoldEdge(const HalfEdges& halfEdges, Visit&& visit) {
	forEachSortedEdge(halfEdges.begin(), halfEdges.end(), [&visit](auto first, auto last) {
		if (last - first == 2 && first[0].forward != first[1].forward) {
			visit(first[0], first[1]);
		}
	});
}

// The same for half-edges in any order, which it sorts. Complexity: O(n log n).
template <class HalfEdges, class Visit>
void forEachManifoldEdge(HalfEdges& halfEdges, Visit&& visit) {
	std::sort(halfEdges.begin(), halfEdges.end());
	forEachSortedManifoldEdge(halfEdges, visit);
}

}  // namespace index_boolean
