// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The run behind the filter, driven through the host's kind of callback.
#include <boolean_run.h>

#include <gtest/gtest.h>

#include <thread>

namespace index_boolean {
namespace {

// The host's callback is a plain function, so what it has seen is kept here.
struct Seen {
	int calls = 0;
	int cancelAt = 0;  // the call that answers false; 0: none
	int lastPercent = 0;
	bool inRange = true, monotone = true, named = true, onThisThread = true;
	std::thread::id thread = std::this_thread::get_id();
};
Seen seen;

bool hostCallback(const int percent, const char* stage) {
	++seen.calls;
	seen.inRange &= percent >= 0 && percent <= 100;
	seen.monotone &= percent >= seen.lastPercent;
	seen.named &= stage != nullptr && *stage != '\0';
	seen.onThisThread &= std::this_thread::get_id() == seen.thread;
	seen.lastPercent = percent;
	return seen.calls != seen.cancelAt;
}

void appendBox(const Point& low, const Point& high, int operand, MeshArrays& out) {
	const auto first = static_cast<std::uint32_t>(out.points.size());
	for (unsigned corner = 0; corner < 8; ++corner) {
		out.points.push_back({(corner & 1 ? high : low)[0], (corner & 2 ? high : low)[1],
		                      (corner & 4 ? high : low)[2]});
	}
	constexpr std::array<std::array<std::uint32_t, 3>, 12> kFaces{{
	    {0, 2, 3},
	    {0, 3, 1},
	    {4, 5, 7},
	    {4, 7, 6},
	    {0, 1, 5},
	    {0, 5, 4},
	    {2, 6, 7},
	    {2, 7, 3},
	    {0, 4, 6},
	    {0, 6, 2},
	    {1, 3, 7},
	    {1, 7, 5},
	}};
	for (const auto& face : kFaces) {
		out.triangles.push_back(
		    {VertexId{first + face[0]}, VertexId{first + face[1]}, VertexId{first + face[2]}});
	}
	for (auto end = static_cast<std::size_t>(operand) + 1; end < 3; ++end) {
		out.vertexBegin[end] = static_cast<std::uint32_t>(out.points.size());
		out.faceBegin[end] = static_cast<std::uint32_t>(out.triangles.size());
	}
}

// Boxes of volume 8 and 3.375 that share a box of volume 0.65625, in general position.
MeshArrays overlappingBoxes() {
	MeshArrays arrays;
	appendBox({0, 0, 0}, {2, 2, 2}, 0, arrays);
	appendBox({1, 1.125, 1.25}, {2.5, 2.625, 2.75}, 1, arrays);
	return arrays;
}

BooleanRequest everything() {
	BooleanRequest request;
	for (int operation = 0; operation < kOperationCount; ++operation)
		request.operations.push_back(static_cast<Operation>(operation));
	return request;
}

Status runWith(int cancelAt, BooleanResult& result) {
	seen = Seen{};
	seen.cancelAt = cancelAt;
	Progress progress(progressCallback(&hostCallback));
	return runBoolean(overlappingBoxes(), everything(), progress, result);
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
	EXPECT_EQ(result.loopCounts.hardClosed, 1u);
}

TEST(BooleanRun, theHostSeesPercentsThatNeverFallOnItsOwnThread) {
	BooleanResult result;
	ASSERT_TRUE(runWith(0, result).ok());
	EXPECT_GT(seen.calls, 5);
	EXPECT_GT(seen.lastPercent, 50);
	EXPECT_TRUE(seen.inRange);
	EXPECT_TRUE(seen.monotone);
	EXPECT_TRUE(seen.named);
	EXPECT_TRUE(seen.onThisThread);
}

TEST(BooleanRun, aHostThatAnswersFalseCancelsAtEveryCall) {
	BooleanResult result;
	ASSERT_TRUE(runWith(0, result).ok());
	const int calls = seen.calls;
	for (int call = 1; call <= calls; ++call) {
		BooleanResult cancelled;
		const Status status = runWith(call, cancelled);
		// Progress within a stage is reported by the clock, so the last calls may not come.
		if (seen.calls < call)
			break;
		EXPECT_EQ(status.code, StatusCode::Cancelled) << "call " << call << " of " << calls;
		EXPECT_EQ(seen.calls, call) << "called again after it had answered false";
	}
}

TEST(BooleanRun, aHostWithoutACallbackIsServed) {
	Progress progress(progressCallback(nullptr));
	BooleanResult result;
	EXPECT_TRUE(runBoolean(overlappingBoxes(), everything(), progress, result).ok());
}

TEST(BooleanRun, stagesAndTheWholeAreTimed) {
	BooleanResult result;
	ASSERT_TRUE(runWith(0, result).ok());
	double sum = 0;
	for (const StageTime& time : result.stageTimes)
		sum += time.seconds;
	EXPECT_GT(result.stageTimes.size(), 4u);
	EXPECT_GT(result.seconds, 0);
	EXPECT_LE(sum, result.seconds);
}

}  // namespace
}  // namespace index_boolean
