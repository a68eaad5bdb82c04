// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What helpers are like, whoever calls them first. Each test of a process runs in a child.
#include "support/sanitizers.h"

#include <vcg_ext/base/helper_threads.h>
#include <vcg_ext/base/process.h>

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <thread>

#ifdef __linux__
#include <csignal>
#include <sched.h>
#include <sys/wait.h>
#include <unistd.h>
#endif

using namespace index_boolean;

namespace {

TEST(Process, isOneAndTheSame) { EXPECT_EQ(currentProcess(), currentProcess()); }

#ifdef __linux__

// Whether a child in which body() runs finds it true.
template <class Body>
bool isTrueInAChild(Body&& body) {
	const pid_t child = fork();
	if (child == 0) {
		_exit(body() ? 0 : 1);
	}
	int status = -1;
	return child > 0 && waitpid(child, &status, 0) == child && WIFEXITED(status) &&
	       WEXITSTATUS(status) == 0;
}

int coresOfThisThread() {
	cpu_set_t cores;
	return sched_getaffinity(0, sizeof cores, &cores) == 0 ? CPU_COUNT(&cores) : 0;
}

// Leaves one core to this thread, and to those that it makes.
void keepToOneCore() {
	cpu_set_t cores, one;
	CPU_ZERO(&one);
	sched_getaffinity(0, sizeof cores, &cores);
	for (int core = 0; core < CPU_SETSIZE && CPU_COUNT(&one) == 0; ++core) {
		if (CPU_ISSET(core, &cores)) {
			CPU_SET(core, &one);
		}
	}
	sched_setaffinity(0, sizeof one, &one);
}

// What help finds, which work waits for.
struct Look {
	std::atomic<bool> isDone{false};
	int cores = 0;
	bool isTermBlocked = false, isFaultBlocked = true;

	static void work(void* context) {
		while (!static_cast<Look*>(context)->isDone) {
			std::this_thread::yield();
		}
	}
	static void help(void* context) {
		Look& look = *static_cast<Look*>(context);
		look.cores = coresOfThisThread();
		sigset_t blocked;
		pthread_sigmask(SIG_SETMASK, nullptr, &blocked);
		look.isTermBlocked = sigismember(&blocked, SIGTERM) == 1;
		look.isFaultBlocked = sigismember(&blocked, SIGSEGV) == 1;
		look.isDone = true;
	}
};

TEST(Process, isNoLongerTheSameInAChild) {
	const ProcessId parent = currentProcess();
	EXPECT_TRUE(isTrueInAChild([&] { return !(currentProcess() == parent); }));
}

// Asked in children alone, since the first answer is kept.
TEST(Process, mayRunOnTheCoresThatItIsLeft) {
	EXPECT_TRUE(isTrueInAChild([] {
		unsetenv("OMP_NUM_THREADS");
		keepToOneCore();
		return availableThreads() == 1;
	}));
	EXPECT_TRUE(isTrueInAChild([] {
		setenv("OMP_NUM_THREADS", "7", 1);
		return availableThreads() == 7;
	}));
}

TEST(HelperThreads, areAsTheProcessIsNotAsWhoCallsFirst) {
	const int cores = coresOfThisThread();
	Look look;
	bool isSignalled = false;
	std::thread first([&] {
		keepToOneCore();
		workWithHelpers(1, &look, Look::work, Look::help);
		sigset_t blocked;
		pthread_sigmask(SIG_SETMASK, nullptr, &blocked);
		isSignalled = sigismember(&blocked, SIGTERM) == 0;
	});
	first.join();
	EXPECT_EQ(look.cores, cores);
	EXPECT_TRUE(look.isTermBlocked);
	EXPECT_FALSE(look.isFaultBlocked);
	EXPECT_TRUE(isSignalled) << "who calls takes signals as before";
}

// A run that another thread is in does not hold up the end of the process. (A thread sanitizer
// wants all threads to have ended by then.)
#ifndef INDEXBOOLEAN_THREAD_SANITIZER
TEST(HelperThreads, leaveTheRestWhenTheProcessEnds) {
	const pid_t child = fork();
	if (child == 0) {
		static std::atomic<bool> isHelped{false};
		const auto work = [](void*) {
			while (true) {
				std::this_thread::yield();
			}
		};
		const auto help = [](void*) {
			isHelped = true;
			while (!areHelpersToLeave()) {
				std::this_thread::yield();
			}
		};
		std::thread([work, help] { workWithHelpers(1, nullptr, work, help); }).detach();
		while (!isHelped) {
			std::this_thread::yield();
		}
		std::exit(0);
	}
	int status = -1;
	ASSERT_EQ(waitpid(child, &status, 0), child);
	EXPECT_TRUE(WIFEXITED(status));
	EXPECT_EQ(WEXITSTATUS(status), 0);
}
#endif

#endif

}  // namespace
