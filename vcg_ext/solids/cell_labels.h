// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: a soup, cut; out: the cells that its surfaces part space into, with the winding number of
// each operand around them, and the cells on both sides of every face and piece. Guarantee: exact,
// and counted a second time by rays through the input (sub_blocks.h).
#pragma once

#include "vcg_ext/arrange/arrangement.h"
#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/status.h"

namespace index_boolean {

// Fills arrangement.cells, turns operands of which no cell has a positive winding number (noted in
// insideOut), and fills volume: of what the winding rule calls inside each closed operand. \pre the
// arrangement is a soup's, and knows which operands are closed as cut \return Ok, Cancelled,
// OutOfMemory, InternalError Complexity: as findSubSurfaces and findSubBlocks; O(c N) memory for c
// cells and N operands.
Status labelCells(Arrangement& arrangement, Monitor& monitor);

}  // namespace index_boolean
