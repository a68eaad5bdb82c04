// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: places from which lines run upwards along an axis; out: which triangles they meet, which way
// these face, and in which order.
// Guarantee: exact, whatever the places are: a line never meets an edge or a corner, and never runs
// within a face.
#pragma once

#include "vcg_ext/exact/box_tree.h"
#include "vcg_ext/exact/exact_sign.h"

#include <algorithm>

namespace index_boolean {

// A line upwards from a place that is infinitely near to the first of three points, which are not
// collinear, within their triangle: p0 + e (p1 - p0) + e^2 (p2 - p0) with an infinitely small e >
// 0. It runs along the axis but for a turn, infinitely small against e, towards the next axis and,
// even less, the one after. Borrows what the points borrow.
struct AxisLine {
	int axis;
	std::array<ExactPoint, 3> near;
};

// A line upwards along an axis from a place, which is moved along the two other axes.
// \param moved written: two places beside it, which the line borrows as it does the first
// Complexity: O(1).
AxisLine lineFrom(const Point& place, int axis, std::array<Point, 2>& moved);

// The three corners of an input face, which stand for its plane.
using PlaneCorners = std::array<const Point*, 3>;

// The way in which a line passes a triangle: +1 if that faces up, -1 if down, 0 if it misses it.
// Complexity: O(1), mostly three orientations.
int meets(const std::array<ExactPoint, 3>& corners, const AxisLine& line);

// The side of a plane on which a line's place lies, as orient3d; 0 if its three points lie on it.
// Complexity: O(1), mostly one orientation.
int sideOfPlane(const PlaneCorners& plane, const AxisLine& line);

// A face that a line meets.
struct FaceOnLine {
	PlaneCorners plane;
	int facing;  // as meets tells
};

// Which of two faces a line meets first: -1, +1; 0 if both lie in one plane. Complexity: O(1).
int compareAlong(const FaceOnLine& a, const FaceOnLine& b, const AxisLine& line);

// Whether lines along an axis that begin in one box may meet what lies in another.
inline bool mayMeet(int axis, const BoundingBox& begins, const BoundingBox& faces) {
	const auto up = static_cast<std::size_t>(axis);
	const auto u = static_cast<std::size_t>(nextCorner(axis));
	const auto v = static_cast<std::size_t>(previousCorner(axis));
	return begins.lo[u] <= faces.hi[u] && begins.hi[u] >= faces.lo[u] &&
	       begins.lo[v] <= faces.hi[v] && begins.hi[v] >= faces.lo[v] &&
	       begins.lo[up] <= faces.hi[up];
}

// Lines along one axis by where they begin, as rounded.
class LineField {
public:
	LineField() = default;
	// \param begins the rounded first point of each line
	LineField(int axis, const Points& begins);

	// Calls visit(i) for each line that may meet a face. Complexity: O(sqrt(l) + lines visited).
	template <class Visit>
	void forEachBelow(const BoundingBox& face, Visit&& visit) const {
		begins_.visit(
		    axis_, [&](const BoundingBox& begins) { return mayMeet(axis_, begins, face); }, visit);
	}
	// Whether there is one.
	bool anyBelow(const BoundingBox& face) const;

private:
	int axis_ = 0;
	BoxTree begins_;
};

// The box of three points as rounded. Rounding keeps order: it holds every line that passes them.
inline BoundingBox boxOfThree(const Point& a, const Point& b, const Point& c) {
	BoundingBox box{a, a};
	for (std::size_t k = 0; k < 3; ++k) {
		box.lo[k] = std::min({a[k], b[k], c[k]});
		box.hi[k] = std::max({a[k], b[k], c[k]});
	}
	return box;
}

}  // namespace index_boolean
