// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the faces of one surface; out: an order in which eight after eight lie together.
// Guarantee: it depends on sizes and places only, never on threads.
#pragma once

#include "vcg_ext/arrange/search_frame.h"

namespace index_boolean {

// The faces in order.
struct FaceOrder {
	HugeVector<std::uint64_t> items;  // low half: a face; high half: its code

	// The face at a place.
	std::uint32_t face(std::size_t place) const { return static_cast<std::uint32_t>(items[place]); }
};

// Orders faces along a curve that fills space, by Morton's codes.
// \param out replaced
// \return Ok, Cancelled or OutOfMemory. Complexity: O(n), in parallel.
Status orderFaces(const SearchedSurface& surface, Monitor& monitor, FaceOrder& out);

}  // namespace index_boolean
