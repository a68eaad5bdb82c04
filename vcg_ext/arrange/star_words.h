// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the faces of one surface; out: the vertices around which floats tell that all faces meet
// properly, the others, and the faces that may have no area.
// Guarantee: no vertex is certified wrongly, however the surface is made. The result does not
// depend on threads.
//
// Why a vertex is certified. Let each edge at v have as many faces each way. Then the wedges that
// faces have at v form closed chains. Let all wedges, projected along an axis, turn the same way,
// strictly. Then each chain goes round v, and all together cover each direction equally often: as
// often as they cross any half-line, which is how often a chain comes from below v to not below it,
// along a coordinate of the projection. If that is once, no two wedges have more in common than a
// spoke, and there is one chain, whose spokes differ. So two faces at v have in common what lies on
// one spoke: the corner v, or the edge that both have. That v be manifold is not needed.
//
// Why floats tell. Let u and w be two sides of a face, from corners that the frame has moved by
// less than 2^-24 each, s = |u|_1 + |w|_1. A component of u x w differs from the true one by less
// than 2^-23 s + 2^-45 for the moves, and by less than 1.03 * 2^-24 s^2 for the rounding of its
// operations. What exceeds s (2^-22 + 2^-23 s) + 2^-40, rounded or not, keeps its sign while
// corners go straight from their rounded to their exact places. On that way no wedge degenerates,
// so the number of windings stays as it is: ties of coordinates need no care.
#pragma once

#include "vcg_ext/arrange/search_frame.h"

#include <vector>

namespace index_boolean {

// What the words of all vertices leave.
struct WordsLeave {
	std::vector<std::uint32_t> openStars;      // vertices, ascending; with a suspect face each
	std::vector<std::uint32_t> zeroAreaFaces;  // of zero area, exactly; ascending
};

// Sets the star of each vertex to its index, or to kNone if it is left open. A vertex without a
// suspect face is certified untested: none of its pairs is of interest.
// \param surface its stars are written, and isZeroArea
// \param out     replaced
// \return Ok, Cancelled or OutOfMemory. Complexity: O(n), in parallel; 2 bytes a vertex for each of
// up to eight threads.
Status certifyStars(SearchedSurface& surface, Monitor& monitor, WordsLeave& out);

}  // namespace index_boolean
