// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: operands, as given or arranged; out: Ok, or which of them no block can be made of, and why.
// Guarantee: exact; by the windings of cells, and closedness as the operands are cut.
#pragma once

#include "vcg_ext/arrange/arrangement.h"
#include "vcg_ext/base/status.h"

namespace index_boolean {

// Whether a refusal of operands that have to be embedded is none of operands that need not be.
// Complexity: O(1).
bool isOnlyForEmbedded(StatusCode code, SelfIntersections selfIntersections);

// \return Ok, or EmptyOperand: the first operand without a face. Complexity: O(N) for N operands.
Status refuseWithoutFaces(const MeshArrays& input);

// \pre the arrangement has cells
// \return Ok, or of the first operand that is no solid: NotClosed or NotOriented if it is open as
// it is cut; if nothing is inside by the winding rule, NoVolume, or EmptyOperand with the number of
// pairs of faces that cancel. Under the rule Odd such pairs are a set like any other, which is
// empty. Complexity: O(c N) for c cells and N operands.
Status refuseUnlessSolids(const Arrangement& arrangement);

}  // namespace index_boolean
