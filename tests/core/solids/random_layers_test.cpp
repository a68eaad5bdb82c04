// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Two to four random layers, each of one to three solids that overlap, repeat, contain or touch
// each other, on a small integer grid. Of boxes, cells and blocks are compared with counted unit
// cubes; of other solids, what is linear and quadratic in winding numbers with integrals over the
// input. 200 inputs, or as many as INDEXBOOLEAN_FUZZ_PAIRS says; input n is made from the seed n.
#include "core/any_operands.h"
#include "support/asked_inputs.h"
#include "support/grid_polyhedra.h"
#include "support/grid_properties.h"
#include "support/voxel_oracle.h"

#include <gtest/gtest.h>

namespace index_boolean {
namespace {

using grid::GridMesh;
using shapes::blockOf;
using shapes::CellsRun;
using shapes::Mesh;
using shapes::SelfContact;
using shapes::Windings;
using voxels::BoxLayer;
using voxels::SignedBox;

// Whether a point is in a block, by whether it is in each operand.
struct Expression {
	const char* name;
	CellPredicate isInside;
};

const std::vector<Expression>& expressions() {
	static const std::vector<Expression> all{
	    {"union", shapes::inAny},
	    {"intersection", shapes::inAll},
	    {"an odd number", shapes::inOddNumber},
	    {"two or more", shapes::inTwoOrMore},
	    {"the first without the others", shapes::inFirstAlone},
	    {"the first, more than once", shapes::atLeast(2)},
	};
	return all;
}

std::vector<std::int32_t> vectorOf(const Windings& w) { return {w.begin(), w.end()}; }

Windings windingsOf(const std::vector<std::int32_t>& w) {
	Windings windings(w.size());
	std::copy(w.begin(), w.end(), windings.begin());
	return windings;
}

// --- boxes --------------------------------------------------------------------------------------

constexpr int kSpan = 5;

SignedBox randomBox(grid::Random& random) {
	SignedBox box{};
	for (std::size_t k = 0; k < 3; ++k) {
		const auto a = static_cast<int>(random.below(kSpan)), b = static_cast<int>(random.below(4));
		box.low[k] = a;
		box.high[k] = std::min(a + 1 + b, kSpan);
	}
	box.sign = random.oneIn(5) ? -1 : 1;
	return box;
}

// Another random box, the same one, one that it touches, or one that it is shifted from.
SignedBox boxRelatedTo(const SignedBox& other, grid::Random& random) {
	SignedBox box = randomBox(random);
	const std::size_t axis = random.index(3);
	switch (random.below(5)) {
	case 0:
		box.low = other.low;
		box.high = other.high;
		break;
	case 1:
		if (other.high[axis] < kSpan) {
			box.low[axis] = other.high[axis];
			box.high[axis] = kSpan;
		}
		break;
	case 2:
		box.low = other.low;
		box.high = other.high;
		box.low[axis] = static_cast<int>(random.below(box.high[axis]));
		break;
	default:
		break;
	}
	return box;
}

std::vector<BoxLayer> randomBoxLayers(grid::Random& random) {
	std::vector<BoxLayer> layers(2 + random.index(3));
	SignedBox last = randomBox(random);
	for (BoxLayer& layer : layers) {
		for (std::int64_t parts = 1 + random.below(3); parts > 0; --parts) {
			last = boxRelatedTo(last, random);
			layer.push_back(last);
		}
	}
	return layers;
}

// Four of its faces are cut by one diagonal or by the other.
Mesh meshOf(const SignedBox& box, bool otherDiagonals) {
	Point low{}, high{};
	for (std::size_t k = 0; k < 3; ++k) {
		low[k] = box.low[k];
		high[k] = box.high[k];
	}
	if (otherDiagonals) {
		std::swap(low[0], high[0]);
	}
	const Mesh m = shapes::box(low, high);
	return otherDiagonals == (box.sign < 0) ? m : turned(m);
}

std::vector<Mesh> meshesOf(const std::vector<BoxLayer>& layers, grid::Random& random) {
	std::vector<Mesh> meshes;
	for (const BoxLayer& layer : layers) {
		std::vector<Mesh> parts;
		for (const SignedBox& box : layer) {
			parts.push_back(meshOf(box, random.oneIn(2)));
		}
		meshes.push_back(shapes::layer(parts));
	}
	return meshes;
}

std::string text(const std::vector<BoxLayer>& layers) {
	std::string s;
	for (const BoxLayer& layer : layers) {
		s += "\nlayer:";
		for (const SignedBox& box : layer) {
			s += box.sign > 0 ? " +" : " -";
			for (std::size_t k = 0; k < 3; ++k) {
				s += '[' + std::to_string(box.low[k]) + ',' + std::to_string(box.high[k]) + ']';
			}
		}
	}
	return s;
}

// \param body of the meshes, and what is counted of them
template <class Body>
void forEachBoxInput(Body&& body) {
	for (std::uint32_t seed = 0; seed < askedInputs(200) && !testing::Test::HasFailure(); ++seed) {
		grid::Random random(seed);
		const std::vector<BoxLayer> layers = randomBoxLayers(random);
		SCOPED_TRACE("seed " + std::to_string(seed) + text(layers));
		body(meshesOf(layers, random), voxels::Oracle(layers, kSpan));
	}
}

TEST(RandomLayers, boxesHaveTheCellsOfTheirUnitCubes) {
	forEachBoxInput([](const std::vector<Mesh>& meshes, const voxels::Oracle& oracle) {
		const CellsRun r = shapes::runCells(meshes);
		ASSERT_TRUE(r.status.ok());
		for (const bool isClosed : r.arrangement.closed) {
			EXPECT_TRUE(isClosed);
		}
		const auto expected = oracle.cells();
		auto found = r.cells();
		for (auto& cell : found) {
			EXPECT_NEAR(cell.second, std::round(cell.second), 1e-9);
			cell.second = std::round(cell.second);
		}
		std::sort(found.begin(), found.end());
		EXPECT_EQ(found, expected);
	});
}

TEST(RandomLayers, boxesHaveTheBlocksOfTheirUnitCubes) {
	forEachBoxInput([](const std::vector<Mesh>& meshes, const voxels::Oracle& oracle) {
		for (const bool isAsCut : {true, false}) {
			const CellsRun r =
			    shapes::runCells(meshes, isAsCut ? shapes::asCut() : shapes::onOneThread());
			ASSERT_TRUE(r.status.ok());
			for (const Expression& e : expressions()) {
				SCOPED_TRACE(std::string(e.name) + (isAsCut ? ", as cut" : ""));
				const auto isInside = [&e](const std::vector<std::int32_t>& w) {
					return e.isInside(windingsOf(w));
				};
				const Block block = blockOf(r, e.isInside);
				EXPECT_EQ(brokenPromise(block), "");
				// Integers all three; where diagonals cross, coordinates are rounded.
				EXPECT_NEAR(shapes::volumeOf(block.points, block.triangles),
				            oracle.volume(isInside), 1e-9);
				EXPECT_NEAR(shapes::doubleProjectionsOf(block), 2 * oracle.area(isInside), 1e-9);
				if (isAsCut) {
					EXPECT_NEAR(SelfContact(block).lengthOfMoreThanTwo(),
					            oracle.lengthOfFourWalls(isInside), 1e-9);
				} else {
					EXPECT_TRUE(shapes::isManifold(block.triangles));
				}
			}
		}
	});
}

// --- other solids -------------------------------------------------------------------------------

// Layers of solids that all look outward or all inward, so that no winding numbers cancel.
struct SolidLayers {
	std::vector<GridMesh> operands;
	std::vector<bool> isTurned;

	explicit SolidLayers(std::uint32_t seed) {
		constexpr std::array<std::int64_t, 4> kSpans{2, 3, 4, 6};
		grid::Generator generator(grid::Random(seed), kSpans[seed % kSpans.size()]);
		grid::Random& random = generator.random();
		operands.resize(2 + random.index(3));
		GridMesh last = generator.solid();
		for (GridMesh& operand : operands) {
			for (std::int64_t parts = 1 + random.below(3); parts > 0; --parts) {
				last = random.oneIn(2) ? generator.solid() : generator.solidRelatedTo(last);
				operand = grid::concatenated(operand, last);
			}
			isTurned.push_back(random.oneIn(6));
		}
	}

	std::vector<Mesh> meshes() const {
		std::vector<Mesh> all;
		for (std::size_t k = 0; k < operands.size(); ++k) {
			const Mesh m = grid::meshOf(operands[k]);
			all.push_back(isTurned[k] ? turned(m) : m);
		}
		return all;
	}
	std::string text() const {
		std::string s;
		for (std::size_t k = 0; k < operands.size(); ++k) {
			s += (isTurned[k] ? "\nturned: " : "\nlayer: ") + grid::text(operands[k]);
		}
		return s;
	}
};

// The sum over all cells of volume times a function of the windings.
template <class Value>
double sumOverCells(const CellsRun& r, Value&& value) {
	double sum = 0;
	for (const auto& [windings, volume] : r.cells()) {
		sum += volume * value(windings);
	}
	return sum;
}

void expectIntegralsOfTheInput(const CellsRun& r, const SolidLayers& layers) {
	for (std::size_t a = 0; a < layers.operands.size(); ++a) {
		const auto one = [a](const std::vector<std::int32_t>& w) { return w[a]; };
		const auto sixVolume = static_cast<double>(grid::sixVolume(layers.operands[a]));
		EXPECT_NEAR(6 * sumOverCells(r, one), sixVolume, 1e-9 * sixVolume) << "operand " << a;
		for (std::size_t b = 0; b <= a; ++b) {
			const auto both = [a, b](const std::vector<std::int32_t>& w) { return w[a] * w[b]; };
			const double expected =
			    grid::sixVolumeOfBoth(layers.operands[a], layers.operands[b]).toDouble();
			EXPECT_NEAR(6 * sumOverCells(r, both), expected, 1e-9 * (expected + 1))
			    << "operands " << a << " and " << b;
		}
	}
}

TEST(RandomLayers, cellsHaveTheIntegralsOfTheInput) {
	for (std::uint32_t seed = 0; seed < askedInputs(200) && !HasFailure(); ++seed) {
		const SolidLayers layers(seed);
		SCOPED_TRACE("seed " + std::to_string(seed) + layers.text());
		const CellsRun r = shapes::runCells(layers.meshes());
		ASSERT_TRUE(r.status.ok());
		expectIntegralsOfTheInput(r, layers);
		for (const auto& [windings, volume] : r.cells()) {
			EXPECT_GT(volume, 0);
			EXPECT_GE(*std::min_element(windings.begin(), windings.end()), 0);
		}
	}
}

TEST(RandomLayers, blocksKeepTheirPromisesAndHaveTheVolumeOfTheirCells) {
	for (std::uint32_t seed = 0; seed < askedInputs(200) && !HasFailure(); ++seed) {
		const SolidLayers layers(seed);
		SCOPED_TRACE("seed " + std::to_string(seed) + layers.text());
		Options options = shapes::onOneThread();
		options.mergeFragments = seed % 2 == 0;
		options.mergeCoplanar = seed % 3 == 0;
		const CellsRun r = shapes::runCells(layers.meshes(), options);
		ASSERT_TRUE(r.status.ok());
		for (const Expression& e : expressions()) {
			SCOPED_TRACE(e.name);
			const Block block = blockOf(r, e.isInside);
			EXPECT_EQ(brokenPromise(block), "");
			EXPECT_TRUE(shapes::isManifold(block.triangles));
			const double volume = r.volumeWhere(e.isInside);
			EXPECT_NEAR(shapes::volumeOf(block.points, block.triangles), volume,
			            1e-9 * (volume + 1));
		}
	}
}

// --- invariance ---------------------------------------------------------------------------------

// The block of an expression, its operands given in another order.
std::vector<std::array<Point, 3>> blockInOrder(const std::vector<Mesh>& meshes,
                                               const std::vector<std::size_t>& order,
                                               const CellPredicate& isInside) {
	std::vector<Mesh> ordered;
	for (const std::size_t k : order) {
		ordered.push_back(meshes[k]);
	}
	const auto isInsideOrdered = [&](const Windings& w) {
		const std::vector<std::int32_t> given = vectorOf(w);
		std::vector<std::int32_t> straight(given.size());
		for (std::size_t i = 0; i < order.size(); ++i) {
			straight[order[i]] = given[i];
		}
		return isInside(windingsOf(straight));
	};
	return shapes::geometry(blockOf(shapes::runCells(ordered), isInsideOrdered));
}

void expectTheSameInAnyOrder(std::vector<Mesh> meshes) {
	while (meshes.size() < 3) {
		meshes.push_back(meshes.front());
	}
	meshes.resize(3);
	for (const Expression& e : expressions()) {
		SCOPED_TRACE(e.name);
		std::vector<std::size_t> order{0, 1, 2};
		const auto straight = blockInOrder(meshes, order, e.isInside);
		while (std::next_permutation(order.begin(), order.end())) {
			EXPECT_EQ(blockInOrder(meshes, order, e.isInside), straight)
			    << order[0] << order[1] << order[2];
		}
	}
}

TEST(RandomLayers, threeOperandsGiveTheSameTrianglesInAnyOrder) {
	for (std::uint32_t seed = 0; seed < (askedInputs(200) + 9) / 10 && !HasFailure(); ++seed) {
		grid::Random random(seed);
		const std::vector<BoxLayer> boxes = randomBoxLayers(random);
		{
			SCOPED_TRACE("boxes of seed " + std::to_string(seed) + text(boxes));
			expectTheSameInAnyOrder(meshesOf(boxes, random));
		}
		const SolidLayers solids(seed);
		SCOPED_TRACE("solids of seed " + std::to_string(seed) + solids.text());
		expectTheSameInAnyOrder(solids.meshes());
	}
}

TEST(RandomLayers, anyNumberOfThreadsGivesTheSameBytes) {
	for (std::uint32_t seed = 0; seed < (askedInputs(200) + 9) / 10 && !HasFailure(); ++seed) {
		const SolidLayers layers(seed);
		SCOPED_TRACE("seed " + std::to_string(seed) + layers.text());
		Options options;
		options.threads = 1;
		const CellsRun one = shapes::runCells(layers.meshes(), options);
		options.threads = 8;
		const CellsRun other = shapes::runCells(layers.meshes(), options);
		EXPECT_EQ(one.arrangement.cells.volume, other.arrangement.cells.volume);
		for (const Expression& e : expressions()) {
			const Block block = blockOf(one, e.isInside), again = blockOf(other, e.isInside);
			EXPECT_EQ(block.points, again.points);
			EXPECT_EQ(block.triangles, again.triangles);
		}
	}
}

}  // namespace
}  // namespace index_boolean
