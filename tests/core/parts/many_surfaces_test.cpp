// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Any number of surfaces split by each other: cells against closed forms and against the split of
// two, walls that no winding number changes across, and what must not depend on the order.
#include "core/split_operands.h"

#include <gtest/gtest.h>

namespace index_boolean {
namespace {

using namespace shapes;

// --- five sheets in a block ---------------------------------------------------------------------

// a x + b y = c
struct Line {
	double a, b, c;
};
using Polygon = std::vector<PlanePoint>;

// The part of a convex polygon to one side of a line.
Polygon halfOf(const Polygon& polygon, const Line& line, double side) {
	const auto height = [&](const PlanePoint& p) {
		return side * (line.a * p[0] + line.b * p[1] - line.c);
	};
	Polygon part;
	for (std::size_t i = 0; i < polygon.size(); ++i) {
		const PlanePoint &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
		const double h = height(p), k = height(q);
		if (h >= 0) {
			part.push_back(p);
		}
		if (h * k < 0) {
			const double t = h / (h - k);
			part.push_back({p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])});
		}
	}
	return part;
}

double areaOf(const Polygon& polygon) {
	double twice = 0;
	for (std::size_t i = 0; i < polygon.size(); ++i) {
		const PlanePoint &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
		twice += p[0] * q[1] - p[1] * q[0];
	}
	return twice / 2;
}

constexpr double kSide = 8, kLevel = 5;
constexpr std::array<Line, 4> kLines{{{1, 0, 2}, {0, 1, 3}, {1, -1, 0}, {1, 1, 8}}};

// The areas of the cells that the lines cut the square into. All corners are integers.
std::vector<double> cellAreas() {
	std::vector<Polygon> cells{{{0, 0}, {kSide, 0}, {kSide, kSide}, {0, kSide}}};
	for (const Line& line : kLines) {
		std::vector<Polygon> parts;
		for (const Polygon& cell : cells) {
			for (const double side : {1., -1.}) {
				parts.push_back(halfOf(cell, line, side));
			}
		}
		cells = std::move(parts);
	}
	std::vector<double> areas;
	for (const Polygon& cell : cells) {
		if (areaOf(cell) > 0) {
			areas.push_back(areaOf(cell));
		}
	}
	return areas;
}

// Upright over one of the lines, well beyond the block.
Mesh sheetOver(const PlanePoint& p, const PlanePoint& q) {
	return rectangle({p[0], p[1], -1}, {q[0], q[1], -1}, {q[0], q[1], 9}, {p[0], p[1], 9});
}

std::vector<Mesh> blockAndFiveSheets() {
	return {box({0, 0, 0}, {kSide, kSide, kSide}),
	        sheetOver({2, -1}, {2, 9}),
	        sheetOver({-1, 3}, {9, 3}),
	        sheetOver({-1, -1}, {9, 9}),
	        sheetOver({-1, 9}, {9, -1}),
	        level(-2, 10, kLevel)};
}

TEST(ManySurfaces, fiveSheetsCutABlockIntoPrisms) {
	const OperandsSplit r = splitAll(blockAndFiveSheets());
	ASSERT_TRUE(r.status.ok()) << describe(r.status);
	std::vector<double> expected;
	for (const double area : cellAreas()) {
		expected.push_back(area * kLevel);
		expected.push_back(area * (kSide - kLevel));
	}
	std::sort(expected.begin(), expected.end());
	ASSERT_EQ(expected.size(), 22u);  // 11 cells of the square
	EXPECT_EQ(r.volumes(), expected);
	EXPECT_LT(r.audit.volumeLawResidual, 1e-15);
	for (const SubBlock& block : r.split.blocks.all) {
		EXPECT_EQ(block.windings, (Windings{1, 0, 0, 0, 0, 0}));
	}
	for (std::size_t i = 0; i < r.blocks.size(); ++i) {
		EXPECT_TRUE(isClosed(r.blocks[i].triangles));
		EXPECT_EQ(volumeOf(r.blocks[i].points, r.blocks[i].triangles),
		          r.split.blocks.all[i].volume);
		EXPECT_EQ(r.blocks[i].certificate.count(), 0);
	}
	// The level sheet: the 11 cells, and what is around them, in which the cuts end.
	EXPECT_EQ(r.surfaceCount(5), 12u);
}

// --- the same in any order ----------------------------------------------------------------------

// Each block, with the operands that it is in by the places in the list as it was at first.
using BlockPlaces = std::vector<std::pair<Triangles3, std::vector<std::int32_t>>>;

struct Geometry {
	BlockPlaces blocks;
	std::vector<std::vector<Triangles3>> surfaces;  // per operand and sub-surface
	friend bool operator==(const Geometry& a, const Geometry& b) {
		return a.blocks == b.blocks && a.surfaces == b.surfaces;
	}
};

// \param order the operand k of the run is the operand order[k] of the list
Geometry geometryOf(const OperandsSplit& r, const std::vector<std::size_t>& order) {
	Geometry g;
	for (std::size_t i = 0; i < r.blocks.size(); ++i) {
		std::vector<std::int32_t> windings(order.size());
		for (std::uint32_t k = 0; k < order.size(); ++k) {
			windings[order[k]] = r.split.blocks.all[i].windings[OperandId{k}];
		}
		g.blocks.emplace_back(placesOf(r.blocks[i]), windings);
	}
	g.surfaces.resize(order.size());
	for (std::uint32_t k = 0; k < order.size(); ++k) {
		for (std::size_t number = 0; number < r.surfaceCount(k); ++number) {
			g.surfaces[order[k]].push_back(placesOfSurface(r, k, number));
		}
	}
	return g;
}

void expectInvariant(const std::vector<Mesh>& operands, std::mt19937& random) {
	std::vector<std::size_t> order(operands.size());
	std::iota(order.begin(), order.end(), std::size_t{0});
	const OperandsSplit reference = splitAll(operands);
	ASSERT_TRUE(reference.status.ok()) << describe(reference.status);
	const Geometry expected = geometryOf(reference, order);
	Options threads;
	threads.threads = 3;
	EXPECT_TRUE(geometryOf(splitAll(operands, threads), order) == expected);
	for (int round = 0; round < 4; ++round) {
		std::shuffle(order.begin(), order.end(), random);
		std::vector<Mesh> other;
		for (const std::size_t operand : order) {
			other.push_back(permuted(operands[operand], random));
		}
		const OperandsSplit r = splitAll(other);
		ASSERT_TRUE(r.status.ok()) << describe(r.status);
		EXPECT_TRUE(geometryOf(r, order) == expected) << "round " << round;
	}
}

TEST(ManySurfaces, piecesAndTheirNumbersDoNotDependOnTheOrder) {
	std::mt19937 random(5);
	expectInvariant(blockAndFiveSheets(), random);
	expectInvariant({box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3}), level(0, 2, 2),
	                 level(1, 4, 1), box({2, 0, 0}, {4, 2, 2})},
	                random);
	std::vector<Mesh> placedOnes{level(-1.25, 1.25, 0.25)};
	for (int i = 0; i < 4; ++i) {
		placedOnes.push_back(placed(sphere(5, {0, 0, 0}, 1), random, 0.6));
	}
	expectInvariant(placedOnes, random);
}

// --- two of several are split as two alone ------------------------------------------------------

TEST(ManySurfaces, twoAreSplitAsByThemselvesBesideAThirdFarAway) {
	std::mt19937 random(9);
	const Mesh far = box({50, 50, 50}, {51, 51, 51});
	std::size_t blocks = 0;
	for (int round = 0; round < 12; ++round) {
		const Mesh a =
		    placed(round % 2 == 0 ? torus(9, 6, 1, 0.4) : sphere(5, {0, 0, 0}, 1), random, 0.3);
		const Mesh b = round % 3 == 0 ? placed(level(-2, 2, 0), random, 0.3)
		                              : placed(torus(8, 7, 0.9, 0.3), random, 0.3);
		const OperandsSplit two = splitAll({a, b}), three = splitAll({a, b, far});
		ASSERT_TRUE(two.status.ok() && three.status.ok()) << "round " << round;
		EXPECT_FALSE(two.arrangement.isSoup);
		EXPECT_TRUE(three.arrangement.isSoup);
		ASSERT_EQ(three.blocks.size(), two.blocks.size() + 1);
		for (std::size_t i = 0; i < two.blocks.size(); ++i) {
			EXPECT_EQ(placesOf(three.blocks[i]), placesOf(two.blocks[i]));
			EXPECT_NEAR(three.split.blocks.all[i].volume, two.split.blocks.all[i].volume, 1e-13);
			for (const OperandId operand : {kFirst, kSecond}) {
				EXPECT_EQ(three.split.blocks.all[i].windings[operand],
				          two.split.blocks.all[i].windings[operand]);
			}
		}
		for (const std::uint32_t k : {0U, 1U}) {
			ASSERT_EQ(three.surfaceCount(k), two.surfaceCount(k));
			for (std::size_t number = 0; number < two.surfaceCount(k); ++number) {
				EXPECT_EQ(placesOfSurface(three, k, number), placesOfSurface(two, k, number));
			}
		}
		blocks += two.blocks.size();
	}
	EXPECT_GT(blocks, 20u);
}

// --- walls --------------------------------------------------------------------------------------

// Two boxes of one layer that have a wall in common, once each way: no winding number changes
// across it, and yet it parts the blocks.
TEST(ManySurfaces, aWallOfZeroJumpPartsBlocks) {
	const Mesh twoRooms = layer({box({0, 0, 0}, {2, 2, 2}), box({2, 0, 0}, {4, 2, 2})});
	const OperandsSplit r = splitAll({twoRooms, level(-1, 5, 1), box({10, 0, 0}, {11, 1, 1})});
	ASSERT_TRUE(r.status.ok()) << describe(r.status);
	EXPECT_EQ(r.volumes(), (std::vector<double>{1, 4, 4, 4, 4}));
}

TEST(ManySurfaces, oneLayerIsCutByItself) {
	const OperandsSplit r =
	    splitAll({layer({box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3})})});
	ASSERT_TRUE(r.status.ok()) << describe(r.status);
	EXPECT_EQ(r.volumes(), (std::vector<double>{1, 7, 7}));
	std::vector<std::int32_t> windings;
	for (const SubBlock& block : r.split.blocks.all) {
		windings.push_back(block.windings[kFirst]);
	}
	std::sort(windings.begin(), windings.end());
	EXPECT_EQ(windings, (std::vector<std::int32_t>{1, 1, 2}));
}

TEST(ManySurfaces, noneAreRefusedAndNotRead) {
	Monitor monitor;
	Arrangement arrangement;
	Split parts;
	const auto again = [](MeshArrays&) { return Status{}; };
	MeshArrays none;
	none.vertexOffsets = none.faceOffsets = OperandOffsets(0);
	const Status status = splitOperands(std::move(none), again, {}, monitor, arrangement, parts);
	EXPECT_EQ(status.code, StatusCode::EmptyOperand);
}

TEST(ManySurfaces, anyOfThemIsNamedWhereItIsRefused) {
	std::vector<Mesh> operands = blockAndFiveSheets();
	for (std::uint32_t k = 0; k < operands.size(); ++k) {
		std::vector<Mesh> other = operands;
		other[k].points[0][1] = std::nan("");
		const OperandsSplit r = splitAll(other);
		EXPECT_EQ(r.status.code, StatusCode::NotFinite);
		EXPECT_EQ(r.status.operand, static_cast<int>(k));
		other[k] = Mesh{};
		const OperandsSplit empty = splitAll(other);
		EXPECT_EQ(empty.status.code, StatusCode::EmptyOperand);
		EXPECT_EQ(empty.status.operand, static_cast<int>(k));
	}
}

}  // namespace
}  // namespace index_boolean
