// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: pairs of faces that may meet wrongly, as threads find them; out: those that do, told to whom
// it may concern. Guarantee: exact; nothing is stored.
#pragma once

#include "vcg_ext/arrange/face_pair.h"
#include "vcg_ext/arrange/faces_view.h"
#include "vcg_ext/base/monitor.h"

#include <atomic>

namespace index_boolean {

// Who takes pairs a < b that meet wrongly, on several threads at a time; a pair may come twice.
class WrongPairTaker {
public:
	virtual ~WrongPairTaker() = default;

	// False where it is of no use to know whether two faces meet wrongly.
	virtual bool wants(FacePair) const { return true; }

	// Throws what it likes, or std::bad_alloc: see parallelFor.
	virtual void take(FacePair pair) = 0;
};

// Judges pairs. One object for all threads.
class PairJudge {
public:
	PairJudge(const FacesView& faces, Monitor& monitor, WrongPairTaker& taker)
	    : faces_(faces), monitor_(monitor), taker_(taker) {}

	// Two different faces that have area, in any order. Nothing is judged any more once the run is
	// cancelled, which each exact decision looks for: some take long.
	void judge(std::uint32_t f, std::uint32_t g);

	// Whether signs have contradicted each other, which is a defect of our own.
	bool sawContradiction() const { return contradiction_; }

private:
	const FacesView& faces_;
	Monitor& monitor_;
	WrongPairTaker& taker_;
	std::atomic<bool> contradiction_{false};
};

}  // namespace index_boolean
