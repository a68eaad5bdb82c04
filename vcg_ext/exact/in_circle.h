// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The predicate behind Delaunay triangulations: which side of a circle a place lies on.
// Guarantee: exact for all finite doubles. Source: Guibas & Stolfi 1985; ties after Edelsbrunner &
// Muecke, "Simulation of simplicity" (1990).
#pragma once

#include "vcg_ext/exact/exact_number.h"

#include <array>
#include <cmath>
#include <cstdint>

namespace index_boolean {

// Two coordinates of a point as they are stored.
using PlanarPlace = std::array<double, 2>;

// The sign as far as plain doubles tell, or kUnknownSign. With u the unit roundoff, the determinant
// errs by less than (10 + 96 u) u times the sum of its terms' sizes (Shewchuk 1997), but for
// underflow. The conditions see to that: a product's underflow, below 2^-1073, is multiplied by
// less than 2^302 in all; that is below u times the least size admitted, and the factor 16 has room
// for it. They are false for infinities and NaN.
inline int inCircleByDoubles(const PlanarPlace& a, const PlanarPlace& b, const PlanarPlace& c,
                             const PlanarPlace& d) {
	constexpr double kMostHeight = 0x1p300, kLeastSize = 0x1p-700;
	const double px = a[0] - d[0], py = a[1] - d[1], qx = b[0] - d[0], qy = b[1] - d[1],
	             rx = c[0] - d[0], ry = c[1] - d[1];
	const double p = px * px + py * py, q = qx * qx + qy * qy, r = rx * rx + ry * ry;
	const double qr = qx * ry, rq = qy * rx, rp = rx * py, pr = ry * px, pq = px * qy, qp = py * qx;
	const double value = p * (qr - rq) + q * (rp - pr) + r * (pq - qp);
	const double size = p * (std::fabs(qr) + std::fabs(rq)) + q * (std::fabs(rp) + std::fabs(pr)) +
	                    r * (std::fabs(pq) + std::fabs(qp));
	const bool isInRange = p + q + r < kMostHeight && size > kLeastSize;
	if (!isInRange || !(std::fabs(value) > 16 * kRoundoff * size)) {
		return kUnknownSign;
	}
	countSign(Predicate::InCircle, DecidedBy::Double);
	return value > 0 ? 1 : -1;
}

// The sign where doubles leave a doubt, and where all four places are on a circle: parts of the two
// functions below. Complexity: O(1).
int inCircleInDoubt(const PlanarPlace& a, const PlanarPlace& b, const PlanarPlace& c,
                    const PlanarPlace& d);
int inCircleOnCircle(const std::array<PlanarPlace, 4>& places,
                     const std::array<std::uint32_t, 4>& ranks);

// The sign of the in-circle determinant: +1 if d lies inside the circle through a, b, c, where
// these are counter-clockwise; the opposite where they are clockwise; 0 on it.
// Complexity: O(1), almost always some 100 flops.
inline int inCircle(const PlanarPlace& a, const PlanarPlace& b, const PlanarPlace& c,
                    const PlanarPlace& d) {
	const int sign = inCircleByDoubles(a, b, c, d);
	return sign != kUnknownSign ? sign : inCircleInDoubt(a, b, c, d);
}

// As inCircle, with an answer on the circle too: as if each place's height on the paraboloid were
// a little more, infinitely more for the place of lower rank than for all of higher.
// \param ranks all different
// \return 0 only if the four places are on one line. Complexity: O(1).
inline int inCirclePerturbed(const std::array<PlanarPlace, 4>& places,
                             const std::array<std::uint32_t, 4>& ranks) {
	const int sign = inCircle(places[0], places[1], places[2], places[3]);
	return sign != 0 ? sign : inCircleOnCircle(places, ranks);
}

}  // namespace index_boolean
