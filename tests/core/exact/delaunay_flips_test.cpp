// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Triangulations of points with integer coordinates, which are stored exactly: there the
// constrained Delaunay triangulation, with ties broken, is one. It does not depend on where
// flipping begins.
#include "core/exact/planar_grid.h"

#include <vcg_ext/exact/delaunay_flips.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <set>

namespace index_boolean {
namespace {

using TriangleSet = std::set<std::array<std::uint32_t, 3>>;  // corners ascending

// Points by rank, fixed edges between them, and a triangulation that has those.
struct Problem {
	std::vector<GridPoint> points;
	std::vector<PlanarEdge> fixed;
	RankTriangles triangles;

	std::vector<PlanarPlace> places() const {
		std::vector<PlanarPlace> all;
		for (const GridPoint& p : points) {
			all.push_back({static_cast<double>(p.x), static_cast<double>(p.y)});
		}
		return all;
	}
};

TriangleSet setOf(const RankTriangles& triangles) {
	TriangleSet all;
	for (auto t : triangles) {
		std::sort(t.begin(), t.end());
		all.insert(t);
	}
	return all;
}

// The edges of two triangles that are not fixed.
std::vector<FreeEdge> freeEdges(const Problem& problem) {
	std::map<std::array<std::uint32_t, 2>, std::vector<std::uint32_t>> beside;
	for (std::uint32_t t = 0; t < problem.triangles.size(); ++t) {
		for (std::size_t i = 0; i < 3; ++i) {
			const auto [a, b] =
			    std::minmax(problem.triangles[t][i], problem.triangles[t][(i + 1) % 3]);
			beside[{a, b}].push_back(t);
		}
	}
	for (const PlanarEdge& e : problem.fixed) {
		beside.erase({e.left, e.right});
	}
	std::vector<FreeEdge> edges;
	for (const auto& [ends, triangles] : beside) {
		EXPECT_EQ(triangles.size(), 2U);
		edges.push_back({{ends[0], ends[1]}, {triangles[0], triangles[1]}});
	}
	return edges;
}

// A square of size n with random points in it, and random edges that meet in ends only.
Problem makeProblem(std::mt19937& random, std::int64_t n, std::size_t pointCount,
                    std::size_t tries) {
	Problem problem;
	std::set<GridPoint> points{{0, 0}, {n, 0}, {n, n}, {0, n}};
	std::uniform_int_distribution<std::int64_t> inside(1, n - 1);
	for (std::size_t i = 0; i < pointCount; ++i) {
		const std::int64_t x = inside(random);
		points.insert({x, inside(random)});
	}
	problem.points.assign(points.begin(), points.end());
	const auto rankOf = [&](GridPoint p) {
		const auto it = std::lower_bound(problem.points.begin(), problem.points.end(), p);
		return static_cast<std::uint32_t>(it - problem.points.begin());
	};
	const std::array<GridPoint, 4> corners{GridPoint{0, 0}, {n, 0}, {n, n}, {0, n}};
	for (std::size_t i = 0; i < 4; ++i) {
		const auto [a, b] = std::minmax({rankOf(corners[i]), rankOf(corners[(i + 1) % 4])});
		problem.fixed.push_back({a, b});
	}
	std::uniform_int_distribution<std::uint32_t> any(
	    0, static_cast<std::uint32_t>(problem.points.size()) - 1);
	for (std::size_t i = 0; i < tries; ++i) {
		const auto [a, b] = std::minmax({any(random), any(random)});
		const GridPoint p = problem.points[a], q = problem.points[b];
		bool clashes = a == b;
		for (std::uint32_t c = 0; c < problem.points.size(); ++c) {
			clashes = clashes || (c != a && c != b && onSegment(problem.points[c], p, q));
		}
		for (const PlanarEdge& e : problem.fixed) {
			const GridPoint r = problem.points[e.left], s = problem.points[e.right];
			const auto side = [](std::int64_t v) { return (v > 0) - (v < 0); };
			const bool crosses = side(area(p, q, r)) * side(area(p, q, s)) < 0 &&
			                     side(area(r, s, p)) * side(area(r, s, q)) < 0;
			clashes = clashes || crosses || (e.left == a && e.right == b);
		}
		if (!clashes) {
			problem.fixed.push_back({a, b});
		}
	}
	Monitor monitor;
	EXPECT_TRUE(PlanarSweep().triangulate(static_cast<std::uint32_t>(problem.points.size()),
	                                      problem.fixed, GridOrientation(problem.points), monitor,
	                                      problem.triangles));
	return problem;
}

std::size_t flip(Problem& problem, int front = 1) {
	Monitor monitor;
	std::vector<FreeEdge> edges = freeEdges(problem);
	return DelaunayFlips().run(edges, problem.places(), front, GridOrientation(problem.points),
	                           monitor, problem.triangles);
}

// Random flips that are legal, wanted or not.
void disturb(Problem& problem, std::mt19937& random) {
	for (int i = 0; i < 300; ++i) {
		const std::vector<FreeEdge> edges = freeEdges(problem);
		if (edges.empty()) {
			return;
		}
		const FreeEdge& edge = edges[random() % edges.size()];
		auto &t = problem.triangles[edge.triangles[0]], &u = problem.triangles[edge.triangles[1]];
		const auto isEnd = [&](std::uint32_t v) {
			return v == edge.ends.left || v == edge.ends.right;
		};
		std::rotate(t.begin(), std::find_if_not(t.begin(), t.end(), isEnd), t.end());
		std::rotate(u.begin(), std::find_if_not(u.begin(), u.end(), isEnd), u.end());
		const auto at = [&](std::uint32_t v) { return problem.points[v]; };
		if (area(at(t[0]), at(t[1]), at(u[0])) > 0 && area(at(u[0]), at(t[2]), at(t[0])) > 0) {
			const std::uint32_t a = t[1], b = t[2], c = t[0], d = u[0];
			t = {a, d, c};
			u = {d, b, c};
		}
	}
}

// A problem that has been changed is flipped as often, to the same triangles.
template <class Change>
void expectSame(Change&& change, int front) {
	std::mt19937 random(21);
	for (int i = 0; i < 30; ++i) {
		SCOPED_TRACE(i);
		Problem problem = makeProblem(random, 6, 40, 20);
		Problem changed = problem;
		change(changed, random);
		EXPECT_EQ(flip(problem), flip(changed, front));
		ASSERT_EQ(setOf(problem.triangles), setOf(changed.triangles));
	}
}

void expectNothingWanted(const Problem& problem) {
	const std::vector<PlanarPlace> places = problem.places();
	for (const FreeEdge& edge : freeEdges(problem)) {
		std::array<std::uint32_t, 4> q{edge.ends.left, edge.ends.right, 0, 0};
		for (std::size_t i = 0; i < 2; ++i) {
			for (const std::uint32_t v : problem.triangles[edge.triangles[i]]) {
				q[2 + i] = v != q[0] && v != q[1] ? v : q[2 + i];
			}
		}
		const auto at = [&](std::size_t i) { return problem.points[q[i]]; };
		if (area(at(0), at(1), at(2)) < 0) {
			std::swap(q[2], q[3]);
		}
		const bool isConvex = area(at(0), at(3), at(2)) > 0 && area(at(3), at(1), at(2)) > 0;
		const int sign =
		    inCirclePerturbed({places[q[0]], places[q[1]], places[q[2]], places[q[3]]}, q);
		ASSERT_FALSE(isConvex && sign > 0);
	}
}

}  // namespace

TEST(DelaunayFlips, endWhereNoFlipIsWanted) {
	std::mt19937 random(19);
	for (int i = 0; i < 60; ++i) {
		SCOPED_TRACE(i);
		Problem problem = makeProblem(random, i % 2 == 0 ? 6 : 1000, 40, 20);
		const std::size_t triangleCount = problem.triangles.size();
		flip(problem);
		EXPECT_EQ(problem.triangles.size(), triangleCount);
		expectNothingWanted(problem);
	}
}

// On a small grid, where many places are on one circle, too.
TEST(DelaunayFlips, findTheSameFromAnyBeginning) {
	std::mt19937 random(20);
	for (int i = 0; i < 60; ++i) {
		SCOPED_TRACE(i);
		Problem problem = makeProblem(random, i % 2 == 0 ? 6 : 1000, 40, 20);
		Problem other = problem;
		disturb(other, random);
		flip(problem);
		flip(other);
		ASSERT_EQ(setOf(problem.triangles), setOf(other.triangles));
	}
}

TEST(DelaunayFlips, areTheSameForTrianglesTurnedOver) {
	expectSame(
	    [](Problem& problem, std::mt19937&) {
		    for (auto& t : problem.triangles) {
			    std::swap(t[1], t[2]);
		    }
	    },
	    -1);
}

// The order of triangles, of edges, and of a triangle's corners is nobody's business.
TEST(DelaunayFlips, doNotDependOnNumbers) {
	expectSame(
	    [](Problem& problem, std::mt19937& random) {
		    std::shuffle(problem.triangles.begin(), problem.triangles.end(), random);
		    for (auto& t : problem.triangles) {
			    std::rotate(t.begin(), t.begin() + random() % 3, t.end());
		    }
	    },
	    1);
}

TEST(DelaunayFlips, keepFixedEdges) {
	std::mt19937 random(23);
	Problem problem = makeProblem(random, 1000, 200, 200);
	flip(problem);
	std::set<std::array<std::uint32_t, 2>> edges;
	for (const auto& t : problem.triangles) {
		for (std::size_t i = 0; i < 3; ++i) {
			const auto [a, b] = std::minmax(t[i], t[(i + 1) % 3]);
			edges.insert({a, b});
		}
	}
	for (const PlanarEdge& e : problem.fixed) {
		EXPECT_EQ(edges.count({e.left, e.right}), 1U);
	}
}

// A regular polygon as doubles have it: nearly all fours of its corners are on a circle but for
// rounding. Signs that err would flip for ever.
TEST(DelaunayFlips, endOnACircleAsRounded) {
	constexpr std::uint32_t kCorners = 256;
	constexpr double kScale = 1LL << 29;
	std::vector<PlanarPlace> circle;
	for (std::uint32_t i = 0; i < kCorners; ++i) {
		const double angle = 2 * std::acos(-1.0) * i / kCorners;
		circle.push_back({std::cos(angle), std::sin(angle)});
	}
	std::sort(circle.begin(), circle.end());
	Problem problem;
	for (const PlanarPlace& p : circle) {
		problem.points.push_back({std::llround(p[0] * kScale), std::llround(p[1] * kScale)});
	}
	std::vector<std::uint32_t> around;
	for (std::uint32_t i = 0; i < kCorners; ++i) {
		around.push_back(i);
	}
	std::sort(around.begin(), around.end(), [&](std::uint32_t i, std::uint32_t j) {
		return std::atan2(circle[i][1], circle[i][0]) < std::atan2(circle[j][1], circle[j][0]);
	});
	for (std::uint32_t i = 0; i < kCorners; ++i) {
		const auto [a, b] = std::minmax(around[i], around[(i + 1) % kCorners]);
		problem.fixed.push_back({a, b});
	}
	for (std::uint32_t i = 1; i + 1 < kCorners; ++i) {
		problem.triangles.push_back({around[0], around[i], around[i + 1]});
	}
	Monitor monitor;
	std::vector<FreeEdge> edges = freeEdges(problem);
	const std::size_t flips = DelaunayFlips().run(edges, circle, 1, GridOrientation(problem.points),
	                                              monitor, problem.triangles);
	EXPECT_GT(flips, 0U);
	EXPECT_LT(flips, 100 * kCorners);
}

TEST(DelaunayFlips, canBeCancelled) {
	std::mt19937 random(24);
	Problem problem = makeProblem(random, 1000, 3000, 0);
	Monitor monitor([](double, const char*) { return false; });
	std::vector<FreeEdge> edges = freeEdges(problem);
	Problem done = problem;
	DelaunayFlips().run(edges, problem.places(), 1, GridOrientation(problem.points), monitor,
	                    problem.triangles);
	flip(done);
	EXPECT_NE(setOf(problem.triangles), setOf(done.triangles));
}

}  // namespace index_boolean
