// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the arrangement of one operand; out: the surface that distances are measured to.
// Guarantee: faces keep their coordinates and the numbers that they were given with.
#pragma once

#include "vcg_ext/distance/reference.h"
#include "vcg_ext/solids/blocks.h"

namespace index_boolean {

// Takes the operand's faces as prepared, right side out. Throws std::bad_alloc. Complexity: O(n).
void takeOperand(const Arrangement& arrangement, Reference& out);

// Takes the boundary of what is inside the operand.
// \param block that boundary, with vertices that meet as one; moved from
// \return Ok, or NoVolume if it has no face. Throws std::bad_alloc. Complexity: O(n).
Status takeBoundary(const Arrangement& arrangement, Block& block, Reference& out);

}  // namespace index_boolean
