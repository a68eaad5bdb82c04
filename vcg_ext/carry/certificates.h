// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: a mesh as it is delivered, in the scalar that it is stored in; out: whether it holds.
// It holds if, vertices in one place being one, no two faces have a point in common that is not a
// common vertex or on a common edge of both, and no face is flat.
// Guarantee: exact, of the coordinates as stored; by pairs of faces, so that closedness is no part
// of it. Supposed is that neither operand meets itself: pairs of faces none of which has a rounded
// corner are not asked again.
#pragma once

#include "vcg_ext/arrange/arrangement.h"
#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/status.h"
#include "vcg_ext/mesh/sourced_mesh.h"

namespace index_boolean {

// Finds the faces that meet others wrongly, and flat ones.
// \param mesh  read from the arrangement, cleaned, before its vertices part at seams
// \param part  per face; empty if all are one. Each part is judged by itself
// \param isAsCut its faces are those of the refined operands, none merged, cleaned or flipped
// since:
//              what repair_places has found of all of them is true of these
// \param out   replaced; not known with options.certify off
// \return Ok, Cancelled, OutOfMemory, InternalError
// Complexity: one pass over the faces, then that of findWrongPairsNearSuspects. In parallel.
Status certify(const Arrangement& arrangement, const SourcedMesh& mesh,
               const std::vector<std::uint32_t>& part, bool isAsCut, Monitor& monitor,
               Certificate& out);

}  // namespace index_boolean
