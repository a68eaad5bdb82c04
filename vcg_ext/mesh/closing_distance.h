// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: an operand that is not closed; out: a distance that closes it, if its border is a crack: its
// faces do not quite meet. It is advice for the user, and decides nothing.
#pragma once

#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/status.h"
#include "vcg_ext/mesh/mesh_arrays.h"

namespace index_boolean {

// Looks for the smallest of the numbers 1, 2 and 5 times powers of ten with which weldNearVertices
// leaves no edge of the operand with an odd number of faces. A distance that takes both ends of a
// border edge to one place is none, since that closes small holes, too; nor is one of more than a
// hundredth of the operand's diagonal.
// \param distance replaced: such a number, or 0 if there is none
// \pre all corners of the operand exist and are finite
// \return Ok or Cancelled. Throws std::bad_alloc.
// Complexity: O(n + d b) as expected, for b vertices at the border and d powers of ten between the
// smallest step of its coordinates and its size: 16 at most.
Status findClosingDistance(const MeshArrays& mesh, OperandId operand, Monitor& monitor,
                           double& distance);

}  // namespace index_boolean
