// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the contacts of a soup and their points; out: the points inside their segments at which a
// third face meets both, and of these the ones that only three faces define.
// Guarantee: exact; every face of such a point finds it on each of its segments. Of two embedded
// operands no three faces are pairwise in contact, and nothing is found.
//
// Why looking at pairs of contacts is enough. The faces f, g meet in a segment, not along an edge
// of either. A point inside it at which the arrangement has a vertex lies in a third face k, which
// is then in contact with both. If it lies on an edge of f or k, it is a corner of the contact of
// these two; likewise of g and k. Else it is inside all three faces, and no two of their planes are
// the same there: then the segment of f and g crosses the plane of k strictly, and that of f and k
// the plane of g. Contacts in common corners only have been left out: a corner of f is an extreme
// point of f, so it is inside no segment in f.
#pragma once

#include "vcg_ext/arrange/triangle_contact.h"

namespace index_boolean {

// Appends the points of three faces to the curve, and fills contacts.inner.
// \param arrangement its curve has the points of the contacts (curve_points.h)
// \param vertexOfName per name in the contacts
// \return Ok, Cancelled, OutOfMemory; TooLarge if there are too many points
// Complexity: O(t log d) for t triples of faces pairwise in contact, d contacts of one face at
// most, in parallel.
Status findTripleContacts(Arrangement& arrangement, const std::vector<VertexId>& vertexOfName,
                          Monitor& monitor, Contacts& contacts);

}  // namespace index_boolean
