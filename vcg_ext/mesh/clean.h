// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: a surface whose coordinates have been rounded; out: the same without faces of zero area.
// Guarantee: no vertex moves, no face has exactly zero area, no edge joins two vertices at one
// place; each directed edge is matched by its opposite if it was before, and the solid behind the
// surface is the same point set. Vertices that no edge joined stay apart, however close (except
// within one line of zero-area faces). The triangles do not depend on the numbering of vertices
// and faces, nor on the threads. Contracting short edges could not promise this: a flat face on an
// edge as long as itself has none.
#pragma once

#include "vcg_ext/exact/zero_area.h"

namespace index_boolean {

// How the elements of an array change places when some leave and some arrive: element `to` becomes
// what element `from` was before; then there are `count` elements. All others stay in place.
struct Relocation {
	struct Move {
		std::uint32_t from, to;
	};

	std::size_t count = 0;
	std::vector<Move> moves;

	// Carries out the changes on any array parallel to the one that changed. O(moves).
	template <class Array>
	void apply(Array& elements) const {
		Array moved;
		moved.reserve(moves.size());
		for (const Move& move : moves) {
			moved.push_back(elements[move.from]);
		}
		elements.resize(count);
		for (std::size_t i = 0; i < moves.size(); ++i) {
			elements[moves[i].to] = moved[i];
		}
	}
};

struct CleanResult {
	Relocation faces;  // done to the triangles; for the caller's per-face arrays: a piece of a
	                   // split face is a copy of that face
	std::vector<std::uint32_t> unreferenced;  // vertices that lost their last face, ascending
	std::vector<std::uint32_t> looked;        // vertices whose faces may have changed, ascending
	std::size_t verticesMerged = 0;           // into another at the same place
	std::size_t zeroAreaFacesRemoved = 0;
	std::size_t oppositeFacesRemoved = 0;  // faces with area that fell on their opposite
	std::size_t facesSplit = 0;            // faces with area, across a vertex on their edge
	Relocation vertices;                   // done to the points, by cleanMesh alone
};

// Removes the zero-area faces from a surface.
// \param points        finite; not changed
// \param zeroAreaFaces every face of zero area, as findZeroAreaFaces gives them
// \param threads       0: as many as there are
// \param triangles     indices into points; changed in place, only if the status is Ok
// \param result        replaced
// \return Ok, Cancelled, OutOfMemory, InternalError, or TooLarge: more than 2^31 - 1 faces
// Complexity: O(1) if there is no zero-area face; else one parallel pass over the triangles and
// O(k log k) for k faces at the corners of zero-area faces, the faces put in their place included.
Status cleanSurface(const Points& points, const std::vector<std::uint32_t>& zeroAreaFaces,
                    int threads, Monitor& monitor, IndexTriangles& triangles, CleanResult& result);

// Finds the zero-area faces among some faces, removes them, and then the vertices that have lost
// their last face.
// \param range     the faces that may have zero area
// \param threads   0: as many as there are
// \param points, triangles changed in place; meaningful only if the status is Ok
// \param result    replaced; `looked` are numbers from before its `vertices` were relocated
// \return as cleanSurface. Complexity: that of findZeroAreaFaces, cleanSurface and removeVertices.
Status cleanMesh(FaceRange range, int threads, Monitor& monitor, Points& points,
                 IndexTriangles& triangles, CleanResult& result);

// Removes vertices that no face refers to; the last ones take their places.
// \param vertices  to be removed, ascending, each once
// \param points    changed in place, as the triangles' indices are, only if the status is Ok
// \param relocated replaced by what was done to the points, for the caller's per-vertex arrays
// \return Ok, Cancelled, OutOfMemory or InternalError
// Complexity: O(1) if there is none to remove, else one parallel pass over the triangles.
Status removeVertices(const std::vector<std::uint32_t>& vertices, int threads, Monitor& monitor,
                      Points& points, IndexTriangles& triangles, Relocation& relocated);

}  // namespace index_boolean
