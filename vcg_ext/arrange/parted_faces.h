// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: two faces of one surface; out: whether doubles already tell that they have nothing in common
// but their common corner or edge; and the exact answer.
// Guarantee: both are never wrong; the first one may not know.
#pragma once

#include "vcg_ext/arrange/face_pair.h"
#include "vcg_ext/arrange/faces_view.h"

namespace index_boolean {

// Whether, without doubt, a plane or, in a projection along an axis, a line parts two faces but for
// their common corner or edge. False for most pairs that meet wrongly, and for those that rounding
// leaves in doubt. \pre neither has two equal corners. Complexity: O(1), mostly 100 flops.
bool arePartedFaces(const FacesView& faces, FacePair pair);

// How two faces meet.
enum class Meeting : std::uint8_t {
	Proper,         // not at all, or in a common corner or edge
	Wrong,          // anywhere else, too
	Contradiction,  // which exact signs never do
};

// Decides it exactly. \pre both have area. Complexity: O(1), a dozen orient3d.
Meeting meetingOf(const FacesView& faces, FacePair pair);

}  // namespace index_boolean
