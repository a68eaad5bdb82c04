// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: both refined surfaces; out: places in which their vertices are stored, and pieces, so that
// fewer faces, as stored, meet others wrongly or have no area; none, if it succeeds.
// Guarantee: the exact surfaces stay what they are, since only stored places change, and diagonals
// within regions; the number of faults falls with each change and never rises. What is done depends
// on geometry alone. Where nothing is wrong, nothing is done: that is nearly always so.
#pragma once

#include "vcg_ext/arrange/arrangement.h"
#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/status.h"

namespace index_boolean {

// Fills arrangement.movedPlaces and .placeRepair, and flips edges of arrangement.refinement.pieces.
// Does nothing unless options.certify is set, and no more than look if too many faces are wrong.
// \return Ok, Cancelled, OutOfMemory, InternalError
// Complexity: where nothing is wrong, one pass over the n faces and a search among the pieces and
// the faces near them, in parallel. Else O(n log n), and bounded work for each wrong face.
Status repairPlaces(Arrangement& arrangement, Monitor& monitor);

}  // namespace index_boolean
