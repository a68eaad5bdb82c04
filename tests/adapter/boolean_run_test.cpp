// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The run behind the filter, driven through the host's kind of callback.
#include "watched_host.h"

#include <runs/boolean_run.h>

#include <gtest/gtest.h>

namespace index_boolean {
namespace {

using namespace watched_host;

BooleanRequest everything() {
	BooleanRequest request;
	for (int operation = 0; operation < kOperationCount; ++operation) {
		request.operations.push_back(static_cast<Operation>(operation));
	}
	return request;
}

Status runWith(int cancelAt, BooleanResult& result) {
	Progress progress = watch(cancelAt);
	return runBoolean(overlappingBoxes(), again(overlappingBoxes), everything(), progress, result);
}

TEST(BooleanRun, blocksHaveTheirVolumesInTheOrderRequested) {
	BooleanResult result;
	ASSERT_TRUE(runWith(0, result).ok());
	const std::array<double, kOperationCount> volumes{10.71875, 0.65625, 7.34375, 2.71875, 10.0625};
	ASSERT_EQ(result.blocks.size(), volumes.size());
	for (std::size_t i = 0; i < volumes.size(); ++i) {
		EXPECT_EQ(result.blocks[i].operation, static_cast<Operation>(i));
		EXPECT_DOUBLE_EQ(result.audit.blocks[i].volume, volumes[i]);
	}
	EXPECT_EQ(result.report.loopCounts.hardClosed, 1u);
}

TEST(BooleanRun, theHostSeesPercentsThatNeverFallOnItsOwnThread) {
	BooleanResult result;
	ASSERT_TRUE(runWith(0, result).ok());
	expectGoodManners();
}

TEST(BooleanRun, aHostThatAnswersFalseCancelsAtEveryCall) {
	expectCancelledAtEveryCall([](int call) {
		BooleanResult result;
		return runWith(call, result);
	});
}

TEST(BooleanRun, aLayerThatMeetsItselfIsResolvedAndCancelledAtEveryCall) {
	const auto resolve = [](int call, BooleanResult& result) {
		Progress progress = watch(call);
		BooleanRequest request = everything();
		request.options.selfIntersections = SelfIntersections::Resolve;
		return runBoolean(crossingBars(), again(crossingBars), request, progress, result);
	};
	BooleanResult result;
	ASSERT_TRUE(resolve(0, result).ok());
	expectGoodManners();
	EXPECT_TRUE(result.report.isLabelledByCells);
	EXPECT_DOUBLE_EQ(result.audit.blocks[0].volume, 33);
	EXPECT_GT(result.report.selfIntersecting[kFirst], 0u);
	EXPECT_EQ(result.report.selfIntersecting[kSecond], 0u);
	expectCancelledAtEveryCall([&](int call) {
		BooleanResult cancelled;
		return resolve(call, cancelled);
	});
}

TEST(BooleanRun, aHostWithoutACallbackIsServed) {
	Progress progress(progressCallback(nullptr));
	BooleanResult result;
	EXPECT_TRUE(
	    runBoolean(overlappingBoxes(), again(overlappingBoxes), everything(), progress, result)
	        .ok());
}

TEST(BooleanRun, stagesAndTheWholeAreTimed) {
	BooleanResult result;
	ASSERT_TRUE(runWith(0, result).ok());
	expectTimed(result.report);
}

}  // namespace
}  // namespace index_boolean
