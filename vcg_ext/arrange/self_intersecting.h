// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the faces that show that an operand intersects itself; out: the status that says so.
#pragma once

#include "vcg_ext/arrange/arrangement.h"
#include "vcg_ext/base/status.h"

namespace index_boolean {

// The refusal of an operand that intersects itself.
// \param faces of the operand, in any order, repeated or not; the status has them as given
// \param place one point at the first defect
// \return SelfIntersecting. Complexity: O(f log f) for f faces.
Status selfIntersecting(const Arrangement& arrangement, OperandId operand,
                        const std::vector<FaceId>& faces, const Point& place);

}  // namespace index_boolean
