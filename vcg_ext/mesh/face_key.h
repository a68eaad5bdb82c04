// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: a triangle; out: the same for all triangles on its corners, and which way round it is.
#pragma once

#include "vcg_ext/base/ids.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace index_boolean {

// A face by its corners without their order. Compared by these alone.
template <class Corner>
struct FaceKey {
	std::array<Corner, 3> corners;  // ascending
	bool ascending;                 // the face goes round them in that order

	friend bool operator==(const FaceKey& a, const FaceKey& b) { return a.corners == b.corners; }
	friend bool operator!=(const FaceKey& a, const FaceKey& b) { return !(a == b); }
	friend bool operator<(const FaceKey& a, const FaceKey& b) { return a.corners < b.corners; }
};

// The key of a triangle with corners of any ordered kind. O(1).
template <class Corner>
FaceKey<Corner> faceKeyOf(const std::array<Corner, 3>& triangle) {
	FaceKey<Corner> key{triangle, true};
	const auto order = [&key](std::size_t i, std::size_t j) {
		if (key.corners[j] < key.corners[i]) {
			std::swap(key.corners[i], key.corners[j]);
			key.ascending = !key.ascending;
		}
	};
	order(0, 1);
	order(1, 2);
	order(0, 1);
	return key;
}

// A face by its index, with its key.
template <class Corner>
struct KeyedFace {
	FaceKey<Corner> key;
	std::uint32_t face;
};

// Mixes three ids. Equal keys have equal hashes. O(1).
template <class Tag>
std::uint64_t hashOf(const FaceKey<Id<Tag>>& key) {
	std::uint64_t hash = 0x9e3779b97f4a7c15U;
	for (const Id<Tag> v : key.corners) {
		hash = (hash ^ v.value) * 0xff51afd7ed558ccdU;
		hash ^= hash >> 32;
	}
	return hash;
}

}  // namespace index_boolean
