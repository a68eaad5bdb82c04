// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the curve's segments; out: its maximal chains between junctions.
// Guarantee: each segment lies in exactly one loop; by index only.
// Source: Mei & Tipper 2013, step 4. A loop is hard-closed if it is a cycle without junction,
// soft-closed if both its ends are junctions, open if an end has degree one.
#pragma once

#include "arrangement.h"
#include "monitor.h"
#include "status.h"

namespace index_boolean {

// Fills arrangement.loops and loopCounts. A junction is a point whose degree is not two.
// \return Ok, Cancelled, OutOfMemory. Complexity: O(s) for s segments.
Status traceLoops(Arrangement& arrangement, Monitor& monitor);

}  // namespace index_boolean
