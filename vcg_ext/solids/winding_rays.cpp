// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Each triangle looks for the queries below it: those in its x range by binary search among the
// sorted queries, then by y and z, then by exact signs.
#include "vcg_ext/solids/winding_rays.h"

#include "vcg_ext/base/parallel.h"
#include "vcg_ext/exact/exact_sign.h"

#include <algorithm>

namespace index_boolean {

namespace {

constexpr int kUpwards = 2;  // the rays' axis: z; its projection has x and y

// The side of the line a b on which p lies, seen from above, with p moved by (e, e^2), e > 0
// infinitely small. Zero only if a and b have equal x and y.
template <class AnyPoint>
int sideOfMoved(const Point& a, const Point& b, const AnyPoint& p) {
	const int side = orient2d(a, b, p, kUpwards);
	if (side != 0) {
		return side;
	}
	if (a[1] != b[1]) {
		return a[1] > b[1] ? 1 : -1;  // d/dx of the orientation is a_y - b_y
	}
	return a[0] == b[0] ? 0 : (b[0] > a[0] ? 1 : -1);  // d/dy is b_x - a_x
}

struct Hit {
	int winding = 0;
	bool onSurface = false;
};

// What a triangle adds to the winding number around p.
template <class AnyPoint>
Hit hitBy(const Point& a, const Point& b, const Point& c, const AnyPoint& p) {
	const int turn = sideOfMoved(a, b, p);
	if (turn == 0 || sideOfMoved(b, c, p) != turn || sideOfMoved(c, a, p) != turn) {
		return {};
	}
	const int side = orient3d(a, b, c, p);  // behind an upward face is below it
	return {side * turn < 0 ? turn : 0, side == 0};
}

struct Range {
	double low, high;
};

Range rangeOf(const Point& a, const Point& b, const Point& c, std::size_t axis) {
	return {std::min({a[axis], b[axis], c[axis]}), std::max({a[axis], b[axis], c[axis]})};
}

struct Found {
	std::uint32_t query;
	Hit hit;
};

using Ignored = std::function<bool(std::size_t query, FaceId face)>;

// The queries, those from vertices sorted by x.
class Rays {
public:
	Rays(const MeshArrays& mesh, const Ignored& ignored, const std::vector<RayQuery>& queries)
	    : mesh_(mesh), ignored_(ignored), queries_(queries) {
		for (std::uint32_t q = 0; q < queries.size(); ++q) {
			if (queries[q].from == VertexId::none()) {
				insideFaces_.push_back(q);
			} else {
				byX_.emplace_back(at(mesh.points, queries[q].from)[0], q);
			}
		}
		std::sort(byX_.begin(), byX_.end());
	}

	// Adds what one face does to any query.
	void shoot(FaceId face, std::vector<Found>& found) const {
		const Triangle& t = at(mesh_.triangles, face);
		const Point& a = at(mesh_.points, t[0]);
		const Point& b = at(mesh_.points, t[1]);
		const Point& c = at(mesh_.points, t[2]);
		for (const std::uint32_t query : insideFaces_) {
			if (!isIgnored(query, face)) {
				found.push_back({query, hitBy(a, b, c, meanPoint(queries_[query]))});
			}
		}
		const Range x = rangeOf(a, b, c, 0);
		auto it = std::lower_bound(byX_.begin(), byX_.end(), std::make_pair(x.low, 0u));
		if (it == byX_.end() || it->first > x.high) {
			return;
		}
		const Range y = rangeOf(a, b, c, 1);
		const Range z = rangeOf(a, b, c, 2);
		for (; it != byX_.end() && it->first <= x.high; ++it) {
			const Point& p = at(mesh_.points, queries_[it->second].from);
			if (p[1] >= y.low && p[1] <= y.high && p[2] <= z.high && !isIgnored(it->second, face)) {
				found.push_back({it->second, hitBy(a, b, c, p)});
			}
		}
	}

private:
	bool isIgnored(std::uint32_t query, FaceId face) const {
		return ignored_ && ignored_(query, face);
	}
	MeanPoint meanPoint(const RayQuery& query) const {
		const Triangle& t = at(mesh_.triangles, query.inside);
		return {{&at(mesh_.points, t[0]), &at(mesh_.points, t[1]), &at(mesh_.points, t[2])},
		        query.weights};
	}

	const MeshArrays& mesh_;
	const Ignored& ignored_;
	const std::vector<RayQuery>& queries_;
	std::vector<std::pair<double, std::uint32_t>> byX_;
	std::vector<std::uint32_t> insideFaces_;
};

}  // namespace

Status castRays(const Arrangement& arrangement, OperandId operand, const Ignored& ignored,
                Monitor& monitor, std::vector<RayQuery>& queries) {
	constexpr std::size_t kGrain = 1 << 14;
	if (queries.empty()) {
		return {};
	}
	const MeshArrays& mesh = arrangement.mesh;
	const Rays rays(mesh, ignored, queries);
	const std::size_t first = mesh.faceOffsets.begin(operand);
	const std::size_t count = mesh.faceOffsets.size(operand);
	std::vector<std::vector<Found>> chunks(chunkCount(count, kGrain));
	const Status status =
	    parallelForChunks(count, kGrain, arrangement.options.threads, monitor,
	                      [&](std::size_t chunk, std::size_t begin, std::size_t end) {
		                      for (std::size_t f = first + begin; f < first + end; ++f) {
			                      rays.shoot(makeId<FaceTag>(f), chunks[chunk]);
		                      }
	                      });
	for (const std::vector<Found>& chunk : chunks) {
		for (const Found& found : chunk) {
			queries[found.query].winding += found.hit.winding;
			queries[found.query].onSurface |= found.hit.onSurface;
		}
	}
	return status;
}

}  // namespace index_boolean
