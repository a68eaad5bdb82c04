// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: numbered points of contact; out: their order along each input edge, each segment between them
// once, and which of them are irregular. Guarantee: the order along an edge is exact.
// Source: Mei & Tipper 2013, step 3.
#pragma once

#include "vcg_ext/arrange/arrangement.h"
#include "vcg_ext/arrange/triangle_contact.h"
#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/status.h"

namespace index_boolean {

// Fills cutEdges, pointsOnEdges, segments, faceSegments, faceVertices and irregular of
// arrangement.curve.
// \param vertexOfName per name in the contacts, as curve_points.h numbers them
// \return Ok, Cancelled, OutOfMemory, InternalError; TooLarge if points on edges, their intervals,
//         or lines are more than numbers of 32 bits tell; SelfIntersecting if two faces of one
//         operand pierce an edge in one point
// Complexity: O(c log c) for c contacts.
Status findCutLines(Arrangement& arrangement, const Contacts& contacts,
                    const std::vector<VertexId>& vertexOfName, Monitor& monitor);

}  // namespace index_boolean
