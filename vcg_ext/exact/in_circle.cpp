// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One determinant, over the number types of exact_number.h. It is linear in the places' heights,
// with the orientation of the other three as each one's factor: what a small rise of a height does
// to it, is known from three places.
#include "vcg_ext/exact/in_circle.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace index_boolean {

namespace {

// An unevaluated sum high + low. What the operations lose is bounded once for the whole formula: a
// BoundedPair, which finds how much each of them loses, takes three times as long.
struct Pair {
	double high, low;

	static Pair difference(double a, double b) {
		double low = 0;
		const double high = twoSum(a, -b, low);
		return {high, low};
	}
	double size() const { return std::fabs(high); }
};

// Within 3u^2 of the sum of both sizes.
Pair operator+(Pair a, Pair b) {
	double highError = 0, low = 0;
	const double high = twoSum(a.high, b.high, highError);
	const double sum = twoSum(high, highError + (a.low + b.low), low);
	return {sum, low};
}

Pair operator-(Pair a, Pair b) { return a + Pair{-b.high, -b.low}; }

// Within 7u^2 of the product.
Pair operator*(Pair a, Pair b) {
	double error = 0, low = 0;
	const double product = twoProduct(a.high, b.high, error);
	const double high = twoSum(product, error + (a.high * b.low + a.low * b.high), low);
	return {high, low};
}

template <class N>
N difference(double a, double b) {
	if constexpr (std::is_same_v<N, BoundedPair> || std::is_same_v<N, Pair>) {
		return N::difference(a, b);
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

// The sign as far as pairs of doubles tell, or kUnknownSign. With u the unit roundoff, a factor of
// a term, itself a sum of two products, errs by less than 11u^2 of its terms' sizes, the product of
// two factors by 8u^2 more, the two sums by 4u^2 of all sizes each: in all by less than 40u^2 times
// the sum of the terms' sizes. The conditions are as above; what underflows, errors of products
// among it, is below u^2 times the least size admitted.
int inCircleByPairs(const PlanarPlace& a, const PlanarPlace& b, const PlanarPlace& c,
                    const PlanarPlace& d) {
	constexpr double kMostHeight = 0x1p300, kLeastSize = 0x1p-600;
	const Relative<Pair> p(a, d), q(b, d), r(c, d);
	const Pair heightP = p.height(), heightQ = q.height(), heightR = r.height();
	const Pair value = heightP * cross(q, r) + heightQ * cross(r, p) + heightR * cross(p, q);
	const double qrSize = q.x.size() * r.y.size() + q.y.size() * r.x.size();
	const double rpSize = r.x.size() * p.y.size() + r.y.size() * p.x.size();
	const double pqSize = p.x.size() * q.y.size() + p.y.size() * q.x.size();
	const double size = heightP.high * qrSize + heightQ.high * rpSize + heightR.high * pqSize;
	const bool isInRange =
	    heightP.high + heightQ.high + heightR.high < kMostHeight && size > kLeastSize;
	if (!isInRange || !(value.size() > 64 * kRoundoff * kRoundoff * size)) {
		return kUnknownSign;
	}
	countSign(Predicate::InCircle, DecidedBy::DoubleDouble);
	return value.high > 0 ? 1 : -1;
}

}  // namespace

int inCircleInDoubt(const PlanarPlace& a, const PlanarPlace& b, const PlanarPlace& c,
                    const PlanarPlace& d) {
	if (const int sign = inCircleByPairs(a, b, c, d); sign != kUnknownSign) {
		return sign;
	}
	return decideInDoubt(Predicate::InCircle, [&](auto number) {
		using N = typename decltype(number)::Type;
		const Relative<N> p(a, d), q(b, d), r(c, d);
		return (p.height() * cross(q, r) + q.height() * cross(r, p) + r.height() * cross(p, q))
		    .sign();
	});
}

int inCircleOnCircle(const std::array<PlanarPlace, 4>& places,
                     const std::array<std::uint32_t, 4>& ranks) {
	const auto& [a, b, c, d] = places;
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
