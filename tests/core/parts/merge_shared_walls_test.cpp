// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pieces with merged walls: they are as few faces as they should be, fit together as before, and
// say that they hold.
#include "core/near_coplanar.h"
#include "core/split_operands.h"
#include "core/wrong_faces.h"

#include <gtest/gtest.h>

#include <set>

namespace index_boolean {
namespace {

using namespace shapes;

const Clip kInside{kFirst, kSecond, true}, kOutside{kFirst, kSecond, false};

Options merging(double tolerance) {
	Options options = onOneThread();
	options.mergeTolerance = tolerance;
	options.selfIntersections = SelfIntersections::Resolve;
	return options;
}

Triangles3 turnedAll(const Triangles3& triangles) {
	Triangles3 all;
	for (Corners c : triangles) {
		std::swap(c[1], c[2]);
		std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
		all.push_back(c);
	}
	std::sort(all.begin(), all.end());
	return all;
}

// Each piece holds; each triangle of a piece is that of its operand, or a neighbour's turned over.
void expectFitting(const OperandsSplit& r) {
	ASSERT_TRUE(r.status.ok()) << describe(r.status);
	Triangles3 ofOperands;
	for (const SplitMesh& mesh : r.surfaces) {
		EXPECT_EQ(mesh.certificate.count(), 0);
		for (const Triangles3& part : {placesOf(mesh), turnedAll(placesOf(mesh))}) {
			ofOperands.insert(ofOperands.end(), part.begin(), part.end());
		}
	}
	const std::set<Corners> known(ofOperands.begin(), ofOperands.end());
	for (const SplitMesh& mesh : r.blocks) {
		EXPECT_EQ(mesh.certificate.count(), 0);
		EXPECT_EQ(faultsOf(mesh.points, mesh.triangles), 0U);
		EXPECT_TRUE(isClosed(mesh.triangles));
		for (const Corners& c : placesOf(mesh)) {
			EXPECT_EQ(known.count(c), 1U);
		}
	}
}

std::vector<std::size_t> faceCounts(const std::vector<SplitMesh>& meshes) {
	std::vector<std::size_t> counts;
	for (const SplitMesh& mesh : meshes) {
		counts.push_back(mesh.triangles.size());
	}
	std::sort(counts.begin(), counts.end());
	return counts;
}

}  // namespace

TEST(MergeSharedWalls, aShakenCubeCutByASheetHasTheWallsOfTwoBoxes) {
	for (const unsigned seed : {1U, 2U, 3U}) {
		std::mt19937 random(seed);
		const Mesh cube = shaken(squaredCube(4, random), 1e-13, random);
		const Mesh sheet = rectangle({0.6, -1, -1}, {0.6, 2, -1}, {0.6, 2, 2}, {0.6, -1, 2});
		const OperandsSplit cut = splitAll({cube, sheet}, merging(0));
		const OperandsSplit r = splitAll({cube, sheet}, merging(1e-11));
		expectFitting(r);
		EXPECT_EQ(faceCounts(r.blocks), (std::vector<std::size_t>{12, 12}));
		EXPECT_GT(faceCounts(cut.blocks).front(), 60U);
		EXPECT_EQ(r.surfaces[0].triangles.size(), 20U);
		EXPECT_GT(r.split.surfaces.wallMerge.vertices, 80U);
		EXPECT_LT(r.split.surfaces.wallMerge.largestMove, 1e-12);
		EXPECT_NEAR(volumeOf(r.blocks[0].points, r.blocks[0].triangles) +
		                volumeOf(r.blocks[1].points, r.blocks[1].triangles),
		            1, 1e-11);
	}
}

TEST(MergeSharedWalls, aWallOfTwoOperandsIsMergedOnce) {
	std::mt19937 random(4);
	const Mesh cube = squaredCube(3, random);
	Mesh beside = squaredCube(2, random);
	for (Point& p : beside.points) {
		p[0] += 1;
	}
	const OperandsSplit r = splitAll({cube, beside}, merging(1e-9));
	expectFitting(r);
	EXPECT_EQ(faceCounts(r.blocks), (std::vector<std::size_t>{12, 12}));
}

TEST(MergeSharedWalls, turnedBoxesThatCutEachOther) {
	for (const OutputScalar scalar : {OutputScalar::Double, OutputScalar::Float}) {
		std::mt19937 random(5);
		Options options = merging(scalar == OutputScalar::Float ? 3e-6 : 1e-11);
		options.outputScalar = scalar;
		std::vector<Mesh> boxes;
		for (int i = 0; i < 4; ++i) {
			boxes.push_back(placed(shaken(squaredCube(3, random), 1e-13, random), random, 0.2));
		}
		const OperandsSplit r = splitAll(boxes, options);
		expectFitting(r);
		Options unmerged = options;
		unmerged.mergeTolerance = 0;
		const OperandsSplit cut = splitAll(boxes, unmerged);
		ASSERT_EQ(r.volumes(), cut.volumes());
		EXPECT_TRUE(r.audit.closed);
		std::size_t before = 0, after = 0;
		for (std::size_t i = 0; i < r.blocks.size(); ++i) {
			before += cut.blocks[i].triangles.size();
			after += r.blocks[i].triangles.size();
			EXPECT_EQ(eulerNumber(r.blocks[i].triangles), eulerNumber(cut.blocks[i].triangles));
			EXPECT_NEAR(volumeOf(r.blocks[i].points, r.blocks[i].triangles),
			            r.split.blocks.all[i].volume, 20 * options.mergeTolerance);
		}
		EXPECT_LT(2 * after, before);
	}
}

TEST(MergeSharedWalls, clipsHaveTheWallsOfThePieces) {
	std::mt19937 random(6);
	const Mesh cube = shaken(squaredCube(4, random), 1e-13, random);
	const OperandsSplit r =
	    splitAll({cube, box({0.6, -1, -1}, {3, 2, 2})}, merging(1e-11), {kInside, kOutside});
	expectFitting(r);
	EXPECT_EQ(faceCounts(r.clips), (std::vector<std::size_t>{10, 10}));
	for (const SplitMesh& clip : r.clips) {
		EXPECT_EQ(clip.certificate.count(), 0);
	}
}

}  // namespace index_boolean
