// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: corners of triangles of the arrangement, each with a line upwards (axis_lines.h) from inside
// the triangle, infinitely near to the corner; out: the triangles that each line meets there, and
// the first one beyond. Guarantee: exact.
#pragma once

#include "vcg_ext/arrange/surface_complex.h"

namespace index_boolean {

// The axis of the lines: x, so that what lies above has a greater place in lexicographic order.
constexpr int kLineAxis = 0;

struct LineStart {
	std::uint32_t face;    // of the complex
	std::uint32_t corner;  // of the face
};

struct LineHit {
	std::uint32_t line;
	std::uint32_t face;  // of the complex
	bool facesUp;        // it is met from behind
	bool isBeyond;       // its plane does not hold the start's corner; the last one of its line
};

// Finds what lies above the starts: of the faces whose planes hold the start's corner, all that the
// line meets, and of the others the one that it meets first.
// \param hits replaced; by line, then along it, beginning with the face of the start
// \return Ok, Cancelled, OutOfMemory, InternalError; SelfIntersecting if a line meets two faces of
//         one plane in one place, which then overlap
// Complexity: O(n + k log k + l log k) for n faces of which k lie above any of l starts, where
// boxes of faces on a line rarely overlap along it. Memory: O(k + hits).
Status findLineHits(const Arrangement& arrangement, const SurfaceComplex& complex,
                    const std::vector<LineStart>& starts, Monitor& monitor,
                    std::vector<LineHit>& hits);

}  // namespace index_boolean
