// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Each predicate is one formula over a number type (exact_number.h); the cheapest type that can
// tell the sign decides. Points of the curve are tried by their rounded coordinates first, each
// known to half an ulp.
#include "vcg_ext/exact/exact_sign.h"

#include <algorithm>
#include <type_traits>

namespace index_boolean {

namespace {

template <class N>
using Vector = std::array<N, 3>;

template <class N>
Vector<N> difference(const Point& a, const Point& b) {
	const auto component = [&](std::size_t k) {
		if constexpr (std::is_same_v<N, BoundedPair> || std::is_same_v<N, Dyadic>) {
			return N::difference(a[k], b[k]);
		} else {
			return N(a[k]) - N(b[k]);
		}
	};
	return {component(0), component(1), component(2)};
}

template <class N>
N crossComponent(const Vector<N>& a, const Vector<N>& b, int axis) {
	const auto i = static_cast<std::size_t>(nextCorner(axis));
	const auto j = static_cast<std::size_t>(previousCorner(axis));
	return a[i] * b[j] - a[j] * b[i];
}

template <class N>
Vector<N> cross(const Vector<N>& a, const Vector<N>& b) {
	return {crossComponent(a, b, 0), crossComponent(a, b, 1), crossComponent(a, b, 2)};
}

template <class N>
N dot(const Vector<N>& a, const Vector<N>& b) {
	return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class N>
N orient3dValue(const Point& a, const Point& b, const Point& c, const Point& p) {
	return dot(cross(difference<N>(b, a), difference<N>(c, a)), difference<N>(p, a));
}

template <class N>
N orient2dValue(const Point& a, const Point& b, const Point& c, int axis) {
	return crossComponent(difference<N>(b, a), difference<N>(c, a), axis);
}

// A point as base + numerator / denominator.
template <class N>
struct Quotient {
	const Point* base;
	Vector<N> numerator;
	N denominator;
};

// A point on a line as from + direction * (top / bottom).
template <class N>
struct LineCut {
	const Point* from;
	Vector<N> direction;
	N top, bottom;
};

// \pre a point of form LinePlane or LineLine
template <class N>
LineCut<N> lineCut(const ExactPoint& p) {
	const auto& by = p.by;
	if (p.form == ExactPoint::Form::LineLine) {
		const N first = orient2dValue<N>(*by[2], *by[3], *by[0], p.axis);
		const N second = orient2dValue<N>(*by[2], *by[3], *by[1], p.axis);
		return {by[0], difference<N>(*by[1], *by[0]), first, first - second};
	}
	const Vector<N> normal = cross(difference<N>(*by[3], *by[2]), difference<N>(*by[4], *by[2]));
	return {by[0], difference<N>(*by[1], *by[0]), dot(normal, difference<N>(*by[0], *by[2])),
	        dot(normal, difference<N>(*by[0], *by[1]))};
}

template <class N>
Quotient<N> meetOfThreePlanes(const std::array<const Point*, 9>& by) {
	const Point& base = *by[0];
	const auto normal = [&by](std::size_t i) {
		return cross(difference<N>(*by[i + 1], *by[i]), difference<N>(*by[i + 2], *by[i]));
	};
	const Vector<N> n0 = normal(0);
	const Vector<N> n1 = normal(3);
	const Vector<N> n2 = normal(6);
	// The base lies on the first plane, so only the other two have a distance from it.
	const N distance1 = dot(n1, difference<N>(*by[3], base));
	const N distance2 = dot(n2, difference<N>(*by[6], base));
	const Vector<N> along1 = cross(n2, n0);
	const Vector<N> along2 = cross(n0, n1);
	const auto component = [&](std::size_t k) {
		return distance1 * along1[k] + distance2 * along2[k];
	};
	return {&base, {component(0), component(1), component(2)}, dot(n0, cross(n1, n2))};
}

template <class N>
Quotient<N> quotient(const ExactPoint& p) {
	switch (p.form) {
	case ExactPoint::Form::Explicit:
		break;
	case ExactPoint::Form::LinePlane:
	case ExactPoint::Form::LineLine: {
		const LineCut<N> cut = lineCut<N>(p);
		const Vector<N>& d = cut.direction;
		return {cut.from, {d[0] * cut.top, d[1] * cut.top, d[2] * cut.top}, cut.bottom};
	}
	case ExactPoint::Form::ThreePlanes:
		return meetOfThreePlanes<N>(p.by);
	}
	return {p.by[0], {N(0), N(0), N(0)}, N(1)};
}

template <class N>
Vector<N> normalOf(const std::array<const Point*, 3>& plane) {
	return cross(difference<N>(*plane[1], *plane[0]), difference<N>(*plane[2], *plane[0]));
}

// The value behind orient3d, times the point's denominator.
template <class N>
N distanceFrom(const std::array<const Point*, 3>& plane, const Vector<N>& normal,
               const Quotient<N>& p) {
	return dot(normal, difference<N>(*p.base, *plane[0])) * p.denominator +
	       dot(normal, p.numerator);
}

// A point as base + offset. \pre not of form Explicit
struct Offset {
	const Point* base;
	Vector<BoundedPair> offset;
};

// One division serves all coordinates of a point on a line.
Offset offsetOf(const ExactPoint& p) {
	if (p.form == ExactPoint::Form::ThreePlanes) {
		const Quotient<BoundedPair> q = meetOfThreePlanes<BoundedPair>(p.by);
		return {q.base,
		        {q.numerator[0] / q.denominator, q.numerator[1] / q.denominator,
		         q.numerator[2] / q.denominator}};
	}
	const LineCut<BoundedPair> cut = lineCut<BoundedPair>(p);
	const BoundedPair fraction = cut.top / cut.bottom;
	const Vector<BoundedPair>& d = cut.direction;
	return {cut.from, {d[0] * fraction, d[1] * fraction, d[2] * fraction}};
}

// Homogeneous coordinates of a point in the projection along an axis, relative to an origin.
template <class N>
struct Homogeneous {
	N x, y, w;
};

template <class N>
Homogeneous<N> homogeneous(const ExactPoint& p, const Point& origin, int axis) {
	const Quotient<N> q = quotient<N>(p);
	const auto i = static_cast<std::size_t>(nextCorner(axis));
	const auto j = static_cast<std::size_t>(previousCorner(axis));
	const Point& base = *q.base;
	return {(N(base[i]) - N(origin[i])) * q.denominator + q.numerator[i],
	        (N(base[j]) - N(origin[j])) * q.denominator + q.numerator[j], q.denominator};
}

template <class N>
int homogeneousOrientation(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c,
                           int axis) {
	const Point& origin = *a.by[0];
	const Homogeneous<N> p = homogeneous<N>(a, origin, axis);
	const Homogeneous<N> q = homogeneous<N>(b, origin, axis);
	const Homogeneous<N> r = homogeneous<N>(c, origin, axis);
	const N determinant = p.w * (q.x * r.y - q.y * r.x) - q.w * (p.x * r.y - p.y * r.x) +
	                      r.w * (p.x * q.y - p.y * q.x);
	const int weights = signProduct(signProduct(p.w.sign(), q.w.sign()), r.w.sign());
	return signProduct(determinant.sign(), weights);
}

// The weights of a triangle's corners as quotients with one denominator.
template <class N>
struct Barycentric {
	std::array<N, 3> numerator;
	N denominator;
};

template <class N>
Barycentric<N> barycentric(const std::array<const Point*, 3>& triangle, const ExactPoint& p,
                           int axis) {
	const Point& origin = *triangle[2];
	const Homogeneous<N> q = homogeneous<N>(p, origin, axis);
	const Homogeneous<N> a = homogeneous<N>(ExactPoint::explicitPoint(*triangle[0]), origin, axis);
	const Homogeneous<N> b = homogeneous<N>(ExactPoint::explicitPoint(*triangle[1]), origin, axis);
	const N first = q.x * b.y - q.y * b.x;
	const N second = a.x * q.y - a.y * q.x;
	const N whole = (a.x * b.y - a.y * b.x) * q.w;
	return {{first, second, whole - first - second}, whole};
}

double approximate(const Bounded& n) { return n.value; }
double approximate(const BoundedPair& n) { return n.high; }

// Writes the weights if their signs are known and their values precise; that of the corner `zero`
// is 0. What a double-double's low part adds is far below that.
template <class N>
bool weightsOf(const Barycentric<N>& quotients, int zero, std::array<double, 3>& weights) {
	constexpr double kPrecision = 0x1p-41;
	const double divisor = approximate(quotients.denominator);
	const double room = std::fabs(divisor) - quotients.denominator.bound;
	for (std::size_t k = 0; k < 3; ++k) {
		const N& numerator = quotients.numerator[k];
		weights[k] = 0;
		if (static_cast<int>(k) == zero) {
			continue;
		}
		weights[k] = approximate(numerator) / divisor;
		const double error = numerator.bound + std::fabs(weights[k]) * quotients.denominator.bound;
		if (numerator.sign() == kUnknownSign || !(error <= kPrecision * room)) {
			return false;
		}
		if (numerator.sign() == 0) {
			weights[k] = 0;
		}
	}
	return true;
}

// Whether all of the points have one coordinate in common, +0 and -0 being the same.
bool haveEqual(const Point* const* points, std::size_t count, std::size_t axis) {
	return std::all_of(points + 1, points + count,
	                   [&](const Point* p) { return (*p)[axis] == (*points[0])[axis]; });
}

// The corner of a point's definition that has exactly the point's coordinate along an axis, or
// null: where an edge or a wall that it lies on is at right angles to the axis, the coordinate is
// known without a calculation. In what is built of axis-parallel walls and edges, most are.
const Point* cornerLevelWith(const ExactPoint& p, std::size_t axis) {
	const auto& by = p.by;
	const auto levelOf = [&](std::size_t first, std::size_t count) {
		return haveEqual(&by[first], count, axis) ? by[first] : nullptr;
	};
	switch (p.form) {
	case ExactPoint::Form::Explicit:
		return by[0];
	case ExactPoint::Form::LinePlane:
		return levelOf(0, 2) != nullptr ? by[0] : levelOf(2, 3);
	case ExactPoint::Form::LineLine:
		// Along its axis the second line need not meet the first.
		return levelOf(0, 2) != nullptr || axis == p.axis ? levelOf(0, 2) : levelOf(2, 2);
	case ExactPoint::Form::ThreePlanes:
		for (const std::size_t plane : {0u, 3u, 6u}) {
			if (const Point* corner = levelOf(plane, 3)) {
				return corner;
			}
		}
	}
	return nullptr;
}

// Whether a point's rounded coordinates in the projection along an axis are exactly its own.
bool isKnown(const ExactPoint& p, int axis) {
	return cornerLevelWith(p, static_cast<std::size_t>(nextCorner(axis))) != nullptr &&
	       cornerLevelWith(p, static_cast<std::size_t>(previousCorner(axis))) != nullptr;
}

// Whether a point lies strictly inside the edge by[0] by[1].
bool isInsideEdge(const ExactPoint& p) {
	const auto& by = p.by;
	if (p.form == ExactPoint::Form::LinePlane) {
		return orient3d(*by[2], *by[3], *by[4], *by[0]) * orient3d(*by[2], *by[3], *by[4], *by[1]) <
		       0;
	}
	return p.form == ExactPoint::Form::LineLine &&
	       orient2d(*by[2], *by[3], *by[0], p.axis) * orient2d(*by[2], *by[3], *by[1], p.axis) < 0;
}

// The orientation of two known points and one inside an edge: that of the edge's ends, if these lie
// on one side or on the line itself; else kUnknownSign. So points that an edge and the curve on it
// project to one line are told to be collinear at once.
int orientationByEnds(const ExactPoint& a, const ExactPoint& b, const ExactPoint& inside,
                      int axis) {
	const int first = orient2d(a.rounded, b.rounded, *inside.by[0], axis);
	const int second = orient2d(a.rounded, b.rounded, *inside.by[1], axis);
	if (first * second < 0 || !isInsideEdge(inside)) {
		return kUnknownSign;
	}
	return first != 0 ? first : second;
}

// Whether three points are known to have one coordinate in common.
bool areLevel(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c, int axis) {
	const auto k = static_cast<std::size_t>(axis);
	const Point* p = cornerLevelWith(a, k);
	const Point* q = p != nullptr ? cornerLevelWith(b, k) : nullptr;
	const Point* r = q != nullptr && (*p)[k] == (*q)[k] ? cornerLevelWith(c, k) : nullptr;
	return r != nullptr && (*q)[k] == (*r)[k];
}

// The orientation as far as coordinates that are known exactly tell it, else kUnknownSign.
int orientationOfKnown(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c, int axis) {
	if (areLevel(a, b, c, nextCorner(axis)) || areLevel(a, b, c, previousCorner(axis))) {
		return 0;
	}
	const bool knowsA = isKnown(a, axis), knowsB = isKnown(b, axis), knowsC = isKnown(c, axis);
	if (knowsA && knowsB && knowsC) {
		return orient2d(a.rounded, b.rounded, c.rounded, axis);
	}
	if (knowsA && knowsB) {
		return orientationByEnds(a, b, c, axis);
	}
	if (knowsB && knowsC) {
		return orientationByEnds(b, c, a, axis);
	}
	return knowsA && knowsC ? orientationByEnds(c, a, b, axis) : kUnknownSign;
}

ExactPoint make(ExactPoint::Form form, int axis) {
	ExactPoint p;
	p.form = form;
	p.axis = static_cast<std::uint8_t>(axis);
	return p;
}

}  // namespace

int PlaneFilter::side(const Point& p) const {
	const double x = p[0] - origin_[0], y = p[1] - origin_[1], z = p[2] - origin_[2];
	const auto& [n, nSize] = normal_;
	const double value = n[0] * x + n[1] * y + n[2] * z;
	const double sizeX = std::fabs(x), sizeY = std::fabs(y), sizeZ = std::fabs(z);
	// Seven rounded operations and an eighth for `size` lie on each path: below 10u times `size`.
	const double size = nSize[0] * sizeX + nSize[1] * sizeY + nSize[2] * sizeZ;
	const double bound = 12 * kRoundoff * size + kUnderflow * (1 + sizeX + sizeY + sizeZ);
	return Bounded(value, bound).sign();
}

bool PlaneFilter::parts(const Point& p, const Point& q, const Point& r) const {
	const int first = side(p);
	return first != kUnknownSign && side(q) == first && side(r) == first;
}

Bounded orient3dBounded(const Point& a, const Point& b, const Point& c, const Point& p) {
	const double ax = a[0] - p[0], ay = a[1] - p[1], az = a[2] - p[2];
	const double bx = b[0] - p[0], by = b[1] - p[1], bz = b[2] - p[2];
	const double cx = c[0] - p[0], cy = c[1] - p[1], cz = c[2] - p[2];
	const double bxcy = bx * cy, cxby = cx * by;
	const double cxay = cx * ay, axcy = ax * cy;
	const double axby = ax * by, bxay = bx * ay;
	const double value = az * (bxcy - cxby) + bz * (cxay - axcy) + cz * (axby - bxay);
	const double sizeA = std::fabs(az), sizeB = std::fabs(bz), sizeC = std::fabs(cz);
	const double size = (std::fabs(bxcy) + std::fabs(cxby)) * sizeA +
	                    (std::fabs(cxay) + std::fabs(axcy)) * sizeB +
	                    (std::fabs(axby) + std::fabs(bxay)) * sizeC;
	// Eight rounded operations lie on each path, so the error is below 9u times `size`.
	const double bound = 10 * kRoundoff * size + kUnderflow * (1 + sizeA + sizeB + sizeC);
	return {-value, bound};  // det(a-p, b-p, c-p) is positive behind the plane
}

int orient3d(const Point& a, const Point& b, const Point& c, const Point& p) {
	if (const int sign = orient3dBounded(a, b, c, p).sign(); sign != kUnknownSign) {
		countSign(Predicate::Orient3d, DecidedBy::Double);
		return sign;
	}
	return decideSign(Predicate::Orient3d, [&](auto tag) {
		return orient3dValue<typename decltype(tag)::Type>(a, b, c, p).sign();
	});
}

int exactVolumeSign(const Points& points, const Triangle* begin, const Triangle* end) {
	const Point origin{};
	Dyadic sum(0.0);
	for (const Triangle* t = begin; t != end; ++t) {
		sum = sum - orient3dValue<Dyadic>(at(points, (*t)[0]), at(points, (*t)[1]),
		                                  at(points, (*t)[2]), origin);
	}
	return sum.sign();
}

int orient2d(const Point& a, const Point& b, const Point& c, int axis) {
	return decideSign(Predicate::Orient2d, [&](auto tag) {
		return orient2dValue<typename decltype(tag)::Type>(a, b, c, axis).sign();
	});
}

ExactPoint ExactPoint::explicitPoint(const Point& p) {
	ExactPoint point = make(Form::Explicit, 0);
	point.by[0] = &p;
	point.rounded = p;
	return point;
}

ExactPoint ExactPoint::linePlane(const std::array<const Point*, 5>& by) {
	ExactPoint point = make(Form::LinePlane, 0);
	std::copy(by.begin(), by.end(), point.by.begin());
	return point;
}

ExactPoint ExactPoint::lineLine(const std::array<const Point*, 4>& by, int axis) {
	ExactPoint point = make(Form::LineLine, axis);
	std::copy(by.begin(), by.end(), point.by.begin());
	return point;
}

ExactPoint ExactPoint::threePlanes(const std::array<const Point*, 9>& by) {
	ExactPoint point = make(Form::ThreePlanes, 0);
	point.by = by;
	return point;
}

void roundPoint(ExactPoint& p) {
	if (p.form == ExactPoint::Form::Explicit) {
		p.rounded = *p.by[0];
		return;
	}
	std::array<bool, 3> certain{};
	for (std::size_t k = 0; k < 3; ++k) {
		if (const Point* corner = cornerLevelWith(p, k)) {
			p.rounded[k] = (*corner)[k] + 0.0;  // one zero, whichever way it is found
			certain[k] = true;
		}
	}
	if (certain[0] && certain[1] && certain[2]) {
		countSign(Predicate::Rounding, DecidedBy::Double);
		return;
	}
	const Offset approximate = offsetOf(p);
	const Point& base = *approximate.base;
	for (std::size_t k = 0; k < 3; ++k) {
		certain[k] = certain[k] || certainSum(base[k], approximate.offset[k], p.rounded[k]);
	}
	const bool allCertain = certain[0] && certain[1] && certain[2];
	countSign(Predicate::Rounding, allCertain ? DecidedBy::DoubleDouble : DecidedBy::Integers);
	if (!allCertain) {
		const Quotient<Dyadic> exact = quotient<Dyadic>(p);
		for (std::size_t k = 0; k < 3; ++k) {
			if (certain[k]) {
				continue;
			}
			const Dyadic numerator = Dyadic(base[k]) * exact.denominator + exact.numerator[k];
			p.rounded[k] = roundedQuotient(numerator, exact.denominator);
		}
	}
	for (double& coordinate : p.rounded) {
		coordinate += 0.0;
	}
}

std::array<double, 3> barycentricWeights(const std::array<const Point*, 3>& triangle,
                                         const ExactPoint& p, int zero, int axis) {
	std::array<double, 3> weights{};
	if (weightsOf(barycentric<Bounded>(triangle, p, axis), zero, weights)) {
		countSign(Predicate::Rounding, DecidedBy::Double);
	} else if (weightsOf(barycentric<BoundedPair>(triangle, p, axis), zero, weights)) {
		countSign(Predicate::Rounding, DecidedBy::DoubleDouble);
	} else {
		countSign(Predicate::Rounding, DecidedBy::Integers);
		const Barycentric<Dyadic> exact = barycentric<Dyadic>(triangle, p, axis);
		for (std::size_t k = 0; k < 3; ++k) {
			weights[k] = roundedQuotient(exact.numerator[k], exact.denominator);
		}
	}
	return weights;
}

int compareCoordinate(const ExactPoint& a, const ExactPoint& b, int axis) {
	const auto k = static_cast<std::size_t>(axis);
	// Correct rounding is monotone: rounded values that differ have the order of the exact ones.
	if (a.rounded[k] != b.rounded[k]) {
		countSign(Predicate::CurveOrder, DecidedBy::Double);
		return a.rounded[k] < b.rounded[k] ? -1 : 1;
	}
	if (cornerLevelWith(a, k) != nullptr && cornerLevelWith(b, k) != nullptr) {
		countSign(Predicate::CurveOrder, DecidedBy::Double);
		return 0;
	}
	const Point& origin = *a.by[0];
	return decideSign(Predicate::CurveOrder, [&](auto tag) {
		using N = typename decltype(tag)::Type;
		const Homogeneous<N> p = homogeneous<N>(a, origin, previousCorner(axis));
		const Homogeneous<N> q = homogeneous<N>(b, origin, previousCorner(axis));
		const int weights = signProduct(p.w.sign(), q.w.sign());
		return signProduct((p.x * q.w - q.x * p.w).sign(), weights);
	});
}

int orient2d(const PlanarPoint& a, const PlanarPoint& b, const PlanarPoint& c) {
	const Bounded value = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
	const int sign = value.sign();
	if (sign != kUnknownSign) {
		countSign(Predicate::CurveOrient2d, DecidedBy::Double);
	}
	return sign;
}

int orient2d(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c, int axis) {
	const auto planar = [axis](const ExactPoint& p) {
		return PlanarPoint(p.rounded, p.form == ExactPoint::Form::Explicit, axis);
	};
	if (const int sign = orient2d(planar(a), planar(b), planar(c)); sign != kUnknownSign) {
		return sign;
	}
	if (const int sign = orientationOfKnown(a, b, c, axis); sign != kUnknownSign) {
		return sign;  // counted as one of input points
	}
	return decideSign(Predicate::CurveOrient2d, [&](auto tag) {
		return homogeneousOrientation<typename decltype(tag)::Type>(a, b, c, axis);
	});
}

int orient3d(const std::array<const Point*, 3>& plane, const ExactPoint& p) {
	if (p.form == ExactPoint::Form::Explicit) {
		return orient3d(*plane[0], *plane[1], *plane[2], *p.by[0]);
	}
	return decideSign(Predicate::Orient3d, [&](auto tag) {
		using N = typename decltype(tag)::Type;
		const Quotient<N> q = quotient<N>(p);
		return signProduct(distanceFrom(plane, normalOf<N>(plane), q).sign(), q.denominator.sign());
	});
}

int planeOrder(const std::array<const Point*, 3>& a, const std::array<const Point*, 3>& b,
               const ExactPoint& p, int axis) {
	return decideSign(Predicate::Slopes, [&](auto tag) {
		using N = typename decltype(tag)::Type;
		const auto k = static_cast<std::size_t>(axis);
		const Quotient<N> q = quotient<N>(p);
		const Vector<N> m = normalOf<N>(a);
		const Vector<N> n = normalOf<N>(b);
		const N order = distanceFrom(b, n, q) * m[k] - distanceFrom(a, m, q) * n[k];
		return signProduct(order.sign(), q.denominator.sign());
	});
}

namespace {

// Compares the sizes of two components of a normal: -1, 0, +1.
int compareSizes(const std::array<const Point*, 3>& t, int axis, int other) {
	const int sign = orient2d(*t[0], *t[1], *t[2], axis);
	const int otherSign = orient2d(*t[0], *t[1], *t[2], other);
	if (sign == 0 || otherSign == 0) {
		return std::abs(sign) - std::abs(otherSign);
	}
	const int order = decideSign(Predicate::AxisOrder, [&](auto number) {
		using N = typename decltype(number)::Type;
		const N mine = orient2dValue<N>(*t[0], *t[1], *t[2], axis);
		const N others = orient2dValue<N>(*t[0], *t[1], *t[2], other);
		return (sign == otherSign ? mine - others : mine + others).sign();
	});
	return signProduct(order, sign);
}

// The axis as far as rounded numbers tell, or -1. See RoundedNormal::isCertain for the bound.
int certainAxis(const RoundedNormal& normal) {
	std::array<double, 3> least{}, most{};  // that the size of each component can be
	for (std::size_t k = 0; k < 3; ++k) {
		const double bound = 8 * kRoundoff * normal.size[k] + kUnderflow;
		least[k] = std::fabs(normal.value[k]) - bound;
		most[k] = std::fabs(normal.value[k]) + bound;
	}
	for (std::size_t k = 0; k < 3; ++k) {
		if (least[k] > most[(k + 1) % 3] && least[k] > most[(k + 2) % 3]) {
			return static_cast<int>(k);
		}
	}
	return -1;
}

}  // namespace

int projectionAxis(const Triangle& triangle, const Points& points, int& sign) {
	const std::array<const Point*, 3> corners{&at(points, triangle[0]), &at(points, triangle[1]),
	                                          &at(points, triangle[2])};
	const RoundedNormal normal(*corners[0], *corners[1], *corners[2]);
	if (const int axis = certainAxis(normal); axis >= 0) {
		sign = normal.value[static_cast<std::size_t>(axis)] > 0 ? 1 : -1;
		return axis;
	}
	int axis = 0;
	for (const int other : {1, 2}) {
		axis = compareSizes(corners, other, axis) > 0 ? other : axis;
	}
	sign = orient2d(*corners[0], *corners[1], *corners[2], axis);
	return sign != 0 ? axis : -1;
}

}  // namespace index_boolean
