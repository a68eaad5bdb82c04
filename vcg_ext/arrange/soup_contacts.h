// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: a prepared soup; out: where its faces meet, within operands and between any two.
// Guarantee: all contacts but those in common corners and edges only; these part no face, and a
// vertex at which surfaces meet like that is in arrangement.nonManifold.
#pragma once

#include "vcg_ext/arrange/triangle_contact.h"

namespace index_boolean {

// Finds all contacts of a soup, and counts the faces that meet others of their own operand: fills
// arrangement.selfIntersecting. Of two edges that cross, names have the smaller one first. Where
// two operands have an edge in common, and no contact of theirs shows it, it is a contact too: the
// curve runs along it.
// \param out replaced; in the order of the pairs of faces
// \return Ok, Cancelled, OutOfMemory, InternalError; TooLarge if there are too many pairs
// Complexity: as findWrongPairs (wrong_pairs.h), and O(p) for p pairs that meet.
Status findSoupContacts(Arrangement& arrangement, Monitor& monitor, Contacts& out);

// Whether the point that a name stands for lies on an edge, as far as the name tells: as a corner
// of it, or inside it. \param edge lower, higher vertex. Complexity: O(1).
bool isOnEdge(const PointName& name, const std::array<VertexId, 2>& edge);

// An edge of one of two faces along which a line between two of their common points runs; as its
// lower and higher vertex, none() if it runs through the inside of both faces.
// \param a, b names of the points, as the contact of the two faces gives them. Complexity: O(1).
std::array<VertexId, 2> edgeAlong(const MeshArrays& mesh, FacePair faces, const PointName& a,
                                  const PointName& b);

}  // namespace index_boolean
