// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the sub-surfaces; out: the sub-blocks: the bounded parts that all surfaces together cut space
// into, each with the sides of the sub-surfaces that bound it.
// Guarantee: exact. Each side of a sub-surface faces exactly one part of space; one that has the
// same part on both sides (it dangles, or has one side only) bounds nothing. The order of the
// sub-blocks depends on coordinates only.
// Source: Mei & Tipper 2013, step 6, with half-planes sorted around each loop in place of a search
// for sub-surfaces with common loops.
#pragma once

#include "vcg_ext/parts/sub_surfaces.h"

namespace index_boolean {

using SubBlockId = Id<struct SubBlockTag>;

constexpr std::int32_t kNoBlock = -1;  // the unbounded outside

// A side of a sub-surface.
struct SubSurfaceSide {
	SubSurfaceId of;
	bool isBack;
};

struct SubBlock {
	double volume;
	double area;                         // of its boundary
	std::vector<SubSurfaceSide> sides;   // that bound it, ascending
	std::vector<SubSurfaceId> dangling;  // with this block on both sides
	PerOperand<std::int32_t> windings;   // of each operand around it; 0 if that is open
};

struct SubBlocks {
	std::vector<SubBlock> all;
	// Per sub-surface: the block in front of it and behind it; kNoBlock is the outside.
	std::vector<std::array<std::int32_t, 2>> beside;
	// Per sub-surface: it has different parts of space on its two sides.
	std::vector<std::uint8_t> separates;
	// Of a soup: an operand around which all blocks would have windings of 0 or less has been
	// turned.
	PerOperand<bool> turned;
};

// Whether a place with this winding number is inside an operand. Complexity: O(1).
bool isInside(WindingRule rule, std::int32_t winding);

// What parts space: every sub-surface, or only those that a winding number changes across and those
// of open operands.
enum class Walls : std::uint8_t { All, Jumps };

// Finds the sub-blocks of an arrangement.
// \param surfaces of the same arrangement
// \return Ok, Cancelled, OutOfMemory, InternalError; unless it is a soup, SelfIntersecting where
//         faces overlap that are not the same
// Complexity: O(n + c log c) for n triangles and c loops, and one ray for each part of the surfaces
// that no edge joins to others.
Status findSubBlocks(const Arrangement& arrangement, const SubSurfaces& surfaces, Walls walls,
                     Monitor& monitor, SubBlocks& out);

}  // namespace index_boolean
