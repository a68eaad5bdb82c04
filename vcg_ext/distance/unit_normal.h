// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: a face with area; out: its unit normal, as good for a needle or a cap as for any other face:
// what it says of the distance from a plane is wrong by a few units in the last place only.
#pragma once

#include "vcg_ext/base/vectors.h"

namespace index_boolean {

// A vector of length 1; zero if the given one is, or is not finite. Any magnitude. Complexity:
// O(1).
Point unitVector(const Point& v);

// (b-a)x(c-a), of length 1: each coordinate within 38 * 2^-53 of the exact one. Depends on which
// corner is the first, in the last bits only. \pre finite, with area Complexity: O(1): some 50
// flops unless the angle at a is near 0 or 180 degrees.
Point unitNormal(const Point& a, const Point& b, const Point& c);

}  // namespace index_boolean
