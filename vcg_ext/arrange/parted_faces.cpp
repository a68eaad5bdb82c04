// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: two faces; out: how they meet. Filters with the bounds of exact_sign.h, then the contact.
//
// A plane: of the corners of b that are not common, all lie strictly on one side of a's plane. Then
// b meets that plane in the common corner or edge alone.
// A line: in the projection along an axis, a third corner of a lies strictly on one side of the
// line along the side opposite to it, and all corners of b that are not common strictly on the
// other. The common ones have to lie on that line, so with one of them it is a side at it that
// counts, with two the side between them. What both faces have in common lies above the line, where
// b has the common corner or edge alone.
#include "vcg_ext/arrange/parted_faces.h"

#include "vcg_ext/arrange/triangle_contact.h"
#include "vcg_ext/exact/exact_sign.h"

#include <algorithm>
#include <cmath>

namespace index_boolean {

namespace {

using Corners = std::array<const Point*, 3>;

// Two faces with their common corners first, in one order; how the others run does not matter.
struct TwoFaces {
	std::size_t common = 0;
	std::array<Corners, 2> corners{};

	TwoFaces(const FacesView& faces, FacePair pair) {
		std::array<IndexTriangle, 2> t{faces[pair.a.value], faces[pair.b.value]};
		for (std::size_t i = 0; i < 3; ++i) {
			const auto same = std::find(t[1].begin() + common, t[1].end(), t[0][i]);
			if (same != t[1].end()) {
				std::swap(t[0][common], t[0][i]);
				std::iter_swap(t[1].begin() + common, same);
				++common;
			}
		}
		for (std::size_t face = 0; face < 2; ++face) {
			for (std::size_t i = 0; i < 3; ++i) {
				corners[face][i] = &faces.point(t[face][i]);
			}
		}
	}
};

bool planeParts(const Corners& a, const Corners& b, std::size_t common) {
	const PlaneFilter plane(*a[0], *a[1], *a[2]);
	const int side = plane.side(*b[common]);
	bool parts = side != kUnknownSign;
	for (std::size_t i = common + 1; i < 3 && parts; ++i) {
		parts = plane.side(*b[i]) == side;
	}
	return parts;
}

// A line through two points in the projection along an axis. With u the unit roundoff, each product
// errs by less than 3.1u of its size, the difference by u more: see RoundedNormal.
class LineFilter {
public:
	LineFilter(const Point& p, const Point& q, std::size_t axis)
	    : origin_(p), x_((axis + 1) % 3), y_((axis + 2) % 3), dx_(q[x_] - p[x_]),
	      dy_(q[y_] - p[y_]) {}

	// +1 or -1, or 0 where there is a doubt.
	int side(const Point& r) const {
		const double left = dx_ * (r[y_] - origin_[y_]), right = dy_ * (r[x_] - origin_[x_]);
		const double value = left - right;
		const double bound = 8 * kRoundoff * (std::fabs(left) + std::fabs(right)) + kUnderflow;
		return value > bound ? 1 : value < -bound ? -1 : 0;
	}

private:
	const Point& origin_;
	std::size_t x_, y_;
	double dx_, dy_;
};

// Whether the line along the side of a that is opposite to its corner `third` parts the faces.
bool sideParts(const Corners& a, const Corners& b, std::size_t common, std::size_t third,
               std::size_t axis) {
	const LineFilter line(*a[(third + 1) % 3], *a[(third + 2) % 3], axis);
	const int side = line.side(*a[third]);
	bool parts = side != 0;
	for (std::size_t i = common; i < 3 && parts; ++i) {
		parts = line.side(*b[i]) == -side;
	}
	return parts;
}

// The corners opposite to which a side has all common corners on its line: those that are not
// common. (With two common corners, the side between them is one side for both faces.)
bool projectionParts(const TwoFaces& two, std::size_t axis) {
	for (std::size_t face = 0; face < 2; ++face) {
		for (std::size_t third = two.common; third < 3; ++third) {
			if (sideParts(two.corners[face], two.corners[1 - face], two.common, third, axis)) {
				return true;
			}
		}
	}
	return false;
}

std::size_t largestAxis(const RoundedNormal& normal) {
	const auto bySize = [](double p, double q) { return std::fabs(p) < std::fabs(q); };
	const auto largest = std::max_element(normal.value.begin(), normal.value.end(), bySize);
	return static_cast<std::size_t>(largest - normal.value.begin());
}

Triangle triangleOf(const FacesView& faces, FaceId face) {
	const IndexTriangle t = faces[face.value];
	return {VertexId{t[0]}, VertexId{t[1]}, VertexId{t[2]}};
}

bool hasCorner(const Triangle& t, VertexId v) { return t[0] == v || t[1] == v || t[2] == v; }

}  // namespace

bool arePartedFaces(const FacesView& faces, FacePair pair) {
	const TwoFaces two(faces, pair);
	if (two.common == 3) {
		return false;
	}
	const Corners &a = two.corners[0], &b = two.corners[1];
	if (planeParts(a, b, two.common) || planeParts(b, a, two.common)) {
		return true;
	}
	const std::size_t first = largestAxis(RoundedNormal(*a[0], *a[1], *a[2]));
	for (std::size_t k = 0; k < 3; ++k) {
		if (projectionParts(two, (first + k) % 3)) {
			return true;
		}
	}
	return false;
}

// A contact is a convex set whose corners are named: it is the common corner or edge of two faces
// iff all its names are common corners. Two faces with three of them are one face twice.
Meeting meetingOf(const FacesView& faces, FacePair pair) {
	const std::array<Triangle, 2> corners{triangleOf(faces, pair.a), triangleOf(faces, pair.b)};
	PairContact contact;
	if (!contactOf(faces.points(), pair, corners, contact)) {
		return Meeting::Contradiction;
	}
	const auto isCommonCorner = [&corners](const PointName& name) {
		const VertexId v{name.ids[0]};
		return name.kind == PointKind::Vertex && hasCorner(corners[0], v) &&
		       hasCorner(corners[1], v);
	};
	const auto end = contact.points.cbegin() + contact.count;
	return contact.count < 3 && std::all_of(contact.points.cbegin(), end, isCommonCorner)
	           ? Meeting::Proper
	           : Meeting::Wrong;
}

}  // namespace index_boolean
