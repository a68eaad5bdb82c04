// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Each region is a planar problem. Free is an edge that two of its faces have, and no others, that
// turn as the region does: slivers that are seen from their sides stay. A region of which a flip
// has made an edge that is one elsewhere, on a wall behind it, gets its faces back.
#include "vcg_ext/mesh/region_flips.h"

#include "vcg_ext/base/edge_table.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/base/sorted_list.h"
#include "vcg_ext/exact/delaunay_flips.h"
#include "vcg_ext/exact/exact_sign.h"

#include <algorithm>

namespace index_boolean {

namespace {

// The orientation of places in a projection, by rank.
class SeenOrientation : public PlanarOrientation {
public:
	SeenOrientation(const std::vector<Point>& points, int axis) : points_(points), axis_(axis) {}
	int operator()(std::uint32_t a, std::uint32_t b, std::uint32_t c) const override {
		return orient2d(points_[a], points_[b], points_[c], axis_);
	}

private:
	const std::vector<Point>& points_;
	int axis_;
};

// An edge that may be flipped, between two faces of a region.
struct RegionEdge {
	std::uint32_t region;
	std::array<std::uint32_t, 2> faces;
};

class RegionFlipper {
public:
	RegionFlipper(const RegionFlips& flips, const std::vector<std::uint8_t>& isAlive,
	              Monitor& monitor, std::vector<RegionFace>& faces)
	    : flips_(flips), isAlive_(isAlive), monitor_(monitor), faces_(faces) {}

	Status run();

private:
	using Edge = std::array<std::uint32_t, 2>;

	bool isWanted(std::uint32_t face) const;
	bool turnsAsRegion(std::uint32_t face) const;
	void markNear();
	std::vector<HalfEdge> sides() const;
	void listFreeEdges(const std::vector<HalfEdge>& sides);
	void flip(const RegionEdge* first, const RegionEdge* last);
	static std::vector<Edge> sharedEdges(const std::vector<HalfEdge>& sides);
	std::vector<std::uint32_t> regionsAt(const std::vector<Edge>& shared) const;

	const RegionFlips& flips_;
	const std::vector<std::uint8_t>& isAlive_;
	Monitor& monitor_;
	std::vector<RegionFace>& faces_;
	std::vector<std::uint8_t> isNear_;  // per vertex: a face of a wanted region has its place
	std::vector<RegionEdge> edges_;     // by region
	DelaunayFlips delaunay_;
};

bool RegionFlipper::isWanted(std::uint32_t face) const {
	const RegionFace& f = faces_[face];
	return !flips_.regions.isSingle(f.region) && flips_.isWanted[f.region] != 0 &&
	       flips_.isKept[f.origin] == 0;
}

bool RegionFlipper::turnsAsRegion(std::uint32_t face) const {
	const RegionFace& f = faces_[face];
	const NearPlane& plane = flips_.regions.planes[f.region];
	const Points& points = flips_.surface.points;
	return plane.front * orient2d(points[f.corners[0]], points[f.corners[1]], points[f.corners[2]],
	                              plane.axis) >
	       0;
}

void RegionFlipper::markNear() {
	isNear_.assign(flips_.surface.points.size(), 0);
	for (std::uint32_t f = 0; f < faces_.size(); ++f) {
		if (isAlive_[f] != 0 && isWanted(f)) {
			for (const std::uint32_t v : faces_[f].corners) {
				isNear_[flips_.surface.place[v]] = 1;
			}
		}
	}
}

// The sides of all faces between corners of wanted regions, by edge.
std::vector<HalfEdge> RegionFlipper::sides() const {
	const std::vector<std::uint32_t>& place = flips_.surface.place;
	std::vector<HalfEdge> sides;
	for (std::size_t f = 0; f < faces_.size(); ++f) {
		const IndexTriangle& t = faces_[f].corners;
		for (std::size_t i = 0; isAlive_[f] != 0 && i < 3; ++i) {
			const std::uint32_t from = place[t[i]], to = place[t[(i + 1) % 3]];
			if (isNear_[from] != 0 && isNear_[to] != 0) {
				sides.push_back(makeHalfEdge(from, to, f, i));
			}
		}
	}
	std::sort(sides.begin(), sides.end());
	return sides;
}

void RegionFlipper::listFreeEdges(const std::vector<HalfEdge>& sides) {
	forEachSortedManifoldEdge(sides, [&](const HalfEdge& h, const HalfEdge& g) {
		const IndexTriangle &s = faces_[h.face].corners, &t = faces_[g.face].corners;
		const bool isJoined =
		    s[h.corner] == t[(g.corner + 1) % 3] && t[g.corner] == s[(h.corner + 1) % 3];
		if (isJoined && faces_[h.face].region == faces_[g.face].region && isWanted(h.face) &&
		    isWanted(g.face) && turnsAsRegion(h.face) && turnsAsRegion(g.face)) {
			edges_.push_back({faces_[h.face].region, {h.face, g.face}});
		}
	});
	std::sort(edges_.begin(), edges_.end(), [](const RegionEdge& a, const RegionEdge& b) {
		return a.region != b.region ? a.region < b.region : a.faces < b.faces;
	});
}

// The points of a region by rank, as its triangles are told to DelaunayFlips.
struct RankedPoints {
	std::vector<std::uint32_t> vertices;  // ascending
	std::vector<std::uint32_t> byRank, rankOf;
	std::vector<Point> points;
	std::vector<PlanarPlace> places;

	RankedPoints(const Points& all, int axis, std::vector<std::uint32_t> used)
	    : vertices(std::move(used)), byRank(vertices), rankOf(vertices.size()) {
		const auto u = static_cast<std::size_t>(nextCorner(axis));
		const auto v = static_cast<std::size_t>(previousCorner(axis));
		const auto seen = [&](std::uint32_t a) {
			return Point{all[a][u], all[a][v], all[a][static_cast<std::size_t>(axis)]};
		};
		std::sort(byRank.begin(), byRank.end(),
		          [&](std::uint32_t a, std::uint32_t b) { return seen(a) < seen(b); });
		for (std::uint32_t rank = 0; rank < byRank.size(); ++rank) {
			const Point& p = all[byRank[rank]];
			rankOf[placeIn(vertices, byRank[rank])] = rank;
			points.push_back(p);
			places.push_back({p[u], p[v]});
		}
	}

	std::uint32_t rank(std::uint32_t vertex) const { return rankOf[placeIn(vertices, vertex)]; }
};

// The edge that two triangles of ranks have in common.
PlanarEdge commonEdge(const std::array<std::uint32_t, 3>& s,
                      const std::array<std::uint32_t, 3>& t) {
	std::array<std::uint32_t, 2> ends{};
	std::size_t count = 0;
	for (const std::uint32_t v : s) {
		if (count < 2 && std::find(t.begin(), t.end(), v) != t.end()) {
			ends[count++] = v;
		}
	}
	return {std::min(ends[0], ends[1]), std::max(ends[0], ends[1])};
}

// Flips within one region.
void RegionFlipper::flip(const RegionEdge* first, const RegionEdge* last) {
	const NearPlane& plane = flips_.regions.planes[first->region];
	std::vector<std::uint32_t> used, vertices;
	for (const RegionEdge* e = first; e != last; ++e) {
		used.insert(used.end(), e->faces.begin(), e->faces.end());
	}
	sortUnique(used);
	for (const std::uint32_t f : used) {
		vertices.insert(vertices.end(), faces_[f].corners.begin(), faces_[f].corners.end());
	}
	sortUnique(vertices);
	const RankedPoints ranked(flips_.surface.points, plane.axis, std::move(vertices));
	RankTriangles triangles;
	for (const std::uint32_t f : used) {
		const IndexTriangle& t = faces_[f].corners;
		triangles.push_back({ranked.rank(t[0]), ranked.rank(t[1]), ranked.rank(t[2])});
	}
	std::vector<FreeEdge> edges;
	for (const RegionEdge* e = first; e != last; ++e) {
		const std::array<std::uint32_t, 2> pair{placeIn(used, e->faces[0]),
		                                        placeIn(used, e->faces[1])};
		edges.push_back({commonEdge(triangles[pair[0]], triangles[pair[1]]), pair});
	}
	const RankTriangles before = triangles;
	delaunay_.run(edges, ranked.places, plane.front, SeenOrientation(ranked.points, plane.axis),
	              monitor_, triangles);
	for (std::size_t i = 0; i < used.size(); ++i) {
		if (triangles[i] != before[i]) {
			const auto& t = triangles[i];
			faces_[used[i]].corners = {ranked.byRank[t[0]], ranked.byRank[t[1]],
			                           ranked.byRank[t[2]]};
		}
	}
}

// The edges that more than two faces have.
std::vector<RegionFlipper::Edge> RegionFlipper::sharedEdges(const std::vector<HalfEdge>& sides) {
	std::vector<Edge> shared;
	forEachSortedEdge(sides.begin(), sides.end(), [&](auto first, auto last) {
		if (last - first > 2) {
			shared.push_back({first->low, first->high});
		}
	});
	return shared;
}

// The wanted regions that have come to an edge that more than two faces have.
// \param shared such edges as they were before, ascending
std::vector<std::uint32_t> RegionFlipper::regionsAt(const std::vector<Edge>& shared) const {
	std::vector<std::uint32_t> found;
	const std::vector<HalfEdge> all = sides();
	forEachSortedEdge(all.begin(), all.end(), [&](auto first, auto last) {
		const bool isNew = last - first > 2 && !std::binary_search(shared.begin(), shared.end(),
		                                                           Edge{first->low, first->high});
		for (auto side = first; isNew && side != last; ++side) {
			if (isWanted(side->face)) {
				found.push_back(faces_[side->face].region);
			}
		}
	});
	sortUnique(found);
	return found;
}

Status RegionFlipper::run() {
	markNear();
	const std::vector<HalfEdge> before = sides();
	listFreeEdges(before);
	if (edges_.empty()) {
		return {};
	}
	const std::vector<Edge> shared = sharedEdges(before);
	const std::vector<RegionFace> unflipped = faces_;
	forEachGroup(
	    edges_.data(), edges_.data() + edges_.size(),
	    [](const RegionEdge& a, const RegionEdge& b) { return a.region == b.region; },
	    [&](const RegionEdge* first, const RegionEdge* last) {
		    if (!pollCancelled(monitor_)) {
			    flip(first, last);
		    }
	    });
	const std::vector<std::uint32_t> undone = regionsAt(shared);
	for (std::size_t f = 0; f < faces_.size() && !undone.empty(); ++f) {
		if (std::binary_search(undone.begin(), undone.end(), faces_[f].region)) {
			faces_[f] = unflipped[f];
		}
	}
	return statusOf(pollCancelled(monitor_) ? StatusCode::Cancelled : StatusCode::Ok);
}

}  // namespace

Status flipRegions(const RegionFlips& flips, const std::vector<std::uint8_t>& isAlive,
                   Monitor& monitor, std::vector<RegionFace>& faces) {
	return RegionFlipper(flips, isAlive, monitor, faces).run();
}

}  // namespace index_boolean
