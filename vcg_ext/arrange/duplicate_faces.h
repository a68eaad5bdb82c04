// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: both operands, welded, without collapsed faces; out: the same without faces that are there
// more than once. Guarantee: for blocks, what is dropped leaves each directed edge matched as well
// as before; else, what is left covers the same points.
#pragma once

#include "vcg_ext/arrange/arrangement.h"
#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/status.h"

namespace index_boolean {

// Drops, within each operand, faces on the same three vertices: a face and its opposite cancel;
// equal faces are counted once if the operand is closed that way. An operand that is closed with
// all of them only overlaps itself there, and is refused; one that is open in both ways keeps them.
// An operand of which nothing would be left stays as it is: it encloses nothing.
// \param arrangement its mesh, faceGiven and duplicates are changed, if there are any
// \return Ok, Cancelled, OutOfMemory; SelfIntersecting with the equal faces
// Complexity: O(n + d log d) for n faces and d duplicates, each operand on a thread.
Status removeDuplicateFaces(Arrangement& arrangement, Monitor& monitor);

// Drops, within each operand, all but one of the faces on the same three vertices, whatever way
// they are turned: what is left covers the same points. The one that is kept depends on coordinates
// only. Counted as taken once. \return Ok, Cancelled, OutOfMemory
// Complexity: as above.
Status takeDuplicateFacesOnce(Arrangement& arrangement, Monitor& monitor);

// Drops, within each operand of a soup that is not closed but would be so, all but one of equal
// faces, which are counted as taken once; the operand is closed then. All others stay, since a
// soup's faces count as often as they are there.
// \pre closed is known, by edges. \return Ok, Cancelled, OutOfMemory. Complexity: as above.
Status takeRepeatedFacesOnce(Arrangement& arrangement, Monitor& monitor);

// The number of pairs of faces on the same three vertices that an operand consists of; 0 if it has
// any other face. The faces of a pair are turned against each other, as those of a double-sided
// model are; or in any way, as they cancel under the winding rule Odd.
// Throws std::bad_alloc. Complexity: O(n log n), for operands that enclose nothing.
std::size_t cancellingPairs(const MeshArrays& mesh, OperandId operand, bool inAnyWay);

}  // namespace index_boolean
