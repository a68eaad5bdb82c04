// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: a block that meets itself along edges or at vertices; out: the same solid as a manifold mesh,
// its sheets pulled apart by copies of these vertices.
// Guarantee: no triangle changes its place or orientation; closed stays closed. At an edge with
// more than two faces, faces are paired across the solid between them; where that would leave both
// ends of two pairs in common, across the void. That always suffices where the order of faces
// around edges is that of a solid; where rounding has broken it, an edge still in common gets a
// midpoint for each pair.
#pragma once

#include "vcg_ext/solids/blocks.h"

namespace index_boolean {

// Pulls a block apart at its suspect vertices, before its coordinates are trusted: faces around an
// edge are ordered by the planes of the input faces that they lie in. No midpoints: edges that
// would need them stay as they are; if there are none, block.isApart is set.
// \param block as collected, or with fragments merged in their faces; changed in place
// \return Ok or Cancelled
// Complexity: O(n + k log k) for k faces at suspect vertices; O(1) if there are none.
Status copyNonManifold(const Arrangement& arrangement, Monitor& monitor, Block& block);

// The same by the block's coordinates as stored, with midpoints where nothing else helps: an edge
// too short to have a midpoint between its ends keeps its faces.
// \pre no face has zero area
// \return Ok or Cancelled
// Complexity: O(n + k log k) for n faces, k of them at suspect vertices; O(1) if there are none.
Status copyNonManifoldAsStored(OutputScalar scalar, Monitor& monitor, Block& block);

}  // namespace index_boolean
