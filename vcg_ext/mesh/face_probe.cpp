// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/mesh/face_probe.h"

#include "vcg_ext/base/vectors.h"

#include <algorithm>
#include <cmath>

namespace index_boolean {

double distanceToTriangle(const Point& p, const std::array<Point, 3>& t) {
	const Point u = minus(t[1], t[0]), v = minus(t[2], t[0]), w = minus(p, t[0]);
	const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), uw = dot(u, w), vw = dot(v, w);
	const double size = uu * vv - uv * uv;
	const double s = uw * vv - vw * uv, r = vw * uu - uw * uv;
	double least = std::sqrt(
	    std::min({squaredDistanceToSegment(p, t[0], t[1]), squaredDistanceToSegment(p, t[1], t[2]),
	              squaredDistanceToSegment(p, t[2], t[0])}));
	if (size > 0 && s >= 0 && r >= 0 && s + r <= size) {
		const Point n = cross(u, v);
		least = std::min(least, std::fabs(dot(n, w)) / std::sqrt(dot(n, n)));
	}
	return least;
}

FaceProbe::FaceProbe(const Points& points, std::vector<IndexTriangle> faces, double reach)
    : points_(points), faces_(std::move(faces)) {
	std::vector<BoundingBox> boxes;
	for (const IndexTriangle& t : faces_) {
		BoundingBox box = emptyBox();
		for (const std::uint32_t v : t) {
			box.add(points_[v]);
		}
		for (std::size_t i = 0; i < 3; ++i) {
			box.lo[i] -= reach;
			box.hi[i] += reach;
		}
		boxes.push_back(box);
	}
	tree_ = BoxTree(std::move(boxes));
}

std::array<Point, 3> FaceProbe::cornersOf(std::uint32_t face) const {
	const IndexTriangle& t = faces_[face];
	return {points_[t[0]], points_[t[1]], points_[t[2]]};
}

template <class Visit>
void FaceProbe::visitNear(const Point& p, Visit&& visit) const {
	tree_.visit(
	    0,
	    [&](const BoundingBox& box) {
		    return !commonBox(box, BoundingBox{p, p}).empty();
	    },
	    visit);
}

double FaceProbe::distanceTo(const Point& p) const {
	double least = HUGE_VAL;
	visitNear(p, [&](std::uint32_t face) {
		least = std::min(least, distanceToTriangle(p, cornersOf(face)));
	});
	return least;
}

bool FaceProbe::isWithin(const Point& a, const Point& b, double length, int depth) const {
	bool isOne = false;
	visitNear(a, [&](std::uint32_t face) {
		const std::array<Point, 3> t = cornersOf(face);
		isOne = isOne || (distanceToTriangle(a, t) <= length && distanceToTriangle(b, t) <= length);
	});
	if (isOne || depth == 0) {
		return isOne;
	}
	const Point middle{(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
	if (middle == a || middle == b) {
		return distanceTo(a) <= length && distanceTo(b) <= length;
	}
	return distanceTo(middle) <= length && isWithin(a, middle, length, depth - 1) &&
	       isWithin(middle, b, length, depth - 1);
}

bool FaceProbe::isSegmentWithin(const Point& a, const Point& b, double length) const {
	constexpr int kMostHalvings = 64;
	return distanceTo(a) <= length && distanceTo(b) <= length &&
	       isWithin(a, b, length, kMostHalvings);
}

}  // namespace index_boolean
