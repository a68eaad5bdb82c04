// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: a block without cuts that part nothing; out: the same point set, with the triangles of each
// input face as round as they can be. Cut faces are triangulated region by region, and what a
// vertex leaves that goes is filled by itself: seams between such triangulations are made good.
// Guarantee: as DelaunayFlips. Source: Lawson 1977.
#pragma once

#include "vcg_ext/solids/blocks.h"

namespace index_boolean {

// Flips edges between faces of one group (face_groups.h) until none wants to.
// Free is an edge that two faces of the block have, counted by place: where the block meets itself
// along it, there are more, and it stays an edge of all. Faces that keep their cuts are left alone.
// \param block after mergeFragments; changed in place. Of faces with several sources, where
//              polygons or planes have been joined, a flip keeps both sources, one for each face
// \return Ok, Cancelled
// Complexity: O(1) if no vertex is suspect; else that of sorting the k faces of input faces with a
// suspect vertex, and of DelaunayFlips, in parallel. With mergeCoplanar k is all faces.
Status makePiecesDelaunay(const Arrangement& arrangement, Monitor& monitor, Block& block);

}  // namespace index_boolean
