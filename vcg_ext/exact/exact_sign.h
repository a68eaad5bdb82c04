// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The predicates: signs of polynomials in input coordinates, for input points and for the implicit
// points of the curve, and the correctly rounded coordinates of the latter.
// Guarantee: every sign is exact for all finite doubles. A point's rounded coordinates do not
// depend on the order in which its edge's or faces' corners are named.
// Degrees: orient3d 3; order of two line-plane points 6; orient2d of three of them 11.
// Complexity: O(1) each, unless said otherwise: some 10 to 100 flops where doubles can tell, more
// than a thousand times that where only integers can. No function fails; each borrows what it is
// given. Source: filters after Shewchuk 1997 and Attene 2020 (indirect predicates), with bounds of
// our own.
#pragma once

#include "vcg_ext/base/mesh_types.h"
#include "vcg_ext/exact/exact_number.h"

#include <vector>

namespace index_boolean {

// The side of the plane through a, b, c on which p lies: +1 where its normal (b-a)x(c-a) points, 0
// on it. \pre finite. Complexity: O(1), almost always 40 flops.
int orient3d(const Point& a, const Point& b, const Point& c, const Point& p);

// The normal (b-a)x(c-a) of a face as rounded; `size` are the sums of the sizes of the two products
// that each component is the difference of, which bound its error.
struct RoundedNormal {
	std::array<double, 3> value, size;

	RoundedNormal(const Point& a, const Point& b, const Point& c);

	// Whether the exact normal is certainly not zero. False where anything overflows.
	bool isCertain() const;
};

inline RoundedNormal::RoundedNormal(const Point& a, const Point& b, const Point& c)
    : value{}, size{} {
	const std::array<double, 3> u{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
	const std::array<double, 3> v{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
	for (std::size_t k = 0; k < 3; ++k) {
		const std::size_t i = k == 2 ? 0 : k + 1, j = k == 0 ? 2 : k - 1;
		const double left = u[i] * v[j], right = u[j] * v[i];
		value[k] = left - right;
		size[k] = std::fabs(left) + std::fabs(right);
	}
}

// With u the unit roundoff, each product errs by less than 3.1u of its computed size (two rounded
// factors, one rounded product) and by less than 2^-1074 on underflow (differences of doubles do
// not underflow); the last subtraction errs by u of the result. In all less than 4.2u times `size`
// plus 2^-1072; the bound is well above that, its own rounding included. An overflow makes the
// comparison one of infinities or NaN, which is false.
inline bool RoundedNormal::isCertain() const {
	const auto certainlyNonZero = [this](std::size_t k) {
		return std::fabs(value[k]) > 8 * kRoundoff * size[k] + kUnderflow;
	};
	return certainlyNonZero(0) || certainlyNonZero(1) || certainlyNonZero(2);
}

// The plane through a, b, c, ready to be asked for the sides of many points: a third of the cost of
// orient3d, but no answer where rounding leaves a doubt.
class PlaneFilter {
public:
	PlaneFilter(const Point& a, const Point& b, const Point& c) : origin_(a), normal_(a, b, c) {}

	// As orient3d(a, b, c, p), or kUnknownSign; 0 is never the answer.
	int side(const Point& p) const;

	// Whether p, q, r lie strictly on one side, without doubt.
	bool parts(const Point& p, const Point& q, const Point& r) const;

private:
	Point origin_;
	RoundedNormal normal_;
};

// The value behind that sign, six times the volume of the tetrahedron a b c p, with an error bound.
Bounded orient3dBounded(const Point& a, const Point& b, const Point& c, const Point& p);

// The sign of six times the volume that closed triangles enclose, exactly. O(n) big numbers: for
// where the sum of orient3dBounded cannot tell.
int exactVolumeSign(const Points& points, const Triangle* begin, const Triangle* end);

// The sign of the component `axis` of (b-a)x(c-a): +1 for a counter-clockwise triangle seen
// against that axis.
int orient2d(const Point& a, const Point& b, const Point& c, int axis);

// A point as the input simplices that define it; borrowed pointers into the input's points.
//   Explicit     by[0]
//   LinePlane    line by[0] by[1], plane by[2] by[3] by[4]
//   LineLine     line by[0] by[1], line by[2] by[3], not parallel in the projection along `axis`
//   ThreePlanes  planes by[0..2], by[3..5], by[6..8]
// `rounded` are its correctly rounded coordinates, filled by roundPoint (for Explicit: the point).
struct ExactPoint {
	enum class Form : std::uint8_t { Explicit, LinePlane, LineLine, ThreePlanes };

	Form form = Form::Explicit;
	std::uint8_t axis = 0;
	std::array<const Point*, 9> by{};
	Point rounded{};

	static ExactPoint explicitPoint(const Point& p);
	static ExactPoint linePlane(const std::array<const Point*, 5>& by);
	static ExactPoint lineLine(const std::array<const Point*, 4>& by, int axis);
	static ExactPoint threePlanes(const std::array<const Point*, 9>& by);
};

// Fills p.rounded: each coordinate of the exact point rounded to the nearest double, ties to even.
// \pre the simplices meet in one point
void roundPoint(ExactPoint& p);

// The weights by which a point in the plane of a triangle is the mean of its corners. Their signs
// are exact, 0 included: negative only where the point is outside; their values within 2^-40.
// \param zero the corner whose weight is known to be 0, or -1; knowing it saves time
// \param axis along which the triangle has area
// \pre p lies in the triangle's plane, and its rounded coordinates are filled
std::array<double, 3> barycentricWeights(const std::array<const Point*, 3>& triangle,
                                         const ExactPoint& p, int zero, int axis);

// Compares one coordinate of two points exactly: -1, 0, +1.
int compareCoordinate(const ExactPoint& a, const ExactPoint& b, int axis);

// As orient2d above, for any points (whose rounded coordinates are filled).
int orient2d(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c, int axis);

// As orient3d above, for any point. Degree 6 for one of form LinePlane.
int orient3d(const std::array<const Point*, 3>& plane, const ExactPoint& p);

// A point in the projection along an axis, as far as its rounded coordinates tell.
struct PlanarPoint {
	Bounded x, y;  // along the axes after and before the one projected along

	// \param isExact whether the coordinates are the point's own; else each is known to half an ulp
	PlanarPoint(const Point& rounded, bool isExact, int axis);
};

inline PlanarPoint::PlanarPoint(const Point& rounded, bool isExact, int axis)
    : x(rounded[static_cast<std::size_t>(nextCorner(axis))]),
      y(rounded[static_cast<std::size_t>(previousCorner(axis))]) {
	if (!isExact) {
		x = Bounded::fromRounded(x.value);
		y = Bounded::fromRounded(y.value);
	}
}

// As orient2d above, or kUnknownSign.
int orient2d(const PlanarPoint& a, const PlanarPoint& b, const PlanarPoint& c);

// Tells which of two planes a line along an axis meets first: with D the value behind orient3d and
// n the normal, the sign of D_b(p) n_a[axis] - D_a(p) n_b[axis], for p on the line. Times the signs
// of n_a[axis] and n_b[axis], if neither is zero: -1 if the line comes to a first, 0 if it meets
// both in one place, +1 if it comes to b first.
int planeOrder(const std::array<const Point*, 3>& a, const std::array<const Point*, 3>& b,
               const ExactPoint& p, int axis);

// The axis along which a triangle is projected: that of its normal's largest component, the first
// of equal ones. So it is a function of the triangle's plane: coplanar faces have the same.
// Writes the exact, non-zero sign of that component. \pre the triangle has area; else -1
int projectionAxis(const Triangle& triangle, const Points& points, int& sign);

}  // namespace index_boolean
