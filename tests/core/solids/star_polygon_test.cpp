// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A polygon that is seen whole from one point is filled: with its own area, and with the cuts that
// are allowed only.
#include <vcg_ext/solids/star_polygon.h>

#include <gtest/gtest.h>

#include <random>

namespace index_boolean {
namespace {

// A star on a grid around a point of it, corners in the order of their angles.
std::vector<Point> randomStar(std::mt19937& random, std::size_t most) {
	std::vector<Point> corners;
	while (corners.size() < most) {
		const Point p{static_cast<double>(random() % 21) - 10,
		              static_cast<double>(random() % 21) - 10, 0};
		if (p[0] != 0 || p[1] != 0) {
			corners.push_back(p);
		}
	}
	const auto angle = [](const Point& p) { return std::atan2(p[1], p[0]); };
	const auto before = [&](const Point& a, const Point& b) { return angle(a) < angle(b); };
	std::sort(corners.begin(), corners.end(), before);
	corners.erase(std::unique(corners.begin(), corners.end(),
	                          [&](const Point& a, const Point& b) { return angle(a) == angle(b); }),
	              corners.end());
	return corners;
}

double areaOf(const Point& a, const Point& b, const Point& c) {
	return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

bool seesAll(const std::vector<Point>& corners) {
	for (std::size_t i = 0; i < corners.size(); ++i) {
		if (areaOf({0, 0, 0}, corners[i], corners[(i + 1) % corners.size()]) <= 0) {
			return false;
		}
	}
	return corners.size() > 2;
}

StarPolygon polygonOf(const std::vector<Point>& corners) {
	StarPolygon polygon{{}, ExactPoint::explicitPoint({0, 0, 0}), 2, 1};
	for (const Point& p : corners) {
		polygon.corners.push_back(ExactPoint::explicitPoint(p));
	}
	return polygon;
}

TEST(StarPolygon, isFilledWithItsOwnArea) {
	std::mt19937 random(1);
	std::size_t filled = 0;
	for (int i = 0; i < 2000; ++i) {
		std::vector<Point> corners = randomStar(random, 3 + random() % 12);
		if (!seesAll(corners)) {
			continue;
		}
		double area = 0;
		for (std::size_t k = 0; k < corners.size(); ++k) {
			area += areaOf({0, 0, 0}, corners[k], corners[(k + 1) % corners.size()]);
		}
		std::vector<std::array<std::size_t, 3>> triangles;
		ASSERT_TRUE(fillStar(
		    polygonOf(corners), [](std::size_t, std::size_t) { return true; }, triangles));
		EXPECT_EQ(triangles.size(), corners.size() - 2);
		for (const auto& [a, b, c] : triangles) {
			EXPECT_GT(areaOf(corners[a], corners[b], corners[c]), 0);
			area -= areaOf(corners[a], corners[b], corners[c]);
		}
		EXPECT_EQ(area, 0);
		++filled;
	}
	EXPECT_GT(filled, 500u);
}

TEST(StarPolygon, isNotFilledAcrossForbiddenCuts) {
	const std::vector<Point> square{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
	std::vector<std::array<std::size_t, 3>> triangles;
	EXPECT_FALSE(fillStar(
	    polygonOf(square), [](std::size_t, std::size_t) { return false; }, triangles));
}

// Half a star: the centre lies on the edge from the last corner to the first, which stays.
TEST(StarPolygon, keepsTheEdgeThatItsCentreLiesOn) {
	const std::vector<Point> half{{2, 0, 0}, {2, 2, 0}, {0, 3, 0}, {-2, 2, 0}, {-2, 0, 0}};
	std::vector<std::array<std::size_t, 3>> triangles;
	ASSERT_TRUE(fillStar(
	    polygonOf(half), [](std::size_t, std::size_t) { return true; }, triangles));
	double area = 0;
	for (const auto& [a, b, c] : triangles) {
		EXPECT_GT(areaOf(half[a], half[b], half[c]), 0);
		area += areaOf(half[a], half[b], half[c]);
	}
	EXPECT_EQ(area, 20);
}

}  // namespace
}  // namespace index_boolean
