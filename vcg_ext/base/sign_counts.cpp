// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The counters are relaxed: only totals matter, taken when all threads have met.
#include "vcg_ext/base/sign_counts.h"

#ifdef INDEXBOOLEAN_COUNT_SIGNS

#include <atomic>

namespace index_boolean {

namespace {

std::array<std::array<std::atomic<std::uint64_t>, kDeciderCount>, kPredicateCount> counts;

}  // namespace

void countSign(Predicate predicate, DecidedBy decider) {
	counts[static_cast<std::size_t>(predicate)][static_cast<std::size_t>(decider)].fetch_add(
	    1, std::memory_order_relaxed);
}

SignCounts takeSignCounts() {
	SignCounts taken{};
	for (std::size_t p = 0; p < kPredicateCount; ++p) {
		for (std::size_t d = 0; d < kDeciderCount; ++d) {
			taken[p][d] = counts[p][d].exchange(0);
		}
	}
	return taken;
}

}  // namespace index_boolean

#else

namespace index_boolean {

SignCounts takeSignCounts() { return {}; }

}  // namespace index_boolean

#endif
