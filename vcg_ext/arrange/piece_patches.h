// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: vertices that have been moved; out: the pieces around them as round as they can be again.
// Guarantee: as that of DelaunayFlips, in the part of each region that is near a moved vertex;
// nothing leaves its region, and a segment stays an edge.
#pragma once

#include "vcg_ext/arrange/planar_patch.h"
#include "vcg_ext/arrange/stored_faults.h"

#include <array>
#include <vector>

namespace index_boolean {

// Flips edges of one patch after another, with buffers that are used again.
class PiecePatches {
public:
	// Borrows the arrangement and the faults. O(s log s) for s segments. Throws std::bad_alloc.
	PiecePatches(const Arrangement& arrangement, StoredFaults& faults, Monitor& monitor);

	// Flips around these vertices, by the places that they are stored in now. A patch is the
	// vertex's pieces in a region and whole rings of pieces around them, until it has enough or is
	// the region. \param vertices of the stored surface
	// Throws std::bad_alloc. Complexity: that of flips in a patch, for each region at a vertex.
	void flipAround(const std::vector<std::uint32_t>& vertices);

private:
	NodeId regionOf(std::uint32_t face) const {
		return arrangement_.refinement.pieceRegion[face - faults_.surface().firstPiece];
	}
	bool isPiece(std::uint32_t face) const { return face >= faults_.surface().firstPiece; }
	bool isSegment(std::uint32_t a, std::uint32_t b) const;
	void listNeighbours(std::uint32_t piece);
	void growPatch();
	void flipPatch();

	const Arrangement& arrangement_;
	StoredFaults& faults_;
	Monitor& monitor_;
	std::vector<std::array<VertexId, 2>> segments_;  // lower end, higher end; sorted
	PlanarPatch patch_;
	std::vector<std::uint32_t> pieces_;      // of the patch; ascending once it has grown
	std::vector<std::uint32_t> neighbours_;  // pieces
	std::vector<IndexTriangle> triangles_;
	std::vector<PlanarPatch::FreePair> edges_;
};

}  // namespace index_boolean
