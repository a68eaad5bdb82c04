// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Unit normals of caps, needles and other faces against normals in whole numbers.
#include <vcg_ext/distance/unit_normal.h>
#include <vcg_ext/exact/zero_area.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace index_boolean {
namespace {

using Integer = boost::multiprecision::int256_t;

// The direction of (b-a)x(c-a) for corners of whole numbers below 2^50.
std::array<long double, 3> trueNormal(const Point& a, const Point& b, const Point& c) {
	std::array<Integer, 3> u, v;
	for (std::size_t k = 0; k < 3; ++k) {
		u[k] = Integer(static_cast<long long>(b[k])) - static_cast<long long>(a[k]);
		v[k] = Integer(static_cast<long long>(c[k])) - static_cast<long long>(a[k]);
	}
	std::array<long double, 3> n;
	for (std::size_t k = 0; k < 3; ++k) {
		const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
		n[k] = Integer(u[i] * v[j] - u[j] * v[i]).convert_to<long double>();
	}
	const long double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
	return {n[0] / length, n[1] / length, n[2] / length};
}

TEST(UnitNormal, isGoodForFacesOfAnyShape) {
	std::mt19937_64 random(1);
	int caps = 0;
	for (int i = 0; i < 20'000; ++i) {
		const auto below = [&](int bits) {
			const auto most = std::int64_t{1} << bits;
			return static_cast<double>(static_cast<std::int64_t>(random() % (2 * most)) - most);
		};
		const int thin = static_cast<int>(random() % 48);
		Point a, b, c;
		for (std::size_t k = 0; k < 3; ++k) {
			a[k] = below(20);
			const double along = below(46);
			b[k] = a[k] + along;
			c[k] = a[k] - std::floor(along * 0.375) + below(thin);  // an angle of about 180 degrees
		}
		if (hasZeroArea(a, b, c)) {
			continue;
		}
		const std::array<long double, 3> truth = trueNormal(a, b, c);
		const double unit = std::ldexp(1.0, static_cast<int>(random() % 1800) - 950);
		const Point normal = unitNormal({a[0] * unit, a[1] * unit, a[2] * unit},
		                                {b[0] * unit, b[1] * unit, b[2] * unit},
		                                {c[0] * unit, c[1] * unit, c[2] * unit});
		for (std::size_t k = 0; k < 3; ++k) {
			ASSERT_NEAR(normal[k], static_cast<double>(truth[k]), 38 * 0x1p-53) << i;
		}
		caps += thin < 30 ? 1 : 0;
	}
	EXPECT_GT(caps, 5000);
}

}  // namespace
}  // namespace index_boolean
