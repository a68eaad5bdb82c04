// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the arrays of any number of operands; out: faces whose corners in one place are one vertex.
// Guarantee: by equality of coordinates alone (0 is -0); only vertices that faces use count, and
// the first of them stands for all. (corner_weld.h does two operands, and faster.)
#pragma once

#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/status.h"
#include "vcg_ext/mesh/mesh_arrays.h"

namespace index_boolean {

// Replaces each corner by the first vertex of its operand with the same coordinates.
// \param welded replaced: which operands have two vertices in one place
// \pre all corners exist and are finite
// \return Ok or Cancelled: then some operands are as they were. Throws std::bad_alloc.
// Complexity: O(n) as expected.
Status weldEachOperand(MeshArrays& mesh, Monitor& monitor, PerOperand<bool>& welded);

// Replaces each corner by the first vertex of all with the same coordinates.
// \pre as above \return as above. Complexity: as above.
Status weldOperandsTogether(MeshArrays& mesh, Monitor& monitor);

}  // namespace index_boolean
