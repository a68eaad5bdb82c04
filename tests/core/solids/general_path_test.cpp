// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Of two embedded solids, blocks read from cells (the general path) are the blocks read from labels
// (the fast path): the one has nothing in common with the other behind the arrangement.
#include "core/any_operands.h"
#include "support/asked_inputs.h"
#include "support/grid_polyhedra.h"
#include "support/grid_properties.h"

#include <gtest/gtest.h>

namespace index_boolean {
namespace {

using namespace shapes;

constexpr std::array<Operation, kOperationCount> kOperations{
    Operation::Union, Operation::Intersection, Operation::FirstMinusSecond,
    Operation::SecondMinusFirst, Operation::SymmetricDifference};

CellPredicate predicateOf(Operation operation) {
	return [operation](const Windings& w) {
		const bool a = isIn(w, 0), b = isIn(w, 1);
		switch (operation) {
		case Operation::Union:
			return a || b;
		case Operation::Intersection:
			return a && b;
		case Operation::FirstMinusSecond:
			return a && !b;
		case Operation::SecondMinusFirst:
			return b && !a;
		case Operation::SymmetricDifference:
			return a != b;
		}
		return false;
	};
}

double areaOf(const Block& block) {
	long double sum = 0;
	for (const IndexTriangle& t : block.triangles) {
		const Point &a = block.points[t[0]], &b = block.points[t[1]], &c = block.points[t[2]];
		long double squares = 0;
		for (std::size_t k = 0; k < 3; ++k) {
			const std::size_t x = (k + 1) % 3, y = (k + 2) % 3;
			const long double n = static_cast<long double>(b[x] - a[x]) * (c[y] - a[y]) -
			                      static_cast<long double>(b[y] - a[y]) * (c[x] - a[x]);
			squares += n * n;
		}
		sum += std::sqrt(squares) / 2;
	}
	return static_cast<double>(sum);
}

// Pairs of runs with the same options; nothing is copied, so that every vertex has its name.
struct BothPaths {
	BooleanRun fast;
	CellsRun general;

	BothPaths(const Mesh& a, const Mesh& b, bool mergeFragments) {
		Options options = asCut();
		options.mergeFragments = mergeFragments;
		fast = run(a, b, options);
		general = runCells({a, b}, options);
	}
};

// \param compare of the two blocks of each operation
template <class Compare>
void expectSameBlocks(const Mesh& a, const Mesh& b, Compare&& compare) {
	for (const bool mergeFragments : {false, true}) {
		const BothPaths paths(a, b, mergeFragments);
		ASSERT_TRUE(paths.fast.status.ok()) << describe(paths.fast.status);
		ASSERT_TRUE(paths.general.status.ok());
		for (const Operation operation : kOperations) {
			SCOPED_TRACE(std::string(operationName(operation)) +
			             (mergeFragments ? ", merged" : ", as cut"));
			const Block& fast = paths.fast.block(operation);
			const Block general = blockOf(paths.general, predicateOf(operation));
			EXPECT_EQ(brokenPromise(general), "");
			const SelfContact fastContact(fast), generalContact(general);
			EXPECT_EQ(generalContact.components(), fastContact.components());
			EXPECT_EQ(generalContact.pinches(), fastContact.pinches());
			if (!mergeFragments) {
				EXPECT_EQ(general.triangles.size(), fast.triangles.size());
				EXPECT_EQ(generalContact.edgesOfMoreThanTwo(), fastContact.edgesOfMoreThanTwo());
			}
			compare(paths, fast, general);
		}
	}
}

void expectNearBlocks(const BothPaths&, const Block& fast, const Block& general) {
	const double volume = volumeOf(fast.points, fast.triangles), area = areaOf(fast);
	EXPECT_NEAR(volumeOf(general.points, general.triangles), volume, 1e-12 * volume);
	EXPECT_NEAR(areaOf(general), area, 1e-12 * area);
}

// In rational numbers, by the names of the vertices.
void expectEqualBlocks(const BothPaths& paths, const Block& fast, const Block& general) {
	ASSERT_TRUE(grid::allVerticesHaveNames(fast));
	ASSERT_TRUE(grid::allVerticesHaveNames(general));
	const grid::ExactMeasure expected = grid::exactMeasure(paths.fast.arrangement, fast);
	const grid::ExactMeasure found = grid::exactMeasure(paths.general.arrangement, general);
	EXPECT_EQ(found.sixVolume.text(), expected.sixVolume.text());
	EXPECT_EQ(found.doubleProjections.text(), expected.doubleProjections.text());
}

TEST(GeneralPath, hasTheBlocksOfTheFastOneOfGridSolids) {
	for (std::uint32_t seed = 0; seed < askedInputs(2000) && !HasFailure(); ++seed) {
		const grid::SolidPair pair = grid::randomPair(seed);
		SCOPED_TRACE("seed " + std::to_string(seed) + "\nA: " + grid::text(pair.a) +
		             "\nB: " + grid::text(pair.b));
		expectSameBlocks(grid::meshOf(pair.a), grid::meshOf(pair.b), expectEqualBlocks);
	}
}

TEST(GeneralPath, hasTheBlocksOfTheFastOneOfBoxesInContact) {
	const Mesh unit = box({0, 0, 0}, {1, 1, 1});
	for (const Mesh& other :
	     {unit, box({1, 0, 0}, {2, 1, 1}), box({1, 1, 0}, {2, 2, 1}), box({1, 1, 1}, {2, 2, 2}),
	      box({0.25, 0.25, 0}, {0.5, 0.5, 1}), box({-1, 0.5, 0.5}, {2, 0.75, 1}),
	      box({1, 0.25, 0.25}, {2, 0.75, 0.75}), box({0, 0, 0}, {0.5, 0.5, 0.5}),
	      box({0.5, 0.5, 0.5}, {2, 2, 1}), box({0.5, 0, 0}, {1.5, 1, 1}),
	      box({-1, -1, 0}, {2, 2, 0.5}), box({0.25, 0.25, 0.25}, {0.5, 0.5, 0.5}),
	      box({5, 5, 5}, {6, 6, 6}), turned(box({0.5, 0.5, 0.5}, {2, 2, 2}))}) {
		expectSameBlocks(unit, other, expectNearBlocks);
		expectSameBlocks(other, unit, expectNearBlocks);
	}
}

TEST(GeneralPath, hasTheBlocksOfTheFastOneOfRoundSolids) {
	for (std::uint32_t seed = 0; seed < 60 && !HasFailure(); ++seed) {
		SCOPED_TRACE("seed " + std::to_string(seed));
		std::mt19937 random(seed);
		const auto solid = [&random](std::uint32_t kind) {
			const auto n = static_cast<std::uint32_t>(5 + random() % 12);
			return placed(kind == 0   ? sphere(n, {0, 0, 0}, 1)
			              : kind == 1 ? torus(n, n, 1, 0.4)
			                          : box({-1, -0.75, -0.5}, {0.75, 1, 1}),
			              random, 0.6);
		};
		const Mesh a = solid(seed % 3), b = solid(seed / 3 % 3);
		expectSameBlocks(a, b, expectNearBlocks);
	}
}

TEST(GeneralPath, hasTheCellsOfTheSplit) {
	for (std::uint32_t seed = 0; seed < askedInputs(2000) && !HasFailure(); ++seed) {
		const grid::SolidPair pair = grid::randomPair(seed);
		SCOPED_TRACE("seed " + std::to_string(seed) + "\nA: " + grid::text(pair.a) +
		             "\nB: " + grid::text(pair.b));
		const Mesh a = grid::meshOf(pair.a), b = grid::meshOf(pair.b);
		Arrangement arrangement;
		Split parts;
		Monitor monitor;
		ASSERT_TRUE(arrangeSurfaces(arrays(a, b), onOneThread(), monitor, arrangement).ok());
		ASSERT_TRUE(split(arrangement, monitor, parts).ok());
		std::vector<std::pair<std::vector<std::int32_t>, double>> expected;
		for (const SubBlock& part : parts.blocks.all) {
			expected.emplace_back(
			    std::vector<std::int32_t>{part.windings[kFirst], part.windings[kSecond]},
			    part.volume);
		}
		std::sort(expected.begin(), expected.end());
		const auto found = runCells({a, b}).cells();
		ASSERT_EQ(found.size(), expected.size());
		for (std::size_t i = 0; i < found.size(); ++i) {
			EXPECT_EQ(found[i].first, expected[i].first);
			EXPECT_NEAR(found[i].second, expected[i].second, 1e-9);
		}
	}
}

}  // namespace
}  // namespace index_boolean
