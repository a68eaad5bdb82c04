// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/base/process.h"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <thread>

#ifndef _WIN32
#include <pthread.h>
#include <unistd.h>
#endif
#ifdef __linux__
#include <sched.h>
#include <sys/resource.h>
#endif

namespace index_boolean {

namespace {

// Since this was loaded, along the line of processes that leads here. Counted on Linux alone, which
// forgets what counts them when the library is unloaded.
std::atomic<long> forks{0};

#ifdef __linux__
const struct ForkCounter {
	ForkCounter() {
		pthread_atfork(nullptr, nullptr, [] { ++forks; });
	}
} forkCounter;
#endif

int coresOfProcess() {
#ifdef __linux__
	cpu_set_t cores;  // too small for more than 1024: all of them then
	if (sched_getaffinity(getpid(), sizeof cores, &cores) == 0) {
		return CPU_COUNT(&cores);
	}
#endif
	return static_cast<int>(std::thread::hardware_concurrency());
}

int askForThreads() {
	constexpr long kMost = 1024;
	const char* const asked = std::getenv("OMP_NUM_THREADS");
	const long number = asked == nullptr ? 0 : std::strtol(asked, nullptr, 10);
	return number > 0 ? static_cast<int>(std::min(number, kMost)) : std::max(1, coresOfProcess());
}

}  // namespace

int availableThreads() {
	static std::atomic<int> known{0};  // no lock, which a child could find taken for ever
	int number = known.load(std::memory_order_relaxed);
	if (number == 0) {
		number = askForThreads();
		known.store(number, std::memory_order_relaxed);
	}
	return number;
}

#ifdef _WIN32

ProcessId currentProcess() { return {0, 0}; }  // there is no fork()
void runAsProcess() {}
SignalsBlocked::SignalsBlocked() = default;
SignalsBlocked::~SignalsBlocked() = default;

#else

ProcessId currentProcess() { return {getpid(), forks.load(std::memory_order_relaxed)}; }

void runAsProcess() {
#ifdef __linux__
	const pid_t first = getpid();
	cpu_set_t cores;
	if (sched_getaffinity(first, sizeof cores, &cores) == 0) {
		sched_setaffinity(0, sizeof cores, &cores);
	}
	sched_param parameters{};
	const int policy = sched_getscheduler(first);
	if (policy >= 0 && sched_getparam(first, &parameters) == 0) {
		sched_setscheduler(0, policy, &parameters);
	}
	setpriority(PRIO_PROCESS, 0, getpriority(PRIO_PROCESS, static_cast<id_t>(first)));
#endif
}

SignalsBlocked::SignalsBlocked() {
	sigset_t most;
	sigfillset(&most);
	for (const int fault : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTRAP, SIGABRT, SIGSYS, SIGPROF}) {
		sigdelset(&most, fault);
	}
	pthread_sigmask(SIG_BLOCK, &most, &before_);
}

SignalsBlocked::~SignalsBlocked() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

#endif

}  // namespace index_boolean
