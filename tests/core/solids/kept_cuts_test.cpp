// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which cuts a block keeps, and what it is made of then. That it holds so where it would fold
// otherwise, test_reports.py and the chains of turned boxes show.
#include "core/shapes.h"

#include <vcg_ext/solids/delaunay_pieces.h>
#include <vcg_ext/solids/kept_cuts.h>
#include <vcg_ext/solids/merge_fragments.h>

#include <gtest/gtest.h>

namespace index_boolean {
namespace {

using namespace shapes;

// A cube on which a small one stands: the large one's top has been cut for nothing.
BooleanRun twoCubes(bool mergeFragments) {
	Options options;
	options.mergeFragments = mergeFragments;
	return run(box({0, 0, 0}, {4, 4, 4}), box({1, 1, 4}, {2, 3, 5}), options);
}

std::vector<FaceId> cutFaces(const Arrangement& arrangement) {
	std::vector<FaceId> faces;
	for (const CutFace& cut : arrangement.refinement.cutFaces) {
		faces.push_back(cut.face);
	}
	std::sort(faces.begin(), faces.end());
	return faces;
}

Block merged(const Arrangement& arrangement, const std::vector<FaceId>& keptCuts) {
	Monitor monitor;
	Block block;
	EXPECT_TRUE(collectBlock(arrangement, Operation::FirstMinusSecond, monitor, block).ok());
	block.keptCuts = keptCuts;
	EXPECT_TRUE(mergeFragments(arrangement, monitor, block).ok());
	EXPECT_TRUE(makePiecesDelaunay(arrangement, monitor, block).ok());
	return block;
}

TEST(KeptCuts, aFaceThatKeepsItsCutsIsAsItWasCut) {
	const BooleanRun r = twoCubes(true);
	ASSERT_TRUE(r.status.ok());
	const std::vector<FaceId> all = cutFaces(r.arrangement);
	EXPECT_EQ(merged(r.arrangement, {}).triangles.size(), 12U);
	const Block cut = merged(r.arrangement, all);
	const BooleanRun unmerged = twoCubes(false);
	EXPECT_EQ(geometry(cut), geometry(unmerged.blocks[2]));
	EXPECT_GT(cut.triangles.size(), 12U);
	for (const FaceId one : all) {
		const Block block = merged(r.arrangement, {one});
		const auto ofOne = [one](const FaceSource& source) { return source.face == one; };
		EXPECT_EQ(std::count_if(block.faceSource.begin(), block.faceSource.end(), ofOne),
		          std::count_if(cut.faceSource.begin(), cut.faceSource.end(), ofOne));
	}
}

// A block of three faces of one input face each, some of them wrong.
Block blockWithWrong(std::vector<std::uint32_t> wrong) {
	Block block;
	block.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
	for (std::uint32_t f = 0; f < 3; ++f) {
		block.triangles.push_back({0, 1, 2});
		block.faceSource.push_back({FaceId{f}, false});
	}
	block.certificate.isKnown = true;
	block.certificate.faces = std::move(wrong);
	return block;
}

// What was asked for, and what became of a block, if each remake leaves these faces wrong.
struct Asked {
	std::vector<std::vector<FaceId>> kept;
	Block block;
	Status status;
};

Asked ask(std::vector<std::uint32_t> first, std::vector<std::vector<std::uint32_t>> later,
          bool mergeFragments = true, Status failure = {}) {
	Arrangement arrangement;
	arrangement.options.mergeFragments = mergeFragments;
	for (std::uint32_t f = 0; f < 4; ++f) {
		arrangement.refinement.cutFaces.push_back({});
		arrangement.refinement.cutFaces.back().face = FaceId{f};
	}
	Asked asked;
	asked.block = blockWithWrong(std::move(first));
	const auto remake = [&](const BlockVariant& variant, Block& out) {
		EXPECT_FALSE(variant.isPulledApartLast);
		asked.kept.push_back(variant.keptCuts);
		out = blockWithWrong(later[asked.kept.size() - 1]);
		return failure;
	};
	asked.status = keepCutsThatHold(arrangement, remake, asked.block);
	return asked;
}

constexpr FaceId a{0}, b{1}, c{2}, d{3};
using Lists = std::vector<std::vector<FaceId>>;

TEST(KeptCuts, aBlockThatHoldsOrMergesNothingIsLeftAlone) {
	EXPECT_TRUE(ask({}, {}).kept.empty());
	EXPECT_TRUE(ask({1}, {}, false).kept.empty());
}

TEST(KeptCuts, theCutsOfWrongFacesAreKeptUntilItHolds) {
	const Asked asked = ask({1, 2}, {{0}, {}});
	EXPECT_EQ(asked.kept, (Lists{{b, c}, {a, b, c}}));
	EXPECT_TRUE(asked.block.certificate.faces.empty());
}

TEST(KeptCuts, allCutsAreKeptAtLastAndTheBestBlockStays) {
	const Asked asked = ask({0, 1}, {{1}, {0, 1, 2}});
	EXPECT_EQ(asked.kept, (Lists{{a, b}, {a, b, c, d}}));
	EXPECT_EQ(asked.block.certificate.faces, (std::vector<std::uint32_t>{1}));
}

TEST(KeptCuts, whatDoesNotHoldIsPulledApartLastIfThatIsBetter) {
	Arrangement arrangement;
	Block block = blockWithWrong({0, 1});
	block.keptCuts = {b};
	std::vector<std::uint32_t> left{0, 1, 2};
	int calls = 0;
	const auto remake = [&](const BlockVariant& variant, Block& out) {
		++calls;
		EXPECT_TRUE(variant.isPulledApartLast);
		EXPECT_EQ(variant.keptCuts, block.keptCuts);
		out = blockWithWrong(left);
		out.keptCuts = variant.keptCuts;
		return Status{};
	};
	EXPECT_TRUE(pullApartLast(arrangement, remake, block).ok());
	EXPECT_EQ(block.certificate.faces.size(), 2U);
	left.clear();
	EXPECT_TRUE(pullApartLast(arrangement, remake, block).ok());
	EXPECT_TRUE(block.certificate.faces.empty());
	EXPECT_TRUE(pullApartLast(arrangement, remake, block).ok());
	EXPECT_EQ(calls, 2);
	block = blockWithWrong({0});
	arrangement.options.weldNonManifold = true;
	EXPECT_TRUE(pullApartLast(arrangement, remake, block).ok());
	EXPECT_EQ(calls, 2);
}

TEST(KeptCuts, aFailureIsHandedOn) {
	Status failure;
	failure.code = StatusCode::Cancelled;
	EXPECT_EQ(ask({0}, {{}}, true, failure).status.code, StatusCode::Cancelled);
}

}  // namespace
}  // namespace index_boolean
