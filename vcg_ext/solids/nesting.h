// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the components of one operand; out: whether each lies where it may: a solid one outside the
// others' solids, a cavity inside one of them.
// Guarantee: exact. Components may touch in any way: in vertices, along edges, in parts of walls.
#pragma once

#include "vcg_ext/solids/components.h"

namespace index_boolean {

// \return Ok, Cancelled, OutOfMemory, InternalError; NestedComponents with all faces of those that
//         lie where they may not
// Complexity: that of findWindings with a query a component, if there are two or more.
Status checkNesting(const Arrangement& arrangement, OperandId operand, const Components& components,
                    Monitor& monitor);

}  // namespace index_boolean
