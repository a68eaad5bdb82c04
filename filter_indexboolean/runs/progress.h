// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the host's callback; out: a monitor for each phase of a run. The core calls back on the
// thread that started the run only, which is what hosts ask for: they handle events in it.
#pragma once

#include <vcg_ext/index_boolean.h>

#include <algorithm>
#include <string>
#include <utility>

namespace index_boolean {

// How a host is told of progress: percents (0 to 100) and a stage's name; false cancels.
using HostCallback = bool(int, const char*);

// Divides the progress bar among the phases of a run. Each phase has a monitor of its own, since a
// monitor's fraction never falls.
class Progress {
public:
	explicit Progress(Monitor::Callback callback) : callback_(std::move(callback)) {}

	// The monitor of the next phase, for `share` of the bar.
	Monitor nextPhase(double share) {
		const double from = done_;
		done_ = std::min(done_ + share, 1.0);
		if (!callback_) {
			return Monitor();
		}
		return Monitor(
		    [callback = callback_, from, to = done_](double fraction, const char* stage) {
			    return callback(from + (to - from) * fraction, stage);
		    });
	}

private:
	Monitor::Callback callback_;
	double done_ = 0;
};

// \param callback may be null
inline Monitor::Callback progressCallback(HostCallback* callback) {
	if (callback == nullptr) {
		return {};
	}
	return [callback](double fraction, const char* stage) {
		std::string text(stage);
		std::replace(text.begin(), text.end(), '_', ' ');
		return callback(static_cast<int>(fraction * 100), text.c_str());
	};
}

}  // namespace index_boolean
