// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/parts/stored_triangles.h"

#include "vcg_ext/arrange/refined_triangles.h"

#include <utility>

namespace index_boolean {

namespace {

// Per input face of the arrangement as stored: the face of the complex that it is, or kNone: then
// another operand's face on the same corners is.
std::vector<std::uint32_t> complexFaces(const Arrangement& arrangement,
                                        const SurfaceComplex& complex) {
	std::vector<std::uint32_t> ofFace(arrangement.mesh.triangles.size(), kNone);
	std::vector<std::uint32_t> ofPiece(arrangement.refinement.pieces.size(), kNone);
	for (std::uint32_t f = 0; f < complex.faces.size(); ++f) {
		const RefinedFace& face = complex.faces[f];
		(face.piece == kNone ? at(ofFace, face.source) : ofPiece[face.piece]) = f;
	}
	const StoredAgain& again = *arrangement.again;
	std::vector<std::uint32_t> found;
	found.reserve(again.faceOf.size());
	for (std::size_t i = 0; i < again.faceOf.size(); ++i) {
		const std::uint32_t piece = again.pieceOf[i];
		found.push_back(piece == kNone ? at(ofFace, again.faceOf[i].face) : ofPiece[piece]);
	}
	return found;
}

}  // namespace

void listStoredTriangles(const Arrangement& arrangement, const SurfaceComplex& complex,
                         StoredTriangles& out) {
	out = StoredTriangles{};
	if (arrangement.again == nullptr) {
		return;
	}
	const StoredAgain& again = *arrangement.again;
	const std::vector<std::uint32_t> faceOf = complexFaces(arrangement, complex);
	out.first.assign(complex.faces.size() + 1, 0);
	const std::size_t faces = again.arrangement.mesh.triangles.size();
	visitRefined(again.arrangement, 0, faces, [&](const Triangle&, FaceId f, std::uint32_t) {
		if (at(faceOf, f) != kNone) {
			++out.first[at(faceOf, f) + 1];
		}
	});
	for (std::size_t f = 0; f < complex.faces.size(); ++f) {
		out.first[f + 1] += out.first[f];
	}
	out.triangles.resize(out.first.back());
	std::vector<std::uint32_t> next(out.first.begin(), out.first.end() - 1);
	visitRefined(again.arrangement, 0, faces, [&](Triangle t, FaceId f, std::uint32_t) {
		if (at(faceOf, f) != kNone) {
			if (at(again.faceOf, f).turned) {
				std::swap(t[1], t[2]);
			}
			out.triangles[next[at(faceOf, f)]++] = t;
		}
	});
}

}  // namespace index_boolean
