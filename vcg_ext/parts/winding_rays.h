// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: places at vertices, or inside triangles, as queries; out: the winding number of closed
// triangles around each. Guarantee: exact, by lines each along whichever axis meets the fewest
// faces. A query on a surface is known to be there, and has a winding number on either side of it.
#pragma once

#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/status.h"
#include "vcg_ext/exact/exact_sign.h"
#include "vcg_ext/mesh/mesh_arrays.h"

#include <functional>

namespace index_boolean {

// Asks infinitely near to an input vertex that is not on the surface, or to a corner of a triangle,
// inside that. Borrows what the points borrow.
struct WindingQuery {
	VertexId from = VertexId::none();
	std::array<ExactPoint, 3> inside{};  // used if `from` is none: the corner, then the others
	// out: in front of the triangle and behind it. They differ only on a surface.
	int inFront = 0, behind = 0;
	bool onSurface = false;  // out: the place lies on a triangle
};

// A query inside an input face, near its first corner. Complexity: O(1).
WindingQuery queryInside(const MeshArrays& mesh, FaceId face);

// Computes the winding number of one operand's faces around each query.
// \param operand whose faces are counted
// \param ignored a face for which (query index, face) is true is not counted; may be empty
// \return Ok, Cancelled, OutOfMemory, InternalError
// Complexity: O(n log v + v log v + hits) for n faces and v queries. Memory: O(v).
Status findWindings(const MeshArrays& mesh, OperandId operand,
                    const std::function<bool(std::size_t query, FaceId face)>& ignored, int threads,
                    Monitor& monitor, std::vector<WindingQuery>& queries);

}  // namespace index_boolean
