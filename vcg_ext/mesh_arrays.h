// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The arrays that the core works on: both operands' points and triangles in one numbering.
// in: two surfaces as plain arrays (or, by mesh_arrays_vcg.h, any vcg::tri::TriMesh); out: one
// MeshArrays. Guarantee: no coordinate is changed.
#pragma once

#include "ids.h"

#include <vector>

namespace index_boolean {

// Operand k has the vertices [vertexBegin[k], vertexBegin[k + 1]) and the faces
// [faceBegin[k], faceBegin[k + 1]). Triangles hold global vertex ids. Once welded, faces of the
// second operand may use vertices of the first, where both have one in the same place.
struct MeshArrays {
	std::vector<Point> points;
	std::vector<Triangle> triangles;
	std::array<std::uint32_t, 3> vertexBegin{};
	std::array<std::uint32_t, 3> faceBegin{};

	int operandOf(FaceId face) const { return face.value < faceBegin[1] ? 0 : 1; }
};

}  // namespace index_boolean
