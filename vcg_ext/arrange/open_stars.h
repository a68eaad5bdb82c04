// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the vertices whose stars floats have left open; out: most of them certified, by doubles along
// any direction, or since all pairs of faces there have been judged.
// Guarantee: no vertex is certified wrongly; the result does not depend on threads.
#pragma once

#include "vcg_ext/arrange/pair_judge.h"
#include "vcg_ext/arrange/star_words.h"

#include <vector>

namespace index_boolean {

// Certifies open stars or judges their pairs, unless there are too many: stars of more than 64
// faces without a common direction stay open. Zero-area faces take no part in pairs.
// \param openStars vertices; ascending
// \param surface   its stars are written
// \return Ok, Cancelled, OutOfMemory or InternalError. Complexity: O(n + k d) for k open stars of d
// faces, O(k d^2) where there is no common direction; in parallel.
Status closeStars(const std::vector<std::uint32_t>& openStars, Monitor& monitor, PairJudge& judge,
                  SearchedSurface& surface);

}  // namespace index_boolean
