// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Floating-point environments that a host may be in, and whether one is the default; of this thread
// and of its helpers.
#pragma once

#include <vcg_ext/base/fp_environment.h>
#include <vcg_ext/base/helper_threads.h>

#include <atomic>
#include <cfenv>
#include <limits>
#include <thread>

#ifdef __SSE__
#include <xmmintrin.h>
#endif

namespace index_boolean {

// Sets a floating-point environment as a careless library leaves it: rounding upward, and
// subnormal numbers flushed to zero where the machine has such a mode.
inline void spoilEnvironment() {
	std::fesetround(FE_UPWARD);
#ifdef __SSE__
	_mm_setcsr(_mm_getcsr() | 0x8040U);
#endif
}

// Rounds to nearest and keeps subnormal numbers, both as results and as operands.
inline bool environmentIsDefault() {
	volatile double smallest = std::numeric_limits<double>::min();
	volatile double one = 1;
	volatile double half = smallest / 2;
	volatile double again = half * 2;
	volatile double third = one / 3;
	return half > 0 && again == smallest && third == 1.0 / 3.0 && one + third * 0x1p-60 == one;
}

// Calls body() on this thread and on `threads` - 1 helpers at once, as the core's loops do.
template <class Body>
void onAllThreads(int threads, Body&& body) {
	struct Team {
		Body& body;
		int threads;
		std::atomic<int> inside{0};

		static void enter(void* context) {
			Team& team = *static_cast<Team*>(context);
			++team.inside;
			while (team.inside < team.threads) {  // so that no helper comes twice
				std::this_thread::yield();
			}
			team.body();
		}
	} team{body, threads};
	workWithHelpers(threads - 1, &team, Team::enter, Team::enter);
}

inline void spoilEnvironmentOfAllThreads(int threads) { onAllThreads(threads, spoilEnvironment); }

inline void restoreEnvironmentOfAllThreads(int threads) {
	onAllThreads(threads, FpEnvironment::setDefault);
}

}  // namespace index_boolean
