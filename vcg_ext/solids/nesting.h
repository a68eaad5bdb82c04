// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the components of one operand; out: whether each lies where it may: a solid one outside the
// others' solids, a cavity inside one of them.
// Guarantee: exact. Components may touch in any way: in vertices, along edges, in parts of walls.
#pragma once

#include "vcg_ext/parts/winding_rays.h"
#include "vcg_ext/solids/components.h"

namespace index_boolean {

// Whether a surface's winding number is 0 or 1 on both sides of a place on one of its components.
// \param others     the winding number there of all other components
// \param volumeSign of the component. Complexity: O(1).
bool isPlacedRight(const WindingQuery& others, int volumeSign);

// \return Ok, Cancelled, OutOfMemory, InternalError; NestedComponents with all faces of those that
//         lie where they may not
// Complexity: that of findWindings with a query a component, if there are two or more.
Status checkNesting(const Arrangement& arrangement, OperandId operand, const Components& components,
                    Monitor& monitor);

}  // namespace index_boolean
