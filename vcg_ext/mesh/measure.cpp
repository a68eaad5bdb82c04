// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: an indexed surface; out: its volume, area, components and closedness.
// Volumes are taken about the centre of the bounding box, on coordinates scaled by a power of two,
// and summed with compensation: the error is a few roundings of the sum of all |terms|, far from
// the origin and at any scale. A volume beyond the range of double becomes infinite or 0.
#include "vcg_ext/mesh/measure.h"

#include "vcg_ext/base/concurrent_sets.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/exact/surface_sums.h"
#include "vcg_ext/mesh/boundary_checksum.h"

namespace index_boolean {

namespace {

constexpr std::size_t kGrain = 8192;

// What one pass over a part of the triangles adds up.
struct Totals {
	SurfaceSums sums;
	std::uint64_t boundary = 0;
};

Totals lookAt(const IndexTriangle* begin, const IndexTriangle* end, const Points& points,
              const SumFrame& frame, ConcurrentSets& sets) {
	Totals totals;
	for (const IndexTriangle* t = begin; t != end; ++t) {
		const auto [a, b, c] = *t;
		addTriangle(frame.map(points[a]), frame.map(points[b]), frame.map(points[c]), totals.sums);
		totals.boundary += boundaryTerm(a, b, c);
		sets.unite(*t);
	}
	return totals;
}

}  // namespace

BlockMeasure measureSurface(const Points& points, const IndexTriangles& triangles, int threads) {
	const FpEnvironmentGuard environment;
	BlockMeasure measure;
	if (triangles.empty()) {
		return measure;
	}
	Monitor unheard;
	BoundingBox box{};
	Status status = findBoundingBox(points.data(), points.size(), threads, unheard, box);
	const SumFrame frame = makeSumFrame(box);
	ConcurrentSets sets(points.size());
	if (status.ok()) {
		status =
		    parallelFor(points.size(), kGrain, threads, unheard,
		                [&sets](std::size_t begin, std::size_t end) { sets.clear(begin, end); });
	}
	std::vector<Totals> parts(chunkCount(triangles.size(), kGrain));
	if (status.ok()) {
		const IndexTriangle* all = triangles.data();
		status = parallelForChunks(triangles.size(), kGrain, threads, unheard,
		                           [&](std::size_t chunk, std::size_t begin, std::size_t end) {
			                           parts[chunk] =
			                               lookAt(all + begin, all + end, points, frame, sets);
		                           });
	}
	Totals totals;
	for (const Totals& part : parts) {
		totals.sums.add(part.sums, 1);
		totals.boundary += part.boundary;
	}
	measure.volume = volumeOf(totals.sums, frame);
	measure.area = areaOf(totals.sums, frame);
	measure.components = sets.count();
	measure.closed = status.ok() && totals.boundary == 0;
	return measure;
}

}  // namespace index_boolean
