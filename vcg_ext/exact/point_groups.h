// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: points and a distance; out: the groups of points that are linked by distances below it.
// Guarantee: exact, whatever the magnitudes; the same groups for any order of the points.
#pragma once

#include "vcg_ext/base/mesh_types.h"
#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/status.h"

#include <vector>

namespace index_boolean {

// Groups points: two of them are in one group if a chain of points leads from one to the other,
// each nearer to the next than the distance.
// \param distance greater than 0, finite, as all coordinates
// \param smallest replaced: per point, the index of the lexicographically smallest point of its
//                 group; of equal points the one that comes first
// \return Ok or Cancelled. Throws std::bad_alloc.
// Complexity: O(n) as expected: a grid whose cells are a few distances wide leaves few neighbours,
// and points that crowd in less than half of it are one from the beginning.
Status groupPoints(const Points& points, double distance, Monitor& monitor,
                   std::vector<std::uint32_t>& smallest);

// The groups with two points that are farther from each other than twice the distance, by their
// smallest point; ascending.
// \param smallest as groupPoints gives it for this distance
// \return Ok or Cancelled. Throws std::bad_alloc.
// Complexity: O(n), but for groups whose box alone does not tell: O(m log m) of m points, for all
// but few shapes.
Status findWideGroups(const Points& points, const std::vector<std::uint32_t>& smallest,
                      double distance, Monitor& monitor, std::vector<std::uint32_t>& wide);

}  // namespace index_boolean
