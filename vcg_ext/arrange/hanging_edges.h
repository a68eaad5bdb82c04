// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the edges of a surface that have not as many faces each way; out: whether that is so only
// because vertices hang on them. Guarantee: exact.
#pragma once

#include "vcg_ext/base/edge_table.h"
#include "vcg_ext/base/mesh_types.h"
#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/status.h"

#include <vector>

namespace index_boolean {

// An edge between two vertices, with how many more faces run from its lower to its higher vertex
// than back.
using UnevenEdge = EdgeItem<std::int32_t>;

// Whether all edges cancel once each is parted at the ends of others that lie on it: the surface is
// closed then, wherever its faces meet. \pre vertices in one place are one
// \param cancel the answer; none if the run is cancelled
// \return Ok or Cancelled. Throws std::bad_alloc.
// Complexity: O(k log k + m) for k edges and m pairs of an edge and an end in its box.
Status findWhetherEdgesCancel(const Points& points, const std::vector<UnevenEdge>& edges,
                              Monitor& monitor, bool& cancel);

}  // namespace index_boolean
