// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Random solids on a small integer grid, where every degeneracy occurs: exact volumes against an
// independent oracle, what every block promises, and invariance. 1000 pairs, or as many as
// INDEXBOOLEAN_FUZZ_PAIRS says; pair n is made from the seed n. A failing pair is made small and
// printed.
#include "core/shapes.h"
#include "support/asked_inputs.h"
#include "support/grid_properties.h"
#include "support/shrink.h"

#include <gtest/gtest.h>

namespace index_boolean {
namespace {

using grid::GridMesh;
using grid::meshOf;
using grid::Rational;
using grid::SolidPair;
using shapes::BooleanRun;

// A third of the pairs run with the defaults, the others with any options.
Options optionsOf(std::uint32_t seed) {
	Options options;
	options.threads = 1;
	if (seed % 3 != 0) {
		grid::Random random(seed);
		options.octreeMaxDepth = 1 + static_cast<int>(random.below(20));
		options.octreeLeafSize = static_cast<int>(random.below(3));
		options.mergeFragments = random.oneIn(2);
		options.mergeCoplanar = random.oneIn(2);
		options.weldNonManifold = random.oneIn(2);
		options.selfIntersections =
		    random.oneIn(2) ? SelfIntersections::Refuse : SelfIntersections::Trust;
	}
	return options;
}

std::string text(const Options& o) {
	return "octree " + std::to_string(o.octreeMaxDepth) + ' ' + std::to_string(o.octreeLeafSize) +
	       (o.mergeFragments ? " mergeFragments" : "") + (o.mergeCoplanar ? " mergeCoplanar" : "") +
	       (o.weldNonManifold ? " weldNonManifold" : "") +
	       (o.selfIntersections == SelfIntersections::Refuse ? " refuse" : "");
}

// What is wrong with a pair; empty if nothing is.
using Property = std::string (*)(const SolidPair&, const Options&);

void expectOfEveryPair(Property defect) {
	for (std::uint32_t seed = 0; seed < askedInputs(1000); ++seed) {
		const SolidPair pair = grid::randomPair(seed);
		const Options options = optionsOf(seed);
		const std::string found = defect(pair, options);
		if (found.empty()) {
			continue;
		}
		const auto fails = [&](const SolidPair& p) { return !defect(p, options).empty(); };
		const SolidPair small = grid::shrunk(pair, fails);
		FAIL() << "seed " << seed << " (" << text(options) << "): " << found
		       << "\nmade small: " << defect(small, options) << "\nA: " << grid::text(small.a)
		       << "\nB: " << grid::text(small.b) << "\nas it was:\nA: " << grid::text(pair.a)
		       << "\nB: " << grid::text(pair.b);
	}
}

TEST(GridPolyhedra, blocksHaveExactlyTheVolumesAndWallsOfTheOracle) {
	expectOfEveryPair(grid::measuresDefect);
}

// --- what every block promises -----------------------------------------------------------------

TEST(GridPolyhedra, deliveredBlocksKeepTheirPromises) { expectOfEveryPair(grid::deliveryDefect); }

TEST(GridPolyhedra, blocksRoundedToFloatKeepTheirPromises) {
	expectOfEveryPair(grid::floatDeliveryDefect);
}

// --- invariance --------------------------------------------------------------------------------

TEST(GridPolyhedra, swappedOperandsGiveTheSameTriangles) { expectOfEveryPair(grid::swapDefect); }

TEST(GridPolyhedra, otherNumberingsAndUnweldedCornersGiveTheSameTriangles) {
	expectOfEveryPair(grid::numberingDefect);
}

TEST(GridPolyhedra, anyNumberOfThreadsGivesTheSameTriangles) {
	expectOfEveryPair(grid::threadsDefect);
}

// One pair is too small for a second thread: so many pairs side by side are one run.
TEST(GridPolyhedra, manyPairsSideBySideAreTheSameForAnyNumberOfThreads) {
	constexpr std::uint32_t kBeside = 200;
	for (std::uint32_t first = 0; first < askedInputs(1000); first += kBeside) {
		SCOPED_TRACE("seeds from " + std::to_string(first));
		GridMesh a, b;
		double sixVolume = 0;
		for (std::uint32_t i = 0; i < kBeside; ++i) {
			const SolidPair pair = grid::randomPair(first + i);
			const grid::IntPoint place{16 * (i % 6), 16 * (i / 6 % 6), 16 * (i / 36)};
			a = grid::concatenated(a, moved(pair.a, place));
			b = grid::concatenated(b, moved(pair.b, place));
			sixVolume += grid::sixVolumeOfBoth(pair.a, pair.b).toDouble();
		}
		Options options;
		options.threads = 1;
		const BooleanRun one = run(meshOf(a), meshOf(b), options);
		ASSERT_EQ(grid::promisesDefect(one), "");
		EXPECT_NEAR(one.volume(Operation::Intersection), sixVolume / 6, 1e-6);
		for (const int threads : {2, 8}) {
			options.threads = threads;
			const BooleanRun other = run(meshOf(a), meshOf(b), options);
			ASSERT_TRUE(other.status.ok());
			for (std::size_t k = 0; k < kOperationCount; ++k) {
				EXPECT_EQ(one.blocks[k].points, other.blocks[k].points);
				EXPECT_EQ(one.blocks[k].triangles, other.blocks[k].triangles);
			}
		}
	}
}

// --- pairs that once failed ---------------------------------------------------------------------

// Edges with four faces whose twins are known: where one of the four has all its corners among
// vertices without other faces, the curve must not go along the edge with the other three.
SolidPair pairWithEdgesOfFourCommonFaces() {
	SolidPair pair;
	pair.a.points = {{0, 0, 1}, {2, 0, 1}, {2, 1, 1}, {0, 1, 1}, {0, 1, 0},
	                 {2, 0, 0}, {2, 0, 2}, {3, 0, 1}, {2, 1, 2}, {2, 1, 0},
	                 {0, 3, 1}, {0, 1, 2}, {2, 3, 1}, {3, 3, 1}, {3, 1, 1}};
	pair.a.triangles = {{0, 1, 2},   {0, 2, 3},   {0, 3, 4},   {0, 4, 5},   {0, 5, 1},   {6, 1, 7},
	                    {6, 2, 1},   {6, 7, 8},   {6, 8, 2},   {1, 2, 7},   {1, 5, 9},   {1, 9, 2},
	                    {2, 3, 10},  {2, 4, 3},   {2, 8, 11},  {2, 9, 4},   {2, 10, 12}, {2, 11, 3},
	                    {2, 12, 13}, {2, 13, 14}, {2, 14, 7},  {3, 11, 10}, {4, 9, 5},   {7, 14, 8},
	                    {8, 10, 11}, {8, 12, 10}, {8, 13, 12}, {8, 14, 13}};
	pair.b.points = {{2, 0, 0}, {2, 0, 1}, {0, 0, 1}, {0, 1, 0}, {2, 1, 0}, {2, 1, 1},
	                 {3, 0, 1}, {2, 0, 2}, {0, 1, 1}, {3, 0, 3}, {0, 1, 2}, {2, 1, 2},
	                 {0, 3, 1}, {2, 3, 1}, {3, 3, 1}, {3, 1, 1}};
	pair.b.triangles = {
	    {0, 1, 2},   {0, 2, 3},   {0, 3, 4},   {0, 4, 1},  {1, 4, 5},  {1, 5, 2},   {1, 5, 6},
	    {1, 6, 7},   {1, 7, 5},   {2, 5, 8},   {2, 7, 9},  {2, 8, 3},  {2, 9, 10},  {2, 10, 7},
	    {3, 5, 4},   {3, 8, 5},   {5, 7, 11},  {5, 8, 12}, {5, 10, 8}, {5, 11, 10}, {5, 12, 13},
	    {5, 13, 14}, {5, 14, 15}, {5, 15, 6},  {6, 9, 7},  {6, 15, 9}, {7, 10, 11}, {8, 10, 12},
	    {9, 12, 10}, {9, 13, 12}, {9, 14, 13}, {9, 15, 14}};
	return pair;
}

TEST(GridPolyhedra, edgesOfFourCommonFacesAreRight) {
	const SolidPair pair = pairWithEdgesOfFourCommonFaces();
	Options options;
	options.threads = 1;
	for (const Property defect :
	     {grid::measuresDefect, grid::deliveryDefect, grid::swapDefect, grid::numberingDefect}) {
		EXPECT_EQ(defect(pair, options), "");
	}
	EXPECT_TRUE(run(meshOf(pair.a), meshOf(pair.b), options).status.ok());
}

// --- the test's own tools ----------------------------------------------------------------------

TEST(GridOracle, doesNotDependOnTheAxisNorOnTheOrder) {
	for (std::uint32_t seed = 0; seed < 300; ++seed) {
		const SolidPair pair = grid::randomPair(seed);
		const Rational both = grid::sixVolumeOfBoth(pair.a, pair.b);
		EXPECT_EQ(both, grid::sixVolumeOfBoth(pair.a, pair.b, 0)) << "seed " << seed;
		EXPECT_EQ(both, grid::sixVolumeOfBoth(pair.a, pair.b, 1)) << "seed " << seed;
		EXPECT_EQ(both, grid::sixVolumeOfBoth(pair.b, pair.a)) << "seed " << seed;
		EXPECT_EQ(grid::sixVolumeOfBoth(pair.a, pair.a), grid::sixVolume(pair.a));
	}
}

GridMesh gridBox(const grid::IntPoint& low, const grid::IntPoint& high) {
	GridMesh m;
	for (const Point& p : shapes::box({0, 0, 0}, {1, 1, 1}).points) {
		m.points.push_back({p[0] == 0 ? low[0] : high[0], p[1] == 0 ? low[1] : high[1],
		                    p[2] == 0 ? low[2] : high[2]});
	}
	m.triangles = shapes::box({0, 0, 0}, {1, 1, 1}).triangles;
	return m;
}

TEST(GridOracle, knowsClosedForms) {
	const GridMesh a = gridBox({0, 0, 0}, {4, 4, 4}), b = gridBox({3, 2, 4}, {8, 8, 8}),
	               c = gridBox({3, 2, 1}, {4, 8, 8});
	const GridMesh tip{{{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {0, 0, 8}},
	                   {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
	EXPECT_EQ(grid::sixVolumeOfBoth(a, b), 0);
	EXPECT_EQ(grid::sixVolumeOfBoth(a, c), 6 * 1 * 2 * 3);
	EXPECT_EQ(grid::sixVolumeOfBoth(a, tip), 6 * 64 - 64);  // but for the corner beyond x+y+z = 8
	EXPECT_EQ(grid::commonWalls(a, b).oppositeWay, 2 * 1 * 2);
	EXPECT_EQ(grid::commonWalls(a, b).sameWay, 0);
	EXPECT_EQ(grid::commonWalls(a, c).sameWay, 2 * 2 * 3);
}

TEST(GridOracle, refusesWhatIsNoSolid) {
	const GridMesh large = gridBox({0, 0, 0}, {6, 6, 6}), small = gridBox({1, 1, 1}, {2, 2, 2});
	EXPECT_TRUE(isSolid(large));
	EXPECT_FALSE(isSolid(turned(large)));
	EXPECT_FALSE(isSolid(grid::concatenated(large, small))) << "nested";
	EXPECT_TRUE(isSolid(grid::concatenated(large, turned(small)))) << "a cavity";
	EXPECT_FALSE(isSolid(grid::concatenated(large, gridBox({5, 5, 5}, {7, 7, 7})))) << "overlap";
	EXPECT_FALSE(isSolid(grid::concatenated(large, gridBox({6, 1, 1}, {7, 2, 2})))) << "on a face";
	GridMesh open = large;
	open.triangles.pop_back();
	EXPECT_FALSE(isSolid(open));
}

// How often each kind of degeneracy occurs in the pairs.
struct Census {
	int fourFaceEdges = 0, components = 0, identical = 0, allCornersOnOther = 0;
	int touchingOnly = 0, apart = 0, sameWalls = 0, oppositeWalls = 0;
	int cornerOnCorner = 0, cornerOnEdge = 0, cornerOnFace = 0, edgesCross = 0, edgePiercesFace = 0;

	void addOperand(const GridMesh& m) {
		std::map<std::array<std::uint32_t, 2>, int> faces;
		for (const grid::Corners& t : m.triangles) {
			for (std::size_t i = 0; i < 3; ++i) {
				++faces[{std::min(t[i], t[(i + 1) % 3]), std::max(t[i], t[(i + 1) % 3])}];
			}
		}
		fourFaceEdges +=
		    std::any_of(faces.begin(), faces.end(), [](const auto& e) { return e.second > 2; }) ? 1
		                                                                                        : 0;
	}

	void addContacts(const SolidPair& pair, const BooleanRun& r) {
		const auto countNames = [&r](PointKind kind) {
			const auto& names = r.arrangement.curve.names;
			return std::any_of(names.begin(), names.end(),
			                   [kind](const PointName& n) { return n.kind == kind; })
			           ? 1
			           : 0;
		};
		edgesCross += countNames(PointKind::EdgeEdge);
		edgePiercesFace += countNames(PointKind::EdgeFace);
		bool touches = !r.arrangement.curve.names.empty();
		for (const auto& [one, other] :
		     {std::pair(&pair.a, &pair.b), std::pair(&pair.b, &pair.a)}) {
			std::size_t on = 0;
			for (const grid::IntPoint& p : one->points) {
				on += grid::isOnSurface(*other, p) ? 1U : 0U;
				const bool common = std::count(other->points.begin(), other->points.end(), p) != 0;
				cornerOnCorner += common ? 1 : 0;
				cornerOnEdge += !common && grid::isOnEdge(*other, p) ? 1 : 0;
				cornerOnFace += !grid::isOnEdge(*other, p) && grid::isOnSurface(*other, p) ? 1 : 0;
			}
			touches = touches || on > 0;
			allCornersOnOther += on == one->points.size() ? 1 : 0;
		}
		const bool apartInside = r.block(Operation::Intersection).triangles.empty();
		touchingOnly += touches && apartInside ? 1 : 0;
		apart += !touches && apartInside ? 1 : 0;
	}
};

TEST(GridPolyhedra, everyDegeneracyOccurs) {
	Census census;
	for (std::uint32_t seed = 0; seed < 400; ++seed) {
		const SolidPair pair = grid::randomPair(seed);
		const BooleanRun r = run(meshOf(pair.a), meshOf(pair.b));
		ASSERT_TRUE(r.status.ok()) << "seed " << seed;
		census.addOperand(pair.a);
		census.addOperand(pair.b);
		census.addContacts(pair, r);
		census.components += r.arrangement.labels.components[kFirst] > 1 ? 1 : 0;
		const grid::CommonWalls walls = grid::commonWalls(pair.a, pair.b);
		census.sameWalls += walls.sameWay != 0 ? 1 : 0;
		census.oppositeWalls += walls.oppositeWay != 0 ? 1 : 0;
		census.identical += r.block(Operation::SymmetricDifference).triangles.empty() ? 1 : 0;
	}
	for (const auto& [what, count] :
	     {std::pair("edges with four faces", census.fourFaceEdges),
	      std::pair("several components", census.components),
	      std::pair("the same solid twice", census.identical),
	      std::pair("all corners on the other", census.allCornersOnOther),
	      std::pair("touching only", census.touchingOnly), std::pair("apart", census.apart),
	      std::pair("walls that face the same way", census.sameWalls),
	      std::pair("walls that face each other", census.oppositeWalls),
	      std::pair("corner on corner", census.cornerOnCorner),
	      std::pair("corner on edge", census.cornerOnEdge),
	      std::pair("corner on face", census.cornerOnFace),
	      std::pair("edges that cross", census.edgesCross),
	      std::pair("an edge that pierces a face", census.edgePiercesFace)}) {
		EXPECT_GE(count, 5) << what;
		RecordProperty(what, count);
	}
}

}  // namespace
}  // namespace index_boolean
