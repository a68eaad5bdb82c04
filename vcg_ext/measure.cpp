// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: an indexed surface; out: its volume, area, components and closedness.
// Volumes are taken about the centre of the bounding box, on coordinates scaled by a power of two,
// and summed with compensation: the error is a few roundings of the sum of all |terms|, far from
// the origin and at any scale. A volume beyond the range of double becomes infinite or 0.
#include "measure.h"

#include "huge_pages.h"
#include "mesh_checks.h"
#include "parallel.h"
#include "surface_sums.h"

#include <atomic>
#include <memory>

namespace index_boolean {

namespace {

constexpr std::size_t kGrain = 8192;

using Corners = std::array<std::uint32_t, 3>;

// Sets of vertices that threads unite at the same time without locks. A vertex's parent never lies
// above it, so that the lowest vertex of a set is its root, in whatever order sets are united.
class VertexSets {
public:
	explicit VertexSets(std::size_t size)
	    : size_(size), parents_(makeHuge<std::atomic<std::uint32_t>>(size)) {}

	// Before any are united: no vertex of [begin, end) is in a set.
	void clear(std::size_t begin, std::size_t end) {
		for (std::size_t i = begin; i < end; ++i)
			parents_[i].store(kUnused, std::memory_order_relaxed);
	}

	void unite(std::uint32_t a, std::uint32_t b) {
		while (true) {
			a = root(a);
			b = root(b);
			if (a == b)
				return;
			if (a < b)
				std::swap(a, b);
			std::uint32_t expected = a;  // still a root?
			if (parents_[a].compare_exchange_strong(expected, b, std::memory_order_relaxed))
				return;
		}
	}

	std::size_t count() const {
		std::size_t count = 0;
		for (std::size_t i = 0; i < size_; ++i)
			count += parents_[i].load(std::memory_order_relaxed) == i ? 1 : 0;
		return count;
	}

private:
	static constexpr std::uint32_t kUnused = 0xffffffff;

	// A vertex becomes a set when its root is first asked for. What a vertex below its root points
	// to may be stored over by another thread, but only by a vertex of its set that is above the
	// root as well.
	std::uint32_t root(std::uint32_t vertex) {
		std::uint32_t parent = parents_[vertex].load(std::memory_order_relaxed);
		if (parent == kUnused &&
		    parents_[vertex].compare_exchange_strong(parent, vertex, std::memory_order_relaxed))
			return vertex;
		while (parent != vertex) {
			const std::uint32_t grandparent = parents_[parent].load(std::memory_order_relaxed);
			if (grandparent != parent)
				parents_[vertex].store(grandparent, std::memory_order_relaxed);
			vertex = grandparent;
			parent = parents_[vertex].load(std::memory_order_relaxed);
		}
		return vertex;
	}

	std::size_t size_;
	std::unique_ptr<std::atomic<std::uint32_t>[]> parents_;
};

// What one pass over a part of the triangles adds up.
struct Totals {
	SurfaceSums sums;
	std::uint64_t boundary = 0;
};

Totals lookAt(const Corners* begin, const Corners* end, const std::vector<Point>& points,
              const SumFrame& frame, VertexSets& sets) {
	Totals totals;
	for (const Corners* t = begin; t != end; ++t) {
		const auto [a, b, c] = *t;
		addTriangle(frame.map(points[a]), frame.map(points[b]), frame.map(points[c]), totals.sums);
		totals.boundary += boundaryTerm(a, b, c);
		sets.unite(a, b);
		sets.unite(b, c);
	}
	return totals;
}

}  // namespace

BlockMeasure measureSurface(const std::vector<Point>& points,
                            const std::vector<std::array<std::uint32_t, 3>>& triangles,
                            int threads) {
	const FpEnvironmentGuard environment;
	BlockMeasure measure;
	if (triangles.empty())
		return measure;
	Monitor unheard;
	BoundingBox box{};
	Status status = findBoundingBox(points.data(), points.size(), threads, unheard, box);
	const SumFrame frame = makeSumFrame(box);
	VertexSets sets(points.size());
	if (status.ok()) {
		status =
		    parallelFor(points.size(), kGrain, threads, unheard,
		                [&sets](std::size_t begin, std::size_t end) { sets.clear(begin, end); });
	}
	std::vector<Totals> parts(chunkCount(triangles.size(), kGrain));
	if (status.ok()) {
		const Corners* all = triangles.data();
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
