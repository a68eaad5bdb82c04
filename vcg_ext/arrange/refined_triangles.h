// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: an arrangement; out: the triangles of its refined operands, one after another.
// Guarantee: each uncut face and each piece once, in the order of the input faces.
#pragma once

#include "vcg_ext/arrange/arrangement.h"

#include <algorithm>

namespace index_boolean {

// Calls visit(corners, face, piece) for the input faces [begin, end): for each that is not cut,
// with kNone as its piece, and for all pieces of the others. Complexity: O(log k + m) for k cut
// faces and m triangles.
template <class Visit>
void visitRefined(const Arrangement& arrangement, std::size_t begin, std::size_t end,
                  Visit&& visit) {
	const Refinement& refinement = arrangement.refinement;
	const auto first = std::lower_bound(
	    refinement.cutFaces.begin(), refinement.cutFaces.end(), makeId<FaceTag>(begin),
	    [](const CutFace& cut, FaceId face) { return cut.face < face; });
	auto cut = static_cast<std::size_t>(first - refinement.cutFaces.begin());
	for (std::size_t f = begin; f < end; ++f) {
		const FaceId face = makeId<FaceTag>(f);
		if (refinement.isCut[f] == 0) {
			visit(arrangement.mesh.triangles[f], face, kNone);
			continue;
		}
		const Refinement::PieceRange pieces = refinement.piecesOf(cut++);
		for (std::size_t piece = pieces.begin; piece < pieces.end; ++piece) {
			visit(refinement.pieces[piece], face, static_cast<std::uint32_t>(piece));
		}
	}
}

}  // namespace index_boolean
