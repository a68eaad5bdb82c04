// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: both operands' triangles; out: the pairs of faces, one of each operand, that may meet.
// Guarantee: every two faces that meet are a pair, listed once, unless they are of one wide fan
// (see common_fans.h) and meet in its vertex only; but each face of such a fan is in a pair with
// one of the other operand's there. Of faces that do not meet, no pair is listed that the plane of
// one face parts, as far as a bound on the rounding tells, nor one whose boxes are apart. The list
// does not depend on the threads. Source: Mei & Tipper 2013, step 1: an octree over the overlap of
// both boxes in which a node without a face of either operand dies, so that the work contracts onto
// the curve.
#pragma once

#include "vcg_ext/arrange/arrangement.h"
#include "vcg_ext/arrange/face_boxes.h"
#include "vcg_ext/arrange/face_pair.h"
#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/status.h"

#include <vector>

namespace index_boolean {

// Finds all pairs of faces, quiet ones left aside, that may meet: their boxes touch or overlap, or
// differ by less than the rounding to float of coordinates taken relative to the operands' common
// box, and no plane of one face parts them. Where many long faces lie askew, pairs are left out
// that a cell of the octree parts. Of the faces of a wide fan: those that may meet elsewhere too,
// and a few. \param mesh    both operands; every face's coordinates are finite \param options
// octree limits and threads \param monitor progress of the stage, and cancel \param out replaced;
// sorted by a, then by b \return Ok, Cancelled, OutOfMemory or InternalError Complexity: O(n + m
// log m + p) for n faces, m of them near the other operand, and p pairs with boxes that meet, those
// of wide fans not counted, nor most of those of long faces askew.
Status findPairs(const MeshArrays& mesh, const Options& options, Monitor& monitor,
                 std::vector<FacePair>& out);

}  // namespace index_boolean
