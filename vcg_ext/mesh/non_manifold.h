// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: a closed surface; out: the vertices at which it is not a manifold. Guarantee: exact, by
// indices alone.
#pragma once

#include "vcg_ext/mesh/mesh_arrays.h"

#include <vector>

namespace index_boolean {

// The vertices [begin, end).
struct VertexRange {
	std::uint32_t begin, end;
};

// Finds the vertices of a range whose faces are not one umbrella: the edges opposite the vertex,
// one in each of its faces, are not one cycle that visits each vertex once. That is so at both ends
// of an edge with more than two faces, and where parts of the surface meet at a vertex alone.
// \param begin, end closed, consistently oriented triangles; no corner twice in one of them
// \param out        appended to, ascending
// Complexity: O(n) as expected. 8 bytes a corner in range.
void findNonManifoldVertices(const Triangle* begin, const Triangle* end, VertexRange range,
                             std::vector<VertexId>& out);

// Whether each vertex of a range that has faces has three or more, in one umbrella that closes. If
// that is so for all vertices, the surface is closed, consistently oriented and a manifold, and no
// two faces have the same corners.
// \param begin, end triangles of any kind; no corner twice in one of them
// Complexity: as above.
bool isClosedManifold(const Triangle* begin, const Triangle* end, VertexRange range);

}  // namespace index_boolean
