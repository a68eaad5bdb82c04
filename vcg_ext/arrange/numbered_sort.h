// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: a list that will be numbered; out: the same sorted. Guarantee: what std::sort would give, for
// any number of threads; or TooLarge, if numbers of 32 bits do not suffice.
#pragma once

#include "vcg_ext/arrange/arrangement.h"
#include "vcg_ext/base/bucket_sort.h"

#include <vector>

namespace index_boolean {

// See bucketSort, for which the keys are; few items should have the same.
// \return Ok, Cancelled, TooLarge; unless Ok, the items are in no order. Throws std::bad_alloc.
template <class Item, class KeyOf, class Before>
Status sortNumbered(std::vector<Item>& items, std::size_t keyCount, KeyOf&& keyOf, Before&& before,
                    const Options& options, Monitor& monitor) {
	return inOrder(
	    [&] { return checkCounts(items.size(), 0, options.mostElements); },
	    [&] { return bucketSort(items, keyCount, keyOf, before, options.threads, monitor); });
}

}  // namespace index_boolean
