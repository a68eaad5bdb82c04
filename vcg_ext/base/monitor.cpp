// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the progress of stages; out: calls of the callback. Guarantee: the fraction never falls and
// stays in [0,1]; a stage's beginning is always reported, progress within it every 10 ms at most;
// once cancelled, always cancelled, and the callback is left alone. What the callback does to the
// floating-point environment ends with it.
#include "vcg_ext/base/monitor.h"

#include "vcg_ext/base/fp_environment.h"

#include <algorithm>
#include <chrono>

namespace index_boolean {

namespace {

constexpr long long kNanosecondsBetweenCalls = 10'000'000;

long long now() {
	using namespace std::chrono;
	return duration_cast<nanoseconds>(steady_clock::now().time_since_epoch()).count();
}

}  // namespace

void Monitor::beginStage(const char* stage, double from, double to) {
	stage_ = stage;
	from_ = from;
	to_ = to;
	call(from);
}

void Monitor::report(double fractionOfStage) {
	if (callback_ && now() - lastCallNanoseconds_ >= kNanosecondsBetweenCalls) {
		call(from_ + (to_ - from_) * fractionOfStage);
	}
}

// Nothing may be thrown through the core: a callback that throws asks for cancelling too.
void Monitor::call(double fraction) {
	if (!callback_ || cancelled()) {
		return;
	}
	last_ = fraction > last_ ? std::min(fraction, 1.0) : last_;
	bool goOn = false;
	FpEnvironment ours;
	ours.save();
	try {
		goOn = callback_(last_, stage_);
	} catch (...) {
		goOn = false;
	}
	ours.restore();  // a window's events may run drivers that change it
	if (!goOn) {
		cancelled_.store(true, std::memory_order_relaxed);
	}
	lastCallNanoseconds_ = now();
}

}  // namespace index_boolean
