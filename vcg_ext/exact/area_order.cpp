// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/exact/area_order.h"

#include "vcg_ext/base/parallel.h"
#include "vcg_ext/exact/exact_number.h"

#include <algorithm>
#include <array>
#include <limits>

namespace index_boolean {

namespace {

bool isStoppedAt(std::size_t i, Monitor& monitor) {
	constexpr std::size_t kGrain = 256;
	return i % kGrain == 0 && pollCancelled(monitor);
}

template <class Number>
using Vector = std::array<Number, 3>;

template <class Number>
Number differenceOf(double a, double b);
template <>
Bounded differenceOf<Bounded>(double a, double b) {
	return Bounded(a) - Bounded(b);
}
template <>
Dyadic differenceOf<Dyadic>(double a, double b) {
	return Dyadic::difference(a, b);
}

template <class Number>
Vector<Number> cross(const Vector<Number>& u, const Vector<Number>& v) {
	return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

template <class Number>
Number dot(const Vector<Number>& u, const Vector<Number>& v) {
	return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

// The square of twice a triangle's area.
template <class Number>
Number squaredDoubleArea(const Points& points, const Triangle& t) {
	const Point &a = at(points, t[0]), &b = at(points, t[1]), &c = at(points, t[2]);
	const auto minusA = [&a](const Point& p) {
		return Vector<Number>{differenceOf<Number>(p[0], a[0]), differenceOf<Number>(p[1], a[1]),
		                      differenceOf<Number>(p[2], a[2])};
	};
	const Vector<Number> n = cross(minusA(b), minusA(c));
	return dot(n, n);
}

// The root of what a bounded number stands for, which is not negative.
Bounded rootOf(Bounded square) {
	if (square.value <= square.bound) {
		return {0, std::sqrt(square.value + square.bound) * Bounded::kGrow};
	}
	const double root = std::sqrt(square.value);  // |sqrt(t) - sqrt(v)| <= |t - v| / sqrt(v)
	return {root, (square.bound / root + kRoundoff * root) * Bounded::kGrow + kUnderflow};
}

Bounded boundedDoubleArea(const Points& points, const Triangles& triangles) {
	Bounded sum(0);
	for (const Triangle& t : triangles) {
		sum = sum + rootOf(squaredDoubleArea<Bounded>(points, t));
	}
	return sum;
}

// Integers without limit: sums of roots are no numbers of the core's predicates.
using Integer = boost::multiprecision::cpp_int;

// Exact squares of twice the triangles' areas.
struct Squares {
	std::vector<Dyadic> of;

	// Below which power of two all roots are.
	std::int64_t largestExponent() const {
		std::int64_t largest = std::numeric_limits<std::int64_t>::min();
		for (const Dyadic& square : of) {
			if (square.sign() != 0) {
				const auto bits = static_cast<std::int64_t>(msb(square.mantissa()));
				largest = std::max(largest, (bits + square.exponent()) / 2 + 1);
			}
		}
		return largest;
	}

	// The sum of the roots in units of 2^exponent, each rounded down.
	Integer sumOfRoots(std::int64_t exponent, Monitor& monitor) const {
		Integer sum = 0;
		for (std::size_t i = 0; i < of.size() && !isStoppedAt(i, monitor); ++i) {
			const std::int64_t shift = of[i].exponent() - 2 * exponent;
			const Integer mantissa(of[i].mantissa());
			sum += sqrt(shift >= 0 ? Integer(mantissa << static_cast<unsigned>(shift))
			                       : Integer(mantissa >> static_cast<unsigned>(-shift)));
		}
		return sum;
	}
};

Squares squaresOf(const Points& points, const Triangles& triangles, Monitor& monitor) {
	Squares all;
	all.of.reserve(triangles.size());
	for (std::size_t i = 0; i < triangles.size() && !isStoppedAt(i, monitor); ++i) {
		all.of.push_back(squaredDoubleArea<Dyadic>(points, triangles[i]));
	}
	return all;
}

// As integers. What is rounded off is less than one unit a triangle.
int compareByIntegers(const Points& points, const Triangles& a, const Triangles& b,
                      Monitor& monitor) {
	constexpr std::int64_t kBits = 512;
	const Squares ofA = squaresOf(points, a, monitor), ofB = squaresOf(points, b, monitor);
	const std::int64_t largest = std::max(ofA.largestExponent(), ofB.largestExponent());
	if (largest == std::numeric_limits<std::int64_t>::min()) {
		return 0;
	}
	const Integer difference =
	    ofA.sumOfRoots(largest - kBits, monitor) - ofB.sumOfRoots(largest - kBits, monitor);
	return abs(difference) <= a.size() + b.size() ? 0 : difference.sign();
}

Dyadic sixVolumesBelow(const Points& points, const Triangles& triangles, Monitor& monitor) {
	const auto exact = [&points](VertexId v) {
		const Point& p = at(points, v);
		return Vector<Dyadic>{Dyadic(p[0]), Dyadic(p[1]), Dyadic(p[2])};
	};
	Dyadic sum(0.0);
	for (std::size_t i = 0; i < triangles.size() && !isStoppedAt(i, monitor); ++i) {
		const Triangle& t = triangles[i];
		sum = sum + dot(exact(t[0]), cross(exact(t[1]), exact(t[2])));
	}
	return sum;
}

}  // namespace

int compareAreas(const Points& points, const Triangles& a, const Triangles& b, Monitor& monitor) {
	const Bounded difference = boundedDoubleArea(points, a) - boundedDoubleArea(points, b);
	const int sign = difference.sign();
	if (sign != kUnknownSign) {
		return sign;
	}
	const int exact = compareByIntegers(points, a, b, monitor);
	return monitor.cancelled() ? 0 : exact;
}

int compareVolumesBelow(const Points& points, const Triangles& a, const Triangles& b,
                        Monitor& monitor) {
	const Dyadic difference =
	    sixVolumesBelow(points, a, monitor) - sixVolumesBelow(points, b, monitor);
	return monitor.cancelled() ? 0 : difference.sign();
}

}  // namespace index_boolean
