// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: a polygon of points that are nearly in one plane; out: triangles that fill it, as seen along
// an axis.
// Guarantee: decided by exact signs of the places; each triangle has area and turns the polygon's
// way; what is chosen depends on the corner that the polygon begins with, and on places, alone.
// Source: Meisters, "Polygons have ears" (1975).
#pragma once

#include "vcg_ext/base/point.h"

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace index_boolean {

// Corners counter-clockwise as seen against the axis if front is +1, along it if it is -1.
struct SeenPolygon {
	std::vector<Point> corners;
	int axis;
	int front;
};

// Fills a polygon, ear by ear, from its first corner on.
// \param mayCut whether a cut may run between two corners, given by their indices
// \param out    gets triangles of indices of corners; appended to
// \return whether it succeeded; if not, `out` means nothing. A polygon that crosses or touches
//         itself, as seen, has no answer, nor has one of more than 4096 corners
// Throws std::bad_alloc. Complexity: O(n^2) signs for n corners in most polygons, O(n^3) at most.
bool fillPolygon(const SeenPolygon& polygon,
                 const std::function<bool(std::size_t, std::size_t)>& mayCut,
                 std::vector<std::array<std::size_t, 3>>& out);

}  // namespace index_boolean
