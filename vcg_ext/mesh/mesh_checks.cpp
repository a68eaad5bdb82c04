// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: counts; out: whether they are within the limit. in: triangles; out: a checksum of their
// boundary, or the boundary's edges and faces.
#include "vcg_ext/mesh/mesh_checks.h"

#include "vcg_ext/base/parallel.h"

#include <algorithm>
#include <numeric>

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

// One side of one face.
struct Side {
	VertexId lower, upper;
	std::uint32_t face;
	bool forward;  // runs from lower to upper

	bool hasEdgeOf(const Side& other) const { return lower == other.lower && upper == other.upper; }
};

std::vector<Side> sortedSides(const Triangle* begin, const Triangle* end) {
	std::vector<Side> sides;
	sides.reserve(3 * static_cast<std::size_t>(end - begin));
	for (const Triangle* triangle = begin; triangle != end; ++triangle) {
		for (int corner = 0; corner < 3; ++corner) {
			const VertexId from = (*triangle)[static_cast<std::size_t>(corner)];
			const VertexId to = (*triangle)[static_cast<std::size_t>(nextCorner(corner))];
			sides.push_back({std::min(from, to), std::max(from, to),
			                 static_cast<std::uint32_t>(triangle - begin), from < to});
		}
	}
	std::sort(sides.begin(), sides.end(), [](const Side& p, const Side& q) {
		return p.lower != q.lower ? p.lower < q.lower : p.upper < q.upper;
	});
	return sides;
}

Status tooLargeIf(bool isTooLarge, std::size_t count) {
	Status status;
	if (isTooLarge) {
		status.code = StatusCode::TooLarge;
		status.count = count;
	}
	return status;
}

}  // namespace

Status checkCounts(std::size_t points, std::size_t faces, std::size_t most) {
	const std::size_t count = std::max(points, faces);
	return tooLargeIf(count > std::min(most, kMostElements), count);
}

Status checkNumbering(std::size_t count, std::size_t most) {
	return tooLargeIf(count > 2 * std::min(most, kMostElements), count);
}

Status boundaryChecksum(const Triangle* begin, const Triangle* end, int threads, Monitor& monitor,
                        std::uint64_t& sum) {
	return checksumOf(begin, static_cast<std::size_t>(end - begin), threads, monitor, sum);
}

Status boundaryChecksum(const std::array<std::uint32_t, 3>* begin,
                        const std::array<std::uint32_t, 3>* end, int threads, Monitor& monitor,
                        std::uint64_t& sum) {
	return checksumOf(begin, static_cast<std::size_t>(end - begin), threads, monitor, sum);
}

void findUnmatchedEdges(const Triangle* begin, const Triangle* end, UnmatchedEdges& out) {
	out = {};
	const std::vector<Side> sides = sortedSides(begin, end);
	for (std::size_t first = 0, next = 0; first < sides.size(); first = next) {
		std::size_t forward = 0;
		for (; next < sides.size() && sides[next].hasEdgeOf(sides[first]); ++next) {
			forward += sides[next].forward ? 1 : 0;
		}
		const std::size_t count = next - first;
		if (2 * forward == count) {
			continue;
		}
		const bool border = count % 2 == 1;
		std::size_t& edges = border ? out.borderEdges : out.conflictingEdges;
		++edges;
		if (edges == 1 && (border || out.borderEdges == 0)) {
			out.firstEdge = {sides[first].lower, sides[first].upper};
		}
		for (std::size_t i = first; i < next; ++i) {
			out.faces.push_back(sides[i].face);
		}
	}
	std::sort(out.faces.begin(), out.faces.end());
	out.faces.erase(std::unique(out.faces.begin(), out.faces.end()), out.faces.end());
}

}  // namespace index_boolean
