// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Count, add up, write: each pass in fixed chunks. A vertex is kept iff its class is, so no face
// has to mark its corners.
#include "vcg_ext/solids/blocks.h"

#include "vcg_ext/arrange/places.h"
#include "vcg_ext/base/huge_vector.h"
#include "vcg_ext/base/parallel.h"

#include <algorithm>
#include <cstring>

namespace index_boolean {

namespace {

constexpr std::size_t kGrain = 1 << 15;

// What becomes of the faces of one operand that have one label.
struct Rule {
	bool kept;
	bool turned;
};
constexpr Rule kDrop{false, false};
constexpr Rule kKeep{true, false};
constexpr Rule kTurn{true, true};

// [operation][operand][label]. A face is kept iff the operation's truth differs between its two
// sides, turned iff it is true in front of the face. Of two coinciding faces one is taken: facing
// the same way, the owner's (overlap_owners.h); else that of the operand whose solid is behind it.
// No face has one of the other labels: a face at a vertex on the other operand is cut, and its
// pieces are labelled, or refused. Whatever a label, there is a rule: a face without one goes, the
// block is not closed then, and the audit refuses it.
constexpr Rule kRules[kOperationCount][2][kLabelCount] = {
    // outside, inside, on: same way, on: opposite way; the others are left to be kDrop
    {{kKeep, kDrop, kKeep, kDrop}, {kKeep, kDrop, kKeep, kDrop}},  // union
    {{kDrop, kKeep, kKeep, kDrop}, {kDrop, kKeep, kKeep, kDrop}},  // intersection
    {{kKeep, kDrop, kDrop, kKeep}, {kDrop, kTurn, kDrop, kDrop}},  // first minus second
    {{kDrop, kTurn, kDrop, kDrop}, {kKeep, kDrop, kDrop, kKeep}},  // second minus first
    {{kKeep, kTurn, kDrop, kDrop}, {kKeep, kTurn, kDrop, kDrop}},  // symmetric difference
};

class BlockCollector {
public:
	BlockCollector(const Arrangement& arrangement, Operation operation, Monitor& monitor,
	               Block& out)
	    : arrangement_(arrangement), rules_(kRules[static_cast<std::size_t>(operation)]),
	      monitor_(monitor), out_(out) {}

	Status run();

private:
	Status collectVertices();
	Status collectFaces();
	void collectPieces();
	template <class Visit>
	void visitKeptPieces(Visit&& visit) const;

	const Rule& rule(OperandId operand, Label label) const {
		return rules_[operand.value][static_cast<std::size_t>(label)];
	}
	// Whether a vertex off the other operand is kept: its faces all have its label.
	bool keepsVertex(std::size_t v) const {
		const Label label = arrangement_.labels.vertex[v];
		const OperandId operand =
		    arrangement_.mesh.vertexOffsets.operandOf(static_cast<std::uint32_t>(v));
		return (label == Label::Outside || label == Label::Inside) && rule(operand, label).kept;
	}
	// A quiet face has no piece and no vertex with a label: its twin tells. Of twins that face the
	// same way, the first operand's is taken.
	const Rule& uncutRule(std::size_t face) const {
		const MeshArrays& mesh = arrangement_.mesh;
		const FaceId id = makeId<FaceTag>(face);
		const OperandId operand = mesh.operandOf(id);
		switch (mesh.quietTwin(id)) {
		case Twin::None:
			return rule(operand, at(arrangement_.labels.vertex, mesh.triangles[face][0]));
		case Twin::SameWay:
			return operand == kFirst ? rule(operand, Label::OnSame) : kDrop;
		case Twin::Opposite:
			return rule(operand, Label::OnOpposite);
		}
		return kDrop;
	}
	// Whether a piece stands for itself, or for the overlap that it is a part of.
	bool ownsPiece(std::size_t piece) const {
		const Labels& labels = arrangement_.labels;
		const std::uint8_t wanted = out_.operation == Operation::Union
		                                ? Labels::kOwnerInUnion
		                                : Labels::kOwnerInIntersection;
		return labels.piece[piece] != Label::OnSame || (labels.owner[piece] & wanted) != 0;
	}
	bool keepsFace(std::size_t face) const {
		return arrangement_.refinement.isCut[face] == 0 && uncutRule(face).kept;
	}
	std::vector<VertexId> keptOnOther() const;
	void addOnOther(const std::vector<VertexId>& vertices);
	void markSuspects(const std::vector<VertexId>& onCurve);
	void write(std::size_t slot, const std::array<std::uint32_t, 3>& corners, FaceId face,
	           bool turned);

	const Arrangement& arrangement_;
	const Rule (&rules_)[2][kLabelCount];
	Monitor& monitor_;
	Block& out_;
	HugeVector<std::uint32_t> newIndex_;  // per input vertex and curve point that is kept
};

// Counts what `keeps` in each chunk of n items; returns where each chunk's begin, the total last.
template <class Keeps>
Status countChunks(std::size_t n, int threads, Monitor& monitor, Keeps&& keeps,
                   std::vector<std::size_t>& begins) {
	begins.assign(chunkCount(n, kGrain) + 1, 0);
	const Status status = parallelForChunks(
	    n, kGrain, threads, monitor, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
		    std::size_t count = 0;
		    for (std::size_t i = begin; i < end; ++i) {
			    count += keeps(i) ? 1 : 0;
		    }
		    begins[chunk + 1] = count;
	    });
	for (std::size_t i = 0; i + 1 < begins.size(); ++i) {
		begins[i + 1] += begins[i];
	}
	return status;
}

Status BlockCollector::collectVertices() {
	const std::size_t n = arrangement_.mesh.points.size();
	const int threads = arrangement_.options.threads;
	const auto keeps = [this](std::size_t v) { return keepsVertex(v); };
	std::vector<std::size_t> begins;
	Status status = countChunks(n, threads, monitor_, keeps, begins);
	if (!status.ok()) {
		return status;
	}
	newIndex_.resizeForOverwrite(n + arrangement_.curve.pointCount());
	const std::vector<VertexId> onOther = keptOnOther();
	out_.points.reserve(begins.back() + onOther.size());
	out_.vertexSource.reserve(begins.back() + onOther.size());
	out_.points.resizeForOverwrite(begins.back());
	out_.vertexSource.resizeForOverwrite(begins.back());
	status = parallelForChunks(
	    n, kGrain, threads, monitor_, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
		    std::size_t slot = begins[chunk];
		    for (std::size_t v = begin; v < end; ++v) {
			    if (keepsVertex(v)) {
				    newIndex_[v] = static_cast<std::uint32_t>(slot);
				    out_.points[slot] = outputCoordinates(arrangement_, makeId<VertexTag>(v));
				    out_.vertexSource[slot] = makeId<VertexTag>(v);
				    ++slot;
			    }
		    }
	    });
	addOnOther(onOther);
	return status;
}

// Calls visit(face, piece, rule) for each piece that is kept.
template <class Visit>
void BlockCollector::visitKeptPieces(Visit&& visit) const {
	const Refinement& refinement = arrangement_.refinement;
	for (std::size_t i = 0; i < refinement.cutFaces.size(); ++i) {
		const CutFace& cutFace = refinement.cutFaces[i];
		const OperandId operand = arrangement_.mesh.operandOf(cutFace.face);
		const Refinement::PieceRange pieces = refinement.piecesOf(i);
		for (std::size_t piece = pieces.begin; piece < pieces.end; ++piece) {
			const Rule& pieceRule = rule(operand, arrangement_.labels.piece[piece]);
			if (pieceRule.kept && ownsPiece(piece)) {
				visit(cutFace.face, refinement.pieces[piece], pieceRule);
			}
		}
	}
}

// The vertices on the other operand that kept faces use, in the order of their ids.
std::vector<VertexId> BlockCollector::keptOnOther() const {
	HugeVector<std::uint8_t> isUsed;
	isUsed.assign(arrangement_.mesh.points.size() + arrangement_.curve.pointCount(), 0);
	const auto use = [&](const Triangle& t) {
		for (const VertexId v : t) {
			if (arrangement_.isOnOther(v)) {
				at(isUsed, v) = 1;
			}
		}
	};
	visitKeptPieces([&](FaceId, const Triangle& t, const Rule&) { use(t); });
	for (std::size_t f = 0; f < arrangement_.mesh.quietFaces.size(); ++f) {
		if (arrangement_.mesh.quietFaces[f] != Twin::None && uncutRule(f).kept) {
			use(arrangement_.mesh.triangles[f]);
		}
	}
	std::vector<VertexId> used;
	const std::uint8_t* const begin = isUsed.data();
	const std::uint8_t* const end = begin + isUsed.size();
	const auto next = [end](const std::uint8_t* from) {  // memchr finds a few among many at once
		const void* found = std::memchr(from, 1, static_cast<std::size_t>(end - from));
		return found != nullptr ? static_cast<const std::uint8_t*>(found) : end;
	};
	for (const std::uint8_t* mark = next(begin); mark != end; mark = next(mark + 1)) {
		used.push_back(makeId<VertexTag>(static_cast<std::size_t>(mark - begin)));
	}
	return used;
}

void BlockCollector::addOnOther(const std::vector<VertexId>& vertices) {
	for (const VertexId v : vertices) {
		at(newIndex_, v) = static_cast<std::uint32_t>(out_.points.size());
		out_.points.push_back(outputCoordinates(arrangement_, v));
		out_.vertexSource.push_back(v);
	}
	markSuspects(vertices);
}

// A symmetric difference meets itself all along the curve.
void BlockCollector::markSuspects(const std::vector<VertexId>& onCurve) {
	const bool all = out_.operation == Operation::SymmetricDifference;
	out_.suspect.assign(out_.points.size(), 0);
	for (const VertexId v : onCurve) {
		if (all || at(arrangement_.curve.irregular, v) != 0) {
			out_.suspect[at(newIndex_, v)] = 1;
		}
	}
	for (const VertexId v : arrangement_.nonManifold) {
		if (!arrangement_.isOnOther(v) && keepsVertex(v.value)) {
			out_.suspect[at(newIndex_, v)] = 1;
			out_.anySuspectOffCurve = true;
		} else if (std::binary_search(onCurve.begin(), onCurve.end(), v)) {
			out_.suspect[at(newIndex_, v)] = 1;
			out_.anySuspectOffCurve |= arrangement_.mesh.isQuiet(v);
		}
	}
}

void BlockCollector::write(std::size_t slot, const std::array<std::uint32_t, 3>& corners,
                           FaceId face, bool turned) {
	out_.triangles[slot] =
	    turned ? std::array<std::uint32_t, 3>{corners[0], corners[2], corners[1]} : corners;
	out_.faceSource[slot] = {face, turned};
}

Status BlockCollector::collectFaces() {
	const std::size_t n = arrangement_.mesh.triangles.size();
	const int threads = arrangement_.options.threads;
	const auto keeps = [this](std::size_t face) { return keepsFace(face); };
	std::vector<std::size_t> begins;
	const Status status = countChunks(n, threads, monitor_, keeps, begins);
	if (!status.ok()) {
		return status;
	}
	const std::size_t most = begins.back() + arrangement_.refinement.pieces.size();
	out_.triangles.reserve(most);
	out_.faceSource.reserve(most);
	out_.triangles.resizeForOverwrite(begins.back());
	out_.faceSource.resizeForOverwrite(begins.back());
	return parallelForChunks(
	    n, kGrain, threads, monitor_, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
		    std::size_t slot = begins[chunk];
		    for (std::size_t face = begin; face < end; ++face) {
			    if (keepsFace(face)) {
				    const Triangle& t = arrangement_.mesh.triangles[face];
				    write(slot++, {at(newIndex_, t[0]), at(newIndex_, t[1]), at(newIndex_, t[2])},
				          makeId<FaceTag>(face), uncutRule(face).turned);
			    }
		    }
	    });
}

void BlockCollector::collectPieces() {
	out_.firstPiece = out_.triangles.size();
	visitKeptPieces([&](FaceId face, const Triangle& t, const Rule& pieceRule) {
		out_.triangles.emplace_back();
		out_.faceSource.emplace_back();
		write(out_.triangles.size() - 1,
		      {at(newIndex_, t[0]), at(newIndex_, t[1]), at(newIndex_, t[2])}, face,
		      pieceRule.turned);
	});
}

Status BlockCollector::run() {
	const Status status =
	    inOrder([this] { return collectVertices(); }, [this] { return collectFaces(); });
	if (status.ok()) {
		collectPieces();
	}
	return status;
}

}  // namespace

const char* operationName(Operation operation) {
	switch (operation) {
	case Operation::Union:
		return "union";
	case Operation::Intersection:
		return "intersection";
	case Operation::FirstMinusSecond:
		return "first_minus_second";
	case Operation::SecondMinusFirst:
		return "second_minus_first";
	case Operation::SymmetricDifference:
		return "symmetric_difference";
	}
	return "";
}

Status collectBlock(const Arrangement& arrangement, Operation operation, Monitor& monitor,
                    Block& out) {
	out = Block{};
	out.operation = operation;
	if (arrangement.labels.vertex.size() != arrangement.mesh.points.size()) {
		return statusOf(StatusCode::InternalError);  // an arrangement that is not for blocks
	}
	return BlockCollector(arrangement, operation, monitor, out).run();
}

}  // namespace index_boolean
