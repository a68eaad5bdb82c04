// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: a point; out: a number that depends on its coordinates alone, the same for 0 and -0. And an
// order by that number: like chance, but the same in every numbering.
#pragma once

#include "vcg_ext/base/point.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

namespace index_boolean {

// Mixes the bits of the three coordinates. Equal points have equal hashes. O(1).
inline std::uint64_t coordinateHash(const Point& p) {
	std::uint64_t hash = 0x9e3779b97f4a7c15u;
	for (const double coordinate : p) {
		const double unsignedZero = coordinate + 0.0;
		std::uint64_t bits;
		std::memcpy(&bits, &unsignedZero, sizeof bits);
		hash = (hash ^ bits) * 0xff51afd7ed558ccdu;
		hash ^= hash >> 32;
	}
	return hash;
}

// Sorts vertices by the hashes of their places.
// \param placeOf  of a vertex
// \param isBefore a strict order of two vertices whose hashes are equal
// Throws std::bad_alloc. Complexity: O(n log n).
template <class PlaceOf, class IsBefore>
void sortByHash(std::vector<std::uint32_t>& vertices, PlaceOf&& placeOf, IsBefore&& isBefore) {
	struct Hashed {
		std::uint64_t hash;
		std::uint32_t vertex;
	};
	std::vector<Hashed> hashed;
	hashed.reserve(vertices.size());
	for (const std::uint32_t v : vertices) {
		hashed.push_back({coordinateHash(placeOf(v)), v});
	}
	std::sort(hashed.begin(), hashed.end(), [&](const Hashed& a, const Hashed& b) {
		return a.hash != b.hash ? a.hash < b.hash : isBefore(a.vertex, b.vertex);
	});
	std::transform(hashed.begin(), hashed.end(), vertices.begin(),
	               [](const Hashed& h) { return h.vertex; });
}

}  // namespace index_boolean
