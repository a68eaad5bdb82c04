// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Near 1, neither a product of three coordinates nor its rounding leaves the range of double; only
// the last step, which scales back, may.
#include "vcg_ext/exact/surface_sums.h"

#include <algorithm>
#include <cmath>

namespace index_boolean {

SumFrame makeSumFrame(const BoundingBox& box) {
	SumFrame frame{};
	frame.centre = box.centre();
	std::frexp(box.halfSize(), &frame.exponent);
	frame.exponent = std::max(frame.exponent, -1000);  // a power's inverse has to be a double too
	frame.scale = std::ldexp(1.0, -frame.exponent);
	return frame;
}

double volumeOf(const SurfaceSums& sums, const SumFrame& frame) {
	return std::ldexp(sums.sixVolumes.value() / 6, 3 * frame.exponent);
}

double areaOf(const SurfaceSums& sums, const SumFrame& frame) {
	return std::ldexp(sums.twoAreas.value() / 2, 2 * frame.exponent);
}

}  // namespace index_boolean
