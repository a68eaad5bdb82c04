// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Surfaces that meet themselves, in ways in which a step may look at far more than there is; see
// growth.py. Guarantee: the same arrays on every run and machine.
#pragma once

#include "operands.h"

namespace index_boolean_bench {

// Upright prisms of 8 triangles over random triangles in the unit disk, from z = 0 up, each a
// little higher than the one before: all bases lie in one plane, and most overlap.
Surface makeStack(std::uint32_t count);

// Two cones of this many sides and one tip, the second turned about x so that it crosses the first:
// many faces at one vertex of which few meet wrongly.
Surface makeCrossedCones(std::uint32_t sides);

// Five unit spheres of about this many faces, each turned by a part of an edge against the one
// before: each face crosses a few of each other sphere.
Surface makeNearCopies(std::uint32_t faces);

// Wedges of 8 triangles round the z axis, each with a face through it: the lines in which these
// faces meet each other lie all on the axis, from z = 0 to the height.
Surface makePencil(std::uint32_t count, double height);

// Boxes across the z axis, beside each other from z = 0 to the height.
Surface makeSlabs(std::uint32_t count, double height);

}  // namespace index_boolean_bench
