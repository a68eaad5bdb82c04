// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Why it is a proof: pieces of positive area, all turned alike, are glued along every inner edge
// from both sides, and end at the face's border. So the number of layers over a place changes
// nowhere inside the face, and is one at its border.
#include "vcg_ext/arrange/face_pieces.h"

#include <algorithm>
#include <numeric>

namespace index_boolean {

namespace {

std::uint32_t findRoot(std::vector<std::uint32_t>& parent, std::uint32_t i) {
	while (parent[i] != i) {
		parent[i] = parent[parent[i]];
		i = parent[i];
	}
	return i;
}

}  // namespace

void FacePieces::turn() {
	for (auto& t : triangles) {
		std::swap(t[1], t[2]);
	}
}

// Enters the pieces beside each edge. False if two pieces lie on one side of an edge, or if there
// are more edges than there can be.
bool FacePieces::findSides(FaceEdges& edges) const {
	for (std::uint32_t piece = 0; piece < triangles.size(); ++piece) {
		for (int i = 0; i < 3; ++i) {
			const std::uint32_t from = triangles[piece][static_cast<std::size_t>(i)];
			const std::uint32_t to = triangles[piece][static_cast<std::size_t>(nextCorner(i))];
			FaceEdge* edge = edges.named(from, to);
			std::uint32_t* beside = edge != nullptr ? &edge->pieces[from < to ? 1 : 0] : nullptr;
			if (beside == nullptr || *beside != kNone) {
				return false;
			}
			*beside = piece;
		}
	}
	return true;
}

// Joins pieces across edges that are not fixed. False unless every border edge has one piece and
// every other edge two.
bool FacePieces::uniteSides(const FaceEdges& edges) {
	regionOf_.resize(triangles.size());
	std::iota(regionOf_.begin(), regionOf_.end(), 0u);
	for (const FaceEdge& edge : edges.all()) {
		if (edge.pieceCount() != (edge.isBorder ? 1U : 2U)) {
			return false;
		}
		if (!edge.isFixed) {
			const std::uint32_t a = findRoot(regionOf_, edge.pieces[0]);
			const std::uint32_t b = findRoot(regionOf_, edge.pieces[1]);
			regionOf_[std::max(a, b)] = std::min(a, b);
		}
	}
	return true;
}

// A root is the first piece of its region, so one pass in order numbers them all.
void FacePieces::numberRegions() {
	regionCount_ = 0;
	number_.resize(regionOf_.size());
	for (std::uint32_t piece = 0; piece < regionOf_.size(); ++piece) {
		const std::uint32_t root = findRoot(regionOf_, piece);
		number_[piece] = root == piece ? regionCount_++ : number_[root];
	}
	regionOf_.swap(number_);
}

bool FacePieces::certify(FaceEdges& edges) {
	if (!findSides(edges) || !uniteSides(edges)) {
		return false;
	}
	numberRegions();
	return true;
}

// Flips exchange triangles among the pieces' numbers.
void FacePieces::enterBesideFixed(FaceEdges& edges) const {
	for (std::uint32_t piece = 0; piece < triangles.size(); ++piece) {
		for (int i = 0; i < 3; ++i) {
			if (flips_.isFree(piece, static_cast<std::size_t>(i))) {
				continue;
			}
			const std::uint32_t from = triangles[piece][static_cast<std::size_t>(i)];
			const std::uint32_t to = triangles[piece][static_cast<std::size_t>(nextCorner(i))];
			edges.named(from, to)->pieces[from < to ? 1 : 0] = piece;
		}
	}
}

void FacePieces::flip(FaceEdges& edges, const FacePoints& points, int front, Monitor& monitor) {
	freeEdges_.clear();
	for (const FaceEdge& edge : edges.others()) {
		freeEdges_.push_back({edge.ranks, edge.pieces});
	}
	if (!freeEdges_.empty() &&
	    flips_.run(freeEdges_, points.places(), front, points, monitor, triangles) > 0) {
		enterBesideFixed(edges);
	}
}

}  // namespace index_boolean
