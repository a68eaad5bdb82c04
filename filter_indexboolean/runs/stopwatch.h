// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Wall-clock seconds since the stopwatch was made.
#pragma once

#include <chrono>

namespace index_boolean {

class Stopwatch {
public:
	double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

private:
	using Clock = std::chrono::steady_clock;
	Clock::time_point start_ = Clock::now();
};

}  // namespace index_boolean
