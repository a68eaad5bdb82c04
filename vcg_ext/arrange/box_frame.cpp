// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: a box; out: its frame. The scale is a power of two, so that it rounds nothing.
#include "vcg_ext/arrange/box_frame.h"

#include <cmath>

namespace index_boolean {

BoxFrame makeBoxFrame(const BoundingBox& box) {
	BoxFrame frame;
	frame.centre = box.centre();
	int exponent = 0;
	std::frexp(box.halfSize(), &exponent);
	const int scaleExponent = std::min(-exponent, 1000);  // a larger power is no double
	frame.scale = std::ldexp(1.0, scaleExponent);
	frame.halfSize = static_cast<float>(std::ldexp(1.0, exponent + scaleExponent));
	return frame;
}

}  // namespace index_boolean
