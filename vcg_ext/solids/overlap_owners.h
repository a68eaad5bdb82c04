// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the labelled arrangement; out: for each coplanar overlap of two walls that face the same way,
// which operand's faces stand for it in a block.
// Guarantee: decided by geometry, so that operands in the other order give the same faces. Where
// one operand's wall goes on beyond the overlap and the other's does not, it is that one's: then a
// wall touched by a smaller one is whole again.
#pragma once

#include "vcg_ext/arrange/arrangement.h"
#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/status.h"

namespace index_boolean {

// Fills arrangement.labels.owner. Overlaps that share an edge have one owner.
// \return Ok or Cancelled
// Complexity: O(k log k) for k pieces; O(1) if no walls overlap so.
Status chooseOverlapOwners(Arrangement& arrangement, Monitor& monitor);

}  // namespace index_boolean
