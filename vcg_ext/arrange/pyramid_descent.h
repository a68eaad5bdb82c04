// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: a pyramid of boxes; out: the pairs of its faces whose boxes meet, but for those that a
// certified star tells of, judged. Guarantee: each pair once; nothing is stored.
#pragma once

#include "vcg_ext/arrange/box_pyramid.h"
#include "vcg_ext/arrange/pair_judge.h"

namespace index_boolean {

// Descends a pyramid against itself and judges the pairs that are left, those of interest only.
// \return Ok, Cancelled, OutOfMemory or InternalError. Complexity: O(n + p) for n faces and p pairs
// of faces with boxes that meet, in parallel; O(1) memory a thread.
Status descendPyramid(const SearchedSurface& surface, const BoxPyramid& pyramid, Monitor& monitor,
                      PairJudge& judge);

}  // namespace index_boolean
