// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Half-edges sorted by their edge: the two of a faux edge are neighbours in the list.
#include "vcg_ext/arrange/joined_polygons.h"

#include "vcg_ext/base/edge_table.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/base/union_find.h"
#include "vcg_ext/exact/exact_sign.h"

#include <algorithm>
#include <numeric>

namespace index_boolean {

namespace {

// Whether a half-edge, in a list sorted by edge, is the first of two that join their faces.
enum class Join : std::uint8_t { None, Bent, Flat };

// A face that lies across an axis: the axis, and which way it turns seen against it.
struct Level {
	std::int8_t axis = -1;  // -1: it lies across none
	std::int8_t turn = 0;
};

using HalfEdges = HugeVector<HalfEdge>;

// Finds what joins the faces of one operand, as indices and by planes.
class FaceJoiner {
public:
	FaceJoiner(const Arrangement& arrangement, OperandId operand, Monitor& monitor)
	    : arrangement_(arrangement), mesh_(arrangement.mesh), monitor_(monitor),
	      begin_(mesh_.faceOffsets.begin(operand)), count_(mesh_.faceOffsets.size(operand)) {}

	Status run();

	std::size_t halfEdgeCount() const { return halfEdges_.size(); }

	// Calls visit(a, b, join) for the two half-edges of each edge that joins its faces.
	template <class Visit>
	void forEachJoin(Visit&& visit) const {
		for (std::size_t i = 0; i < joins_.size(); ++i) {
			if (joins_[i] != Join::None) {
				visit(halfEdges_[i], halfEdges_[i + 1], joins_[i]);
			}
		}
	}

private:
	static constexpr std::size_t kGrain = 1 << 12;

	Status findLevels();
	Status listHalfEdges();
	template <class Visit>
	void forEachHalfEdge(std::size_t f, Visit&& visit) const;
	Level levelOf(std::size_t face) const;
	Join joinAt(std::size_t i) const;
	int commonFrontOf(std::uint32_t a, std::uint32_t b) const;

	const Arrangement& arrangement_;
	const MeshArrays& mesh_;
	Monitor& monitor_;
	std::size_t begin_, count_;  // of the operand's faces
	HugeVector<Level> levels_;   // per face of the operand
	HalfEdges halfEdges_;        // sorted by edge
	HugeVector<Join> joins_;     // per half-edge
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

// Counted first, then written: they are many.
Status FaceJoiner::listHalfEdges() {
	const auto forEachIn = [this](std::size_t begin, std::size_t end, auto&& visit) {
		for (std::size_t i = begin; i < end; ++i) {
			forEachHalfEdge(begin_ + i, visit);
		}
	};
	const int threads = arrangement_.options.threads;
	std::vector<std::size_t> ends(chunkCount(count_, kGrain) + 1, 0);  // of each chunk
	const auto count = [&](std::size_t chunk, std::size_t begin, std::size_t end) {
		std::size_t found = 0;
		forEachIn(begin, end, [&](const HalfEdge&) { ++found; });
		ends[chunk + 1] = found;
	};
	const auto write = [&](std::size_t chunk, std::size_t begin, std::size_t end) {
		std::size_t next = ends[chunk];
		forEachIn(begin, end, [&](const HalfEdge& halfEdge) { halfEdges_[next++] = halfEdge; });
	};
	return inOrder([&] { return parallelForChunks(count_, kGrain, threads, monitor_, count); },
	               [&] {
		               std::partial_sum(ends.begin(), ends.end(), ends.begin());
		               halfEdges_.resizeForOverwrite(ends.back());
		               return parallelForChunks(count_, kGrain, threads, monitor_, write);
	               });
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

// What the i-th of the sorted half-edges is.
Join FaceJoiner::joinAt(std::size_t i) const {
	const HalfEdges& sorted = halfEdges_;
	const bool isFirst = i == 0 || !sorted[i - 1].sameEdge(sorted[i]);
	const bool hasMate = i + 1 < sorted.size() && sorted[i + 1].sameEdge(sorted[i]);
	if (!isFirst || !hasMate || (i + 2 < sorted.size() && sorted[i + 2].sameEdge(sorted[i]))) {
		return Join::None;
	}
	const HalfEdge &a = sorted[i], &b = sorted[i + 1];
	const bool joins = a.forward != b.forward && isFaux(mesh_.faux[a.face], a.corner) &&
	                   isFaux(mesh_.faux[b.face], b.corner);
	if (!joins) {
		return Join::None;
	}
	return commonFrontOf(a.face, b.face) > 0 ? Join::Flat : Join::Bent;
}

Status FaceJoiner::run() {
	const int threads = arrangement_.options.threads;
	return inOrder([&] { return listHalfEdges(); },
	               [&] { return sortByEdge(halfEdges_, mesh_.points.size(), threads, monitor_); },
	               [&] { return halfEdges_.empty() ? Status{} : findLevels(); },
	               [&] {
		               joins_.resizeForOverwrite(halfEdges_.size());
		               return parallelFor(halfEdges_.size(), kGrain, threads, monitor_,
		                                  [&](std::size_t begin, std::size_t end) {
			                                  for (std::size_t i = begin; i < end; ++i) {
				                                  joins_[i] = joinAt(i);
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

std::vector<FaceId> roots(UnionFind& sets) {
	sets.flatten();
	std::vector<FaceId> result(sets.size());
	for (std::uint32_t i = 0; i < result.size(); ++i) {
		result[i] = {sets.root(i)};
	}
	return result;
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
	if (mesh.faux.empty()) {
		return {};
	}
	UnionFind flat(mesh.triangles.size());
	std::vector<std::array<std::uint32_t, 2>> bent;  // faces joined, but not within one plane
	std::vector<std::uint8_t> joining(mesh.triangles.size(), 0);
	Polygons& out = arrangement.polygons;
	const Status status = forEachOperand(mesh.operands(), [&](OperandId operand) {
		FaceJoiner joiner(arrangement, operand, monitor);
		const Status found = joiner.run();
		if (!found.ok()) {
			return found;
		}
		out.flatEdges.reserve(out.flatEdges.size() + joiner.halfEdgeCount() / 2);
		joiner.forEachJoin([&](const HalfEdge& a, const HalfEdge& b, Join join) {
			markFaux(joining[a.face], a.corner);
			markFaux(joining[b.face], b.corner);
			if (join == Join::Flat) {
				flat.unite(a.face, b.face);
				out.flatEdges.push_back({VertexId{a.low}, VertexId{a.high}});
			} else {
				bent.push_back({a.face, b.face});
			}
		});
		return found;
	});
	mesh.faux = std::move(joining);
	if (!std::is_sorted(out.flatEdges.begin(), out.flatEdges.end())) {  // vertices in common
		std::sort(out.flatEdges.begin(), out.flatEdges.end());
	}
	out.flat = roots(flat);
	for (const auto& [a, b] : bent) {
		flat.unite(a, b);
	}
	out.polygon = bent.empty() ? out.flat : roots(flat);
	return status;
}

}  // namespace index_boolean
