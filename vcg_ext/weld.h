// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: contacts by name; out: the curve: one numbering for all points, their coordinates, their
// order along each input edge, and each segment once. Guarantee: equal names become one point; the
// order along an edge is exact; coordinates are the exact points correctly rounded, hence in the
// same order. Source: Mei & Tipper 2013, step 3, by names instead of distances.
#pragma once

#include "arrangement.h"
#include "exact_sign.h"
#include "monitor.h"
#include "status.h"
#include "triangle_contact.h"

namespace index_boolean {

// The simplices that define a vertex or a curve point; borrows the arrangement's points.
// \param vertex an input vertex or a numbered curve point
ExactPoint exactPoint(const Arrangement& arrangement, VertexId vertex);

// An order of vertices that depends on their places only: by the rounded coordinates,
// lexicographically, then, if all three are equal, by the exact ones. \return -1, 0, +1
int comparePlaces(const Arrangement& arrangement, VertexId a, VertexId b);

// A vertex's coordinates as they are delivered: the exact point, rounded once to the output scalar.
Point outputCoordinates(const Arrangement& arrangement, VertexId vertex);

// Fills arrangement.curve.
// \return Ok, Cancelled, OutOfMemory, InternalError; SelfIntersecting if two faces of one operand
//         pierce an edge in one point
// Complexity: O(c log c) for c contacts.
Status weldPoints(Arrangement& arrangement, const Contacts& contacts, Monitor& monitor);

}  // namespace index_boolean
