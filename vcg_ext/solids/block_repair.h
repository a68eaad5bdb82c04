// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: a block before and after it is cleaned; out: what the repair of places (repair_places.h) has
// done to it. Nearly always no place has been moved, and nothing is measured.
#pragma once

#include "vcg_ext/mesh/measure.h"
#include "vcg_ext/solids/blocks.h"

namespace index_boolean {

// Counts the block's moved vertices, and measures it as it would be with all places as rounded.
// \param block before it is cleaned; gets repair.movedVertices
// Throws std::bad_alloc. Complexity: O(1) if no place has been moved, else O(n log m).
BlockMeasure measureUnrepaired(const Arrangement& arrangement, Block& block);

// Fills the rest of block.repair. \param before as measured \param block after it is cleaned
// Throws std::bad_alloc. Complexity: O(1) if no place has been moved, else O(n).
void compareWithUnrepaired(const Arrangement& arrangement, const BlockMeasure& before,
                           Block& block);

// Fills block.repair of a block that was read from operands arranged again (rounding_loop.h).
// \param exact the same block as the exact arrangement has it, before it is cleaned
// \param block its sources are named as the arrangement's
// \return Ok. Throws std::bad_alloc. Complexity: O(n).
Status compareWithExact(const Arrangement& arrangement, const Block& exact, Block& block);

}  // namespace index_boolean
