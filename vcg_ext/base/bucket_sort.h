// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: items that begin with an index; out: the same sorted. Guarantee: what std::sort would give,
// for any number of threads, if the order is total.
#pragma once

#include "vcg_ext/base/huge_vector.h"
#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/base/status.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace index_boolean {

// Sorts items by counting how many there are of each few keys, then each such set on its own.
// \param items    a vector of them
// \param keyCount above all keys
// \param keyOf    of an item, an unsigned number that never falls in the order `before`
// \param before   a strict order
// \return Ok or Cancelled; else the items are in no order. Throws std::bad_alloc.
// Complexity: O(n), in parallel but for moving each item once, as long as no key is very frequent;
// O(n log n) else.
template <class Array, class KeyOf, class Before>
Status bucketSort(Array& items, std::size_t keyCount, KeyOf&& keyOf, Before&& before, int threads,
                  Monitor& monitor) {
	using Item = typename Array::value_type;
	constexpr std::size_t kFew = 4096, kItemsPerBucket = 4, kGrain = 4096;
	if (items.size() < kFew) {
		std::sort(items.begin(), items.end(), before);
		return {};
	}
	unsigned shift = 0;
	while (keyCount >> shift > items.size() / kItemsPerBucket) {
		++shift;
	}
	const auto bucketOf = [&](const Item& item) {
		return static_cast<std::size_t>(keyOf(item)) >> shift;
	};
	std::vector<std::uint32_t> ends((keyCount >> shift) + 2, 0);  // begins, until items are moved
	for (const Item& item : items) {
		++ends[bucketOf(item) + 1];
	}
	for (std::size_t bucket = 1; bucket < ends.size(); ++bucket) {
		ends[bucket] += ends[bucket - 1];
	}
	Array sorted = arrayForOverwrite(items.size(), items);
	for (const Item& item : items) {
		sorted[ends[bucketOf(item)]++] = item;
	}
	items.swap(sorted);
	return parallelFor(ends.size(), kGrain, threads, monitor,
	                   [&](std::size_t first, std::size_t last) {
		                   std::size_t begin = first == 0 ? 0 : ends[first - 1];
		                   for (std::size_t bucket = first; bucket < last; ++bucket) {
			                   Item* const bucketBegin = items.data() + begin;
			                   std::sort(bucketBegin, items.data() + ends[bucket], before);
			                   begin = ends[bucket];
		                   }
	                   });
}

}  // namespace index_boolean
