// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: a finished block, and options.mergeTolerance; out: the same with walls that lie within it of
// one plane in as few faces as that allows (merge_near_coplanar.h, which has the guarantees).
// Pieces of one face are one plane by name within a run; rounded, they are faces of their own in
// the next one, a hair off their plane, which every later step would cut again.
// Guarantee: nothing is merged across a difference of face classes or polygons.
#pragma once

#include "vcg_ext/solids/blocks.h"

namespace index_boolean {

// Merges a block's walls; the block's certificate follows.
// \param arrangement that the block's sources name
// \param block       certified, unless that is switched off; its faux edges are not marked yet
// \return Ok, Cancelled, OutOfMemory, InternalError. Throws std::bad_alloc.
// Complexity: O(1) if there is no tolerance; else that of mergeNearCoplanar.
Status mergeWalls(const Arrangement& arrangement, Monitor& monitor, Block& block);

}  // namespace index_boolean
