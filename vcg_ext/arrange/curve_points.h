// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: contacts by name; out: one numbering for all points of contact, and the coordinates of the
// new ones. Guarantee: equal names become one point; coordinates are the exact points correctly
// rounded, hence in the same order. Source: Mei & Tipper 2013, step 3, by names instead of
// distances.
#pragma once

#include "vcg_ext/arrange/arrangement.h"
#include "vcg_ext/arrange/triangle_contact.h"
#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/status.h"

namespace index_boolean {

// Fills names, rounded, onOther and touchedFaces of arrangement.curve.
// \param vertexOfName replaced; per name in the contacts, the vertex or point it stands for
// \return Ok, Cancelled, OutOfMemory, InternalError; TooLarge if contacts, or points with the input
//         vertices, are more than options.mostElements
// Complexity: O(c log c) for c contacts.
Status numberCurvePoints(Arrangement& arrangement, const Contacts& contacts, Monitor& monitor,
                         std::vector<VertexId>& vertexOfName);

// Rounds the points of the curve from one on. \return Ok, Cancelled or OutOfMemory
// Complexity: O(k) for k of them, in parallel.
Status roundCurvePoints(Arrangement& arrangement, std::size_t first, Monitor& monitor);

}  // namespace index_boolean
