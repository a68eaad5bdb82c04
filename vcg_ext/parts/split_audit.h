// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: sub-blocks and their boundaries as delivered; out: whether these are closed and consistently
// oriented, and whether volumes add up; and of a clip as delivered, whether its area does.
// Guarantee: a boundary that is not closed is found but with a probability of 2^-64; a volume
// or area counts as wrong only where no rounding of coordinates and sums can explain it.
#pragma once

#include "vcg_ext/parts/clip.h"

namespace index_boolean {

struct SplitAudit {
	bool closed = true;  // each directed edge of each boundary is matched by its opposite
	// How far the blocks in a closed operand, each taken as often as that is wound around it, are
	// from having its volume in all; the larger of both, relative to the volumes of both.
	double volumeLawResidual = 0;
};

// \param boundaries one for each sub-block, or none if they are not delivered
// \return Ok, Cancelled, OutOfMemory; InternalError if a boundary is not closed, does not have its
//         sub-block's volume, or the law does not hold
// Complexity: O(n) for all faces.
Status auditSubBlocks(const Arrangement& arrangement, const SubSurfaces& surfaces,
                      const SubBlocks& blocks, const std::vector<SplitMesh>& boundaries,
                      Monitor& monitor, SplitAudit& out);

// \param mesh that of the clip \param measure replaced: of the mesh
// \return Ok; InternalError if the mesh, unless faces of it were cleaned away, does not have
//         the area of the clip's sub-surfaces
// Throws std::bad_alloc. Complexity: O(n) for all faces.
Status auditClip(const Arrangement& arrangement, const SubSurfaces& surfaces,
                 const SubBlocks& blocks, const Clip& clip, const SplitMesh& mesh,
                 BlockMeasure& measure);

}  // namespace index_boolean
