// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Faces joined by faux edges are one input face: no trace of their triangulation in a cut, and
// quads stay quads.
#include "core/shapes.h"

#include <gtest/gtest.h>

#include <numeric>
#include <set>

namespace index_boolean {
namespace {

using namespace shapes;

constexpr std::size_t kUnion = 0, kIntersection = 1, kFirstOnly = 2, kSecondOnly = 3;

using Edge = std::array<Point, 2>;
using Edges = std::multiset<Edge>;

Edge edgeOf(const Point& a, const Point& b) { return {std::min(a, b), std::max(a, b)}; }

// The faux edges of a surface, once for each face that calls them so.
Edges fauxEdges(const Points& points, const IndexTriangles& triangles,
                const std::vector<std::uint8_t>& faux) {
	Edges edges;
	for (std::size_t f = 0; f < faux.size(); ++f) {
		for (std::size_t i = 0; i < 3; ++i) {
			if ((faux[f] >> i & 1) != 0) {
				edges.insert(edgeOf(points[triangles[f][i]], points[triangles[f][(i + 1) % 3]]));
			}
		}
	}
	return edges;
}

Edges fauxEdges(const Block& b) { return fauxEdges(b.points, b.triangles, b.faux); }
Edges fauxEdges(const Mesh& m) { return fauxEdges(m.points, m.triangles, m.faux); }

// The number of corners of each polygon of a block, ascending.
std::vector<std::size_t> polygonSizes(const Block& block) {
	std::vector<std::size_t> set(block.triangles.size());
	std::iota(set.begin(), set.end(), 0);
	std::map<std::array<std::uint32_t, 2>, std::size_t> faceOf;
	for (std::size_t f = 0; f < set.size(); ++f) {
		for (std::size_t i = 0; i < 3; ++i) {
			faceOf[{block.triangles[f][i], block.triangles[f][(i + 1) % 3]}] = f;
		}
	}
	for (std::size_t f = 0; f < block.faux.size(); ++f) {
		for (std::size_t i = 0; i < 3; ++i) {
			if ((block.faux[f] >> i & 1) != 0) {
				const std::size_t other =
				    faceOf.at({block.triangles[f][(i + 1) % 3], block.triangles[f][i]});
				const std::size_t from = set[f], to = set[other];
				std::replace(set.begin(), set.end(), from, to);
			}
		}
	}
	std::map<std::size_t, std::size_t> count;
	for (const std::size_t s : set) {
		++count[s];
	}
	std::vector<std::size_t> sizes;
	for (const auto& [s, n] : count) {
		sizes.push_back(n + 2);
	}
	std::sort(sizes.begin(), sizes.end());
	return sizes;
}

// Each two triangles of a list, which have one side in common, are a quad.
Mesh asQuads(Mesh m) {
	m.faux.assign(m.triangles.size(), 0);
	for (std::size_t f = 0; f + 1 < m.triangles.size(); f += 2) {
		for (std::size_t i = 0; i < 9; ++i) {
			const auto &s = m.triangles[f], &t = m.triangles[f + 1];
			if (s[i / 3] == t[(i + 1) % 3] && s[(i / 3 + 1) % 3] == t[i % 3]) {
				m.faux[f] = static_cast<std::uint8_t>(1U << i / 3);
				m.faux[f + 1] = static_cast<std::uint8_t>(1U << i % 3);
			}
		}
	}
	return m;
}

Mesh quadBox(Point low, Point high) { return asQuads(box(low, high)); }

std::size_t triangleCount(const BooleanRun& r, std::size_t block) {
	return r.blocks[block].triangles.size();
}

TEST(Polygons, aCutAcrossADiagonalLeavesNoPointOnIt) {
	// A pocket whose rim crosses the diagonal of the wall twice: eight corners of the box, eight of
	// the pocket, no others. A surface like a sphere has 2V - 4 triangles.
	const Mesh small = quadBox({0.5, 1, 2}, {3, 2, 5});
	const BooleanRun quads = run(quadBox({0, 0, 0}, {4, 4, 4}), small);
	ASSERT_TRUE(quads.status.ok()) << describe(quads.status);
	EXPECT_EQ(quads.blocks[kFirstOnly].points.size(), 16u);
	EXPECT_EQ(triangleCount(quads, kFirstOnly), 28u);
	EXPECT_EQ(triangleCount(quads, kUnion), 28u);
	EXPECT_EQ(triangleCount(quads, kIntersection), 12u);
	EXPECT_EQ(triangleCount(quads, kSecondOnly), 12u);
	const BooleanRun triangles = run(box({0, 0, 0}, {4, 4, 4}), small);
	EXPECT_EQ(triangles.blocks[kFirstOnly].points.size(), 18u);
	EXPECT_EQ(polygonSizes(triangles.blocks[kFirstOnly]).back(), 5u);  // a wall of the pocket
	for (std::size_t k = 0; k < 5; ++k) {
		EXPECT_DOUBLE_EQ(quads.audit.blocks[k].volume, triangles.audit.blocks[k].volume);
		EXPECT_TRUE(isManifold(quads.blocks[k].triangles));
	}
}

TEST(Polygons, aCutBoxHasPolygonsForFaces) {
	// Both are boxes of quads; the second cuts off a half, the third a corner, the fourth a hole.
	const Mesh a = quadBox({0, 0, 0}, {4, 4, 4});
	const BooleanRun half = run(a, quadBox({-1, -1, 2}, {5, 5, 5}));
	ASSERT_TRUE(half.status.ok());
	EXPECT_EQ(polygonSizes(half.blocks[kFirstOnly]), (std::vector<std::size_t>{4, 4, 4, 4, 4, 4}));
	EXPECT_EQ(polygonSizes(half.blocks[kIntersection]), polygonSizes(half.blocks[kFirstOnly]));
	const BooleanRun corner = run(a, quadBox({2, 2, 2}, {5, 5, 5}));
	EXPECT_EQ(polygonSizes(corner.blocks[kFirstOnly]),
	          (std::vector<std::size_t>{4, 4, 4, 4, 4, 4, 6, 6, 6}));
	// Around the hole's ends the wall is no simple polygon: eight triangles each.
	const BooleanRun hole = run(a, quadBox({1, 1, -1}, {3, 2, 5}));
	std::vector<std::size_t> expected(24, 3);
	std::fill(expected.begin() + 16, expected.end(), 4);
	EXPECT_EQ(polygonSizes(hole.blocks[kFirstOnly]), expected);
}

TEST(Polygons, untouchedQuadsKeepTheirDiagonals) {
	const Mesh a = asQuads(torus(24, 12, 3, 1));  // its quads are not plane
	const BooleanRun r = run(a, box({1.5, -0.25, -2}, {5, 0.75, 2}));
	ASSERT_TRUE(r.status.ok());
	const Edges given = fauxEdges(a), got = fauxEdges(r.blocks[kFirstOnly]);
	EXPECT_EQ(given.size(), 2u * 24 * 12);
	std::size_t uncut = 0;
	for (std::size_t f = 0; f < a.triangles.size(); f += 2) {
		const CutFace* begin = r.arrangement.refinement.cutFaces.data();
		const CutFace* end = begin + r.arrangement.refinement.cutFaces.size();
		const bool isCut = std::any_of(begin, end, [f](const CutFace& c) {
			return c.face.value == f || c.face.value == f + 1;
		});
		const auto& t = a.triangles[f];
		const bool isKept = r.arrangement.labels.vertex[t[0]] == Label::Outside;
		if (!isCut && isKept) {
			const Edge diagonal = edgeOf(a.points[t[0]], a.points[t[2]]);
			EXPECT_EQ(got.count(diagonal), 2u);
			++uncut;
		}
	}
	EXPECT_GT(uncut, 200u);
	EXPECT_LT(uncut, 288u);
}

TEST(Polygons, pointsOnTheDiagonalOfAQuadThatIsNotPlaneStay) {
	Mesh a = quadBox({0, 0, 0}, {4, 4, 4});
	a.points[7] = {4, 4, 5};
	const Mesh small = quadBox({0.5, 1, 2}, {3, 2, 6});
	const BooleanRun r = run(a, small);
	Mesh plain = a;
	plain.faux.clear();
	const BooleanRun expected = run(plain, small);
	ASSERT_TRUE(r.status.ok() && expected.status.ok());
	for (std::size_t k = 0; k < 5; ++k) {
		EXPECT_EQ(geometry(r.blocks[k]), geometry(expected.blocks[k]));
	}
	EXPECT_EQ(r.blocks[kFirstOnly].points.size(), 18u);
}

TEST(Polygons, whatTouchesADiagonalLeavesNoTrace) {
	// An edge of the second lies across the diagonal, a vertex of it on the diagonal.
	const Mesh a = quadBox({0, 0, 0}, {4, 4, 4});
	const Mesh plain = box({0, 0, 0}, {4, 4, 4});
	for (const Mesh& b : {box({1, 1, 4}, {3, 2, 5}), box({2, 2, 4}, {3, 3, 5})}) {
		const BooleanRun r = run(a, b);
		ASSERT_TRUE(r.status.ok());
		const Block& untouched = r.blocks[kFirstOnly];
		EXPECT_EQ(untouched.triangles.size(), 12u);
		EXPECT_EQ(untouched.points.size(), 8u);
		EXPECT_EQ(polygonSizes(untouched), std::vector<std::size_t>(6, 4));
	}
}

TEST(Polygons, verticesInsideAPolygonStay) {
	// A wall of four triangles around its middle is one polygon. The middle is an input vertex.
	Mesh a = box({0, 0, 0}, {4, 4, 4});
	a.points.push_back({2, 2, 4});
	a.triangles.erase(a.triangles.begin() + 2, a.triangles.begin() + 4);
	for (const auto& t : {std::array{4U, 5U}, {5U, 7U}, {7U, 6U}, {6U, 4U}}) {
		a.triangles.push_back({t[0], t[1], 8});
	}
	a.faux.assign(10, 0);
	a.faux.insert(a.faux.end(), 4, 6);  // the two sides at the middle
	for (const Mesh& b : {box({3, 3, 3}, {5, 5, 5}), box({1, 2.5, 3}, {3, 3, 5}),
	                      box({2, 2, 4}, {3, 3, 5}), box({1, 1, 4}, {3, 3, 5})}) {
		const BooleanRun r = run(a, b);
		ASSERT_TRUE(r.status.ok());
		const auto& points = r.blocks[kFirstOnly].points;
		EXPECT_NE(std::find(points.begin(), points.end(), Point({2, 2, 4})), points.end());
		EXPECT_TRUE(isManifold(r.blocks[kFirstOnly].triangles));
	}
}

// What is done to the operands takes the faux edges along.
TEST(Polygons, defectsOfTheOperandsDoNotMatter) {
	const Mesh a = quadBox({0, 0, 0}, {4, 4, 4}), b = quadBox({0.5, 1, 2}, {3, 2, 5});
	const BooleanRun expected = run(a, b);
	ASSERT_TRUE(expected.status.ok());
	std::mt19937 random(3);
	Mesh collapsed = a;
	collapsed.triangles.insert(collapsed.triangles.begin() + 1, {0, 0, 1});
	collapsed.faux.insert(collapsed.faux.begin() + 1, 5);
	Mesh twice = a;
	twice.triangles.insert(twice.triangles.begin(), {a.triangles[0], {2, 0, 1}, {0, 2, 1}});
	twice.faux.insert(twice.faux.begin(), {a.faux[0], 2, 2});
	for (const Mesh& other : {turned(a), soup(a), permuted(a, random),
	                          turned(permuted(soup(a), random)), collapsed, twice}) {
		const BooleanRun first = run(other, b), second = run(b, other);
		ASSERT_TRUE(first.status.ok()) << describe(first.status);
		ASSERT_TRUE(second.status.ok());
		for (const auto& [k, swapped] : {std::array{kUnion, kUnion},
		                                 {kIntersection, kIntersection},
		                                 {kFirstOnly, kSecondOnly},
		                                 {kSecondOnly, kFirstOnly}}) {
			EXPECT_EQ(geometry(first.blocks[k]), geometry(expected.blocks[k]));
			EXPECT_EQ(fauxEdges(first.blocks[k]), fauxEdges(expected.blocks[k]));
			EXPECT_EQ(geometry(second.blocks[swapped]), geometry(expected.blocks[k]));
			EXPECT_EQ(fauxEdges(second.blocks[swapped]), fauxEdges(expected.blocks[k]));
		}
	}
}

TEST(Polygons, aZeroAreaFaceInAPolygonDoesNotBreakIt) {
	// The top is a pentagon with a corner in the middle of a side, triangulated with a flat ear.
	Mesh a = quadBox({0, 0, 0}, {4, 4, 4});
	a.points.push_back({2, 4, 4});  // between the corners 6 and 7, in the top and in the back
	a.triangles.push_back({7, 8, 6});
	a.faux.push_back(4);
	a.faux[3] |= 2;              // of the top's face 4 7 6, the side 7 6
	a.triangles[6] = {2, 6, 8};  // the back
	a.triangles[7] = {2, 8, 3};
	a.triangles.push_back({8, 7, 3});
	a.faux[6] = 4, a.faux[7] = 3;
	a.faux.push_back(4);
	const Mesh small = quadBox({0.5, 1, 2}, {3, 2, 5});
	const BooleanRun r = run(a, small);
	ASSERT_TRUE(r.status.ok()) << describe(r.status);
	EXPECT_EQ(r.blocks[kFirstOnly].points.size(), 17u);
	EXPECT_EQ(triangleCount(r, kFirstOnly), 30u);
	const BooleanRun apart = run(a, box({1, 1, -5}, {3, 2, -4}));
	EXPECT_EQ(polygonSizes(apart.blocks[kFirstOnly]), (std::vector<std::size_t>{4, 4, 4, 4, 5, 5}));
}

TEST(Polygons, anEdgeThatOneFaceAloneCallsFauxIsAnEdge) {
	Mesh a = quadBox({0, 0, 0}, {4, 4, 4});
	a.faux[2] = 0;
	a.faux[0] = 7;
	const BooleanRun r = run(a, quadBox({0.5, 1, 2}, {3, 2, 5}));
	ASSERT_TRUE(r.status.ok());
	EXPECT_EQ(r.blocks[kFirstOnly].points.size(), 18u);
	// Five quads of the box, three of the pocket and two of its walls with a point more.
	const std::vector<std::size_t> sizes = polygonSizes(r.blocks[kFirstOnly]);
	EXPECT_EQ(std::count(sizes.begin(), sizes.end(), 4), 8);
	EXPECT_EQ(std::count(sizes.begin(), sizes.end(), 5), 2);
}

// Two boxes of one operand have an edge in common, and walls in one plane on either side of it. Two
// faces there, of one box or of both, call the edge faux and follow each other in the list.
TEST(Polygons, anEdgeOfFourFacesJoinsNoneOfThem) {
	const Mesh m = joined(box({0, 0, 0}, {2, 2, 2}), box({2, 2, 0}, {4, 4, 2}));
	const Edge common = edgeOf({2, 2, 0}, {2, 2, 2});
	using Place = std::array<std::size_t, 2>;  // a face and a corner
	std::vector<Place> sides;
	for (std::size_t i = 0; i < 3 * m.triangles.size(); ++i) {
		const auto& t = m.triangles[i / 3];
		if (edgeOf(m.points[t[i % 3]], m.points[t[(i + 1) % 3]]) == common) {
			sides.push_back({i / 3, i % 3});
		}
	}
	ASSERT_EQ(sides.size(), 4u);
	for (const Place& a : sides) {
		for (const Place& b : sides) {
			if (a[0] == b[0]) {
				continue;
			}
			Mesh marked = m;
			marked.faux.assign(m.triangles.size(), 0);
			marked.faux[a[0]] = static_cast<std::uint8_t>(1U << a[1]);
			marked.faux[b[0]] = static_cast<std::uint8_t>(1U << b[1]);
			const auto move = [&](std::size_t from, std::size_t to) {
				std::swap(marked.triangles[from], marked.triangles[to]);
				std::swap(marked.faux[from], marked.faux[to]);
			};
			move(a[0], 0);
			move(b[0] == 0 ? a[0] : b[0], 1);
			const BooleanRun r = run(marked, box({0.5, 0.5, 1}, {1, 1, 3}));
			ASSERT_TRUE(r.status.ok()) << describe(r.status);
			const std::vector<FaceId>& polygon = r.arrangement.polygons.polygon;
			for (std::uint32_t f = 0; f < polygon.size(); ++f) {
				EXPECT_EQ(polygon[f].value, f);
			}
		}
	}
}

TEST(Polygons, meshesWithoutFauxEdgesPayNothing) {
	const BooleanRun r = run(box({0, 0, 0}, {4, 4, 4}), sphere(8, {0, 0, 0}, 2));
	ASSERT_TRUE(r.status.ok());
	EXPECT_TRUE(r.arrangement.mesh.faux.empty());
	EXPECT_TRUE(r.arrangement.polygons.polygon.empty());
	EXPECT_TRUE(r.blocks[kUnion].faux.empty());
}

// Any mask on any shape, cut again and again: the point set stays, whatever is called a polygon.
TEST(Polygons, anyMaskKeepsVolumesAndInputVertices) {
	for (std::uint32_t seed = 0; seed < 60; ++seed) {
		SCOPED_TRACE("seed " + std::to_string(seed));
		std::mt19937 random(seed);
		const BooleanRun first = run(gridBox(random, 5), gridBox(random, 5));
		ASSERT_TRUE(first.status.ok());
		const Block& solid = first.blocks[seed % 2 == 0 ? kUnion : kFirstOnly];
		if (solid.triangles.empty()) {
			continue;
		}
		Mesh m{solid.points, solid.triangles};
		const Mesh c = gridBox(random, 5);
		const BooleanRun plain = run(m, c);
		ASSERT_TRUE(plain.status.ok());
		for (std::size_t f = 0; f < m.triangles.size(); ++f) {
			m.faux.push_back(static_cast<std::uint8_t>(seed % 3 == 0 ? 7 : random() % 8));
		}
		const BooleanRun r = run(m, c);
		const BooleanRun swapped = run(c, permuted(m, random));
		ASSERT_TRUE(r.status.ok() && swapped.status.ok());
		for (std::size_t k = 0; k < 5; ++k) {
			EXPECT_NEAR(r.audit.blocks[k].volume, plain.audit.blocks[k].volume, 1e-9);
			EXPECT_NEAR(r.audit.blocks[k].area, plain.audit.blocks[k].area, 1e-9);
			EXPECT_TRUE(isManifold(r.blocks[k].triangles));
			EXPECT_LE(r.blocks[k].triangles.size(), plain.blocks[k].triangles.size());
			const std::size_t other = k == kFirstOnly    ? kSecondOnly
			                          : k == kSecondOnly ? kFirstOnly
			                                             : k;
			EXPECT_EQ(geometry(swapped.blocks[other]), geometry(r.blocks[k]));
			EXPECT_EQ(fauxEdges(swapped.blocks[other]), fauxEdges(r.blocks[k]));
			// Of the plain run's points, those that are input vertices are all there.
			const Block& p = plain.blocks[k];
			for (std::size_t v = 0; v < p.points.size(); ++v) {
				if (!plain.arrangement.isCurvePoint(p.vertexSource[v])) {
					EXPECT_NE(std::find(r.blocks[k].points.begin(), r.blocks[k].points.end(),
					                    p.points[v]),
					          r.blocks[k].points.end());
				}
			}
		}
	}
}

}  // namespace
}  // namespace index_boolean
