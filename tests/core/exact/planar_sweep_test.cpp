// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The sweep on integer grids, where orientation is exact in 64 bits: random non-crossing edges
// with holes, dangling ends, isolated points and collinear runs.
#include "core/exact/planar_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>

namespace index_boolean {
namespace {

bool cross(GridPoint a, GridPoint b, GridPoint c, GridPoint d) {
	const auto sign = [](std::int64_t v) { return (v > 0) - (v < 0); };
	return sign(area(a, b, c)) * sign(area(a, b, d)) < 0 &&
	       sign(area(c, d, a)) * sign(area(c, d, b)) < 0;
}

// A triangle with random points on its border and inside it, and random edges that neither cross
// nor run through a point.
struct Problem {
	std::vector<GridPoint> points;
	std::vector<PlanarEdge> edges;
	std::size_t borderPoints = 0;
	std::int64_t twiceArea = 0;
};

bool triangulate(const Problem& problem, const PlanarOrientation& orientation, Monitor& monitor,
                 std::vector<std::array<std::uint32_t, 3>>& triangles) {
	const auto count = static_cast<std::uint32_t>(problem.points.size());
	return PlanarSweep().triangulate(count, problem.edges, orientation, monitor, triangles);
}

Problem randomProblem(std::mt19937& random, std::size_t inner, std::size_t tries) {
	constexpr std::int64_t kSize = 48;
	const std::array<GridPoint, 3> corners{{{0, 0}, {kSize, 0}, {kSize / 2, kSize}}};
	std::set<GridPoint> border(corners.begin(), corners.end());
	std::uniform_int_distribution<std::int64_t> coordinate(0, kSize);
	for (int i = 0; i < 4; ++i) {
		border.insert({coordinate(random), 0});
		const std::int64_t t = coordinate(random) / 2;
		border.insert({t, 2 * t});
	}
	std::set<GridPoint> all = border;
	for (std::size_t i = 0; i < inner; ++i) {
		const GridPoint p{coordinate(random), coordinate(random)};
		if (area(corners[0], corners[1], p) > 0 && area(corners[1], corners[2], p) > 0 &&
		    area(corners[2], corners[0], p) > 0) {
			all.insert(p);
		}
	}
	Problem problem;
	problem.points.assign(all.begin(), all.end());
	problem.borderPoints = border.size();
	problem.twiceArea = area(corners[0], corners[1], corners[2]);
	const auto& points = problem.points;
	const auto n = static_cast<std::uint32_t>(points.size());
	for (std::size_t side = 0; side < 3; ++side) {
		std::vector<std::uint32_t> run;
		for (std::uint32_t p = 0; p < n; ++p) {
			if (onSegment(points[p], corners[side], corners[(side + 1) % 3])) {
				run.push_back(p);
			}
		}
		for (std::size_t i = 0; i + 1 < run.size(); ++i) {
			problem.edges.push_back({run[i], run[i + 1]});
		}
	}
	std::uniform_int_distribution<std::uint32_t> pick(0, n - 1);
	for (std::size_t i = 0; i < tries; ++i) {
		std::uint32_t a = pick(random), b = pick(random);
		if (a == b) {
			continue;
		}
		const PlanarEdge edge{std::min(a, b), std::max(a, b)};
		bool free = true;
		for (std::uint32_t p = 0; p < n && free; ++p) {
			free = p == a || p == b || !onSegment(points[p], points[a], points[b]);
		}
		for (const PlanarEdge& e : problem.edges) {
			free = free && !(e.left == edge.left && e.right == edge.right) &&
			       !cross(points[a], points[b], points[e.left], points[e.right]);
		}
		if (free) {
			problem.edges.push_back(edge);
		}
	}
	std::shuffle(problem.edges.begin(), problem.edges.end(), random);
	return problem;
}

void expectTriangulates(const Problem& problem) {
	const GridOrientation orientation(problem.points);
	std::vector<std::array<std::uint32_t, 3>> triangles;
	Monitor monitor;
	ASSERT_TRUE(triangulate(problem, orientation, monitor, triangles));
	EXPECT_EQ(triangles.size(), 2 * problem.points.size() - problem.borderPoints - 2);
	std::int64_t sum = 0;
	std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
	for (const auto& t : triangles) {
		const std::int64_t twice =
		    area(problem.points[t[0]], problem.points[t[1]], problem.points[t[2]]);
		EXPECT_GT(twice, 0);
		sum += twice;
		for (std::size_t i = 0; i < 3; ++i) {
			++sides[{std::min(t[i], t[(i + 1) % 3]), std::max(t[i], t[(i + 1) % 3])}];
		}
	}
	EXPECT_EQ(sum, problem.twiceArea);  // with positive areas and no overlap of edges: a partition
	for (const PlanarEdge& e : problem.edges) {
		EXPECT_GE((sides[{e.left, e.right}]), 1);
	}
}

TEST(PlanarSweep, coversRandomPlanarGraphsExactly) {
	for (std::uint32_t seed = 0; seed < 3000; ++seed) {
		SCOPED_TRACE("seed " + std::to_string(seed));
		std::mt19937 random(seed);
		const Problem problem = randomProblem(random, seed % 40, seed % 120);
		expectTriangulates(problem);
		if (HasFailure()) {
			return;
		}
	}
}

TEST(PlanarSweep, keepsLoopsInsideLoopsAndIsolatedPoints) {
	Problem problem;
	const std::vector<GridPoint> border{{0, 0}, {50, 0}, {50, 100}};
	const std::vector<GridPoint> outer{{10, 5}, {40, 70}, {45, 10}};
	const std::vector<GridPoint> inner{{28, 20}, {38, 20}, {36, 40}};
	const GridPoint isolated{35, 25};
	for (const auto* loop : {&border, &outer, &inner}) {
		problem.points.insert(problem.points.end(), loop->begin(), loop->end());
	}
	problem.points.push_back(isolated);
	std::sort(problem.points.begin(), problem.points.end());
	const auto rank = [&problem](GridPoint p) {
		const auto it = std::lower_bound(problem.points.begin(), problem.points.end(), p);
		return static_cast<std::uint32_t>(it - problem.points.begin());
	};
	for (const auto* loop : {&border, &outer, &inner}) {
		for (std::size_t i = 0; i < 3; ++i) {
			const std::uint32_t p = rank((*loop)[i]), q = rank((*loop)[(i + 1) % 3]);
			problem.edges.push_back({std::min(p, q), std::max(p, q)});
		}
	}
	problem.borderPoints = 3;
	problem.twiceArea = 5000;
	expectTriangulates(problem);
}

TEST(PlanarSweep, answersFalseToCrossingOrOpenBorders) {
	const std::vector<GridPoint> points{{0, 0}, {4, 8}, {8, 0}, {9, 9}};
	const GridOrientation orientation(points);
	std::vector<std::array<std::uint32_t, 3>> triangles;
	Monitor monitor;
	PlanarSweep sweep;
	EXPECT_FALSE(sweep.triangulate(3, {{0, 1}, {0, 2}}, orientation, monitor, triangles));
	EXPECT_FALSE(sweep.triangulate(4, {{0, 1}, {1, 2}, {0, 2}}, orientation, monitor, triangles));
	EXPECT_TRUE(sweep.triangulate(3, {{0, 1}, {0, 2}, {1, 2}}, orientation, monitor, triangles))
	    << "what is left of a failure does no harm";
	EXPECT_EQ(triangles.size(), 1u);
}

// A star of n edges at one point, and a comb of n parallel edges.
Problem comb(std::int64_t n) {
	Problem problem;
	problem.points = {{0, 0}, {4 * n, 0}, {0, 8 * n}};
	for (std::int64_t i = 1; i <= n; ++i) {
		problem.points.push_back({1, 2 * i});
		problem.points.push_back({3, 2 * i});
	}
	std::sort(problem.points.begin(), problem.points.end());
	const auto rank = [&problem](std::int64_t x, std::int64_t y) {
		const auto it =
		    std::lower_bound(problem.points.begin(), problem.points.end(), GridPoint{x, y});
		return static_cast<std::uint32_t>(it - problem.points.begin());
	};
	problem.edges = {{rank(0, 0), rank(0, 8 * n)},
	                 {rank(0, 0), rank(4 * n, 0)},
	                 {rank(0, 8 * n), rank(4 * n, 0)}};
	for (std::int64_t i = 1; i <= n; ++i) {
		problem.edges.push_back({rank(1, 2 * i), rank(3, 2 * i)});
	}
	problem.borderPoints = 3;
	problem.twiceArea = 32 * n * n;
	return problem;
}

TEST(PlanarSweep, asksForOrientationsInProportionToNLogN) {
	for (const std::int64_t n : {1000, 10000}) {
		const Problem problem = comb(n);
		expectTriangulates(problem);
		const GridOrientation orientation(problem.points);
		std::vector<std::array<std::uint32_t, 3>> triangles;
		Monitor monitor;
		ASSERT_TRUE(triangulate(problem, orientation, monitor, triangles));
		EXPECT_LT(orientation.calls, static_cast<std::size_t>(100 * n));
	}
}

TEST(PlanarSweep, stopsWithinAPolygonWhenTheRunIsCancelled) {
	const Problem problem = comb(20000);
	const GridOrientation orientation(problem.points);
	std::vector<std::array<std::uint32_t, 3>> triangles;
	Monitor monitor([](double, const char*) { return false; });
	EXPECT_FALSE(triangulate(problem, orientation, monitor, triangles));
	EXPECT_TRUE(monitor.cancelled());
	EXPECT_LT(triangles.size(), 20000u) << "a polygon of 40000 points";
}

}  // namespace
}  // namespace index_boolean
