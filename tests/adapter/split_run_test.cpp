// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The runs behind the filters for splitting and for curves, driven through the host's kind of
// callback; and what all runs report alike.
#include "watched_host.h"

#include <runs/boolean_run.h>
#include <runs/curves_run.h>
#include <runs/split_run.h>

#include <gtest/gtest.h>

namespace index_boolean {
namespace {

using namespace watched_host;

Status splitWith(int cancelAt, SplitResult& result) {
	Progress progress = watch(cancelAt);
	return runSplit(overlappingBoxes(), again(overlappingBoxes), SplitRequest{}, progress, result);
}

Status curvesWith(int cancelAt, CurvesResult& result) {
	Progress progress = watch(cancelAt);
	return runCurves(overlappingBoxes(), again(overlappingBoxes), Options{}, progress, result);
}

TEST(SplitRun, theHostSeesPercentsThatNeverFallOnItsOwnThread) {
	SplitResult result;
	ASSERT_TRUE(splitWith(0, result).ok());
	expectGoodManners();
	for (const char* stage : {"loops", "sub surfaces", "sub blocks", "split meshes", "audit"}) {
		EXPECT_EQ(seen.stages.count(stage), 1u) << stage;
	}
}

TEST(SplitRun, aHostThatAnswersFalseCancelsAtEveryCall) {
	expectCancelledAtEveryCall([](int call) {
		SplitResult result;
		return splitWith(call, result);
	});
}

TEST(SplitRun, blocksAreAuditedAndTimed) {
	SplitResult result;
	ASSERT_TRUE(splitWith(0, result).ok());
	ASSERT_EQ(result.blockMeshes.size(), 3u);
	EXPECT_TRUE(result.audit.closed);
	EXPECT_LT(result.audit.volumeLawResidual, 1e-15);
	EXPECT_STREQ(result.report.stageTimes.back().stage, "audit");
	expectTimed(result.report);
}

TEST(SplitRun, withoutBlocksTheVolumesAreAuditedAlone) {
	Progress progress = watch(0);
	SplitRequest request;
	request.subBlocks = false;
	SplitResult result;
	ASSERT_TRUE(
	    runSplit(overlappingBoxes(), again(overlappingBoxes), request, progress, result).ok());
	EXPECT_TRUE(result.blockMeshes.empty());
	EXPECT_EQ(result.split.blocks.all.size(), 3u);
	EXPECT_LT(result.audit.volumeLawResidual, 1e-15);
}

TEST(CurvesRun, theHostSeesPercentsThatNeverFallOnItsOwnThread) {
	CurvesResult result;
	ASSERT_TRUE(curvesWith(0, result).ok());
	expectGoodManners();
	for (const char* stage : {"loops", "sub surfaces", "curve lines"}) {
		EXPECT_EQ(seen.stages.count(stage), 1u) << stage;
	}
}

TEST(CurvesRun, stagesAndTheWholeAreTimed) {
	CurvesResult result;
	ASSERT_TRUE(curvesWith(0, result).ok());
	EXPECT_STREQ(result.report.stageTimes.back().stage, "sub_surfaces");
	expectTimed(result.report);
}

TEST(CurvesRun, aHostThatAnswersFalseCancelsAtEveryCall) {
	expectCancelledAtEveryCall([](int call) {
		CurvesResult result;
		return curvesWith(call, result);
	});
}

// The second box inside out, and one face of the first there twice.
MeshArrays boxesWithFindings() {
	MeshArrays boxes = overlappingBoxes();
	for (std::size_t f = boxes.faceOffsets.begin(kSecond); f < boxes.faceOffsets.total(); ++f) {
		std::swap(boxes.triangles[f][1], boxes.triangles[f][2]);
	}
	boxes.triangles.insert(boxes.triangles.begin(), Triangle(boxes.triangles.front()));
	boxes.faceOffsets = {boxes.faceOffsets.end(kFirst) + 1, boxes.faceOffsets.total() + 1};
	return boxes;
}

void expectFindings(const RunReport& report) {
	EXPECT_FALSE(report.insideOut[kFirst]);
	EXPECT_TRUE(report.insideOut[kSecond]);
	EXPECT_EQ(report.duplicates.takenOnce[kFirst], 1u);
	EXPECT_EQ(report.duplicates.takenOnce[kSecond], 0u);
	EXPECT_EQ(report.loopCounts.hardClosed, 1u);
}

TEST(RunReport, allRunsReportTheSameOfTheOperands) {
	BooleanRequest request;
	request.operations = {Operation::Union};
	BooleanResult blocks;
	Progress progress = watch(0);
	ASSERT_TRUE(
	    runBoolean(boxesWithFindings(), again(boxesWithFindings), request, progress, blocks).ok());
	expectFindings(blocks.report);

	SplitResult pieces;
	progress = watch(0);
	ASSERT_TRUE(
	    runSplit(boxesWithFindings(), again(boxesWithFindings), SplitRequest{}, progress, pieces)
	        .ok());
	expectFindings(pieces.report);

	CurvesResult curves;
	progress = watch(0);
	ASSERT_TRUE(
	    runCurves(boxesWithFindings(), again(boxesWithFindings), Options{}, progress, curves).ok());
	expectFindings(curves.report);
}

}  // namespace
}  // namespace index_boolean
