// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: an indexed surface; out: its volume, area, components and closedness.
// Volumes are taken about the centre of the bounding box, on coordinates scaled by a power of two,
// and summed with compensation: the error is a few roundings of the sum of all |terms|, far from
// the origin and at any scale. A volume beyond the range of double becomes infinite or 0.
#include "measure.h"

#include "mesh_checks.h"
#include "parallel.h"
#include "surface_sums.h"

#include <atomic>

namespace index_boolean {

namespace {

constexpr std::size_t kGrain = 8192;

using Corners = std::array<std::uint32_t, 3>;

Status sumTriangles(const std::vector<Point>& points, const std::vector<Corners>& triangles,
                    const SumFrame& frame, int threads, SurfaceSums& out) {
	Monitor unheard;
	std::vector<SurfaceSums> parts(chunkCount(triangles.size(), kGrain));
	const Status status =
	    parallelForChunks(triangles.size(), kGrain, threads, unheard,
	                      [&](std::size_t chunk, std::size_t begin, std::size_t end) {
		                      for (std::size_t i = begin; i < end; ++i) {
			                      const Corners& t = triangles[i];
			                      addTriangle(frame.map(points[t[0]]), frame.map(points[t[1]]),
			                                  frame.map(points[t[2]]), parts[chunk]);
		                      }
	                      });
	for (const SurfaceSums& part : parts) {
		out.add(part, 1);
	}
	return status;
}

// Sets of vertices that threads unite at the same time without locks. A vertex's parent never lies
// above it, so that the lowest vertex of a set is its root, in whatever order sets are united.
class VertexSets {
public:
	explicit VertexSets(std::size_t size) : parents_(size) {
		for (auto& parent : parents_)
			parent.store(kUnused, std::memory_order_relaxed);
	}

	// Marks a vertex as used. All are marked before any are united.
	void use(std::uint32_t vertex) { parents_[vertex].store(vertex, std::memory_order_relaxed); }

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

	// The number of roots in [begin, end).
	std::size_t countRoots(std::size_t begin, std::size_t end) const {
		std::size_t count = 0;
		for (std::size_t i = begin; i < end; ++i)
			count += parents_[i].load(std::memory_order_relaxed) == i ? 1 : 0;
		return count;
	}

private:
	static constexpr std::uint32_t kUnused = 0xffffffff;

	std::uint32_t root(std::uint32_t vertex) {
		std::uint32_t parent = parents_[vertex].load(std::memory_order_relaxed);
		while (parent != vertex) {
			const std::uint32_t grandparent = parents_[parent].load(std::memory_order_relaxed);
			if (grandparent != parent) {
				parents_[vertex].compare_exchange_weak(parent, grandparent,
				                                       std::memory_order_relaxed);
			}
			vertex = grandparent;
			parent = parents_[vertex].load(std::memory_order_relaxed);
		}
		return vertex;
	}

	std::vector<std::atomic<std::uint32_t>> parents_;
};

Status countComponents(std::size_t pointCount, const std::vector<Corners>& triangles, int threads,
                       std::size_t& out) {
	Monitor unheard;
	VertexSets sets(pointCount);
	Status status = parallelFor(triangles.size(), kGrain, threads, unheard,
	                            [&](std::size_t begin, std::size_t end) {
		                            for (std::size_t i = begin; i < end; ++i) {
			                            for (const std::uint32_t vertex : triangles[i])
				                            sets.use(vertex);
		                            }
	                            });
	if (!status.ok())
		return status;
	status = parallelFor(triangles.size(), kGrain, threads, unheard,
	                     [&](std::size_t begin, std::size_t end) {
		                     for (std::size_t i = begin; i < end; ++i) {
			                     sets.unite(triangles[i][0], triangles[i][1]);
			                     sets.unite(triangles[i][1], triangles[i][2]);
		                     }
	                     });
	out = sets.countRoots(0, pointCount);
	return status;
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
	SurfaceSums sums;
	std::uint64_t checksum = 0;
	Status status = findBoundingBox(points.data(), points.size(), threads, unheard, box);
	const SumFrame frame = makeSumFrame(box);
	if (status.ok())
		status = sumTriangles(points, triangles, frame, threads, sums);
	if (status.ok())
		status = countComponents(points.size(), triangles, threads, measure.components);
	if (status.ok()) {
		status = boundaryChecksum(triangles.data(), triangles.data() + triangles.size(), threads,
		                          unheard, checksum);
	}
	measure.volume = volumeOf(sums, frame);
	measure.area = areaOf(sums, frame);
	measure.closed = status.ok() && checksum == 0;
	return measure;
}

}  // namespace index_boolean
