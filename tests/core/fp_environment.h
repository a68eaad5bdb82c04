// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Floating-point environments that a host may be in, and whether one is the default.
#pragma once

#include <vcg_ext/base/fp_environment.h>

#include <cfenv>
#include <limits>

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

inline void spoilEnvironmentOfAllThreads(int threads) {
	spoilEnvironment();
#ifdef _OPENMP
#pragma omp parallel num_threads(threads)
	spoilEnvironment();
#else
	static_cast<void>(threads);
#endif
}

inline void restoreEnvironmentOfAllThreads(int threads) {
	FpEnvironment::setDefault();
#ifdef _OPENMP
#pragma omp parallel num_threads(threads)
	FpEnvironment::setDefault();
#else
	static_cast<void>(threads);
#endif
}

}  // namespace index_boolean
