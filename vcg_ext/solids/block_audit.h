// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: an arrangement and blocks as delivered; out: their measures, and how far these are from the
// laws of volumes. Guarantee: a block that is not closed does not pass. The laws are a test of sums
// only: they hold of every consistent assignment of cells, a wrong one, too.
#pragma once

#include "vcg_ext/mesh/measure.h"
#include "vcg_ext/solids/cell_blocks.h"

namespace index_boolean {

// Measures blocks. \param out replaced; one per block, in their order
// \return Ok, Cancelled; InternalError if one is not closed. Complexity: O(n) for all faces.
Status measureBlocks(const Arrangement& arrangement, const std::vector<Block>& blocks,
                     Monitor& monitor, std::vector<BlockMeasure>& out);

// The largest |law| between the blocks of two operands that have been delivered, over the sum of
// the operands' volumes; 0 where volumes are beyond the range of double. Complexity: O(1).
double lawResidual(const Arrangement& arrangement, const std::vector<Block>& blocks,
                   const std::vector<BlockMeasure>& measures);

// The same of the law that a block has the volume of its cells.
// \param cells of each block. Complexity: O(c) for c cells of all blocks.
double cellResidual(const Arrangement& arrangement, const std::vector<CellSet>& cells,
                    const std::vector<BlockMeasure>& measures);

}  // namespace index_boolean
