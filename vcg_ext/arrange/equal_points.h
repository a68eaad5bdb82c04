// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the points of a soup by their names; out: the same with one number for each place.
// Guarantee: exact. Equal points are rounded alike, so that only points with equal rounded
// coordinates need be compared. The smallest name stands for all of one place, an input vertex
// before new points.
#pragma once

#include "vcg_ext/arrange/triangle_contact.h"

namespace index_boolean {

// Merges the points of the curve that lie in one place, with each other and with input vertices in
// contact; renumbers them in the contacts.
// \param vertexOfName per name in the contacts
// \return Ok, Cancelled, OutOfMemory
// Complexity: O(c log c) for c points, and a comparison for each two with equal rounded
// coordinates.
Status mergeEqualPoints(Arrangement& arrangement, Monitor& monitor, Contacts& contacts,
                        std::vector<VertexId>& vertexOfName);

}  // namespace index_boolean
