// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rounding of one double to single precision.
#pragma once

namespace index_boolean {

// The float nearest to x, as a double; infinite beyond the range of floats. Complexity: O(1).
// It is a call, not a cast in place: where a loop over a point's coordinates casts there and back,
// GCC 12 at -O3 leaves the rounding out of one of them.
[[gnu::noinline]] inline double nearestFloat(double x) {
	return static_cast<double>(static_cast<float>(x));
}

}  // namespace index_boolean
