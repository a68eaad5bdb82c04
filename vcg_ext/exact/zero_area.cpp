// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A face has area as soon as one component of its normal is certainly not zero; that settles
// nearly every face in plain doubles. Only where all three components are in doubt are their exact
// signs asked for.
#include "vcg_ext/exact/zero_area.h"

#include "vcg_ext/base/parallel.h"
#include "vcg_ext/exact/exact_sign.h"

namespace index_boolean {

namespace {

constexpr std::size_t kGrain = 16384;  // faces that a thread takes at a time

// Gathers the faces of [0, count) that have no area; faceAt(i) is a face's index, cornersOf(face)
// its three points.
template <class FaceAt, class CornersOf>
Status gatherZeroArea(std::size_t count, int threads, Monitor& monitor, const FaceAt& faceAt,
                      const CornersOf& cornersOf, std::vector<std::uint32_t>& out) try {
	out.clear();
	std::vector<std::vector<std::uint32_t>> found(chunkCount(count, kGrain));
	const Status status =
	    parallelForChunks(count, kGrain, threads, monitor,
	                      [&](std::size_t chunk, std::size_t begin, std::size_t end) {
		                      for (std::size_t i = begin; i < end; ++i) {
			                      const std::size_t face = faceAt(i);
			                      const std::array<const Point*, 3> corners = cornersOf(face);
			                      if (hasZeroArea(*corners[0], *corners[1], *corners[2])) {
				                      found[chunk].push_back(static_cast<std::uint32_t>(face));
			                      }
		                      }
	                      });
	for (const std::vector<std::uint32_t>& faces : found) {
		out.insert(out.end(), faces.begin(), faces.end());
	}
	return status;
} catch (const std::bad_alloc&) {
	return statusOf(StatusCode::OutOfMemory);
}

auto cornersIn(const Points& points, const IndexTriangles& triangles) {
	return [&points, &triangles](std::size_t face) -> std::array<const Point*, 3> {
		const IndexTriangle& t = triangles[face];
		return {&points[t[0]], &points[t[1]], &points[t[2]]};
	};
}

}  // namespace

bool hasZeroArea(const Point& a, const Point& b, const Point& c) {
	if (RoundedNormal(a, b, c).isCertain()) {
		return false;
	}
	return orient2d(a, b, c, 0) == 0 && orient2d(a, b, c, 1) == 0 && orient2d(a, b, c, 2) == 0;
}

Status findZeroAreaFaces(const Points& points, const IndexTriangles& triangles, FaceRange range,
                         int threads, Monitor& monitor, std::vector<std::uint32_t>& out) {
	const auto faceAt = [&range](std::size_t i) { return range.begin + i; };
	return gatherZeroArea(range.end - range.begin, threads, monitor, faceAt,
	                      cornersIn(points, triangles), out);
}

Status findZeroAreaFacesAmong(const std::vector<std::uint32_t>& candidates, const Points& points,
                              const IndexTriangles& triangles, int threads, Monitor& monitor,
                              std::vector<std::uint32_t>& out) {
	const auto faceAt = [&candidates](std::size_t i) { return candidates[i]; };
	return gatherZeroArea(candidates.size(), threads, monitor, faceAt, cornersIn(points, triangles),
	                      out);
}

}  // namespace index_boolean
