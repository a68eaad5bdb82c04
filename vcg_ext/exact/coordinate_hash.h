// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: a point; out: a number that depends on its coordinates alone, the same for 0 and -0.
#pragma once

#include "vcg_ext/base/point.h"

#include <cstdint>
#include <cstring>

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

}  // namespace index_boolean
