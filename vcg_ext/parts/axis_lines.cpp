// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every question is the sign of a polynomial in e and in the turn t: what is asked of the line's
// place is linear in it, so its coefficients are the same question asked of p0, p1 and p2; what is
// asked of the direction (1, t, t^2) is linear in that, so they are the same question asked along
// the three axes. The sign is that of the first coefficient that is not zero, with the powers of e
// within those of t. All are zero only where
//  - an edge lies on one line with p0, p1 and p2, which are not collinear: so never;
//  - a normal is zero: so never;
//  - both planes are one: D_b(p) n_a = D_a(p) n_b at three points p that are not collinear means
//    that one plane's equation is a multiple of the other's, or that both planes are that of p0,
//    p1, p2.
#include "vcg_ext/parts/axis_lines.h"

#include <cmath>

namespace index_boolean {

namespace {

// The first answer that is not 0 of ask(point, axis) at the points near the line's place, first
// along its axis, then along the others.
template <class Ask>
int firstSign(const AxisLine& line, Ask&& ask) {
	for (const int axis : {line.axis, nextCorner(line.axis), previousCorner(line.axis)}) {
		for (const ExactPoint& point : line.near) {
			if (const int sign = ask(point, axis); sign != 0) {
				return sign;
			}
		}
	}
	return 0;
}

// The side of the edge from a to b on which a line passes: +1 to its left as seen against the line.
int sideOfEdge(const ExactPoint& a, const ExactPoint& b, const AxisLine& line) {
	return firstSign(line, [&](const ExactPoint& p, int axis) { return orient2d(a, b, p, axis); });
}

}  // namespace

AxisLine lineFrom(const Point& place, int axis, std::array<Point, 2>& moved) {
	moved = {place, place};
	const std::array<int, 2> others{nextCorner(axis), previousCorner(axis)};
	for (std::size_t i = 0; i < 2; ++i) {
		double& coordinate = moved[i][static_cast<std::size_t>(others[i])];
		coordinate = std::nextafter(coordinate, coordinate > 0 ? -HUGE_VAL : HUGE_VAL);
	}
	return {axis,
	        {ExactPoint::explicitPoint(place), ExactPoint::explicitPoint(moved[0]),
	         ExactPoint::explicitPoint(moved[1])}};
}

int meets(const std::array<ExactPoint, 3>& corners, const AxisLine& line) {
	const int side = sideOfEdge(corners[0], corners[1], line);
	const bool inside = sideOfEdge(corners[1], corners[2], line) == side &&
	                    sideOfEdge(corners[2], corners[0], line) == side;
	return inside ? side : 0;
}

int sideOfPlane(const PlaneCorners& plane, const AxisLine& line) {
	for (const ExactPoint& point : line.near) {
		if (const int side = orient3d(plane, point); side != 0) {
			return side;
		}
	}
	return 0;
}

int compareAlong(const FaceOnLine& a, const FaceOnLine& b, const AxisLine& line) {
	const int order = firstSign(
	    line, [&](const ExactPoint& p, int axis) { return planeOrder(a.plane, b.plane, p, axis); });
	return order * a.facing * b.facing;
}

LineField::LineField(int axis, const Points& begins) : axis_(axis) {
	std::vector<BoundingBox> boxes;
	boxes.reserve(begins.size());
	for (const Point& begin : begins) {
		boxes.push_back({begin, begin});
	}
	begins_ = BoxTree(std::move(boxes));
}

bool LineField::anyBelow(const BoundingBox& face) const {
	bool found = false;
	const auto enters = [&](const BoundingBox& begins) {
		return !found && mayMeet(axis_, begins, face);
	};
	begins_.visit(axis_, enters, [&found](std::uint32_t) { found = true; });
	return found;
}

}  // namespace index_boolean
