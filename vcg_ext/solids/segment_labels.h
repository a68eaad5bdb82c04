// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the half-planes around one segment, of both operands; out: where each lies with respect to
// the other operand. Guarantee: exact. Any contact: crossing, tangential, along edges, coplanar.
#pragma once

#include "vcg_ext/arrange/radial_order.h"

#include <optional>

namespace index_boolean {

struct LabelledHalfPlane : HalfPlane {
	NodeId region;
	Label label = Label::Unknown;  // out
};

// Sorts half-planes around a segment and labels each by the other operand's around it.
// \param halfPlanes all of the segment, of both operands; labelled
// \return the operand that contradicts itself there (two of its faces in one place, or insides that
//         do not alternate), if one does
// Complexity: O(k log k) for k half-planes.
std::optional<OperandId> labelAround(const Arrangement& arrangement, const Segment& segment,
                                     std::vector<LabelledHalfPlane>& halfPlanes);

}  // namespace index_boolean
