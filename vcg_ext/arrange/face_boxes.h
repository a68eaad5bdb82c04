// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: both operands' triangles; out: the boxes of the faces that may meet the other operand.
// Guarantee: for every two faces, one of each operand, whose boxes touch or overlap, both boxes are
// listed and still touch or overlap. Boxes are floats, relative to the common part of the operands'
// boxes: the map never swaps two numbers, so it needs no margin to keep boxes together. Vertices
// that no face uses do not make them coarse, wherever they are.
#pragma once

#include "vcg_ext/arrange/box_frame.h"
#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/status.h"
#include "vcg_ext/mesh/mesh_arrays.h"

namespace index_boolean {

struct FaceBox {
	std::array<float, 3> lo;
	std::array<float, 3> hi;
	std::uint32_t face;
};

// The boxes of each operand in the order of the faces, in the cube of a frame in which all that the
// operands have in common lies.
struct FaceBoxes {
	PerOperand<HugeVector<FaceBox>> operand;
	BoxFrame frame;
};

// Lists the faces, but for quiet ones, that reach both operands' boxes and, in a coarse grid, a
// cell of the other operand.
// \param mesh both operands; every face's coordinates are finite
// \param out  both lists empty if the operands' boxes are apart
// \return Ok, Cancelled or OutOfMemory. Complexity: O(n), in parallel.
Status collectFaceBoxes(const MeshArrays& mesh, int threads, Monitor& monitor, FaceBoxes& out);

}  // namespace index_boolean
