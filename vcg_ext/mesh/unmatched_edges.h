// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: triangles; out: the edges that do not occur as often as their reverse. Guarantee: exact; what
// the boundary's checksum tells at once, with places.
#pragma once

#include "vcg_ext/base/mesh_types.h"
#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/status.h"

#include <array>
#include <vector>

namespace index_boolean {

// The edges at which a surface is not closed or not consistently oriented.
struct UnmatchedEdges {
	std::size_t borderEdges = 0;          // with an odd number of faces
	std::size_t conflictingEdges = 0;     // with an even number, not as many each way
	std::array<VertexId, 2> firstEdge{};  // of the borders if any, else of the conflicts
	std::vector<std::uint32_t> faces;     // at these edges, counted from `begin`; ascending
};

// Finds all unmatched edges of the triangles [begin, end). "First" is by smaller, then by larger
// vertex. Complexity: O(n log n), for surfaces that are refused.
void findUnmatchedEdges(const Triangle* begin, const Triangle* end, UnmatchedEdges& out);

// The number of unmatched edges, of either kind, of triangles that index points.
// \return Ok or Cancelled. Throws std::bad_alloc. Complexity: O(n), in parallel, if there are none;
// else O(n log n).
Status countUnmatchedEdges(const IndexTriangles& triangles, int threads, Monitor& monitor,
                           std::size_t& count);

}  // namespace index_boolean
