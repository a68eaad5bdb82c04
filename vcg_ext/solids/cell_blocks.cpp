// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/solids/cell_blocks.h"

#include "vcg_ext/arrange/places.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/parts/sub_blocks.h"

#include <algorithm>

namespace index_boolean {

namespace {

class CellCollector {
public:
	CellCollector(const Arrangement& arrangement, const CellSet& isInside, Block& out)
	    : arrangement_(arrangement), mesh_(arrangement.mesh), isInside_(isInside), out_(out),
	      numbers_(arrangement.mesh.points.size() + arrangement.curve.pointCount(), kNone) {}

	bool isOutsideInside() const { return isInside_[0] != 0; }
	void collectFaces();
	void placeVertices();
	void markSuspects();

private:
	FaceSource shownSource(FaceId first, std::uint32_t piece, bool turned) const;
	void add(const Triangle& corners, FaceId source, std::uint32_t piece,
	         const CellLabels::Sides& sides);

	const Arrangement& arrangement_;
	const MeshArrays& mesh_;
	const CellSet& isInside_;
	Block& out_;
	std::vector<std::uint32_t> numbers_;  // per vertex: in the block
};

// Of the input faces that have a kept piece the one that it is shown as a part of: one that is
// turned as the block is, if any, and of these the one whose corners come first.
FaceSource CellCollector::shownSource(FaceId first, std::uint32_t piece, bool turned) const {
	FaceSource shown{first, turned};
	arrangement_.cells.visitOtherSources(piece, [&](const CellLabels::Source& source) {
		const FaceSource other{source.face, turned != source.opposed};
		const bool isBetter = other.turned != shown.turned ? shown.turned
		                                                   : sortedPlaces(mesh_, other.face) <
		                                                         sortedPlaces(mesh_, shown.face);
		shown = isBetter ? other : shown;
	});
	return shown;
}

// Adds a triangle if its cells differ. Corners keep their numbers in the arrangement for now.
// \param piece or kNone, if it is an input face
void CellCollector::add(const Triangle& corners, FaceId source, std::uint32_t piece,
                        const CellLabels::Sides& sides) {
	const bool isFrontInside = isInside_[sides[0]] != 0;
	if (isFrontInside == (isInside_[sides[1]] != 0)) {
		return;
	}
	for (const VertexId v : corners) {
		at(numbers_, v) = 0;
	}
	out_.triangles.push_back({corners[0].value, corners[isFrontInside ? 2 : 1].value,
	                          corners[isFrontInside ? 1 : 2].value});
	out_.faceSource.push_back(piece == kNone ? FaceSource{source, isFrontInside}
	                                         : shownSource(source, piece, isFrontInside));
}

void CellCollector::collectFaces() {
	const Refinement& refinement = arrangement_.refinement;
	const CellLabels& cells = arrangement_.cells;
	for (std::size_t f = 0; f < mesh_.triangles.size(); ++f) {
		if (refinement.isCut[f] == 0) {
			add(mesh_.triangles[f], makeId<FaceTag>(f), kNone, cells.ofFace[f]);
		}
	}
	out_.firstPiece = out_.triangles.size();
	for (std::size_t i = 0; i < refinement.cutFaces.size(); ++i) {
		const Refinement::PieceRange pieces = refinement.piecesOf(i);
		for (std::size_t piece = pieces.begin; piece < pieces.end; ++piece) {
			add(refinement.pieces[piece], refinement.cutFaces[i].face,
			    static_cast<std::uint32_t>(piece), cells.ofPiece[piece]);
		}
	}
}

void CellCollector::placeVertices() {
	for (std::uint32_t v = 0; v < numbers_.size(); ++v) {
		if (numbers_[v] != kNone) {
			numbers_[v] = static_cast<std::uint32_t>(out_.points.size());
			out_.points.push_back(outputCoordinates(arrangement_, {v}));
			out_.vertexSource.push_back({v});
		}
	}
	for (IndexTriangle& t : out_.triangles) {
		t = {numbers_[t[0]], numbers_[t[1]], numbers_[t[2]]};
	}
}

// The block may meet itself wherever several surfaces are, or one that is not one umbrella.
void CellCollector::markSuspects() {
	out_.suspect.assign(out_.points.size(), 0);
	for (std::size_t i = 0; i < out_.points.size(); ++i) {
		out_.suspect[i] = arrangement_.isOnOther(out_.vertexSource[i]) ? 1 : 0;
	}
	for (const VertexId v : arrangement_.nonManifold) {
		if (at(numbers_, v) != kNone) {
			out_.suspect[at(numbers_, v)] = 1;
		}
	}
	const auto isSuspect = [this](std::uint32_t v) { return out_.suspect[v] != 0; };
	out_.anySuspectOffCurve =
	    std::any_of(out_.triangles.begin(),
	                out_.triangles.begin() + static_cast<std::ptrdiff_t>(out_.firstPiece),
	                [&](const IndexTriangle& t) {
		                return isSuspect(t[0]) || isSuspect(t[1]) || isSuspect(t[2]);
	                });
}

}  // namespace

CellPredicate cellPredicateOf(Operation operation, WindingRule rule) {
	const auto of = [rule](bool (*truth)(bool, bool)) {
		return [rule, truth](const PerOperand<std::int32_t>& windings) {
			return truth(isInside(rule, windings[kFirst]), isInside(rule, windings[kSecond]));
		};
	};
	switch (operation) {
	case Operation::Union:
		return of([](bool a, bool b) { return a || b; });
	case Operation::Intersection:
		return of([](bool a, bool b) { return a && b; });
	case Operation::FirstMinusSecond:
		return of([](bool a, bool b) { return a && !b; });
	case Operation::SecondMinusFirst:
		return of([](bool a, bool b) { return b && !a; });
	case Operation::SymmetricDifference:
		break;
	}
	return of([](bool a, bool b) { return a != b; });
}

CellSet cellSetOf(const Arrangement& arrangement, const CellPredicate& isInside) {
	CellSet cells;
	for (const PerOperand<std::int32_t>& windings : arrangement.cells.windings) {
		cells.push_back(isInside(windings) ? 1 : 0);
	}
	return cells;
}

Status collectCells(const Arrangement& arrangement, const CellSet& isInside, Monitor& monitor,
                    Block& out) {
	out = Block{};
	if (!arrangement.cells.areKnown()) {
		return statusOf(StatusCode::InternalError);  // an arrangement that is not for blocks
	}
	CellCollector collector(arrangement, isInside, out);
	if (collector.isOutsideInside()) {
		return statusOf(StatusCode::InternalError);
	}
	collector.collectFaces();
	collector.placeVertices();
	collector.markSuspects();
	return statusOf(pollCancelled(monitor) ? StatusCode::Cancelled : StatusCode::Ok);
}

}  // namespace index_boolean
