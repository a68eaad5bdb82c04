// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Both operands have the same pieces in an overlap, so a piece's twin is found by its corners.
#include "vcg_ext/solids/overlap_owners.h"

#include "vcg_ext/base/edge_table.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/base/union_find.h"

#include <algorithm>

namespace index_boolean {

namespace {

// An input face that takes part in an overlap: its corners in lexicographic order, and whether all
// of it does.
struct Wall {
	std::array<Point, 3> corners;
	bool isWhole;

	friend bool operator<(const Wall& a, const Wall& b) { return a.corners < b.corners; }
	friend bool operator==(const Wall& a, const Wall& b) { return a.corners == b.corners; }
};

using PieceEdge = EdgeItem<std::uint32_t>;  // of a piece

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
	std::vector<PieceEdge> sortedEdges() const;
	void uniteNeighbours(const std::vector<PieceEdge>& edges);
	void listClaims(const std::vector<PieceEdge>& edges);
	void addClaim(std::uint32_t overlap, std::uint32_t piece);
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
		const Refinement::PieceRange pieces = refinement_.piecesOf(i);
		std::fill(parent_.begin() + static_cast<std::ptrdiff_t>(pieces.begin),
		          parent_.begin() + static_cast<std::ptrdiff_t>(pieces.end),
		          refinement_.cutFaces[i].face);
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

std::vector<PieceEdge> Chooser::sortedEdges() const {
	std::vector<PieceEdge> edges;
	for (std::uint32_t piece = 0; piece < parent_.size(); ++piece) {
		const Triangle& t = refinement_.pieces[piece];
		for (std::size_t i = 0; i < 3; ++i) {
			edges.push_back(makeEdgeItem(t[i].value, t[i == 2 ? 0 : i + 1].value, piece));
		}
	}
	std::sort(edges.begin(), edges.end());
	return edges;
}

// Overlaps that share an edge are one.
void Chooser::uniteNeighbours(const std::vector<PieceEdge>& edges) {
	forEachSortedEdge(edges.begin(), edges.end(), [this](auto first, auto last) {
		std::uint32_t one = kNone;  // of the overlap's pieces there
		for (auto edge = first; edge != last; ++edge) {
			if (isOverlap(edge->item)) {
				one = one == kNone ? edge->item : overlaps_.unite(one, edge->item);
			}
		}
	});
	overlaps_.flatten();
}

// A piece beside an overlap, of a wall that takes part in it.
void Chooser::addClaim(std::uint32_t overlap, std::uint32_t piece) {
	const Label label = arrangement_.labels.piece[piece];
	Claims& claims = claims_[overlaps_.root(overlap)];
	claims.inUnion[operandOf(piece)] |= label == Label::Outside;
	claims.inIntersection[operandOf(piece)] |= label == Label::Inside;
}

// \pre all overlaps have been joined
void Chooser::listClaims(const std::vector<PieceEdge>& edges) {
	claims_.resize(parent_.size());
	forEachSortedEdge(edges.begin(), edges.end(), [this](auto first, auto last) {
		for (auto a = first; a != last; ++a) {
			for (auto b = first; b != last && isOverlap(a->item); ++b) {
				if (parent_[a->item] == parent_[b->item]) {
					addClaim(a->item, b->item);
				}
			}
		}
	});
}

// The faces of each operand that take part in each overlap.
void Chooser::listWalls() {
	walls_.resize(parent_.size());
	for (std::size_t i = 0; i < refinement_.cutFaces.size(); ++i) {
		const Refinement::PieceRange pieces = refinement_.piecesOf(i);
		bool isWhole = true;
		for (std::size_t piece = pieces.begin; piece < pieces.end; ++piece) {
			isWhole = isWhole && isOverlap(static_cast<std::uint32_t>(piece));
		}
		const Triangle& t = at(arrangement_.mesh.triangles, refinement_.cutFaces[i].face);
		const Points& points = arrangement_.mesh.points;
		Wall wall{{at(points, t[0]), at(points, t[1]), at(points, t[2])}, isWhole};
		std::sort(wall.corners.begin(), wall.corners.end());
		for (auto piece = static_cast<std::uint32_t>(pieces.begin); piece < pieces.end; ++piece) {
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
	const std::vector<PieceEdge> edges = sortedEdges();
	uniteNeighbours(edges);
	listClaims(edges);
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
