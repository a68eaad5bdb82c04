// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: both refined surfaces; out: those of their faces that rounding may have made meet others
// wrongly, and all that they may meet, as one surface with the places that are delivered.
// Guarantee: nothing that meets a suspect face wrongly is left out. A face is suspect if a corner
// of it is not stored in its exact place.
#pragma once

#include "vcg_ext/arrange/arrangement.h"
#include "vcg_ext/arrange/wrong_pairs.h"
#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/status.h"

#include <vector>

namespace index_boolean {

// Faces by vertices of their own numbering, and by places: vertices stored in one place have one.
// Uncut faces come first, then all pieces of the arrangement, in their order. Of quiet twins only
// the first operand's is here; of twin pieces, both.
struct StoredSurface {
	std::vector<VertexId> vertices;      // ascending
	std::vector<std::uint32_t> placeOf;  // per vertex
	std::vector<std::uint8_t> isWhole;   // per vertex: all faces at it are here, and all that they
	                                     // may meet, with the reach; else it must stay in its place
	Points places;                       // each once, at first
	IndexTriangles corners;              // per face: its vertices
	IndexTriangles stored;               // per face: its places
	std::vector<FaceId> inputFaces;      // per face: that it is or is a piece of
	std::vector<std::uint8_t> isSuspect;  // per face
	std::size_t firstPiece = 0;           // face firstPiece + i is piece i
	bool anySuspect = false;
};

// Collects the faces.
// \param reach how far from suspect faces those that may meet them are looked for, in the unit of
//              the operands' coordinates; not negative. If it is positive, faces at the corners of
//              pieces are as good as suspect, so that those corners may be moved
// \param out   replaced; has no face, and anySuspect is false, if nothing is rounded
// \return Ok, Cancelled or OutOfMemory. Complexity: O(n) for n faces, in parallel, and O(s) for s
// pieces and faces near them.
Status collectStoredSurface(const Arrangement& arrangement, double reach, Monitor& monitor,
                            StoredSurface& out);

// Whether a face has two corners in one place. Complexity: O(1).
inline bool isCollapsed(const IndexTriangle& stored) {
	return stored[0] == stored[1] || stored[1] == stored[2] || stored[2] == stored[0];
}

// Finds what is wrong among some faces: pairs that meet wrongly and faces without area.
// \param which ascending; none collapsed. Two on the same three places meet wrongly
// \param out   replaced; by the surface's faces
// \return Ok, Cancelled, OutOfMemory, InternalError. Complexity: see findWrongPairs.
Status findFaults(const StoredSurface& surface, const std::vector<std::uint32_t>& which,
                  int threads, Monitor& monitor, WrongPairs& out);

// Lists the faces of a surface that are not collapsed, of twin pieces only one.
// \param out replaced; ascending
// \return Ok or Cancelled. Throws std::bad_alloc. Complexity: O(n + d log d), d pieces with all
// corners on the other operand.
Status findDistinctFaces(const Arrangement& arrangement, const StoredSurface& surface,
                         Monitor& monitor, std::vector<std::uint32_t>& out);

}  // namespace index_boolean
