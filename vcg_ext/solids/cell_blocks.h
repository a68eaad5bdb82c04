// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: an arrangement labelled by cells, and which cells are inside; out: the block that they are,
// as blocks.h gives it. Guarantee: a face is kept iff its two cells differ, turned so that the one
// inside lies behind it.
#pragma once

#include "vcg_ext/solids/blocks.h"

#include <functional>

namespace index_boolean {

// Whether a cell is inside, by the winding numbers of all operands around it. It is asked of each
// cell once, and must be false where all are 0: the outside has no boundary.
using CellPredicate = std::function<bool(const PerOperand<std::int32_t>& windings)>;

// What an operation on two operands says, each of which is what the rule calls inside.
// Complexity: O(1).
CellPredicate cellPredicateOf(Operation operation, WindingRule rule);

// Which cells are inside, a byte each.
using CellSet = std::vector<std::uint8_t>;

// The cells of which a predicate is true. Throws std::bad_alloc. Complexity: a call for each cell.
CellSet cellSetOf(const Arrangement& arrangement, const CellPredicate& isInside);

// Collects the faces and vertices of one block, before cleaning.
// \pre arrangement.cells are known
// \return Ok, Cancelled; InternalError if the outside is inside. Throws std::bad_alloc.
// Complexity: O(n) for n faces and pieces.
Status collectCells(const Arrangement& arrangement, const CellSet& isInside, Monitor& monitor,
                    Block& out);

}  // namespace index_boolean
