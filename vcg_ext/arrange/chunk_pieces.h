// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the pieces and regions of one face after another, in chunks of faces; out: all of them in one
// numbering. Guarantee: the order of the faces, whichever thread cut them.
#pragma once

#include "vcg_ext/arrange/face_pieces.h"
#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/status.h"

#include <vector>

namespace index_boolean {

// What one chunk of cut faces gives. Regions are numbered within the chunk.
struct ChunkPieces {
	// The regions to both sides of a segment on one face; or kNone.
	struct Sides {
		SegmentId segment;
		FaceId face;
		std::uint32_t left, right;
	};
	struct Link {
		std::uint32_t region;
		NodeId other;
	};

	std::vector<CutFace> cutFaces;
	Triangles pieces;
	std::vector<std::uint32_t> pieceRegion;
	std::vector<Sides> sides;
	std::vector<Link> links;
	std::vector<Link> cornerLinks;
	std::uint32_t regionCount = 0;

	// Adds a face that has been cut.
	// \param pieces certified, with these edges
	// Throws std::bad_alloc. O(n).
	void append(const Arrangement& arrangement, FaceId face, const FacePoints& points,
	            const FaceEdges& edges, const FacePieces& pieces);

	// Adds a face that is met at its corners alone: it is its one piece. O(1).
	// Throws std::bad_alloc.
	void appendWhole(const Arrangement& arrangement, const FaceLines& lines);

private:
	void linkCorner(const Arrangement& arrangement, std::uint32_t region, VertexId corner);
	void appendSides(FaceId face, const FaceEdges& edges, const FacePieces& pieces);
};

// Fills arrangement.refinement with all chunks, one after another.
// \return Ok, Cancelled, OutOfMemory; TooLarge if there are more label nodes, or corners of faces
//         and pieces, than 32 bits number
// Complexity: O(n), in parallel.
Status concatenate(const std::vector<ChunkPieces>& chunks, Arrangement& arrangement,
                   Monitor& monitor);

}  // namespace index_boolean
