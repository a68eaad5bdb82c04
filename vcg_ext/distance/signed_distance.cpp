// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points are asked in an order in which neighbours follow each other: each begins with the face
// that was nearest to the one before, and looks for a ball that its sign is known from.
#include "vcg_ext/distance/signed_distance.h"

#include "vcg_ext/base/bucket_sort.h"
#include "vcg_ext/base/morton.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/distance/face_tree_builder.h"
#include "vcg_ext/distance/unit_normal.h"
#include "vcg_ext/exact/exact_sign.h"
#include "vcg_ext/parts/sub_blocks.h"

#include <algorithm>
#include <cmath>
#include <new>

namespace index_boolean {

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kRelativeError = 0x1p-45;  // of a distance and the longest edge; see face_block.h

bool isFinite(const Point& p) {
	return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

bool isOutside(const BoundingBox& box, const Point& p) {
	return p[0] < box.lo[0] || p[0] > box.hi[0] || p[1] < box.lo[1] || p[1] > box.hi[1] ||
	       p[2] < box.lo[2] || p[2] > box.hi[2];
}

double lengthOf(const Point& v) {
	const double squared = dot(v, v);
	const bool isSafe = squared > 0x1p-900 && squared < 0x1p900;
	return isSafe ? std::sqrt(squared) : std::hypot(v[0], v[1], v[2]);
}

// A point in the tree's scale, where no coordinate of the surface exceeds R = 2. From farther away
// than D = 2^26, the point at that distance in the same direction is taken. What is nearest to it
// is nearest to the true one, but for R^2 / D: that is below 2^-50 of the distance.
Point inScale(const TreeFrame& frame, const Point& p, bool& isFar) {
	constexpr int kFar = 26;
	const double largest = std::max({std::fabs(p[0]), std::fabs(p[1]), std::fabs(p[2])});
	isFar = largest * frame.scale > std::ldexp(1.0, kFar);
	if (!isFar) {
		return frame.scaled(p);
	}
	const int exponent = kFar - std::ilogb(largest);
	return {std::scalbn(p[0], exponent), std::scalbn(p[1], exponent), std::scalbn(p[2], exponent)};
}

// Between two places; exact at its ends.
Point placeOn(const Point& a, const Point& b, double t) {
	Point p;
	for (std::size_t k = 0; k < 3; ++k) {
		p[k] = t <= 0 ? a[k] : t >= 1 ? b[k] : a[k] * (1 - t) + b[k] * t;
	}
	return p;
}

// Orders points along a curve that fills space. Those that are not finite come first.
Status orderPoints(const DistanceQuery& query, int threads, Monitor& monitor,
                   std::vector<std::uint64_t>& out) {
	constexpr std::size_t kGrain = 1 << 14;
	constexpr unsigned kBits = 10;
	BoundingBox box{};
	Status status = findBoundingBox(query.points, query.count, threads, monitor, box);
	const Point centre = box.centre();
	const double half = box.halfSize();
	out.resize(query.count);
	const auto setCodes = [&](std::size_t begin, std::size_t end) {
		for (std::size_t i = begin; i < end; ++i) {
			std::uint32_t code = 0;
			for (unsigned axis = 0; axis < 3 && isFinite(query.points[i]) && half > 0; ++axis) {
				const double place = (query.points[i][axis] / 2 - centre[axis] / 2) / half + 0.5;
				const double cell = std::clamp(place, 0.0, 1.0) * ((1U << kBits) - 1);
				code |= spreadBits(static_cast<std::uint32_t>(cell)) << axis;
			}
			out[i] = std::uint64_t{code} << 32U | i;
		}
	};
	return inOrder([&] { return status; },
	               [&] { return parallelFor(query.count, kGrain, threads, monitor, setCodes); },
	               [&] {
		               return bucketSort(
		                   out, std::size_t{1} << 3 * kBits,
		                   [](std::uint64_t item) { return item >> 32U; }, std::less<>(), threads,
		                   monitor);
	               });
}

}  // namespace

// What the points before one leave behind.
struct SignedDistance::Trail {
	// No surface is in it.
	struct Ball {
		Point centre;  // in the tree's scale
		double radius;
		int sign;
	};
	static constexpr std::size_t kBalls = 8;

	NearFace last;
	std::array<Ball, kBalls> balls{};
	std::size_t count = 0;

	void add(const Ball& ball) { balls[count++ % kBalls] = ball; }

	// The sign of a ball that reaches the centre of another one, or the other way round; 0 if there
	// is none. The factor is more than all roundings.
	int signFor(const Point& centre, double radius) const {
		for (std::size_t i = 0; i < std::min(count, kBalls); ++i) {
			const double reach = std::max(balls[i].radius, radius);
			const Point between = minus(balls[i].centre, centre);
			if (dot(between, between) < reach * reach * (1 - 0x1p-40)) {
				return balls[i].sign;
			}
		}
		return 0;
	}
};

Status SignedDistance::build(Reference reference, int threads, Monitor& monitor) {
	reference_ = std::move(reference);
	if (reference_.triangles.empty()) {
		return statusOf(StatusCode::EmptyOperand);
	}
	try {
		return inOrder(
		    [&] { return tree_.build(reference_.points, reference_.triangles, threads, monitor); },
		    [&] {
			    return findBoundingBox(reference_.points.data(), reference_.points.size(), threads,
			                           monitor, box_);
		    });
	} catch (const std::bad_alloc&) {
		return statusOf(StatusCode::OutOfMemory);
	}
}

double SignedDistance::errorBound(double distance) const {
	return kRelativeError * (std::fabs(distance) + tree_.frame().longestEdge / tree_.frame().scale);
}

int SignedDistance::windingSign(const Point& point) const {
	return isInside(reference_.rule, windingAround(searched(), point)) ? -1 : 1;
}

FeatureVertices SignedDistance::verticesOf(std::uint32_t face, Feature feature) const {
	const std::array<std::uint32_t, 3> v =
	    verticesByShape(reference_.points, reference_.triangles[face], tree_.frame());
	switch (feature) {
	case Feature::Face:
		break;
	case Feature::First:
		return {{v[0], v[1], 0}, 2};
	case Feature::Second:
		return {{v[0], v[2], 0}, 2};
	case Feature::Third:
		return {{v[1], v[2], 0}, 2};
	case Feature::Origin:
		return {{v[0], 0, 0}, 1};
	case Feature::FirstEnd:
		return {{v[1], 0, 0}, 1};
	case Feature::SecondEnd:
		return {{v[2], 0, 0}, 1};
	}
	return {v, 3};
}

// The side of the nearest feature, of a surface that need not be closed.
int SignedDistance::sideOfFeature(const Point& point, const NearestInFace& nearest,
                                  const NearFace& near) const {
	const std::uint32_t face = tree_.faceOf(near);
	if (nearest.feature == Feature::Face) {
		const IndexTriangle& t = reference_.triangles[face];
		const Points& p = reference_.points;
		return orient3d(p[t[0]], p[t[1]], p[t[2]], point) < 0 ? -1 : 1;
	}
	const Point normal = pseudonormal(searched(), face, verticesOf(face, nearest.feature));
	return dot(normal, unitVector(nearest.offset)) < 0 ? -1 : 1;
}

// \param distance in the tree's scale
int SignedDistance::signAt(const Point& point, const NearestInFace& nearest, const NearFace& near,
                           double distance, Trail& trail) const {
	const double bound = kRelativeError * (distance + tree_.frame().longestEdge);
	if (distance <= bound && liesOnSurface(searched(), point)) {
		return 0;
	}
	if (!reference_.isSigned) {
		return 1;
	}
	if (!reference_.isClosed) {
		return sideOfFeature(point, nearest, near);
	}
	if (isOutside(box_, point)) {
		return 1;
	}
	const Point scaled = tree_.frame().scaled(point);
	const double radius = distance - bound;
	int sign = radius > 0 ? trail.signFor(scaled, radius) : 0;
	if (sign == 0) {
		sign = windingSign(point);
	}
	if (radius > 0) {
		trail.add({scaled, radius, sign});
	}
	return sign;
}

Point SignedDistance::closestPoint(const Point& scaled, const NearestInFace& nearest,
                                   const FeatureVertices& feature) const {
	const Points& p = reference_.points;
	const Point& corner = p[feature.vertex[0]];
	if (feature.count == 1) {
		return corner;
	}
	if (feature.count == 2) {
		return placeOn(corner, p[feature.vertex[1]], nearest.along);
	}
	const Point local = minus(scaled, tree_.frame().scaled(corner));
	Point closest;
	for (std::size_t k = 0; k < 3; ++k) {
		const auto [low, high] =
		    std::minmax({corner[k], p[feature.vertex[1]][k], p[feature.vertex[2]][k]});
		closest[k] =
		    std::clamp(corner[k] + (local[k] - nearest.offset[k]) / tree_.frame().scale, low, high);
	}
	return closest;
}

DistanceSample SignedDistance::sampleAt(const Point& point, const DistanceOptions& options,
                                        Trail& trail) const {
	DistanceSample sample;
	sample.closest = sample.gradient = {kNaN, kNaN, kNaN};
	if (!isFinite(point)) {
		return sample;
	}
	const TreeFrame& frame = tree_.frame();
	bool isFar = false;
	const Point scaled = inScale(frame, point, isFar);
	// Of an open surface the nearest feature has the sign, however far it is.
	const bool isBounded = !isFar && (reference_.isClosed || !reference_.isSigned);
	const double most = isBounded ? options.maximum * frame.scale * (1 + 0x1p-40)
	                              : std::numeric_limits<double>::infinity();
	NearFace begin{most * most, kNone, 0};
	if (trail.last.isFound()) {
		const NearFace again = tree_.distanceTo(trail.last, scaled);
		begin = again.squared <= begin.squared ? again : begin;
	}
	const NearFace near = tree_.nearest(scaled, begin);
	if (!near.isFound()) {
		sample.sign = signAt(point, {}, near, most * (1 - 0x1p-39), trail);
		return sample;
	}
	trail.last = near;
	NearestInFace nearest = tree_.nearestIn(near, scaled);
	const std::uint32_t face = tree_.faceOf(near);
	const FeatureVertices feature = verticesOf(face, nearest.feature);
	const Point closest = closestPoint(scaled, nearest, feature);
	const double inTree =
	    near.squared > 0x1p-900 ? std::sqrt(near.squared) : lengthOf(nearest.offset);
	double distance = inTree / frame.scale;
	if (isFar) {
		nearest.offset = minus(times(point, 0.5), times(closest, 0.5));
		distance = 2 * lengthOf(nearest.offset);
	}
	sample.sign = signAt(point, nearest, near, inTree, trail);
	if (distance > options.maximum) {
		return sample;
	}
	constexpr double kLeast = std::numeric_limits<double>::min();
	sample.distance = sample.sign * std::max(distance, kLeast);
	sample.face = reference_.faceGiven[face];
	sample.closest = closest;
	const bool isNear = sample.sign == 0 || distance <= errorBound(distance);
	sample.gradient = isNear ? pseudonormal(searched(), face, feature)
	                         : times(unitVector(nearest.offset), sample.sign);
	if (options.negate) {
		sample.distance = 0 - sample.distance;  // which is no negative zero
		sample.gradient = times(sample.gradient, -1);
	}
	return sample;
}

DistanceSample SignedDistance::at(const Point& point, const DistanceOptions& options) const {
	const FpEnvironmentGuard environment;
	Trail trail;
	return sampleAt(point, options, trail);
}

Status SignedDistance::sample(const DistanceQuery& query, const DistanceOptions& options,
                              int threads, Monitor& monitor) const {
	constexpr std::size_t kGrain = 1 << 9, kBetweenPolls = 8;
	try {
		const FpEnvironmentGuard environment;
		std::vector<std::uint64_t> order;
		const auto sampleSome = [&](std::size_t begin, std::size_t end) {
			Trail trail;
			for (std::size_t i = begin; i < end; ++i) {
				if (i % kBetweenPolls == 0 && pollCancelled(monitor)) {
					return;
				}
				const auto at = static_cast<std::uint32_t>(order[i]);
				query.samples[at] = sampleAt(query.points[at], options, trail);
			}
		};
		Status status =
		    inOrder([&] { return orderPoints(query, threads, monitor, order); },
		            [&] { return parallelFor(query.count, kGrain, threads, monitor, sampleSome); });
		if (status.ok() && monitor.cancelled()) {
			status.code = StatusCode::Cancelled;
		}
		return status;
	} catch (const std::bad_alloc&) {
		return statusOf(StatusCode::OutOfMemory);
	}
}

}  // namespace index_boolean
