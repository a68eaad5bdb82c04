// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The normal in doubles errs by less than 4.2u of the products' sizes (see RoundedNormal) in each
// coordinate. Where its largest coordinate is an eighth of the largest size, that is 34u of it; and
// what dividing by the length adds is 4u: together 38u. Else double-doubles, whose bound is
// asked, and else integers.
#include "vcg_ext/distance/unit_normal.h"

#include "vcg_ext/exact/exact_sign.h"

#include <algorithm>
#include <cmath>

namespace index_boolean {

namespace {

double largestOf(const std::array<double, 3>& v) {
	return std::max({std::fabs(v[0]), std::fabs(v[1]), std::fabs(v[2])});
}

template <class Number>
std::array<Number, 3> crossOf(const Point& a, const Point& b, const Point& c) {
	const auto edge = [&a](const Point& to, std::size_t k) {
		return Number::difference(to[k], a[k]);
	};
	const auto component = [&](std::size_t i, std::size_t j) {
		return edge(b, i) * edge(c, j) - edge(b, j) * edge(c, i);
	};
	return {component(1, 2), component(2, 0), component(0, 1)};
}

// The ratios of a normal's coordinates to the largest, correctly rounded.
Point exactRatios(const Point& a, const Point& b, const Point& c) {
	const std::array<Dyadic, 3> normal = crossOf<Dyadic>(a, b, c);
	const auto sizeBefore = [](const Dyadic& left, const Dyadic& right) {
		const Dyadic zero(0.0);
		const Dyadic one = left.sign() < 0 ? zero - left : left;
		const Dyadic other = right.sign() < 0 ? zero - right : right;
		return (one - other).sign() < 0;
	};
	const Dyadic& largest = *std::max_element(normal.begin(), normal.end(), sizeBefore);
	Point ratios{};
	for (std::size_t k = 0; k < 3 && largest.sign() != 0; ++k) {
		const double ratio = roundedQuotient(normal[k], largest);
		ratios[k] = largest.sign() < 0 ? -ratio : ratio;
	}
	return ratios;
}

}  // namespace

Point unitVector(const Point& v) {
	const double largest = largestOf(v);
	if (!(largest > 0) || !std::isfinite(largest)) {
		return {0, 0, 0};
	}
	const int exponent = -std::ilogb(largest);
	const Point scaled{std::scalbn(v[0], exponent), std::scalbn(v[1], exponent),
	                   std::scalbn(v[2], exponent)};
	return times(scaled, 1 / std::sqrt(dot(scaled, scaled)));
}

Point unitNormal(const Point& a, const Point& b, const Point& c) {
	constexpr double kTooSmall = 0x1p-480, kTooLarge = 0x1p480;
	const RoundedNormal rounded(a, b, c);
	const double largest = largestOf(rounded.value);
	if (largest * 8 >= largestOf(rounded.size) && largest > kTooSmall && largest < kTooLarge) {
		return times(rounded.value, 1 / std::sqrt(dot(rounded.value, rounded.value)));
	}
	const std::array<BoundedPair, 3> pairs = crossOf<BoundedPair>(a, b, c);
	const Point values{pairs[0].high, pairs[1].high, pairs[2].high};
	const double bound = pairs[0].bound + pairs[1].bound + pairs[2].bound;
	const double sum = values[0] + values[1] + values[2];  // no number if anything overflows
	if (std::isfinite(sum + bound) && bound <= largestOf(values) * 0x1p-60) {
		return unitVector(values);
	}
	return unitVector(exactRatios(a, b, c));
}

}  // namespace index_boolean
