// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: faces and the frame of an octree; out: which of a node's children a face itself may reach,
// where its box reaches many: the box of a long face that lies askew is mostly empty.
// Guarantee: a child that is left out has no point of the face. Decided by a direction along which
// all corners lie beyond the child, farther than all roundings can tell.
// Source: the separating axes of a triangle and a box (Akenine-Möller 2001).
#pragma once

#include "vcg_ext/arrange/box_frame.h"
#include "vcg_ext/mesh/mesh_arrays.h"

namespace index_boolean {

// Sets of the eight children as bits. Child c lies in the upper half along axis k iff bit k of c.
using ChildSet = std::uint8_t;

// A node of the octree, in the frame: it reaches from middle - half to middle + half.
struct OctreeCell {
	std::array<float, 3> middle;
	float half;
};

// Clips faces to children of nodes. Borrows the arrays.
class CellClip {
public:
	CellClip(const MeshArrays& mesh, const BoxFrame& frame) : mesh_(mesh), frame_(frame) {}

	// Those of some children of a node that a face may have a point in that lies in the frame.
	// Complexity: O(1), about ten scalar products a child.
	ChildSet reached(FaceId face, ChildSet children, const OctreeCell& node) const;

private:
	const MeshArrays& mesh_;
	BoxFrame frame_;
};

}  // namespace index_boolean
