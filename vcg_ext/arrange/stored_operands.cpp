// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One operand after another: its faces by what its winding number changes across each triangle,
// where that is known, so that what a fold has made twice or the wrong way round is gone.
#include "vcg_ext/arrange/stored_operands.h"

#include "vcg_ext/arrange/places.h"
#include "vcg_ext/base/sorted_list.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace index_boolean {

namespace {

class OperandTaker {
public:
	OperandTaker(const Arrangement& arrangement, StoredOperands& out)
	    : arrangement_(arrangement), mesh_(arrangement.mesh), out_(out),
	      jumps_(arrangement.mesh.operands().count()),
	      numbers_(arrangement.mesh.points.size() + arrangement.curve.pointCount(), kNone) {}

	void run();

private:
	void takeAll(OperandId operand);
	void listJumps(const Triangle& corners, FaceId face, std::uint32_t piece);
	std::array<Point, 3> placesOf(FaceId face) const;
	FaceSource sourceOf(OperandId operand, FaceId face, std::uint32_t piece) const;
	void add(const Triangle& corners, const FaceSource& source, std::uint32_t piece, bool isTurned);
	VertexId numberOf(VertexId vertex);
	std::uint32_t classOf(OperandId operand, FaceId face) const;

	// Calls visit(corners, face, piece) for the faces [begin, end): for each that is not cut, with
	// kNone, and for all pieces of the others.
	template <class Visit>
	void visitTriangles(std::uint32_t begin, std::uint32_t end, Visit&& visit) const;

	template <class Visit>
	void visitOtherSources(std::uint32_t piece, Visit&& visit) const;

	// A triangle that an operand's winding number changes across.
	struct Jump {
		Triangle corners;
		FaceSource source;
		std::uint32_t piece;
		bool isTurned;
	};

	const Arrangement& arrangement_;
	const MeshArrays& mesh_;
	StoredOperands& out_;
	PerOperand<std::vector<Jump>> jumps_;
	std::vector<std::uint32_t> numbers_;  // per vertex: in the operand that is being taken
};

VertexId OperandTaker::numberOf(VertexId vertex) {
	std::uint32_t& number = at(numbers_, vertex);
	if (number == kNone) {
		number = static_cast<std::uint32_t>(out_.vertexOf.size());
		out_.vertexOf.push_back(vertex);
		out_.mesh.points.push_back(outputCoordinates(arrangement_, vertex));
	}
	return {number};
}

// \param source   of which the triangle is a piece as it is, not turned
// \param isTurned the operand has it turned over
void OperandTaker::add(const Triangle& corners, const FaceSource& source, std::uint32_t piece,
                       bool isTurned) {
	Triangle t{numberOf(corners[0]), numberOf(corners[1]), numberOf(corners[2])};
	if (isTurned) {
		std::swap(t[1], t[2]);
	}
	out_.mesh.triangles.push_back(t);
	out_.faceOf.push_back({source.face, source.turned != isTurned});
	out_.pieceOf.push_back(piece);
}

template <class Visit>
void OperandTaker::visitTriangles(std::uint32_t begin, std::uint32_t end, Visit&& visit) const {
	const Refinement& refinement = arrangement_.refinement;
	const auto first =
	    std::lower_bound(refinement.cutFaces.begin(), refinement.cutFaces.end(), FaceId{begin},
	                     [](const CutFace& cut, FaceId face) { return cut.face < face; });
	auto cut = static_cast<std::size_t>(first - refinement.cutFaces.begin());
	for (std::uint32_t f = begin; f < end; ++f) {
		if (refinement.isCut[f] == 0) {
			visit(mesh_.triangles[f], FaceId{f}, kNone);
			continue;
		}
		const Refinement::PieceRange pieces = refinement.piecesOf(cut++);
		for (std::size_t piece = pieces.begin; piece < pieces.end; ++piece) {
			visit(refinement.pieces[piece], FaceId{f}, static_cast<std::uint32_t>(piece));
		}
	}
}

// Calls visit(source) for the input faces that have a piece besides its own.
template <class Visit>
void OperandTaker::visitOtherSources(std::uint32_t piece, Visit&& visit) const {
	const auto& all = arrangement_.cells.otherSources;
	const auto before = [](const CellLabels::Source& s, std::uint32_t p) { return s.piece < p; };
	for (auto s = std::lower_bound(all.begin(), all.end(), piece, before);
	     s != all.end() && s->piece == piece; ++s) {
		visit(*s);
	}
}

// All triangles of an operand, as they are.
void OperandTaker::takeAll(OperandId operand) {
	// In a soup the winding numbers have been turned, not the faces.
	const bool isTurned = arrangement_.isSoup && arrangement_.insideOut[operand];
	visitTriangles(mesh_.faceOffsets.begin(operand), mesh_.faceOffsets.end(operand),
	               [&](const Triangle& corners, FaceId face, std::uint32_t piece) {
		               add(corners, {face, false}, piece, isTurned);
	               });
}

std::array<Point, 3> OperandTaker::placesOf(FaceId face) const {
	const Triangle& t = at(mesh_.triangles, face);
	std::array<Point, 3> places{at(mesh_.points, t[0]), at(mesh_.points, t[1]),
	                            at(mesh_.points, t[2])};
	std::sort(places.begin(), places.end());
	return places;
}

// Of the input faces of an operand that have a triangle the one whose corners come first, in
// whatever numbering.
FaceSource OperandTaker::sourceOf(OperandId operand, FaceId face, std::uint32_t piece) const {
	FaceSource found{face, false};
	const auto& all = arrangement_.cells.otherSources;
	const auto before = [](const CellLabels::Source& s, std::uint32_t p) { return s.piece < p; };
	for (auto s = std::lower_bound(all.begin(), all.end(), piece, before);
	     s != all.end() && s->piece == piece; ++s) {
		if (mesh_.operandOf(s->face) == operand &&
		    (mesh_.operandOf(found.face) != operand || placesOf(s->face) < placesOf(found.face))) {
			found = {s->face, s->opposed};
		}
	}
	return found;
}

// Notes of which operands a triangle is a wall: only of those that have a face there.
void OperandTaker::listJumps(const Triangle& corners, FaceId face, std::uint32_t piece) {
	const CellLabels& cells = arrangement_.cells;
	const CellLabels::Sides& sides = piece == kNone ? at(cells.ofFace, face) : cells.ofPiece[piece];
	if (sides[0] == sides[1]) {
		return;
	}
	std::vector<OperandId> owners{mesh_.operandOf(face)};
	visitOtherSources(piece, [&](const CellLabels::Source& source) {
		owners.push_back(mesh_.operandOf(source.face));
	});
	sortUnique(owners);
	for (const OperandId operand : owners) {
		const int jump = cells.windings[sides[1]][operand] - cells.windings[sides[0]][operand];
		for (int i = 0; i < std::abs(jump); ++i) {
			jumps_[operand].push_back({corners, sourceOf(operand, face, piece), piece, jump < 0});
		}
	}
}

std::uint32_t OperandTaker::classOf(OperandId operand, FaceId face) const {
	if (!arrangement_.options.mergeCoplanar) {
		return face.value;
	}
	const auto& classes = mesh_.faceClass;
	const bool areGiven = operand.value < classes.size() && !classes[operand].empty();
	return areGiven ? classes[operand][arrangement_.givenFace(face)] : 0;
}

void OperandTaker::run() {
	const Operands operands = mesh_.operands();
	if (arrangement_.cells.areKnown()) {
		visitTriangles(0, mesh_.faceOffsets.total(),
		               [&](const Triangle& corners, FaceId face, std::uint32_t piece) {
			               listJumps(corners, face, piece);
		               });
	}
	out_.mesh.vertexOffsets = out_.mesh.faceOffsets = OperandOffsets(operands.count());
	out_.mesh.faceClass = PerOperand<std::vector<std::uint32_t>>(operands.count());
	for (const OperandId operand : operands) {
		const std::size_t firstVertex = out_.vertexOf.size(), firstFace = out_.faceOf.size();
		for (const Jump& jump : jumps_[operand]) {
			add(jump.corners, jump.source, jump.piece, jump.isTurned);
		}
		if (jumps_[operand].empty()) {  // it is open or encloses nothing, or no cells are known
			takeAll(operand);
		}
		out_.mesh.vertexOffsets.setEnd(operand, out_.vertexOf.size());
		out_.mesh.faceOffsets.setEnd(operand, out_.faceOf.size());
		for (std::size_t v = firstVertex; v < out_.vertexOf.size(); ++v) {
			at(numbers_, out_.vertexOf[v]) = kNone;
		}
		for (std::size_t f = firstFace; f < out_.faceOf.size(); ++f) {
			out_.mesh.faceClass[operand].push_back(classOf(operand, out_.faceOf[f].face));
		}
	}
}

}  // namespace

void takeStoredOperands(const Arrangement& arrangement, StoredOperands& out) {
	out = StoredOperands{};
	OperandTaker(arrangement, out).run();
}

void nameFacesAsFirst(const StoredAgain& again, HugeVector<FaceSource>& faces) {
	for (FaceSource& source : faces) {
		const FaceSource& before = at(again.faceOf, source.face);
		source = {before.face, source.turned != before.turned};
	}
}

void nameVerticesAsFirst(const StoredAgain& again, HugeVector<VertexId>& vertices) {
	for (VertexId& v : vertices) {
		v = v.value < again.vertexOf.size() ? at(again.vertexOf, v) : VertexId::none();
	}
}

}  // namespace index_boolean
