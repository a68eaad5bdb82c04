// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: an arrangement many of whose faces meet others wrongly as they are stored, whatever
// repair_places has tried; out: its refined operands as they are stored, with vertices near those
// faces joined, arranged once more, so that what crosses has points there; and so on, while that
// leaves faults. Guarantee: closed operands stay closed; all blocks come from one rounding; it
// ends. Not promised is that it ends without faults, so their number is told. Sources: the rounding
// loops of CGAL's autorefinement and of Valque & Lazard, which move vertices to coarser grids
// instead and drop flat faces before these are refined, which does not keep a surface closed.
#pragma once

#include "vcg_ext/arrange/arrangement.h"
#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/status.h"

#include <functional>

namespace index_boolean {

// Arranges operands that may meet themselves, for what the first arrangement was for.
using ArrangeSoup =
    std::function<Status(MeshArrays operands, const Options& options, Arrangement& out)>;

// Fills out.again, if that leaves fewer faults, and takes what it did into out.placeRepair.
// \param arrangeAgain called once for each round
// \param out its faults are known (placeRepair)
// \return Ok, Cancelled or OutOfMemory. Throws std::bad_alloc.
// Complexity: a bounded number of arrangements of as many faces as there are pieces.
Status holdAsStored(const ArrangeSoup& arrangeAgain, Monitor& monitor, Arrangement& out);

}  // namespace index_boolean
