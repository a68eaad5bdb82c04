// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: both operands as given; out: the same welded by exact coordinates, free of degenerate and
// duplicate faces, closed, consistently oriented and right side out, or a refusal that names the
// first defect. Guarantee: no coordinate is changed; -0.0 equals 0.0; what is dropped leaves the
// surface closed.
#pragma once

#include "vcg_ext/arrange/arrangement.h"
#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/status.h"

namespace index_boolean {

// Checks and prepares arrangement.mesh in place; fills faceGiven, closed, insideOut, duplicates
// and volume.
// \return Ok, Cancelled, OutOfMemory, EmptyOperand, NotFinite, BeyondFloat, IndexOutOfRange,
//         TooLarge, NotClosed, NotOriented, NoVolume, SelfIntersecting
// Complexity: O(n); the exact volume sign, needed only next to zero, is O(n) big numbers.
Status prepareOperands(Arrangement& arrangement, Monitor& monitor);

// The same for surfaces of any kind, which may be open: checked, welded, free of degenerate faces,
// each face once. None is turned. Fills faceGiven, closed, duplicates and, of closed operands,
// insideOut and volume.
// \return Ok, Cancelled, OutOfMemory, EmptyOperand, NotFinite, BeyondFloat, IndexOutOfRange,
//         TooLarge
// Complexity: O(n), in parallel.
Status prepareSurfaces(Arrangement& arrangement, Monitor& monitor);

// The same for any number of surfaces of any kind, which may meet themselves and have faces more
// than once: a soup. Checked, welded, free of degenerate faces. No operand is turned, but faces are
// that run against their neighbours (alike_faces.h); nothing that has area is dropped, but repeated
// faces without which the operand is closed. Fills faceGiven, isSoup, closed (by the input's
// edges), nonManifold: where what is at a vertex is not one umbrella of one operand; and volume:
// what the faces enclose, as they are turned, which tells nothing where the operand is open.
// \return Ok, Cancelled, OutOfMemory, EmptyOperand, NotFinite, BeyondFloat, IndexOutOfRange,
//         TooLarge
// Complexity: O(n) as expected.
Status prepareSoup(Arrangement& arrangement, Monitor& monitor);

}  // namespace index_boolean
