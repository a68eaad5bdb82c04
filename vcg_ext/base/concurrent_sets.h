// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Disjoint sets over 0 .. n-1 that threads unite at the same time without locks. An element's
// parent never lies above it, so that the lowest element of a set is its root, in whatever order
// sets are united.
#pragma once

#include "vcg_ext/base/huge_vector.h"
#include "vcg_ext/base/ids.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <utility>

namespace index_boolean {

class ConcurrentSets {
public:
	ConcurrentSets() = default;
	explicit ConcurrentSets(std::size_t size)
	    : parents_(HugeVector<std::atomic<std::uint32_t>>::forOverwrite(size)) {}

	// Before any are united, for all elements [begin, end): they are in no set until they are
	// united with others.
	void clear(std::size_t begin, std::size_t end) {
		for (std::size_t i = begin; i < end; ++i) {
			parents_[i].store(kNone, std::memory_order_relaxed);
		}
	}

	// The same, but each is a set of its own.
	void makeSets(std::size_t begin, std::size_t end) {
		for (std::size_t i = begin; i < end; ++i) {
			parents_[i].store(static_cast<std::uint32_t>(i), std::memory_order_relaxed);
		}
	}

	// \return an element of both's set, its root unless another thread unites it meanwhile
	std::uint32_t unite(std::uint32_t a, std::uint32_t b) {
		while (true) {
			a = find(a);
			b = find(b);
			if (a == b) {
				return a;
			}
			if (a < b) {
				std::swap(a, b);
			}
			std::uint32_t expected = a;  // still a root?
			if (parents_[a].compare_exchange_strong(expected, b, std::memory_order_relaxed)) {
				return b;
			}
		}
	}

	// Neighbours on a surface mostly point at one root already: one search, two glances.
	void unite(const std::array<std::uint32_t, 3>& corners) {
		std::uint32_t set = find(corners[0]);
		if (root(corners[1]) != set) {
			set = unite(set, corners[1]);
		}
		if (root(corners[2]) != set) {
			unite(set, corners[2]);
		}
	}

	// Once all are united: makes the elements [begin, end) point at their roots. Afterwards root()
	// may be called for them.
	void flatten(std::size_t begin, std::size_t end) {
		for (std::size_t i = begin; i < end; ++i) {
			std::uint32_t parent = root(static_cast<std::uint32_t>(i));
			while (parent != kNone && root(parent) != parent) {
				parent = root(parent);
			}
			parents_[i].store(parent, std::memory_order_relaxed);
		}
	}
	std::uint32_t root(std::uint32_t i) const {
		return parents_[i].load(std::memory_order_relaxed);
	}

	// The number of sets.
	std::size_t count() const {
		std::size_t count = 0;
		for (std::size_t i = 0; i < parents_.size(); ++i) {
			count += parents_[i].load(std::memory_order_relaxed) == i ? 1 : 0;
		}
		return count;
	}

private:
	// An element in no set becomes one. What an element below its root points to may be stored over
	// by another thread, but only by an element of its set that is above the root as well.
	std::uint32_t find(std::uint32_t i) {
		std::uint32_t parent = parents_[i].load(std::memory_order_relaxed);
		if (parent == kNone &&
		    parents_[i].compare_exchange_strong(parent, i, std::memory_order_relaxed)) {
			return i;
		}
		while (parent != i) {
			const std::uint32_t grandparent = parents_[parent].load(std::memory_order_relaxed);
			if (grandparent != parent) {
				parents_[i].store(grandparent, std::memory_order_relaxed);
			}
			i = grandparent;
			parent = parents_[i].load(std::memory_order_relaxed);
		}
		return i;
	}

	HugeVector<std::atomic<std::uint32_t>> parents_;
};

}  // namespace index_boolean
