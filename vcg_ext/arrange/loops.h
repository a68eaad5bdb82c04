// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the curve's segments; out: its maximal chains between junctions.
// Guarantee: each segment lies in exactly one loop, but for those inside a coplanar overlap, where
// both surfaces go on; by index only. Start, direction and order of loops depend on coordinates
// only.
// Source: Mei & Tipper 2013, step 4. A loop is hard-closed if it is a cycle without junction,
// soft-closed if both its ends are junctions, open if an end has degree one. A junction is a point
// at which more or fewer than two segments end, or at which the faces at the one segment are not,
// going round the point, those at the other: so at a vertex where an operand is no manifold, or
// where the curve comes to a border or leaves it. Hence all edges of a loop have the same
// sub-surfaces around them, in the same order.
#pragma once

#include "vcg_ext/arrange/arrangement.h"
#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/status.h"

namespace index_boolean {

// Fills arrangement.loops and loopCounts.
// \return Ok, Cancelled, OutOfMemory. Complexity: O(s log s) for s segments.
Status traceLoops(Arrangement& arrangement, Monitor& monitor);

}  // namespace index_boolean
