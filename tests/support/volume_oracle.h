// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The exact volume of the intersection of two solids with integer coordinates, by signed prisms; no
// code of the core. A solid is, almost everywhere, the signed sum of the prisms between its faces
// and the plane z = 0: with T a face's projection, s = +1 where it looks up, -1 where it looks
// down, and z its height,
//     vol(A and B) = sum over faces f of A, g of B of s_f s_g * integral of min(z_f, z_g)
//                    over the intersection of T_f and T_g.
// (Cones from an apex far below: the points that occur are crossings of edges, and of edges with
// faces, so all numbers stay small.) Coordinates are 0 to kMostCoordinate.
#pragma once

#include "exact_sum.h"
#include "grid_mesh.h"

namespace index_boolean::grid {

// With coordinates up to 8, a point's denominator is a determinant of at most 2660, and every
// product below fits 64 bits.
constexpr std::int64_t kMostCoordinate = 8;

// A point of a plane: (x / w, y / w), w > 0, without common divisor. Also a linear form
// x * [0] + y * [1] + w * [2].
using PlanePoint = std::array<std::int64_t, 3>;
using PlanePolygon = std::vector<PlanePoint>;

inline std::int64_t valueAt(const PlanePoint& form, const PlanePoint& p) {
	return form[0] * p[0] + form[1] * p[1] + form[2] * p[2];
}

// The part of a convex polygon where a linear form is not negative.
inline PlanePolygon clipped(const PlanePolygon& polygon, const PlanePoint& form) {
	PlanePolygon part;
	for (std::size_t i = 0; i < polygon.size(); ++i) {
		const PlanePoint &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
		const std::int64_t valueP = valueAt(form, p), valueQ = valueAt(form, q);
		if (valueP >= 0) {
			part.push_back(p);
		}
		if (signOf(valueP) * signOf(valueQ) < 0) {
			const std::int64_t a = std::abs(valueQ), b = std::abs(valueP);
			PlanePoint crossing{p[0] * a + q[0] * b, p[1] * a + q[1] * b, p[2] * a + q[2] * b};
			const std::int64_t divisor = std::gcd(std::gcd(crossing[0], crossing[1]), crossing[2]);
			for (std::int64_t& c : crossing) {
				c /= divisor;
			}
			part.push_back(crossing);
		}
	}
	return part;
}

// A face seen along an axis: counter-clockwise, with the linear form of its height, which is to be
// divided by `scale`. Its sign is that of its normal along the axis; 0: it is seen edge-on.
struct SeenFace {
	int sign = 0;
	PlanePolygon corners;
	std::array<PlanePoint, 3> sides{};  // not negative inside
	PlanePoint height{};
	std::int64_t scale = 0;

	SeenFace(const GridMesh& m, std::size_t face, std::size_t axis) {
		const std::size_t x = (axis + 1) % 3, y = (axis + 2) % 3;
		const IntPoint n = normal(m.corner(face, 0), m.corner(face, 1), m.corner(face, 2));
		sign = signOf(n[axis]);
		if (sign == 0) {
			return;
		}
		for (std::size_t i = 0; i < 3; ++i) {
			const IntPoint& p = m.corner(face, sign > 0 ? i : 2 - i);
			corners.push_back({p[x], p[y], 1});
		}
		for (std::size_t i = 0; i < 3; ++i) {
			const PlanePoint &p = corners[i], &q = corners[(i + 1) % 3];
			sides[i] = {p[1] - q[1], q[0] - p[0], p[0] * q[1] - p[1] * q[0]};
		}
		height = {-sign * n[x], -sign * n[y], sign * dot(n, m.corner(face, 0))};
		scale = sign * n[axis];
	}

	PlanePolygon overlap(const SeenFace& other) const {
		PlanePolygon polygon = corners;
		for (std::size_t i = 0; i < 3 && polygon.size() > 2; ++i) {
			polygon = clipped(polygon, other.sides[i]);
		}
		return polygon;
	}

	// Where this face is higher than the other, it is positive.
	PlanePoint heightOver(const SeenFace& other) const {
		PlanePoint form{};
		for (std::size_t k = 0; k < 3; ++k) {
			form[k] = height[k] * other.scale - other.height[k] * scale;
		}
		return form;
	}
};

inline std::vector<SeenFace> seenFaces(const GridMesh& m, std::size_t axis) {
	std::vector<SeenFace> faces;
	for (std::size_t f = 0; f < m.triangles.size(); ++f) {
		SeenFace face(m, f, axis);
		if (face.sign != 0) {
			faces.push_back(std::move(face));
		}
	}
	return faces;
}

// Twice the area of a triangle times the product of its corners' w.
inline std::int64_t doubleArea(const PlanePoint& p, const PlanePoint& q, const PlanePoint& r) {
	return p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) +
	       p[2] * (q[0] * r[1] - q[1] * r[0]);
}

// Adds sign * 6 * (the integral of a face's height over a convex polygon).
inline void addPrism(const PlanePolygon& polygon, const SeenFace& face, int sign, ExactSum& sum) {
	for (std::size_t i = 2; i < polygon.size(); ++i) {
		const std::array<PlanePoint, 3> t{polygon[0], polygon[i - 1], polygon[i]};
		const std::int64_t area = sign * doubleArea(t[0], t[1], t[2]);
		const std::int64_t w = t[0][2] * t[1][2] * t[2][2];
		for (const PlanePoint& p : t) {
			// The area is at most 64 w, the height at most 8: their product fits if w does.
			sum.add(area * valueAt(face.height, p), w * p[2] * face.scale);
		}
	}
}

// Six times the integral of (winding number in a) * (winding number in b): for solids, six times
// the volume of their intersection. O(|a| |b|).
// \param axis along which the prisms lie; the result does not depend on it
inline Rational sixVolumeOfBoth(const GridMesh& a, const GridMesh& b, std::size_t axis = 2) {
	const std::vector<SeenFace> facesA = seenFaces(a, axis), facesB = seenFaces(b, axis);
	ExactSum sum;
	for (const SeenFace& f : facesA) {
		for (const SeenFace& g : facesB) {
			const PlanePolygon both = f.overlap(g);
			if (both.size() < 3) {
				continue;
			}
			const PlanePoint over = f.heightOver(g);
			const auto isHigher = [&over](const PlanePoint& p) { return valueAt(over, p) > 0; };
			const auto isLower = [&over](const PlanePoint& p) { return valueAt(over, p) < 0; };
			const int sign = f.sign * g.sign;
			if (std::none_of(both.begin(), both.end(), isHigher)) {
				addPrism(both, f, sign, sum);
			} else if (std::none_of(both.begin(), both.end(), isLower)) {
				addPrism(both, g, sign, sum);
			} else {
				addPrism(clipped(both, over), g, sign, sum);
				addPrism(clipped(both, {-over[0], -over[1], -over[2]}), f, sign, sum);
			}
		}
	}
	return sum.value();
}

// Areas are measured in the sum of the three projections of a face: rational, and a face that is
// kept twice or lost shows in it.
inline std::int64_t doubleProjections(const GridMesh& m) {
	std::int64_t sum = 0;
	for (std::size_t f = 0; f < m.triangles.size(); ++f) {
		const IntPoint n = normal(m.corner(f, 0), m.corner(f, 1), m.corner(f, 2));
		sum += std::abs(n[0]) + std::abs(n[1]) + std::abs(n[2]);
	}
	return sum;
}

// Twice the projections of the parts of the plane in which faces of both meshes lie on each other.
struct CommonWalls {
	Rational sameWay;
	Rational oppositeWay;
};

inline CommonWalls commonWalls(const GridMesh& a, const GridMesh& b) {
	std::array<ExactSum, 2> sums;
	for (std::size_t axis = 0; axis < 3; ++axis) {
		const std::vector<SeenFace> facesA = seenFaces(a, axis), facesB = seenFaces(b, axis);
		for (const SeenFace& f : facesA) {
			for (const SeenFace& g : facesB) {
				if (f.heightOver(g) != PlanePoint{}) {
					continue;
				}
				const PlanePolygon both = f.overlap(g);
				for (std::size_t i = 2; i < both.size(); ++i) {
					sums[f.sign == g.sign ? 0 : 1].add(doubleArea(both[0], both[i - 1], both[i]),
					                                   both[0][2] * both[i - 1][2] * both[i][2]);
				}
			}
		}
	}
	return {sums[0].value(), sums[1].value()};
}

// Whether a mesh is a solid's boundary as the core takes it: closed, embedded, with a winding
// number of 0 or 1 everywhere. (Of an integer w, w * w - w is never negative: where its integral is
// zero, so is w * w - w.)
inline bool isSolid(const GridMesh& m) {
	return !m.triangles.empty() && sixVolume(m) > 0 && isClosed(m) && isEmbedded(m) &&
	       sixVolumeOfBoth(m, m) == sixVolume(m);
}

}  // namespace index_boolean::grid
