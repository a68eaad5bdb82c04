// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: n places, each with any number of items; out: all items in one array, in the order of the
// places, for any number of threads. They are visited twice: counted, then written, so that the
// array never grows.
#pragma once

#include "vcg_ext/base/huge_vector.h"
#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/base/status.h"

#include <numeric>
#include <vector>

namespace index_boolean {

// Lists the items of all places.
// \param n          how many places
// \param visitItems visitItems(i, visit): calls visit(item) for each item of place i, twice the
// same;
//                   from any thread
// \param out        replaced
// \return Ok, Cancelled, OutOfMemory or InternalError. Throws std::bad_alloc.
// Complexity: O(n + m) for m items, in parallel.
template <class Item, class VisitItems>
Status listInParallel(std::size_t n, VisitItems&& visitItems, int threads, Monitor& monitor,
                      HugeVector<Item>& out) {
	constexpr std::size_t kGrain = 1 << 12;
	std::vector<std::size_t> ends(chunkCount(n, kGrain) + 1, 0);  // of each chunk's items
	const auto count = [&](std::size_t chunk, std::size_t begin, std::size_t end) {
		std::size_t found = 0;
		for (std::size_t i = begin; i < end; ++i) {
			visitItems(i, [&found](const Item&) { ++found; });
		}
		ends[chunk + 1] = found;
	};
	const auto write = [&](std::size_t chunk, std::size_t begin, std::size_t end) {
		Item* next = out.data() + ends[chunk];
		for (std::size_t i = begin; i < end; ++i) {
			visitItems(i, [&next](const Item& item) { *next++ = item; });
		}
	};
	return inOrder([&] { return parallelForChunks(n, kGrain, threads, monitor, count); },
	               [&] {
		               std::partial_sum(ends.begin(), ends.end(), ends.begin());
		               out.resizeForOverwrite(ends.back());
		               return parallelForChunks(n, kGrain, threads, monitor, write);
	               });
}

}  // namespace index_boolean
