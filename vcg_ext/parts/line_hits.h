// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: lines along the axes; out: the triangles of the arrangement that each meets, in the order in
// which it meets them. Guarantee: exact; a line never meets an edge, since it is moved
// symbolically: its place p becomes p + (e, e^2) with an infinitely small e > 0.
#pragma once

#include "vcg_ext/arrange/surface_complex.h"

namespace index_boolean {

// A line along `axis`, through a place whose coordinate there does not count.
struct AxisLine {
	int axis;
	Point place;
};

struct LineHit {
	std::uint32_t line;
	std::uint32_t face;  // of the complex
	bool facesUp;        // its front lies on the side of larger coordinates along the axis
};

// The side of the edge from a to b on which a line passes: +1 to its left as seen against the axis.
// Zero only if the edge has the line's direction.
int sideOfLine(const Arrangement& arrangement, VertexId a, VertexId b, const AxisLine& line);

// Whether a line meets a triangle: +1 if that faces up, -1 if down, 0 if the line misses it.
int meets(const Arrangement& arrangement, const AxisLine& line, const Triangle& corners);

// Finds all faces that lines meet.
// \param hits replaced; by line, then along it
// \return Ok, Cancelled, OutOfMemory, InternalError; SelfIntersecting if a line meets two faces in
//         one place, which then overlap
// Complexity: O(n + l log l + h log h) for n faces, l lines and h hits, for faces as small as the
// distances between lines; a line costs one test for each face with a box that it meets.
Status castLines(const Arrangement& arrangement, const SurfaceComplex& complex,
                 const std::vector<AxisLine>& lines, Monitor& monitor, std::vector<LineHit>& hits);

}  // namespace index_boolean
