// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: triangles in the plane of one input face, of which some edges are free; out: the same points
// and other edges, as round as they can be. Guarantee: as that of DelaunayFlips.
#pragma once

#include "vcg_ext/arrange/face_points.h"
#include "vcg_ext/exact/delaunay_flips.h"

#include <array>
#include <vector>

namespace index_boolean {

// Flips the edges of one patch after another, with buffers that are used again. One for each
// thread.
class PlanarPatch {
public:
	// Two of the patch's triangles that have an edge in common which may be flipped.
	using FreePair = std::array<std::uint32_t, 2>;

	// Borrows the arrangement.
	explicit PlanarPatch(const Arrangement& arrangement)
	    : arrangement_(arrangement), points_(arrangement) {}

	// \param plane     an input face in whose plane they lie
	// \param turned    they run the other way round than it
	// \param names     of vertices, by the numbers that the triangles have; copies may be among
	// them \param edges     each once \param triangles changed in place \return how many flips
	// there were; if the run is cancelled, it may not be done Throws std::bad_alloc. Complexity:
	// O(n log n) and that of DelaunayFlips.
	std::size_t flip(FaceId plane, bool turned, const VertexId* names,
	                 const std::vector<FreePair>& edges, Monitor& monitor,
	                 std::vector<IndexTriangle>& triangles);

private:
	void rankVertices(int axis, const VertexId* names, const std::vector<IndexTriangle>& triangles);
	PlanarEdge commonEdge(const FreePair& pair) const;

	const Arrangement& arrangement_;
	FacePoints points_;
	DelaunayFlips flips_;
	std::vector<std::uint32_t> vertices_;  // ascending
	std::vector<VertexId> names_;          // of each
	RankTriangles ranked_;
	std::vector<FreeEdge> edges_;
};

}  // namespace index_boolean
