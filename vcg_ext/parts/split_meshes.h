// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: sub-surfaces and sub-blocks; out: meshes of them, each element with where it came from.
// Guarantee: a sub-block's mesh is closed and faces outwards; coordinates are rounded once; no face
// has zero area. Cuts stay, so that neighbours fit together.
#pragma once

#include "vcg_ext/carry/surface_repair.h"
#include "vcg_ext/mesh/sourced_mesh.h"
#include "vcg_ext/parts/sub_blocks.h"

namespace index_boolean {

// subSurface and beside are parallel to the triangles.
struct SplitMesh : SourcedMesh {
	HugeVector<SubSurfaceId> subSurface;
	HugeVector<std::array<std::int32_t, 2>> beside;  // blocks in front of the face and behind it
	SurfaceRepair repair;                            // if all sub-surfaces in it are one surface
};

// Sub-surfaces of one operand.
struct SurfaceChoice {
	OperandId operand;
	std::vector<std::uint8_t> isChosen;  // per sub-surface of the arrangement; empty: all are
	bool isOneSurface;                   // they are certified together; else each by itself
};

// The mesh of sub-surfaces of one operand: that operand with its cuts, turned as it was given.
// \return Ok, Cancelled, OutOfMemory, InternalError. Complexity: O(n).
Status collectSubSurfaces(const Arrangement& arrangement, const SubSurfaces& surfaces,
                          const SubBlocks& blocks, const SurfaceChoice& choice, Monitor& monitor,
                          SplitMesh& out);

// The boundary of one sub-block, which lies behind all faces; what dangles in it is left out.
// \return Ok, Cancelled, OutOfMemory, InternalError. Complexity: O(m log m) for its m faces.
Status collectSubBlock(const Arrangement& arrangement, const SubSurfaces& surfaces,
                       const SubBlocks& blocks, SubBlockId block, Monitor& monitor, SplitMesh& out);

}  // namespace index_boolean
