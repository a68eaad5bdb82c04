// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A set of faces is a simple polygon iff all its vertices are on its border, once each, and its
// faces are two fewer: its Euler number is then one, which no other surface with a border has.
#include "vcg_ext/carry/polygons.h"

#include "vcg_ext/base/bucket_sort.h"
#include "vcg_ext/base/concurrent_sets.h"
#include "vcg_ext/base/edge_table.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/base/parallel_list.h"

#include <algorithm>
#include <functional>

namespace index_boolean {

namespace {

// A vertex of a set of pieces.
struct SetVertex {
	std::uint32_t vertex, set;

	friend bool operator==(const SetVertex& a, const SetVertex& b) {
		return a.vertex == b.vertex && a.set == b.set;
	}
	friend bool operator<(const SetVertex& a, const SetVertex& b) {
		return a.vertex != b.vertex ? a.vertex < b.vertex : a.set < b.set;
	}
};

constexpr std::size_t kGrain = 1 << 12;
constexpr std::uint8_t kNotWhole = 0xff;  // no mask of faux edges

// Marks the faux edges of one finished mesh.
class Marker {
public:
	Marker(const Arrangement& arrangement, const std::vector<std::uint32_t>& part, Monitor& monitor,
	       SourcedMesh& output)
	    : arrangement_(arrangement), mesh_(arrangement.mesh), part_(part), monitor_(monitor),
	      output_(output) {}

	Status run();

private:
	bool isWhole(std::size_t face, std::uint8_t& faux) const;
	Status findWholeFaces();
	void countWholeFaces();
	void markIntact();
	Status listHalfEdges();
	bool joinsNext(std::size_t i) const;
	Status joinPieces();
	Status findSimple();
	Status checkVertices();
	void markSimple();

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
	Monitor& monitor_;
	SourcedMesh& output_;
	std::vector<std::uint32_t> size_;  // faces of a polygon, at its first face
	HugeVector<std::uint8_t> whole_;   // per face of the mesh: its faux edges in the input, if it
	                                   // is all of an input face of a polygon; else kNotWhole
	std::vector<std::uint32_t> present_;  // of whole faces in one part of the mesh, per side
	// Faces of the mesh in polygons that are not whole; and which these are.
	std::vector<std::uint32_t> broken_;
	std::vector<std::uint8_t> isBroken_;
	HugeVector<HalfEdge> halfEdges_;  // their edges, and others on the same two vertices; by edge
	// Per face of the mesh, as faux edges are marked: those that join faces of one side of a
	// polygon; and the set of faces that are joined across them.
	std::vector<std::uint8_t> inner_;
	HugeVector<std::uint32_t> set_;
	std::vector<std::uint8_t> isSimple_;  // per set
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

Status Marker::findWholeFaces() {
	size_.assign(mesh_.triangles.size(), 0);
	for (const FaceId first : arrangement_.polygons.polygon) {
		++at(size_, first);
	}
	whole_.resizeForOverwrite(output_.triangles.size());
	return parallelFor(whole_.size(), kGrain, arrangement_.options.threads, monitor_,
	                   [this](std::size_t begin, std::size_t end) {
		                   for (std::size_t f = begin; f < end; ++f) {
			                   std::uint8_t faux = 0;
			                   const bool isPart = size_[polygonOf(f)] > 1;
			                   whole_[f] = isPart && isWhole(f, faux) ? faux : kNotWhole;
		                   }
	                   });
}

void Marker::countWholeFaces() {
	present_.assign(2 * size_.size(), 0);
	std::vector<std::uint32_t> part(part_.empty() ? 0 : present_.size());  // of the first, per side
	for (std::size_t f = 0; f < output_.triangles.size(); ++f) {
		if (whole_[f] == kNotWhole) {
			continue;
		}
		const std::uint32_t side = sideOf(f);
		if (!part.empty() && present_[side] == 0) {
			part[side] = partOf(f);
		}
		present_[side] += part.empty() || part[side] == partOf(f) ? 1 : 0;
	}
}

void Marker::markIntact() {
	output_.faux.assign(output_.triangles.size(), 0);
	isBroken_.assign(output_.triangles.size(), 0);
	for (std::size_t f = 0; f < output_.triangles.size(); ++f) {
		const std::uint32_t size = size_[polygonOf(f)];
		if (size == 1) {
			continue;
		}
		if (whole_[f] != kNotWhole && present_[sideOf(f)] == size) {
			output_.faux[f] = whole_[f];
		} else {
			isBroken_[f] = 1;
			broken_.push_back(static_cast<std::uint32_t>(f));
		}
	}
}

Status Marker::listHalfEdges() {
	std::vector<std::uint8_t> near(output_.points.size(), 0);
	for (const std::uint32_t f : broken_) {
		for (const std::uint32_t v : output_.triangles[f]) {
			near[v] = 1;
		}
	}
	const auto visitEdges = [&](std::size_t f, auto&& visit) {
		const auto& t = output_.triangles[f];
		for (std::size_t i = 0; i < 3; ++i) {
			const std::uint32_t from = t[i], to = t[(i + 1) % 3];
			if (near[from] != 0 && near[to] != 0) {
				visit(makeHalfEdge(from, to, f, i));
			}
		}
	};
	const int threads = arrangement_.options.threads;
	return inOrder(
	    [&] {
		    return listInParallel(output_.triangles.size(), visitEdges, threads, monitor_,
		                          halfEdges_);
	    },
	    [&] { return sortByEdge(halfEdges_, output_.points.size(), threads, monitor_); });
}

// Whether the i-th of the sorted half-edges and the next one are all of an edge inside one side of
// a polygon.
bool Marker::joinsNext(std::size_t i) const {
	const HugeVector<HalfEdge>& sorted = halfEdges_;
	if (i + 1 >= sorted.size() || !sorted[i].sameEdge(sorted[i + 1]) ||
	    sorted[i].forward == sorted[i + 1].forward ||
	    (i > 0 && sorted[i - 1].sameEdge(sorted[i])) ||
	    (i + 2 < sorted.size() && sorted[i + 2].sameEdge(sorted[i]))) {
		return false;
	}
	const std::uint32_t a = sorted[i].face, b = sorted[i + 1].face;
	return isBroken_[a] != 0 && isBroken_[b] != 0 && sideOf(a) == sideOf(b) &&
	       partOf(a) == partOf(b);
}

// \pre the half-edges are sorted
Status Marker::joinPieces() {
	const std::size_t n = output_.triangles.size();
	const int threads = arrangement_.options.threads;
	ConcurrentSets sets(n);
	HugeVector<std::uint8_t> joins = HugeVector<std::uint8_t>::forOverwrite(halfEdges_.size());
	set_.resizeForOverwrite(n);
	inner_.assign(n, 0);
	const auto join = [&](std::size_t begin, std::size_t end) {
		for (std::size_t i = begin; i < end; ++i) {
			joins[i] = joinsNext(i) ? 1 : 0;
			if (joins[i] != 0) {
				sets.unite(halfEdges_[i].face, halfEdges_[i + 1].face);
			}
		}
	};
	const auto listSets = [&](std::size_t begin, std::size_t end) {
		sets.flatten(begin, end);
		for (std::size_t f = begin; f < end; ++f) {
			set_[f] = sets.root(static_cast<std::uint32_t>(f));
		}
	};
	const auto makeSets = [&](std::size_t begin, std::size_t end) { sets.makeSets(begin, end); };
	const Status status =
	    inOrder([&] { return parallelFor(n, kGrain, threads, monitor_, makeSets); },
	            [&] { return parallelFor(joins.size(), kGrain, threads, monitor_, join); },
	            [&] { return parallelFor(n, kGrain, threads, monitor_, listSets); });
	for (std::size_t i = 0; i < joins.size() && status.ok(); ++i) {
		if (joins[i] != 0) {
			markFaux(inner_[halfEdges_[i].face], halfEdges_[i].corner);
			markFaux(inner_[halfEdges_[i + 1].face], halfEdges_[i + 1].corner);
		}
	}
	return status;
}

// Of a simple polygon, each vertex begins one edge of the border, and the faces are two fewer than
// these: what fails by counts needs no look at its vertices.
Status Marker::findSimple() {
	std::vector<std::uint32_t> faces(set_.size(), 0), border(set_.size(), 0);
	for (const std::uint32_t f : broken_) {
		++faces[set_[f]];
		for (std::size_t i = 0; i < 3; ++i) {
			border[set_[f]] += isFaux(inner_[f], i) ? 0 : 1;
		}
	}
	isSimple_.assign(set_.size(), 1);
	for (const std::uint32_t f : broken_) {
		if (faces[set_[f]] + 2 != border[set_[f]]) {
			isSimple_[set_[f]] = 0;
		}
	}
	return checkVertices();
}

// Marks the sets as not simple that have a vertex with none or several edges of the border.
Status Marker::checkVertices() {
	std::vector<SetVertex> used,
	    starts;  // corners of faces; those that an edge of the border leaves
	for (const std::uint32_t f : broken_) {
		for (std::size_t i = 0; isSimple_[set_[f]] != 0 && i < 3; ++i) {
			used.push_back({output_.triangles[f][i], set_[f]});
			if (!isFaux(inner_[f], i)) {
				starts.push_back(used.back());
			}
		}
	}
	const auto sort = [this](std::vector<SetVertex>& list) {
		return bucketSort(
		    list, output_.points.size(), [](const SetVertex& v) { return v.vertex; }, std::less<>(),
		    arrangement_.options.threads, monitor_);
	};
	const Status status = inOrder([&] { return sort(used); }, [&] { return sort(starts); });
	auto start = starts.begin();
	const auto begins = [&](auto first, auto) {
		const auto end =
		    std::find_if_not(start, starts.end(), [&](const SetVertex& v) { return v == *first; });
		if (end - start != 1) {
			isSimple_[first->set] = 0;
		}
		start = end;
	};
	if (status.ok()) {
		forEachGroup(used.begin(), used.end(), std::equal_to<>(), begins);
	}
	return status;
}

void Marker::markSimple() {
	for (const std::uint32_t f : broken_) {
		if (isSimple_[set_[f]] != 0) {
			output_.faux[f] = inner_[f];
		}
	}
}

Status Marker::run() {
	Status status = findWholeFaces();
	if (status.ok()) {
		countWholeFaces();
		markIntact();
	}
	// Faces merged across polygons belong to none of them.
	if (status.ok() && !broken_.empty() && !arrangement_.options.mergeCoplanar) {
		status = inOrder([this] { return listHalfEdges(); }, [this] { return joinPieces(); },
		                 [this] { return findSimple(); });
		if (status.ok()) {
			markSimple();
		}
	}
	if (std::none_of(output_.faux.begin(), output_.faux.end(), [](std::uint8_t m) { return m; })) {
		output_.faux.clear();
	}
	return status;
}

}  // namespace

Status findFauxEdges(const Arrangement& arrangement, const std::vector<std::uint32_t>& part,
                     Monitor& monitor, SourcedMesh& mesh) {
	Status status;
	if (!arrangement.polygons.polygon.empty()) {
		status = Marker(arrangement, part, monitor, mesh).run();
	}
	return status.ok() && pollCancelled(monitor) ? statusOf(StatusCode::Cancelled) : status;
}

}  // namespace index_boolean
