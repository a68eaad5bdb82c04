// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: two sets of triangles; out: which has more area, and what volume lies below one.
// Guarantee: a function of the sets alone, in whatever order and with whatever corner first. Areas
// are sums of square roots: where double precision leaves a doubt they are compared as integers, in
// units of 2^-512 of the largest; what agrees that far is taken as equal.
#pragma once

#include "vcg_ext/base/mesh_types.h"
#include "vcg_ext/base/monitor.h"

namespace index_boolean {

// +1 if a has more area, -1 if b has, 0 if neither has, or if the run is cancelled meanwhile.
// \param points of all corners, which exist and are finite
// Complexity: O(n), where doubles can tell; else O(n) roots of integers of two thousand bits.
int compareAreas(const Points& points, const Triangles& a, const Triangles& b, Monitor& monitor);

// The sign of the sum over the triangles of a set of the volume between each and the origin, less
// the same of another set; exactly. 0, too, if the run is cancelled meanwhile.
// \param points as above. Complexity: O(n) products of integers of some two thousand bits.
int compareVolumesBelow(const Points& points, const Triangles& a, const Triangles& b,
                        Monitor& monitor);

}  // namespace index_boolean
