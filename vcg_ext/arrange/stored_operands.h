// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: an arrangement; out: its refined operands as they are stored, as the operands of another
// arrangement, and which element of this one each of their elements is.
// Guarantee: rounding is a map of vertices, and every face with three different corners is taken,
// so that what is closed stays closed.
#pragma once

#include "vcg_ext/arrange/arrangement.h"
#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/status.h"
#include "vcg_ext/mesh/sourced_mesh.h"

#include <vector>

namespace index_boolean {

// Operands whose vertices are an arrangement's vertices, each operand with vertices of its own.
struct StoredOperands {
	MeshArrays mesh;
	std::vector<FaceSource> faceOf;  // per face: the arrangement's input face that it is a piece of
	std::vector<std::uint32_t> pieceOf;  // per face: the piece, or kNone: all of that face
	std::vector<VertexId> vertexOf;      // per vertex: an input vertex or a curve point
};

// Takes the operands as they are stored: what is turned for blocks is turned here, too. Faces are
// classed by the input face that they are pieces of, or by its class, if coplanar faces are merged.
// \param out replaced \return Ok or Cancelled. Throws std::bad_alloc.
// Complexity: O(n) for n faces and pieces.
Status takeStoredOperands(const Arrangement& arrangement, Monitor& monitor, StoredOperands& out);

// Names what was read from operands arranged again as the first arrangement does: faces by the
// input faces that they are pieces of; a vertex that is none of its vertices by none(). Complexity:
// O(n).
void nameFacesAsFirst(const StoredAgain& again, HugeVector<FaceSource>& faces);
void nameVerticesAsFirst(const StoredAgain& again, HugeVector<VertexId>& vertices);

}  // namespace index_boolean
