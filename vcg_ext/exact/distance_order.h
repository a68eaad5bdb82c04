// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: two points and a distance; out: which is larger, their distance or that one. Guarantee: exact
// for any finite numbers, subnormals and the largest ones included.
#pragma once

#include "vcg_ext/base/point.h"

namespace index_boolean {

// The sign of |a - b| minus `times` the distance: -1, 0 or 1.
// \pre all numbers are finite, neither distance nor times is negative
// Complexity: O(1), nearly always by doubles.
int compareDistance(const Point& a, const Point& b, double distance, double times = 1);

}  // namespace index_boolean
