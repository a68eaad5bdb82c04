// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the faces of one surface; out: axes along which their boxes are to be taken for a search.
// Where long thin faces lie askew, as the walls of a turned comb or of a plate with holes, boxes
// along x, y and z overlap by the square of their number; along the axes of these faces hardly any
// does. Nothing is decided by the axes but how much there is to look at.
#pragma once

#include "vcg_ext/arrange/faces_view.h"
#include "vcg_ext/exact/bounding_box.h"

#include <array>
#include <optional>

namespace index_boolean {

// Three axes, of length 1 and perpendicular to each other but for rounding.
using Axes = std::array<Point, 3>;

// A guess from some faces.
// \param box   of the faces' corners
// \param scale a power of two by which no side of the box is longer than 2
// \return none if x, y and z will do. Throws std::bad_alloc. Complexity: O(1).
std::optional<Axes> guessFrameAxes(const FacesView& faces, const BoundingBox& box, double scale);

}  // namespace index_boolean
