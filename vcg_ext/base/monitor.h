// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Progress and cancel. One Monitor belongs to one run; its callback is called on the thread that
// started the run only, with a fraction that never falls.
#pragma once

#include <atomic>
#include <functional>

namespace index_boolean {

class Monitor {
public:
	// fraction in [0,1], the stage's name (a literal); false asks for cancelling.
	using Callback = std::function<bool(double fraction, const char* stage)>;

	Monitor() = default;
	explicit Monitor(Callback callback) : callback_(std::move(callback)) {}

	// Names the stage that runs now and the part of the whole that it covers.
	// Main thread only. O(1).
	void beginStage(const char* stage, double from, double to);

	// Reports progress within the stage, at most every 10 ms. Main thread only. O(1).
	void report(double fractionOfStage);

	// True once the callback has answered false. Any thread.
	bool cancelled() const { return cancelled_.load(std::memory_order_relaxed); }

private:
	void call(double fraction);

	Callback callback_;
	std::atomic<bool> cancelled_{false};
	const char* stage_ = "";
	double from_ = 0, to_ = 0, last_ = 0;
	long long lastCallNanoseconds_ = 0;
};

}  // namespace index_boolean
