// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The predicate behind Delaunay triangulations: which side of a circle a place lies on.
// Guarantee: exact for all finite doubles. Source: Guibas & Stolfi 1985; ties after Edelsbrunner &
// Muecke, "Simulation of simplicity" (1990).
#pragma once

#include <array>
#include <cstdint>

namespace index_boolean {

// Two coordinates of a point as they are stored.
using PlanarPlace = std::array<double, 2>;

// The sign of the in-circle determinant: +1 if d lies inside the circle through a, b, c, where
// these are counter-clockwise; the opposite where they are clockwise; 0 on it.
// Complexity: O(1), almost always some 100 flops.
int inCircle(const PlanarPlace& a, const PlanarPlace& b, const PlanarPlace& c,
             const PlanarPlace& d);

// As inCircle, with an answer on the circle too: as if each place's height on the paraboloid were
// a little more, infinitely more for the place of lower rank than for all of higher.
// \param ranks all different
// \return 0 only if the four places are on one line. Complexity: O(1).
int inCirclePerturbed(const std::array<PlanarPlace, 4>& places,
                      const std::array<std::uint32_t, 4>& ranks);

}  // namespace index_boolean
