// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: both operands, prepared; out: Ok, or all faces of the first operand that meets itself
// wrongly: two of its faces have more in common than the corner or the edge that they share.
// Guarantee: decided by exact signs, for every two faces; what is found does not depend on threads.
#pragma once

#include "vcg_ext/arrange/arrangement.h"
#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/status.h"

namespace index_boolean {

// Searches each operand for self-intersections: faces that cross, touch where they share no corner,
// or overlap in one plane; two faces on the same corners. Components that meet in common corners
// and edges only are no defect, nor is one within another.
// \param arrangement its operands are prepared (operands.h); nothing is searched if
//                    options.selfIntersections is Trust
// \return Ok, Cancelled, OutOfMemory, InternalError; SelfIntersecting with the operand, the number
//         of faces concerned, their indices as given, and a point where the first two of them meet
// Complexity: O(n log n + p) for n faces and p pairs of faces with boxes that meet, in parallel;
// O(n) memory.
Status checkSelfIntersections(const Arrangement& arrangement, Monitor& monitor);

}  // namespace index_boolean
