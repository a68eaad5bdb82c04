// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: a surface, and the feature of it that is nearest to a point: a face, an edge or a vertex;
// out: the direction that says on which side of it the point lies. Guarantee: does not depend on
// the numbering of vertices and faces.
// Source: Baerentzen & Aanaes, "Signed Distance Computation Using the Angle Weighted Pseudonormal",
// IEEE TVCG 11 (2005).
#pragma once

#include "vcg_ext/distance/inside_test.h"

namespace index_boolean {

// A feature by its vertices: three of a face, two of an edge, one of a vertex.
struct FeatureVertices {
	std::array<std::uint32_t, 3> vertex;
	std::size_t count;
};

// The outward unit normal of a face; of an edge the sum of its faces' normals, and of a vertex that
// weighted by the faces' angles there, of length 1. If a sum is zero, the normal of `face`.
// \param face one of the faces that have the feature
// Complexity: O(log n + k log k) as expected, for k faces at the feature.
Point pseudonormal(const SearchedFaces& faces, std::uint32_t face, const FeatureVertices& feature);

}  // namespace index_boolean
