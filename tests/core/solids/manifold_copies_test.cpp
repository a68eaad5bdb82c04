// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a block meets itself it is pulled apart: a manifold mesh with copies, of the same solid.
#include "core/shapes.h"

#include <vcg_ext/exact/zero_area.h>
#include <vcg_ext/mesh/non_manifold.h>
#include <vcg_ext/solids/manifold_copies.h>

#include <gtest/gtest.h>

#include <set>

namespace index_boolean {
namespace {

using namespace shapes;

Options welded() {
	Options options;
	options.weldNonManifold = true;
	return options;
}

void expectManifold(const BooleanRun& r) {
	ASSERT_TRUE(r.status.ok()) << describe(r.status);
	for (const Block& block : r.blocks) {
		EXPECT_TRUE(isManifold(block.triangles)) << operationName(block.operation);
	}
}

TEST(ManifoldCopies, cubesThatShareAnEdgeOrAVertexComeApart) {
	const Mesh unit = box({0, 0, 0}, {1, 1, 1});
	for (const Mesh& other : {box({1, 1, 0}, {2, 2, 1}), box({1, 1, 1}, {2, 2, 2})}) {
		const BooleanRun r = run(unit, other);
		expectManifold(r);
		EXPECT_EQ(r.blocks[0].points.size(), 16u);
		EXPECT_EQ(r.blocks[0].triangles.size(), 24u);
		EXPECT_EQ(r.audit.blocks[0].components, 2u);
		EXPECT_GT(r.blocks[0].verticesCopied, 0u);
		const BooleanRun asOne = run(unit, other, welded());
		ASSERT_TRUE(asOne.status.ok());
		EXPECT_LT(asOne.blocks[0].points.size(), 16u);
		EXPECT_TRUE(isClosed(asOne.blocks[0].triangles));
		EXPECT_EQ(asOne.audit.blocks[0].components, 1u);
	}
}

TEST(ManifoldCopies, aSymmetricDifferenceComesApartAlongTheCurve) {
	std::mt19937 random(11);
	const BooleanRun r = run(placed(sphere(20, {0, 0, 0}, 1), random, 0),
	                         placed(sphere(20, {0, 0, 0}, 1), random, 0.4));
	expectManifold(r);
	EXPECT_EQ(r.audit.blocks[4].components, 2u);
}

// GEOMETRY E13: two diagonal columns, with slabs above and below. Pairs across the solid would
// leave both ends of the edge in one umbrella; across the void they come apart.
TEST(ManifoldCopies, anEdgeInsideOneUmbrellaIsPairedAcrossTheVoid) {
	const Mesh columns = joined(box({0, 0, 1}, {1, 1, 2}), box({1, 1, 1}, {2, 2, 2}));
	const Mesh slabs = joined(box({0, 0, 0}, {2, 2, 1}), box({0, 0, 2}, {2, 2, 3}));
	for (const bool swap : {false, true}) {
		const BooleanRun r = swap ? run(slabs, columns) : run(columns, slabs);
		expectManifold(r);
		EXPECT_DOUBLE_EQ(r.volume(Operation::Union), 10);
		EXPECT_EQ(r.audit.blocks[0].components, 1u);
	}
}

Mesh prism(const std::array<std::array<double, 2>, 3>& base, double low, double high) {
	Mesh m;
	for (const double z : {low, high}) {
		for (const auto& [x, y] : base) {
			m.points.push_back({x, y, z});
		}
	}
	m.triangles = {{0, 2, 1}, {3, 4, 5}};
	for (std::uint32_t i = 0; i < 3; ++i) {
		const std::uint32_t j = (i + 1) % 3;
		m.triangles.push_back({i, j, j + 3});
		m.triangles.push_back({i, j + 3, i + 3});
	}
	return m;
}

// Three wedges around an edge, two of them joined by slabs at both of its ends. Across the solid,
// the two joined wedges have an umbrella in common at both ends; across the void, the two gaps
// beside the third wedge have. In two rounds it comes apart.
TEST(ManifoldCopies, anEdgeWithSixFacesComesApart) {
	const Mesh wedges = joined(
	    joined(prism({{{0, 0}, {2, 0}, {1, 1}}}, 0, 1), prism({{{0, 0}, {-1, 1}, {-2, 0}}}, 0, 1)),
	    prism({{{0, 0}, {-1, -2}, {1, -2}}}, 0, 1));
	const Mesh slabs =
	    joined(prism({{{2, 0}, {0, 3}, {-2, 0}}}, 1, 2), prism({{{2, 0}, {0, 3}, {-2, 0}}}, -1, 0));
	for (const bool swap : {false, true}) {
		const BooleanRun r = swap ? run(slabs, wedges) : run(wedges, slabs);
		expectManifold(r);
		EXPECT_DOUBLE_EQ(r.volume(Operation::Union), 1 + 1 + 2 + 6 + 6);
	}
}

// As many pairs at one edge as there are wedges. Comparing each with each took a minute.
TEST(ManifoldCopies, aPinwheelComesApartIntoItsWedges) {
	constexpr std::uint32_t kWedges = 20000;
	Mesh pinwheel;
	pinwheel.points = {{0, 0, -1}, {0, 0, 1}};
	for (std::uint32_t i = 0; i < kWedges; ++i) {
		const std::uint32_t p = 2 + 2 * i, q = p + 1;
		for (const double along : {0.0, 0.5}) {
			const double angle = 2 * 3.141592653589793 * (i + along) / kWedges;
			pinwheel.points.push_back({std::cos(angle), std::sin(angle), 0});
		}
		pinwheel.triangles.insert(pinwheel.triangles.end(),
		                          {{0, p, 1}, {0, 1, q}, {0, q, p}, {1, p, q}});
	}
	Monitor monitor;
	Arrangement arrangement;
	Block block;
	ASSERT_TRUE(
	    arrange(arrays(pinwheel, box({5, 5, 5}, {6, 6, 6})), {}, monitor, arrangement).ok());
	ASSERT_TRUE(extractBlock(arrangement, Operation::FirstMinusSecond, monitor, block).ok());
	EXPECT_TRUE(isManifold(block.triangles));
	EXPECT_EQ(block.verticesCopied, 2 * (kWedges - 1));
	EXPECT_EQ(block.points.size(), 4 * kWedges);
}

// What rounding has put in one place is in no order but that of coordinates: two solids, flat as
// stored, fall on each other at an edge. Whatever the numbering, the same faces hang together.
TEST(ManifoldCopies, facesInOnePlaceAsStoredArePairedByTheirCoordinates) {
	const Points places{{0, 0, 0}, {0, 0, 4}, {4, 0, 1}, {6, 0, 1}, {4, 3, 1}, {6, 5, 2}};
	const IndexTriangles faces{{0, 1, 2}, {1, 0, 4}, {0, 2, 4}, {1, 4, 2},
	                           {0, 1, 3}, {1, 0, 5}, {0, 3, 5}, {1, 5, 3}};
	std::set<std::vector<std::array<Point, 3>>> results;
	std::mt19937 random(5);
	for (int i = 0; i < 40; ++i) {
		const Mesh m = permuted({places, faces, {}}, random);
		Block block;
		block.points = m.points;
		block.triangles = m.triangles;
		block.vertexSource.assign(places.size(), VertexId{0});
		block.faceSource.assign(faces.size(), FaceSource{FaceId{0}, false});
		for (const Point& p : m.points) {
			block.suspect.push_back(p[0] == 0 ? 1 : 0);
		}
		Monitor monitor;
		ASSERT_TRUE(copyNonManifoldAsStored(OutputScalar::Double, monitor, block).ok());
		// Which apexes hang together across the edge.
		std::map<std::uint32_t, std::vector<Point>> apexes;
		for (const auto& t : block.triangles) {
			for (std::size_t k = 0; k < 3; ++k) {
				if (block.points[t[k]] == places[0] && block.points[t[(k + 1) % 3]][0] != 0) {
					apexes[t[k]].push_back(block.points[t[(k + 1) % 3]]);
				}
			}
		}
		std::vector<std::array<Point, 3>> together;
		for (auto& [vertex, ends] : apexes) {
			std::sort(ends.begin(), ends.end());
			ends.resize(3);
			together.push_back({ends[0], ends[1], ends[2]});
		}
		std::sort(together.begin(), together.end());
		results.insert(together);
	}
	EXPECT_EQ(results.size(), 1u);
}

// No solid has such a surface: around vertex 0 it runs through the vertices 1 and 2 in turn, twice.
// However the four faces at the edges to them are paired, they have an umbrella in common.
TEST(ManifoldCopies, whatCannotComeApartGetsMidpoints) {
	Block block;
	block.points = {{0, 0, 0},  {0, 0, 4},  {4, 0, 0},  {1, 2, 6},
	                {2, -2, 1}, {-2, 1, 2}, {2, 3, -2}, {9, 9, 9}};
	block.vertexSource.assign(8, VertexId{0});
	const std::array<std::uint32_t, 8> around{1, 3, 2, 4, 1, 5, 2, 6};
	for (std::size_t i = 0; i < 8; ++i) {
		const std::uint32_t from = around[i], to = around[(i + 1) % 8];
		block.triangles.push_back({0, from, to});
		block.triangles.push_back({7, to, from});
	}
	block.faceSource.assign(16, FaceSource{FaceId{0}, false});
	block.suspect.assign(8, 0);
	block.suspect[0] = 1;
	Monitor monitor;
	ASSERT_TRUE(copyNonManifoldAsStored(OutputScalar::Double, monitor, block).ok());
	EXPECT_TRUE(isClosed(block.triangles));
	std::map<Point, int> midpoints;
	for (std::size_t v = 0; v < block.points.size(); ++v) {
		midpoints[block.points[v]] += block.vertexSource[v] == VertexId::none() ? 1 : 0;
	}
	EXPECT_EQ(midpoints[(Point{0, 0, 2})], 2);
	EXPECT_EQ(midpoints[(Point{2, 0, 0})], 2);
	EXPECT_EQ(block.triangles.size(), 16u + 8u);
	for (const auto& t : block.triangles) {
		EXPECT_FALSE(hasZeroArea(block.points[t[0]], block.points[t[1]], block.points[t[2]]));
	}
	std::map<std::array<std::uint32_t, 2>, int> facesAt;
	for (const auto& t : block.triangles) {
		for (std::size_t i = 0; i < 3; ++i) {
			if (t[i] == 0 || t[(i + 1) % 3] == 0) {
				EXPECT_EQ(++facesAt[(std::array{t[i], t[(i + 1) % 3]})], 1);
			}
		}
	}
}

TEST(ManifoldCopies, nonManifoldOperandsGiveManifoldBlocksAwayFromTheCurveToo) {
	Mesh pair = joined(box({0, 0, 0}, {1, 1, 1}), box({1, 1, 0}, {2, 2, 1}));
	const BooleanRun r = run(pair, box({10, 10, 10}, {11, 11, 11}));
	expectManifold(r);
	EXPECT_EQ(r.arrangement.nonManifold.size(), 2u);
	EXPECT_EQ(r.audit.blocks[2].components, 2u);
}

TEST(NonManifold, aClosedManifoldIsToldFromAnyOtherSurface) {
	const auto isManifold = [](const IndexTriangles& faces) {
		Triangles triangles;
		std::uint32_t end = 0;
		for (const auto& t : faces) {
			triangles.push_back({VertexId{t[0]}, VertexId{t[1]}, VertexId{t[2]}});
			end = std::max({end, t[0] + 1, t[1] + 1, t[2] + 1});
		}
		const Triangle* first = triangles.data();
		const Triangle* last = first + triangles.size();
		// In parts it is told as in one.
		const bool all = isClosedManifold(first, last, {0, end});
		EXPECT_EQ(all, isClosedManifold(first, last, {0, end / 2}) &&
		                   isClosedManifold(first, last, {end / 2, end}));
		return all;
	};
	EXPECT_TRUE(isManifold(torus(9, 7, 2, 1).triangles));
	EXPECT_TRUE(isManifold(sphere(40, {0, 0, 0}, 1).triangles));  // poles with 80 faces
	const IndexTriangles tetrahedron{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
	EXPECT_TRUE(isManifold(tetrahedron));
	auto faces = tetrahedron;
	faces.pop_back();
	EXPECT_FALSE(isManifold(faces));  // open
	faces.push_back({1, 2, 3});
	EXPECT_FALSE(isManifold(faces));  // one face the wrong way round
	faces = tetrahedron;
	faces.insert(faces.end(), tetrahedron.begin(), tetrahedron.end());
	EXPECT_FALSE(isManifold(faces));                   // all of them twice
	EXPECT_FALSE(isManifold({{0, 1, 2}, {0, 2, 1}}));  // a face and its opposite
	const std::uint32_t far = 1024;                    // as far as two edges of one table's place
	EXPECT_TRUE(isManifold({{0, 1, 1 + far}, {0, 1 + far, 3}, {0, 3, 1}, {1, 3, 1 + far}}));
}

TEST(NonManifold, findsEdgesWithFourFacesAndCornersThatTouch) {
	const auto nonManifold = [](const Mesh& m) {
		Triangles triangles;
		for (const auto& t : m.triangles) {
			triangles.push_back({VertexId{t[0]}, VertexId{t[1]}, VertexId{t[2]}});
		}
		std::vector<VertexId> out;
		const auto count = static_cast<std::uint32_t>(m.points.size());
		findNonManifoldVertices(triangles.data(), triangles.data() + triangles.size(), {0, count},
		                        out);
		return out;
	};
	EXPECT_TRUE(nonManifold(torus(9, 7, 2, 1)).empty());
	EXPECT_TRUE(nonManifold(sphere(40, {0, 0, 0}, 1)).empty());  // poles with 80 faces
	// Two tetrahedra on one vertex; two on one edge; a vertex with many faces of two cones.
	Mesh m;
	m.points.assign(7, {});
	m.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2},
	               {0, 4, 5}, {0, 5, 6}, {0, 6, 4}, {4, 6, 5}};
	EXPECT_EQ(nonManifold(m), std::vector<VertexId>{VertexId{0}});
	m.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2},
	               {0, 1, 4}, {0, 4, 5}, {0, 5, 1}, {1, 5, 4}};
	EXPECT_EQ(nonManifold(m), (std::vector<VertexId>{VertexId{0}, VertexId{1}}));
	Mesh cones;
	constexpr std::uint32_t kSides = 60;
	cones.points.assign(3 + 2 * kSides, {});
	for (std::uint32_t cone = 0; cone < 2; ++cone) {
		for (std::uint32_t i = 0; i < kSides; ++i) {
			const std::uint32_t a = 3 + cone * kSides + i;
			const std::uint32_t b = 3 + cone * kSides + (i + 1) % kSides;
			cones.triangles.push_back({0, a, b});
			cones.triangles.push_back({1 + cone, b, a});
		}
	}
	EXPECT_EQ(nonManifold(cones), std::vector<VertexId>{VertexId{0}});
}

}  // namespace
}  // namespace index_boolean
