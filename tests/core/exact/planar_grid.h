// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points with integer coordinates, whose orientation is exact in 64 bits: for tests of the sweep.
#pragma once

#include <vcg_ext/exact/planar_sweep.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace index_boolean {

struct GridPoint {
	std::int64_t x, y;
	friend bool operator<(GridPoint a, GridPoint b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }
	friend bool operator==(GridPoint a, GridPoint b) { return a.x == b.x && a.y == b.y; }
};

// Twice the signed area of a triangle, exact for coordinates below 2^30.
inline std::int64_t area(GridPoint a, GridPoint b, GridPoint c) {
	return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Of points by rank; counts how often it is asked.
class GridOrientation : public PlanarOrientation {
public:
	explicit GridOrientation(const std::vector<GridPoint>& points) : points_(points) {}
	int operator()(std::uint32_t a, std::uint32_t b, std::uint32_t c) const override {
		++calls;
		const std::int64_t value = area(points_[a], points_[b], points_[c]);
		return (value > 0) - (value < 0);
	}
	mutable std::size_t calls = 0;

private:
	const std::vector<GridPoint>& points_;
};

// Its ends included.
inline bool onSegment(GridPoint p, GridPoint a, GridPoint b) {
	return area(a, b, p) == 0 && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) &&
	       std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y);
}

}  // namespace index_boolean
