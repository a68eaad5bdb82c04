// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A region is what the seed reaches within a slab: a closure, which no order of visits changes. The
// slab follows from the faces reached so far: its normal is the mean of theirs by area, which
// slivers turned anyhow do not disturb, its middle that of their corners. Sums are taken in the
// order of the faces' sizes and places. So a wall of which one piece is the seed is found as a
// whole, though the piece alone tells its plane too badly to reach far.
#include "vcg_ext/mesh/plane_regions.h"

#include "vcg_ext/base/edge_buckets.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/base/vectors.h"
#include "vcg_ext/exact/exact_sign.h"

#include <algorithm>
#include <cmath>

namespace index_boolean {

namespace {

constexpr std::size_t kGrain = 1 << 12;
constexpr int kMostFits = 16;

// A face's corners in lexicographic order, and the cross product of its sides, front up.
struct SortedFace {
	std::array<Point, 3> corners;
	Point normal;  // twice the area long

	SortedFace(const Points& points, const IndexTriangle& t)
	    : corners{points[t[0]], points[t[1]], points[t[2]]}, normal{} {
		double sign = 1;
		const auto order = [&](std::size_t i, std::size_t j) {
			if (corners[j] < corners[i]) {
				std::swap(corners[i], corners[j]);
				sign = -sign;
			}
		};
		order(0, 1);
		order(1, 2);
		order(0, 1);
		normal = cross(minus(corners[1], corners[0]), minus(corners[2], corners[0]));
		for (double& component : normal) {
			component *= sign;
		}
	}
};

// The plane through a point with a normal of any length.
NearPlane planeThrough(const Point& origin, const Point& normal) {
	NearPlane plane;
	const double length = std::hypot(normal[0], normal[1], normal[2]);
	if (!(length > 0) || !std::isfinite(length)) {
		return plane;
	}
	plane.origin = origin;
	for (std::size_t i = 0; i < 3; ++i) {
		plane.normal[i] = normal[i] / length;
		if (std::fabs(normal[i]) > std::fabs(normal[static_cast<std::size_t>(plane.axis)])) {
			plane.axis = static_cast<int>(i);
		}
	}
	plane.front = normal[static_cast<std::size_t>(plane.axis)] > 0 ? 1 : -1;
	return plane;
}

class RegionGrower {
public:
	RegionGrower(const ClassedSurface& surface, double reach, int threads, Monitor& monitor,
	             PlaneRegions& out)
	    : surface_(surface), reach_(reach), threads_(threads), monitor_(monitor), out_(out) {}

	Status run();

private:
	static constexpr std::uint32_t kNoFace = kNone;

	Status findNeighbours();
	Status findCandidates();
	void sortSeeds();
	bool isNear(const NearPlane& plane, std::uint32_t vertex) const {
		return std::fabs(plane.height(surface_.points[vertex])) <= reach_;
	}
	bool isNearApex(std::uint32_t face, std::uint32_t other) const;
	bool fits(const NearPlane& plane, std::uint32_t face) const;
	void grow(std::uint32_t seed, const NearPlane& plane, std::vector<std::uint32_t>& region);
	NearPlane fit(std::vector<std::uint32_t>& region) const;
	void growFrom(std::uint32_t seed);

	const ClassedSurface& surface_;
	double reach_;
	int threads_;
	Monitor& monitor_;
	PlaneRegions& out_;
	HugeVector<Point> normals_;             // per face, twice its area long
	HugeVector<std::uint8_t> isCandidate_;  // per face: it or a neighbour is near the other's plane
	std::vector<std::uint32_t> seeds_;      // largest first
	std::vector<std::uint32_t> rank_;       // per face, among the seeds
	std::vector<std::uint32_t> visited_;    // per face: the last growth that has reached it
	std::uint32_t growth_ = 0;
};

Status RegionGrower::findNeighbours() {
	const IndexTriangles& triangles = surface_.triangles;
	out_.neighbours.assign(triangles.size(), {kNoFace, kNoFace, kNoFace});
	EdgeBuckets edges;
	const auto visitHalfEdges = [&](std::size_t f, const auto& visit) {
		const IndexTriangle& t = triangles[f];
		for (std::size_t i = 0; i < 3; ++i) {
			visit(makeHalfEdge(surface_.place[t[i]], surface_.place[t[i == 2 ? 0 : i + 1]], f, i));
		}
	};
	const auto join = [&](std::size_t, const EdgeSide* first, const EdgeSide* last) {
		if (last - first == 2 && first[0].forward != first[1].forward &&
		    surface_.faceClass[first[0].face] == surface_.faceClass[first[1].face]) {
			const IndexTriangle &s = triangles[first[0].face], &t = triangles[first[1].face];
			if (s[first[0].corner] == t[(first[1].corner + 1) % 3] &&
			    t[first[1].corner] == s[(first[0].corner + 1) % 3]) {
				out_.neighbours[first[0].face][first[0].corner] = first[1].face;
				out_.neighbours[first[1].face][first[1].corner] = first[0].face;
			}
		}
	};
	return inOrder(
	    [&] {
		    return edges.list(triangles.size(), surface_.points.size(), visitHalfEdges, monitor_);
	    },
	    [&] { return edges.forEachEdge(threads_, monitor_, join); });
}

// Whether all corners of one face are near the plane of another one that it is joined to: those
// that it does not have are. Twice the reach: the plane that is fitted in the end may lie between.
bool RegionGrower::isNearApex(std::uint32_t face, std::uint32_t other) const {
	const Point& normal = normals_[other];
	const Point& origin = surface_.points[surface_.triangles[other][0]];
	const double length = std::sqrt(dot(normal, normal));
	const IndexTriangle& t = surface_.triangles[face];
	return std::all_of(t.begin(), t.end(), [&](std::uint32_t v) {
		const Point d = minus(surface_.points[v], origin);
		const double height = normal[0] * d[0] + normal[1] * d[1] + normal[2] * d[2];
		return std::fabs(height) <= 2 * reach_ * length;
	});
}

Status RegionGrower::findCandidates() {
	const std::size_t n = surface_.triangles.size();
	normals_.resizeForOverwrite(n);
	isCandidate_.assign(n, 0);
	const auto findNormals = [&](std::size_t begin, std::size_t end) {
		for (std::size_t f = begin; f < end; ++f) {
			normals_[f] = SortedFace(surface_.points, surface_.triangles[f]).normal;
		}
	};
	const auto find = [&](std::size_t begin, std::size_t end) {
		for (std::size_t f = begin; f < end; ++f) {
			const auto face = static_cast<std::uint32_t>(f);
			const IndexTriangle& others = out_.neighbours[f];
			const auto isNearOther = [&](std::uint32_t other) {
				return other != kNoFace && (isNearApex(face, other) || isNearApex(other, face));
			};
			isCandidate_[f] = std::any_of(others.begin(), others.end(), isNearOther) ? 1 : 0;
		}
	};
	return inOrder([&] { return parallelFor(n, kGrain, threads_, monitor_, findNormals); },
	               [&] { return parallelFor(n, kGrain, threads_, monitor_, find); });
}

void RegionGrower::sortSeeds() {
	struct Seed {
		double squaredArea;
		std::array<Point, 3> corners;
		std::uint32_t face;
	};
	std::vector<Seed> seeds;
	for (std::uint32_t f = 0; f < isCandidate_.size(); ++f) {
		if (isCandidate_[f] != 0) {
			const SortedFace sorted(surface_.points, surface_.triangles[f]);
			seeds.push_back({dot(normals_[f], normals_[f]), sorted.corners, f});
		}
	}
	std::sort(seeds.begin(), seeds.end(), [](const Seed& a, const Seed& b) {
		return a.squaredArea != b.squaredArea ? a.squaredArea > b.squaredArea
		                                      : a.corners < b.corners;
	});
	rank_.assign(isCandidate_.size(), kNone);
	for (const Seed& seed : seeds) {
		rank_[seed.face] = static_cast<std::uint32_t>(seeds_.size());
		seeds_.push_back(seed.face);
	}
}

bool RegionGrower::fits(const NearPlane& plane, std::uint32_t face) const {
	const IndexTriangle& t = surface_.triangles[face];
	const Points& points = surface_.points;
	return isNear(plane, t[0]) && isNear(plane, t[1]) && isNear(plane, t[2]) &&
	       (plane.front * orient2d(points[t[0]], points[t[1]], points[t[2]], plane.axis) > 0 ||
	        sizeOfFace(points, t).leastHeight <= reach_);
}

// All faces that a seed reaches near a plane. Those of other regions are no way.
void RegionGrower::grow(std::uint32_t seed, const NearPlane& plane,
                        std::vector<std::uint32_t>& region) {
	region.clear();
	if (plane.front == 0 || !fits(plane, seed)) {
		return;
	}
	visited_[seed] = ++growth_;
	region.push_back(seed);
	for (std::size_t i = 0; i < region.size(); ++i) {
		for (const std::uint32_t next : out_.neighbours[region[i]]) {
			if (next != kNoFace && visited_[next] != growth_ && isCandidate_[next] != 0 &&
			    out_.ofFace[next] == kNone && fits(plane, next)) {
				visited_[next] = growth_;
				region.push_back(next);
			}
		}
	}
}

// The plane in the middle of a region, which it sorts.
NearPlane RegionGrower::fit(std::vector<std::uint32_t>& region) const {
	std::sort(region.begin(), region.end(),
	          [this](std::uint32_t a, std::uint32_t b) { return rank_[a] < rank_[b]; });
	Point sum{};
	for (const std::uint32_t face : region) {
		for (std::size_t i = 0; i < 3; ++i) {
			sum[i] += normals_[face][i];
		}
	}
	NearPlane plane = planeThrough(
	    SortedFace(surface_.points, surface_.triangles[region.front()]).corners[0], sum);
	double low = 0, high = 0;
	for (const std::uint32_t face : region) {
		for (const std::uint32_t v : surface_.triangles[face]) {
			low = std::min(low, plane.height(surface_.points[v]));
			high = std::max(high, plane.height(surface_.points[v]));
		}
	}
	for (std::size_t i = 0; i < 3; ++i) {
		plane.origin[i] += (low + high) / 2 * plane.normal[i];
	}
	return plane;
}

void RegionGrower::growFrom(std::uint32_t seed) {
	std::vector<std::uint32_t> region, wider;
	NearPlane plane = planeOfFace(surface_.points, surface_.triangles[seed]);
	grow(seed, plane, region);
	for (int i = 0; i < kMostFits && region.size() > 1; ++i) {
		const NearPlane fitted = fit(region);
		grow(seed, fitted, wider);
		if (wider.size() < region.size()) {
			break;
		}
		plane = fitted;
		region.swap(wider);
		if (region.size() == wider.size()) {
			break;
		}
	}
	if (region.size() > 1) {
		for (const std::uint32_t face : region) {
			out_.ofFace[face] = static_cast<std::uint32_t>(out_.planes.size());
		}
		out_.planes.push_back(plane);
	}
}

Status RegionGrower::run() {
	const std::size_t n = surface_.triangles.size();
	out_.ofFace.assign(n, kNone);
	visited_.assign(n, 0);
	const Status status =
	    inOrder([this] { return findNeighbours(); }, [this] { return findCandidates(); },
	            [this] {
		            sortSeeds();
		            return inOrderFor(seeds_.size(), kGrain, monitor_,
		                              [this](std::size_t begin, std::size_t end) {
			                              for (std::size_t i = begin; i < end; ++i) {
				                              if (out_.ofFace[seeds_[i]] == kNone) {
					                              growFrom(seeds_[i]);
				                              }
			                              }
		                              });
	            });
	for (std::uint32_t f = 0; f < n; ++f) {
		if (out_.ofFace[f] == kNone) {
			out_.ofFace[f] = static_cast<std::uint32_t>(out_.planes.size()) + f;
		}
	}
	return status;
}

}  // namespace

NearPlane planeOfFace(const Points& points, const IndexTriangle& face) {
	const SortedFace sorted(points, face);
	return planeThrough(sorted.corners[0], sorted.normal);
}

FaceSize sizeOfFace(const Points& points, const IndexTriangle& face) {
	const SortedFace sorted(points, face);
	const double longest = std::max({squaredDistance(sorted.corners[0], sorted.corners[1]),
	                                 squaredDistance(sorted.corners[1], sorted.corners[2]),
	                                 squaredDistance(sorted.corners[0], sorted.corners[2])});
	const double area = dot(sorted.normal, sorted.normal);
	return {area, longest > 0 ? std::sqrt(area / longest) : 0};
}

Status findPlaneRegions(const ClassedSurface& surface, double reach, int threads, Monitor& monitor,
                        PlaneRegions& out) {
	out = {};
	return RegionGrower(surface, reach, threads, monitor, out).run();
}

}  // namespace index_boolean
