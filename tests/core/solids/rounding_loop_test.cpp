// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The rounding loop: what it makes hold, whether surfaces stay closed, where what it delivers came
// from, and that numbering, order and threads do not matter. What holds is judged by stored_faces.h
// and by the search for pairs; by another search in tests/python/test_results_hold.py.
#include "core/any_operands.h"
#include "core/shapes.h"
#include "core/wrong_faces.h"
#include "support/stored_faces.h"

#include <vcg_ext/arrange/places.h>
#include <vcg_ext/solids/rounding_loop.h>

#include <gtest/gtest.h>

#include <map>

namespace index_boolean {
namespace {

using namespace shapes;

Mesh movedBy(Mesh m, const Point& by) {
	for (Point& p : m.points) {
		p = {p[0] + by[0], p[1] + by[1], p[2] + by[2]};
	}
	return m;
}

Options withScalar(OutputScalar scalar) {
	Options options;
	options.outputScalar = scalar;
	return options;
}

struct Pair {
	const char* name;
	Mesh a, b;
	OutputScalar scalar;
};

// On all of them faults are left that joins and moves of the first arrangement's places do not
// cure.
std::vector<Pair> pairsNearlyTheSame() {
	const Mesh ball = sphere(16, {0, 0, 0}, 1), small = sphere(8, {.5, 0, 0}, 1);
	return {
	    {"ball, turned by 1e-15", ball, turnedAboutX(ball, 1e-15), OutputScalar::Double},
	    {"ball, turned by 1e-7, in floats", ball, turnedAboutX(ball, 1e-7), OutputScalar::Float},
	    {"small ball, turned by 3e-16", small, turnedAboutX(small, 3e-16), OutputScalar::Double}};
}

TEST(RoundingLoop, makesHoldWhatIsNearlyTheSame) {
	std::size_t arrangedAgain = 0;
	for (const Pair& pair : pairsNearlyTheSame()) {
		const BooleanRun r = run(pair.a, pair.b, withScalar(pair.scalar));
		ASSERT_TRUE(r.status.ok()) << pair.name << ": " << describe(r.status);
		arrangedAgain += r.arrangement.again != nullptr ? 1 : 0;
		EXPECT_EQ(r.arrangement.placeRepair.faultsAfter, 0U) << pair.name;
		for (const Block& block : r.blocks) {
			EXPECT_EQ(faultsOf(block.points, block.triangles), 0U) << pair.name;
			EXPECT_EQ(block.certificate.count(), 0) << pair.name;
			EXPECT_EQ(brokenPromise(block), "") << pair.name;
		}
	}
	EXPECT_GE(arrangedAgain, 2U);  // else this tests nothing
}

// A volume changes by no more than the area times the largest move, twice.
TEST(RoundingLoop, changesVolumesByNoMoreThanItSays) {
	for (const Pair& pair : pairsNearlyTheSame()) {
		const BooleanRun r = run(pair.a, pair.b, withScalar(pair.scalar));
		const double whole = volumeOf(pair.a.points, pair.a.triangles);
		const double area = 4 * kPi;  // about
		const double unit = gapAt(1.5, pair.scalar);
		const double move = r.arrangement.placeRepair.largestMove + unit;
		EXPECT_LE(r.arrangement.placeRepair.largestMove, 16 * unit) << pair.name;
		EXPECT_NEAR(r.volume(Operation::Union), whole, 2e-7 * area + 2 * move * area) << pair.name;
		EXPECT_NEAR(r.volume(Operation::Union) - r.volume(Operation::FirstMinusSecond) -
		                r.volume(Operation::SecondMinusFirst) - r.volume(Operation::Intersection),
		            0, 1e-10)
		    << pair.name;
		for (const Block& block : r.blocks) {
			EXPECT_LE(std::fabs(block.repair.volumeChange), 2 * move * area) << pair.name;
		}
	}
}

// Faces of input faces that they lie on, vertices of vertices that they are near.
TEST(RoundingLoop, namesSourcesAsTheFirstArrangement) {
	for (const Pair& pair : pairsNearlyTheSame()) {
		const BooleanRun r = run(pair.a, pair.b, withScalar(pair.scalar));
		const Arrangement& first = r.arrangement;
		const double most = first.placeRepair.largestMove + 4 * gapAt(1.5, pair.scalar);
		std::size_t named = 0;
		for (const Block& block : r.blocks) {
			for (std::size_t v = 0; v < block.points.size(); ++v) {
				if (block.vertexSource[v] == VertexId::none()) {
					continue;
				}
				++named;
				const Point place = roundedPlace(first, block.vertexSource[v]);
				for (std::size_t axis = 0; axis < 3; ++axis) {
					ASSERT_LE(std::fabs(place[axis] - block.points[v][axis]), most) << pair.name;
				}
			}
			for (std::size_t f = 0; f < block.triangles.size(); ++f) {
				const FaceSource& source = block.faceSource[f];
				ASSERT_LT(source.face.value, first.mesh.triangles.size());
				const Triangle& t = at(first.mesh.triangles, source.face);
				const Point& a = at(first.mesh.points, t[0]);
				const RoundedNormal normal(a, at(first.mesh.points, t[1]),
				                           at(first.mesh.points, t[2]));
				const double length = std::hypot(normal.value[0], normal.value[1], normal.value[2]);
				for (const std::uint32_t v : block.triangles[f]) {
					double height = 0;
					for (std::size_t axis = 0; axis < 3; ++axis) {
						height += normal.value[axis] * (block.points[v][axis] - a[axis]) / length;
					}
					ASSERT_LE(std::fabs(height), 8 * most) << pair.name;
				}
			}
		}
		EXPECT_GT(named, 0U) << pair.name;
	}
}

TEST(RoundingLoop, isTheSameForAnyNumberOfThreads) {
	for (const Pair& pair : pairsNearlyTheSame()) {
		Options options = withScalar(pair.scalar);
		options.threads = 1;
		const BooleanRun one = run(pair.a, pair.b, options);
		options.threads = 3;
		const BooleanRun many = run(pair.a, pair.b, options);
		for (std::size_t k = 0; k < one.blocks.size(); ++k) {
			EXPECT_EQ(many.blocks[k].triangles, one.blocks[k].triangles) << pair.name;
			EXPECT_EQ(many.blocks[k].points, one.blocks[k].points) << pair.name;
		}
	}
}

TEST(RoundingLoop, makesHoldInAnyNumberingAndOrder) {
	std::mt19937 random(5);
	const Pair pair = pairsNearlyTheSame()[2];
	for (int round = 0; round < 6; ++round) {
		const Mesh a = permuted(pair.a, random), b = permuted(pair.b, random);
		const BooleanRun r = round % 2 == 0 ? run(a, b) : run(b, a);
		for (const Block& block : r.blocks) {
			EXPECT_EQ(faultsOf(block.points, block.triangles), 0U) << "seed 5, round " << round;
			EXPECT_EQ(brokenPromise(block), "") << "seed 5, round " << round;
		}
	}
}

// Sub-blocks are closed and hold, or say that they do not.
TEST(RoundingLoop, makesPartsHold) {
	for (const Pair& pair : pairsNearlyTheSame()) {
		Monitor monitor;
		Arrangement arrangement;
		Split parts;
		Status status =
		    arrangeSurfaces(arrays(pair.a, pair.b), withScalar(pair.scalar), monitor, arrangement);
		ASSERT_TRUE(status.ok()) << describe(status);
		ASSERT_TRUE(split(arrangement, monitor, parts).ok());
		std::vector<SplitMesh> boundaries;
		std::size_t uncertified = 0;
		for (std::uint32_t i = 0; i < parts.blocks.all.size(); ++i) {
			boundaries.emplace_back();
			SplitMesh& mesh = boundaries.back();
			status = extractSubBlock(arrangement, parts, {i}, monitor, mesh);
			ASSERT_TRUE(status.ok()) << describe(status);
			const bool holds = faultsOf(mesh.points, mesh.triangles) == 0;
			EXPECT_EQ(mesh.certificate.count() == 0, holds) << pair.name << ", block " << i;
			uncertified += holds ? 0 : 1;
			EXPECT_TRUE(measureSurface(mesh.points, mesh.triangles, 1).closed) << pair.name;
		}
		// Where a wall is folded onto itself three times, a sub-block has it twice.
		EXPECT_LE(uncertified, 2U) << pair.name << ": of " << boundaries.size();
		for (const OperandId operand : arrangement.mesh.operands()) {
			SplitMesh mesh;
			status = extractSubSurfaces(arrangement, parts, operand, monitor, mesh);
			ASSERT_TRUE(status.ok()) << describe(status);
			EXPECT_LE(mesh.certificate.count(), 2) << pair.name;
			EXPECT_TRUE(measureSurface(mesh.points, mesh.triangles, 1).closed) << pair.name;
		}
		SplitAudit audited;
		EXPECT_TRUE(audit(arrangement, parts, boundaries, monitor, audited).ok()) << pair.name;
	}
}

// Tetrahedra on whole numbers; a float's step is 1 there, so that floats are whole numbers.
constexpr double kFarOff = 1 << 23;

std::vector<Mesh> farOff(std::vector<Mesh> operands) {
	for (Mesh& m : operands) {
		m = movedBy(m, {kFarOff, kFarOff, kFarOff});
	}
	return operands;
}

// Random tetrahedra on few whole numbers, where nearly every new point rounds to a neighbour's:
// what is left is told, and little is.
TEST(RoundingLoop, tellsWhatIsLeftOfRandomTetrahedraOnWholeNumbers) {
	std::mt19937 random(31);
	std::uniform_int_distribution<int> number(0, 12);
	const auto corner = [&] {
		return Point{static_cast<double>(number(random)), static_cast<double>(number(random)),
		             static_cast<double>(number(random))};
	};
	Options options = onOneThread();
	options.outputScalar = OutputScalar::Float;
	std::size_t left = 0;
	for (int round = 0; round < 300; ++round) {
		std::vector<Mesh> operands;
		while (operands.size() < 3) {
			const Mesh m = tetrahedron(corner(), corner(), corner(), corner());
			if (volumeOf(m.points, m.triangles) > 0) {
				operands.push_back(m);
			}
		}
		const CellsRun r = runCells(farOff(operands), options);
		for (const CellPredicate& isInside : {CellPredicate(inAny), CellPredicate(inOddNumber)}) {
			const Block block = blockOf(r, isInside);
			const std::size_t faults = faultsOf(block.points, block.triangles);
			EXPECT_EQ(block.certificate.count() == 0, faults == 0) << "seed 31, round " << round;
			EXPECT_EQ(brokenPromise(block), "") << "seed 31, round " << round;
			left += faults > 0 ? 1 : 0;
		}
	}
	EXPECT_LE(left, 1U);
}

// Rounding and resolving again and again comes back to where it was on these.
TEST(RoundingLoop, endsWhereRoundingAndResolvingGoesInCircles) {
	const std::vector<Mesh> operands =
	    farOff({tetrahedron({7, 1, 1}, {5, 1, 4}, {4, 2, 7}, {5, 5, 8}),
	            tetrahedron({1, 2, 3}, {7, 0, 4}, {8, 1, 1}, {3, 0, 5}),
	            tetrahedron({6, 8, 3}, {8, 5, 3}, {7, 4, 3}, {5, 6, 6})});
	const auto firstOnlyOrThird = [](const Windings& w) {
		return (isIn(w, 0) && !isIn(w, 1)) || isIn(w, 2);
	};
	Options options = onOneThread();
	options.outputScalar = OutputScalar::Float;
	const CellsRun r = runCells(operands, options);
	for (const CellPredicate& isInside :
	     {CellPredicate(inAny), CellPredicate(inOddNumber), CellPredicate(firstOnlyOrThird)}) {
		const Block block = blockOf(r, isInside);
		EXPECT_EQ(faultsOf(block.points, block.triangles), 0U);
		EXPECT_EQ(block.certificate.count(), 0);
		EXPECT_EQ(brokenPromise(block), "");
		EXPECT_NEAR(volumeOf(block.points, block.triangles), r.volumeWhere(isInside), 20);
	}
}

// A corner in a face is a touch that rounding makes a fold; without a vertex there it would stay
// for ever.
TEST(RoundingLoop, curesCornersInsideFaces) {
	const std::vector<Mesh> operands =
	    farOff({layer({tetrahedron({10, 10, 2}, {1, 12, 1}, {0, 9, 6}, {12, 12, 12}),
	                   tetrahedron({10, 2, 0}, {9, 11, 9}, {3, 1, 7}, {11, 4, 7})}),
	            box({40, 40, 40}, {41, 41, 41})});
	Options options = onOneThread();
	options.outputScalar = OutputScalar::Float;
	const CellsRun r = runCells(operands, options);
	const Block block = blockOf(r, inAny);
	EXPECT_EQ(faultsOf(block.points, block.triangles), 0U);
	EXPECT_EQ(brokenPromise(block), "");
}

// A flat face that is kept until the mesh is refined keeps a surface closed when vertices move:
// here one of its corners has. Dropped, the surface would be open.
TEST(RoundingLoop, aSurfaceWithAMovedFlatFaceIsClosed) {
	Mesh m;
	m.points = {{0, 0, 0}, {6, 2, 0}, {4, 0, 0}, {3, 0, 6}, {3, 6, 1}};  // u, v, w (moved), x, y
	m.triangles = {{0, 1, 3}, {1, 2, 4}, {2, 0, 4}, {0, 2, 1}, {0, 3, 4}, {1, 4, 3}};
	const CellsRun r = runCells({m});
	EXPECT_TRUE(r.arrangement.closed[kFirst]);
	const std::vector<std::pair<std::vector<std::int32_t>, double>> cells = r.cells();
	ASSERT_EQ(cells.size(), 2U);
	EXPECT_EQ(cells[0].first, std::vector<std::int32_t>{-1});
	EXPECT_NEAR(cells[0].second, 32 / 117., 1e-12);
	EXPECT_EQ(cells[1].first, std::vector<std::int32_t>{1});
	EXPECT_NEAR(cells[1].second, 3503 / 117., 1e-11);
	m.triangles.erase(m.triangles.begin() + 3);
	EXPECT_FALSE(runCells({m}).arrangement.closed[kFirst]);
}

// A round that grows beyond all measure is refused for its size, and the first arrangement stays.
TEST(RoundingLoop, endsWhereARoundIsRefused) {
	Monitor monitor;
	Arrangement arrangement;
	const Mesh ball = sphere(6, {0, 0, 0}, 1);
	ASSERT_TRUE(arrange(arrays(ball, movedBy(ball, {.5, 0, 0})), {}, monitor, arrangement).ok());
	const std::size_t size =
	    arrangement.mesh.triangles.size() + arrangement.refinement.pieces.size();
	arrangement.placeRepair.faultsAfter = 5;
	int rounds = 0;
	const ArrangeSoup refuse = [&](const MeshArrays&, const Options& options, Arrangement&) {
		++rounds;
		EXPECT_LE(options.mostElements, 32 * size + 1000);
		EXPECT_GE(options.mostElements, size);
		return statusOf(StatusCode::TooLarge);
	};
	EXPECT_TRUE(holdAsStored(refuse, monitor, arrangement).ok());
	EXPECT_EQ(rounds, 1);
	EXPECT_EQ(arrangement.again, nullptr);
	const ArrangeSoup cancel = [](const MeshArrays&, const Options&, Arrangement&) {
		return statusOf(StatusCode::Cancelled);
	};
	EXPECT_EQ(holdAsStored(cancel, monitor, arrangement).code, StatusCode::Cancelled);
}

// Each callback that may cancel does so in one of the runs.
TEST(RoundingLoop, canBeCancelled) {
	const Pair pair = pairsNearlyTheSame()[2];
	int cancelledRuns = 0;
	for (int most = 0; most < 10000; most = most * 2 + 1) {
		int calls = 0;
		Monitor monitor([&](double, const char*) { return calls++ < most; });
		Arrangement arrangement;
		const Status status =
		    arrange(arrays(pair.a, pair.b), withScalar(pair.scalar), monitor, arrangement);
		if (status.ok()) {
			break;
		}
		EXPECT_EQ(status.code, StatusCode::Cancelled) << most;
		++cancelledRuns;
	}
	EXPECT_GT(cancelledRuns, 4);
}

}  // namespace
}  // namespace index_boolean
