// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whole runs: closed forms, laws of set algebra, invariance, and refusals.
#include "core/shapes.h"

#include <gtest/gtest.h>

#include <cstring>

namespace index_boolean {
namespace {

using namespace shapes;

constexpr std::array<Operation, 5> kOperations{
    Operation::Union, Operation::Intersection, Operation::FirstMinusSecond,
    Operation::SecondMinusFirst, Operation::SymmetricDifference};

void expectLaws(const BooleanRun& r) {
	ASSERT_TRUE(r.status.ok()) << statusName(r.status.code) << ": " << describe(r.status);
	const double a = r.arrangement.volume[kFirst], b = r.arrangement.volume[kSecond];
	const double scale = 1e-13 * (a + b);
	const double both = r.volume(Operation::Intersection);
	EXPECT_NEAR(r.volume(Operation::Union) + both, a + b, scale);
	EXPECT_NEAR(r.volume(Operation::FirstMinusSecond) + both, a, scale);
	EXPECT_NEAR(r.volume(Operation::SecondMinusFirst) + both, b, scale);
	EXPECT_NEAR(r.volume(Operation::SymmetricDifference) + 2 * both, a + b, scale);
	EXPECT_LT(r.audit.volumeLawResidual, 1e-13);
	for (std::size_t i = 0; i < r.blocks.size(); ++i) {
		const Block& block = r.blocks[i];
		EXPECT_TRUE(isClosed(block.triangles)) << operationName(block.operation);
		EXPECT_TRUE(r.audit.blocks[i].closed);
		EXPECT_EQ(block.points.size(), block.vertexSource.size());
		EXPECT_EQ(block.triangles.size(), block.faceSource.size());
		std::vector<bool> used(block.points.size(), false);
		for (const auto& t : block.triangles) {
			for (const std::uint32_t v : t) {
				used[v] = true;
			}
		}
		EXPECT_EQ(std::count(used.begin(), used.end(), false), 0) << "unreferenced vertices";
	}
}

// Corners at generic places, so that no two faces of two boxes touch.
const Mesh kBoxA = box({0, 0, 0}, {4, 4, 4});
const Mesh kBoxB = box({1.25, 1.5, 1.75}, {5.25, 6.5, 7.75});

TEST(Blocks, boxesOverlappingAtACornerHaveTheirClosedFormVolumes) {
	const BooleanRun r = run(kBoxA, kBoxB);
	expectLaws(r);
	const double both = 2.75 * 2.5 * 2.25;
	EXPECT_DOUBLE_EQ(r.volume(Operation::Intersection), both);
	EXPECT_DOUBLE_EQ(r.volume(Operation::Union), 64 + 4 * 5 * 6 - both);
	EXPECT_EQ(r.arrangement.loopCounts.hardClosed, 1u);
	EXPECT_EQ(r.arrangement.loopCounts.softClosed, 0u);
	EXPECT_EQ(r.arrangement.loopCounts.open, 0u);
}

TEST(Blocks, boxesGiveEachOfTheirFaceVerticesUnchanged) {
	const BooleanRun r = run(kBoxA, kBoxB);
	for (const Block& block : r.blocks) {
		for (std::size_t v = 0; v < block.points.size(); ++v) {
			const VertexId source = block.vertexSource[v];
			EXPECT_EQ(
			    std::memcmp(&block.points[v], &r.arrangement.coordinates(source), sizeof(Point)),
			    0);
		}
	}
}

TEST(Blocks, aBarThroughABoxLeavesTwoEndsAndATunnel) {
	const BooleanRun r = run(kBoxA, box({-1, 1.25, 1.5}, {5, 2.25, 2.75}));
	expectLaws(r);
	EXPECT_DOUBLE_EQ(r.volume(Operation::Intersection), 4 * 1 * 1.25);
	EXPECT_EQ(r.audit.blocks[static_cast<std::size_t>(Operation::SecondMinusFirst)].components, 2u);
	EXPECT_EQ(r.audit.blocks[static_cast<std::size_t>(Operation::FirstMinusSecond)].components, 1u);
	EXPECT_EQ(r.arrangement.loopCounts.hardClosed, 2u);
}

TEST(Blocks, aWallOnAWallHasOneLoopAroundTheOverlap) {
	for (const Mesh& other : {box({4, 1, 1}, {5, 2, 2}), box({3, 1, 1}, {4, 2, 2})}) {
		const BooleanRun r = run(kBoxA, other);
		expectLaws(r);
		EXPECT_EQ(r.arrangement.loopCounts.hardClosed, 1u);
		EXPECT_EQ(r.arrangement.loopCounts.softClosed, 0u);
		EXPECT_EQ(r.arrangement.loopCounts.open, 0u);
	}
}

TEST(Blocks, disjointOperandsAreUnitedAsTheyAre) {
	const BooleanRun r = run(kBoxA, box({10, 10, 10}, {11, 12, 13}));
	expectLaws(r);
	EXPECT_EQ(r.block(Operation::Union).triangles.size(), 24u);
	EXPECT_TRUE(r.block(Operation::Intersection).triangles.empty());
	EXPECT_EQ(r.block(Operation::FirstMinusSecond).triangles.size(), 12u);
	EXPECT_EQ(r.audit.blocks[0].components, 2u);
}

TEST(Blocks, aNestedOperandBecomesACavity) {
	const BooleanRun r = run(kBoxA, box({1, 1.25, 1.5}, {2, 3, 3.5}));
	expectLaws(r);
	EXPECT_DOUBLE_EQ(r.volume(Operation::FirstMinusSecond), 64 - 1 * 1.75 * 2);
	EXPECT_EQ(r.block(Operation::FirstMinusSecond).triangles.size(), 24u);
	EXPECT_TRUE(r.block(Operation::SecondMinusFirst).triangles.empty());
	EXPECT_EQ(r.block(Operation::Union).triangles.size(), 12u);
}

TEST(Blocks, operandsWithCavitiesAndSeveralComponentsAreRight) {
	const Mesh hollow = joined(kBoxA, turned(box({0.5, 0.5, 0.5}, {3.5, 3.5, 3.5})));
	const Mesh two = joined(box({1, 1, 1}, {2, 2, 2.25}), box({3, 1.25, 1.5}, {6, 2.25, 2.5}));
	const BooleanRun r = run(hollow, two);
	expectLaws(r);
	EXPECT_EQ(r.arrangement.labels.components[kFirst], 2u);
	EXPECT_EQ(r.arrangement.labels.components[kSecond], 2u);
	// The small box floats in the cavity; the bar sticks through the wall of 0.5.
	EXPECT_DOUBLE_EQ(r.volume(Operation::Intersection), 0.5 * 1 * 1);
}

TEST(Blocks, aMeshInsideOutIsTurnedRightSideOut) {
	const BooleanRun straight = run(kBoxA, kBoxB);
	const BooleanRun turnedRun = run(turned(kBoxA), kBoxB);
	expectLaws(turnedRun);
	EXPECT_TRUE(turnedRun.arrangement.insideOut[kFirst]);
	EXPECT_FALSE(turnedRun.arrangement.insideOut[kSecond]);
	for (const Operation operation : kOperations) {
		EXPECT_EQ(geometry(straight.block(operation)), geometry(turnedRun.block(operation)));
	}
}

TEST(Blocks, aSoupOfTrianglesGivesTheSameAsTheWeldedMesh) {
	const BooleanRun welded = run(kBoxA, kBoxB);
	const BooleanRun loose = run(soup(kBoxA), soup(kBoxB));
	expectLaws(loose);
	for (const Operation operation : kOperations) {
		EXPECT_EQ(geometry(welded.block(operation)), geometry(loose.block(operation)));
	}
}

TEST(Blocks, negativeZeroEqualsZeroWhenCornersAreWelded) {
	Mesh loose = soup(kBoxA);
	for (std::size_t v = 0; v < loose.points.size(); v += 2) {
		for (double& c : loose.points[v]) {
			c = c == 0 ? -0.0 : c;
		}
	}
	expectLaws(run(loose, kBoxB));
}

TEST(Blocks, degenerateFacesOfTheInputAreSplitAwayAndLeaveItClosed) {
	// A flat face in an edge of the box: corners 0, 1 and the middle of the edge between them.
	Mesh flat = kBoxA;
	flat.points.push_back({2, 0, 0});
	auto& t = flat.triangles;
	const auto it = std::find(t.begin(), t.end(), (std::array<std::uint32_t, 3>{0, 3, 1}));
	*it = {0, 3, 8};
	t.push_back({8, 3, 1});
	t.push_back({0, 8, 1});
	ASSERT_TRUE(isClosed(t));
	const BooleanRun r = run(flat, kBoxB);
	expectLaws(r);
	EXPECT_DOUBLE_EQ(r.volume(Operation::Intersection), 2.75 * 2.5 * 2.25);
}

TEST(Blocks, theSameBytesForAnyNumberOfThreads) {
	std::mt19937 random(5);
	const Mesh a = placed(sphere(40, {0, 0, 0}, 1), random, 0.1);
	const Mesh b = placed(torus(60, 30, 1, 0.4), random, 0.3);
	std::vector<BooleanRun> runs;
	for (const int threads : {1, 2, 8, 2}) {
		Options options;
		options.threads = threads;
		runs.push_back(run(a, b, options));
		expectLaws(runs.back());
	}
	for (std::size_t i = 1; i < runs.size(); ++i) {
		for (const Operation operation : kOperations) {
			EXPECT_EQ(runs[0].block(operation).points, runs[i].block(operation).points);
			EXPECT_EQ(runs[0].block(operation).triangles, runs[i].block(operation).triangles);
		}
		for (std::size_t k = 0; k < runs[0].audit.blocks.size(); ++k) {
			EXPECT_EQ(runs[0].audit.blocks[k].volume, runs[i].audit.blocks[k].volume);
			EXPECT_EQ(runs[0].audit.blocks[k].area, runs[i].audit.blocks[k].area);
		}
	}
}

// Two random shapes that meet in general position.
std::pair<Mesh, Mesh> randomPair(std::uint32_t seed, std::mt19937& random) {
	const auto shape = [&random](std::uint32_t kind) {
		switch (kind % 4) {
		case 0:
			return placed(sphere(4 + kind % 9, {0, 0, 0}, 1), random, 0.6);
		case 1:
			return placed(torus(5 + kind % 11, 4 + kind % 7, 1, 0.45), random, 0.6);
		case 2:
			return placed(box({-1, -0.7, -0.5}, {0.8, 0.9, 1}), random, 0.6);
		default:
			return joined(placed(box({-1, -1, -1}, {-0.2, 0.5, 0.3}), random, 0.1),
			              placed(sphere(5, {3, 0, 0}, 0.8), random, 0.1));
		}
	};
	const Mesh a = shape(seed);
	return {a, shape(seed / 4 + seed % 7)};
}

TEST(Blocks, randomPairsObeyTheLawsInAnyOrderAndNumbering) {
	for (std::uint32_t seed = 0; seed < 300; ++seed) {
		SCOPED_TRACE("seed " + std::to_string(seed));
		std::mt19937 random(seed);
		const auto [a, b] = randomPair(seed, random);
		const BooleanRun straight = run(a, b);
		if (straight.status.code == StatusCode::SelfIntersecting ||
		    straight.status.code == StatusCode::NestedComponents) {
			continue;  // the two parts of one operand fell on each other: rightly refused
		}
		expectLaws(straight);
		const BooleanRun other = run(permuted(b, random), permuted(a, random));
		expectLaws(other);
		constexpr std::array<Operation, 5> kSwapped{
		    Operation::Union, Operation::Intersection, Operation::SecondMinusFirst,
		    Operation::FirstMinusSecond, Operation::SymmetricDifference};
		for (std::size_t k = 0; k < kOperations.size(); ++k) {
			EXPECT_EQ(geometry(straight.block(kOperations[k])), geometry(other.block(kSwapped[k])))
			    << operationName(kOperations[k]);
		}
		if (HasFailure()) {
			return;
		}
	}
}

TEST(Blocks, floatOutputIsClosedWithoutZeroAreaAndRoundsOnce) {
	std::mt19937 random(11);
	Options options;
	options.outputScalar = OutputScalar::Float;
	for (int i = 0; i < 20; ++i) {
		Mesh a = placed(sphere(16, {0, 0, 0}, 1), random, 0.4);
		Mesh b = placed(torus(24, 12, 1, 0.3), random, 0.4);
		for (Mesh* m : {&a, &b}) {
			for (Point& p : m->points) {
				for (double& c : p) {
					c = static_cast<double>(static_cast<float>(c));
				}
			}
		}
		const BooleanRun r = run(a, b, options);
		ASSERT_TRUE(r.status.ok()) << describe(r.status);
		for (const Block& block : r.blocks) {
			EXPECT_TRUE(isClosed(block.triangles));
			for (const Point& p : block.points) {
				for (const double c : p) {
					EXPECT_EQ(c, static_cast<double>(static_cast<float>(c)));
				}
			}
		}
		EXPECT_LT(r.audit.volumeLawResidual, 1e-6);
	}
}

void expectRefused(const Mesh& a, const Mesh& b, StatusCode code, int operand, std::size_t count) {
	const BooleanRun r = run(a, b);
	EXPECT_EQ(r.status.code, code) << statusName(r.status.code);
	EXPECT_EQ(r.status.operand, operand);
	EXPECT_EQ(r.status.count, count);
	EXPECT_FALSE(describe(r.status).empty());
}

TEST(Refusals, anOperandWithoutFaces) {
	expectRefused(kBoxA, Mesh{}, StatusCode::EmptyOperand, 1, 0);
	expectRefused(Mesh{}, kBoxA, StatusCode::EmptyOperand, 0, 0);
}

TEST(Refusals, coordinatesThatAreNotFinite) {
	Mesh bad = kBoxB;
	bad.points[7][1] = std::nan("");
	expectRefused(kBoxA, bad, StatusCode::NotFinite, 1, 6);
	bad.points[7][1] = HUGE_VAL;
	expectRefused(bad, kBoxA, StatusCode::NotFinite, 0, 6);
}

TEST(Refusals, aVertexThatIsNotFiniteButUnusedDoesNotMatter) {
	Mesh loose = kBoxB;
	loose.points.push_back({std::nan(""), 0, 0});
	expectLaws(run(kBoxA, loose));
}

TEST(Refusals, facesThatNameMissingVertices) {
	Mesh bad = kBoxB;
	bad.triangles[3][2] = 8;
	expectRefused(kBoxA, bad, StatusCode::IndexOutOfRange, 1, 1);
}

TEST(Refusals, anOpenOperandWithItsBorderFaces) {
	Mesh open = kBoxB;
	open.triangles.pop_back();
	expectRefused(kBoxA, open, StatusCode::NotClosed, 1, 3);
	EXPECT_EQ(run(open, kBoxA).status.faces.size(), 3u);
}

TEST(Refusals, facesThatRunAgainstTheirNeighbours) {
	Mesh bad = kBoxB;
	std::swap(bad.triangles[5][0], bad.triangles[5][1]);
	expectRefused(kBoxA, bad, StatusCode::NotOriented, 1, 3);
}

TEST(Refusals, aFlatMeshThatEnclosesNothing) {
	Mesh flat;
	flat.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
	flat.triangles = {{0, 1, 2}, {0, 2, 1}};
	expectRefused(kBoxA, flat, StatusCode::NoVolume, 1, 0);
}

TEST(Refusals, oneComponentInsideOutAmongOthers) {
	const Mesh bad = joined(kBoxB, turned(box({20, 20, 20}, {21, 21, 21})));
	expectRefused(kBoxA, bad, StatusCode::NestedComponents, 1, 1);
}

TEST(Refusals, nestedShellsBothOutwardAreNotTakenForACavity) {
	const Mesh nested = joined(box({0, 0, 0}, {10, 10, 10}), box({2, 2, 2}, {6, 6, 6}));
	expectRefused(nested, box({5, 3.125, 3.5}, {7, 4.0625, 4.25}), StatusCode::NestedComponents, 0,
	              1);
}

TEST(Refusals, componentsThatOverlapWhereTheVolumeLawsCannotTell) {
	const Mesh overlapping = joined(box({0, 0, 0}, {4, 4, 4}), box({3, -1, -1.5}, {9, 5, 5.25}));
	const BooleanRun r = run(overlapping, box({3.5, 1, 1.25}, {5, 2, 2.5}));
	EXPECT_EQ(r.status.code, StatusCode::SelfIntersecting) << statusName(r.status.code);
	EXPECT_EQ(r.status.operand, 0);
	EXPECT_FALSE(r.status.faces.empty());
}

TEST(Contacts, boxesThatShareAFaceAnEdgeAVertexOrMoreAreRight) {
	const Mesh unit = box({0, 0, 0}, {1, 1, 1});
	struct Case {
		Mesh other;
		double both;
	};
	for (const Case& c :
	     {Case{box({1, 0, 0}, {2, 1, 1}), 0}, Case{box({1, 1, 0}, {2, 2, 1}), 0},
	      Case{box({1, 1, 1}, {2, 2, 2}), 0}, Case{box({0.25, 0.25, 0}, {0.5, 0.5, 1}), 0.0625},
	      Case{box({-1, 0.5, 0.5}, {2, 0.75, 1}), 0.125}, Case{unit, 1},
	      Case{box({1, 0.25, 0.25}, {2, 0.75, 0.75}), 0},
	      Case{box({0, 0, 0}, {0.5, 0.5, 0.5}), 0.125},
	      Case{box({0.5, 0.5, 0.5}, {2, 2, 1}), 0.125}, Case{box({0.5, 0, 0}, {1.5, 1, 1}), 0.5},
	      Case{box({-1, -1, 0}, {2, 2, 0.5}), 0.5}}) {
		for (const bool swap : {false, true}) {
			const BooleanRun r = swap ? run(c.other, unit) : run(unit, c.other);
			expectLaws(r);
			if (r.status.ok()) {
				EXPECT_DOUBLE_EQ(r.volume(Operation::Intersection), c.both);
			}
		}
	}
}

TEST(Refusals, aVertexInThePlaneOfAFaceBesideItIsNoContact) {
	// The second box's lower corners lie in the plane z = 0 of the first one's floor, beside it.
	expectLaws(run(box({0, 0, 0}, {1, 1, 1}), box({2, 0.25, 0}, {3, 0.5, 1})));
}

TEST(Cancelling, stopsTheRunAtAnyStage) {
	std::mt19937 random(3);
	const Mesh a = placed(sphere(60, {0, 0, 0}, 1), random, 0.1);
	const Mesh b = placed(sphere(60, {0, 0, 0}, 1), random, 0.3);
	std::vector<std::string> stages;
	Monitor listening([&stages](double, const char* stage) {
		if (stages.empty() || stages.back() != stage) {
			stages.push_back(stage);
		}
		return true;
	});
	Arrangement arrangement;
	ASSERT_TRUE(arrange(arrays(a, b), {}, listening, arrangement).ok());
	ASSERT_GE(stages.size(), 7u);
	for (const std::string& stop : stages) {
		Monitor monitor([&stop](double, const char* stage) { return stage != stop; });
		EXPECT_EQ(arrange(arrays(a, b), {}, monitor, arrangement).code, StatusCode::Cancelled)
		    << stop;
	}
}

TEST(Scale, operandsOfAnyMagnitudeAndPlaceAreRight) {
	std::mt19937 random(17);
	const Mesh a = placed(sphere(10, {0, 0, 0}, 1), random, 0.1);
	const Mesh b = placed(torus(12, 8, 1, 0.4), random, 0.3);
	const BooleanRun reference = run(a, b);
	expectLaws(reference);
	for (const int exponent : {-300, -100, 100, 300}) {
		Mesh c = a, d = b;
		for (Mesh* m : {&c, &d}) {
			for (Point& p : m->points) {
				for (double& x : p) {
					x = std::ldexp(x, exponent);
				}
			}
		}
		const BooleanRun scaled = run(c, d);
		ASSERT_TRUE(scaled.status.ok()) << exponent << " " << describe(scaled.status);
		EXPECT_EQ(scaled.block(Operation::Union).triangles,
		          reference.block(Operation::Union).triangles)
		    << exponent;
		if (std::abs(exponent) <= 100) {
			for (std::size_t v = 0; v < reference.block(Operation::Union).points.size(); ++v) {
				for (std::size_t k = 0; k < 3; ++k) {
					EXPECT_EQ(scaled.block(Operation::Union).points[v][k],
					          std::ldexp(reference.block(Operation::Union).points[v][k], exponent));
				}
			}
		}
	}
	Mesh c = a, d = b;
	for (Mesh* m : {&c, &d}) {
		for (Point& p : m->points) {
			p[0] += 1e6;
		}
	}
	const BooleanRun far = run(c, d);
	ASSERT_TRUE(far.status.ok());
	EXPECT_EQ(far.arrangement.loopCounts.hardClosed, reference.arrangement.loopCounts.hardClosed);
}

// No arrangement has such labels; whatever they are, no other rule is read.
TEST(Blocks, labelsWithoutARuleKeepNothing) {
	BooleanRun r = run(box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3}));
	ASSERT_TRUE(r.status.ok());
	Monitor monitor;
	for (const Label label : {Label::OnVertex, Label::Unused, Label::Unknown}) {
		std::vector<Label>& pieces = r.arrangement.labels.piece;
		std::vector<Label>& vertices = r.arrangement.labels.vertex;
		std::fill(pieces.begin(), pieces.end(), label);
		std::fill(vertices.begin(), vertices.end(), label);
		for (int k = 0; k < kOperationCount; ++k) {
			Block block;
			ASSERT_TRUE(
			    collectBlock(r.arrangement, static_cast<Operation>(k), monitor, block).ok());
			EXPECT_TRUE(block.triangles.empty());
			EXPECT_TRUE(block.points.empty());
		}
	}
}

}  // namespace
}  // namespace index_boolean
