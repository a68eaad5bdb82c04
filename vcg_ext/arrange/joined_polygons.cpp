// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Half-edges by their edge: the two of a faux edge are next to each other. Many need not be looked
// for: the triangles of a polygon mostly follow each other in the list of faces.
#include "vcg_ext/arrange/joined_polygons.h"

#include "vcg_ext/base/concurrent_sets.h"
#include "vcg_ext/base/edge_buckets.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/exact/exact_sign.h"

#include <algorithm>
#include <utility>

namespace index_boolean {

namespace {

constexpr std::size_t kGrain = 1 << 12;

// A face that lies across an axis: the axis, and which way it turns seen against it.
struct Level {
	std::int8_t axis = -1;  // -1: it lies across none
	std::int8_t turn = 0;
};

// What the edges of a chunk, or the faces of one, say of what joins them.
struct Joins {
	std::vector<std::array<std::uint32_t, 2>> bent;       // faces that meet in an edge at an angle
	std::vector<std::pair<std::uint32_t, int>> joinNone;  // faux edges, by face and corner
};

// Finds what joins the faces of one operand, as indices and by planes.
class FaceJoiner {
public:
	FaceJoiner(const Arrangement& arrangement, OperandId operand, Monitor& monitor)
	    : arrangement_(arrangement), mesh_(arrangement.mesh), monitor_(monitor),
	      begin_(mesh_.faceOffsets.begin(operand)), count_(mesh_.faceOffsets.size(operand)) {}

	// Unites faces joined within one plane.
	Status run(ConcurrentSets& flat);

	const std::vector<Joins>& joins() const { return joins_; }

private:
	bool isOdd(VertexId v) const;
	template <class Visit>
	void forEachHalfEdge(std::size_t f, Visit&& visit) const;
	Level levelOf(std::size_t face) const;
	Status joinNeighbours(ConcurrentSets& flat);
	void joinToNext(std::size_t i, ConcurrentSets& flat, Joins& out);
	bool isFauxSide(const EdgeSide& s) const { return isFaux(mesh_.faux[s.face], s.corner); }
	void joinAt(const EdgeSide* first, const EdgeSide* last, ConcurrentSets& flat,
	            Joins& out) const;
	void join(std::uint32_t a, std::uint32_t b, ConcurrentSets& flat, Joins& out) const;
	int commonFrontOf(std::uint32_t a, std::uint32_t b) const;

	const Arrangement& arrangement_;
	const MeshArrays& mesh_;
	Monitor& monitor_;
	std::size_t begin_, count_;         // of the operand's faces
	HugeVector<Level> levels_;          // per face of the operand
	std::vector<std::uint8_t> joined_;  // per face, as faux edges are marked: to the one before or
	                                    // after it in the list, in that edge
	std::vector<Joins> joins_;          // per chunk of faces, then per chunk of edges
};

// Whether the operand is no manifold at a vertex. An edge with more than two faces has two such
// ends, and so has one at a border.
bool FaceJoiner::isOdd(VertexId v) const {
	const std::vector<VertexId>& nonManifold = arrangement_.nonManifold;
	return std::binary_search(nonManifold.begin(), nonManifold.end(), v);
}

// Visits the half-edges of a face that may join it to others yet. Between vertices at which the
// operand is no manifold all half-edges are looked at.
template <class Visit>
void FaceJoiner::forEachHalfEdge(std::size_t f, Visit&& visit) const {
	const bool isManifold = arrangement_.nonManifold.empty();
	for (std::size_t i = 0; (mesh_.faux[f] != 0 || !isManifold) && i < 3; ++i) {
		const VertexId from = mesh_.triangles[f][i];
		const VertexId to = mesh_.triangles[f][(i + 1) % 3];
		const bool isOpen = isFaux(mesh_.faux[f], i) && !isFaux(joined_[f - begin_], i);
		if (isOpen || (!isManifold && isOdd(from) && isOdd(to))) {
			visit(makeHalfEdge(from.value, to.value, f, i));
		}
	}
}

// \pre the face has area: it lies across one axis at most
Level FaceJoiner::levelOf(std::size_t face) const {
	const Triangle& t = mesh_.triangles[face];
	const Point &a = at(mesh_.points, t[0]), &b = at(mesh_.points, t[1]),
	            &c = at(mesh_.points, t[2]);
	for (std::size_t axis = 0; axis < 3; ++axis) {
		if (a[axis] == b[axis] && a[axis] == c[axis]) {
			const int turn = orient2d(a, b, c, static_cast<int>(axis));
			return {static_cast<std::int8_t>(axis), static_cast<std::int8_t>(turn)};
		}
	}
	return {};
}

// As commonFront, mostly without arithmetic. \pre both faces have faux edges, and a vertex in
// common
int FaceJoiner::commonFrontOf(std::uint32_t a, std::uint32_t b) const {
	const Level s = levels_[a - begin_], t = levels_[b - begin_];
	if (s.axis >= 0 && t.axis >= 0) {  // two planes across axes with a point in common
		return s.axis == t.axis ? s.turn * t.turn : 0;
	}
	return s.axis == t.axis ? commonFront(mesh_, {a}, {b}) : 0;
}

// Joins two faces at an edge that no other has and both call faux.
void FaceJoiner::join(std::uint32_t a, std::uint32_t b, ConcurrentSets& flat, Joins& out) const {
	if (commonFrontOf(a, b) > 0) {
		flat.unite(a, b);
	} else {
		out.bent.push_back({a, b});
	}
}

// Joins the faces at an edge, all of whose sides are given, if there are two of them and both call
// it faux.
void FaceJoiner::joinAt(const EdgeSide* first, const EdgeSide* last, ConcurrentSets& flat,
                        Joins& out) const {
	if (last - first == 2 && first[0].forward != first[1].forward && isFauxSide(first[0]) &&
	    isFauxSide(first[1])) {
		join(first[0].face, first[1].face, flat, out);
		return;
	}
	for (const EdgeSide* side = first; side != last; ++side) {
		if (isFauxSide(*side)) {
			out.joinNone.emplace_back(side->face, side->corner);
		}
	}
}

// Joins the i-th face of the operand to the next in the list at the first edge where that is so,
// and where no third face can be.
void FaceJoiner::joinToNext(std::size_t i, ConcurrentSets& flat, Joins& out) {
	const std::size_t f = begin_ + i;
	const Triangle &s = mesh_.triangles[f], &t = mesh_.triangles[f + 1];
	for (std::size_t j = 0; j < 3; ++j) {
		const VertexId from = s[j], to = s[j == 2 ? 0 : j + 1];
		for (std::size_t k = 0; isFaux(mesh_.faux[f], j) && k < 3; ++k) {
			const bool areOpposite = to == t[k] && from == t[k == 2 ? 0 : k + 1];
			if (areOpposite && isFaux(mesh_.faux[f + 1], k) && !(isOdd(from) && isOdd(to))) {
				join(static_cast<std::uint32_t>(f), static_cast<std::uint32_t>(f + 1), flat, out);
				markFaux(joined_[i], j);
				markFaux(joined_[i + 1], k);
				return;
			}
		}
	}
}

// Finds the levels of faces, and joins those that follow each other in the list.
Status FaceJoiner::joinNeighbours(ConcurrentSets& flat) {
	levels_.resizeForOverwrite(count_);
	joined_.assign(count_, 0);
	joins_.resize(chunkCount(count_, kGrain));
	return parallelForChunks(
	    count_, kGrain, arrangement_.options.threads, monitor_,
	    [&](std::size_t chunk, std::size_t begin, std::size_t end) {
		    for (std::size_t i = begin; i < end; ++i) {
			    levels_[i] = mesh_.faux[begin_ + i] != 0 ? levelOf(begin_ + i) : Level{};
		    }
		    for (std::size_t i = begin; i + 1 < end; ++i) {
			    if (mesh_.faux[begin_ + i] != 0 && mesh_.faux[begin_ + i + 1] != 0) {
				    joinToNext(i, flat, joins_[chunk]);
			    }
		    }
	    });
}

Status FaceJoiner::run(ConcurrentSets& flat) {
	const std::uint8_t* const faux = mesh_.faux.data() + begin_;
	if (std::none_of(faux, faux + count_, [](std::uint8_t mask) { return mask != 0; })) {
		return {};
	}
	EdgeBuckets edges;
	const auto visitHalfEdges = [this](std::size_t i, auto&& visit) {
		forEachHalfEdge(begin_ + i, visit);
	};
	const auto joinEdge = [&](std::size_t chunk, const EdgeSide* first, const EdgeSide* last) {
		joinAt(first, last, flat, joins_[chunkCount(count_, kGrain) + chunk]);
	};
	return inOrder(
	    [&] { return joinNeighbours(flat); },
	    [&] { return edges.list(count_, mesh_.points.size(), visitHalfEdges, monitor_); },
	    [&] {
		    joins_.resize(joins_.size() + edges.chunks());
		    return edges.forEachEdge(arrangement_.options.threads, monitor_, joinEdge);
	    });
}

// The axis along which all corners of two triangles have one coordinate, or -1.
int commonLevel(const MeshArrays& mesh, const Triangle& s, const Triangle& t) {
	for (int axis = 0; axis < 3; ++axis) {
		const auto k = static_cast<std::size_t>(axis);
		const double level = at(mesh.points, s[0])[k];
		const auto isLevel = [&](VertexId v) { return at(mesh.points, v)[k] == level; };
		if (std::all_of(s.begin(), s.end(), isLevel) && std::all_of(t.begin(), t.end(), isLevel)) {
			return axis;
		}
	}
	return -1;
}

int turnOf(const MeshArrays& mesh, const Triangle& t, int axis) {
	return orient2d(at(mesh.points, t[0]), at(mesh.points, t[1]), at(mesh.points, t[2]), axis);
}

// Writes the root of each element.
Status listRoots(ConcurrentSets& sets, int threads, Monitor& monitor, std::vector<FaceId>& out) {
	return parallelFor(out.size(), kGrain, threads, monitor,
	                   [&](std::size_t begin, std::size_t end) {
		                   sets.flatten(begin, end);
		                   for (std::size_t i = begin; i < end; ++i) {
			                   out[i] = {sets.root(static_cast<std::uint32_t>(i))};
		                   }
	                   });
}

}  // namespace

int commonFront(const MeshArrays& mesh, FaceId a, FaceId b) {
	const Triangle& s = at(mesh.triangles, a);
	const Triangle& t = at(mesh.triangles, b);
	if (const int level = commonLevel(mesh, s, t); level >= 0) {
		return turnOf(mesh, s, level) * turnOf(mesh, t, level);
	}
	for (const VertexId v : t) {
		if (orient3d(at(mesh.points, s[0]), at(mesh.points, s[1]), at(mesh.points, s[2]),
		             at(mesh.points, v)) != 0) {
			return 0;
		}
	}
	int front = 0;
	const int axis = projectionAxis(s, mesh.points, front);
	return front * turnOf(mesh, t, axis);
}

Status joinPolygons(Arrangement& arrangement, Monitor& monitor) {
	MeshArrays& mesh = arrangement.mesh;
	const std::size_t n = mesh.triangles.size();
	if (mesh.faux.empty()) {
		return {};
	}
	const int threads = arrangement.options.threads;
	ConcurrentSets sets(n);
	std::vector<std::array<std::uint32_t, 2>> bent;
	Polygons& out = arrangement.polygons;
	const auto joinOperand = [&](OperandId operand) {
		FaceJoiner joiner(arrangement, operand, monitor);
		const Status status = joiner.run(sets);
		for (const Joins& part : joiner.joins()) {
			bent.insert(bent.end(), part.bent.begin(), part.bent.end());
			for (const auto& [face, corner] : part.joinNone) {
				mesh.faux[face] = static_cast<std::uint8_t>(mesh.faux[face] & ~(1 << corner));
			}
		}
		return status;
	};
	const auto joinBent = [&] {
		out.polygon = out.flat;
		if (bent.empty()) {
			return Status{};
		}
		for (const auto& [a, b] : bent) {
			sets.unite(a, b);
		}
		return listRoots(sets, threads, monitor, out.polygon);
	};
	return inOrder(
	    [&] {
		    return parallelFor(
		        n, kGrain, threads, monitor,
		        [&](std::size_t begin, std::size_t end) { sets.makeSets(begin, end); });
	    },
	    [&] { return forEachOperand(mesh.operands(), joinOperand); },
	    [&] {
		    out.flat.resize(n);
		    return listRoots(sets, threads, monitor, out.flat);
	    },
	    joinBent);
}

Status listFlatEdges(const Arrangement& arrangement, Monitor& monitor, EdgeList& out) {
	using Edge = EdgeItem<FaceId>;
	const MeshArrays& mesh = arrangement.mesh;
	const std::vector<FaceId>& flat = arrangement.polygons.flat;
	std::vector<Edge> edges;  // of each faux side, and which faces its own is joined to
	const auto listSides = [&](FaceId face) {
		const Triangle& t = at(mesh.triangles, face);
		for (std::size_t i = 0; i < 3; ++i) {
			if (isFaux(at(mesh.faux, face), i)) {
				edges.push_back(
				    makeEdgeItem(t[i].value, t[i == 2 ? 0 : i + 1].value, at(flat, face)));
			}
		}
	};
	out.clear();
	if (flat.empty()) {
		return {};
	}
	for (const CutFace& cut : arrangement.refinement.cutFaces) {
		listSides(cut.face);
	}
	const Status status =
	    sortByEdge(edges, mesh.points.size(), arrangement.options.threads, monitor);
	// The edges that joinPolygons has left faux join two faces each. Two faces of one set lie in
	// one plane, with their fronts to one side, so the edge joins them within it.
	forEachSortedEdge(edges.begin(), edges.end(), [&](auto first, auto last) {
		if (last - first == 2 && first[0].item == first[1].item) {
			out.push_back({VertexId{first->low}, VertexId{first->high}});
		}
	});
	return status;
}

}  // namespace index_boolean
