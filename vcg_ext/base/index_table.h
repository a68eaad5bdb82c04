// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: indices of items of any kind, and which items are equal; out: one index for all equal items.
// Open addressing with linear probing, at most half full: the items stay with the caller, so that
// an entry is one index.
#pragma once

#include "vcg_ext/base/huge_vector.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace index_boolean {

// A set of indices, found by their items.
class IndexTable {
public:
	static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

	// \param most how many indices there may be. Throws std::bad_alloc.
	explicit IndexTable(std::size_t most = 0) { reset(most); }

	// Empty again, with room for that many. Throws std::bad_alloc. Complexity: O(most).
	void reset(std::size_t most) {
		std::size_t size = 16;
		while (size < 2 * most) {
			size *= 2;
		}
		slots_.assign(size, kNone);
	}

	// The slot of an item: it holds the index of an equal one, or kNone; then the caller may put an
	// index there.
	// \param hash  of the item, mixed well in its lower bits; the same for equal ones
	// \param isSame isSame(index): the item at an index in the table equals this one
	// Complexity: O(1) as expected.
	template <class IsSame>
	std::uint32_t& slotOf(std::uint64_t hash, IsSame&& isSame) {
		return slots_[placeOf(hash, isSame)];
	}

	// The index of an equal item, or kNone. The same complexity.
	template <class IsSame>
	std::uint32_t find(std::uint64_t hash, IsSame&& isSame) const {
		return slots_[placeOf(hash, isSame)];
	}

private:
	template <class IsSame>
	std::size_t placeOf(std::uint64_t hash, IsSame& isSame) const {
		const std::size_t mask = slots_.size() - 1;
		std::size_t place = static_cast<std::size_t>(hash) & mask;
		while (slots_[place] != kNone && !isSame(slots_[place])) {
			place = (place + 1) & mask;
		}
		return place;
	}

	HugeVector<std::uint32_t> slots_;
};

// A number for each of any pairs of numbers. Grows.
class PairTable {
	struct Entry {
		std::uint32_t a, b, number;
	};

	static std::uint64_t hashOf(std::uint32_t a, std::uint32_t b) {
		std::uint64_t hash = std::uint64_t{a} << 32 | b;
		hash = (hash ^ hash >> 31) * 0x9e3779b97f4a7c15U;
		return hash ^ hash >> 29;
	}

	auto isPair(std::uint32_t a, std::uint32_t b) const {
		return [this, a, b](std::uint32_t i) { return entries_[i].a == a && entries_[i].b == b; };
	}

public:
	// The number of a pair; if it has none yet, from now on the given one. O(1) as expected, grown
	// over all calls. Throws std::bad_alloc.
	std::uint32_t findOrAdd(std::uint32_t a, std::uint32_t b, std::uint32_t number) {
		if (entries_.size() == most_) {
			grow();
		}
		std::uint32_t& slot = slotOf(a, b);
		if (slot == IndexTable::kNone) {
			slot = static_cast<std::uint32_t>(entries_.size());
			entries_.push_back({a, b, number});
		}
		return entries_[slot].number;
	}

	// The number of a pair, or kNone.
	std::uint32_t find(std::uint32_t a, std::uint32_t b) const {
		const std::uint32_t entry = table_.find(hashOf(a, b), isPair(a, b));
		return entry == IndexTable::kNone ? entry : entries_[entry].number;
	}

private:
	std::uint32_t& slotOf(std::uint32_t a, std::uint32_t b) {
		return table_.slotOf(hashOf(a, b), isPair(a, b));
	}

	void grow() {
		const std::size_t most = most_ == 0 ? 8 : 2 * most_;
		table_.reset(most);
		for (std::size_t i = 0; i < entries_.size(); ++i) {
			slotOf(entries_[i].a, entries_[i].b) = static_cast<std::uint32_t>(i);
		}
		most_ = most;
	}

	std::vector<Entry> entries_;
	IndexTable table_;
	std::size_t most_ = 0;  // entries that the table has room for
};

}  // namespace index_boolean
