// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: a polygon in a plane, all of which is seen from one point of it; out: triangles that fill it.
// Guarantee: decided exactly; each triangle has area; what is chosen depends on the corner that the
// polygon begins with, and on places, alone.
#pragma once

#include "vcg_ext/exact/exact_sign.h"

#include <functional>

namespace index_boolean {

// Corners counter-clockwise around the centre, which lies inside, or on the edge from the last
// corner to the first.
struct StarPolygon {
	std::vector<ExactPoint> corners;
	ExactPoint centre;
	int axis;   // seen along which the plane has area
	int front;  // +1: counter-clockwise seen against the axis; -1: seen along it
};

// Fills a polygon, ear by ear, from its first corner on.
// \param isFree whether a cut may run between two corners, given by their indices
// \param out    gets triangles of indices of corners, counter-clockwise; appended to
// \return whether it succeeded; if not, `out` means nothing
// \pre three corners at least; their rounded coordinates are filled
// Complexity: O(n) signs for n corners in most polygons, O(n^2) at most.
bool fillStar(const StarPolygon& polygon,
              const std::function<bool(std::size_t, std::size_t)>& isFree,
              std::vector<std::array<std::size_t, 3>>& out);

}  // namespace index_boolean
