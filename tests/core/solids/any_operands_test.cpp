// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Operands that overlap themselves, touch themselves, have T-junctions or are open, and more than
// two of them: the cells of inputs whose cells are known in closed form, and blocks of them. All
// numbers come from a model in rational arithmetic, or from a sheet of paper; none from the core.
#include "core/any_operands.h"

#include <gtest/gtest.h>

#include <set>

namespace index_boolean {
namespace {

using namespace shapes;

struct ExpectedCells {
	std::vector<std::int32_t> windings;
	double volume;  // of each
	int count = 1;
};

// As cut, by position. A pinch is a vertex with two umbrellas at no edge of more than two faces.
struct ExpectedBlock {
	CellPredicate isInside;
	double volume;
	std::size_t edgesOfFour = 0;
	std::vector<Point> pinches = {};
	std::size_t faces = 0;  // 0: not told, unless the block is empty
};

struct Input {
	std::string name;
	std::vector<Mesh> operands;
	std::vector<ExpectedCells> cells;
	std::vector<ExpectedBlock> blocks;
	std::vector<bool> closed = {};  // per operand; empty: all are
};

void PrintTo(const Input& input, std::ostream* out) { *out << input.name; }

// --- operands that cross each other -------------------------------------------------------------

std::vector<Mesh> plates() {
	return {box({-3, -4, -1}, {5, 3, 1}), box({-4, -1, -3}, {3, 1, 5}),
	        box({-1, -3, -4}, {1, 5, 3})};
}

// A cube, and three walls through its middle.
std::vector<Mesh> octants() {
	return {box({-2, -2, -2}, {2, 2, 2}), box({0, -3, -4}, {3, 5, 3}), box({-4, 0, -3}, {3, 3, 5}),
	        box({-3, -4, 0}, {5, 3, 3})};
}

std::vector<Mesh> obliqueOctants() {
	std::vector<Mesh> operands;
	for (const Mesh& m : octants()) {
		operands.push_back(mapped(m, {{{1, 1, 0}, {0, 1, 1}, {1, 0, 2}}}));
	}
	return operands;
}

// A fourth wall through the same point: 0 <= x + y + z <= 9.
std::vector<Mesh> octantsAndSlant() {
	std::vector<Mesh> operands = octants();
	operands.push_back(mapped(box({0, -7, -8}, {9, 9, 6}), {{{1, -1, -1}, {0, 1, 0}, {0, 0, 1}}}));
	return operands;
}

std::ptrdiff_t wallCount(const Windings& w) {
	return (isIn(w, 1) ? 1 : 0) + (isIn(w, 2) ? 1 : 0) + (isIn(w, 3) ? 1 : 0);
}
bool inOppositeOctants(const Windings& w) {
	return isIn(w, 0) && (wallCount(w) == 0 || wallCount(w) == 3);
}
bool inOddOctants(const Windings& w) { return isIn(w, 0) && wallCount(w) % 2 != 0; }

std::vector<ExpectedCells> octantCells(double scale) {
	std::vector<ExpectedCells> cells;
	for (std::int32_t i = 0; i < 8; ++i) {
		const std::vector<std::int32_t> walls{i & 1, i >> 1 & 1, i >> 2};
		const auto count = walls[0] + walls[1] + walls[2];
		cells.push_back({{1, walls[0], walls[1], walls[2]}, 8 * scale});
		if (count > 0) {
			cells.push_back({{0, walls[0], walls[1], walls[2]}, (count == 1 ? 79 : 19) * scale});
		}
	}
	return cells;
}

std::vector<ExpectedCells> slantCells() {
	std::vector<ExpectedCells> cells{
	    {{0, 0, 0, 0, 1}, 1777}, {{0, 1, 1, 1, 1}, 19}, {{1, 0, 0, 0, 0}, 8}, {{1, 1, 1, 1, 1}, 8}};
	for (std::size_t i = 1; i < 4; ++i) {
		std::vector<std::int32_t> one(5, 0), two{0, 1, 1, 1, 0};
		one[i] = 1;
		two[i] = 0;
		const auto with = [](std::vector<std::int32_t> windings, std::int32_t cube,
		                     std::int32_t slant) {
			windings[0] = cube;
			windings[4] = slant;
			return windings;
		};
		cells.insert(cells.end(), {{with(one, 0, 0), 4 / 3.},
		                           {with(one, 0, 0), 185 / 6.},
		                           {with(one, 0, 1), 19 / 6.},
		                           {with(one, 0, 1), 131 / 3.},
		                           {with(two, 0, 0), 19 / 6.},
		                           {with(two, 0, 1), 95 / 6.},
		                           {with(one, 1, 0), 20 / 3.},
		                           {with(one, 1, 1), 4 / 3.},
		                           {with(two, 1, 0), 4 / 3.},
		                           {with(two, 1, 1), 20 / 3.}});
	}
	return cells;
}

std::vector<Input> crossingOperands() {
	return {
	    {"threePlates",
	     plates(),
	     {{{1, 0, 0}, 8},
	      {{1, 0, 0}, 64},
	      {{0, 1, 0}, 8},
	      {{0, 1, 0}, 64},
	      {{0, 0, 1}, 8},
	      {{0, 0, 1}, 64},
	      {{1, 1, 0}, 8, 2},
	      {{1, 0, 1}, 8, 2},
	      {{0, 1, 1}, 8, 2},
	      {{1, 1, 1}, 8}},
	     {{inAny, 272},
	      {inAll, 8},
	      {inOne, 216, 60},
	      {inTwoOrMore, 56},
	      {inFirstAlone, 72},
	      {[](const Windings& w) { return isIn(w, 0) && !(isIn(w, 1) && !isIn(w, 2)); }, 96}}},
	    {"threeWallsInACube",
	     octants(),
	     octantCells(1),
	     {{inOppositeOctants, 16, 0, {{0, 0, 0}}}, {inOddOctants, 32, 12}}},
	    {"threeObliqueWalls",
	     obliqueOctants(),
	     octantCells(3),
	     {{inOppositeOctants, 48, 0, {{0, 0, 0}}}, {inOddOctants, 96, 12}}},
	    {"fourPlanesThroughAPoint",
	     octantsAndSlant(),
	     slantCells(),
	     {{[](const Windings& w) { return isIn(w, 0) && isIn(w, 4); }, 32},
	      {[](const Windings& w) { return isIn(w, 0) && wallCount(w) == 3 && !isIn(w, 4); }, 0}}},
	    {"threeBoxesWithCommonWalls",
	     {box({0, 0, 0}, {4, 2, 2}), box({2, 0, 0}, {6, 2, 2}), box({3, 0, 0}, {5, 2, 1})},
	     {{{1, 0, 0}, 8}, {{1, 1, 0}, 6}, {{1, 1, 1}, 2}, {{0, 1, 0}, 6}, {{0, 1, 1}, 2}},
	     {{[](const Windings& w) { return (isIn(w, 0) || isIn(w, 1)) && !isIn(w, 2); }, 20},
	      {inFirstAlone, 8},
	      {inOddNumber, 16, 2},
	      {inTwoOrMore, 10}}},
	};
}

// --- one layer that overlaps itself -------------------------------------------------------------

std::vector<Input> overlappingLayers() {
	return {
	    {"shiftedCubes",
	     {layer({box({0, 0, 0}, {2, 2, 2}), box({1, 0, 0}, {3, 2, 2})})},
	     {{{1}, 4, 2}, {{2}, 4}},
	     {{atLeast(1), 12}, {atLeast(2), 4}, {oddWinding, 8}}},
	    {"cubesOverlappingInACorner",
	     {layer({box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3})})},
	     {{{1}, 7, 2}, {{2}, 1}},
	     {{atLeast(1), 15}, {atLeast(2), 1}, {oddWinding, 14, 6}}},
	    {"nestedShells",
	     {layer({box({0, 0, 0}, {6, 6, 6}), box({1, 1, 1}, {5, 5, 5}), box({2, 2, 2}, {4, 4, 4})})},
	     {{{1}, 152}, {{2}, 56}, {{3}, 8}},
	     {{atLeast(1), 216}, {atLeast(2), 64}, {atLeast(3), 8}, {oddWinding, 160}}},
	    {"shellInACavity",
	     {layer({box({0, 0, 0}, {6, 6, 6}), turned(box({1, 1, 1}, {5, 5, 5})),
	             box({2, 2, 2}, {4, 4, 4})})},
	     {{{1}, 152}, {{0}, 56}, {{1}, 8}},
	     {{atLeast(1), 160}, {inAny, 160}, {oddWinding, 160}}},
	    {"crossingBars",
	     {layer({box({-3, -1, -1}, {3, 1, 1}), box({-1, -3, -0.5}, {1, 3, 0.5})}),
	      box({10, 10, 10}, {11, 11, 11})},
	     {{{1, 0}, 4, 2}, {{1, 0}, 20}, {{2, 0}, 4}, {{0, 1}, 1}},
	     {{inFirst, 32}, {inAny, 33}}},
	    {"overlapAcrossAnotherOperand",
	     {layer({box({0, 0, 0}, {4, 4, 4}), box({3, -1, -1}, {9, 5, 5})}),
	      box({3.5, 1, 1}, {5, 2, 2})},
	     {{{1, 0}, 48}, {{1, 0}, 199}, {{1, 1}, 1}, {{2, 0}, 31 / 2.}, {{2, 1}, 1 / 2.}},
	     {{inAny, 264}, {inAll, 3 / 2.}, {inFirstAlone, 525 / 2.}}},
	    {"framesInEachOther",
	     {layer({frame(2), frame(1), frame(3)})},
	     {{{1}, 1, 2}, {{2}, 1, 2}, {{2}, 3, 2}, {{3}, 26}},
	     {{atLeast(1), 36}, {atLeast(2), 34, 1}, {atLeast(3), 26}}},
	    {"fold", {fold()}, {{{1}, 8}}, {{inAny, 8}}},
	};
}

// --- orientation --------------------------------------------------------------------------------

std::vector<Input> turnedLayers() {
	const Mesh cube = box({0, 0, 0}, {2, 2, 2}), shifted = box({1, 0, 0}, {3, 2, 2});
	return {
	    {"insideOutBeside",
	     {layer({turned(cube), box({4, 0, 0}, {5, 1, 1})})},
	     {{{-1}, 8}, {{1}, 1}},
	     {{atLeast(1), 1}, {inAny, 9}}},
	    {"insideOutOverlapping",
	     {layer({turned(cube), shifted})},
	     {{{-1}, 4}, {{1}, 4}},
	     {{atLeast(1), 4}, {inAny, 8}}},
	    {"insideOutOperandIsTurned",
	     {cube, turned(shifted)},
	     {{{1, 0}, 4}, {{1, 1}, 4}, {{0, 1}, 4}},
	     {{inAny, 12}, {inFirstAlone, 4}}},
	    {"figureEightTube",
	     {figureEightTube()},
	     {{{1}, 3}, {{-1}, 3}},
	     {{atLeast(1), 3}, {inAny, 6, 2}}},
	};
}

// --- faces on faces -----------------------------------------------------------------------------

std::vector<Mesh> stackedFrames() {
	return {frame(2), moved(frame(1), {0, 0, 1}), moved(frame(3), {0, 0, 2})};
}

std::vector<Mesh> growingBoxes() {
	std::vector<Mesh> operands;
	for (int k = 0; k < 5; ++k) {
		operands.push_back(box({0, 0, 0}, {2. + k, 2. + k, 1}));
	}
	return operands;
}

std::vector<Input> facesOnFaces() {
	const Mesh low = box({0, 0, 0}, {4, 4, 2}), high = box({1, 1, 2}, {3, 3, 4});
	return {
	    {"standingBox", {layer({low, high})}, {{{1}, 40}}, {{inAny, 40, 0, {}, 28}}},
	    {"standingBoxAsOperand",
	     {low, high},
	     {{{1, 0}, 32}, {{0, 1}, 8}},
	     {{inAny, 40}, {inOddNumber, 40}}},
	    {"boxesBesideEachOther",
	     {layer({box({0, 0, 0}, {2, 2, 2}), box({2, 1, 1}, {4, 3, 3})})},
	     {{{1}, 16}},
	     {{atLeast(1), 16}}},
	    {"skinOfBothBoxes", {skinOfTwoBoxes()}, {{{1}, 16}}, {{inAny, 16}}},
	    {"skinOfBothBoxesWithABoxInTheOpening",
	     {skinOfTwoBoxes(), box({1, 1.25, 1.25}, {3, 1.75, 1.75})},
	     {{{1, 0}, 31 / 2.}, {{1, 1}, 1 / 2.}},
	     {{inFirstAlone, 31 / 2.}}},
	    {"growingBoxes",
	     growingBoxes(),
	     {{{1, 1, 1, 1, 1}, 4},
	      {{0, 1, 1, 1, 1}, 5},
	      {{0, 0, 1, 1, 1}, 7},
	      {{0, 0, 0, 1, 1}, 9},
	      {{0, 0, 0, 0, 1}, 11}},
	     {{inAny, 36}, {inAll, 4}, {inOddNumber, 22}}},
	    {"stackedFrames",
	     stackedFrames(),
	     {{{1, 0, 0}, 32}, {{0, 1, 0}, 32}, {{0, 0, 1}, 32}},
	     {{inAny, 96, 0, {{3, 3, 2}}},
	      {[](const Windings& w) { return isIn(w, 0) || isIn(w, 2); }, 64}}},
	    {"filledCavity",
	     {layer({box({0, 0, 0}, {4, 4, 4}), turned(box({1, 1, 1}, {3, 3, 3}))}),
	      box({1, 1, 1}, {3, 3, 3})},
	     {{{1, 0}, 56}, {{0, 1}, 8}},
	     {{inAny, 64, 0, {}, 12}, {inFirstAlone, 56}, {inAll, 0}}},
	    {"halvesAgainstTheWhole",
	     {layer({box({0, 0, 0}, {1, 1, 1}), box({1, 0, 0}, {2, 1, 1})}), box({0, 0, 0}, {2, 1, 1})},
	     {{{1, 1}, 2}},
	     {{inFirstAlone, 0},
	      {[](const Windings& w) { return isIn(w, 1) && !isIn(w, 0); }, 0},
	      {inAll, 2}}},
	};
}

// --- faces that are given more than once --------------------------------------------------------

std::vector<Input> repeatedFaces() {
	const Mesh cube = box({0, 0, 0}, {1, 1, 1});
	Mesh repeated = cube;
	repeated.triangles.push_back(cube.triangles.front());
	return {
	    {"cubeTwice",
	     {layer({cube, cube})},
	     {{{2}, 1}},
	     {{atLeast(1), 1}, {atLeast(2), 1}, {oddWinding, 0}}},
	    {"cubeAndItsOpposite", {layer({cube, turned(cube)})}, {}, {{inAny, 0}}},
	    {"cubeAsThreeOperands",
	     {cube, cube, cube},
	     {{{1, 1, 1}, 1}},
	     {{[](const Windings& w) { return (isIn(w, 0) && !isIn(w, 1)) || isIn(w, 2); }, 1},
	      {[](const Windings& w) { return isIn(w, 0) && !isIn(w, 1); }, 0},
	      {inOddNumber, 1}}},
	    {"oneFaceTwiceIsTakenOnce", {repeated}, {{{1}, 1}}, {{atLeast(1), 1}}},
	};
}

// --- T-junctions and open operands --------------------------------------------------------------

Mesh sheet(bool endsInside) {
	const std::vector<Corners> faces{
	    {Point{-1, -1, 1}, Point{endsInside ? 1. : 3., -1, 1}, Point{endsInside ? 1. : 3., 3, 1}},
	    {Point{-1, -1, 1}, Point{endsInside ? 1. : 3., 3, 1}, Point{-1, 3, 1}}};
	return welded(faces);
}

std::vector<Input> bordersOfOperands() {
	const Mesh cube = box({0, 0, 0}, {2, 2, 2}), hanging = boxWithHangingVertex({1, 0, 2});
	return {
	    {"hangingVertex", {hanging}, {{{1}, 8}}, {{inAny, 8, 0, {}, 14}}},
	    {"hangingVertexInAnotherOperand",
	     {hanging, box({1, -1, 1}, {3, 1, 3})},
	     {{{1, 0}, 7}, {{1, 1}, 1}, {{0, 1}, 7}},
	     {{inAny, 15}}},
	    {"hangingVertexOnAnEdgeOfAnotherOperand",
	     {hanging, cube},
	     {{{1, 1}, 8}},
	     {{inAny, 8}, {inFirstAlone, 0}, {inOddNumber, 0}}},
	    {"crack", {boxWithHangingVertex({1, 0.125, 2})}, {}, {}, {false}},
	    {"openSheetThroughABox",
	     {cube, sheet(false)},
	     {{{1, 0}, 4, 2}},
	     {{inFirst, 8}},
	     {true, false}},
	    {"openSheetThatEndsInABox",
	     {cube, sheet(true)},
	     {{{1, 0}, 8}},
	     {{inFirst, 8}},
	     {true, false}},
	};
}

// --- contacts in corners only -------------------------------------------------------------------

std::vector<Mesh> rowOfCubes() {
	std::vector<Mesh> operands;
	for (int k = 0; k < 5; ++k) {
		operands.push_back(box({1. * k, 0, 0}, {k + 1., 1, 1}));
	}
	return operands;
}

std::vector<Mesh> eightCubes() {
	std::vector<Mesh> operands;
	for (int i = 0; i < 8; ++i) {
		const Point low{1. * (i & 1), 1. * (i >> 1 & 1), 1. * (i >> 2)};
		operands.push_back(box(low, {low[0] + 1, low[1] + 1, low[2] + 1}));
	}
	return operands;
}

std::vector<ExpectedCells> oneCellEach(std::size_t operands, double volume) {
	std::vector<ExpectedCells> cells;
	for (std::size_t k = 0; k < operands; ++k) {
		std::vector<std::int32_t> windings(operands, 0);
		windings[k] = 1;
		cells.push_back({windings, volume});
	}
	return cells;
}

std::vector<Input> commonCorners() {
	const Mesh cube = box({0, 0, 0}, {1, 1, 1});
	const Mesh ground = box({0, 0, 0}, {4, 4, 2});
	const auto firstOrLast = [](const Windings& w) { return isIn(w, 0) || isIn(w, 7); };
	return {
	    {"cubesAroundAnEdge",
	     {cube, box({-1, 0, 0}, {0, 1, 1}), box({-1, -1, 0}, {0, 0, 1})},
	     oneCellEach(3, 1),
	     {{inAny, 3}, {[](const Windings& w) { return isIn(w, 0) || isIn(w, 2); }, 2, 1}}},
	    {"cubesAtAnEdge",
	     {layer({cube, box({1, 1, 0}, {2, 2, 1})})},
	     {{{1}, 1, 2}},
	     {{inAny, 2, 1}}},
	    {"cubesAtACorner",
	     {cube, box({1, 1, 1}, {2, 2, 2})},
	     oneCellEach(2, 1),
	     {{inAny, 2, 0, {{1, 1, 1}}}}},
	    {"rowOfCubes",
	     rowOfCubes(),
	     oneCellEach(5, 1),
	     {{inAny, 5, 0, {}, 44},
	      {[](const Windings& w) { return isIn(w, 0) || isIn(w, 2) || isIn(w, 4); }, 3}}},
	    {"eightCubes",
	     eightCubes(),
	     oneCellEach(8, 1),
	     {{inAny, 8},
	      {[](const Windings& w) { return isIn(w, 0) || isIn(w, 3) || isIn(w, 5) || isIn(w, 6); },
	       4, 6},
	      {firstOrLast, 2, 0, {{1, 1, 1}}}}},
	    {"tipThroughAFace",
	     {ground, tetrahedron({1, 1, 5}, {3, 1, 5}, {2, 3, 5}, {2, 2, 1})},
	     {{{1, 0}, 767 / 24.}, {{1, 1}, 1 / 24.}, {{0, 1}, 21 / 8.}},
	     {{inAny, 277 / 8.}, {inAll, 1 / 24.}, {inFirstAlone, 767 / 24.}}},
	    {"tipOnAFace",
	     {ground, tetrahedron({1, 1, 5}, {3, 1, 5}, {2, 3, 5}, {2, 1, 2})},
	     {{{1, 0}, 32}, {{0, 1}, 2}},
	     {{inAny, 34, 0, {{2, 1, 2}}, 18}}},
	};
}

std::vector<Input> allInputs() {
	std::vector<Input> all;
	for (const auto& inputs :
	     {crossingOperands(), overlappingLayers(), turnedLayers(), facesOnFaces(), repeatedFaces(),
	      bordersOfOperands(), commonCorners()}) {
		all.insert(all.end(), inputs.begin(), inputs.end());
	}
	return all;
}

// --- what is expected of each -------------------------------------------------------------------

class AnyOperands : public testing::TestWithParam<Input> {};

void expectCells(const CellsRun& r, const Input& input) {
	std::vector<std::pair<std::vector<std::int32_t>, double>> expected;
	for (const ExpectedCells& cells : input.cells) {
		for (int i = 0; i < cells.count; ++i) {
			expected.emplace_back(cells.windings, cells.volume);
		}
	}
	std::sort(expected.begin(), expected.end());
	const auto found = r.cells();
	ASSERT_EQ(found.size(), expected.size());
	for (std::size_t i = 0; i < found.size(); ++i) {
		EXPECT_EQ(found[i].first, expected[i].first);
		EXPECT_NEAR(found[i].second, expected[i].second, 1e-12 * expected[i].second);
	}
}

void expectOutsideAndClosedness(const CellsRun& r, const Input& input) {
	const CellLabels& cells = r.arrangement.cells;
	ASSERT_EQ(cells.windings.size(), cells.volume.size());
	ASSERT_FALSE(cells.volume.empty());
	EXPECT_EQ(cells.volume[0], 0);
	EXPECT_EQ(cells.windings[0].size(), input.operands.size());
	EXPECT_EQ(insideCount(cells.windings[0]), 0);
	ASSERT_EQ(r.arrangement.closed.size(), input.operands.size());
	for (std::uint32_t k = 0; k < input.operands.size(); ++k) {
		EXPECT_EQ(r.arrangement.closed[OperandId{k}], input.closed.empty() || input.closed[k]);
	}
}

// In all ways to turn the axes, and in mirrors; every second time without common vertices.
TEST_P(AnyOperands, haveTheseCells) {
	std::mt19937 random(7);
	for (std::size_t view = 0; view < 6; ++view) {
		SCOPED_TRACE("view " + std::to_string(view));
		std::vector<Mesh> operands;
		for (const Mesh& m : GetParam().operands) {
			Mesh seen = permuted(m, random);
			const double sign = view < 3 ? 1 : -1;
			for (Point& p : seen.points) {
				p = {sign * p[view % 3], sign * p[(view + 1) % 3], sign * p[(view + 2) % 3]};
			}
			seen = view < 3 ? seen : turned(seen);
			operands.push_back(view % 2 == 0 ? seen : soup(seen));
		}
		const CellsRun r = runCells(operands);
		ASSERT_TRUE(r.status.ok());
		expectOutsideAndClosedness(r, GetParam());
		expectCells(r, GetParam());
	}
}

void expectBlock(const Block& block, const ExpectedBlock& expected) {
	EXPECT_EQ(brokenPromise(block), "");
	EXPECT_NEAR(exactVolumeOf(block), expected.volume, 1e-12 * expected.volume);
	if (expected.volume == 0) {
		EXPECT_TRUE(block.triangles.empty());
		EXPECT_TRUE(block.points.empty());
	}
}

TEST_P(AnyOperands, haveTheseBlocksAsCut) {
	const CellsRun r = runCells(GetParam().operands, asCut());
	ASSERT_TRUE(r.status.ok());
	for (std::size_t i = 0; i < GetParam().blocks.size(); ++i) {
		SCOPED_TRACE("block " + std::to_string(i));
		const ExpectedBlock& expected = GetParam().blocks[i];
		const Block block = blockOf(r, expected.isInside);
		expectBlock(block, expected);
		const SelfContact contact(block);
		EXPECT_EQ(contact.edgesOfMoreThanTwo(), expected.edgesOfFour);
		EXPECT_EQ(contact.pinches(), expected.pinches);
		if (expected.faces > 0) {
			EXPECT_EQ(block.triangles.size(), expected.faces);
		}
	}
}

TEST_P(AnyOperands, deliverTheirBlocksAsManifolds) {
	for (const bool mergeCoplanar : {false, true}) {
		Options options = shapes::onOneThread();
		options.mergeCoplanar = mergeCoplanar;
		const CellsRun r = runCells(GetParam().operands, options);
		ASSERT_TRUE(r.status.ok());
		for (std::size_t i = 0; i < GetParam().blocks.size(); ++i) {
			SCOPED_TRACE("block " + std::to_string(i));
			const Block block = blockOf(r, GetParam().blocks[i].isInside);
			expectBlock(block, GetParam().blocks[i]);
			EXPECT_TRUE(isManifold(block.triangles));
		}
	}
}

TEST_P(AnyOperands, areTheSameInAnyNumbering) {
	std::mt19937 random(11);
	const CellsRun straight = runCells(GetParam().operands);
	std::vector<Mesh> operands;
	for (const Mesh& m : GetParam().operands) {
		operands.push_back(soup(permuted(m, random)));
	}
	const CellsRun other = runCells(operands);
	for (const ExpectedBlock& expected : GetParam().blocks) {
		EXPECT_EQ(geometry(blockOf(straight, expected.isInside)),
		          geometry(blockOf(other, expected.isInside)));
	}
}

// Also where cells have been labelled before.
TEST_P(AnyOperands, havePartsThatPassTheAudit) {
	const CellsRun r = runCells(GetParam().operands);
	Monitor monitor;
	Split parts;
	ASSERT_TRUE(split(r.arrangement, monitor, parts).ok());
	SplitAudit audited;
	EXPECT_TRUE(audit(r.arrangement, parts, {}, monitor, audited).ok());
	EXPECT_LT(audited.volumeLawResidual, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Inputs, AnyOperands, testing::ValuesIn(allInputs()),
                         [](const auto& input) { return input.param.name; });

// --- inputs of which other things are known -----------------------------------------------------

// All three points of the line are stored in one place.
TEST(Arranged, threePointsOfALineInOnePlaceAreInOrder) {
	const double deep = -0x1p-60;
	const CellsRun r = runCells({welded({{Point{-4, -4, 0}, Point{4, -4, 0}, Point{0, 8, 0}}}),
	                             welded({{Point{1, 1, deep}, Point{1, 0, 1}, Point{1, 2, 1}}}),
	                             welded({{Point{-3, 1, -3}, Point{5, 1, -3}, Point{1, 1, 5}}})});
	ASSERT_TRUE(r.status.ok());
	std::vector<Segment> segments;
	for (const Segment& s : r.arrangement.curve.segments) {
		if (std::min(s.a, s.b) == FaceId{0} && std::max(s.a, s.b) == FaceId{1}) {
			segments.push_back(s);
		}
	}
	ASSERT_EQ(segments.size(), 2u);
	std::map<std::uint32_t, int> ends;
	for (const Segment& s : segments) {
		for (const VertexId v : {s.begin, s.end}) {
			++ends[v.value];
			EXPECT_EQ(r.arrangement.coordinates(v), (Point{1, 1, 0}));
		}
	}
	EXPECT_EQ(ends.size(), 3u) << "one of them is an end of both";
}

// Two triangles in the plane x + y + z = 3, where no axis is nearer to the normal than another.
TEST(Arranged, aHexagonalOverlapIsCutAlikeInBothFaces) {
	const CellsRun r = runCells({welded({{Point{3, 0, 0}, Point{0, 3, 0}, Point{0, 0, 3}}}),
	                             welded({{Point{2, 2, -1}, Point{-1, 2, 2}, Point{2, -1, 2}}})});
	ASSERT_TRUE(r.status.ok());
	std::map<std::array<std::uint32_t, 3>, int> sources;  // of each piece, by its corners
	for (const Triangle& t : r.arrangement.refinement.pieces) {
		std::array<std::uint32_t, 3> corners{t[0].value, t[1].value, t[2].value};
		std::sort(corners.begin(), corners.end());
		++sources[corners];
	}
	EXPECT_EQ(sources.size(), 10u);
	EXPECT_EQ(std::count_if(sources.begin(), sources.end(),
	                        [](const auto& entry) { return entry.second == 2; }),
	          4);
	EXPECT_EQ(r.arrangement.cells.windings.size(), 1u) << "open sheets in one plane part nothing";
}

TEST(Arranged, aNeedleThinnerThanAnUlpIsOneCell) {
	const CellsRun r = runCells({needleThinnerThanAnUlp(), box({0, 0, 0}, {1, 1, 1})});
	ASSERT_TRUE(r.status.ok());
	std::multiset<std::vector<std::int32_t>> windings;
	for (const auto& cell : r.cells()) {
		windings.insert(cell.first);
	}
	EXPECT_EQ(windings, (std::multiset<std::vector<std::int32_t>>{{0, 1}, {1, 0}}));
	const Block both = blockOf(r, inAny);
	EXPECT_EQ(both.triangles.size(), 16u);
	EXPECT_EQ(exactVolumeOf(both), 1.5);
}

// Sheets through one line: each two of them name each of its points once more, and each three of
// them ask whether they meet in one point.
TEST(Arranged, aPencilOfSheetsIsCutInTimeForItsPoints) {
	constexpr int kSheets = 64;
	std::vector<Corners> faces;
	for (int i = 0; i < kSheets; ++i) {
		const double x = 3 * std::cos(kPi * i / kSheets), y = 3 * std::sin(kPi * i / kSheets);
		addQuad(faces, {-x, -y, -3}, {x, y, -3}, {x, y, 3}, {-x, -y, 3});
	}
	const CellsRun r = runCells({welded(faces), box({-2, -2, -2}, {2, 2, 2})});
	ASSERT_TRUE(r.status.ok());
	EXPECT_EQ(r.cells().size(), 2u * kSheets);
	double seconds = 0;
	for (const StageTime& stage : r.arrangement.stageTimes) {
		seconds += std::string(stage.stage) == "triple_contact" ? stage.seconds : 0;
	}
	EXPECT_LT(seconds, 1);  // 0.05; 6 where no point is known to be the same as another
}

// An open sheet has the diagonal of the base in common with it, and another one of its edges: all
// faces at these are touched, whatever their numbers, and so their diagonal may be flipped.
TEST(Arranged, facesAtCommonEdgesAreMergedAlikeInAnyNumbering) {
	const Point a{0, 0, 3}, b{3, 3, 3}, c{0, 2.99, 3}, d{3, 0, 3}, top{0, 0, 4}, low{0, 0, 0};
	const Mesh pyramid =
	    welded({{a, b, c}, {a, d, b}, {a, top, d}, {c, b, top}, {a, c, top}, {d, top, b}});
	const Mesh sheet = welded({{low, a, b}, {low, b, d}});
	Options options = onOneThread();
	options.mergeCoplanar = true;
	std::mt19937 random(3);
	std::set<std::vector<Corners>> geometries;
	for (int i = 0; i < 30; ++i) {
		const CellsRun r = runCells({permuted(pyramid, random), permuted(sheet, random)}, options);
		ASSERT_TRUE(r.status.ok());
		geometries.insert(geometry(blockOf(r, inAny)));
	}
	EXPECT_EQ(geometries.size(), 1u);
}

// No orientation has an edge as often each way; what is inside is known modulo two at most.
TEST(Arranged, oneSidedSurfacesHaveCellsByTheOddRule) {
	const auto volumesOf = [](const Mesh& m) {
		Options options = shapes::onOneThread();
		options.windingRule = WindingRule::Odd;
		const CellsRun r = runCells({m}, options);
		EXPECT_TRUE(r.arrangement.closed[kFirst]);
		std::vector<double> volumes;
		for (std::size_t cell = 1; cell < r.arrangement.cells.windings.size(); ++cell) {
			if (r.arrangement.cells.windings[cell][kFirst] == 1) {
				volumes.push_back(r.arrangement.cells.volume[cell]);
			}
		}
		return volumes;
	};
	const std::vector<double> ofFour = volumesOf(tetrahemihexahedron());
	ASSERT_EQ(ofFour.size(), 4u);
	for (const double volume : ofFour) {
		EXPECT_NEAR(volume, 1.0 / 6, 1e-15);
	}
	const std::vector<double> ofBottle = volumesOf(kleinBottle());
	ASSERT_EQ(ofBottle.size(), 1u);
	EXPECT_NEAR(ofBottle[0], 144, 1e-12);
}

TEST(Arranged, oneSidedSurfacesAreNotClosed) {
	for (const Mesh& m : {tetrahemihexahedron(), kleinBottle()}) {
		const CellsRun r = runCells({m});
		ASSERT_TRUE(r.status.ok());
		EXPECT_FALSE(r.arrangement.closed[kFirst]);
		for (const Windings& w : r.arrangement.cells.windings) {
			EXPECT_EQ(w[kFirst], 0);
		}
	}
}

}  // namespace
}  // namespace index_boolean
