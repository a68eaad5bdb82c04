// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A patch is a planar problem of its own, with its border fixed: what lies farther away has no
// reason to change.
#include "vcg_ext/arrange/piece_patches.h"

#include <algorithm>

namespace index_boolean {

namespace {

void sortUnique(std::vector<std::uint32_t>& items) {
	std::sort(items.begin(), items.end());
	items.erase(std::unique(items.begin(), items.end()), items.end());
}

std::uint32_t placeIn(const std::vector<std::uint32_t>& sorted, std::uint32_t item) {
	return static_cast<std::uint32_t>(std::lower_bound(sorted.begin(), sorted.end(), item) -
	                                  sorted.begin());
}

}  // namespace

PiecePatches::PiecePatches(const Arrangement& arrangement, StoredFaults& faults, Monitor& monitor)
    : arrangement_(arrangement), faults_(faults), monitor_(monitor), points_(arrangement) {
	for (const Segment& s : arrangement.curve.segments) {
		segments_.push_back({std::min(s.begin, s.end), std::max(s.begin, s.end)});
	}
	std::sort(segments_.begin(), segments_.end());
}

bool PiecePatches::isSegment(std::uint32_t a, std::uint32_t b) const {
	const std::vector<VertexId>& names = faults_.surface().vertices;
	return std::binary_search(
	    segments_.begin(), segments_.end(),
	    std::array{std::min(names[a], names[b]), std::max(names[a], names[b])});
}

// The pieces of the same region across the edges of one that are no segments.
void PiecePatches::listNeighbours(std::uint32_t piece) {
	neighbours_.clear();
	const IndexTriangle& t = faults_.surface().corners[piece];
	for (std::size_t i = 0; i < 3; ++i) {
		const std::uint32_t a = t[i], b = t[(i + 1) % 3];
		if (isSegment(a, b)) {
			continue;
		}
		for (const std::uint32_t other : faults_.facesAt(a)) {
			const IndexTriangle& u = faults_.surface().corners[other];
			if (other != piece && isPiece(other) && regionOf(other) == regionOf(piece) &&
			    std::find(u.begin(), u.end(), b) != u.end()) {
				neighbours_.push_back({other, {std::min(a, b), std::max(a, b)}});
			}
		}
	}
}

// Adds whole rings.
void PiecePatches::growPatch() {
	constexpr std::size_t kEnough = 128;
	std::vector<std::uint32_t> ring = patch_, next;
	sortUnique(patch_);
	while (!ring.empty() && patch_.size() < kEnough) {
		next.clear();
		for (const std::uint32_t piece : ring) {
			listNeighbours(piece);
			for (const Neighbour& n : neighbours_) {
				if (!std::binary_search(patch_.begin(), patch_.end(), n.piece)) {
					next.push_back(n.piece);
				}
			}
		}
		sortUnique(next);
		patch_.insert(patch_.end(), next.begin(), next.end());
		sortUnique(patch_);
		ring.swap(next);
	}
}

// False if two points are in one place, which they are nowhere in a face.
bool PiecePatches::rankPoints(int axis) {
	const StoredSurface& surface = faults_.surface();
	vertices_.clear();
	names_.clear();
	for (const std::uint32_t piece : patch_) {
		const IndexTriangle& t = surface.corners[piece];
		vertices_.insert(vertices_.end(), t.begin(), t.end());
	}
	sortUnique(vertices_);
	for (const std::uint32_t v : vertices_) {
		names_.push_back(surface.vertices[v]);
	}
	points_.take(names_);
	return points_.rank(axis);
}

void PiecePatches::flipPatch() {
	const StoredSurface& surface = faults_.surface();
	int front = 0;
	const int axis =
	    projectionAxis(at(arrangement_.mesh.triangles, surface.inputFaces[patch_.front()]),
	                   arrangement_.mesh.points, front);
	if (!rankPoints(axis)) {
		return;
	}
	const auto rankOf = [this](std::uint32_t v) { return points_.rankAt(placeIn(vertices_, v)); };
	triangles_.clear();
	edges_.clear();
	for (std::uint32_t i = 0; i < patch_.size(); ++i) {
		const IndexTriangle& t = surface.corners[patch_[i]];
		triangles_.push_back({rankOf(t[0]), rankOf(t[1]), rankOf(t[2])});
		listNeighbours(patch_[i]);
		for (const Neighbour& n : neighbours_) {
			if (patch_[i] < n.piece && std::binary_search(patch_.begin(), patch_.end(), n.piece)) {
				const std::uint32_t a = rankOf(n.ends.left), b = rankOf(n.ends.right);
				edges_.push_back({{std::min(a, b), std::max(a, b)}, {i, placeIn(patch_, n.piece)}});
			}
		}
	}
	if (edges_.empty() ||
	    flips_.run(edges_, points_.places(), front, points_, monitor_, triangles_) == 0) {
		return;
	}
	for (std::size_t i = 0; i < patch_.size(); ++i) {
		IndexTriangle t;
		for (std::size_t k = 0; k < 3; ++k) {
			t[k] = vertices_[points_.indexAt(triangles_[i][k])];
		}
		faults_.setCorners(patch_[i], t);
	}
}

void PiecePatches::flipAround(const std::vector<std::uint32_t>& vertices) {
	std::vector<std::pair<NodeId, std::uint32_t>> pieces;
	for (const std::uint32_t v : vertices) {
		for (const std::uint32_t face : faults_.facesAt(v)) {
			if (isPiece(face)) {
				pieces.emplace_back(regionOf(face), face);
			}
		}
	}
	std::sort(pieces.begin(), pieces.end());
	for (auto first = pieces.begin(); first != pieces.end();) {
		const auto last = std::find_if(first, pieces.end(),
		                               [first](const auto& p) { return p.first != first->first; });
		patch_.clear();
		std::transform(first, last, std::back_inserter(patch_),
		               [](const auto& p) { return p.second; });
		growPatch();
		flipPatch();
		first = last;
	}
}

}  // namespace index_boolean
