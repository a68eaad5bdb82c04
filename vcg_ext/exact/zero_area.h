// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: faces as stored; out: which of them have exactly no area, that is, the exact cross product
// of their stored coordinates is zero. Guarantee: decided exactly for all finite doubles, however
// small or large; a face is never judged by its size.
#pragma once

#include "vcg_ext/base/mesh_types.h"
#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/status.h"

#include <vector>

namespace index_boolean {

// The faces [begin, end).
struct FaceRange {
	std::size_t begin, end;
};

// True if a, b and c lie on one line or coincide. \pre finite. Complexity: O(1), mostly 8 flops.
bool hasZeroArea(const Point& a, const Point& b, const Point& c);

// Finds the zero-area faces of a range.
// \param points    finite
// \param triangles indices into points
// \param threads   0: as many as there are
// \param out       replaced by the indices of the zero-area faces, ascending
// \return Ok, Cancelled, OutOfMemory or InternalError
// Complexity: O(end - begin), in parallel.
Status findZeroAreaFaces(const Points& points, const IndexTriangles& triangles, FaceRange range,
                         int threads, Monitor& monitor, std::vector<std::uint32_t>& out);

// The same among the faces listed in `candidates` (ascending, each once).
// \return as above. Complexity: O(candidates), in parallel.
Status findZeroAreaFacesAmong(const std::vector<std::uint32_t>& candidates, const Points& points,
                              const IndexTriangles& triangles, int threads, Monitor& monitor,
                              std::vector<std::uint32_t>& out);

}  // namespace index_boolean
