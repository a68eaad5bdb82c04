// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// With u the unit roundoff and offsets within u of themselves: a component of a cross product errs
// by less than 4.2u times its size (see RoundedNormal), a product with an offset by 2u more, the
// sums by 2u: in all less than 9u times the sum of sizes. The normal of a plane along a side is the
// cross product of a vector, which may be any and is taken as it is, and the side. No offset is
// larger than kLargest or, along all axes, smaller than 1 / kLargest: four of them multiplied do
// not overflow, and what underflows is, multiplied by two of them, far less than kFloor.
#include "vcg_ext/arrange/star_planes.h"

#include "vcg_ext/exact/exact_sign.h"

#include <algorithm>
#include <cmath>

namespace index_boolean {

namespace {

constexpr double kLargest = 0x1p200;
constexpr double kFloor = 0x1p-600;

using Vector = std::array<double, 3>;

// A cross product, and the size of each component's terms.
struct Cross {
	Vector value, size;

	Cross(const Vector& a, const Vector& b) : value{}, size{} {
		for (std::size_t k = 0; k < 3; ++k) {
			const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
			const double left = a[i] * b[j], right = a[j] * b[i];
			value[k] = left - right;
			size[k] = std::fabs(left) + std::fabs(right);
		}
	}
};

constexpr std::uint64_t bit(std::size_t i) { return std::uint64_t{1} << i; }

}  // namespace

// The index of a corner among those of the star.
std::size_t StarPlanes::indexOf(std::uint32_t corner) {
	const auto found = std::find(corners_.begin(), corners_.end(), corner);
	const auto index = static_cast<std::size_t>(found - corners_.begin());
	if (found == corners_.end()) {
		corners_.push_back(corner);
	}
	return index;
}

bool StarPlanes::take(const FacesView& surface, std::uint32_t vertex,
                      const std::vector<std::uint32_t>& faces) {
	if (faces.size() > kMostFaces) {
		return false;
	}
	corners_.clear();
	ends_.clear();
	for (const std::uint32_t face : faces) {
		const IndexTriangle t = surface[face];
		const std::size_t at = t[0] == vertex ? 0 : t[1] == vertex ? 1 : 2;
		const std::size_t first = indexOf(t[(at + 1) % 3]), second = indexOf(t[(at + 2) % 3]);
		ends_.push_back({static_cast<std::uint8_t>(first), static_cast<std::uint8_t>(second)});
	}
	if (!placeCorners(surface, vertex)) {
		return false;
	}
	planes_.resize(faces.size());
	for (std::size_t face = 0; face < faces.size(); ++face) {
		findOwnPlane(face);
	}
	return true;
}

// \return false if there are too many corners, or one is too near or too far
bool StarPlanes::placeCorners(const FacesView& surface, std::uint32_t vertex) {
	if (corners_.size() > offset_[0].size()) {
		return false;
	}
	const Point& origin = surface.point(vertex);
	bool areInRange = true;
	for (std::size_t i = 0; i < corners_.size(); ++i) {
		const Point& p = surface.point(corners_[i]);
		double largest = 0;
		for (std::size_t axis = 0; axis < 3; ++axis) {
			offset_[axis][i] = p[axis] - origin[axis];
			largest = std::max(largest, std::fabs(offset_[axis][i]));
		}
		perLength_[i] =
		    1 / std::sqrt(offset_[0][i] * offset_[0][i] + offset_[1][i] * offset_[1][i] +
		                  offset_[2][i] * offset_[2][i]);
		areInRange = areInRange && largest <= kLargest && largest >= 1 / kLargest;
	}
	return areInRange;
}

StarPlanes::Sides StarPlanes::sidesOf(const Vector& normal, const Vector& size) const {
	Sides sides{0, 0};
	for (std::size_t i = 0; i < corners_.size(); ++i) {
		const double x = offset_[0][i], y = offset_[1][i], z = offset_[2][i];
		const double value = normal[0] * x + normal[1] * y + normal[2] * z;
		const double bound =
		    16 * kRoundoff *
		        (size[0] * std::fabs(x) + size[1] * std::fabs(y) + size[2] * std::fabs(z)) +
		    kFloor;
		sides.above |= std::uint64_t{value > bound} << i;
		sides.below |= std::uint64_t{value < -bound} << i;
	}
	return sides;
}

// The corners that lie beyond the plane spanned by a normal and a side, seen from a third corner:
// none if that may lie in the plane.
StarPlanes::Corners StarPlanes::beyond(const Vector& normal, std::size_t along,
                                       Corners third) const {
	const Cross across(normal, {offset_[0][along], offset_[1][along], offset_[2][along]});
	const Sides sides = sidesOf(across.value, across.size);
	return (sides.above & third) != 0 ? sides.below : (sides.below & third) != 0 ? sides.above : 0;
}

void StarPlanes::findOwnPlane(std::size_t face) {
	const auto [a, b] = ends_[face];
	const Cross normal({offset_[0][a], offset_[1][a], offset_[2][a]},
	                   {offset_[0][b], offset_[1][b], offset_[2][b]});
	const Sides sides = sidesOf(normal.value, normal.size);
	Vector middle{};
	for (std::size_t axis = 0; axis < 3; ++axis) {
		middle[axis] = offset_[axis][a] * perLength_[a] + offset_[axis][b] * perLength_[b];
	}
	planes_[face] = {normal.value, middle, bit(a), bit(b), sides.above, sides.below, 0, 0, false};
}

// A product of the way and an offset, whose error is the offset's, errs by less than 4.1u.
bool StarPlanes::middlePlaneParts(std::size_t i, std::size_t j) const {
	Vector way{};
	for (std::size_t axis = 0; axis < 3; ++axis) {
		way[axis] = planes_[j].middle[axis] - planes_[i].middle[axis];
	}
	const auto isAhead = [this, &way](std::size_t corner, double sign) {
		double value = 0, size = 0;
		for (std::size_t axis = 0; axis < 3; ++axis) {
			const double term = way[axis] * offset_[axis][corner];
			value += term;
			size += std::fabs(term);
		}
		return sign * value > 8 * kRoundoff * size + kFloor;
	};
	return isAhead(ends_[j][0], 1) && isAhead(ends_[j][1], 1) && isAhead(ends_[i][0], -1) &&
	       isAhead(ends_[i][1], -1);
}

void StarPlanes::findSides(std::size_t face) {
	Planes& planes = planes_[face];
	planes.beyondFirst = beyond(planes.normal, ends_[face][0], planes.second);
	planes.beyondSecond = beyond(planes.normal, ends_[face][1], planes.first);
	planes.hasSides = true;
}

}  // namespace index_boolean
