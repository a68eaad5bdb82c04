// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the numbered curve; out: every cut face as pieces that contain the curve's segments, and the
// regions they form.
// Guarantee: pieces have positive area (exactly), cover their face and no more, and meet the pieces
// of neighbouring faces edge to edge; the choice of diagonals depends on coordinates only.
// Source: Mei & Tipper 2013, step 2 (re-triangulation), by a sweep instead of ear clipping.
#pragma once

#include "vcg_ext/arrange/arrangement.h"
#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/status.h"

namespace index_boolean {

// Fills arrangement.refinement from arrangement.curve.
// \return Ok, Cancelled, OutOfMemory; TooLarge if pieces, their corners or label nodes are more
//         than their numbers can tell; SelfIntersecting if the segments of a face cross or meet
//         outside their ends, which they do only where an operand touches itself
// Complexity: O(k log k) for k points and segments, the faces in parallel.
Status retriangulate(Arrangement& arrangement, Monitor& monitor);

}  // namespace index_boolean
