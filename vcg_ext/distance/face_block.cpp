// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The same arithmetic as of four faces at once, with branches.
#include "vcg_ext/distance/face_block.h"

#include "vcg_ext/distance/unit_normal.h"

namespace index_boolean {

namespace {

Point laneOf(const std::array<FourNumbers, 3>& of, std::size_t lane) {
	return {of[0][lane], of[1][lane], of[2][lane]};
}

// The nearest point of an edge that begins at an offset from the point.
NearestInFace nearestOnEdge(const Point& offset, const Point& edge, double inverse,
                            const std::array<Feature, 3>& startInnerEnd) {
	const double t = placeAlong(dot(offset, edge), inverse);
	const std::size_t which = t > 0 ? (t < 1 ? 1 : 2) : 0;
	return {startInnerEnd[which], minus(offset, times(edge, t)), t};
}

}  // namespace

NearestInFace nearestInFace(const FaceBlock& f, std::size_t lane, const Point& point) {
	const Point q = minus(point, laneOf(f.origin, lane));
	const Point first = laneOf(f.first, lane), second = laneOf(f.second, lane);
	const Point third = minus(second, first), r = minus(q, first);
	const Point normal = laneOf(f.normal, lane);
	if (dot(normal, cross(first, q)) >= 0 && dot(normal, cross(q, second)) >= 0 &&
	    dot(normal, cross(third, r)) >= 0) {
		return {Feature::Face, times(normal, dot(normal, q)), 0};
	}
	NearestInFace nearest = nearestOnEdge(q, first, f.inverse[0][lane],
	                                      {Feature::Origin, Feature::First, Feature::FirstEnd});
	const auto keepNearer = [&nearest](const NearestInFace& other) {
		if (dot(other.offset, other.offset) < dot(nearest.offset, nearest.offset)) {
			nearest = other;
		}
	};
	keepNearer(nearestOnEdge(q, second, f.inverse[1][lane],
	                         {Feature::Origin, Feature::Second, Feature::SecondEnd}));
	keepNearer(nearestOnEdge(r, third, f.inverse[2][lane],
	                         {Feature::FirstEnd, Feature::Third, Feature::SecondEnd}));
	return nearest;
}

}  // namespace index_boolean
