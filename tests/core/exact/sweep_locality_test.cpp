// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The sweep is local: a convex region of a planar graph, with holes, dangling edges and isolated
// points in it, gets the same triangles whatever lies around it. Where faces of two operands
// overlap in one plane, this is why both are cut alike.
#include "core/exact/planar_grid.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>
#include <string>

namespace index_boolean {
namespace {

struct GridEdge {
	GridPoint a, b;
};

using Polygon = std::vector<GridPoint>;                    // convex, counter-clockwise
using GridTriangles = std::set<std::array<GridPoint, 3>>;  // corners in order

int sign(std::int64_t value) { return (value > 0) - (value < 0); }

int orientation(GridPoint a, GridPoint b, GridPoint c) { return sign(area(a, b, c)); }

bool isInner(GridPoint p, const GridEdge& e) {
	return onSegment(p, e.a, e.b) && !(p == e.a) && !(p == e.b);
}

// Whether two edges meet anywhere but in common ends, or are the same.
bool clash(const GridEdge& e, const GridEdge& f) {
	const bool isSame = (e.a == f.a && e.b == f.b) || (e.a == f.b && e.b == f.a);
	const bool isTouching =
	    isInner(f.a, e) || isInner(f.b, e) || isInner(e.a, f) || isInner(e.b, f);
	return isSame || isTouching ||
	       (orientation(e.a, e.b, f.a) * orientation(e.a, e.b, f.b) < 0 &&
	        orientation(f.a, f.b, e.a) * orientation(f.a, f.b, e.b) < 0);
}

bool clashWithAny(const GridEdge& edge, const std::vector<GridEdge>& edges) {
	return std::any_of(edges.begin(), edges.end(),
	                   [&edge](const GridEdge& e) { return clash(edge, e); });
}

// The convex hull without collinear points; empty if all points are on one line.
Polygon hullOf(std::vector<GridPoint> points) {
	std::sort(points.begin(), points.end());
	points.erase(std::unique(points.begin(), points.end()), points.end());
	const auto chainOf = [](auto begin, auto end) {
		Polygon chain;
		for (auto p = begin; p != end; ++p) {
			while (chain.size() >= 2 && area(chain[chain.size() - 2], chain.back(), *p) <= 0) {
				chain.pop_back();
			}
			chain.push_back(*p);
		}
		return chain;
	};
	Polygon hull = chainOf(points.begin(), points.end());
	const Polygon upper = chainOf(points.rbegin(), points.rend());
	if (hull.size() + upper.size() < 5) {
		return {};
	}
	hull.pop_back();
	hull.insert(hull.end(), upper.begin(), upper.end() - 1);
	return hull;
}

// +1 inside, 0 on the border, -1 outside.
int sideOf(GridPoint p, const Polygon& polygon) {
	int least = 1;
	for (std::size_t i = 0; i < polygon.size(); ++i) {
		least = std::min(least, orientation(polygon[i], polygon[(i + 1) % polygon.size()], p));
	}
	return least;
}

// Whether an edge has a point inside a polygon. If not, a side of the polygon or the edge itself
// has all of the one on the one side of its line and all of the other on the other.
bool entersInside(const GridEdge& e, const Polygon& polygon) {
	bool isLeft = false, isRight = false;
	for (std::size_t i = 0; i < polygon.size(); ++i) {
		const GridPoint p = polygon[i], q = polygon[(i + 1) % polygon.size()];
		if (area(p, q, e.a) <= 0 && area(p, q, e.b) <= 0) {
			return false;
		}
		isLeft = isLeft || area(e.a, e.b, p) > 0;
		isRight = isRight || area(e.a, e.b, p) < 0;
	}
	return isLeft && isRight;
}

class Random {
public:
	explicit Random(std::uint32_t seed) : engine_(seed) {}

	std::int64_t number(std::int64_t low, std::int64_t high) {
		return std::uniform_int_distribution<std::int64_t>(low, high)(engine_);
	}
	GridPoint point(GridPoint low, GridPoint high) {
		const std::int64_t x = number(low.x, high.x);
		return {x, number(low.y, high.y)};
	}
	bool oneOf(std::int64_t n) { return number(1, n) == 1; }
	template <class Item>
	const Item& oneOf(const std::vector<Item>& items) {
		return items[static_cast<std::size_t>(
		    number(0, static_cast<std::int64_t>(items.size()) - 1))];
	}
	template <class Item>
	void shuffle(std::vector<Item>& items) {
		std::shuffle(items.begin(), items.end(), engine_);
	}

private:
	std::mt19937 engine_;
};

// A convex region in the square from 0 to `size`, and what is in it.
struct Region {
	std::int64_t size = 0;
	Polygon polygon;
	std::vector<GridPoint> borderPoints;  // corners, and others, on which edges may end
	std::vector<GridEdge> border, inner;
	std::set<GridPoint> isolated;

	bool isBorderPoint(GridPoint p) const {
		return std::find(borderPoints.begin(), borderPoints.end(), p) != borderPoints.end();
	}
};

// An edge of the sides of a polygon between each two neighbours of some points on them.
std::vector<GridEdge> sidesCutAt(const Polygon& polygon, const std::set<GridPoint>& points) {
	std::vector<GridEdge> edges;
	for (std::size_t i = 0; i < polygon.size(); ++i) {
		std::vector<GridPoint> onSide;  // sorted, thus in order along it
		for (const GridPoint p : points) {
			if (onSegment(p, polygon[i], polygon[(i + 1) % polygon.size()])) {
				onSide.push_back(p);
			}
		}
		for (std::size_t k = 0; k + 1 < onSide.size(); ++k) {
			edges.push_back({onSide[k], onSide[k + 1]});
		}
	}
	return edges;
}

Region randomRegion(Random& random) {
	Region region;
	region.size = random.number(3, 9);
	const GridPoint low{0, 0}, high{region.size, region.size};
	while (region.polygon.empty()) {
		std::vector<GridPoint> points(6);
		std::generate(points.begin(), points.end(), [&] { return random.point(low, high); });
		region.polygon = hullOf(points);
	}
	std::set<GridPoint> onBorder(region.polygon.begin(), region.polygon.end());
	for (int i = 0; i < 40; ++i) {
		const GridPoint p = random.point(low, high);
		if (sideOf(p, region.polygon) == 0) {
			onBorder.insert(p);
		}
	}
	region.borderPoints.assign(onBorder.begin(), onBorder.end());
	region.border = sidesCutAt(region.polygon, onBorder);
	const auto mayEndAt = [&region](GridPoint p) {
		return sideOf(p, region.polygon) > 0 || region.isBorderPoint(p);
	};
	for (std::int64_t n = random.number(0, 12); n > 0; --n) {
		const GridEdge edge{random.point(low, high), random.point(low, high)};
		if (!(edge.a == edge.b) && mayEndAt(edge.a) && mayEndAt(edge.b) &&
		    !clashWithAny(edge, region.border) && !clashWithAny(edge, region.inner)) {
			region.inner.push_back(edge);
		}
	}
	for (std::int64_t n = random.number(0, 4); n > 0; --n) {
		const GridPoint p = random.point(low, high);
		const auto isOn = [p](const GridEdge& e) { return onSegment(p, e.a, e.b); };
		if (sideOf(p, region.polygon) > 0 &&
		    std::none_of(region.inner.begin(), region.inner.end(), isOn)) {
			region.isolated.insert(p);
		}
	}
	return region;
}

// A box or a triangle around a region, whose sides may go along the region's.
Polygon randomPolygonAround(const Region& region, Random& random) {
	const auto [left, right] =
	    std::minmax_element(region.polygon.begin(), region.polygon.end(),
	                        [](GridPoint p, GridPoint q) { return p.x < q.x; });
	const auto [bottom, top] =
	    std::minmax_element(region.polygon.begin(), region.polygon.end(),
	                        [](GridPoint p, GridPoint q) { return p.y < q.y; });
	const GridPoint low{left->x - random.number(0, 3), bottom->y - random.number(0, 3)};
	const GridPoint high{right->x + random.number(0, 3), top->y + random.number(0, 3)};
	if (random.oneOf(2)) {
		return {low, {high.x, low.y}, high, {low.x, high.y}};
	}
	const std::int64_t leg = (high.x - low.x) + (high.y - low.y);
	return {low, {low.x + leg, low.y}, {low.x, low.y + leg}};
}

// Edges between the region and a polygon around it, up to 14.
std::vector<GridEdge> randomEdgesAround(const Region& region, const Polygon& around,
                                        Random& random) {
	std::vector<GridEdge> edges;
	const GridPoint low{-3, -3}, high{region.size + 3, region.size + 3};
	const auto mayEndAt = [&](GridPoint p) {
		return sideOf(p, around) >= 0 && (sideOf(p, region.polygon) < 0 || region.isBorderPoint(p));
	};
	const auto end = [&] {
		return random.oneOf(3) ? random.oneOf(region.borderPoints) : random.point(low, high);
	};
	for (std::int64_t n = random.number(0, 14); n > 0; --n) {
		const GridPoint a = end();
		const GridEdge edge{a, end()};
		if (!(edge.a == edge.b) && mayEndAt(edge.a) && mayEndAt(edge.b) &&
		    !entersInside(edge, region.polygon) && !clashWithAny(edge, region.border) &&
		    !clashWithAny(edge, edges)) {
			edges.push_back(edge);
		}
	}
	return edges;
}

// The region in surroundings: its own edges, those around it, and the polygon around all.
std::vector<GridEdge> surrounded(const Region& region, Random& random) {
	const Polygon around = randomPolygonAround(region, random);
	std::vector<GridEdge> edges = region.border;
	for (const GridEdge& e : randomEdgesAround(region, around, random)) {
		edges.push_back(e);
	}
	std::set<GridPoint> points(around.begin(), around.end());
	for (const GridEdge& e : edges) {
		points.insert({e.a, e.b});
	}
	for (const GridEdge& e : sidesCutAt(around, points)) {
		if (!clashWithAny(e, edges)) {  // it may be there as a side of the region
			edges.push_back(e);
		}
	}
	return edges;
}

// An integer map of the plane, under which other points come first.
struct LinearMap {
	std::int64_t xx = 1, xy = 0, yx = 0, yy = 1;

	GridPoint operator()(GridPoint p) const { return {xx * p.x + xy * p.y, yx * p.x + yy * p.y}; }
};

LinearMap randomMap(Random& random) {
	LinearMap map;
	do {
		map = {random.number(-2, 2), random.number(-2, 2), random.number(-2, 2),
		       random.number(-2, 2)};
	} while (map.xx * map.yy == map.xy * map.yx);
	return map;
}

// Sweeps over edges and the region's isolated points, all mapped.
// \return the triangles that lie in the region
GridTriangles sweep(PlanarSweep& planarSweep, const std::vector<GridEdge>& edges,
                    const Region& region, const LinearMap& map, Random& random) {
	std::map<GridPoint, std::uint32_t> ranks;
	for (const GridEdge& e : edges) {
		ranks[map(e.a)] = ranks[map(e.b)] = 0;
	}
	for (const GridPoint p : region.isolated) {
		ranks[map(p)] = 0;
	}
	std::vector<GridPoint> points;
	for (auto& [point, rank] : ranks) {
		rank = static_cast<std::uint32_t>(points.size());
		points.push_back(point);
	}
	std::vector<PlanarEdge> planar;
	for (const GridEdge& e : edges) {
		const auto [left, right] = std::minmax({ranks[map(e.a)], ranks[map(e.b)]});
		planar.push_back({left, right});
	}
	random.shuffle(planar);
	std::vector<std::array<std::uint32_t, 3>> triangles;
	Monitor monitor;
	const auto count = static_cast<std::uint32_t>(points.size());
	EXPECT_TRUE(
	    planarSweep.triangulate(count, planar, GridOrientation(points), monitor, triangles));
	Polygon thrice;  // the region, as large as sums of three corners
	for (const GridPoint p : region.polygon) {
		thrice.push_back(map({3 * p.x, 3 * p.y}));
	}
	thrice = hullOf(thrice);
	GridTriangles inside;
	for (const auto& t : triangles) {
		std::array<GridPoint, 3> corners{points[t[0]], points[t[1]], points[t[2]]};
		const GridPoint sum{corners[0].x + corners[1].x + corners[2].x,
		                    corners[0].y + corners[1].y + corners[2].y};
		if (sideOf(sum, thrice) > 0) {
			std::sort(corners.begin(), corners.end());
			inside.insert(corners);
		}
	}
	return inside;
}

TEST(SweepLocality, aRegionGetsTheSameTrianglesWhateverLiesAroundIt) {
	PlanarSweep planarSweep;
	std::size_t withInnerEdges = 0, withIsolatedPoints = 0;
	for (std::uint32_t seed = 0; seed < 4000 && !HasFailure(); ++seed) {
		SCOPED_TRACE("seed " + std::to_string(seed));
		Random random(seed);
		const Region region = randomRegion(random);
		const LinearMap map = randomMap(random);
		const auto trianglesIn = [&](std::vector<GridEdge> edges) {
			edges.insert(edges.end(), region.inner.begin(), region.inner.end());
			return sweep(planarSweep, edges, region, map, random);
		};
		const GridTriangles alone = trianglesIn(region.border);
		EXPECT_FALSE(alone.empty());
		for (int i = 0; i < 2; ++i) {
			EXPECT_TRUE(trianglesIn(surrounded(region, random)) == alone);
		}
		withInnerEdges += region.inner.empty() ? 0 : 1;
		withIsolatedPoints += region.isolated.empty() ? 0 : 1;
	}
	EXPECT_GT(withInnerEdges, 1000U);
	EXPECT_GT(withIsolatedPoints, 1000U);
}

}  // namespace
}  // namespace index_boolean
