// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Both operands have the same pieces in an overlap, so a piece's twin is found by its corners.
#include "vcg_ext/solids/overlap_owners.h"

#include "vcg_ext/base/parallel.h"
#include "vcg_ext/base/union_find.h"

#include <algorithm>

namespace index_boolean {

namespace {

// An edge of a piece.
struct PieceEdge {
	VertexId low, high;
	std::uint32_t piece;

	bool sameEdge(const PieceEdge& other) const { return low == other.low && high == other.high; }
};

// An input face that takes part in an overlap: its corners in lexicographic order, and whether all
// of it does.
struct Wall {
	std::array<Point, 3> corners;
	bool isWhole;

	friend bool operator<(const Wall& a, const Wall& b) { return a.corners < b.corners; }
	friend bool operator==(const Wall& a, const Wall& b) { return a.corners == b.corners; }
};

class Chooser {
public:
	explicit Chooser(Arrangement& arrangement)
	    : arrangement_(arrangement), refinement_(arrangement.refinement),
	      overlaps_(arrangement.refinement.pieces.size()) {}

	void run();

private:
	// What speaks for an operand: how its walls go on beyond an overlap.
	struct Claims {
		PerOperand<bool> inUnion, inIntersection;
	};

	void listParents();
	void uniteTwins();
	void visitEdges();
	void visitEdge(const PieceEdge* begin, const PieceEdge* end);
	void listWalls();
	void setOwners();
	OperandId ownerByShape(std::uint32_t overlap) const;

	bool isOverlap(std::uint32_t piece) const {
		return arrangement_.labels.piece[piece] == Label::OnSame;
	}
	OperandId operandOf(std::uint32_t piece) const {
		return arrangement_.mesh.operandOf(parent_[piece]);
	}

	Arrangement& arrangement_;
	const Refinement& refinement_;
	std::vector<FaceId> parent_;  // per piece
	UnionFind overlaps_;          // over pieces; sets: overlaps with their twins
	std::vector<Claims> claims_;  // per overlap's root
	std::vector<PerOperand<std::vector<Wall>>> walls_;  // per overlap's root and operand
};

void Chooser::listParents() {
	parent_.resize(refinement_.pieces.size());
	for (std::size_t i = 0; i < refinement_.cutFaces.size(); ++i) {
		const std::size_t end = i + 1 < refinement_.cutFaces.size()
		                            ? refinement_.cutFaces[i + 1].firstPiece
		                            : refinement_.pieces.size();
		for (std::size_t piece = refinement_.cutFaces[i].firstPiece; piece < end; ++piece) {
			parent_[piece] = refinement_.cutFaces[i].face;
		}
	}
}

void Chooser::uniteTwins() {
	std::vector<std::pair<Triangle, std::uint32_t>> pieces;
	for (std::uint32_t piece = 0; piece < parent_.size(); ++piece) {
		if (isOverlap(piece)) {
			Triangle corners = refinement_.pieces[piece];
			std::sort(corners.begin(), corners.end());
			pieces.emplace_back(corners, piece);
		}
	}
	std::sort(pieces.begin(), pieces.end());
	for (std::size_t i = 1; i < pieces.size(); ++i) {
		if (pieces[i].first == pieces[i - 1].first) {
			overlaps_.unite(pieces[i].second, pieces[i - 1].second);
		}
	}
}

void Chooser::visitEdges() {
	std::vector<PieceEdge> edges;
	for (std::uint32_t piece = 0; piece < parent_.size(); ++piece) {
		for (int i = 0; i < 3; ++i) {
			const Triangle& t = refinement_.pieces[piece];
			const auto edge = std::minmax(t[static_cast<std::size_t>(i)],
			                              t[static_cast<std::size_t>(nextCorner(i))]);
			edges.push_back({edge.first, edge.second, piece});
		}
	}
	std::sort(edges.begin(), edges.end(), [](const PieceEdge& a, const PieceEdge& b) {
		return a.low != b.low     ? a.low < b.low
		       : a.high != b.high ? a.high < b.high
		                          : a.piece < b.piece;
	});
	// First all overlaps are joined, then their neighbours are asked.
	claims_.clear();
	for (const bool asking : {false, true}) {
		claims_.resize(asking ? parent_.size() : 0);
		for (std::size_t i = 0; i < edges.size();) {
			std::size_t end = i + 1;
			while (end < edges.size() && edges[end].sameEdge(edges[i])) {
				++end;
			}
			visitEdge(&edges[i], edges.data() + end);
			i = end;
		}
		overlaps_.flatten();
	}
}

void Chooser::visitEdge(const PieceEdge* begin, const PieceEdge* end) {
	for (const PieceEdge* a = begin; a != end; ++a) {
		for (const PieceEdge* b = begin; b != end && isOverlap(a->piece); ++b) {
			if (claims_.empty() && isOverlap(b->piece)) {
				overlaps_.unite(a->piece, b->piece);
			} else if (!claims_.empty() && parent_[a->piece] == parent_[b->piece]) {
				const Label label = arrangement_.labels.piece[b->piece];
				Claims& claims = claims_[overlaps_.root(a->piece)];
				claims.inUnion[operandOf(b->piece)] |= label == Label::Outside;
				claims.inIntersection[operandOf(b->piece)] |= label == Label::Inside;
			}
		}
	}
}

// The faces of each operand that take part in each overlap.
void Chooser::listWalls() {
	walls_.resize(parent_.size());
	for (std::uint32_t first = 0, end = 0; first < parent_.size(); first = end) {
		bool isWhole = true;
		for (end = first; end < parent_.size() && parent_[end] == parent_[first]; ++end) {
			isWhole = isWhole && isOverlap(end);
		}
		const Triangle& t = at(arrangement_.mesh.triangles, parent_[first]);
		const Points& points = arrangement_.mesh.points;
		Wall wall{{at(points, t[0]), at(points, t[1]), at(points, t[2])}, isWhole};
		std::sort(wall.corners.begin(), wall.corners.end());
		for (std::uint32_t piece = first; piece < end; ++piece) {
			if (isOverlap(piece)) {
				walls_[overlaps_.root(piece)][operandOf(piece)].push_back(wall);
			}
		}
	}
	for (auto& both : walls_) {
		for (std::vector<Wall>& walls : both) {
			std::sort(walls.begin(), walls.end());
			walls.erase(std::unique(walls.begin(), walls.end()), walls.end());
		}
	}
}

// Faces that lie in the overlap as a whole need no cut; else fewer faces need fewer.
OperandId Chooser::ownerByShape(std::uint32_t overlap) const {
	const std::vector<Wall>& first = walls_[overlap][kFirst];
	const std::vector<Wall>& second = walls_[overlap][kSecond];
	const auto isWhole = [](const Wall& wall) { return wall.isWhole; };
	const bool firstIsWhole = std::all_of(first.begin(), first.end(), isWhole);
	const bool secondIsWhole = std::all_of(second.begin(), second.end(), isWhole);
	if (firstIsWhole != secondIsWhole) {
		return secondIsWhole ? kSecond : kFirst;
	}
	if (first.size() != second.size()) {
		return second.size() < first.size() ? kSecond : kFirst;
	}
	return second < first ? kSecond : kFirst;
}

void Chooser::setOwners() {
	std::vector<OperandId> byShape(parent_.size(),
	                               OperandId::none());  // per overlap's root, once asked
	std::vector<std::uint8_t>& owner = arrangement_.labels.owner;
	owner.assign(parent_.size(), 0);
	for (std::uint32_t piece = 0; piece < parent_.size(); ++piece) {
		if (!isOverlap(piece)) {
			continue;
		}
		const std::uint32_t overlap = overlaps_.root(piece);
		OperandId& shape = byShape[overlap];
		shape = shape == OperandId::none() ? ownerByShape(overlap) : shape;
		const auto owns = [&](const PerOperand<bool>& claims) {
			const OperandId only = claims[kSecond] ? kSecond : kFirst;
			return (claims[kFirst] == claims[kSecond] ? shape : only) == operandOf(piece);
		};
		owner[piece] = static_cast<std::uint8_t>(
		    (owns(claims_[overlap].inUnion) ? Labels::kOwnerInUnion : 0) |
		    (owns(claims_[overlap].inIntersection) ? Labels::kOwnerInIntersection : 0));
	}
}

void Chooser::run() {
	listParents();
	uniteTwins();
	visitEdges();
	listWalls();
	setOwners();
}

}  // namespace

Status chooseOverlapOwners(Arrangement& arrangement, Monitor& monitor) {
	Status status;
	const std::vector<Label>& labels = arrangement.labels.piece;
	if (std::find(labels.begin(), labels.end(), Label::OnSame) != labels.end()) {
		Chooser(arrangement).run();
	}
	status.code = pollCancelled(monitor) ? StatusCode::Cancelled : StatusCode::Ok;
	return status;
}

}  // namespace index_boolean
