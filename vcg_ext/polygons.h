// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: triangles, some of whose edges are faux: inside a polygon that is one face to the user; out:
// which faces are one polygon, and, of a finished mesh, which of its edges are faux again.
// Guarantee: by indices alone, but for the question which faces lie in one plane, decided exactly.
// Nothing is done, and no memory taken, for meshes without faux edges.
#pragma once

#include "arrangement.h"
#include "monitor.h"
#include "sourced_mesh.h"
#include "status.h"

namespace index_boolean {

// Whether two input faces lie in one plane: +1 with their fronts to the same side, -1 with fronts
// to opposite sides; else 0. Exact. \pre both have area
int commonFront(const MeshArrays& mesh, FaceId a, FaceId b);

// Joins the faces of each operand to polygons, across edges that both their faces call faux; an
// edge that one face alone calls faux, or that has more than two faces, joins none.
// \pre arrangement.nonManifold is known
// \param arrangement its polygons are filled; its mesh.faux keeps those edges only that join
// \return Ok, Cancelled or OutOfMemory
// Complexity: O(n + k log k) for n faces and k faux edges, each operand on a thread.
Status joinPolygons(Arrangement& arrangement, Monitor& monitor);

// Fills mesh.faux: the faux edges of polygons of which all faces are there as they were; else those
// inside each set of neighbouring pieces of one polygon, if the set is a simple polygon.
// Where faces have been merged across polygons (options.mergeCoplanar) only the former.
// \param part per face: faces of different parts are no polygon together; empty: there is one part
// \param mesh finished, but for its faux edges
// \return Ok, Cancelled or OutOfMemory
// Complexity: O(n + k log k) for n faces, k of them in cut polygons.
Status findFauxEdges(const Arrangement& arrangement, const std::vector<std::uint32_t>& part,
                     Monitor& monitor, SourcedMesh& mesh);

}  // namespace index_boolean
