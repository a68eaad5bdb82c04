// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: operands as given, some of which may be cracked: their faces do not quite meet; out: the same
// with vertices that are near to each other in one place. Guarantee: exact; only vertices that
// faces use count; the same places for any numbering. No face is taken away here, and none is
// turned: what falls together, the preparation of the operands welds and cleans.
#pragma once

#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/status.h"
#include "vcg_ext/mesh/mesh_arrays.h"

namespace index_boolean {

// What became of vertices that were near to others.
struct VertexWeld {
	std::size_t moved = 0;   // vertices that have another place than they were given in
	double largestMove = 0;  // how far one was moved
};

// Moves the vertices of each operand that are linked by distances below `distance` to the place of
// the lexicographically smallest of them. Corners that do not exist, and vertices that are not
// finite, are left as they are.
// \param distance 0, for nothing to be done, or more; finite
// \return Ok, Cancelled; WeldTooWide of the first operand that has a group of vertices, two of
//         which are farther from each other than twice the distance, with the faces at such groups
// Throws std::bad_alloc. Complexity: O(n) as expected; see exact/point_groups.h.
Status weldNearVertices(double distance, Monitor& monitor, MeshArrays& mesh, VertexWeld& out);

}  // namespace index_boolean
