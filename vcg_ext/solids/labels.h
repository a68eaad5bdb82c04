// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: both refined surfaces; out: for every vertex and piece, whether it lies inside the other
// operand.
// Guarantee: two witnesses agree, or the run is refused: the orientation of the curve beside each
// segment, and one exact winding number for each class of elements that the curve does not part.
// Source: Mei & Tipper 2013, section 4.6 (loop orientation), made local; the winding number catches
// operands that overlap themselves, which loop orientation and volume laws cannot see.
#pragma once

#include "vcg_ext/arrange/arrangement.h"
#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/status.h"

namespace index_boolean {

// Fills arrangement.labels.
// \return Ok, Cancelled, OutOfMemory, InternalError; SelfIntersecting where the witnesses differ;
//         NestedComponents where components of one operand lie in each other or inside out
// Complexity: O(n) for n faces, but for sorting the rays.
Status labelArrangement(Arrangement& arrangement, Monitor& monitor);

}  // namespace index_boolean
