// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One determinant, over the number types of exact_number.h. It is linear in the places' heights,
// with the orientation of the other three as each one's factor: what a small rise of a height does
// to it, is known from three places.
#include "vcg_ext/exact/in_circle.h"

#include "vcg_ext/exact/exact_number.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace index_boolean {

namespace {

template <class N>
N difference(double a, double b) {
	if constexpr (std::is_same_v<N, BoundedPair>) {
		return BoundedPair::difference(a, b);
	} else {
		return N(a) - N(b);
	}
}

// A place relative to another one.
template <class N>
struct Relative {
	N x, y;

	Relative(const PlanarPlace& p, const PlanarPlace& origin)
	    : x(difference<N>(p[0], origin[0])), y(difference<N>(p[1], origin[1])) {}

	N height() const { return x * x + y * y; }
};

template <class N>
N cross(const Relative<N>& a, const Relative<N>& b) {
	return a.x * b.y - a.y * b.x;
}

int orientation(const PlanarPlace& a, const PlanarPlace& b, const PlanarPlace& c) {
	return decideSign(Predicate::InCircle, [&](auto number) {
		using N = typename decltype(number)::Type;
		return cross(Relative<N>(a, c), Relative<N>(b, c)).sign();
	});
}

// The sign as far as plain doubles tell, or kUnknownSign. With u the unit roundoff, the determinant
// errs by less than (10 + 96 u) u times the sum of its terms' sizes (Shewchuk 1997), but for
// underflow. The conditions see to that: a product's underflow, below 2^-1073, is multiplied by
// less than 2^302 in all; that is below u times the least size admitted, and the factor 16 has room
// for it. They are false for infinities and NaN.
int inCircleByDoubles(const PlanarPlace& a, const PlanarPlace& b, const PlanarPlace& c,
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

}  // namespace

int inCircle(const PlanarPlace& a, const PlanarPlace& b, const PlanarPlace& c,
             const PlanarPlace& d) {
	if (const int sign = inCircleByDoubles(a, b, c, d); sign != kUnknownSign) {
		return sign;
	}
	return decideInDoubt(Predicate::InCircle, [&](auto number) {
		using N = typename decltype(number)::Type;
		const Relative<N> p(a, d), q(b, d), r(c, d);
		return (p.height() * cross(q, r) + q.height() * cross(r, p) + r.height() * cross(p, q))
		    .sign();
	});
}

int inCirclePerturbed(const std::array<PlanarPlace, 4>& places,
                      const std::array<std::uint32_t, 4>& ranks) {
	const auto& [a, b, c, d] = places;
	if (const int sign = inCircle(a, b, c, d); sign != 0) {
		return sign;
	}
	std::array<std::size_t, 4> order{0, 1, 2, 3};
	std::sort(order.begin(), order.end(),
	          [&ranks](std::size_t i, std::size_t j) { return ranks[i] < ranks[j]; });
	for (const std::size_t i : order) {
		const int factor = i == 0   ? orientation(b, c, d)
		                   : i == 1 ? orientation(c, a, d)
		                   : i == 2 ? orientation(a, b, d)
		                            : orientation(b, a, c);
		if (factor != 0) {
			return factor;
		}
	}
	return 0;
}

}  // namespace index_boolean
