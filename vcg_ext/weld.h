// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: segments between named points; out: the curve with one numbering for all points, their
// coordinates, and their order along each input edge.
// Guarantee: equal names become one point; the order along an edge is exact; coordinates are the
// exact points correctly rounded, hence in the same order.
// Source: Mei & Tipper 2013, step 3, by names instead of distances.
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

// Fills arrangement.curve.
// \param segments any order
// \return Ok, Cancelled, OutOfMemory, InternalError; SelfIntersecting if two faces of one operand
//         pierce an edge in one point
// Complexity: O(s log s) for s segments.
Status weldPoints(Arrangement& arrangement, const std::vector<NamedSegment>& segments,
                  Monitor& monitor);

}  // namespace index_boolean
