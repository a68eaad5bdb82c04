// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: both operands, with common vertices where they coincide; out: the faces that both have and
// that lie among such faces only. They need no search for contacts: any other face of either
// operand meets them in common vertices and edges, which are known.
// Guarantee: by indices alone; what is not marked is decided by the stages that follow.
#pragma once

#include "vcg_ext/arrange/arrangement.h"
#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/status.h"

namespace index_boolean {

// Fills mesh.quietFaces and mesh.quietVertices; leaves them empty if there is no such face.
// \return Ok, Cancelled or OutOfMemory
// Complexity: O(n) in one pass if no vertex is common to both operands; else a look-up a face.
Status findCoincidentFaces(Arrangement& arrangement, Monitor& monitor);

}  // namespace index_boolean
