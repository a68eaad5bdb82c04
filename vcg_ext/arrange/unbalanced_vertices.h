// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the faces of a surface of any kind; out: the ends of the edges that do not have as many faces
// each way. Guarantee: exact; no hash decides.
#pragma once

#include "vcg_ext/arrange/search_frame.h"

namespace index_boolean {

// Finds the vertices at which an edge is unbalanced.
// \param surface placed in the frame; its isUnbalanced is replaced
// \return Ok, Cancelled or OutOfMemory. Complexity: O(n) for vertices with few faces each,
// O(d log d) for one with d, in parallel; 12 bytes a corner.
Status findUnbalancedVertices(SearchedSurface& surface, Monitor& monitor);

}  // namespace index_boolean
