// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: a convex polygon in the plane with points and non-crossing edges inside it; out: triangles
// that cover it and contain every edge.
// Guarantee: O(n log n), only orientation signs of the points are asked for; holes, dangling edges,
// several components and isolated points are all right; the result depends on the geometry alone,
// and in each region that the edges part, on that region's alone.
// Source: the sweep of Hertel and Mehlhorn, "Fast triangulation of simple polygons" (1983), taken
// from polygons to any set of edges.
#pragma once

#include "vcg_ext/base/monitor.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace index_boolean {

// Edge between two points given by their ranks in lexicographic order.
struct PlanarEdge {
	std::uint32_t left, right;  // left < right
};

// Tells the side of the line a b on which c lies: +1 left of a to b, 0 on it. Points are ranks.
class PlanarOrientation {
public:
	virtual ~PlanarOrientation() = default;
	virtual int operator()(std::uint32_t a, std::uint32_t b, std::uint32_t c) const = 0;
};

// Triangulates one polygon after another, with reused buffers. One object for each thread.
class PlanarSweep {
public:
	PlanarSweep();
	~PlanarSweep();

	// \param pointCount  points are 0 .. pointCount-1, sorted lexicographically, all different
	// \param edges       the polygon's sides (cut at the points on them) and the inner edges; each
	//                    once, in any order; they meet in common end points only, and no point lies
	//                    inside an edge
	// \param orientation the exact orientation of three points
	// \param triangles   replaced: counter-clockwise triples of ranks
	// \param monitor     asked now and then, as a polygon may have any number of points
	// \return false if the run is cancelled, or if the input breaks the above, as far as noticed;
	// triangles are then meaningless
	bool triangulate(std::uint32_t pointCount, const std::vector<PlanarEdge>& edges,
	                 const PlanarOrientation& orientation, Monitor& monitor,
	                 std::vector<std::array<std::uint32_t, 3>>& triangles);

private:
	class Line;
	std::unique_ptr<Line> line_;
};

}  // namespace index_boolean
