// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: triangles; out: sums of their areas and of the volumes below them, from which the area and
// volume of any surface made of them follow.
// Guarantee: the error is a few roundings of the sum of all |terms|, far from the origin and at any
// scale, since coordinates are taken about the centre of a box and scaled by a power of two.
#pragma once

#include "vcg_ext/exact/bounding_box.h"

#include <cmath>

namespace index_boolean {

// A sum of doubles that keeps what each addition rounds off.
class CompensatedSum {
public:
	void add(double x) {
		const double total = sum_ + x;
		const double part = total - sum_;
		lost_ += (sum_ - (total - part)) + (x - part);
		sum_ = total;
	}

	// \param sign +1 or -1
	void add(const CompensatedSum& other, int sign) {
		add(sign * other.sum_);
		lost_ += sign * other.lost_;
	}

	double value() const { return sum_ + lost_; }

private:
	double sum_ = 0;
	double lost_ = 0;
};

// Moves the box's centre to the origin and brings its size near 1, by a power of two.
struct SumFrame {
	Point centre;
	int exponent;  // of the power that undoes the scaling of a length
	double scale;

	Point map(const Point& p) const {
		return {(p[0] - centre[0]) * scale, (p[1] - centre[1]) * scale, (p[2] - centre[2]) * scale};
	}
};

// The frame of all points in a box. Complexity: O(1).
SumFrame makeSumFrame(const BoundingBox& box);

// The sums over a set of triangles, in a frame.
struct SurfaceSums {
	CompensatedSum sixVolumes;
	CompensatedSum twoAreas;

	// Adds another set, turned over if the sign is -1.
	void add(const SurfaceSums& other, int sign) {
		sixVolumes.add(other.sixVolumes, sign);
		twoAreas.add(other.twoAreas, 1);
	}
};

// Adds the triangle p q r, in the frame's coordinates.
// The edges' cross product comes first: it is small where the triangle is, so its roundings are
// small compared with the triangle's share of the volume.
inline void addTriangle(const Point& p, const Point& q, const Point& r, SurfaceSums& sums) {
	const Point u = {q[0] - p[0], q[1] - p[1], q[2] - p[2]};
	const Point v = {r[0] - p[0], r[1] - p[1], r[2] - p[2]};
	const Point n = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
	                 u[0] * v[1] - u[1] * v[0]};
	sums.sixVolumes.add(p[0] * n[0] + p[1] * n[1] + p[2] * n[2]);
	sums.twoAreas.add(std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]));
}

// The volume that closed triangles enclose, and the area of any; one beyond the range of double
// becomes infinite or 0. In the cube and square of the coordinates' unit. Complexity: O(1).
double volumeOf(const SurfaceSums& sums, const SumFrame& frame);
double areaOf(const SurfaceSums& sums, const SumFrame& frame);

}  // namespace index_boolean
