// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: triangles, some of which are parts of polygons; out: how many of the polygons were cut into
// triangles that lie on each other, as fans of concave polygons do. It is a remark for the user,
// and decides nothing.
#pragma once

#include "vcg_ext/mesh/mesh_arrays.h"

namespace index_boolean {

// The number of polygons of an operand in which two neighbouring triangles are folded over the edge
// that parts them: their normals, as rounded, point away from each other.
// Throws std::bad_alloc. Complexity: O(n log n); O(1) if there is no polygon.
std::size_t countFoldedFans(const MeshArrays& mesh, OperandId operand);

}  // namespace index_boolean
