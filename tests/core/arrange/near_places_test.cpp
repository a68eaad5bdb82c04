// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Joining points that are near each other around places where something is wrong.
#include <vcg_ext/arrange/near_places.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>

namespace index_boolean {
namespace {

std::vector<std::uint8_t> ranks(const Points& points, std::uint8_t rank = 0) {
	return std::vector<std::uint8_t>(points.size(), rank);
}

TEST(NearPlaces, theUnitIsTheStepAtTheLargestCoordinate) {
	const Points points{{1, 0, 0}, {0, -3, .5}};
	EXPECT_EQ(unitOf(points, OutputScalar::Double), 0x1p-51);
	EXPECT_EQ(unitOf(points, OutputScalar::Float), 0x1p-22);
	EXPECT_GT(unitOf({}, OutputScalar::Double), 0);
}

TEST(NearPlaces, joinsWhatIsNearAndNothingElse) {
	Points points{{0, 0, 0}, {1, 1, -1}, {2, 0, 0}, {50, 0, 0}, {51, 0, 0}};
	EXPECT_EQ(joinNearPlaces({{0, 0, 0}}, ranks(points), 1, points), 1U);
	// The lowest comes first and takes what is near it; (2, 0, 0) is farther than 1 from that.
	EXPECT_EQ(points, (Points{{0, 0, 0}, {0, 0, 0}, {2, 0, 0}, {50, 0, 0}, {51, 0, 0}}));
}

TEST(NearPlaces, pointsOfLowerRankStay) {
	Points points{{0, 0, 0}, {1, 0, 0}};
	EXPECT_EQ(joinNearPlaces({{0, 0, 0}}, {1, 0}, 1, points), 1U);
	EXPECT_EQ(points, (Points{{1, 0, 0}, {1, 0, 0}}));
}

TEST(NearPlaces, cellsAroundZeroAndLargeNumbersAreLikeOthers) {
	for (const double at : {0., -4., 0x1p52, -0x1p52}) {
		Points points{{at, at, at}, {at - 1, at, at}};
		EXPECT_EQ(joinNearPlaces({{at, at, at}}, ranks(points), 1, points), 1U) << at;
		EXPECT_EQ(points[0], points[1]) << at;
	}
}

// In any order of the points: points in one place stay in one place, none moves farther than the
// reach, those that stay are not near each other.
TEST(NearPlaces, keepsItsPromisesOnRandomPoints) {
	std::mt19937 random(3);
	std::uniform_int_distribution<int> number(0, 30);
	for (int round = 0; round < 200; ++round) {
		Points before;
		std::vector<std::uint8_t> rank;
		for (int i = 0; i < 200; ++i) {
			before.push_back(
			    {static_cast<double>(number(random)), static_cast<double>(number(random)), 0});
			rank.push_back(static_cast<std::uint8_t>(number(random) % 2));
		}
		std::map<Point, std::uint8_t> lowest;  // points in one place have one rank
		for (std::size_t i = 0; i < before.size(); ++i) {
			lowest.emplace(before[i], rank[i]);
		}
		for (std::size_t i = 0; i < before.size(); ++i) {
			rank[i] = lowest[before[i]];
		}
		const double reach = 1 << (round % 3);
		const Points places(before.begin(), before.begin() + 20);
		Points after = before;
		joinNearPlaces(places, rank, reach, after);
		std::map<Point, Point> image;
		for (std::size_t i = 0; i < before.size(); ++i) {
			EXPECT_EQ(image.emplace(before[i], after[i]).first->second, after[i]);
			for (std::size_t axis = 0; axis < 3; ++axis) {
				EXPECT_LE(std::fabs(before[i][axis] - after[i][axis]), reach);
			}
		}
		std::vector<std::size_t> order(before.size());
		std::iota(order.begin(), order.end(), 0U);
		std::shuffle(order.begin(), order.end(), random);
		Points shuffled;
		std::vector<std::uint8_t> shuffledRank;
		for (const std::size_t i : order) {
			shuffled.push_back(before[i]);
			shuffledRank.push_back(rank[i]);
		}
		joinNearPlaces(places, shuffledRank, reach, shuffled);
		for (std::size_t i = 0; i < order.size(); ++i) {
			EXPECT_EQ(shuffled[i], after[order[i]]) << "seed 3, round " << round;
		}
	}
}

}  // namespace
}  // namespace index_boolean
