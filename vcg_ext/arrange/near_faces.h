// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the faces of one surface, some of them suspect; out: those that may meet a suspect one.
// Guarantee: no face that meets a suspect one is left out.
#pragma once

#include "vcg_ext/arrange/faces_view.h"
#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/status.h"
#include "vcg_ext/exact/bounding_box.h"

#include <vector>

namespace index_boolean {

// Lists the suspect faces and those whose boxes reach a cell of a suspect one's, in a grid of 126
// cells along each axis of the suspect faces' box.
// \param isSuspect per face, not 0: suspect
// \param out       replaced; ascending; empty if no face is suspect
// \return Ok, Cancelled or OutOfMemory. Complexity: O(n + v) for v points, in parallel, and
// O(s c^2) for s suspect faces whose boxes reach c cells along an axis.
Status findNearFaces(const FacesView& faces, const std::vector<std::uint8_t>& isSuspect,
                     int threads, Monitor& monitor, std::vector<std::uint32_t>& out);

// Lists the faces of a surface whose boxes reach a cell of one of these boxes, which may be those
// of suspect faces elsewhere; cells as above.
// \param boxes none of them empty; finite
// \param out   replaced; ascending
// \return Ok, Cancelled or OutOfMemory. Complexity: as above.
Status findFacesNear(const FacesView& faces, const std::vector<BoundingBox>& boxes, int threads,
                     Monitor& monitor, std::vector<std::uint32_t>& out);

// Some of the faces of a surface as a surface of their own.
struct FacesApart {
	Points points;  // of their corners only, in the same order
	IndexTriangles triangles;
};

// Copies faces; corners in one place become one.
// \param which ascending \param out replaced
// Throws std::bad_alloc. Complexity: O(v / 64 + m) for v points and m faces.
void copyFaces(const FacesView& faces, const std::vector<std::uint32_t>& which, FacesApart& out);

}  // namespace index_boolean
