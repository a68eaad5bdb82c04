// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: a range in which equal elements are neighbours; out: its groups, one after another.
#pragma once

namespace index_boolean {

// Calls visit(first, last) for each maximal run [first, last) of elements that are the same as its
// first one.
// \param same   same(a, b): an equivalence of elements
// \param visit  may change the elements it is given, not the range
// Complexity: O(n) calls of same.
template <class Iterator, class Same, class Visit>
void forEachGroup(Iterator begin, Iterator end, Same&& same, Visit&& visit) {
	for (Iterator first = begin; first != end;) {
		Iterator last = first;
		do {
			++last;
		} while (last != end && same(*first, *last));
		visit(first, last);
		first = last;
	}
}

}  // namespace index_boolean
