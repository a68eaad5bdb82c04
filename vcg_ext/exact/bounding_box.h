// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: points; out: their axis-parallel box. Guarantee: exact; always finite, since coordinates that
// are not finite (of a vertex that no face uses) do not count.
#pragma once

#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/point.h"
#include "vcg_ext/base/status.h"

#include <cstddef>
#include <limits>

namespace index_boolean {

// All points between lo and hi, both included.
struct BoundingBox {
	Point lo, hi;

	bool empty() const { return !(lo[0] <= hi[0] && lo[1] <= hi[1] && lo[2] <= hi[2]); }

	// The middle, without overflow.
	Point centre() const;

	// Half of the longest side, without overflow.
	double halfSize() const;

	// Takes a point in; its coordinates are numbers.
	void add(const Point& point) {
		for (std::size_t axis = 0; axis < 3; ++axis) {
			lo[axis] = point[axis] < lo[axis] ? point[axis] : lo[axis];
			hi[axis] = point[axis] > hi[axis] ? point[axis] : hi[axis];
		}
	}
};

// The box of no point.
constexpr BoundingBox emptyBox() {
	constexpr double kMax = std::numeric_limits<double>::max();
	return {{kMax, kMax, kMax}, {-kMax, -kMax, -kMax}};
}

// The box of `count` boxes, which may be empty. Complexity: O(count).
BoundingBox joinedBox(const BoundingBox* boxes, std::size_t count);

// The box of `count` points; empty if there are none.
// \return Ok or Cancelled. Complexity: O(count), in parallel.
Status findBoundingBox(const Point* points, std::size_t count, int threads, Monitor& monitor,
                       BoundingBox& out);

// The points that lie in both boxes. Complexity: O(1).
BoundingBox commonBox(const BoundingBox& a, const BoundingBox& b);

}  // namespace index_boolean
