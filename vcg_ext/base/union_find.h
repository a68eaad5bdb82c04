// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Disjoint sets over 0 .. n-1 in one array. The smallest element of a set is its root, so the
// roots do not depend on the order of the unions.
#pragma once

#include "vcg_ext/base/huge_vector.h"

#include <array>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace index_boolean {

class UnionFind {
public:
	explicit UnionFind(std::size_t n) : parent_(HugeVector<std::uint32_t>::forOverwrite(n)) {
		std::iota(parent_.begin(), parent_.end(), 0u);
	}

	// Adds elements, each a set of its own, up to n in all.
	void grow(std::size_t n) {
		for (std::size_t i = parent_.size(); i < n; ++i) {
			parent_.push_back(static_cast<std::uint32_t>(i));
		}
	}

	std::uint32_t find(std::uint32_t i) {
		while (parent_[i] != i) {
			parent_[i] = parent_[parent_[i]];
			i = parent_[i];
		}
		return i;
	}

	// \return the root of both from then on
	std::uint32_t unite(std::uint32_t a, std::uint32_t b) {
		a = find(a);
		b = find(b);
		const std::uint32_t lower = a < b ? a : b;
		parent_[a < b ? b : a] = lower;
		return lower;
	}

	// Neighbours on a surface mostly point at one root already: one search, two glances.
	void unite(const std::array<std::uint32_t, 3>& corners) {
		std::uint32_t root = find(corners[0]);
		if (parent_[corners[1]] != root) {
			root = unite(root, corners[1]);
		}
		if (parent_[corners[2]] != root) {
			unite(root, corners[2]);
		}
	}

	// Makes every element point at its root, in one pass: parents precede their children.
	// Afterwards root() may be called from any thread, until the next union.
	void flatten() {
		for (std::uint32_t& parent : parent_) {
			parent = parent_[parent];
		}
	}
	std::uint32_t root(std::uint32_t i) const { return parent_[i]; }

	std::size_t size() const { return parent_.size(); }

private:
	HugeVector<std::uint32_t> parent_;
};

}  // namespace index_boolean
