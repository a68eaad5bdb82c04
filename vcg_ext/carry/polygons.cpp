// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A set of faces is a simple polygon iff all its vertices are on its border, once each, and its
// faces are two fewer: its Euler number is then one, which no other surface with a border has.
#include "vcg_ext/carry/polygons.h"

#include "vcg_ext/base/edge_table.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/base/union_find.h"

#include <algorithm>

namespace index_boolean {

namespace {

// Marks the faux edges of one finished mesh.
class Marker {
public:
	Marker(const Arrangement& arrangement, const std::vector<std::uint32_t>& part,
	       SourcedMesh& output)
	    : arrangement_(arrangement), mesh_(arrangement.mesh), part_(part), output_(output) {}

	void run();

private:
	bool isWhole(std::size_t face, std::uint8_t& faux) const;
	void countWholeFaces();
	void markIntact();
	void listHalfEdges();
	void joinPieces();
	void findSimple();

	std::uint32_t polygonOf(std::size_t face) const {
		return at(arrangement_.polygons.polygon, output_.faceSource[face].face).value;
	}
	std::uint32_t partOf(std::size_t face) const { return part_.empty() ? 0 : part_[face]; }
	// The polygon, and the side of it that is outside.
	std::uint32_t sideOf(std::size_t face) const {
		return 2 * polygonOf(face) + (output_.faceSource[face].turned ? 1 : 0);
	}

	const Arrangement& arrangement_;
	const MeshArrays& mesh_;
	const std::vector<std::uint32_t>& part_;
	SourcedMesh& output_;
	std::vector<std::uint32_t> size_;  // faces of a polygon, at its first face
	std::vector<std::uint32_t>
	    present_;  // and those that are whole in one part of the mesh, per side
	std::vector<std::uint32_t> broken_;  // faces of the mesh in polygons that are not whole
	std::vector<HalfEdge> halfEdges_;    // their edges, and others on the same two vertices
	std::vector<std::array<HalfEdge, 2>> inner_;  // between two faces of one side of a polygon
	std::vector<std::uint32_t> set_;              // per face of the mesh: joined across these
	std::vector<std::uint8_t> isSimple_;          // per set
};

// If a face of the mesh is all of its input face: whether its edges are faux in the input.
bool Marker::isWhole(std::size_t face, std::uint8_t& faux) const {
	const FaceSource& source = output_.faceSource[face];
	Triangle t = at(mesh_.triangles, source.face);
	const std::uint8_t given = at(mesh_.faux, source.face);
	const unsigned mask = source.turned ? turnedFaux(given) : given;
	if (source.turned) {
		std::swap(t[1], t[2]);
	}
	const auto& c = output_.triangles[face];
	for (std::size_t k = 0; k < 3; ++k) {
		if (output_.vertexSource[c[0]] == t[k]) {
			faux = static_cast<std::uint8_t>((mask | mask << 3U) >> k & 7U);
			return output_.vertexSource[c[1]] == t[(k + 1) % 3] &&
			       output_.vertexSource[c[2]] == t[(k + 2) % 3];
		}
	}
	return false;
}

void Marker::countWholeFaces() {
	size_.assign(mesh_.triangles.size(), 0);
	for (const FaceId first : arrangement_.polygons.polygon) {
		++at(size_, first);
	}
	present_.assign(2 * size_.size(), 0);
	std::vector<std::uint32_t> part(present_.size());  // of the first whole face, per side
	std::uint8_t faux = 0;
	for (std::size_t f = 0; f < output_.triangles.size(); ++f) {
		if (size_[polygonOf(f)] > 1 && isWhole(f, faux)) {
			const std::uint32_t side = sideOf(f);
			part[side] = present_[side] == 0 ? partOf(f) : part[side];
			present_[side] += part[side] == partOf(f) ? 1 : 0;
		}
	}
}

void Marker::markIntact() {
	output_.faux.assign(output_.triangles.size(), 0);
	for (std::size_t f = 0; f < output_.triangles.size(); ++f) {
		const std::uint32_t size = size_[polygonOf(f)];
		if (size == 1) {
			continue;
		}
		std::uint8_t faux = 0;
		if (present_[sideOf(f)] == size && isWhole(f, faux)) {
			output_.faux[f] = faux;
		} else {
			broken_.push_back(static_cast<std::uint32_t>(f));
		}
	}
}

void Marker::listHalfEdges() {
	std::vector<std::uint8_t> near(output_.points.size(), 0);
	for (const std::uint32_t f : broken_) {
		for (const std::uint32_t v : output_.triangles[f]) {
			near[v] = 1;
		}
	}
	for (std::size_t f = 0; f < output_.triangles.size(); ++f) {
		const auto& t = output_.triangles[f];
		for (std::size_t i = 0; i < 3; ++i) {
			const std::uint32_t from = t[i], to = t[(i + 1) % 3];
			if (near[from] != 0 && near[to] != 0) {
				halfEdges_.push_back(makeHalfEdge(from, to, f, i));
			}
		}
	}
}

void Marker::joinPieces() {
	UnionFind sets(output_.triangles.size());
	std::vector<std::uint8_t> isBroken(output_.triangles.size(), 0);
	for (const std::uint32_t f : broken_) {
		isBroken[f] = 1;
	}
	forEachManifoldEdge(halfEdges_, [&](const HalfEdge& a, const HalfEdge& b) {
		if (isBroken[a.face] != 0 && isBroken[b.face] != 0 && sideOf(a.face) == sideOf(b.face) &&
		    partOf(a.face) == partOf(b.face)) {
			inner_.push_back({a, b});
			sets.unite(a.face, b.face);
		}
	});
	sets.flatten();
	set_.resize(sets.size());
	for (std::uint32_t f = 0; f < set_.size(); ++f) {
		set_[f] = sets.root(f);
	}
}

void Marker::findSimple() {
	std::vector<std::uint32_t> faces(set_.size(), 0), corners(set_.size(), 0);
	std::vector<std::array<std::uint32_t, 2>> starts;  // of edges, by set and vertex
	std::vector<std::uint8_t> inner(set_.size(), 0);
	for (const auto& pair : inner_) {
		for (const HalfEdge& h : pair) {
			markFaux(inner[h.face], h.corner);
		}
	}
	isSimple_.assign(set_.size(), 1);
	std::vector<std::array<std::uint32_t, 2>> used;
	for (const std::uint32_t f : broken_) {
		++faces[set_[f]];
		for (std::size_t i = 0; i < 3; ++i) {
			used.push_back({set_[f], output_.triangles[f][i]});
			if (!isFaux(inner[f], i)) {
				starts.push_back(used.back());
				++corners[set_[f]];
			}
		}
	}
	std::sort(starts.begin(), starts.end());
	std::sort(used.begin(), used.end());
	used.erase(std::unique(used.begin(), used.end()), used.end());
	// Each vertex begins one edge of the border: the lists are equal, set by set.
	for (std::size_t i = 0; i + 1 < starts.size(); ++i) {
		if (starts[i] == starts[i + 1]) {
			isSimple_[starts[i][0]] = 0;
		}
	}
	for (const auto& u : used) {
		if (!std::binary_search(starts.begin(), starts.end(), u)) {
			isSimple_[u[0]] = 0;
		}
	}
	for (const std::uint32_t f : broken_) {
		if (faces[set_[f]] + 2 != corners[set_[f]]) {
			isSimple_[set_[f]] = 0;
		}
	}
}

void Marker::run() {
	countWholeFaces();
	markIntact();
	// Faces merged across polygons belong to none of them.
	if (!broken_.empty() && !arrangement_.options.mergeCoplanar) {
		listHalfEdges();
		joinPieces();
		findSimple();
	}
	for (const auto& pair : inner_) {
		for (const HalfEdge& h : pair) {
			if (isSimple_[set_[h.face]] != 0) {
				markFaux(output_.faux[h.face], h.corner);
			}
		}
	}
	if (std::none_of(output_.faux.begin(), output_.faux.end(), [](std::uint8_t m) { return m; })) {
		output_.faux.clear();
	}
}

}  // namespace

Status findFauxEdges(const Arrangement& arrangement, const std::vector<std::uint32_t>& part,
                     Monitor& monitor, SourcedMesh& mesh) {
	Status status;
	if (!arrangement.polygons.polygon.empty()) {
		Marker(arrangement, part, mesh).run();
	}
	status.code = pollCancelled(monitor) ? StatusCode::Cancelled : StatusCode::Ok;
	return status;
}

}  // namespace index_boolean
