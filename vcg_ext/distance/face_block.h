// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: up to four faces and a point; out: the point's distance from each of them at once, as far as
// the processor has numbers side by side. Guarantee: it errs by less than 2^-45 (d + l), where l is
// the face's longest edge, and depends on the face's places only, not on the order of its corners.
//
// With u the unit roundoff 2^-53, p the point and a the first corner, q = p - a and the edges are
// each rounded once, so whatever is computed from them is relative to |q| <= d + l and to l; the
// size of coordinates does not come in.
//  - An edge's distance: the place t along it errs by less than 8u |q| / |e|, so its point by less
//    than 8u |q|; being the nearest point, that and what the difference rounds off, 6u (|q| + l),
//    bound the error of the distance.
//  - The plane's: the normal is known within 38u in each coordinate (unit_normal.h) whatever the
//    face's shape, hence within 66u as a vector, and the product with q adds 4u: below 70u |q|.
//  - Whether the point is above the face: by three triple products with that normal, each of which
//    errs by less than 76u |q| times its edge's length. So where one of them has the wrong sign the
//    foot of the point is off the face, or within it, by less than 76u |q|, and so much does the
//    distance change at most. (The edges from the first corner are at most as long as the third, so
//    what their rounding does to that is small against it.)
// The sum is below 160u (d + l) < 2^-45 (d + l).
// Source of the cases: Ericson, Real-Time Collision Detection (2005), 5.1.5, here without branches.
#pragma once

#include "vcg_ext/base/ids.h"
#include "vcg_ext/base/point.h"

#include <array>
#include <cstdint>

namespace index_boolean {

constexpr std::size_t kLanes = 4;
using FourNumbers = std::array<double, kLanes>;

// Four faces, each with its corners in the order of its shape: the corner opposite the longest edge
// first, then the other two in lexicographic order. Lanes without a face repeat the first one.
struct FaceBlock {
	std::array<FourNumbers, 3> origin;         // the first corner
	std::array<FourNumbers, 3> first, second;  // the edges from there
	std::array<FourNumbers, 3> normal;   // of length 1; NaN where edges are too short for squares
	std::array<FourNumbers, 3> inverse;  // of the squared lengths of first, second, and of the
	                                     // edge between their ends; 0 where those are too short
	std::array<std::uint32_t, kLanes> face;  // kNone: a lane without a face
};

// What is nearest in a face to a point; corners are in the order of the block.
enum class Feature : std::uint8_t { Face, First, Second, Third, Origin, FirstEnd, SecondEnd };

// The number of the place along an edge that is nearest to a point.
inline double placeAlong(double product, double inverse) {
	const double t = product * inverse;
	const double low = t < 0 ? 0 : t;
	return low > 1 ? 1 : low;
}

// The squared distances of a point from the four faces. Complexity: O(1).
[[gnu::always_inline]] inline void squaredDistances(const FaceBlock& f, const Point& point,
                                                    FourNumbers& out) {
	for (std::size_t k = 0; k < kLanes; ++k) {
		const double qx = point[0] - f.origin[0][k], qy = point[1] - f.origin[1][k],
		             qz = point[2] - f.origin[2][k];
		const double ax = f.first[0][k], ay = f.first[1][k], az = f.first[2][k];
		const double bx = f.second[0][k], by = f.second[1][k], bz = f.second[2][k];
		const double cx = bx - ax, cy = by - ay, cz = bz - az;
		const double rx = qx - ax, ry = qy - ay, rz = qz - az;
		const double nx = f.normal[0][k], ny = f.normal[1][k], nz = f.normal[2][k];
		const double atFirst =
		    nx * (ay * qz - az * qy) + ny * (az * qx - ax * qz) + nz * (ax * qy - ay * qx);
		const double atSecond =
		    nx * (qy * bz - qz * by) + ny * (qz * bx - qx * bz) + nz * (qx * by - qy * bx);
		const double atThird =
		    nx * (cy * rz - cz * ry) + ny * (cz * rx - cx * rz) + nz * (cx * ry - cy * rx);
		const double height = nx * qx + ny * qy + nz * qz;
		const double s = placeAlong(qx * ax + qy * ay + qz * az, f.inverse[0][k]);
		const double t = placeAlong(qx * bx + qy * by + qz * bz, f.inverse[1][k]);
		const double v = placeAlong(rx * cx + ry * cy + rz * cz, f.inverse[2][k]);
		const double sx = qx - s * ax, sy = qy - s * ay, sz = qz - s * az;
		const double tx = qx - t * bx, ty = qy - t * by, tz = qz - t * bz;
		const double vx = rx - v * cx, vy = ry - v * cy, vz = rz - v * cz;
		const double first = sx * sx + sy * sy + sz * sz;
		const double second = tx * tx + ty * ty + tz * tz;
		const double third = vx * vx + vy * vy + vz * vz;
		const double two = first < second ? first : second;
		const double edges = two < third ? two : third;
		const bool isAbove = (atFirst >= 0) & (atSecond >= 0) & (atThird >= 0);
		out[k] = isAbove ? height * height : edges;
	}
}

// The nearest point of one face.
struct NearestInFace {
	Feature feature;
	Point offset;  // from the nearest point to the one that was asked for
	double along;  // of an edge: the place on it, from 0 to 1
};

// The nearest point of the face in a lane of a block. Complexity: O(1).
NearestInFace nearestInFace(const FaceBlock& f, std::size_t lane, const Point& point);

}  // namespace index_boolean
