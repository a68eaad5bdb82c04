// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: an indexed surface; out: its volume, area, components and closedness.
// Volumes are taken about the centre of the bounding box, on coordinates scaled by a power of two,
// and summed with compensation: the error is a few roundings of the sum of all |terms|, far from
// the origin and at any scale. A volume beyond the range of double becomes infinite or 0.
#include "measure.h"

#include "bounding_box.h"
#include "mesh_checks.h"
#include "parallel.h"

#include <cmath>

namespace index_boolean {

namespace {

constexpr std::size_t kGrain = 8192;

using Corners = std::array<std::uint32_t, 3>;

// A sum of doubles that keeps what each addition rounds off.
class CompensatedSum {
public:
	void add(double x) {
		const double total = sum_ + x;
		const double part = total - sum_;
		lost_ += (sum_ - (total - part)) + (x - part);
		sum_ = total;
	}

	void add(const CompensatedSum& other) {
		add(other.sum_);
		lost_ += other.lost_;
	}

	double value() const { return sum_ + lost_; }

private:
	double sum_ = 0;
	double lost_ = 0;
};

// Moves the box's centre to the origin and brings its size near 1, by a power of two.
struct Frame {
	Point centre;
	int exponent;  // of the power that undoes the scaling of a length
	double scale;

	Point map(const Point& p) const {
		return {(p[0] - centre[0]) * scale, (p[1] - centre[1]) * scale, (p[2] - centre[2]) * scale};
	}
};

Frame makeFrame(const BoundingBox& box) {
	Frame frame{};
	frame.centre = box.centre();
	std::frexp(box.halfSize(), &frame.exponent);
	frame.exponent = std::max(frame.exponent, -1000);  // a power's inverse has to be a double too
	frame.scale = std::ldexp(1.0, -frame.exponent);
	return frame;
}

struct Sums {
	CompensatedSum sixVolumes;
	CompensatedSum twoAreas;
};

// The edges' cross product comes first: it is small where the triangle is, so its roundings are
// small compared with the triangle's share of the volume.
void addTriangle(const Point& p, const Point& q, const Point& r, Sums& sums) {
	const Point u = {q[0] - p[0], q[1] - p[1], q[2] - p[2]};
	const Point v = {r[0] - p[0], r[1] - p[1], r[2] - p[2]};
	const Point n = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
	                 u[0] * v[1] - u[1] * v[0]};
	sums.sixVolumes.add(p[0] * n[0] + p[1] * n[1] + p[2] * n[2]);
	sums.twoAreas.add(std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]));
}

Status sumTriangles(const std::vector<Point>& points, const std::vector<Corners>& triangles,
                    const Frame& frame, int threads, Sums& out) {
	Monitor unheard;
	std::vector<Sums> parts(chunkCount(triangles.size(), kGrain));
	const Status status =
	    parallelForChunks(triangles.size(), kGrain, threads, unheard,
	                      [&](std::size_t chunk, std::size_t begin, std::size_t end) {
		                      for (std::size_t i = begin; i < end; ++i) {
			                      const Corners& t = triangles[i];
			                      addTriangle(frame.map(points[t[0]]), frame.map(points[t[1]]),
			                                  frame.map(points[t[2]]), parts[chunk]);
		                      }
	                      });
	for (const Sums& part : parts) {
		out.sixVolumes.add(part.sixVolumes);
		out.twoAreas.add(part.twoAreas);
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
	Sums sums;
	std::uint64_t checksum = 0;
	Status status = findBoundingBox(points.data(), points.size(), threads, unheard, box);
	const Frame frame = makeFrame(box);
	if (status.ok())
		status = sumTriangles(points, triangles, frame, threads, sums);
	if (status.ok())
		status = countComponents(points.size(), triangles, threads, measure.components);
	if (status.ok()) {
		status = boundaryChecksum(triangles.data(), triangles.data() + triangles.size(), threads,
		                          unheard, checksum);
	}
	measure.volume = std::ldexp(sums.sixVolumes.value() / 6, 3 * frame.exponent);
	measure.area = std::ldexp(sums.twoAreas.value() / 2, 2 * frame.exponent);
	measure.closed = status.ok() && checksum == 0;
	return measure;
}

}  // namespace index_boolean
