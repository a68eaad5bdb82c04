// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A set of faces is a simple polygon iff all its vertices are on its border, once each, and its
// faces are two fewer: its Euler number is then one, which no other surface with a border has.
// A vertex of a closed mesh all of whose faces are of one side of a polygon is on no border. Most
// pieces of a large polygon have one, so that few edges have to be looked at.
#include "vcg_ext/carry/polygons.h"

#include "vcg_ext/base/bucket_sort.h"
#include "vcg_ext/base/edge_buckets.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/base/union_find.h"

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

// A face of the mesh: of a polygon that is whole, or of none; of one that is not; and that with a
// vertex inside, for which its set is no polygon.
enum class Kind : std::uint8_t { Whole, Broken, Inside };

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
	void findInside();
	Status listHalfEdges();
	bool areJoined(const EdgeSide* first, const EdgeSide* last) const;
	Status findJoints();
	void joinPieces();
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
	// Faces of the mesh in polygons that are not whole, but for those with a vertex inside; and
	// what each face is.
	std::vector<std::uint32_t> broken_;
	std::vector<Kind> kind_;
	EdgeBuckets edges_;                // theirs, with the sides of others on the same two vertices
	HugeVector<std::uint32_t> place_;  // per face of the mesh that is in broken_: where
	// Per face in broken_, as faux edges are marked: those that join faces of one side of a
	// polygon; and the set of faces that are joined across them.
	std::vector<std::uint8_t> inner_;
	std::vector<std::uint32_t> set_;
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
	kind_.assign(output_.triangles.size(), Kind::Whole);
	for (std::size_t f = 0; f < output_.triangles.size(); ++f) {
		const std::uint32_t size = size_[side_[f] / 2];
		if (size == 1) {
			continue;
		}
		if (whole_[f] != kNotWhole && present_[side_[f]] == size) {
			output_.faux[f] = whole_[f];
		} else {
			kind_[f] = Kind::Broken;
			broken_.push_back(static_cast<std::uint32_t>(f));
		}
	}
}

// Leaves out the faces with a vertex all of whose faces are of their side of the polygon. Where
// there are several parts the mesh may have a border, which such a vertex may be on.
void Marker::findInside() {
	constexpr std::uint32_t kSeveral = kNone - 1;
	if (!part_.empty()) {
		return;
	}
	std::vector<std::uint32_t> sideAt(output_.points.size(), kNone);  // per vertex, of its faces
	for (std::size_t f = 0; f < output_.triangles.size(); ++f) {
		for (const std::uint32_t v : output_.triangles[f]) {
			sideAt[v] = sideAt[v] == kNone || sideAt[v] == side_[f] ? side_[f] : kSeveral;
		}
	}
	const auto isInside = [&](std::uint32_t f) {
		const auto& t = output_.triangles[f];
		return std::any_of(t.begin(), t.end(),
		                   [&](std::uint32_t v) { return sideAt[v] == side_[f]; });
	};
	std::size_t kept = 0;
	for (const std::uint32_t f : broken_) {
		if (isInside(f)) {
			kind_[f] = Kind::Inside;
		} else {
			broken_[kept++] = f;
		}
	}
	broken_.resize(kept);
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
	return kind_[a] != Kind::Whole && kind_[b] != Kind::Whole && side_[a] == side_[b] &&
	       partOf(a) == partOf(b);
}

// Marks the first side of each edge inside one side of a polygon: the other follows it.
Status Marker::findJoints() {
	const auto join = [this](std::size_t, EdgeSide* first, EdgeSide* last) {
		first[0].mark = areJoined(first, last);
	};
	return edges_.forEachEdge(arrangement_.options.threads, monitor_, join);
}

// Makes the sets, and marks the edges inside them and those to faces with a vertex inside.
void Marker::joinPieces() {
	const std::size_t n = broken_.size();
	place_.resizeForOverwrite(output_.triangles.size());
	for (std::uint32_t i = 0; i < n; ++i) {
		place_[broken_[i]] = i;
	}
	UnionFind sets(n);
	inner_.assign(n, 0);
	const auto& sides = edges_.sides();
	for (std::size_t k = 0; k < sides.size(); ++k) {
		if (!sides[k].mark) {
			continue;
		}
		const EdgeSide &a = sides[k], &b = sides[k + 1];
		for (const EdgeSide& side : {a, b}) {
			if (kind_[side.face] == Kind::Broken) {
				markFaux(inner_[place_[side.face]], side.corner);
			}
		}
		if (kind_[a.face] == Kind::Broken && kind_[b.face] == Kind::Broken) {
			sets.unite(place_[a.face], place_[b.face]);
		}
	}
	set_.resize(n);
	for (std::uint32_t i = 0; i < n; ++i) {
		set_[i] = sets.find(i);
	}
}

// Of a simple polygon, each vertex begins one edge of the border, and the faces are two fewer than
// these: what fails by counts needs no look at its vertices. Of n faces joined by at least n - 1
// edges, k of whose other edges lead to faces with a vertex inside, at most n + 2 - k are at the
// border: a set that is only a part of one with a vertex inside fails by counts.
Status Marker::findSimple() {
	const std::size_t n = broken_.size();
	std::vector<std::uint32_t> faces(n, 0), border(n, 0);
	isSimple_.assign(n, 1);
	for (std::size_t f = 0; f < n; ++f) {
		++faces[set_[f]];
		for (std::size_t i = 0; i < 3; ++i) {
			border[set_[f]] += isFaux(inner_[f], i) ? 0 : 1;
		}
	}
	for (std::size_t f = 0; f < n; ++f) {
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
	for (std::size_t f = 0; f < broken_.size(); ++f) {
		for (std::size_t i = 0; isSimple_[set_[f]] != 0 && i < 3; ++i) {
			used.push_back({output_.triangles[broken_[f]][i], set_[f]});
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
	for (std::size_t f = 0; f < broken_.size(); ++f) {
		if (isSimple_[set_[f]] != 0) {
			output_.faux[broken_[f]] = inner_[f];
		}
	}
}

Status Marker::run() {
	Status status = findWholeFaces();
	if (status.ok()) {
		countWholeFaces();
		markIntact();
		findInside();
	}
	// Faces merged across polygons belong to none of them.
	if (status.ok() && !broken_.empty() && !arrangement_.options.mergeCoplanar) {
		status = inOrder([this] { return listHalfEdges(); }, [this] { return findJoints(); });
		if (status.ok()) {
			joinPieces();
			status = findSimple();
		}
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
