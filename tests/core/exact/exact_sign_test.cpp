// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every predicate against rational arithmetic that shares no code with it.
// GCC 12 takes the inline storage of Boost's integers for uninitialized where it inlines them.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <vcg_ext/exact/exact_sign.h>

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace index_boolean {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using RationalPoint = std::array<Rational, 3>;

RationalPoint rational(const Point& p) { return {Rational(p[0]), Rational(p[1]), Rational(p[2])}; }

RationalPoint minus(const RationalPoint& a, const RationalPoint& b) {
	return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

RationalPoint crossed(const RationalPoint& a, const RationalPoint& b) {
	return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Rational dotted(const RationalPoint& a, const RationalPoint& b) {
	return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Rational planeValue(const Point& a, const Point& b, const Point& c, const RationalPoint& p) {
	const RationalPoint r = rational(a);
	return dotted(crossed(minus(rational(b), r), minus(rational(c), r)), minus(p, r));
}

RationalPoint between(const Point& p, const Point& q, const Rational& t) {
	const RationalPoint d = minus(rational(q), rational(p));
	const RationalPoint r = rational(p);
	return {r[0] + t * d[0], r[1] + t * d[1], r[2] + t * d[2]};
}

Rational areaValue(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c,
                   int axis) {
	return crossed(minus(b, a), minus(c, a))[static_cast<std::size_t>(axis)];
}

// The oracle's own way to each form of point.
RationalPoint exactly(const ExactPoint& p) {
	const auto& by = p.by;
	switch (p.form) {
	case ExactPoint::Form::Explicit:
		return rational(*by[0]);
	case ExactPoint::Form::LinePlane: {
		const Rational f = planeValue(*by[2], *by[3], *by[4], rational(*by[0]));
		const Rational g = planeValue(*by[2], *by[3], *by[4], rational(*by[1]));
		return between(*by[0], *by[1], Rational(f / (f - g)));
	}
	case ExactPoint::Form::LineLine: {
		const RationalPoint c = rational(*by[2]), d = rational(*by[3]);
		const Rational f = areaValue(c, d, rational(*by[0]), p.axis);
		const Rational g = areaValue(c, d, rational(*by[1]), p.axis);
		return between(*by[0], *by[1], Rational(f / (f - g)));
	}
	case ExactPoint::Form::ThreePlanes:
		break;
	}
	std::array<RationalPoint, 3> n;
	RationalPoint right;
	for (std::size_t i = 0; i < 3; ++i) {
		const RationalPoint a = rational(*by[3 * i]);
		n[i] = crossed(minus(rational(*by[3 * i + 1]), a), minus(rational(*by[3 * i + 2]), a));
		right[i] = dotted(n[i], a);
	}
	const Rational determinant = dotted(n[0], crossed(n[1], n[2]));
	RationalPoint x;
	const RationalPoint u = crossed(n[1], n[2]), v = crossed(n[2], n[0]), w = crossed(n[0], n[1]);
	for (std::size_t k = 0; k < 3; ++k) {
		x[k] = (right[0] * u[k] + right[1] * v[k] + right[2] * w[k]) / determinant;
	}
	return x;
}

int signOf(const Rational& r) { return r.sign(); }

void expectNearest(double rounded, const Rational& exact) {
	const Rational error = abs(Rational(rounded) - exact);
	const double up = std::nextafter(rounded, HUGE_VAL);
	const double down = std::nextafter(rounded, -HUGE_VAL);
	EXPECT_LE(error, abs(Rational(up) - exact));
	EXPECT_LE(error, abs(Rational(down) - exact));
	if (error == abs(Rational(up) - exact) || error == abs(Rational(down) - exact)) {
		int exponent = 0;
		const double fraction = std::ldexp(std::frexp(rounded, &exponent), 53);
		EXPECT_EQ(std::fmod(fraction, 2.0), 0.0) << "a tie goes to even";
	}
}

// Points of several kinds of difficulty: spread, on a coarse grid (many zeros), nearly equal, of
// very different magnitudes, far from the origin, denormal.
class PointSource {
public:
	explicit PointSource(std::uint32_t seed) : random_(seed), kind_(seed % 6) {}

	Point operator()() {
		Point p{};
		for (double& c : p) {
			c = coordinate();
		}
		return p;
	}

private:
	double coordinate() {
		std::uniform_real_distribution<double> unit(-1, 1);
		std::uniform_int_distribution<int> grid(-3, 3);
		std::uniform_int_distribution<int> exponent(-300, 40);
		switch (kind_) {
		case 0:
			return unit(random_);
		case 1:
			return grid(random_);
		case 2:
			return 1 + grid(random_) * std::numeric_limits<double>::epsilon();
		case 3:
			return std::ldexp(unit(random_), exponent(random_));
		case 4:
			return 1e6 + grid(random_) + unit(random_) * 1e-9;
		default:
			return grid(random_) * std::numeric_limits<double>::denorm_min();
		}
	}

	std::mt19937 random_;
	std::uint32_t kind_;
};

constexpr std::uint32_t kSeeds = 1200;

TEST(ExactSign, orient3dEqualsRationalArithmetic) {
	for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
		SCOPED_TRACE("seed " + std::to_string(seed));
		PointSource next(seed);
		const Point a = next(), b = next(), c = next(), p = next();
		EXPECT_EQ(orient3d(a, b, c, p), signOf(planeValue(a, b, c, rational(p))));
	}
}

TEST(ExactSign, planeFilterNeverErrsAndKnowsInGeneralPosition) {
	std::size_t known = 0, generic = 0;
	for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
		SCOPED_TRACE("seed " + std::to_string(seed));
		PointSource next(seed);
		const Point a = next(), b = next(), c = next(), p = next();
		const int side = PlaneFilter(a, b, c).side(p);
		if (side != kUnknownSign) {
			EXPECT_EQ(side, signOf(planeValue(a, b, c, rational(p))));
		}
		if (seed % 6 == 0) {  // coordinates spread evenly
			++generic;
			known += side != kUnknownSign ? 1u : 0u;
		}
	}
	EXPECT_EQ(known, generic);
}

TEST(ExactSign, orient2dEqualsRationalArithmetic) {
	for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
		SCOPED_TRACE("seed " + std::to_string(seed));
		PointSource next(seed);
		const Point a = next(), b = next(), c = next();
		for (int axis = 0; axis < 3; ++axis) {
			EXPECT_EQ(orient2d(a, b, c, axis),
			          signOf(areaValue(rational(a), rational(b), rational(c), axis)));
		}
	}
}

// One point of each form, as far as its simplices meet in one point.
std::vector<ExactPoint> somePoints(PointSource& next, Points& storage) {
	storage.clear();
	for (int i = 0; i < 19; ++i) {
		storage.push_back(next());
	}
	const Point* s = storage.data();
	std::vector<ExactPoint> points{ExactPoint::explicitPoint(s[0])};
	const auto plane = [s](std::size_t i, std::size_t p) {
		return planeValue(s[i], s[i + 1], s[i + 2], rational(s[p]));
	};
	if (plane(3, 1) != plane(3, 2)) {
		points.push_back(ExactPoint::linePlane({s + 1, s + 2, s + 3, s + 4, s + 5}));
	}
	for (int axis = 0; axis < 3; ++axis) {
		const Rational f = areaValue(rational(s[8]), rational(s[9]), rational(s[6]), axis);
		const Rational g = areaValue(rational(s[8]), rational(s[9]), rational(s[7]), axis);
		if (f != g) {
			points.push_back(ExactPoint::lineLine({s + 6, s + 7, s + 8, s + 9}, axis));
			break;
		}
	}
	std::array<RationalPoint, 3> n;
	for (std::size_t i = 0; i < 3; ++i) {
		const RationalPoint a = rational(s[10 + 3 * i]);
		n[i] = crossed(minus(rational(s[11 + 3 * i]), a), minus(rational(s[12 + 3 * i]), a));
	}
	if (dotted(n[0], crossed(n[1], n[2])) != 0) {
		points.push_back(ExactPoint::threePlanes(
		    {s + 10, s + 11, s + 12, s + 13, s + 14, s + 15, s + 16, s + 17, s + 18}));
	}
	for (ExactPoint& p : points) {
		roundPoint(p);
	}
	return points;
}

TEST(ExactSign, roundedCoordinatesAreTheNearestDoubles) {
	Points storage;
	for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
		SCOPED_TRACE("seed " + std::to_string(seed));
		PointSource next(seed);
		for (const ExactPoint& p : somePoints(next, storage)) {
			const RationalPoint exact = exactly(p);
			for (std::size_t k = 0; k < 3; ++k) {
				if (std::isfinite(p.rounded[k])) {
					expectNearest(p.rounded[k], exact[k]);
				} else {
					EXPECT_GT(abs(exact[k]), Rational(std::numeric_limits<double>::max()));
				}
			}
		}
	}
}

TEST(ExactSign, implicitPointsCompareAndTurnAsRationalOnes) {
	Points storage[3];
	for (std::uint32_t seed = 0; seed < kSeeds / 3; ++seed) {
		SCOPED_TRACE("seed " + std::to_string(seed));
		PointSource next(seed);
		const auto as = somePoints(next, storage[0]);
		const auto bs = somePoints(next, storage[1]);
		const auto cs = somePoints(next, storage[2]);
		for (std::size_t i = 0; i < std::min({as.size(), bs.size(), cs.size()}); ++i) {
			const ExactPoint& a = as[i];
			const ExactPoint& b = bs[bs.size() - 1 - i % bs.size()];
			const ExactPoint& c = cs[i];
			const RationalPoint x = exactly(a), y = exactly(b), z = exactly(c);
			for (int axis = 0; axis < 3; ++axis) {
				const auto k = static_cast<std::size_t>(axis);
				EXPECT_EQ(compareCoordinate(a, b, axis), signOf(Rational(x[k] - y[k])));
				EXPECT_EQ(orient2d(a, b, c, axis), signOf(areaValue(x, y, z, axis)));
			}
			EXPECT_EQ(orient2d(a, b, a, 0), 0);
		}
	}
}

TEST(ExactSign, roundingDoesNotDependOnTheOrderOfCorners) {
	Points storage;
	for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
		PointSource next(seed);
		for (const ExactPoint& p : somePoints(next, storage)) {
			if (p.form == ExactPoint::Form::LinePlane) {
				ExactPoint q = ExactPoint::linePlane({p.by[1], p.by[0], p.by[4], p.by[2], p.by[3]});
				roundPoint(q);
				EXPECT_EQ(p.rounded, q.rounded) << "seed " << seed;
			}
		}
	}
}

TEST(ExactSign, differencesOfDoublesAreExact) {
	using boost::multiprecision::cpp_int;
	const auto valueOf = [](const Dyadic& d) {
		const Rational mantissa{cpp_int(d.mantissa())};
		const Rational power{cpp_int(1) << static_cast<unsigned>(std::abs(d.exponent()))};
		return d.exponent() < 0 ? Rational(mantissa / power) : Rational(mantissa * power);
	};
	constexpr double kMost = std::numeric_limits<double>::max();
	constexpr double kLeast = std::numeric_limits<double>::denorm_min();
	std::vector<double> numbers{0.0,    -0.0,    1,          0.1,       -0.3,
	                            1e17,   1e300,   -1e-300,    kMost,     -kMost,
	                            kLeast, -kLeast, 7 * kLeast, 0x1p-1022, 0x1p52};
	std::mt19937 random(4);
	std::uniform_real_distribution<double> place(-1, 1);
	for (int i = 0; i < 20; ++i) {
		numbers.push_back(place(random));
	}
	for (const double a : numbers) {
		EXPECT_EQ(valueOf(Dyadic(a)), Rational(a)) << a;
		for (const double b : numbers) {
			EXPECT_EQ(valueOf(Dyadic::difference(a, b)), Rational(a) - Rational(b))
			    << a << ' ' << b;
		}
	}
}

TEST(ExactSign, aProductAndItsErrorAreTheProduct) {
	std::mt19937 random(9);
	std::uniform_real_distribution<double> mantissa(-1, 1);
	std::uniform_int_distribution<int> exponent(-430, 480);
	for (int i = 0; i < 20000; ++i) {
		const double a = std::ldexp(mantissa(random), exponent(random));
		const double b = std::ldexp(mantissa(random), exponent(random));
		double error;
		const double product = twoProduct(a, b, error);
		EXPECT_EQ(Rational(product) + Rational(error), Rational(a) * Rational(b)) << a << ' ' << b;
	}
}

TEST(ExactSign, quotientsRoundToNearestAlsoWhereTheyAreDenormal) {
	const auto quotient = [](double n, double scale, double d) {
		return roundedQuotient(Dyadic(n) * Dyadic(scale), Dyadic(d));
	};
	EXPECT_EQ(quotient(1, 1, 3), 1.0 / 3.0);
	EXPECT_EQ(quotient(-2, 1, 3), -2.0 / 3.0);
	const double tiny = std::numeric_limits<double>::denorm_min();
	EXPECT_EQ(quotient(tiny, 1, 2), 0.0);       // a tie, to even
	EXPECT_EQ(quotient(3, tiny, 2), 2 * tiny);  // a tie, to even
	EXPECT_EQ(quotient(3, tiny, 4), tiny);
	EXPECT_EQ(quotient(1e300, 1e300, 1), HUGE_VAL);
	EXPECT_EQ(quotient(9007199254740993.0, 1, 1), 9007199254740992.0);
}

}  // namespace
}  // namespace index_boolean
