// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: points, and places around which something is wrong; out: those points in one place that are
// near each other there. Guarantee: what is in one place stays in one place, so that a closed
// surface stays closed; the outcome depends on places and ranks only, not on numbers.
// A coarser grid in place of it moves points that have no other near them, too, and parts some that
// have: on surfaces that are nearly the same it makes more faults than it cures.
#pragma once

#include "vcg_ext/arrange/arrangement.h"

namespace index_boolean {

// The distance of a scalar's values at the largest coordinate of some points; of none, at 0.
// Complexity: O(n).
double unitOf(const Points& points, OutputScalar scalar);

// Joins points that are not farther apart than `reach` along each axis, where one of them is not
// farther than that, or twice as far at most, from one of the places. Points that stay are chosen
// by rank, then lexicographically; each takes those near it that none has taken.
// \param ranks of the points: lower ones stay
// \param reach positive, in the unit of the coordinates
// \return how many points have moved, none of them farther than `reach` along an axis.
// Throws std::bad_alloc. Complexity: O(n log k + m log m) for k places and m points near them.
std::size_t joinNearPlaces(const Points& places, const std::vector<std::uint8_t>& ranks,
                           double reach, Points& points);

}  // namespace index_boolean
