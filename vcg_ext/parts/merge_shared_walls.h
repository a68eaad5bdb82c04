// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the sub-surfaces of an arrangement, and options.mergeTolerance; out: other triangles in their
// place, as few as the tolerance allows (merge_near_coplanar.h, which has the guarantees).
// Guarantee: a wall of two pieces is merged once, and both have the same triangles; nothing is
// merged across a difference of sub-surfaces, face classes or polygons.
#pragma once

#include "vcg_ext/parts/sub_surfaces.h"

namespace index_boolean {

// Merges the walls of all sub-surfaces.
// \param surfaces gets stored triangles, and says in wallMerge what has been done; stays as it is
//                 if nothing can be merged
// \return Ok, Cancelled, OutOfMemory, InternalError. Throws std::bad_alloc.
// Complexity: O(1) if there is no tolerance; else that of mergeNearCoplanar for all triangles.
Status mergeSharedWalls(const Arrangement& arrangement, Monitor& monitor, SubSurfaces& surfaces);

}  // namespace index_boolean
