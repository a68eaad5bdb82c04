// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
//        c              Wanted: d lies inside the circle through a, b and c.
//      / | \            Legal: the way a, d, b, c turns left at a, and at b.
//    a - + - b   ->  a  |  b    The edge keeps its number; its sides are looked at again.
//      \ | /
//        d
//
// Why it ends: lift each place to the paraboloid (its height the square of its distance from the
// origin). The volume under the lifted triangles, each counted as its projected area is signed, is
// changed by a flip by a sixth of the in-circle determinant, whichever way the stored triangles are
// turned: it is an identity of polynomials. A wanted flip lowers the volume; where the determinant
// is zero, the perturbed heights do. So no state comes back, and there are finitely many.
//
// Why it is the same for everybody: edges are looked at first in the order of their ends, then in
// the order in which they were queued; the sides of a flipped quad are queued in the order of their
// ends. Nothing depends on the numbers of triangles or edges, and nothing passes a fixed edge. The
// order of ends is that of ranks: two faces in one plane that have the same points in a region rank
// them alike.
#include "vcg_ext/exact/delaunay_flips.h"

#include "vcg_ext/base/parallel.h"

#include <algorithm>
#include <numeric>

namespace index_boolean {

namespace {

PlanarEdge edgeBetween(std::uint32_t a, std::uint32_t b) {
	return {std::min(a, b), std::max(a, b)};
}

constexpr std::array<std::size_t, 3> kNext{1, 2, 0}, kBefore{2, 0, 1};

// The corner at which a triangle's side with these ends begins.
std::size_t sideOf(const std::array<std::uint32_t, 3>& t, const PlanarEdge& ends) {
	std::size_t side = 0;
	while (side < 2 && (t[(side + 2) % 3] == ends.left || t[(side + 2) % 3] == ends.right)) {
		++side;
	}
	return side;
}

}  // namespace

// Sorts edges in the order of their ends: by buckets for the left end, each of them in place.
void DelaunayFlips::sort(std::vector<FreeEdge>& edges, std::size_t pointCount) {
	ends_.assign(pointCount + 1, 0);
	for (const FreeEdge& edge : edges) {
		++ends_[edge.ends.left + 1];
	}
	std::partial_sum(ends_.begin(), ends_.end(), ends_.begin());
	sorted_.resize(edges.size());
	for (const FreeEdge& edge : edges) {
		sorted_[ends_[edge.ends.left]++] = edge;
	}
	std::size_t begin = 0;
	for (std::size_t left = 0; left < pointCount; ++left) {
		std::sort(sorted_.begin() + static_cast<std::ptrdiff_t>(begin),
		          sorted_.begin() + static_cast<std::ptrdiff_t>(ends_[left]),
		          [](const FreeEdge& e, const FreeEdge& f) { return e.ends.right < f.ends.right; });
		begin = ends_[left];
	}
	edges.swap(sorted_);
}

// Enters each edge into both of its triangles.
void DelaunayFlips::link(const std::vector<FreeEdge>& edges, std::size_t triangleCount) {
	edgeOf_.assign(triangleCount, {kNone, kNone, kNone});
	for (std::uint32_t e = 0; e < edges.size(); ++e) {
		for (const std::uint32_t t : edges[e].triangles) {
			edgeOf_[t][sideOf((*triangles_)[t], edges[e].ends)] = e;
		}
	}
}

DelaunayFlips::Quad DelaunayFlips::quadOf(const FreeEdge& edge, std::uint32_t index) const {
	const auto sideOfTriangle = [this, index](std::uint32_t triangle) -> std::size_t {
		const auto& edges = edgeOf_[triangle];
		return edges[0] == index ? 0 : edges[1] == index ? 1 : 2;
	};
	const auto [s, t] = edge.triangles;
	const std::size_t sideOfS = sideOfTriangle(s), sideOfT = sideOfTriangle(t);
	const std::array<std::uint32_t, 3>&cornersOfS = (*triangles_)[s],
	                                &cornersOfT = (*triangles_)[t];
	const std::uint32_t c = cornersOfS[kBefore[sideOfS]], d = cornersOfT[kBefore[sideOfT]];
	return c < d ? Quad{cornersOfS[sideOfS], cornersOfT[sideOfT], c, d, s, t, sideOfS, sideOfT}
	             : Quad{cornersOfT[sideOfT], cornersOfS[sideOfS], d, c, t, s, sideOfT, sideOfS};
}

DelaunayFlips::Sides DelaunayFlips::sidesOf(const Quad& q) const {
	const auto &first = edgeOf_[q.first], &second = edgeOf_[q.second];
	return {first[kNext[q.firstSide]], first[kBefore[q.firstSide]], second[kNext[q.secondSide]],
	        second[kBefore[q.secondSide]]};
}

bool DelaunayFlips::isWanted(const Quad& q) const {
	const std::vector<PlanarPlace>& at = *places_;
	return front_ * inCirclePerturbed({at[q.a], at[q.b], at[q.c], at[q.d]}, {q.a, q.b, q.c, q.d}) >
	       0;
}

bool DelaunayFlips::isLegal(const Quad& q) const {
	return front_ * (*orientation_)(q.a, q.d, q.c) > 0 &&
	       front_ * (*orientation_)(q.d, q.b, q.c) > 0;
}

// A side that has come from one triangle to another.
void DelaunayFlips::moveSide(std::uint32_t side, std::uint32_t from, std::uint32_t to) {
	if (side != kNone) {
		auto& beside = (*edges_)[side].triangles;
		(beside[0] == from ? beside[0] : beside[1]) = to;
	}
}

void DelaunayFlips::flip(const Quad& q, const Sides& sides, std::uint32_t index) {
	const bool aIsLower = q.a < q.b;  // the first triangle becomes that at the lower end
	const std::uint32_t atA = aIsLower ? q.first : q.second, atB = aIsLower ? q.second : q.first;
	(*triangles_)[atA] = {q.a, q.d, q.c};
	edgeOf_[atA] = {sides.ad, index, sides.ca};
	(*triangles_)[atB] = {q.d, q.b, q.c};
	edgeOf_[atB] = {sides.db, sides.bc, index};
	(*edges_)[index].ends = edgeBetween(q.c, q.d);
	moveSide(sides.ca, q.first, atA);
	moveSide(sides.bc, q.first, atB);
	moveSide(sides.ad, q.second, atA);
	moveSide(sides.db, q.second, atB);
}

void DelaunayFlips::enqueue(const Sides& sides) {
	struct Side {
		std::uint64_t ends;
		std::uint32_t edge;
	};
	const auto sideOfEdge = [this](std::uint32_t e) {
		const PlanarEdge ends = e == kNone ? PlanarEdge{kNone, kNone} : (*edges_)[e].ends;
		return Side{std::uint64_t{ends.left} << 32 | ends.right, e};
	};
	std::array<Side, 4> ordered{sideOfEdge(sides.ad), sideOfEdge(sides.db), sideOfEdge(sides.bc),
	                            sideOfEdge(sides.ca)};
	const auto order = [&ordered](std::size_t i, std::size_t j) {
		if (ordered[j].ends < ordered[i].ends) {
			std::swap(ordered[i], ordered[j]);
		}
	};
	order(0, 1);
	order(2, 3);
	order(0, 2);
	order(1, 3);
	order(1, 2);
	for (const Side& side : ordered) {
		if (side.edge != kNone && isQueued_[side.edge] == 0) {
			queue_.push_back(side.edge);
			isQueued_[side.edge] = 1;
		}
	}
}

std::size_t DelaunayFlips::run(std::vector<FreeEdge>& edges, const std::vector<PlanarPlace>& places,
                               int front, const PlanarOrientation& orientation, Monitor& monitor,
                               RankTriangles& triangles) {
	constexpr std::size_t kEdgesAPoll = 4096;
	edges_ = &edges;
	triangles_ = &triangles;
	places_ = &places;
	orientation_ = &orientation;
	front_ = front;
	sort(edges, places.size());
	link(edges, triangles.size());
	queue_.resize(edges.size());
	std::iota(queue_.begin(), queue_.end(), 0u);
	isQueued_.assign(edges.size(), 1);
	std::size_t flips = 0, looked = 0;
	for (std::size_t head = 0; head < queue_.size(); ++head) {
		if (++looked % kEdgesAPoll == 0 && pollCancelled(monitor)) {
			return flips;
		}
		const std::uint32_t index = queue_[head];
		isQueued_[index] = 0;
		const Quad quad = quadOf(edges[index], index);
		if (isWanted(quad) && isLegal(quad)) {
			const Sides sides = sidesOf(quad);
			flip(quad, sides, index);
			enqueue(sides);
			++flips;
		}
		if (head > kEdgesAPoll && 2 * head > queue_.size()) {  // done: no more of it is kept
			queue_.erase(queue_.begin(), queue_.begin() + static_cast<std::ptrdiff_t>(head) + 1);
			head = static_cast<std::size_t>(-1);
		}
	}
	return flips;
}

}  // namespace index_boolean
