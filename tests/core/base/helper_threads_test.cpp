// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Helpers: they help, nobody waits for one that has not come, and a child process has its own.
#include "support/sanitizers.h"

#include <vcg_ext/base/helper_threads.h>

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

#ifndef _WIN32
#include <sys/wait.h>
#include <unistd.h>
#endif

using namespace index_boolean;

namespace {

// Whether `flag` is raised within half a minute.
bool isRaised(const std::atomic<bool>& flag) {
	const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30);
	while (!flag && std::chrono::steady_clock::now() < end) {
		std::this_thread::sleep_for(std::chrono::milliseconds(1));
	}
	return flag;
}

// A call whose work waits until it is helped, and whose help waits until it may go.
struct Meeting {
	std::atomic<bool> isHelped{false}, mayGo{false}, wasHelped{false};

	static void work(void* context) {
		Meeting& meeting = *static_cast<Meeting*>(context);
		meeting.wasHelped = isRaised(meeting.isHelped);
	}
	static void help(void* context) {
		Meeting& meeting = *static_cast<Meeting*>(context);
		meeting.isHelped = true;
		isRaised(meeting.mayGo);
	}
};

bool isHelpedOnce() {
	Meeting meeting;
	meeting.mayGo = true;
	workWithHelpers(1, &meeting, Meeting::work, Meeting::help);
	return meeting.wasHelped;
}

TEST(HelperThreads, theyHelp) {
	for (int i = 0; i < 10; ++i) {
		EXPECT_TRUE(isHelpedOnce());
	}
}

TEST(HelperThreads, asManyAsAreWanted) {
	struct Team {
		std::atomic<int> inside{0};
		std::atomic<bool> areAll{false};
	} team;
	const auto enter = [](void* context) {
		Team& all = *static_cast<Team*>(context);
		all.areAll = ++all.inside == 4 || all.areAll;
		isRaised(all.areAll);
	};
	workWithHelpers(3, &team, enter, enter);
	EXPECT_TRUE(team.areAll);
	EXPECT_EQ(team.inside, 4);
}

TEST(HelperThreads, noneIfNoneIsWanted) {
	for (const int helpers : {0, -1}) {
		int calls = 0;
		const auto count = [](void* context) { ++*static_cast<int*>(context); };
		workWithHelpers(helpers, &calls, count, count);
		EXPECT_EQ(calls, 1);
		EXPECT_TRUE(isHelpedOnce()) << "what is called for next";
	}
}

// Run by itself, as CTest does, there is one helper, which is elsewhere.
TEST(HelperThreads, nobodyWaitsForOneThatIsElsewhere) {
	Meeting elsewhere;
	std::thread host([&] { workWithHelpers(1, &elsewhere, Meeting::work, Meeting::help); });
	EXPECT_TRUE(isRaised(elsewhere.isHelped));
	int calls = 0;
	const auto count = [](void* context) { ++*static_cast<int*>(context); };
	for (int i = 0; i < 100; ++i) {
		workWithHelpers(1, &calls, count, [](void*) {});
	}
	EXPECT_EQ(calls, 100);
	EXPECT_FALSE(elsewhere.mayGo);
	elsewhere.mayGo = true;
	host.join();
	EXPECT_TRUE(elsewhere.wasHelped);
}

#if !defined(_WIN32) && !defined(INDEXBOOLEAN_THREAD_SANITIZER)
TEST(HelperThreads, aChildHasItsOwn) {
	ASSERT_TRUE(isHelpedOnce());
	const pid_t child = fork();
	ASSERT_GE(child, 0);
	if (child == 0) {
		_exit(isHelpedOnce() ? 0 : 1);
	}
	int status = -1;
	ASSERT_EQ(waitpid(child, &status, 0), child);
	EXPECT_TRUE(WIFEXITED(status));
	EXPECT_EQ(WEXITSTATUS(status), 0);
	EXPECT_TRUE(isHelpedOnce()) << "and the parent keeps its own";
}
#endif

}  // namespace
