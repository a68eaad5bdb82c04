// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: a finished mesh, and which input faces are one polygon; out: which of the mesh's edges are
// faux again. Guarantee: by indices alone; a set of pieces is one polygon only if it is a simple
// one. Nothing is done, and no memory taken, for operands without faux edges.
#pragma once

#include "vcg_ext/arrange/arrangement.h"
#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/status.h"
#include "vcg_ext/mesh/sourced_mesh.h"

namespace index_boolean {

// Fills mesh.faux: the faux edges of polygons of which all faces are there as they were; else those
// inside each set of neighbouring pieces of one polygon, if the set is a simple polygon.
// Where faces have been merged across polygons (options.mergeCoplanar) only the former.
// \param part per face: faces of different parts are no polygon together; empty: there is one part,
//             and the mesh is closed
// \param mesh finished, but for its faux edges
// \return Ok, Cancelled or OutOfMemory
// Complexity: O(n + k log k) for n faces, k of them in cut polygons at their borders or in several
// parts.
Status findFauxEdges(const Arrangement& arrangement, const std::vector<std::uint32_t>& part,
                     Monitor& monitor, SourcedMesh& mesh);

}  // namespace index_boolean
