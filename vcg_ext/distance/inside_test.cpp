// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Above a point, a face that is met from behind counts +1, one that is met in front -1. Over all of
// a line they sum up to nothing, so what lies below counts the other way. Nearly always the line
// passes no edge; where orientations tell that it does, it is moved (axis_lines.h).
#include "vcg_ext/distance/inside_test.h"

#include "vcg_ext/parts/axis_lines.h"

#include <algorithm>

namespace index_boolean {

namespace {

// A half of a line along an axis, from a point on.
struct HalfLine {
	int axis;
	bool upwards;
};

// The half of a line that leaves the box soonest.
HalfLine shortestHalfLine(const BoundingBox& box, const Point& p) {
	HalfLine best{0, true};
	double least = std::numeric_limits<double>::infinity();
	for (int axis = 0; axis < 3; ++axis) {
		const auto k = static_cast<std::size_t>(axis);
		for (const bool upwards : {true, false}) {
			const double length = upwards ? box.hi[k] - p[k] : p[k] - box.lo[k];
			if (length < least) {
				least = length;
				best = {axis, upwards};
			}
		}
	}
	return best;
}

using Corners = std::array<const Point*, 3>;

// Whether the line misses the box of a face across itself.
bool passesBeside(const Corners& c, const Point& p, std::size_t axis) {
	const double low = std::min({(*c[0])[axis], (*c[1])[axis], (*c[2])[axis]});
	const double high = std::max({(*c[0])[axis], (*c[1])[axis], (*c[2])[axis]});
	return p[axis] < low || p[axis] > high;
}

// What a face adds to the winding number, by a half-line that is moved off its edges.
int crossingOfMoved(const Corners& corners, const Point& p, HalfLine half) {
	std::array<Point, 2> moved;
	const AxisLine line = lineFrom(p, half.axis, moved);
	const int facing =
	    meets({ExactPoint::explicitPoint(*corners[0]), ExactPoint::explicitPoint(*corners[1]),
	           ExactPoint::explicitPoint(*corners[2])},
	          line);
	if (facing == 0) {
		return 0;
	}
	const bool isAbove = sideOfPlane(corners, line) != facing;
	return isAbove == half.upwards ? facing : 0;
}

int crossing(const Corners& c, const Point& p, HalfLine half) {
	const std::array<int, 3> turns{orient2d(*c[0], *c[1], p, half.axis),
	                               orient2d(*c[1], *c[2], p, half.axis),
	                               orient2d(*c[2], *c[0], p, half.axis)};
	const auto [least, most] = std::minmax({turns[0], turns[1], turns[2]});
	if (least < 0 && most > 0) {
		return 0;
	}
	if (least == 0 || most == 0) {
		return crossingOfMoved(c, p, half);
	}
	const int side = orient3d(*c[0], *c[1], *c[2], p);
	if (side == 0) {
		return crossingOfMoved(c, p, half);
	}
	return (side != turns[0]) == half.upwards ? turns[0] : 0;
}

Corners cornersOf(const SearchedFaces& faces, std::uint32_t face) {
	const IndexTriangle& t = faces.triangles[face];
	return {&faces.points[t[0]], &faces.points[t[1]], &faces.points[t[2]]};
}

}  // namespace

bool liesOnFace(const Point& p, const Point& a, const Point& b, const Point& c) {
	if (orient3d(a, b, c, p) != 0) {
		return false;
	}
	for (int axis = 0; axis < 3; ++axis) {
		const int turn = orient2d(a, b, c, axis);
		if (turn != 0) {
			return orient2d(a, b, p, axis) != -turn && orient2d(b, c, p, axis) != -turn &&
			       orient2d(c, a, p, axis) != -turn;
		}
	}
	return false;
}

bool liesOnSurface(const SearchedFaces& faces, const Point& p) {
	const TreeFrame& frame = faces.tree.frame();
	const Point scaled = frame.scaled(p);
	bool found = false;
	const auto holds = [&](auto&& lo, auto&& hi) {
		for (std::size_t axis = 0; axis < 3; ++axis) {
			const double place = scaled[axis] - frame.centre[axis];
			if (found || place < lo(axis) || place > hi(axis)) {
				return false;
			}
		}
		return true;
	};
	faces.tree.visit(holds, [&](std::uint32_t face) {
		const Corners c = cornersOf(faces, face);
		found = found || (!passesBeside(c, p, 0) && !passesBeside(c, p, 1) &&
		                  !passesBeside(c, p, 2) && liesOnFace(p, *c[0], *c[1], *c[2]));
	});
	return found;
}

int windingAround(const SearchedFaces& faces, const Point& p) {
	const HalfLine half = shortestHalfLine(faces.box, p);
	const auto along = static_cast<std::size_t>(half.axis);
	const auto u = static_cast<std::size_t>(nextCorner(half.axis));
	const auto v = static_cast<std::size_t>(previousCorner(half.axis));
	const TreeFrame& frame = faces.tree.frame();
	const Point scaled = frame.scaled(p);
	const std::array<double, 3> place{scaled[0] - frame.centre[0], scaled[1] - frame.centre[1],
	                                  scaled[2] - frame.centre[2]};
	const auto isOnLine = [&](auto&& lo, auto&& hi) {
		return place[u] >= lo(u) && place[u] <= hi(u) && place[v] >= lo(v) && place[v] <= hi(v) &&
		       (half.upwards ? place[along] <= hi(along) : place[along] >= lo(along));
	};
	int above = 0;
	faces.tree.visit(isOnLine, [&](std::uint32_t face) {
		const Corners c = cornersOf(faces, face);
		if (!passesBeside(c, p, u) && !passesBeside(c, p, v)) {
			above += crossing(c, p, half);
		}
	});
	return half.upwards ? above : -above;
}

}  // namespace index_boolean
