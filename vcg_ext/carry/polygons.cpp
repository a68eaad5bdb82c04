// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A set of faces is a simple polygon iff all its vertices are on its border, once each, and its
// faces are two fewer: its Euler number is then one, which no other surface with a border has.
#include "vcg_ext/carry/polygons.h"

#include "vcg_ext/base/bucket_sort.h"
#include "vcg_ext/base/concurrent_sets.h"
#include "vcg_ext/base/edge_buckets.h"
#include "vcg_ext/base/parallel.h"

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
	bool areJoined(const EdgeSide* first, const EdgeSide* last) const;
	Status joinPieces();
	Status findSimple();
	Status checkVertices();
	void markSimple();

	std::uint32_t polygonOf(std::size_t face) const {
		return at(arrangement_.polygons.polygon, output_.faceSource[face].face).value;
	}
	std::uint32_t partOf(std::size_t face) const { return part_.empty() ? 0 : part_[face]; }

	const Arrangement& arrangement_;
	const MeshArrays& mesh_;
	const std::vector<std::uint32_t>& part_;
	Monitor& monitor_;
	SourcedMesh& output_;
	std::vector<std::uint32_t> size_;  // faces of a polygon, at its first face
	HugeVector<std::uint32_t> side_;   // per face of the mesh: 2 * its polygon, + 1 if it is turned
	HugeVector<std::uint8_t> whole_;   // per face of the mesh: its faux edges in the input, if it
	                                   // is all of an input face of a polygon; else kNotWhole
	HugeVector<std::uint32_t> present_;  // of whole faces in one part of the mesh, per side
	// Faces of the mesh in polygons that are not whole; and which these are.
	std::vector<std::uint32_t> broken_;
	std::vector<std::uint8_t> isBroken_;
	EdgeBuckets edges_;  // theirs, with the sides of others on the same two vertices
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
	side_.resizeForOverwrite(output_.triangles.size());
	return parallelFor(whole_.size(), kGrain, arrangement_.options.threads, monitor_,
	                   [this](std::size_t begin, std::size_t end) {
		                   for (std::size_t f = begin; f < end; ++f) {
			                   std::uint8_t faux = 0;
			                   const std::uint32_t polygon = polygonOf(f);
			                   const bool isPart = size_[polygon] > 1;
			                   side_[f] = 2 * polygon + (output_.faceSource[f].turned ? 1 : 0);
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
		const std::uint32_t side = side_[f];
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
		const std::uint32_t size = size_[side_[f] / 2];
		if (size == 1) {
			continue;
		}
		if (whole_[f] != kNotWhole && present_[side_[f]] == size) {
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
	return edges_.list(output_.triangles.size(), output_.points.size(), visitEdges, monitor_);
}

// Whether an edge, all of whose sides are given, is inside one side of a polygon.
bool Marker::areJoined(const EdgeSide* first, const EdgeSide* last) const {
	if (last - first != 2 || first[0].forward == first[1].forward) {
		return false;
	}
	const std::uint32_t a = first[0].face, b = first[1].face;
	return isBroken_[a] != 0 && isBroken_[b] != 0 && side_[a] == side_[b] && partOf(a) == partOf(b);
}

Status Marker::joinPieces() {
	const std::size_t n = output_.triangles.size();
	const int threads = arrangement_.options.threads;
	ConcurrentSets sets(n);
	set_.resizeForOverwrite(n);
	inner_.assign(n, 0);
	const auto join = [&](std::size_t, EdgeSide* first, EdgeSide* last) {
		if (areJoined(first, last)) {
			sets.unite(first[0].face, first[1].face);
			first[0].mark = first[1].mark = true;
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
	            [&] { return edges_.forEachEdge(threads, monitor_, join); },
	            [&] { return parallelFor(n, kGrain, threads, monitor_, listSets); });
	for (const EdgeSide& side : edges_.sides()) {  // in order: the edges of a face share a byte
		if (side.mark) {
			markFaux(inner_[side.face], side.corner);
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
