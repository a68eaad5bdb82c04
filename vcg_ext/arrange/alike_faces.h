// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: a soup's operands, some of whose faces may be turned wrongly; out: neighbours turned alike.
// Guarantee: by indices, but for the areas that say which way most of a part is turned; the same in
// any numbering. Left alone is an operand that is closed, if only once vertices that hang on edges
// part these, that has an edge with an odd number of faces, or that would not be closed then.
#pragma once

#include "vcg_ext/arrange/arrangement.h"
#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/status.h"

namespace index_boolean {

// Turns faces of operands that are not closed but have an even number of faces at each edge: what
// hangs together across edges with two faces runs one way then, the way that most of its area does,
// or, of two halves, the way that encloses more; if neither does, the way of the faces that come
// first by the places of their corners. A part that has one side only stays as it is. Where
// vertices hang on edges, two copies of a part look like one that is turned wrongly, but are closed
// as cut.
// \param arrangement of a soup; closed is known by edges, and changed; turnedAlike is filled
// \return Ok, Cancelled, OutOfMemory
// Complexity: O(n log n) for n faces of such operands.
Status turnFacesAlike(Arrangement& arrangement, Monitor& monitor);

}  // namespace index_boolean
