// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The repair of stored places: what is wrong before and after, on pairs that rounding folds, and on
// those that it does not.
#include "core/shapes.h"
#include "core/wrong_faces.h"

#include <vcg_ext/arrange/piece_patches.h>
#include <vcg_ext/arrange/places.h>
#include <vcg_ext/arrange/repair_places.h>
#include <vcg_ext/arrange/stored_faults.h>

#include <gtest/gtest.h>

#include <map>
#include <numeric>
#include <set>

namespace index_boolean {
namespace {

using namespace shapes;

Mesh movedBy(Mesh m, double x) {
	for (Point& p : m.points) {
		p[0] += x;
	}
	return m;
}

// A box on whole squares, of height 1, turned by 30 degrees.
Mesh gridBoxAboutZ(double x, double right, double y, double back) {
	Mesh m = box({x, y, 0}, {right, back, 1});
	const double c = std::cos(kPi / 6), s = std::sin(kPi / 6);
	for (Point& p : m.points) {
		p = {c * p[0] - s * p[1], s * p[0] + c * p[1], p[2]};
	}
	return m;
}

// Two tori with one inner radius, the second upright, as in the paper: nearly coplanar faces cross
// in needles.
constexpr std::uint32_t kRings = 24, kSides = 16;
Mesh firstTorus() { return torus(kRings, kSides, 1, .4); }
Mesh secondTorus() { return turnedAboutX(firstTorus(), kPi / 2); }

std::vector<std::size_t> faultsOfBlocks(const BooleanRun& r) {
	std::vector<std::size_t> faults;
	for (const Block& block : r.blocks) {
		faults.push_back(faultsOf(block.points, block.triangles));
	}
	return faults;
}

std::size_t sum(const std::vector<std::size_t>& counts) {
	std::size_t all = 0;
	for (const std::size_t count : counts) {
		all += count;
	}
	return all;
}

std::set<std::array<Point, 2>> movesOf(const Arrangement& arrangement) {
	std::set<std::array<Point, 2>> moves;  // from, to
	for (const auto& [vertex, place] : arrangement.movedPlaces) {
		moves.insert({roundedPlace(arrangement, vertex), place});
	}
	return moves;
}

Options withThreads(int threads, bool certify = true) {
	Options options;
	options.threads = threads;
	options.certify = certify;
	return options;
}

struct Pair {
	const char* name;
	Mesh a, b;
	OutputScalar scalar;
};

std::vector<Pair> foldedPairs() {
	const Mesh ball = sphere(12, {0, 0, 0}, 1);
	return {{"tori", firstTorus(), secondTorus(), OutputScalar::Double},
	        {"tori in floats", firstTorus(), secondTorus(), OutputScalar::Float},
	        {"spheres an ulp apart", ball, movedBy(ball, 1e-15), OutputScalar::Double}};
}

// Which need an input vertex moved.
Pair boxesOnATurnedGrid() {
	return {"boxes on a turned grid", gridBoxAboutZ(0, 4, 1, 6), gridBoxAboutZ(4, 5, 0, 2),
	        OutputScalar::Double};
}

std::vector<Pair> pairsOfAllKinds() {
	std::vector<Pair> pairs = foldedPairs();
	pairs.push_back(boxesOnATurnedGrid());
	return pairs;
}

TEST(RepairPlaces, leavesNothingWrongInAnyBlock) {
	for (const Pair& pair : foldedPairs()) {
		Options options;
		options.outputScalar = pair.scalar;
		options.certify = false;
		const BooleanRun asRounded = run(pair.a, pair.b, options);
		options.certify = true;
		const BooleanRun repaired = run(pair.a, pair.b, options);
		ASSERT_TRUE(asRounded.status.ok() && repaired.status.ok()) << pair.name;
		EXPECT_GT(sum(faultsOfBlocks(asRounded)), 0U) << pair.name;
		EXPECT_EQ(faultsOfBlocks(repaired), std::vector<std::size_t>(kOperationCount)) << pair.name;
		const PlaceRepair& report = repaired.arrangement.placeRepair;
		EXPECT_GT(report.faultsBefore, 0U) << pair.name;
		EXPECT_GT(report.concernedBefore, 0U) << pair.name;
		EXPECT_EQ(report.faultsAfter + report.concernedAfter, 0U) << pair.name;
		EXPECT_FALSE(report.isGivenUp) << pair.name;
		EXPECT_FALSE(repaired.arrangement.movedPlaces.empty()) << pair.name;
	}
}

// What is counted on the refined surfaces is what the symmetric difference has, which keeps all
// pieces but those of overlaps.
TEST(RepairPlaces, countsWhatTheBlocksWouldHave) {
	const BooleanRun asRounded = run(firstTorus(), secondTorus(), withThreads(2, false));
	const BooleanRun repaired = run(firstTorus(), secondTorus());
	const Block& either = asRounded.block(Operation::SymmetricDifference);
	EXPECT_EQ(repaired.arrangement.placeRepair.faultsBefore,
	          faultsOf(either.points, either.triangles));
}

TEST(RepairPlaces, movesLittle) {
	for (const Pair& pair : pairsOfAllKinds()) {
		Options options;
		options.outputScalar = pair.scalar;
		const BooleanRun r = run(pair.a, pair.b, options);
		const double unit = pair.scalar == OutputScalar::Double ? 0x1p-52 : 0x1p-23;
		double largest = 0;
		for (const auto& [from, to] : movesOf(r.arrangement)) {
			double square = 0;
			for (std::size_t k = 0; k < 3; ++k) {
				square += (to[k] - from[k]) * (to[k] - from[k]);
			}
			largest = std::max(largest, std::sqrt(square));
		}
		EXPECT_LE(largest, 32 * unit * std::sqrt(3)) << pair.name;
		if (r.arrangement.again == nullptr) {  // else the rounding loop has moved others
			EXPECT_NEAR(r.arrangement.placeRepair.largestMove, largest, 1e-9 * largest)
			    << pair.name;
		}
	}
}

std::size_t countMovedInputs(const Arrangement& arrangement) {
	std::size_t count = 0;
	for (const auto& [vertex, place] : arrangement.movedPlaces) {
		count += arrangement.isCurvePoint(vertex) ? 0 : 1;
		EXPECT_NE(place, roundedPlace(arrangement, vertex));
		EXPECT_EQ(place, outputCoordinates(arrangement, vertex));
		EXPECT_FALSE(isStoredExactly(arrangement, vertex));
	}
	return count;
}

TEST(RepairPlaces, movesInputVerticesLast) {
	for (const Pair& pair : foldedPairs()) {
		Options options;
		options.outputScalar = pair.scalar;
		const BooleanRun r = run(pair.a, pair.b, options);
		EXPECT_LT(4 * countMovedInputs(r.arrangement), r.arrangement.movedPlaces.size())
		    << pair.name;
	}
}

TEST(RepairPlaces, movesAnInputVertexIfNothingElseHelps) {
	const Pair pair = boxesOnATurnedGrid();
	const BooleanRun r = run(pair.a, pair.b);
	ASSERT_TRUE(r.status.ok()) << describe(r.status);
	EXPECT_GT(countMovedInputs(r.arrangement), 0U);
	for (const Block& block : r.blocks) {
		if (block.operation != Operation::SymmetricDifference) {
			EXPECT_EQ(faultsOf(block.points, block.triangles), 0U)
			    << operationName(block.operation);
			EXPECT_EQ(block.certificate.count(), 0) << operationName(block.operation);
		}
	}
	EXPECT_NEAR(r.volume(Operation::Union), 22, 1e-13);
}

// Else a face at one might come to meet another wrongly, and nobody would know.
TEST(RepairPlaces, mayMoveInputVerticesIfAllIsThereThatTheirFacesMeet) {
	const BooleanRun r = run(sphere(12, {0, 0, 0}, 1), sphere(12, {1, .3, .2}, 1));
	const Arrangement& arrangement = r.arrangement;
	const Triangles& triangles = arrangement.mesh.triangles;
	StoredSurface surface;
	Monitor monitor;
	ASSERT_TRUE(collectStoredSurface(arrangement, 1e-14, monitor, surface).ok());
	std::set<VertexId> movable, around;
	for (std::size_t v = 0; v < surface.vertices.size(); ++v) {
		if (surface.isWhole[v] != 0 && !arrangement.isCurvePoint(surface.vertices[v])) {
			movable.insert(surface.vertices[v]);
		}
	}
	const auto isAt = [](const Triangle& t, const std::set<VertexId>& vertices) {
		return std::any_of(t.begin(), t.end(), [&](VertexId v) { return vertices.count(v) != 0; });
	};
	for (const Triangle& t : triangles) {
		if (isAt(t, movable)) {
			around.insert(t.begin(), t.end());
		}
	}
	const std::set<FaceId> here(surface.inputFaces.begin(), surface.inputFaces.end());
	std::size_t count = 0;
	for (std::size_t f = 0; f < triangles.size(); ++f) {
		const bool mayMeet = isAt(triangles[f], around);
		count += mayMeet ? 1 : 0;
		EXPECT_TRUE(!mayMeet || here.count(makeId<FaceTag>(f)) != 0) << f;
	}
	EXPECT_GT(count, 0U);
	EXPECT_LT(here.size(), triangles.size());
	ASSERT_TRUE(collectStoredSurface(arrangement, 0, monitor, surface).ok());
	for (std::size_t v = 0; v < surface.vertices.size(); ++v) {
		EXPECT_EQ(surface.isWhole[v] != 0, arrangement.isCurvePoint(surface.vertices[v]));
	}
}

TEST(RepairPlaces, doesNothingWhereNothingIsWrong) {
	std::mt19937 random(7);
	for (int round = 0; round < 20; ++round) {
		const Mesh a = placed(sphere(8, {0, 0, 0}, 1), random, .1);
		const Mesh b = placed(torus(12, 8, 1, .4), random, .3);
		const BooleanRun repaired = run(a, b), asRounded = run(a, b, withThreads(2, false));
		ASSERT_TRUE(repaired.status.ok()) << round;
		EXPECT_TRUE(repaired.arrangement.movedPlaces.empty()) << round;
		EXPECT_EQ(repaired.arrangement.placeRepair.faultsBefore, 0U) << round;
		for (std::size_t k = 0; k < repaired.blocks.size(); ++k) {
			EXPECT_EQ(repaired.blocks[k].triangles, asRounded.blocks[k].triangles) << round;
			EXPECT_EQ(repaired.blocks[k].points, asRounded.blocks[k].points) << round;
		}
	}
}

TEST(RepairPlaces, isSwitchedOff) {
	const BooleanRun r = run(firstTorus(), secondTorus(), withThreads(2, false));
	EXPECT_TRUE(r.arrangement.movedPlaces.empty());
	EXPECT_EQ(r.arrangement.placeRepair.faultsBefore, 0U);
	EXPECT_EQ(r.arrangement.placeRepair.trials, 0U);
}

TEST(RepairPlaces, isTheSameForAnyNumberOfThreads) {
	for (const Pair& pair : pairsOfAllKinds()) {
		Options options = withThreads(1);
		options.outputScalar = pair.scalar;
		const BooleanRun one = run(pair.a, pair.b, options);
		for (const int threads : {2, 5}) {
			options.threads = threads;
			const BooleanRun many = run(pair.a, pair.b, options);
			EXPECT_EQ(many.arrangement.movedPlaces, one.arrangement.movedPlaces) << pair.name;
			EXPECT_EQ(many.arrangement.placeRepair.trials, one.arrangement.placeRepair.trials);
			for (std::size_t k = 0; k < one.blocks.size(); ++k) {
				EXPECT_EQ(many.blocks[k].triangles, one.blocks[k].triangles) << pair.name;
				EXPECT_EQ(many.blocks[k].points, one.blocks[k].points) << pair.name;
			}
		}
	}
}

TEST(RepairPlaces, isTheSameInAnyNumbering) {
	std::mt19937 random(11);
	for (const Pair& pair : pairsOfAllKinds()) {
		Options options;
		options.outputScalar = pair.scalar;
		const BooleanRun first = run(pair.a, pair.b, options);
		for (int round = 0; round < 3; ++round) {
			const BooleanRun other =
			    run(permuted(pair.a, random), permuted(pair.b, random), options);
			EXPECT_EQ(movesOf(other.arrangement), movesOf(first.arrangement)) << pair.name;
			EXPECT_EQ(other.arrangement.placeRepair.trials, first.arrangement.placeRepair.trials);
			for (std::size_t k = 0; k < first.blocks.size(); ++k) {
				EXPECT_EQ(geometry(other.blocks[k]), geometry(first.blocks[k])) << pair.name;
			}
		}
	}
}

TEST(RepairPlaces, isTheSameWithOperandsSwapped) {
	for (const Pair& pair : pairsOfAllKinds()) {
		Options options;
		options.outputScalar = pair.scalar;
		const BooleanRun there = run(pair.a, pair.b, options), back = run(pair.b, pair.a, options);
		EXPECT_EQ(movesOf(there.arrangement), movesOf(back.arrangement)) << pair.name;
		const std::array<std::array<Operation, 2>, 4> same{
		    {{Operation::Union, Operation::Union},
		     {Operation::Intersection, Operation::Intersection},
		     {Operation::FirstMinusSecond, Operation::SecondMinusFirst},
		     {Operation::SecondMinusFirst, Operation::FirstMinusSecond}}};
		for (const auto& [a, b] : same) {
			EXPECT_EQ(geometry(there.block(a)), geometry(back.block(b))) << pair.name;
		}
	}
}

// Walls nearer to each other than floats are touch as floats.
TEST(RepairPlaces, operandsAreRoundedFirstWhereThatHelps) {
	const Mesh ball = sphere(40, {0, 0, 0}, 1);
	Options options;
	options.outputScalar = OutputScalar::Float;
	const BooleanRun r = run(ball, movedBy(ball, 1e-9), options);
	ASSERT_TRUE(r.status.ok()) << describe(r.status);
	EXPECT_EQ(r.arrangement.placeRepair.faultsAfter, 0U);
	EXPECT_EQ(r.arrangement.options.selfIntersections, SelfIntersections::Trust);
	for (const Point& p : r.arrangement.mesh.points) {
		EXPECT_EQ(p[0], static_cast<float>(p[0]));
	}
	for (const Block& block : r.blocks) {
		EXPECT_EQ(block.certificate.count(), 0);
	}
}

TEST(RepairPlaces, isCancelled) {
	bool isReached = false;
	Monitor monitor([&isReached](double, const char* stage) {
		isReached |= std::string(stage) == "repair_places";
		return !isReached;
	});
	Arrangement arrangement;
	const Status status = arrange(arrays(firstTorus(), secondTorus()), {}, monitor, arrangement);
	EXPECT_TRUE(isReached);
	EXPECT_EQ(status.code, StatusCode::Cancelled);
}

// Pieces stay a triangulation of the exact points, in their regions.
TEST(RepairPlaces, keepsPiecesAndRegions) {
	BooleanRun asRounded = run(firstTorus(), secondTorus(), withThreads(2, false));
	const BooleanRun repaired = run(firstTorus(), secondTorus());
	const Refinement &before = asRounded.arrangement.refinement,
	                 &after = repaired.arrangement.refinement;
	ASSERT_EQ(before.pieces.size(), after.pieces.size());
	EXPECT_EQ(before.pieceRegion, after.pieceRegion);
	std::map<std::uint32_t, std::multiset<std::uint32_t>> edges[2];
	for (std::size_t i = 0; i < after.cutFaces.size(); ++i) {
		const Triangle& face = at(repaired.arrangement.mesh.triangles, after.cutFaces[i].face);
		int front = 0;
		const int axis = projectionAxis(face, repaired.arrangement.mesh.points, front);
		const Refinement::PieceRange range = after.piecesOf(i);
		for (std::size_t piece = range.begin; piece < range.end; ++piece) {
			const Triangle& t = after.pieces[piece];
			EXPECT_EQ(orient2d(exactPoint(repaired.arrangement, t[0]),
			                   exactPoint(repaired.arrangement, t[1]),
			                   exactPoint(repaired.arrangement, t[2]), axis),
			          front);
			for (std::size_t k = 0; k < 3; ++k) {
				edges[0][after.pieceRegion[piece].value].insert(t[k].value);
				edges[1][before.pieceRegion[piece].value].insert(before.pieces[piece][k].value);
			}
		}
	}
	for (auto& [region, corners] : edges[0]) {
		const auto& old = edges[1][region];
		EXPECT_EQ(std::set<std::uint32_t>(corners.begin(), corners.end()),
		          std::set<std::uint32_t>(old.begin(), old.end()));
	}
}

// With its faces in front.
Mesh solid(Mesh m) { return volumeOf(m.points, m.triangles) < 0 ? turned(m) : m; }

// A wedge that stands on the plane z = 2 with an edge, and two tetrahedra on tips, one to each side
// of the middle of that edge: its two faces want it flipped, from tip to tip.
Mesh wedgeBetweenTips() {
	const Mesh wedge = solid(
	    {{{1.5, 1, 2}, {1.5, .9, 3}, {1.5, 1.1, 3}, {3.5, 1, 2}, {3.5, .9, 3}, {3.5, 1.1, 3}},
	     {{0, 1, 2}, {3, 5, 4}, {0, 3, 4}, {0, 4, 1}, {1, 4, 5}, {1, 5, 2}, {2, 5, 3}, {2, 3, 0}}});
	const auto tip = [](double y) {
		return solid({{{2.5, y, 2}, {2.4, y, 3}, {2.6, y, 3}, {2.5, y + (y - 1) / 4, 3}},
		              {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}});
	};
	return joined(wedge, joined(tip(.7), tip(1.3)));
}

// A segment that parts no regions stays an edge of two pieces.
TEST(PiecePatches, flipNoSegment) {
	BooleanRun r = run(box({0, 0, 0}, {4, 4, 2}), wedgeBetweenTips(), withThreads(2, false));
	ASSERT_TRUE(r.status.ok()) << describe(r.status);
	Arrangement& arrangement = r.arrangement;
	StoredSurface surface;
	Monitor monitor;
	const VertexId begin = arrangement.curve.segments.at(0).begin;
	const VertexId end = arrangement.curve.segments.at(0).end;
	arrangement.options.outputScalar = OutputScalar::Float;  // so that all faces are collected
	arrangement.mesh.points[0][0] = 1e-9;
	ASSERT_TRUE(collectStoredSurface(arrangement, 0, monitor, surface).ok());
	StoredFaults faults(arrangement, surface, std::vector<std::uint32_t>(surface.corners.size()),
	                    monitor);
	ASSERT_TRUE(faults.find().ok());
	const auto piecesAtSegment = [&] {
		std::size_t count = 0;
		for (std::size_t f = surface.firstPiece; f < surface.corners.size(); ++f) {
			std::size_t ends = 0;
			for (const std::uint32_t v : surface.corners[f]) {
				ends += surface.vertices[v] == begin || surface.vertices[v] == end ? 1 : 0;
			}
			count += ends == 2 && arrangement.mesh.operandOf(surface.inputFaces[f]) == kFirst;
		}
		return count;
	};
	ASSERT_EQ(piecesAtSegment(), 2U);
	std::vector<std::uint32_t> vertices(surface.vertices.size());
	std::iota(vertices.begin(), vertices.end(), 0U);
	PiecePatches patches(arrangement, faults, monitor);
	patches.flipAround(vertices);
	EXPECT_EQ(piecesAtSegment(), 2U);
}

// Faults that are kept up to date are those that a search finds; what is not better is undone.
TEST(StoredFaults, areThoseThatASearchFinds) {
	BooleanRun r = run(firstTorus(), secondTorus(), withThreads(2, false));
	Arrangement& arrangement = r.arrangement;
	Monitor monitor;
	StoredSurface surface;
	ASSERT_TRUE(collectStoredSurface(arrangement, 1e-14, monitor, surface).ok());
	const std::vector<std::uint32_t> oneClass(surface.corners.size());
	StoredFaults faults(arrangement, surface, oneClass, monitor);
	ASSERT_TRUE(faults.find().ok());
	std::mt19937 random(5);
	std::size_t keptCount = 0;
	for (int round = 0; round < 400; ++round) {
		const std::vector<std::uint32_t> concerned = faults.facesConcerned();
		if (concerned.empty()) {
			break;
		}
		const std::uint32_t face = concerned[random() % concerned.size()];
		const std::uint32_t v = surface.corners[face][random() % 3];
		const std::uint32_t u = surface.corners[face][random() % 3];
		Point place = random() % 2 == 0 ? faults.place(u) : faults.place(v);
		place[random() % 3] += (static_cast<int>(random() % 5) - 2) * 0x1p-52;
		const auto storedBefore = surface.stored;
		const std::size_t before = faults.count();
		if (!arrangement.isCurvePoint(surface.vertices[v])) {
			continue;
		}
		faults.setPlace(v, place);
		const bool isKept = faults.settle();
		EXPECT_EQ(isKept, faults.count() < before);
		EXPECT_LE(faults.count(), before);
		if (!isKept) {
			EXPECT_TRUE(surface.stored == storedBefore);
			continue;
		}
		++keptCount;
		arrangement.movedPlaces[surface.vertices[v]] = place;
		StoredSurface anew;
		ASSERT_TRUE(collectStoredSurface(arrangement, 1e-14, monitor, anew).ok());
		StoredFaults found(arrangement, anew, std::vector<std::uint32_t>(anew.corners.size()),
		                   monitor);
		ASSERT_TRUE(found.find().ok());
		ASSERT_EQ(found.count(), faults.count()) << "seed 5, round " << round;
	}
	EXPECT_GT(keptCount, 5U);
}

// A roof whose ridge is stored below its eaves' plane lies on itself, until the ridge moves up.
TEST(StoredFaults, seeAFoldGo) {
	Arrangement arrangement;
	StoredSurface surface;
	surface.vertices = {VertexId{0}, VertexId{1}, VertexId{2}, VertexId{3}};
	surface.places = {{0, 0, 0}, {4, 0, 0}, {2, 1, 0}, {2, 3, 0}};
	surface.placeOf = {0, 1, 2, 3};
	surface.corners = {{0, 1, 2}, {0, 1, 3}};  // both on one side of their common edge
	surface.stored = surface.corners;
	surface.inputFaces = {FaceId{0}, FaceId{1}};
	surface.isSuspect = {1, 1};
	arrangement.mesh.points = surface.places;
	arrangement.mesh.faceOffsets.setEnd(kFirst, 2);
	arrangement.mesh.faceOffsets.setEnd(kSecond, 2);
	Monitor monitor;
	StoredFaults faults(arrangement, surface, {0, 0}, monitor);
	ASSERT_TRUE(faults.find().ok());
	EXPECT_EQ(faults.count(), 1U);
	EXPECT_EQ(faults.facesConcerned(), (std::vector<std::uint32_t>{0, 1}));
	faults.setPlace(2, {2, 2, 0});
	EXPECT_FALSE(faults.settle());
	EXPECT_EQ(faults.place(2), (Point{2, 1, 0}));
	faults.setPlace(2, {2, 0, 0});  // a zero-area face instead of a pair
	EXPECT_FALSE(faults.settle());
	EXPECT_EQ(faults.count(), 1U);
	faults.setPlace(2, {2, -1, 0});
	EXPECT_TRUE(faults.settle());
	EXPECT_EQ(faults.count(), 0U);
	faults.setPlace(2, {2, 3, 0});
	EXPECT_FALSE(faults.settle());
	EXPECT_EQ(faults.place(2), (Point{2, -1, 0}));
}

}  // namespace
}  // namespace index_boolean
