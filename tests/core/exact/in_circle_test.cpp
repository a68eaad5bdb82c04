// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The in-circle sign against a determinant of rational numbers, and what its perturbation promises.
// GCC 12 takes the inline storage of Boost's integers for uninitialized where it inlines them.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <vcg_ext/exact/in_circle.h>

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace index_boolean {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using Four = std::array<PlanarPlace, 4>;

// The determinant with a row (x, y, x^2 + y^2, 1) for each place.
int expectedSign(const Four& p) {
	std::array<std::array<Rational, 3>, 3> row;
	for (std::size_t i = 0; i < 3; ++i) {
		const Rational x = Rational(p[i][0]) - Rational(p[3][0]);
		const Rational y = Rational(p[i][1]) - Rational(p[3][1]);
		row[i] = {x, y, x * x + y * y};
	}
	const auto minor = [&row](std::size_t i, std::size_t j) {
		return Rational(row[i][0] * row[j][1] - row[i][1] * row[j][0]);
	};
	const Rational value =
	    row[0][2] * minor(1, 2) + row[1][2] * minor(2, 0) + row[2][2] * minor(0, 1);
	return value.sign();
}

bool areCollinear(const Four& p) {
	const auto area = [&p](std::size_t i, std::size_t j, std::size_t k) {
		return Rational(
		    (Rational(p[j][0]) - Rational(p[i][0])) * (Rational(p[k][1]) - Rational(p[i][1])) -
		    (Rational(p[j][1]) - Rational(p[i][1])) * (Rational(p[k][0]) - Rational(p[i][0])));
	};
	return area(0, 1, 2).is_zero() && area(0, 1, 3).is_zero() && area(0, 2, 3).is_zero() &&
	       area(1, 2, 3).is_zero();
}

// Places of several kinds of difficulty: spread, on a small grid (many on one circle), nearly
// equal, on a circle but for rounding, of very different sizes, far away, denormal.
class PlaceSource {
public:
	explicit PlaceSource(std::uint32_t seed) : random_(seed), kind_(seed % 7) {}

	Four four() { return {place(), place(), place(), place()}; }

private:
	PlanarPlace place() {
		if (kind_ == 6) {
			const double angle = std::uniform_real_distribution<double>(0, 7)(random_);
			return {std::cos(angle), std::sin(angle)};
		}
		return {coordinate(), coordinate()};
	}
	double coordinate() {
		const double unit = std::uniform_real_distribution<double>(-1, 1)(random_);
		const int grid = std::uniform_int_distribution<int>(-3, 3)(random_);
		const int exponent = std::uniform_int_distribution<int>(-300, 40)(random_);
		switch (kind_) {
		case 0:
			return unit;
		case 1:
			return grid;
		case 2:
			return 1 + grid * std::numeric_limits<double>::epsilon();
		case 3:
			return std::ldexp(unit, exponent);
		case 4:
			return 1e6 + grid + unit * 1e-9;
		default:
			return grid * std::numeric_limits<double>::denorm_min();
		}
	}

	std::mt19937 random_;
	std::uint32_t kind_;
};

// Calls visit(four places, seed) for so many of each seed.
template <class Visit>
void forEachFour(int count, Visit&& visit) {
	for (std::uint32_t seed = 0; seed < 70; ++seed) {
		SCOPED_TRACE(seed);
		PlaceSource source(seed);
		for (int i = 0; i < count && !testing::Test::HasFatalFailure(); ++i) {
			visit(source.four(), seed);
		}
	}
}

}  // namespace

TEST(InCircle, isTheSignOfTheRationalDeterminant) {
	forEachFour(100, [](const Four& p, std::uint32_t) {
		ASSERT_EQ(inCircle(p[0], p[1], p[2], p[3]), expectedSign(p));
	});
}

TEST(InCircle, overflowIsNoObstacle) {
	const double huge = std::numeric_limits<double>::max();
	EXPECT_EQ(inCircle({-huge, 0}, {0, -huge}, {huge, 0}, {0, 0}), 1);
	EXPECT_EQ(inCircle({-huge, 0}, {0, -huge}, {huge, 0}, {0, huge}), 0);
}

TEST(InCircle, perturbedIsZeroOnALineOnly) {
	forEachFour(100, [](const Four& p, std::uint32_t) {
		const int sign = inCirclePerturbed(p, {3, 1, 2, 0});
		ASSERT_EQ(sign == 0, areCollinear(p));
		if (expectedSign(p) != 0) {
			ASSERT_EQ(sign, expectedSign(p));
		}
	});
}

// As a determinant, it changes its sign when two rows are exchanged, each with its rank.
TEST(InCircle, perturbedIsADeterminant) {
	forEachFour(50, [](const Four& p, std::uint32_t seed) {
		std::array<std::uint32_t, 4> ranks{0, 1, 2, 3};
		std::shuffle(ranks.begin(), ranks.end(), std::mt19937(seed));
		const int sign = inCirclePerturbed(p, ranks);
		for (std::size_t k = 0; k < 3; ++k) {
			Four q = p;
			std::array<std::uint32_t, 4> others = ranks;
			std::swap(q[k], q[k + 1]);
			std::swap(others[k], others[k + 1]);
			ASSERT_EQ(inCirclePerturbed(q, others), -sign);
		}
	});
}

// Heights that are really raised, the lowest rank's by far the most, give the same sign.
TEST(InCircle, perturbedRaisesHeights) {
	const Four square{PlanarPlace{0, 0}, {1, 0}, {1, 1}, {0, 1}};
	for (std::uint32_t first = 0; first < 4; ++first) {
		std::array<std::uint32_t, 4> ranks{1, 2, 3, 4};
		ranks[first] = 0;
		// Opposite corners raised: the diagonal through the others lies lower.
		EXPECT_EQ(inCirclePerturbed(square, ranks), first % 2 == 0 ? 1 : -1);
	}
}

}  // namespace index_boolean
