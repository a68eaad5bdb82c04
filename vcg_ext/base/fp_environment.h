// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A thread's floating-point environment: rounding, masks, flags, and on x86 and ARM flush to zero.
// Guarantee: what is set is set for doubles on every system. mingw-w64's C library sets that of the
// x87 alone, which no double is computed by.
#pragma once

#include <cfenv>

#ifdef __MINGW32__
#include <xmmintrin.h>
#endif

namespace index_boolean {

class FpEnvironment {
public:
	// Makes this the environment that this thread has. Complexity: O(1), as of all here.
	void save() {
		std::fegetenv(&common_);
#ifdef __MINGW32__
		sse_ = _mm_getcsr();
#endif
	}

	// Gives this thread the environment that was saved.
	void restore() const {
		std::fesetenv(&common_);
#ifdef __MINGW32__
		_mm_setcsr(sse_);
#endif
	}

	// Gives this thread the default: to nearest, no flush to zero, nothing traps.
	static void setDefault() {
		std::fesetenv(FE_DFL_ENV);
#ifdef __MINGW32__
		_mm_setcsr(0x1F80);
#endif
	}

private:
	std::fenv_t common_;
#ifdef __MINGW32__
	unsigned sse_;
#endif
};

}  // namespace index_boolean
