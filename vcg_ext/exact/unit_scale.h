// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: a box; out: a factor for its coordinates. Guarantee: a power of two, so that nothing is
// rounded but what becomes smaller than doubles are.
#pragma once

#include "vcg_ext/exact/bounding_box.h"

#include <algorithm>
#include <cmath>

namespace index_boolean {

// A power of two that brings the largest coordinate in a box near 1, so that products of
// coordinates neither overflow nor vanish; 1 if there is no coordinate but zero. Complexity: O(1).
inline double unitScale(const BoundingBox& box) {
	double largest = 0;
	for (std::size_t axis = 0; axis < 3; ++axis) {
		largest = std::max({largest, std::abs(box.lo[axis]), std::abs(box.hi[axis])});
	}
	constexpr int kSmallestExponent = -1022;  // beyond, the scale itself would overflow
	return largest > 0 ? std::ldexp(1.0, -std::max(std::ilogb(largest), kSmallestExponent)) : 1.0;
}

}  // namespace index_boolean
