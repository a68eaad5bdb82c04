// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The runs behind the filters for splitting and for curves, driven through the host's kind of
// callback.
#include "watched_host.h"

#include <runs/curves_run.h>
#include <runs/split_run.h>

#include <gtest/gtest.h>

namespace index_boolean {
namespace {

using namespace watched_host;

Status splitWith(int cancelAt, SplitResult& result) {
	Progress progress = watch(cancelAt);
	return runSplit(overlappingBoxes(), SplitRequest{}, progress, result);
}

Status curvesWith(int cancelAt, CurvesResult& result) {
	Progress progress = watch(cancelAt);
	return runCurves(overlappingBoxes(), Options{}, progress, result);
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
	EXPECT_STREQ(result.stageTimes.back().stage, "audit");
	double sum = 0;
	for (const StageTime& time : result.stageTimes) {
		sum += time.seconds;
	}
	EXPECT_LE(sum, result.seconds);
}

TEST(SplitRun, withoutBlocksTheVolumesAreAuditedAlone) {
	Progress progress = watch(0);
	SplitRequest request;
	request.subBlocks = false;
	SplitResult result;
	ASSERT_TRUE(runSplit(overlappingBoxes(), request, progress, result).ok());
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

TEST(CurvesRun, aHostThatAnswersFalseCancelsAtEveryCall) {
	expectCancelledAtEveryCall([](int call) {
		CurvesResult result;
		return curvesWith(call, result);
	});
}

}  // namespace
}  // namespace index_boolean
