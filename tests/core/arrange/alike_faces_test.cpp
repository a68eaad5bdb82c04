// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which faces of a layer are turned, where neighbours run against each other: told by what the
// layer encloses then, in any numbering.
#include "core/any_operands.h"

#include <vcg_ext/arrange/operands.h>

#include <gtest/gtest.h>

namespace index_boolean {
namespace {

using namespace shapes;

const std::vector<std::array<bool, 2>> kHalves{{false, true}, {true, false}};

// An octahedron; each of its upper faces is three around a point that does not lie in its middle,
// so that sums of areas that are equal are rounded otherwise than those of the lower faces. Both
// areas are 4 * 8 sqrt(3).
Mesh octahedron(std::array<bool, 2> turnedHalves) {
	std::vector<Corners> faces;
	const auto add = [&](const Corners& t, bool turn) {
		faces.push_back(turn ? shapes::turned(t) : t);
	};
	const std::array<PlanePoint, 4> rim{{{4, 0}, {0, 4}, {-4, 0}, {0, -4}}};
	for (std::size_t i = 0; i < 4; ++i) {
		const Point a{rim[i][0], rim[i][1], 0}, b{rim[(i + 1) % 4][0], rim[(i + 1) % 4][1], 0};
		const Point top{0, 0, 4}, low{0, 0, -4};
		Point inside{};
		for (std::size_t k = 0; k < 3; ++k) {
			inside[k] = (9 * a[k] + 4 * b[k] + 3 * top[k]) / 16;
		}
		for (const Corners& t : {Corners{a, b, inside}, {b, top, inside}, {top, a, inside}}) {
			add(t, turnedHalves[0]);
		}
		add({b, a, low}, turnedHalves[1]);
	}
	return welded(faces);
}

TEST(AlikeFaces, ofTwoHalvesTheOneIsTurnedThatMakesTheVolumePositive) {
	std::mt19937 random(1);
	for (const auto& halves : kHalves) {
		for (int n = 0; n < 40; ++n) {
			const CellsRun r = runCells({permuted(octahedron(halves), random)});
			ASSERT_TRUE(r.status.ok());
			ASSERT_EQ(r.cells().size(), 1U);
			EXPECT_EQ(r.cells()[0].first, std::vector<std::int32_t>{1});
			EXPECT_NEAR(r.cells()[0].second, 4 * 64 / 3., 1e-12);
			EXPECT_EQ(r.arrangement.turnedAlike[kFirst], halves[0] ? 12U : 4U);
		}
	}
}

TEST(AlikeFaces, whatHasMoreAreaStays) {
	std::mt19937 random(2);
	const Mesh whole = turned(octahedron({false, false}));
	Mesh mesh = whole;  // inside out; a lower face looks outward
	for (IndexTriangle& t : mesh.triangles) {
		if (mesh.points[t[0]][2] + mesh.points[t[1]][2] + mesh.points[t[2]][2] < 0) {
			std::swap(t[1], t[2]);
			break;
		}
	}
	const CellsRun r = runCells({layer({permuted(mesh, random), box({8, 8, 8}, {9, 9, 9})})});
	ASSERT_EQ(r.cells().size(), 2U);  // else all of it would be turned
	EXPECT_EQ(r.cells()[0].first, std::vector<std::int32_t>{-1});
	EXPECT_EQ(r.arrangement.turnedAlike[kFirst], 1U);
}

// One of the tube's lobes is inside out whatever is turned: neither way encloses more.
TEST(AlikeFaces, ofWhatEnclosesNothingAlwaysTheSameIsTurned) {
	std::mt19937 random(3);
	const Mesh tube = figureEightTube();
	const auto isFirstHalf = [](std::size_t face) {  // of as much area as the others
		return face < 4 || face >= 10;
	};
	std::set<std::vector<std::pair<std::vector<std::int32_t>, std::array<double, 2>>>> results;
	for (const bool turnsFirst : {false, true}) {
		Mesh mesh = tube;
		for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
			if (isFirstHalf(f) == turnsFirst) {
				std::swap(mesh.triangles[f][1], mesh.triangles[f][2]);
			}
		}
		for (int n = 0; n < 20; ++n) {
			const CellsRun r = runCells({permuted(mesh, random)});
			ASSERT_EQ(r.cells().size(), 2U);
			const Block right = blockOf(r, atLeast(1));
			const auto [low, high] = std::minmax_element(right.points.begin(), right.points.end());
			results.insert({{r.cells()[1].first, {(*low)[0], (*high)[0]}}});
		}
	}
	EXPECT_EQ(results.size(), 1U);
}

// Two copies of a box on an edge of which a vertex hangs: the edge has two faces, which run alike,
// but all is right as it is.
TEST(AlikeFaces, copiesThatVerticesHangOnStayAsTheyAre) {
	const Mesh one = boxWithHangingVertex({1, 0, 2});
	const CellsRun r = runCells({layer({one, one})});
	ASSERT_TRUE(r.status.ok());
	EXPECT_TRUE(r.arrangement.closed[kFirst]);
	EXPECT_EQ(r.arrangement.turnedAlike[kFirst], 0U);
	ASSERT_EQ(r.cells().size(), 1U);
	EXPECT_EQ(r.cells()[0].first, std::vector<std::int32_t>{2});
	EXPECT_EQ(r.cells()[0].second, 8);
}

// The same, where turning some faces would give another closed surface.
TEST(AlikeFaces, whatIsClosedAsCutIsNotTurned) {
	Mesh one;
	one.points = {{0, 0, 0}, {0, 8, 0}, {8, 8, 0}, {8, 0, 0}, {0, 0, 8},
	              {8, 0, 8}, {8, 8, 8}, {8, 8, 0}, {8, 4, 4}, {4, 4, 8}};
	one.triangles = {{0, 1, 2}, {2, 3, 0}, {4, 5, 6}, {4, 9, 7}, {0, 3, 4}, {2, 6, 5},
	                 {2, 1, 7}, {2, 7, 6}, {1, 0, 4}, {1, 4, 7}, {3, 2, 4}, {2, 8, 4},
	                 {3, 1, 4}, {3, 4, 1}, {8, 5, 4}, {9, 6, 7}};
	const auto single = runCells({one}).cells();
	const CellsRun r = runCells({layer({one, one})});
	EXPECT_EQ(r.arrangement.turnedAlike[kFirst], 0U);
	const auto twice = r.cells();
	ASSERT_EQ(twice.size(), single.size());
	for (std::size_t cell = 0; cell < single.size(); ++cell) {
		EXPECT_EQ(twice[cell].first[0], 2 * single[cell].first[0]);
		EXPECT_DOUBLE_EQ(twice[cell].second, single[cell].second);
	}
}

}  // namespace
}  // namespace index_boolean
