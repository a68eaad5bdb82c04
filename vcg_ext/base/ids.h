// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Typed indices: one struct per element kind, so that mixing them does not compile.
// Notation used throughout the core: operand 0 is the first mesh (A), operand 1 the second (B).
// Vertices and faces of both operands share one numbering each, the first operand's before the
// second's; the points of the intersection curve are vertices too, numbered after both.
// Faces are counter-clockwise seen from outside: the solid lies behind a face.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

namespace index_boolean {

template <class Tag>
struct Id {
	std::uint32_t value;

	static constexpr Id none() { return {std::numeric_limits<std::uint32_t>::max()}; }

	friend constexpr bool operator==(Id a, Id b) { return a.value == b.value; }
	friend constexpr bool operator!=(Id a, Id b) { return a.value != b.value; }
	friend constexpr bool operator<(Id a, Id b) { return a.value < b.value; }
};

// What an index is where there is none.
constexpr std::uint32_t kNone = 0xffffffff;

using VertexId = Id<struct VertexTag>;  // an input vertex, or a point of the curve (numbered after)
using FaceId = Id<struct FaceTag>;      // an input face
using PointId = Id<struct PointTag>;    // a point of the curve; its VertexId is vertexCount + value
using SegmentId = Id<struct SegmentTag>;  // one edge of the intersection curve

// The next corner of a triangle in its cyclic order, and the one before.
constexpr int nextCorner(int corner) { return corner == 2 ? 0 : corner + 1; }
constexpr int previousCorner(int corner) { return corner == 0 ? 2 : corner - 1; }

// For an element kind T, the value at a typed index of a plain array.
template <class Array, class Tag>
auto& at(Array& array, Id<Tag> id) {
	return array[static_cast<std::size_t>(id.value)];
}

// An id of an index that fits into 32 bits.
template <class Tag>
constexpr Id<Tag> makeId(std::size_t index) {
	return {static_cast<std::uint32_t>(index)};
}

}  // namespace index_boolean
