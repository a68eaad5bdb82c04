// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: sub-surfaces and sub-blocks; out: a clip: the sub-surfaces of one operand, open or closed,
// that lie inside another one, which is closed, or those that lie outside of it.
// Guarantee: by indices alone; each sub-surface of the clipped operand is in exactly one of the
// two. What lies on the boundary of what is inside counts as inside.
#pragma once

#include "vcg_ext/parts/split_meshes.h"

namespace index_boolean {

struct Clip {
	OperandId surface;  // is clipped
	OperandId solid;    // clips it, and has to be closed
	bool isInside;      // what lies inside the solid is kept, or on it; else what lies outside
};

// Whether a sub-surface of the clipped operand is in the clip. Complexity: O(1).
bool isInClip(const SubBlocks& blocks, WindingRule rule, const Clip& clip, SubSurfaceId surface);

// Collects a clip as one surface, turned as the clipped operand was given.
// \pre refuseSolid(arrangement, blocks, clip.solid) is Ok
// \return Ok, Cancelled, OutOfMemory, InternalError. Complexity: O(n).
Status collectClip(const Arrangement& arrangement, const SubSurfaces& surfaces,
                   const SubBlocks& blocks, const Clip& clip, Monitor& monitor, SplitMesh& out);

// Ok, or why an operand cannot clip others.
// \return NotClosed or NotOriented with the faces at the edges in question (of a soup), or, of what
//         has nothing inside, as refuseWithoutInside, with the operand. Complexity: O(c) for c
//         blocks of Ok, else O(n log n).
Status refuseSolid(const Arrangement& arrangement, const SubBlocks& blocks, OperandId operand);

}  // namespace index_boolean
