// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From each query a line goes upwards. What lies above it is counted: +1 for a face that is met
// from behind, -1 for one that is met in front. Counts alone are kept.
#include "vcg_ext/parts/winding_rays.h"

#include "vcg_ext/base/parallel.h"
#include "vcg_ext/parts/axis_lines.h"

#include <algorithm>
#include <atomic>

namespace index_boolean {

namespace {

constexpr std::size_t kGrain = 1 << 12;

using Ignored = std::function<bool(std::size_t query, FaceId face)>;

// Sums of numbers do not depend on the order in which threads add them.
struct Count {
	std::atomic<int> above{0};     // of faces above the query
	std::atomic<int> at{0};        // of faces that it lies on
	std::atomic<bool> any{false};  // it lies on a face
};

PlaneCorners planeOf(const MeshArrays& mesh, FaceId face) {
	const Triangle& t = at(mesh.triangles, face);
	return {&at(mesh.points, t[0]), &at(mesh.points, t[1]), &at(mesh.points, t[2])};
}

std::array<ExactPoint, 3> cornersOf(const PlaneCorners& p) {
	return {ExactPoint::explicitPoint(*p[0]), ExactPoint::explicitPoint(*p[1]),
	        ExactPoint::explicitPoint(*p[2])};
}

BoundingBox boxOf(const PlaneCorners& p) { return boxOfThree(*p[0], *p[1], *p[2]); }

// All queries with the lines upwards from them.
class Rays {
public:
	Rays(const MeshArrays& mesh, const Ignored& ignored, std::vector<WindingQuery>& queries)
	    : mesh_(mesh), ignored_(ignored), queries_(queries), counts_(queries.size()) {}

	// Chooses an axis for each query, and draws its line.
	Status draw(OperandId operand, int threads, Monitor& monitor);

	// Adds what one face does to any query.
	void shoot(FaceId face);
	// Writes the answers.
	void finish();

private:
	std::vector<BoundingBox> sampleOf(OperandId operand) const;
	Status chooseAxes(OperandId operand, int threads, Monitor& monitor);
	void drawLines();
	void addLine(const WindingQuery& query, int axis);
	void take(FaceId face, const PlaneCorners& plane, std::uint32_t query);
	const Point& beginOf(const WindingQuery& query) const {
		return query.from != VertexId::none() ? at(mesh_.points, query.from)
		                                      : query.inside[0].rounded;
	}

	const MeshArrays& mesh_;
	const Ignored& ignored_;
	std::vector<WindingQuery>& queries_;
	std::vector<int> axes_;                    // per query
	std::vector<std::array<Point, 2>> moved_;  // where vertices' lines are moved to
	std::vector<AxisLine> lines_;              // per query
	std::array<LineField, 3> fields_;
	std::array<std::vector<std::uint32_t>, 3> queriesOf_;  // per line of each field
	std::vector<Count> counts_;
};

void Rays::drawLines() {
	std::array<Points, 3> begins;
	moved_.reserve(queries_.size());  // the lines borrow them
	lines_.reserve(queries_.size());
	for (std::size_t q = 0; q < queries_.size(); ++q) {
		const auto axis = static_cast<std::size_t>(axes_[q]);
		addLine(queries_[q], axes_[q]);
		queriesOf_[axis].push_back(static_cast<std::uint32_t>(q));
		begins[axis].push_back(beginOf(queries_[q]));
	}
	for (std::size_t axis = 0; axis < 3; ++axis) {
		fields_[axis] = LineField(static_cast<int>(axis), begins[axis]);
	}
}

// The boxes of a few of an operand's faces.
std::vector<BoundingBox> Rays::sampleOf(OperandId operand) const {
	constexpr std::size_t kSamples = 64;
	const std::size_t first = mesh_.faceOffsets.begin(operand);
	const std::size_t count = mesh_.faceOffsets.size(operand);
	std::vector<BoundingBox> boxes;
	for (std::size_t f = 0; f < count; f += count / kSamples + 1) {
		boxes.push_back(boxOf(planeOf(mesh_, makeId<FaceTag>(first + f))));
	}
	return boxes;
}

// Per query the axis along which the fewest of a few faces lie above it, so far as boxes tell,
// unless the axis along which the fewest lie above all queries is about as good: each axis in use
// costs a look at each face.
Status Rays::chooseAxes(OperandId operand, int threads, Monitor& monitor) {
	constexpr std::size_t kWorthAnAxis = 4, kQueries = 256, kFew = 1 << 10;
	if (queries_.size() * mesh_.faceOffsets.size(operand) <= kFew) {
		axes_.assign(queries_.size(), 0);  // done before a choice would be
		return {};
	}
	using PerAxis = std::array<std::size_t, 3>;
	const std::vector<BoundingBox> sample = sampleOf(operand);
	std::vector<PerAxis> above(queries_.size());
	const auto look = [&](std::size_t first, std::size_t last) {
		for (std::size_t q = first; q < last; ++q) {
			const BoundingBox begin{beginOf(queries_[q]), beginOf(queries_[q])};
			for (const BoundingBox& box : sample) {
				for (std::size_t axis = 0; axis < 3; ++axis) {
					above[q][axis] += mayMeet(static_cast<int>(axis), begin, box) ? 1 : 0;
				}
			}
		}
	};
	const Status status = parallelFor(queries_.size(), kQueries, threads, monitor, look);
	PerAxis all{};
	for (const PerAxis& cost : above) {
		for (std::size_t axis = 0; axis < 3; ++axis) {
			all[axis] += cost[axis];
		}
	}
	const auto best = std::min_element(all.begin(), all.end()) - all.begin();
	for (const PerAxis& cost : above) {
		const auto least = std::min_element(cost.begin(), cost.end());
		const bool pays = cost[static_cast<std::size_t>(best)] >= *least + kWorthAnAxis;
		axes_.push_back(static_cast<int>(pays ? least - cost.begin() : best));
	}
	return status;
}

Status Rays::draw(OperandId operand, int threads, Monitor& monitor) {
	const Status status = chooseAxes(operand, threads, monitor);
	if (status.ok()) {
		drawLines();
	}
	return status;
}

// A line from a vertex is moved away from it along the two other axes.
void Rays::addLine(const WindingQuery& query, int axis) {
	if (query.from == VertexId::none()) {
		lines_.push_back({axis, query.inside});
		return;
	}
	moved_.emplace_back();
	lines_.push_back(lineFrom(at(mesh_.points, query.from), axis, moved_.back()));
}

void Rays::take(FaceId face, const PlaneCorners& plane, std::uint32_t query) {
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
}

void Rays::shoot(FaceId face) {
	const PlaneCorners plane = planeOf(mesh_, face);
	const BoundingBox box = boxOf(plane);
	for (std::size_t axis = 0; axis < 3; ++axis) {
		fields_[axis].forEachBelow(
		    box, [&](std::uint32_t line) { take(face, plane, queriesOf_[axis][line]); });
	}
}

void Rays::finish() {
	for (std::size_t q = 0; q < queries_.size(); ++q) {
		const int above = counts_[q].above, below = above + counts_[q].at;
		const bool upwards =
		    queries_[q].from != VertexId::none() || meets(queries_[q].inside, lines_[q]) > 0;
		queries_[q].inFront = upwards ? above : below;
		queries_[q].behind = upwards ? below : above;
		queries_[q].onSurface = counts_[q].any;
	}
}

}  // namespace

WindingQuery queryInside(const MeshArrays& mesh, FaceId face) {
	WindingQuery query;
	query.inside = cornersOf(planeOf(mesh, face));
	return query;
}

Status findWindings(const MeshArrays& mesh, OperandId operand, const Ignored& ignored, int threads,
                    Monitor& monitor, std::vector<WindingQuery>& queries) {
	if (queries.empty()) {
		return {};
	}
	Rays rays(mesh, ignored, queries);
	const std::size_t first = mesh.faceOffsets.begin(operand);
	// With many queries a face takes long, and the monitor is looked at between chunks only.
	const std::size_t grain = std::clamp<std::size_t>((kGrain << 6) / queries.size(), 16, kGrain);
	const auto shoot = [&rays, first](std::size_t begin, std::size_t end) {
		for (std::size_t f = first + begin; f < first + end; ++f) {
			rays.shoot(makeId<FaceTag>(f));
		}
	};
	return inOrder(
	    [&] { return rays.draw(operand, threads, monitor); },
	    [&] { return parallelFor(mesh.faceOffsets.size(operand), grain, threads, monitor, shoot); },
	    [&] {
		    rays.finish();
		    return Status{};
	    });
}

}  // namespace index_boolean
