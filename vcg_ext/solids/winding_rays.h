// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: vertices, or points inside faces, as queries; out: the winding number of closed triangles
// around each. Guarantee: exact; rays never hit an edge, since the query is moved symbolically in x
// and y. All rays are shot in one pass over the triangles.
#pragma once

#include "vcg_ext/arrange/arrangement.h"
#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/status.h"

#include <functional>

namespace index_boolean {

// A ray upwards (+z) from an input vertex or from a point inside a face.
struct RayQuery {
	VertexId from = VertexId::none();
	FaceId inside = FaceId::none();  // used if `from` is none: a weighted mean of its corners
	std::array<double, 3> weights{1, 1, 1};  // positive small integers
	int winding = 0;                         // out
	bool onSurface = false;  // out: the point lies on a triangle; winding is then meaningless
};

// Computes the winding number of one operand's faces around each query.
// \param operand whose faces are counted
// \param ignored a face for which (query index, face) is true is not counted; may be empty
// \return Ok, Cancelled, OutOfMemory, InternalError
// Complexity: O(n + v log v + f n + hits) for n faces, v queries from vertices and f from faces.
Status castRays(const Arrangement& arrangement, OperandId operand,
                const std::function<bool(std::size_t query, FaceId face)>& ignored,
                Monitor& monitor, std::vector<RayQuery>& queries);

}  // namespace index_boolean
