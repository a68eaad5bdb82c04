// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From each query a line goes upwards. What lies above it is counted: +1 for a face that is met
// from behind, -1 for one that is met in front. Counts alone are kept.
#include "vcg_ext/solids/winding_rays.h"

#include "vcg_ext/base/parallel.h"
#include "vcg_ext/parts/axis_lines.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace index_boolean {

namespace {

constexpr std::size_t kGrain = 1 << 14;

using Ignored = std::function<bool(std::size_t query, FaceId face)>;

// Sums of numbers do not depend on the order in which threads add them.
struct Count {
	std::atomic<int> above{0};     // of faces above the query
	std::atomic<int> at{0};        // of faces that it lies on
	std::atomic<bool> any{false};  // it lies on a face
};

// All queries with the lines upwards from them.
class Rays {
public:
	Rays(const MeshArrays& mesh, OperandId operand, const Ignored& ignored,
	     std::vector<WindingQuery>& queries);

	// Adds what one face does to any query.
	void shoot(FaceId face);
	// Writes the answers.
	void finish();

private:
	int cheapestAxis(OperandId operand) const;
	AxisLine lineOf(const WindingQuery& query);
	const Point& beginOf(const WindingQuery& query) const {
		return at(mesh_.points, query.from != VertexId::none()
		                            ? query.from
		                            : at(mesh_.triangles, query.inside)[0]);
	}
	PlaneCorners planeOf(FaceId face) const {
		const Triangle& t = at(mesh_.triangles, face);
		return {&at(mesh_.points, t[0]), &at(mesh_.points, t[1]), &at(mesh_.points, t[2])};
	}
	static std::array<ExactPoint, 3> cornersOf(const PlaneCorners& p) {
		return {ExactPoint::explicitPoint(*p[0]), ExactPoint::explicitPoint(*p[1]),
		        ExactPoint::explicitPoint(*p[2])};
	}

	const MeshArrays& mesh_;
	const Ignored& ignored_;
	std::vector<WindingQuery>& queries_;
	int axis_;
	Points moved_;  // where vertices' lines are moved to
	std::vector<AxisLine> lines_;
	LineField field_;
	std::vector<Count> counts_;
};

Rays::Rays(const MeshArrays& mesh, OperandId operand, const Ignored& ignored,
           std::vector<WindingQuery>& queries)
    : mesh_(mesh), ignored_(ignored), queries_(queries), axis_(cheapestAxis(operand)),
      counts_(queries.size()) {
	Points begins;
	moved_.reserve(2 * queries.size());
	for (const WindingQuery& query : queries) {
		lines_.push_back(lineOf(query));
		begins.push_back(beginOf(query));
	}
	field_ = LineField(axis_, begins);
}

// The axis along which a few of the faces lie above the fewest queries, so far as boxes tell.
int Rays::cheapestAxis(OperandId operand) const {
	constexpr std::size_t kSamples = 64;
	const std::size_t first = mesh_.faceOffsets.begin(operand);
	const std::size_t count = mesh_.faceOffsets.size(operand);
	const std::size_t step = count / kSamples + 1;
	std::array<std::size_t, 3> cost{};
	for (std::size_t f = first; f < first + count; f += step) {
		const PlaneCorners plane = planeOf(makeId<FaceTag>(f));
		const BoundingBox box = boxOfThree(*plane[0], *plane[1], *plane[2]);
		for (const WindingQuery& query : queries_) {
			const BoundingBox begin{beginOf(query), beginOf(query)};
			for (int axis = 0; axis < 3; ++axis) {
				cost[static_cast<std::size_t>(axis)] += mayMeet(axis, begin, box) ? 1 : 0;
			}
		}
	}
	return static_cast<int>(std::min_element(cost.begin(), cost.end()) - cost.begin());
}

// A line from a vertex is moved away from it along the two other axes.
AxisLine Rays::lineOf(const WindingQuery& query) {
	if (query.from == VertexId::none()) {
		return {axis_, cornersOf(planeOf(query.inside))};
	}
	const Point& vertex = at(mesh_.points, query.from);
	for (const int axis : {nextCorner(axis_), previousCorner(axis_)}) {
		moved_.push_back(vertex);
		double& coordinate = moved_.back()[static_cast<std::size_t>(axis)];
		coordinate = std::nextafter(coordinate, coordinate > 0 ? -HUGE_VAL : HUGE_VAL);
	}
	return {axis_, cornersOf({&vertex, &moved_[moved_.size() - 2], &moved_.back()})};
}

void Rays::shoot(FaceId face) {
	const PlaneCorners plane = planeOf(face);
	const auto hit = [&](std::uint32_t query) {
		if (ignored_ && ignored_(query, face)) {
			return;
		}
		const AxisLine& line = lines_[query];
		const int facing = meets(cornersOf(plane), line);
		if (facing == 0) {
			return;
		}
		Count& count = counts_[query];
		const int side = sideOfPlane(plane, line);
		if (side == 0) {
			count.at.fetch_add(facing, std::memory_order_relaxed);
			count.any.store(true, std::memory_order_relaxed);
		} else if (side != facing) {
			count.above.fetch_add(facing, std::memory_order_relaxed);
		}
	};
	field_.forEachBelow(boxOfThree(*plane[0], *plane[1], *plane[2]), hit);
}

void Rays::finish() {
	for (std::size_t q = 0; q < queries_.size(); ++q) {
		const int above = counts_[q].above, below = above + counts_[q].at;
		const bool upwards = queries_[q].from != VertexId::none() ||
		                     meets(cornersOf(planeOf(queries_[q].inside)), lines_[q]) > 0;
		queries_[q].inFront = upwards ? above : below;
		queries_[q].behind = upwards ? below : above;
		queries_[q].onSurface = counts_[q].any;
	}
}

}  // namespace

Status findWindings(const MeshArrays& mesh, OperandId operand, const Ignored& ignored, int threads,
                    Monitor& monitor, std::vector<WindingQuery>& queries) {
	if (queries.empty()) {
		return {};
	}
	Rays rays(mesh, operand, ignored, queries);
	const std::size_t first = mesh.faceOffsets.begin(operand);
	const auto shoot = [&rays, first](std::size_t begin, std::size_t end) {
		for (std::size_t f = first + begin; f < first + end; ++f) {
			rays.shoot(makeId<FaceTag>(f));
		}
	};
	const Status status =
	    parallelFor(mesh.faceOffsets.size(operand), kGrain, threads, monitor, shoot);
	rays.finish();
	return status;
}

}  // namespace index_boolean
