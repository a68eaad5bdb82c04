// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A patch is a planar problem of its own, with its border fixed: what lies farther away has no
// reason to change.
#include "vcg_ext/arrange/piece_patches.h"

#include "vcg_ext/base/sorted_list.h"

#include <algorithm>

namespace index_boolean {

PiecePatches::PiecePatches(const Arrangement& arrangement, StoredFaults& faults, Monitor& monitor)
    : arrangement_(arrangement), faults_(faults), monitor_(monitor), patch_(arrangement) {
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
				neighbours_.push_back(other);
			}
		}
	}
}

// Adds whole rings.
void PiecePatches::growPatch() {
	constexpr std::size_t kEnough = 128;
	std::vector<std::uint32_t> ring = pieces_, next;
	sortUnique(pieces_);
	while (!ring.empty() && pieces_.size() < kEnough) {
		next.clear();
		for (const std::uint32_t piece : ring) {
			listNeighbours(piece);
			for (const std::uint32_t other : neighbours_) {
				if (!std::binary_search(pieces_.begin(), pieces_.end(), other)) {
					next.push_back(other);
				}
			}
		}
		sortUnique(next);
		pieces_.insert(pieces_.end(), next.begin(), next.end());
		sortUnique(pieces_);
		ring.swap(next);
	}
}

void PiecePatches::flipPatch() {
	const StoredSurface& surface = faults_.surface();
	triangles_.clear();
	edges_.clear();
	for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
		triangles_.push_back(surface.corners[pieces_[i]]);
		listNeighbours(pieces_[i]);
		for (const std::uint32_t other : neighbours_) {
			if (pieces_[i] < other && std::binary_search(pieces_.begin(), pieces_.end(), other)) {
				edges_.push_back({i, placeIn(pieces_, other)});
			}
		}
	}
	const FaceId plane = surface.inputFaces[pieces_.front()];
	if (patch_.flip(plane, false, surface.vertices.data(), edges_, monitor_, triangles_) > 0) {
		for (std::size_t i = 0; i < pieces_.size(); ++i) {
			faults_.setCorners(pieces_[i], triangles_[i]);
		}
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
		pieces_.clear();
		std::transform(first, last, std::back_inserter(pieces_),
		               [](const auto& p) { return p.second; });
		growPatch();
		flipPatch();
		first = last;
	}
}

}  // namespace index_boolean
