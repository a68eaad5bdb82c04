// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the half-planes of faces around one segment of the curve; out: their cyclic order, and where
// each lies with respect to the other operand.
// Guarantee: decided by signs of input corners against input planes; half-planes in one place are
// told from opposite ones exactly. Any contact: crossing, tangential, along edges, coplanar.
#pragma once

#include "arrangement.h"

namespace index_boolean {

// One half-plane that ends in the segment: the part of a face to the left or right of it.
struct HalfPlane {
	FaceId face;
	bool left;
	NodeId region;
	Label label = Label::Unknown;  // out
};

// Sorts half-planes around a segment counter-clockwise, seen against its direction, and labels each
// by the other operand's half-planes around it.
// \param halfPlanes all of the segment, of both operands; reordered, labelled
// \return the operand (0 or 1) that contradicts itself there (two of its faces in one place, or
//         insides that do not alternate), or -1 if all is well
// Complexity: O(k log k) for k half-planes.
int labelAround(const Arrangement& arrangement, const Segment& segment,
                std::vector<HalfPlane>& halfPlanes);

}  // namespace index_boolean
