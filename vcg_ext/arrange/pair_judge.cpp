// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: a pair; out: taken if it meets wrongly. Doubles first.
#include "vcg_ext/arrange/pair_judge.h"

#include "vcg_ext/arrange/parted_faces.h"
#include "vcg_ext/base/parallel.h"

#include <algorithm>

namespace index_boolean {

void PairJudge::judge(std::uint32_t f, std::uint32_t g) {
	const FacePair pair{{std::min(f, g)}, {std::max(f, g)}};
	if (!taker_.wants(pair) || arePartedFaces(faces_, pair) || pollCancelled(monitor_)) {
		return;
	}
	switch (meetingOf(faces_, pair)) {
	case Meeting::Proper:
		break;
	case Meeting::Wrong:
		taker_.take(pair);
		break;
	case Meeting::Contradiction:
		contradiction_ = true;
		break;
	}
}

}  // namespace index_boolean
