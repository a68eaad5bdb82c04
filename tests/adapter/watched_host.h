// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A host's callback that keeps what it has seen and cancels when it is told to, and boxes to run
// on.
#pragma once

#include <runs/progress.h>
#include <runs/run_report.h>

#include <vcg_ext/index_boolean.h>

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <thread>

namespace index_boolean::watched_host {

// The host's callback is a plain function, so what it has seen is kept here.
struct Seen {
	int calls = 0;
	int cancelAt = 0;  // the call that answers false; 0: none
	int lastPercent = 0;
	bool inRange = true, monotone = true, named = true, onThisThread = true;
	std::thread::id thread = std::this_thread::get_id();
	std::set<std::string> stages;
};
inline Seen seen;

inline bool hostCallback(const int percent, const char* stage) {
	++seen.calls;
	seen.inRange &= percent >= 0 && percent <= 100;
	seen.monotone &= percent >= seen.lastPercent;
	seen.named &= stage != nullptr && *stage != '\0';
	seen.onThisThread &= std::this_thread::get_id() == seen.thread;
	seen.lastPercent = percent;
	seen.stages.insert(stage);
	return seen.calls != seen.cancelAt;
}

inline void appendBox(const Point& low, const Point& high, OperandId operand, MeshArrays& out) {
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
	out.vertexOffsets.setEnd(operand, out.points.size());
	out.faceOffsets.setEnd(operand, out.triangles.size());
}

// Boxes of volume 8 and 3.375 that share a box of volume 0.65625, in general position.
inline MeshArrays overlappingBoxes() {
	MeshArrays arrays;
	appendBox({0, 0, 0}, {2, 2, 2}, kFirst, arrays);
	appendBox({1, 1.125, 1.25}, {2.5, 2.625, 2.75}, kSecond, arrays);
	return arrays;
}

// Two bars in one layer that cross, with no corner of one in the other, and a box far away.
inline MeshArrays crossingBars() {
	MeshArrays arrays;
	appendBox({-3, -1, -1}, {3, 1, 1}, kFirst, arrays);
	appendBox({-1, -3, -.5}, {1, 3, .5}, kFirst, arrays);
	appendBox({10, 10, 10}, {11, 11, 11}, kSecond, arrays);
	return arrays;
}

// Makes the same arrays once more.
inline InputAgain again(MeshArrays (*make)()) {
	return [make](MeshArrays& out) {
		out = make();
		return Status{};
	};
}

// What any run must have made of the callback, up to its end or to its refusal.
inline void expectGoodMannersSoFar() {
	EXPECT_GT(seen.calls, 5);
	EXPECT_TRUE(seen.inRange);
	EXPECT_TRUE(seen.monotone);
	EXPECT_TRUE(seen.named);
	EXPECT_TRUE(seen.onThisThread);
}

inline void expectGoodManners() {
	expectGoodMannersSoFar();
	EXPECT_GT(seen.lastPercent, 50);
}

// All stages are timed, and the whole.
inline void expectTimed(const RunReport& report) {
	double sum = 0;
	for (const StageTime& time : report.stageTimes) {
		sum += time.seconds;
	}
	EXPECT_GT(report.stageTimes.size(), 4u);
	EXPECT_GT(report.seconds, 0);
	EXPECT_LE(sum, report.seconds);
}

// Runs once for each call of the callback, and has that one answered false.
// \param run called with the number of the call; its status
template <class Run>
void expectCancelledAtEveryCall(Run&& run) {
	ASSERT_TRUE(run(0).ok());
	const int calls = seen.calls;
	for (int call = 1; call <= calls; ++call) {
		const Status status = run(call);
		// Progress within a stage is reported by the clock, so the last calls may not come.
		if (seen.calls < call) {
			break;
		}
		EXPECT_EQ(status.code, StatusCode::Cancelled) << "call " << call << " of " << calls;
		EXPECT_EQ(seen.calls, call) << "called again after it had answered false";
	}
}

// Forgets what was seen. \return the progress of a new run, cancelled at that call (0: never)
inline Progress watch(int cancelAt) {
	seen = Seen{};
	seen.cancelAt = cancelAt;
	return Progress(progressCallback(&hostCallback));
}

}  // namespace index_boolean::watched_host
