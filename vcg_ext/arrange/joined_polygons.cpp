// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Half-edges sorted by their edge: the two of a faux edge are neighbours in the list.
#include "vcg_ext/arrange/joined_polygons.h"

#include "vcg_ext/base/concurrent_sets.h"
#include "vcg_ext/base/edge_table.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/base/parallel_list.h"
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

// What a chunk of half-edges, sorted by edge, says of their faces.
struct Joins {
	std::vector<std::array<VertexId, 2>> flat;            // edges between faces of one plane
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
	Status listHalfEdges();
	template <class Visit>
	void forEachHalfEdge(std::size_t f, Visit&& visit) const;
	Level levelOf(std::size_t face) const;
	Status findLevels();
	bool joinsNext(std::size_t i) const;
	void join(std::size_t i, ConcurrentSets& flat, Joins& out) const;
	int commonFrontOf(std::uint32_t a, std::uint32_t b) const;

	const Arrangement& arrangement_;
	const MeshArrays& mesh_;
	Monitor& monitor_;
	std::size_t begin_, count_;       // of the operand's faces
	HugeVector<Level> levels_;        // per face of the operand
	HugeVector<HalfEdge> halfEdges_;  // sorted by edge
	std::vector<Joins> joins_;        // per chunk of them
};

// Visits the half-edges of a face that may join it to others. An edge with more than two faces has
// ends at which the operand is no manifold, and so has one at a border: between such vertices, all
// half-edges are looked at.
template <class Visit>
void FaceJoiner::forEachHalfEdge(std::size_t f, Visit&& visit) const {
	const std::vector<VertexId>& nonManifold = arrangement_.nonManifold;
	const auto isOdd = [&](VertexId v) {
		return std::binary_search(nonManifold.begin(), nonManifold.end(), v);
	};
	for (std::size_t i = 0; (mesh_.faux[f] != 0 || !nonManifold.empty()) && i < 3; ++i) {
		const VertexId from = mesh_.triangles[f][i];
		const VertexId to = mesh_.triangles[f][(i + 1) % 3];
		if (isFaux(mesh_.faux[f], i) || (isOdd(from) && isOdd(to))) {
			visit(makeHalfEdge(from.value, to.value, f, i));
		}
	}
}

Status FaceJoiner::listHalfEdges() {
	return listInParallel(
	    count_, [this](std::size_t i, auto&& visit) { forEachHalfEdge(begin_ + i, visit); },
	    arrangement_.options.threads, monitor_, halfEdges_);
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

Status FaceJoiner::findLevels() {
	levels_.resizeForOverwrite(count_);
	return parallelFor(count_, kGrain, arrangement_.options.threads, monitor_,
	                   [&](std::size_t begin, std::size_t end) {
		                   for (std::size_t i = begin; i < end; ++i) {
			                   levels_[i] =
			                       mesh_.faux[begin_ + i] != 0 ? levelOf(begin_ + i) : Level{};
		                   }
	                   });
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

// Whether the i-th of the sorted half-edges and the next one are all of an edge that joins faces.
bool FaceJoiner::joinsNext(std::size_t i) const {
	const HugeVector<HalfEdge>& sorted = halfEdges_;
	if (i + 1 >= sorted.size() || !sorted[i].sameEdge(sorted[i + 1]) ||
	    (i > 0 && sorted[i - 1].sameEdge(sorted[i])) ||
	    (i + 2 < sorted.size() && sorted[i + 2].sameEdge(sorted[i]))) {
		return false;
	}
	const HalfEdge &a = sorted[i], &b = sorted[i + 1];
	return a.forward != b.forward && isFaux(mesh_.faux[a.face], a.corner) &&
	       isFaux(mesh_.faux[b.face], b.corner);
}

void FaceJoiner::join(std::size_t i, ConcurrentSets& flat, Joins& out) const {
	const HalfEdge& a = halfEdges_[i];
	if (!joinsNext(i)) {
		if (isFaux(mesh_.faux[a.face], a.corner) && (i == 0 || !joinsNext(i - 1))) {
			out.joinNone.emplace_back(a.face, a.corner);
		}
		return;
	}
	const HalfEdge& b = halfEdges_[i + 1];
	if (commonFrontOf(a.face, b.face) > 0) {
		flat.unite(a.face, b.face);
		out.flat.push_back({VertexId{a.low}, VertexId{a.high}});
	} else {
		out.bent.push_back({a.face, b.face});
	}
}

Status FaceJoiner::run(ConcurrentSets& flat) {
	const int threads = arrangement_.options.threads;
	return inOrder([&] { return listHalfEdges(); },
	               [&] { return sortByEdge(halfEdges_, mesh_.points.size(), threads, monitor_); },
	               [&] { return halfEdges_.empty() ? Status{} : findLevels(); },
	               [&] {
		               joins_.resize(chunkCount(halfEdges_.size(), kGrain));
		               return parallelForChunks(
		                   halfEdges_.size(), kGrain, threads, monitor_,
		                   [&](std::size_t chunk, std::size_t begin, std::size_t end) {
			                   for (std::size_t i = begin; i < end; ++i) {
				                   join(i, flat, joins_[chunk]);
			                   }
		                   });
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
			out.flatEdges.insert(out.flatEdges.end(), part.flat.begin(), part.flat.end());
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
	const Status status = inOrder(
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
	if (!std::is_sorted(out.flatEdges.begin(), out.flatEdges.end())) {  // vertices in common
		std::sort(out.flatEdges.begin(), out.flatEdges.end());
	}
	return status;
}

}  // namespace index_boolean
