// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: a block with the cuts of the whole arrangement; out: the same surface without cuts that part
// nothing in this block.
// Guarantee: the point set does not change, decided exactly; what is chosen is chosen by
// coordinates. Source: the reconstruction of faces in Freixas, Grau & Silva 2006 (Blender).
#pragma once

#include "vcg_ext/solids/blocks.h"

namespace index_boolean {

// Takes vertices away and fills the holes with fewer triangles.
// With options.mergeFragments: points of the curve inside one input face, and inside an input edge
// where nothing else meets it; the faces of a polygon that lie in one plane count as one. Corners
// of the faces stay.
// With options.mergeCoplanar: any vertex inside a set of neighbouring faces in one plane, or inside
// a straight line between two such sets.
// Vertices of which the block has copies, since it touches itself there, stay; and those of faces
// that keep their cuts.
// \param block before its coordinates are cleaned; changed in place
// \return Ok or Cancelled
// Complexity: O(k log k) for k faces at suspect vertices, O(1) if there are none; with
// mergeCoplanar k is all faces.
Status mergeFragments(const Arrangement& arrangement, Monitor& monitor, Block& block);

}  // namespace index_boolean
