// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A face that is not touched is one with its vertices; a piece of a touched one is linked to what
// it reaches. A vertex on the other operand joins nothing: what meets there may lie on different
// sides.
#include "vcg_ext/solids/label_nodes.h"

#include "vcg_ext/base/parallel.h"

#include <algorithm>

namespace index_boolean {

namespace {

void uniteFaces(Arrangement& arrangement, OperandId operand, UnionFind& classes) {
	const MeshArrays& mesh = arrangement.mesh;
	std::vector<Label>& label = arrangement.labels.vertex;
	const std::vector<std::uint8_t>& isCut = arrangement.refinement.isCut;
	for (std::size_t f = mesh.faceOffsets.begin(operand); f < mesh.faceOffsets.end(operand); ++f) {
		const Triangle& t = mesh.triangles[f];
		if (mesh.quietTwin(makeId<FaceTag>(f)) != Twin::None) {
			continue;
		}
		if (isCut[f] == 0) {
			label[t[0].value] = label[t[1].value] = label[t[2].value] = Label::Unknown;
			classes.unite({t[0].value, t[1].value, t[2].value});
		}
	}
}

}  // namespace

LabelNodes::LabelNodes(const Arrangement& arrangement) : arrangement_(arrangement) {
	const Refinement& refinement = arrangement.refinement;
	for (const CutFace& cut : refinement.cutFaces) {
		if (arrangement.mesh.operandOf(cut.face) == kSecond) {
			firstRegionOfSecond_ = refinement.pieceRegion[cut.firstPiece];
			break;
		}
	}
}

NodeId LabelNodes::ofFace(FaceId face) const {
	const MeshArrays& mesh = arrangement_.mesh;
	const Refinement& refinement = arrangement_.refinement;
	const VertexId corner = at(mesh.triangles, face)[0];
	if (mesh.quietTwin(face) != Twin::None) {
		return ofCorner(mesh.operandOf(face), corner);
	}
	if (at(refinement.isCut, face) == 0) {
		return ofVertex(corner);
	}
	const auto cut = std::lower_bound(refinement.cutFaces.begin(), refinement.cutFaces.end(), face,
	                                  [](const CutFace& c, FaceId f) { return c.face < f; });
	return refinement.pieceRegion[cut->firstPiece];
}

Status findClasses(Arrangement& arrangement, Monitor& monitor, UnionFind& classes) {
	const MeshArrays& mesh = arrangement.mesh;
	const Refinement& refinement = arrangement.refinement;
	std::vector<Label>& label = arrangement.labels.vertex;
	label.assign(mesh.points.size(), Label::Unused);
	classes = UnionFind(LabelNodes(arrangement).count());
	// Faces that are not touched have vertices of their own operand only, so each operand may be
	// united on a thread of its own.
	const int halves = threadsForHalves(mesh.points.size(), arrangement.options.threads);
	const Status status =
	    parallelFor(2, 1, halves, monitor, [&](std::size_t begin, std::size_t end) {
		    for (std::size_t operand = begin; operand < end; ++operand) {
			    uniteFaces(arrangement, makeId<OperandTag>(operand), classes);
		    }
	    });
	for (const auto& link : refinement.links) {
		if (link[1].value < label.size()) {
			label[link[1].value] = Label::Unknown;
		}
		classes.unite(link[0].value, link[1].value);
	}
	for (const auto& link : refinement.cornerLinks) {
		label[link[1].value] = Label::OnVertex;
	}
	for (std::size_t v = 0; v < mesh.quietVertices.size(); ++v) {
		if (mesh.quietVertices[v] != 0) {
			label[v] = Label::OnVertex;
		}
	}
	classes.flatten();
	return status;
}

}  // namespace index_boolean
