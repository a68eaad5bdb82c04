// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: triangles; out: a checksum of their boundary. Guarantee: it tells whether each directed edge
// occurs as often as its reverse, and is wrong with a probability of 2^-64 only, and only where an
// open surface is called closed.
#pragma once

#include "vcg_ext/base/mesh_types.h"
#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/status.h"

namespace index_boolean {

// A fixed bijection in which every bit of the key changes every bit of the hash about half the
// time: two rounds of multiplying by an odd number and folding the high half onto the low one.
// Negative (modulo 2^64) if the edge runs from the larger vertex to the smaller.
inline std::uint64_t signedEdgeHash(std::uint32_t from, std::uint32_t to) {
	const std::uint64_t lower = from < to ? from : to, upper = from < to ? to : from;
	std::uint64_t hash = (lower << 32 | upper) + 0x5851f42d4c957f2dU;
	hash = (hash ^ hash >> 32) * 0xd6e8feb86659fd93U;
	hash = (hash ^ hash >> 29) * 0xa0761d6478bd642fU;
	hash ^= hash >> 32;
	const std::uint64_t sign = 0 - std::uint64_t{from > to};
	return (hash ^ sign) - sign;
}

// What one triangle adds to the checksum below.
inline std::uint64_t boundaryTerm(std::uint32_t u, std::uint32_t v, std::uint32_t w) {
	return signedEdgeHash(u, v) + signedEdgeHash(v, w) + signedEdgeHash(w, u);
}

// Sums a 64-bit hash of each edge's vertices over all directed edges of the triangles [begin, end),
// modulo 2^64: plus from the smaller to the larger vertex, minus in reverse.
// \param sum 0 iff each directed edge occurs as often as its reverse
// \return Ok or Cancelled. Complexity: O(n), in parallel.
Status boundaryChecksum(const Triangle* begin, const Triangle* end, int threads, Monitor& monitor,
                        std::uint64_t& sum);
Status boundaryChecksum(const std::array<std::uint32_t, 3>* begin,
                        const std::array<std::uint32_t, 3>* end, int threads, Monitor& monitor,
                        std::uint64_t& sum);

}  // namespace index_boolean
