// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: items in any order; out: a sorted list that has each once, and where in it an item is.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace index_boolean {

// Sorts the items and leaves each once. Complexity: O(n log n).
template <class Item>
void sortUnique(std::vector<Item>& items) {
	std::sort(items.begin(), items.end());
	items.erase(std::unique(items.begin(), items.end()), items.end());
}

// The place of an item in a sorted list. \pre it is there. Complexity: O(log n).
template <class Item>
std::uint32_t placeIn(const std::vector<Item>& sorted, const Item& item) {
	return static_cast<std::uint32_t>(std::lower_bound(sorted.begin(), sorted.end(), item) -
	                                  sorted.begin());
}

}  // namespace index_boolean
