// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: triangles by rank and the edges of their face; out: the proof that they cover the face once,
// the regions into which the fixed edges part it, and in each the best triangles.
// Guarantee: proof and regions by index alone.
#pragma once

#include "vcg_ext/arrange/face_edges.h"
#include "vcg_ext/exact/delaunay_flips.h"

#include <array>
#include <vector>

namespace index_boolean {

// The pieces of one face after another, in memory that is used again.
class FacePieces {
public:
	// Their corners by rank; whoever triangulates a face replaces them.
	std::vector<std::array<std::uint32_t, 3>> triangles;

	// Turns every piece over.
	void turn();

	// Finds the pieces beside each edge, and the regions.
	// \pre all pieces are turned as the face is, which a sweep takes care of
	// \param edges of the face; all others that the pieces have are named
	// \return true only if every border edge has one piece and every other edge two, one on each
	//         side, and if there is room for all edges: with that precondition the proof that the
	//         pieces cover the face once. Throws std::bad_alloc.
	// Complexity: O(n), but for a union-find's search.
	bool certify(FaceEdges& edges);

	// Flips edges that are not fixed until all pieces are as round as they can be; each stays in
	// its region, and fixed edges know the pieces beside them. \pre certified with these edges and
	// points \param front +1 if the pieces are counter-clockwise in the points' projection, else -1
	// Throws std::bad_alloc. Complexity: see DelaunayFlips.
	void flip(FaceEdges& edges, const FacePoints& points, int front, Monitor& monitor);

	// Regions are numbered from 0 on, in the order of their first pieces.
	std::uint32_t regionCount() const { return regionCount_; }
	std::uint32_t regionOf(std::size_t piece) const { return regionOf_[piece]; }

	// The region on one side of an edge, for who goes from its lower to its higher rank; or kNone.
	std::uint32_t regionBeside(const FaceEdge& edge, bool left) const {
		const std::uint32_t piece = edge.pieces[left ? 1 : 0];
		return piece != kNone ? regionOf_[piece] : kNone;
	}

private:
	bool findSides(FaceEdges& edges) const;
	bool uniteSides(const FaceEdges& edges);
	void numberRegions();
	void enterBesideFixed(FaceEdges& edges) const;

	std::uint32_t regionCount_ = 0;
	std::vector<std::uint32_t> regionOf_;  // per piece; a union-find while they are united
	std::vector<std::uint32_t> number_;    // per piece, while the regions are numbered
	std::vector<FreeEdge> freeEdges_;
	DelaunayFlips flips_;
};

}  // namespace index_boolean
