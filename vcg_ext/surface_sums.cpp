// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Near 1, neither a product of three coordinates nor its rounding leaves the range of double; only
// the last step, which scales back, may.
#include "surface_sums.h"

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

// The edges' cross product comes first: it is small where the triangle is, so its roundings are
// small compared with the triangle's share of the volume.
void addTriangle(const Point& p, const Point& q, const Point& r, SurfaceSums& sums) {
	const Point u = {q[0] - p[0], q[1] - p[1], q[2] - p[2]};
	const Point v = {r[0] - p[0], r[1] - p[1], r[2] - p[2]};
	const Point n = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
	                 u[0] * v[1] - u[1] * v[0]};
	sums.sixVolumes.add(p[0] * n[0] + p[1] * n[1] + p[2] * n[2]);
	sums.twoAreas.add(std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]));
}

double volumeOf(const SurfaceSums& sums, const SumFrame& frame) {
	return std::ldexp(sums.sixVolumes.value() / 6, 3 * frame.exponent);
}

double areaOf(const SurfaceSums& sums, const SumFrame& frame) {
	return std::ldexp(sums.twoAreas.value() / 2, 2 * frame.exponent);
}

}  // namespace index_boolean
