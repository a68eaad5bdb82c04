// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: a soup, cut; out: which operands are closed. Guarantee: asked of the pieces, so that an edge
// with a vertex hanging on it is the two edges that it is.
#pragma once

#include "vcg_ext/arrange/arrangement.h"
#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/status.h"

namespace index_boolean {

// Finds which operands are closed once they are cut; those closed by the input's edges stay so.
// \param arrangement its refinement is known; its closed is changed, and volume is 0 of what is
// open \return Ok, Cancelled, OutOfMemory. Complexity: O(n) for n triangles of the operands that
// are not closed by the input's edges.
Status findRefinedClosed(Arrangement& arrangement, Monitor& monitor);

// Says where an operand is not closed, or not consistently oriented, as cut.
// \pre it is not closed \return NotClosed or NotOriented, with the number of edges, a place, and
// the faces at these edges as given. Complexity: O(n log n) for its n triangles.
Status refuseOpen(const Arrangement& arrangement, OperandId operand);

// Says why an operand encloses nothing. All of its faces may cancel: it is a double-sided model
// then, but under the rule Odd a set like any other.
// \pre it is closed, and no place is inside it by its winding rule \return NoVolume; EmptyOperand
// with the number of pairs that cancel; Ok. Complexity: O(n) for its n faces.
Status refuseWithoutInside(const Arrangement& arrangement, OperandId operand);

}  // namespace index_boolean
