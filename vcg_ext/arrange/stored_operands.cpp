// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One operand after another: its faces by what its winding number changes across each triangle,
// where that is known, so that what a fold has made twice or the wrong way round is gone.
#include "vcg_ext/arrange/stored_operands.h"

#include "vcg_ext/arrange/places.h"
#include "vcg_ext/arrange/refined_triangles.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/base/sorted_list.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace index_boolean {

namespace {

class OperandTaker {
public:
	OperandTaker(const Arrangement& arrangement, Monitor& monitor, StoredOperands& out)
	    : arrangement_(arrangement), mesh_(arrangement.mesh), monitor_(monitor), out_(out),
	      jumps_(arrangement.mesh.operands().count()),
	      numbers_(arrangement.mesh.points.size() + arrangement.curve.pointCount(), kNone) {}

	Status run();

private:
	template <class Visit>
	Status visitAll(std::size_t first, std::size_t count, Visit&& visit) const;
	Status takeAll(OperandId operand);
	Status takeOperand(OperandId operand);
	void listJumps(const Triangle& corners, FaceId face, std::uint32_t piece);
	FaceSource sourceOf(OperandId operand, FaceId face, std::uint32_t piece) const;
	void add(const Triangle& corners, const FaceSource& source, std::uint32_t piece, bool isTurned);
	VertexId numberOf(VertexId vertex);
	std::uint32_t classOf(OperandId operand, FaceId face) const;

	// A triangle that an operand's winding number changes across.
	struct Jump {
		Triangle corners;
		FaceSource source;
		std::uint32_t piece;
		bool isTurned;
	};

	const Arrangement& arrangement_;
	const MeshArrays& mesh_;
	Monitor& monitor_;
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

// As visitRefined, with a look at the monitor now and then.
template <class Visit>
Status OperandTaker::visitAll(std::size_t first, std::size_t count, Visit&& visit) const {
	constexpr std::size_t kGrain = 1 << 14;
	return inOrderFor(count, kGrain, monitor_, [&](std::size_t begin, std::size_t end) {
		visitRefined(arrangement_, first + begin, first + end, visit);
	});
}

// All triangles of an operand, as they are.
Status OperandTaker::takeAll(OperandId operand) {
	// In a soup the winding numbers have been turned, not the faces.
	const bool isTurned = arrangement_.isSoup && arrangement_.insideOut[operand];
	return visitAll(mesh_.faceOffsets.begin(operand), mesh_.faceOffsets.size(operand),
	                [&](const Triangle& corners, FaceId face, std::uint32_t piece) {
		                add(corners, {face, false}, piece, isTurned);
	                });
}

// Of the input faces of an operand that have a triangle the one whose corners come first, in
// whatever numbering.
FaceSource OperandTaker::sourceOf(OperandId operand, FaceId face, std::uint32_t piece) const {
	FaceSource found{face, false};
	arrangement_.cells.visitOtherSources(piece, [&](const CellLabels::Source& source) {
		if (mesh_.operandOf(source.face) == operand &&
		    (mesh_.operandOf(found.face) != operand ||
		     sortedPlaces(mesh_, source.face) < sortedPlaces(mesh_, found.face))) {
			found = {source.face, source.opposed};
		}
	});
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
	cells.visitOtherSources(piece, [&](const CellLabels::Source& source) {
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

Status OperandTaker::takeOperand(OperandId operand) {
	const std::size_t firstVertex = out_.vertexOf.size(), firstFace = out_.faceOf.size();
	for (const Jump& jump : jumps_[operand]) {
		add(jump.corners, jump.source, jump.piece, jump.isTurned);
	}
	// It may be open, or enclose nothing; or no cells are known.
	const Status status = jumps_[operand].empty() ? takeAll(operand) : Status{};
	out_.mesh.vertexOffsets.setEnd(operand, out_.vertexOf.size());
	out_.mesh.faceOffsets.setEnd(operand, out_.faceOf.size());
	for (std::size_t v = firstVertex; v < out_.vertexOf.size(); ++v) {
		at(numbers_, out_.vertexOf[v]) = kNone;
	}
	for (std::size_t f = firstFace; f < out_.faceOf.size(); ++f) {
		out_.mesh.faceClass[operand].push_back(classOf(operand, out_.faceOf[f].face));
	}
	return status;
}

Status OperandTaker::run() {
	const Operands operands = mesh_.operands();
	out_.mesh.vertexOffsets = out_.mesh.faceOffsets = OperandOffsets(operands.count());
	out_.mesh.faceClass = PerOperand<std::vector<std::uint32_t>>(operands.count());
	const std::size_t faces = arrangement_.cells.areKnown() ? mesh_.triangles.size() : 0;
	return inOrder(
	    [&] {
		    return visitAll(0, faces,
		                    [&](const Triangle& corners, FaceId face, std::uint32_t piece) {
			                    listJumps(corners, face, piece);
		                    });
	    },
	    [&] { return forEachOperand(operands, [&](OperandId o) { return takeOperand(o); }); });
}

}  // namespace

Status takeStoredOperands(const Arrangement& arrangement, Monitor& monitor, StoredOperands& out) {
	out = StoredOperands{};
	return OperandTaker(arrangement, monitor, out).run();
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
