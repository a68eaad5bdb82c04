// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Distances and the groups that they make, against integers of any size, on all pairs.
#include <vcg_ext/exact/distance_order.h>
#include <vcg_ext/exact/point_groups.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <set>

namespace index_boolean {
namespace {

using Integer = boost::multiprecision::cpp_int;
using Groups = std::vector<std::uint32_t>;

constexpr double kTiny = std::numeric_limits<double>::denorm_min();
constexpr double kHuge = std::numeric_limits<double>::max();

// A finite double times 2^1100, which is a whole number.
Integer scaled(double x) {
	int exponent = 0;
	const double mantissa = std::ldexp(std::frexp(x, &exponent), 53);
	constexpr int kScale = 1100;
	const Integer whole(static_cast<std::int64_t>(mantissa));
	const int shift = exponent - 53 + kScale;
	return shift >= 0 ? Integer(whole << shift) : Integer(whole / (Integer(1) << -shift));
}

using ScaledPoint = std::array<Integer, 3>;

ScaledPoint scaled(const Point& p) { return {scaled(p[0]), scaled(p[1]), scaled(p[2])}; }

// \param limit a distance, scaled as the points are
int expectedOrder(const ScaledPoint& a, const ScaledPoint& b, const Integer& limit) {
	Integer sum = 0;
	for (std::size_t k = 0; k < 3; ++k) {
		const Integer difference = a[k] - b[k];
		sum += difference * difference;
	}
	return sum.compare(limit * limit);
}

// A number whose magnitude is of any kind, often one of few so that distances are equal.
double anyNumber(std::mt19937& random, int kind) {
	const auto whole = static_cast<double>(random() % 7) - 3;
	switch (kind) {
	case 0:
		return whole;
	case 1:
		return whole * kTiny;
	case 2:
		return whole / 4 * kHuge;
	case 3:
		return std::nextafter(whole, random() % 2 == 0 ? -10 : 10);
	default:
		return std::ldexp(whole, static_cast<int>(random() % 2000) - 1000);
	}
}

TEST(DistanceOrder, isThatOfIntegersForAllMagnitudes) {
	std::mt19937 random(5);
	std::array<int, 3> seen{};
	for (int run = 0; run < 6000; ++run) {
		const int kind = run % 5;
		Point a{}, b{};
		for (std::size_t k = 0; k < 3; ++k) {
			a[k] = anyNumber(random, kind);
			b[k] = anyNumber(random, kind);
		}
		const double distance = std::fabs(anyNumber(random, kind));
		const double times = run % 2 == 0 ? 1 : 2;
		const int order = compareDistance(a, b, distance, times);
		const Integer limit = scaled(distance) * static_cast<int>(times);
		const int expected = expectedOrder(scaled(a), scaled(b), limit);
		ASSERT_EQ(order, expected < 0 ? -1 : expected > 0 ? 1 : 0) << "run " << run;
		++seen[static_cast<std::size_t>(order + 1)];
	}
	EXPECT_GT(*std::min_element(seen.begin(), seen.end()), 30);
	EXPECT_EQ(compareDistance({0, 0, 0}, {3, 4, 0}, 5), 0);
	EXPECT_EQ(compareDistance({0, 0, 0}, {3, 4, 1e-300}, 5), 1);
	EXPECT_EQ(compareDistance({0, 0, 0}, {3, std::nextafter(4.0, 0), 0}, 5), -1);
}

std::vector<ScaledPoint> allScaled(const Points& points) {
	std::vector<ScaledPoint> all;
	for (const Point& p : points) {
		all.push_back(scaled(p));
	}
	return all;
}

Groups expectedGroups(const Points& points, double distance) {
	const std::vector<ScaledPoint> places = allScaled(points);
	const Integer limit = scaled(distance);
	Groups group(points.size());
	std::iota(group.begin(), group.end(), 0u);
	const auto root = [&group](std::uint32_t i) {
		while (group[i] != i) {
			i = group[i];
		}
		return i;
	};
	for (std::uint32_t i = 0; i < points.size(); ++i) {
		for (std::uint32_t j = 0; j < i; ++j) {
			if (expectedOrder(places[i], places[j], limit) < 0) {
				const std::uint32_t a = root(i), b = root(j);
				const bool isFirst = points[a] < points[b] || (points[a] == points[b] && a < b);
				(isFirst ? group[b] : group[a]) = isFirst ? a : b;
			}
		}
	}
	for (std::uint32_t i = 0; i < points.size(); ++i) {
		group[i] = root(i);
	}
	return group;
}

Groups expectedWide(const Points& points, const Groups& groups, double distance) {
	const std::vector<ScaledPoint> places = allScaled(points);
	const Integer limit = 2 * scaled(distance);
	Groups wide;
	for (std::uint32_t i = 0; i < points.size(); ++i) {
		for (std::uint32_t j = 0; j < i; ++j) {
			if (groups[i] == groups[j] && expectedOrder(places[i], places[j], limit) > 0) {
				wide.push_back(groups[i]);
			}
		}
	}
	std::sort(wide.begin(), wide.end());
	wide.erase(std::unique(wide.begin(), wide.end()), wide.end());
	return wide;
}

Groups groupsOf(const Points& points, double distance) {
	Monitor monitor;
	Groups groups;
	EXPECT_TRUE(groupPoints(points, distance, monitor, groups).ok());
	return groups;
}

Groups wideOf(const Points& points, const Groups& groups, double distance) {
	Monitor monitor;
	Groups wide{77};  // replaced
	EXPECT_TRUE(findWideGroups(points, groups, distance, monitor, wide).ok());
	return wide;
}

// Points in a few clusters of a grid, so that many distances are equal to the one asked for, or
// next to it.
Points clusters(std::mt19937& random, double step, double far) {
	Points points;
	for (int cluster = 0; cluster < 4; ++cluster) {
		const double at = far * static_cast<double>(random() % 3);
		const std::size_t spread = 1 + random() % 12;
		for (std::size_t i = 0, count = 3 + random() % 30; i < count; ++i) {
			Point p{};
			for (double& x : p) {
				x = at + step * static_cast<double>(random() % spread);
				x = random() % 4 == 0 ? std::nextafter(x, -1) : x;
			}
			points.push_back(p);
		}
	}
	return points;
}

TEST(PointGroups, areThoseOfAllPairsAndSoAreTheWideOnes) {
	std::mt19937 random(11);
	std::size_t wideSeen = 0, grouped = 0;
	const std::array<double, 5> steps{1, 1.0 / 3, 1e-300, 1e299, 1e-9};
	for (int run = 0; run < 300; ++run) {
		const double step = steps[static_cast<std::size_t>(run) % steps.size()];
		const Points points = clusters(random, step, run % 3 == 0 ? step * 1e7 : step * 40);
		const double length = std::sqrt(static_cast<double>(1 + random() % 20)) / 2;
		const double distance = step * length;
		const Groups groups = groupsOf(points, distance);
		ASSERT_EQ(groups, expectedGroups(points, distance)) << "run " << run;
		const Groups wide = wideOf(points, groups, distance);
		ASSERT_EQ(wide, expectedWide(points, groups, distance)) << "run " << run;
		wideSeen += wide.size();
		for (std::uint32_t i = 0; i < groups.size(); ++i) {
			grouped += groups[i] != i && points[groups[i]] != points[i] ? 1 : 0;
		}
	}
	EXPECT_GT(wideSeen, 50u);
	EXPECT_GT(grouped, 500u);
}

TEST(PointGroups, reachFromTheSmallestNumbersToTheLargest) {
	const Points tiny{{0, 0, 0}, {kTiny, 0, 0}, {3 * kTiny, 0, 0}, {-kTiny, 0, 0}, {-0.0, 0, 0}};
	EXPECT_EQ(groupsOf(tiny, kTiny), (Groups{0, 1, 2, 3, 0}));
	EXPECT_EQ(groupsOf(tiny, 2 * kTiny), (Groups{3, 3, 2, 3, 3}));
	EXPECT_EQ(groupsOf(tiny, 3 * kTiny), (Groups{3, 3, 3, 3, 3}));
	const Points huge{{-kHuge, 0, 0}, {kHuge, 0, 0}, {0, 0, 0}, {kHuge, kHuge, kHuge}};
	EXPECT_EQ(groupsOf(huge, kHuge), (Groups{0, 1, 2, 3}));
	EXPECT_EQ(groupsOf({{-kHuge / 2, 0, 0}, {kHuge / 4, 0, 0}}, kHuge), (Groups{0, 0}));
	EXPECT_EQ(groupsOf(huge, kTiny), (Groups{0, 1, 2, 3}));
	// Numbers that are farther from each other than the distance is long, or half of it.
	const double next = std::nextafter(1e20, kHuge), step = next - 1e20;
	const Points steps{{1e20, 0, 0}, {next, 0, 0}, {next + step, 0, 0}};
	EXPECT_EQ(groupsOf(steps, step), (Groups{0, 1, 2}));
	EXPECT_EQ(groupsOf(steps, std::nextafter(step, kHuge)), (Groups{0, 0, 0}));
}

TEST(PointGroups, areTheSameInAnyOrder) {
	std::mt19937 random(3);
	for (int run = 0; run < 50; ++run) {
		const Points points = clusters(random, 1, 40);
		std::vector<std::uint32_t> order(points.size());
		std::iota(order.begin(), order.end(), 0u);
		std::shuffle(order.begin(), order.end(), random);
		Points shuffled;
		for (const std::uint32_t i : order) {
			shuffled.push_back(points[i]);
		}
		const Groups groups = groupsOf(points, 1.5), others = groupsOf(shuffled, 1.5);
		for (std::size_t i = 0; i < order.size(); ++i) {
			ASSERT_EQ(shuffled[others[i]], points[groups[order[i]]]);
		}
	}
}

// Looking at all pairs of these would take hours.
TEST(PointGroups, ofCrowdedPointsAreSoonFound) {
	constexpr std::size_t kMany = 100000, kInBall = 10000;
	std::mt19937 random(1);
	std::uniform_real_distribution<double> within(0, 0.4);
	std::normal_distribution<double> normal;
	Points apart, ball;
	for (std::size_t i = 0; i < kMany; ++i) {
		// Two clusters whose boxes are less than 1 apart, and whose points are more.
		const double x = within(random), y = within(random), z = within(random);
		const double gap = i % 2 == 0 ? 0 : 1;
		const double slope = 0.4 - x;
		apart.push_back({gap + (i % 2 == 0 ? x : x + slope), y, i % 2 == 0 ? z : z + slope + 0.3});
		// A sphere whose diameter is 2, less a bit.
		Point p{normal(random), normal(random), normal(random)};
		const double length = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
		for (double& coordinate : p) {
			coordinate *= 0.999999 / length;
		}
		if (i < kInBall) {
			ball.push_back(p);
		}
	}
	const Groups two = groupsOf(apart, 1);
	EXPECT_LE(std::set<std::uint32_t>(two.begin(), two.end()).size(), 2u);
	EXPECT_TRUE(wideOf(apart, two, 1).empty());
	const Groups one = groupsOf(ball, 1);
	EXPECT_EQ(std::set<std::uint32_t>(one.begin(), one.end()).size(), 1u);
	EXPECT_TRUE(wideOf(ball, one, 1).empty());
	EXPECT_EQ(wideOf(ball, one, 0.999).size(), 1u);

	Points line;  // one far away, all others in a row
	for (std::size_t i = 0; i < kMany; ++i) {
		line.push_back({i == 0 ? 1e9 : 1e-9 * static_cast<double>(i), 0, 0});
	}
	const Groups row = groupsOf(line, 1.5e-9);
	EXPECT_EQ(row[0], 0u);
	EXPECT_TRUE(std::all_of(row.begin() + 1, row.end(), [](auto g) { return g == 1; }));
	EXPECT_EQ(wideOf(line, row, 1.5e-9), Groups{1});
	EXPECT_EQ(groupsOf(line, 1e-10)[5], 5u);
}

TEST(PointGroups, areLeftWhenTheUserCancels) {
	Monitor monitor([](double, const char*) { return false; });
	monitor.beginStage("groups", 0, 1);
	monitor.report(0.5);
	Groups groups;
	EXPECT_EQ(groupPoints({{0, 0, 0}, {1, 0, 0}}, 1, monitor, groups).code, StatusCode::Cancelled);
}

}  // namespace
}  // namespace index_boolean
