// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Progress and cancel.
#include <vcg_ext/base/monitor.h>

#include <gtest/gtest.h>

#include <chrono>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

using namespace index_boolean;

namespace {

using Clock = std::chrono::steady_clock;

struct Call {
	double fraction;
	std::string stage;
	Clock::time_point time;
};

Monitor recording(std::vector<Call>& calls) {
	return Monitor([&calls](double fraction, const char* stage) {
		calls.push_back({fraction, stage, Clock::now()});
		return true;
	});
}

void waitPastTheInterval() { std::this_thread::sleep_for(std::chrono::milliseconds(11)); }

}  // namespace

TEST(Monitor, stagesAreReportedAtOnceAndByName) {
	std::vector<Call> calls;
	Monitor monitor = recording(calls);
	monitor.beginStage("first", 0, 0.5);
	monitor.beginStage("second", 0.5, 1);
	ASSERT_EQ(calls.size(), 2U);
	EXPECT_EQ(calls[0].stage, "first");
	EXPECT_EQ(calls[0].fraction, 0);
	EXPECT_EQ(calls[1].stage, "second");
	EXPECT_EQ(calls[1].fraction, 0.5);
}

TEST(Monitor, progressIsMappedIntoTheStage) {
	std::vector<Call> calls;
	Monitor monitor = recording(calls);
	monitor.beginStage("stage", 0.5, 0.75);
	waitPastTheInterval();
	monitor.report(0.5);
	ASSERT_EQ(calls.size(), 2U);
	EXPECT_EQ(calls[1].fraction, 0.625);
}

TEST(Monitor, fractionNeverFallsNorLeavesTheUnitInterval) {
	std::vector<Call> calls;
	Monitor monitor = recording(calls);
	monitor.beginStage("stage", -1, 0.5);
	for (const double fraction : {0.9, 0.1, std::numeric_limits<double>::quiet_NaN(), 7.0, 0.2}) {
		waitPastTheInterval();
		monitor.report(fraction);
	}
	monitor.beginStage("earlier", 0.25, 0.5);
	double last = 0;
	for (const Call& call : calls) {
		EXPECT_GE(call.fraction, last);
		EXPECT_LE(call.fraction, 1);
		last = call.fraction;
	}
	EXPECT_EQ(calls.size(), 7U);
}

TEST(Monitor, progressIsReportedEveryTenMillisecondsAtMost) {
	std::vector<Call> calls;
	Monitor monitor = recording(calls);
	monitor.beginStage("stage", 0, 1);
	const auto begin = Clock::now();
	while (Clock::now() - begin < std::chrono::milliseconds(55)) {
		monitor.report(0.5);
	}
	EXPECT_GE(calls.size(), 3U);
	for (std::size_t i = 1; i < calls.size(); ++i) {
		EXPECT_GE(calls[i].time - calls[i - 1].time, std::chrono::milliseconds(10));
	}
}

TEST(Monitor, cancelStaysAndEndsTheCalls) {
	int calls = 0;
	Monitor monitor([&calls](double, const char*) { return ++calls != 2; });
	monitor.beginStage("first", 0, 0.5);
	EXPECT_FALSE(monitor.cancelled());
	monitor.beginStage("second", 0.5, 1);
	EXPECT_TRUE(monitor.cancelled());
	monitor.beginStage("third", 0.75, 1);
	waitPastTheInterval();
	monitor.report(1);
	EXPECT_TRUE(monitor.cancelled());
	EXPECT_EQ(calls, 2);
}

TEST(Monitor, callbackThatThrowsCancels) {
	Monitor monitor([](double, const char*) -> bool { throw std::runtime_error("by a test"); });
	monitor.beginStage("stage", 0, 1);
	EXPECT_TRUE(monitor.cancelled());
}

TEST(Monitor, withoutACallbackNothingIsCancelled) {
	Monitor monitor;
	monitor.beginStage("stage", 0, 1);
	monitor.report(0.5);
	EXPECT_FALSE(monitor.cancelled());
}
