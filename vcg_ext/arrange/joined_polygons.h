// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: both operands, some of whose edges are faux: inside a polygon that is one face to the user;
// out: which faces are one polygon, and which of those lie in one plane.
// Guarantee: by indices alone, but for the question which faces lie in one plane, decided exactly.
// Nothing is done, and no memory taken, for operands without faux edges.
#pragma once

#include "vcg_ext/arrange/arrangement.h"
#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/status.h"

namespace index_boolean {

// Whether two input faces lie in one plane: +1 with their fronts to the same side, -1 with fronts
// to opposite sides; else 0. Exact. \pre both have area
// Complexity: O(1); a few comparisons where both lie in one plane across an axis.
int commonFront(const MeshArrays& mesh, FaceId a, FaceId b);

// Joins the faces of each operand to polygons, across edges that both their faces call faux; an
// edge that one face alone calls faux, or that has more than two faces, joins none.
// \pre arrangement.nonManifold is known
// \param arrangement its polygons are filled; its mesh.faux keeps those edges only that join
// \return Ok, Cancelled or OutOfMemory
// Complexity: O(n + k log k) for n faces and k faux edges, in parallel.
Status joinPolygons(Arrangement& arrangement, Monitor& monitor);

// Edges as pairs of vertices: lower, higher.
using EdgeList = std::vector<std::array<VertexId, 2>>;

// Lists the edges that join two cut faces of one polygon within one plane. Any edge that does, and
// that the curve passes through, is among them: both of its faces are cut.
// \pre the faces have been cut
// \param out replaced: sorted
// \return Ok or Cancelled. Throws std::bad_alloc.
// Complexity: O(k) for k cut faces, as long as no vertex is in very many of them.
Status listFlatEdges(const Arrangement& arrangement, Monitor& monitor, EdgeList& out);

}  // namespace index_boolean
