// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: points and vectors, by doubles; out: what they make, each operation rounded. For what is
// asked of sizes and distances; signs are decided elsewhere (exact/exact_sign.h).
#pragma once

#include "vcg_ext/base/point.h"

#include <algorithm>

namespace index_boolean {

// a - b, the scalar product, the cross product, and a vector times a number. Complexity: O(1), as
// of all here.
inline Point minus(const Point& a, const Point& b) {
	return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline double dot(const Point& a, const Point& b) {
	return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Point cross(const Point& a, const Point& b) {
	return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Point times(const Point& a, double factor) {
	return {a[0] * factor, a[1] * factor, a[2] * factor};
}

// The square of the distance of two points.
inline double squaredDistance(const Point& a, const Point& b) {
	const Point d = minus(b, a);
	return dot(d, d);
}

// The square of the distance of a point from the segment from a to b, which may be one point.
inline double squaredDistanceToSegment(const Point& p, const Point& a, const Point& b) {
	const Point along = minus(b, a), to = minus(p, a);
	const double length = dot(along, along);
	const double t = length > 0 ? std::clamp(dot(to, along) / length, 0.0, 1.0) : 0;
	const Point off = minus(to, times(along, t));
	return dot(off, off);
}

}  // namespace index_boolean
