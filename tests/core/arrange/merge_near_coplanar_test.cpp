// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Walls of many faces that nearly lie in one plane become one polygon, and what must not go stays.
#include "core/near_coplanar.h"
#include "core/wrong_faces.h"

#include <vcg_ext/arrange/merge_near_coplanar.h>
#include <vcg_ext/exact/exact_sign.h>

#include <gtest/gtest.h>

#include <set>

namespace index_boolean {
namespace {

using namespace shapes;

struct Merged {
	IndexTriangles triangles;
	NearCoplanarMerge merge;
};

Merged merged(const Mesh& m, double tolerance, std::vector<std::uint32_t> classes = {},
              const std::vector<std::uint32_t>& wrong = {}) {
	classes.resize(m.triangles.size(), 0);
	Merged result;
	Monitor monitor;
	const Status status = mergeNearCoplanar({m.points, m.triangles, classes, wrong, tolerance, 0},
	                                        monitor, result.merge);
	EXPECT_TRUE(status.ok()) << describe(status);
	result.triangles = result.merge.any() ? result.merge.triangles : m.triangles;
	return result;
}

// What is promised of any surface.
void expectSound(const Mesh& before, const Merged& after, double tolerance) {
	EXPECT_TRUE(isClosed(after.triangles));
	EXPECT_EQ(isManifold(after.triangles), isManifold(before.triangles));
	EXPECT_EQ(eulerNumber(after.triangles), eulerNumber(before.triangles));
	EXPECT_LE(faultsOf(before.points, after.triangles), faultsOf(before.points, before.triangles));
	EXPECT_LE(after.merge.largestMove, tolerance);
	EXPECT_LE(greatestDistance(before.points, before.triangles, before.points, after.triangles),
	          tolerance);
	EXPECT_LE(greatestDistance(before.points, after.triangles, before.points, before.triangles),
	          tolerance);
}

std::vector<std::array<Point, 3>> geometryOf(const Mesh& m, const IndexTriangles& triangles) {
	Block block;
	block.points = m.points;
	block.triangles = triangles;
	return geometry(block);
}

}  // namespace

TEST(MergeNearCoplanar, aShakenCubeHasTwelveFacesAgain) {
	for (const unsigned seed : {1U, 2U, 3U, 4U}) {
		std::mt19937 random(seed);
		const double noise = std::array{1e-13, 1e-9, 1e-4, 1e-3}[seed - 1];
		const Mesh cube = placed(shaken(squaredCube(5, random), noise, random), random, 1);
		const Merged result = merged(cube, 12 * noise);
		EXPECT_EQ(result.triangles.size(), 12U);
		EXPECT_GT(result.merge.largestMove, 0);
		expectSound(cube, result, 12 * noise);
	}
}

TEST(MergeNearCoplanar, whatIsBeyondTheToleranceStays) {
	std::mt19937 random(5);
	const Mesh cube = shaken(squaredCube(4, random), 1e-3, random);
	const Merged result = merged(cube, 1e-5);
	EXPECT_FALSE(result.merge.any());
	for (const double tolerance : {2e-4, 1e-3, 3e-3}) {
		expectSound(cube, merged(cube, tolerance), tolerance);
	}
}

TEST(MergeNearCoplanar, isTheSameInAnyNumbering) {
	std::mt19937 random(6);
	for (const double noise : {1e-12, 1e-3}) {
		const Mesh cube = placed(shaken(squaredCube(4, random), noise, random), random, 1);
		const auto expected = geometryOf(cube, merged(cube, 2 * noise).triangles);
		for (int i = 0; i < 5; ++i) {
			const Mesh other = permuted(cube, random);
			EXPECT_EQ(geometryOf(other, merged(other, 2 * noise).triangles), expected);
		}
	}
}

// A ball with edges of 0.05 has a sagitta of 3e-4.
TEST(MergeNearCoplanar, aBallStaysBelowItsSagittaAndHoldsAboveIt) {
	const Mesh ball = sphere(60, {0.1, 0.2, 0.3}, 1);
	EXPECT_FALSE(merged(ball, 1e-7).merge.any());
	const Mesh small = sphere(10, {0.1, 0.2, 0.3}, 1);
	for (const double tolerance : {0.04, 0.1, 0.5}) {
		const Merged result = merged(small, tolerance);
		EXPECT_TRUE(result.merge.any());
		expectSound(small, result, tolerance);
	}
}

TEST(MergeNearCoplanar, classesKeepTheirBorders) {
	std::mt19937 random(8);
	const Mesh cube = shaken(squaredCube(4, random), 1e-12, random);
	const std::vector<std::uint32_t> classes = classesByHalf(cube, 0, 3, 8);
	const Merged result = merged(cube, 1e-11, classes);
	EXPECT_EQ(result.triangles.size(), 20U);  // two boxes without the wall between
	std::array<double, 2> area{};
	for (std::size_t f = 0; f < result.triangles.size(); ++f) {
		const IndexTriangle& t = result.triangles[f];
		const RoundedNormal n(cube.points[t[0]], cube.points[t[1]], cube.points[t[2]]);
		area[classes[result.merge.origin[f]] == 3 ? 0 : 1] +=
		    std::hypot(n.value[0], n.value[1], n.value[2]) / 2;
	}
	EXPECT_NEAR(area[0], 3, 1e-10);
	EXPECT_NEAR(area[1], 3, 1e-10);
}

// Two walls at a step much lower than the tolerance are one, and the step goes.
TEST(MergeNearCoplanar, aStepBetweenTwoWallsGoes) {
	Mesh m;
	const double step = 1e-14;
	for (const double y : {0.0, 1.0}) {
		for (const Point& p : {Point{0, y, 0},
		                       {2, y, 0},
		                       {2, y, 1 + step},
		                       {1, y, 1 + step},
		                       {1, y, 1},
		                       {0, y, 1}}) {
			m.points.push_back(p);
		}
	}
	for (const auto& [a, b, c] :
	     std::vector<std::array<std::uint32_t, 3>>{{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {4, 5, 0}}) {
		m.triangles.push_back({a, b, c});
		m.triangles.push_back({6 + a, 6 + c, 6 + b});
	}
	for (std::uint32_t i = 0; i < 6; ++i) {
		const std::uint32_t j = (i + 1) % 6;
		m.triangles.push_back({i, 6 + i, 6 + j});
		m.triangles.push_back({i, 6 + j, j});
	}
	ASSERT_TRUE(isClosed(m.triangles) && faultsOf(m.points, m.triangles) == 0);
	const Merged result = merged(m, 1e-12);
	EXPECT_EQ(result.triangles.size(), 12U);
	expectSound(m, result, 1e-12);
}

// A lid with a dent, into which the tip of something else reaches: without the dent they would
// cross.
TEST(MergeNearCoplanar, aRemovalThatWouldMakeFacesCrossIsUndone) {
	std::mt19937 random(9);
	Mesh lid = squaredCube(4, random);
	for (Point& p : lid.points) {
		if (p == Point{0.5, 0.5, 1}) {
			p[2] = 1 - 1e-3;
		}
	}
	EXPECT_EQ(merged(lid, 0.01).triangles.size(), 12U);
	Mesh tip;
	tip.points = {{0.5, 0.5, 1 - 5e-4}, {0.4, 0.4, 2}, {0.6, 0.4, 2}, {0.5, 0.6, 2}};
	tip.triangles = {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}};
	const Mesh both = joined(lid, tip);
	ASSERT_EQ(faultsOf(both.points, both.triangles), 0U);
	const Merged result = merged(both, 0.01);
	EXPECT_TRUE(result.merge.any());
	expectSound(both, result, 0.01);
	const auto dent = std::find(both.points.begin(), both.points.end(), Point{0.5, 0.5, 1 - 1e-3});
	EXPECT_EQ(std::count(result.merge.gone.begin(), result.merge.gone.end(),
	                     static_cast<std::uint32_t>(dent - both.points.begin())),
	          0);
}

// The faces of a wall that meets others wrongly already stay as they are.
TEST(MergeNearCoplanar, wallsOfWrongFacesStay) {
	std::mt19937 random(10);
	const Mesh cube = squaredCube(3, random);
	const Merged result = merged(cube, 1e-6, {}, {0});
	EXPECT_TRUE(result.merge.any());
	const std::set<std::uint32_t> gone(result.merge.gone.begin(), result.merge.gone.end());
	for (std::size_t f = 0; f < 18; ++f) {
		for (const std::uint32_t v : cube.triangles[f]) {
			EXPECT_EQ(gone.count(v), 0U);
		}
	}
	EXPECT_EQ(result.merge.origin[0], 0U);
}

TEST(MergeNearCoplanar, copiesInOnePlaceStay) {
	std::mt19937 random(11);
	Mesh other = squaredCube(2, random);
	for (Point& p : other.points) {
		p[0] += 1;
		p[1] += 0.5;
		p[2] += 1;
	}
	const Mesh both = joined(squaredCube(2, random), other);  // they touch along half an edge
	const Merged result = merged(both, 1e-9);
	EXPECT_EQ(result.triangles.size(), 28U);  // each has a copy of the other's end on its edge
	expectSound(both, result, 1e-9);
}

TEST(MergeNearCoplanar, thinAndSmallPartsStayWhole) {
	std::mt19937 random(12);
	Mesh plate = squaredCube(4, random);
	for (Point& p : plate.points) {
		p[2] *= 1e-3;
	}
	for (const double tolerance : {1e-4, 1e-3, 1e-2, 0.1, 2.0}) {
		const Merged result = merged(plate, tolerance);
		EXPECT_GE(result.triangles.size(), 4U);
		expectSound(plate, result, tolerance);
	}
	const Mesh ring = torus(16, 8, 1, 0.3);
	for (const double tolerance : {1e-3, 0.05, 0.3}) {
		expectSound(ring, merged(ring, tolerance), tolerance);
	}
}

TEST(MergeNearCoplanar, coordinatesOfAnyMagnitudeAreNoDanger) {
	std::mt19937 random(13);
	for (const double size : {1e-300, 1e-160, 1e-80, 1e80, 1e160, 1e300}) {
		Mesh cube = squaredCube(3, random);
		for (Point& p : cube.points) {
			for (double& c : p) {
				c *= size;
			}
		}
		const Merged result = merged(cube, size * 1e-9);
		EXPECT_TRUE(isClosed(result.triangles));
		EXPECT_EQ(faultsOf(cube.points, result.triangles), 0U);
	}
}

TEST(MergeNearCoplanar, aCancelledRunSaysSo) {
	std::mt19937 random(14);
	const Mesh cube = squaredCube(30, random);
	const std::vector<std::uint32_t> classes(cube.triangles.size(), 0);
	Monitor monitor([](double, const char*) { return false; });
	NearCoplanarMerge merge;
	EXPECT_EQ(
	    mergeNearCoplanar({cube.points, cube.triangles, classes, {}, 1e-6, 0}, monitor, merge).code,
	    StatusCode::Cancelled);
}

}  // namespace index_boolean
