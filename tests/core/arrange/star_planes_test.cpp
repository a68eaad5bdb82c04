// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Faces that planes part meet properly by exact signs, whatever the star; in stars as surfaces have
// them, and where two surfaces cross, few pairs are left to those.
#include <vcg_ext/arrange/parted_faces.h>
#include <vcg_ext/arrange/star_planes.h>
#include <vcg_ext/exact/zero_area.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace index_boolean {
namespace {

// Faces at point 0.
struct StarMesh {
	Points points;
	IndexTriangles triangles;

	FacesView view() const { return {points, triangles.data(), triangles.size()}; }
};

struct Counts {
	std::size_t parted = 0, proper = 0, pairs = 0;
};

// Asks for all pairs, and the exact signs for each.
Counts askAll(const StarMesh& star) {
	Counts counts;
	StarPlanes planes;
	std::vector<std::uint32_t> faces;
	for (std::uint32_t f = 0; f < star.triangles.size(); ++f) {
		faces.push_back(f);
	}
	const bool isTaken = planes.take(star.view(), 0, faces);
	for (std::uint32_t i = 0; i < faces.size(); ++i) {
		for (std::uint32_t j = i + 1; j < faces.size(); ++j) {
			const bool isProper = meetingOf(star.view(), {{i}, {j}}) == Meeting::Proper;
			const bool isParted = isTaken && planes.areParted(i, j);
			EXPECT_TRUE(isProper || !isParted) << "faces " << i << " and " << j;
			counts.parted += isParted ? 1 : 0;
			counts.proper += isProper ? 1 : 0;
			++counts.pairs;
		}
	}
	return counts;
}

// Faces on points of a grid of 4 x 4 x 4 around one of them, times a power of two, moved by a bit
// here and there.
StarMesh randomStar(std::mt19937& random, int exponent, bool isMoved) {
	StarMesh star;
	const auto below = [&random](unsigned n) { return static_cast<int>(random() % n); };
	const std::size_t pointCount = 6 + random() % 6;
	star.points.push_back({std::ldexp(1, exponent), std::ldexp(1, exponent), 0});
	while (star.points.size() < pointCount) {
		Point p{};
		for (double& x : p) {
			x = std::ldexp(below(4), exponent);
			x = isMoved && below(3) == 0 ? std::nextafter(x, below(2) == 0 ? -HUGE_VAL : HUGE_VAL)
			                             : x;
		}
		if (std::find(star.points.begin(), star.points.end(), p) == star.points.end()) {
			star.points.push_back(p);
		}
	}
	for (int i = 0; i < 12; ++i) {
		const auto a = static_cast<std::uint32_t>(1 + random() % (pointCount - 1));
		const auto b = static_cast<std::uint32_t>(1 + random() % (pointCount - 1));
		if (a != b && !hasZeroArea(star.points[0], star.points[a], star.points[b])) {
			star.triangles.push_back({0, a, b});
		}
	}
	return star;
}

TEST(StarPlanes, partOnlyWhatMeetsProperly) {
	std::mt19937 random(20261129);
	Counts all;
	for (int i = 0; i < 3000; ++i) {
		SCOPED_TRACE(i);
		const int exponent = std::array{0, -190, 190, -1060, 1000}[i % 5];
		const Counts counts = askAll(randomStar(random, exponent, i % 2 == 0));
		all.parted += i % 5 == 0 ? counts.parted : 0;
		all.proper += i % 5 == 0 ? counts.proper : 0;
	}
	EXPECT_GT(all.proper, 10000U);
	EXPECT_GT(10 * all.parted, 8 * all.proper);
}

// A fan around point 0, closed.
void addRing(StarMesh& star, std::size_t count, const Point& x, const Point& y) {
	const auto first = static_cast<std::uint32_t>(star.points.size());
	const auto n = static_cast<std::uint32_t>(count);
	for (std::uint32_t i = 0; i < n; ++i) {
		const double angle = 2 * 3.14159265358979323846 * i / n;
		Point p = star.points[0];
		for (std::size_t k = 0; k < 3; ++k) {
			p[k] += std::cos(angle) * x[k] + std::sin(angle) * y[k];
		}
		star.points.push_back(p);
	}
	for (std::uint32_t i = 0; i < n; ++i) {
		star.triangles.push_back({0, first + i, first + (i + 1) % n});
	}
}

TEST(StarPlanes, partAllFacesOfAFlatFanAndOfAConeAndOfTwoThatTouchAtTheTip) {
	for (const std::size_t n : {5U, 6U, 13U}) {
		StarMesh flat;
		flat.points.push_back({0.1, 0.2, 0.3});
		addRing(flat, n, {1, 0.3, 0.2}, {-0.1, 0.7, 0.4});
		const Counts counts = askAll(flat);
		EXPECT_EQ(counts.parted, counts.pairs) << n;
	}
	StarMesh cones;
	cones.points.push_back({0, 0, 0});
	addRing(cones, 7, {1, 0, 0}, {0, 1, 0});
	addRing(cones, 7, {1, 0, 0}, {0, 1, 0});
	for (std::size_t i = 1; i < cones.points.size(); ++i) {
		cones.points[i][2] = i <= 7 ? 2 : -2;
	}
	const Counts counts = askAll(cones);
	EXPECT_EQ(counts.parted, counts.pairs);
}

// Of a point on the curve of two planes that cross: both have edges along the curve.
TEST(StarPlanes, partAllFacesAtAPointWhereTwoSurfacesCross) {
	StarMesh star;
	star.points = Points{{0, 0, 0}, {1, 0, 0}, {-1, 0.1, 0}, {0.3, 1, 0}, {0.2, -1, 0}};
	star.points.push_back({0.1, 0.1, 1});
	star.points.push_back({0.2, -0.2, -1});
	for (const std::uint32_t side : {3U, 4U, 5U, 6U}) {
		star.triangles.push_back({0, 1, side});
		star.triangles.push_back({0, side, 2});
	}
	const Counts counts = askAll(star);
	EXPECT_EQ(counts.parted, counts.pairs);
	EXPECT_EQ(counts.pairs, 28U);
}

TEST(StarPlanes, takeNoStarThatHasTooManyFaces) {
	StarMesh star;
	star.points.push_back({0, 0, 0});
	addRing(star, StarPlanes::kMostFaces + 1, {1, 0, 0}, {0, 1, 0});
	EXPECT_EQ(askAll(star).parted, 0U);
}

}  // namespace
}  // namespace index_boolean
