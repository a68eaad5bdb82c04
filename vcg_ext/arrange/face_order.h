// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the faces of one surface; out: an order in which eight after eight lie together.
// Guarantee: it depends on sizes and places only, never on threads.
#pragma once

#include "vcg_ext/arrange/search_frame.h"

namespace index_boolean {

// Faces in groups of eight, the last one of which may have fewer.
struct FaceOrder {
	bool asGiven = true;              // a group has faces that follow each other
	HugeVector<std::uint64_t> items;  // low half: if asGiven the groups, else the faces, in order

	// Where the faces of a group begin: among all faces if asGiven, else among the items.
	std::size_t first(std::size_t group) const {
		return 8 * (asGiven ? static_cast<std::uint32_t>(items[group]) : group);
	}
	// The face at such a place.
	std::uint32_t face(std::size_t place) const {
		return static_cast<std::uint32_t>(asGiven ? place : items[place]);
	}
};

// Orders faces along a curve that fills space, by Morton's codes. Faces that follow each other stay
// together where, as a sample tells, most of them lie together anyway.
// \param out replaced
// \return Ok, Cancelled or OutOfMemory. Complexity: O(n), in parallel.
Status orderFaces(const SearchedSurface& surface, Monitor& monitor, FaceOrder& out);

}  // namespace index_boolean
