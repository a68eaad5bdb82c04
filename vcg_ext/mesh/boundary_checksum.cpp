// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: triangles; out: the sum of their terms, chunk by chunk.
#include "vcg_ext/mesh/boundary_checksum.h"

#include "vcg_ext/base/parallel.h"

#include <numeric>
#include <vector>

namespace index_boolean {

namespace {

constexpr std::size_t kGrain = 16384;

std::uint32_t indexOf(VertexId vertex) { return vertex.value; }
std::uint32_t indexOf(std::uint32_t vertex) { return vertex; }

template <class Corners>
Status checksumOf(const Corners* triangles, std::size_t count, int threads, Monitor& monitor,
                  std::uint64_t& sum) {
	std::vector<std::uint64_t> parts(chunkCount(count, kGrain));
	const Status status = parallelForChunks(
	    count, kGrain, threads, monitor,
	    [&](std::size_t chunk, std::size_t begin, std::size_t end) {
		    std::uint64_t part = 0;
		    for (std::size_t i = begin; i < end; ++i) {
			    part += boundaryTerm(indexOf(triangles[i][0]), indexOf(triangles[i][1]),
			                         indexOf(triangles[i][2]));
		    }
		    parts[chunk] = part;
	    });
	sum = std::accumulate(parts.begin(), parts.end(), std::uint64_t{0});
	return status;
}

}  // namespace

Status boundaryChecksum(const Triangle* begin, const Triangle* end, int threads, Monitor& monitor,
                        std::uint64_t& sum) {
	return checksumOf(begin, static_cast<std::size_t>(end - begin), threads, monitor, sum);
}

Status boundaryChecksum(const std::array<std::uint32_t, 3>* begin,
                        const std::array<std::uint32_t, 3>* end, int threads, Monitor& monitor,
                        std::uint64_t& sum) {
	return checksumOf(begin, static_cast<std::size_t>(end - begin), threads, monitor, sum);
}

}  // namespace index_boolean
