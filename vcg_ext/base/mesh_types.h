// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Triangles by their corners, and the large arrays that a mesh is made of.
#pragma once

#include "vcg_ext/base/huge_vector.h"
#include "vcg_ext/base/ids.h"
#include "vcg_ext/base/point.h"

#include <array>
#include <cstdint>

namespace index_boolean {

using Triangle = std::array<VertexId, 3>;
using IndexTriangle = std::array<std::uint32_t, 3>;  // of a mesh that has a numbering of its own

using Points = HugeVector<Point>;
using Triangles = HugeVector<Triangle>;
using IndexTriangles = HugeVector<IndexTriangle>;

}  // namespace index_boolean
