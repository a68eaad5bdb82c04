// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A patch is a planar problem as a cut face is one, but for what is known of edges.
#include "vcg_ext/arrange/planar_patch.h"

#include "vcg_ext/base/sorted_list.h"

#include <algorithm>

namespace index_boolean {

// Copies are in one place, which makes no difference: no flip across them is legal.
void PlanarPatch::rankVertices(int axis, const VertexId* names,
                               const std::vector<IndexTriangle>& triangles) {
	vertices_.clear();
	names_.clear();
	for (const IndexTriangle& t : triangles) {
		vertices_.insert(vertices_.end(), t.begin(), t.end());
	}
	sortUnique(vertices_);
	for (const std::uint32_t v : vertices_) {
		names_.push_back(names[v]);
	}
	points_.take(names_);
	points_.rank(axis);
}

// The ranks of the two corners that two triangles have in common.
PlanarEdge PlanarPatch::commonEdge(const FreePair& pair) const {
	const auto& other = ranked_[pair[1]];
	std::array<std::uint32_t, 2> ends{};
	std::size_t count = 0;
	for (const std::uint32_t v : ranked_[pair[0]]) {
		if (count < 2 && std::find(other.begin(), other.end(), v) != other.end()) {
			ends[count++] = v;
		}
	}
	return {std::min(ends[0], ends[1]), std::max(ends[0], ends[1])};
}

std::size_t PlanarPatch::flip(FaceId plane, bool turned, const VertexId* names,
                              const std::vector<FreePair>& edges, Monitor& monitor,
                              std::vector<IndexTriangle>& triangles) {
	if (edges.empty()) {
		return 0;
	}
	int front = 0;
	const MeshArrays& mesh = arrangement_.mesh;
	const int axis = projectionAxis(at(mesh.triangles, plane), mesh.points, front);
	rankVertices(axis, names, triangles);
	const auto rankOf = [this](std::uint32_t v) { return points_.rankAt(placeIn(vertices_, v)); };
	ranked_.clear();
	for (const IndexTriangle& t : triangles) {
		ranked_.push_back({rankOf(t[0]), rankOf(t[1]), rankOf(t[2])});
	}
	edges_.clear();
	for (const FreePair& pair : edges) {
		edges_.push_back({commonEdge(pair), pair});
	}
	const std::size_t count =
	    flips_.run(edges_, points_.places(), turned ? -front : front, points_, monitor, ranked_);
	for (std::size_t i = 0; i < triangles.size() && count > 0; ++i) {
		for (std::size_t k = 0; k < 3; ++k) {
			triangles[i][k] = vertices_[points_.indexAt(ranked_[i][k])];
		}
	}
	return count;
}

}  // namespace index_boolean
