// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One vertex after another goes, with the faces around it; what they leave is filled with faces
// that do without it.
//
//      5 ------- 4         One group: all faces at v lie in one plane, front up. Their edges
//      | \     / |         opposite v are a cycle, its star, here 1 to 6. The polygon of the star
//      6 -- v -- 3         is filled again: two triangles fewer.
//      | /     \ |         Two groups: the faces above the line 6 v 3 lie in one plane, those
//      1 ------- 2         below it in another. The line goes straight on at v, and is an edge
//                          from 6 to 3 afterwards: each side of it is filled on its own.
//
// Why the point set stays: seen from v, the corners of its star follow each other all the way round
// in one plane, or half of the way in each of two, so the faces at v cover just the polygons that
// are filled (star_polygon.cpp).
// Why closed stays closed, and a manifold a manifold: the new faces have the star as their border,
// as the old ones had. Inside, each cut has two of them, and no face elsewhere, since a cut between
// corners that are neighbours already is refused.
// Why a vertex that stays is never left inside a face: what is taken away lies in the faces at v,
// none of which has a vertex inside.
//
// What is chosen depends on places alone, exactly compared, not on numbers. A star begins with its
// smallest corner, a hole of one group with the same; a hole of two with an end of the line. That
// corner is where filling begins, and the old face there is whose source the new ones take. The
// order of the vertices is that of a hash of the coordinates: like chance, which keeps the polygons
// small, but the same in every numbering.
#include "vcg_ext/solids/merge_fragments.h"

#include "vcg_ext/arrange/joined_polygons.h"
#include "vcg_ext/arrange/places.h"
#include "vcg_ext/base/groups.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/exact/coordinate_hash.h"
#include "vcg_ext/exact/exact_sign.h"
#include "vcg_ext/solids/block_elements.h"
#include "vcg_ext/solids/face_groups.h"
#include "vcg_ext/solids/star_polygon.h"

#include <algorithm>

namespace index_boolean {

namespace {

// A face at a vertex that may go. Faces of one group lie in one plane and are joined; `origin` is
// the block's face that it is, or that it replaces with others.
struct StarFace {
	IndexTriangle corners;
	std::uint32_t group;
	std::uint32_t origin;
	bool alive;
};

// The edge opposite a vertex in one of its faces.
struct LinkEdge {
	std::uint32_t from, to;
	std::uint32_t face;
};

// The edges opposite a vertex, each from where the one before ends, and the last back to the first.
using Star = std::vector<LinkEdge>;

// The polygon that faces of one group leave when a vertex goes.
struct Hole {
	std::vector<std::uint32_t> corners;  // counter-clockwise seen from outside
	std::uint32_t group;                 // of the faces that fill it
	std::uint32_t origin;                // theirs too
};

class Merger {
public:
	Merger(const Arrangement& arrangement, Monitor& monitor, Block& block)
	    : arrangement_(arrangement), mesh_(arrangement.mesh), monitor_(monitor), block_(block) {}

	Status run();

private:
	void listCandidates();
	void collectFaces();
	void groupFaces();
	bool liesInPolygon(VertexId v) const;
	void keepCopies();
	void sortCandidates();
	std::vector<LinkEdge> linkOf(std::uint32_t v) const;
	bool findStar(std::uint32_t v, Star& star) const;
	bool listHoles(std::uint32_t v, const Star& star, std::vector<Hole>& holes) const;
	Hole holeOf(const Star& star, std::size_t begin, std::size_t end) const;
	bool isStraight(std::uint32_t a, std::uint32_t v, std::uint32_t b, std::uint32_t face,
	                std::uint32_t other) const;
	bool fill(const Hole& hole, std::uint32_t v, std::vector<StarFace>& out) const;
	bool isFree(std::uint32_t a, std::uint32_t b) const;
	void tryRemove(std::uint32_t v);
	void replace(const Star& star, const std::vector<StarFace>& filling);
	void compactFaces();

	bool wholeBlock() const { return arrangement_.options.mergeCoplanar; }
	ExactPoint exact(std::uint32_t v) const {
		return exactPoint(arrangement_, block_.vertexSource[v]);
	}
	const Point& roundedPlace(std::uint32_t v) const {
		return arrangement_.coordinates(block_.vertexSource[v]);
	}
	// Whether a vertex comes before another one by its exact place.
	bool isBefore(std::uint32_t a, std::uint32_t b) const {
		return comparePlaces(arrangement_, block_.vertexSource[a], block_.vertexSource[b]) < 0;
	}
	// The faces at a vertex, dead ones too. Most vertices of a block have none that may go.
	const std::vector<std::uint32_t>& facesAt(std::uint32_t v) const { return lists_[listAt_[v]]; }
	void addFaceAt(std::uint32_t v, std::uint32_t face) {
		if (listAt_[v] == 0) {
			listAt_[v] = static_cast<std::uint32_t>(lists_.size());
			lists_.emplace_back();
		}
		lists_[listAt_[v]].push_back(face);
	}
	const FaceSource& sourceOf(std::uint32_t face) const {
		return block_.faceSource[faces_[face].origin];
	}

	const Arrangement& arrangement_;
	const MeshArrays& mesh_;
	Monitor& monitor_;
	Block& block_;
	EdgeList flatEdges_;                     // that the curve may pass through inside a polygon
	std::vector<std::uint8_t> isCandidate_;  // per vertex of the block
	// Per vertex of the block: an input face's corner, or in a face that keeps its cuts.
	std::vector<std::uint8_t> isFixed_;
	std::vector<std::uint32_t> candidates_;
	std::vector<StarFace> faces_;
	std::vector<std::uint32_t> listAt_;  // per vertex of the block: which of the lists it has
	// Of faces, dead ones too. The first is empty, for vertices that have none.
	std::vector<std::vector<std::uint32_t>> lists_ = std::vector<std::vector<std::uint32_t>>(1);
	std::vector<std::uint8_t> removed_;  // per vertex of the block
	std::size_t originalCount_ = 0;      // of the faces, those of the block
};

// Whether a point of the curve lies inside a polygon, on an edge of its triangulation: the curve
// may pass straight through it.
bool Merger::liesInPolygon(VertexId v) const {
	if (flatEdges_.empty() || !arrangement_.isCurvePoint(v)) {
		return false;
	}
	const PointName& name = at(arrangement_.curve.names, arrangement_.pointOf(v));
	return name.kind == PointKind::EdgeFace &&
	       std::binary_search(flatEdges_.begin(), flatEdges_.end(),
	                          std::array{VertexId{name.ids[0]}, VertexId{name.ids[1]}});
}

void Merger::listCandidates() {
	isCandidate_.resize(block_.points.size());
	for (std::uint32_t v = 0; v < isCandidate_.size(); ++v) {
		if (wholeBlock() || block_.suspect[v] != 0 || liesInPolygon(block_.vertexSource[v])) {
			isCandidate_[v] = 1;
			candidates_.push_back(v);
		}
	}
}

// Where the block touches itself, all the sheets there keep their copy of the vertex: else a corner
// of one would lie inside an edge or a face of another, which no run takes as an operand. Copies of
// a suspect vertex are suspect.
void Merger::keepCopies() {
	const auto source = [this](std::uint32_t v) { return block_.vertexSource[v]; };
	std::sort(candidates_.begin(), candidates_.end(),
	          [&](std::uint32_t a, std::uint32_t b) { return source(a) < source(b); });
	const auto sameSource = [&](std::uint32_t a, std::uint32_t b) {
		return source(a) == source(b);
	};
	std::size_t kept = 0;
	forEachGroup(candidates_.begin(), candidates_.end(), sameSource, [&](auto first, auto last) {
		if (last - first == 1) {
			candidates_[kept++] = *first;
		}
	});
	candidates_.resize(kept);
}

void Merger::collectFaces() {
	const bool all = wholeBlock() || block_.anySuspectOffCurve;
	listAt_.resize(block_.points.size());
	isFixed_.resize(block_.points.size());
	for (std::size_t f = all ? 0 : block_.firstPiece; f < block_.triangles.size(); ++f) {
		const IndexTriangle& t = block_.triangles[f];
		if (std::none_of(t.begin(), t.end(),
		                 [this](std::uint32_t v) { return isCandidate_[v] != 0; })) {
			continue;
		}
		const auto face = static_cast<std::uint32_t>(faces_.size());
		faces_.push_back({t, 0, static_cast<std::uint32_t>(f), true});
		const Triangle& parent = at(mesh_.triangles, block_.faceSource[f].face);
		const bool isKept = block_.keepsCutsOf(f);
		for (const std::uint32_t v : t) {
			addFaceAt(v, face);
			const bool isCorner =
			    std::find(parent.begin(), parent.end(), block_.vertexSource[v]) != parent.end();
			if (isKept || (isCorner && !wholeBlock())) {
				isFixed_[v] = 1;
			}
		}
	}
}

void Merger::groupFaces() {
	std::vector<std::uint32_t> origins;
	for (const StarFace& face : faces_) {
		origins.push_back(face.origin);
	}
	const std::vector<std::uint32_t> groups = groupsOf(arrangement_, block_, origins);
	for (std::size_t f = 0; f < faces_.size(); ++f) {
		faces_[f].group = groups[f];
	}
}

// \pre no two candidates are copies of one vertex
void Merger::sortCandidates() {
	sortByHash(
	    candidates_, [this](std::uint32_t v) { return roundedPlace(v); },
	    [this](std::uint32_t v, std::uint32_t w) { return isBefore(v, w); });
}

// The edges opposite a vertex, in any order.
std::vector<LinkEdge> Merger::linkOf(std::uint32_t v) const {
	std::vector<LinkEdge> edges;
	edges.reserve(facesAt(v).size());
	for (const std::uint32_t face : facesAt(v)) {
		const StarFace& f = faces_[face];
		for (std::size_t i = 0; f.alive && i < 3; ++i) {
			if (f.corners[i] == v) {
				edges.push_back({f.corners[(i + 1) % 3], f.corners[(i + 2) % 3], face});
			}
		}
	}
	return edges;
}

// The edges opposite a vertex in their order around it, from its smallest neighbour on. False if
// they are not one cycle.
bool Merger::findStar(std::uint32_t v, Star& star) const {
	std::vector<LinkEdge> edges = linkOf(v);
	if (edges.empty()) {
		return false;
	}
	const auto byFrom = [](const LinkEdge& a, const LinkEdge& b) { return a.from < b.from; };
	std::sort(edges.begin(), edges.end(), byFrom);
	const auto byPlace = [this](const LinkEdge& a, const LinkEdge& b) {
		return isBefore(a.from, b.from);
	};
	const auto first = std::min_element(edges.begin(), edges.end(), byPlace);
	std::uint32_t from = first->from;
	star.clear();
	star.reserve(edges.size());
	do {
		const auto [begin, end] =
		    std::equal_range(edges.begin(), edges.end(), LinkEdge{from, 0, 0}, byFrom);
		if (end - begin != 1) {
			return false;
		}
		star.push_back(*begin);
		from = begin->to;
	} while (from != first->from && star.size() < edges.size());
	return star.size() == edges.size() && from == first->from;
}

// Whether no face has an edge between two vertices, in either direction.
bool Merger::isFree(std::uint32_t a, std::uint32_t b) const {
	const std::uint32_t fewer = facesAt(a).size() < facesAt(b).size() ? a : b;
	const std::uint32_t other = fewer == a ? b : a;
	return std::none_of(facesAt(fewer).begin(), facesAt(fewer).end(), [&](std::uint32_t face) {
		const StarFace& f = faces_[face];
		return f.alive && std::find(f.corners.begin(), f.corners.end(), other) != f.corners.end();
	});
}

// Fills the hole that a vertex leaves. False if that does not succeed, or if a cut is an edge
// elsewhere.
bool Merger::fill(const Hole& hole, std::uint32_t v, std::vector<StarFace>& out) const {
	const FaceSource& source = block_.faceSource[hole.origin];
	StarPolygon polygon;
	polygon.centre = exact(v);
	polygon.axis = projectionAxis(at(mesh_.triangles, source.face), mesh_.points, polygon.front);
	polygon.front = source.turned ? -polygon.front : polygon.front;
	polygon.corners.reserve(hole.corners.size());
	for (const std::uint32_t corner : hole.corners) {
		polygon.corners.push_back(exact(corner));
	}
	const std::vector<std::uint32_t>& corners = hole.corners;
	std::vector<std::array<std::size_t, 3>> triangles;
	const auto mayCut = [&](std::size_t a, std::size_t b) {
		return isFree(corners[a], corners[b]);
	};
	if (corners.size() < 3 || !fillStar(polygon, mayCut, triangles)) {
		return false;
	}
	for (const auto& [i, j, k] : triangles) {
		out.push_back({{corners[i], corners[j], corners[k]}, hole.group, hole.origin, true});
	}
	return true;
}

// The hole that the faces begin to end - 1 of a star leave, counted round and round: the corners
// from where the first begins to where the last ends. If these are all faces, both are one corner.
Hole Merger::holeOf(const Star& star, std::size_t begin, std::size_t end) const {
	const std::size_t n = star.size();
	const StarFace& face = faces_[star[begin % n].face];
	Hole hole{{}, face.group, face.origin};
	hole.corners.reserve(end - begin + 1);
	const std::size_t last = end - begin == n ? end - 1 : end;
	for (std::size_t i = begin; i <= last; ++i) {
		hole.corners.push_back(star[i % n].from);
	}
	return hole;
}

// Whether v lies in a straight line between a and b, which all lie in the planes of two faces.
// Where that is not one plane they do: seldom is there a need for exact points.
bool Merger::isStraight(std::uint32_t a, std::uint32_t v, std::uint32_t b, std::uint32_t face,
                        std::uint32_t other) const {
	const Triangle& s = at(mesh_.triangles, sourceOf(face).face);
	const Triangle& t = at(mesh_.triangles, sourceOf(other).face);
	const auto pointOf = [this](VertexId w) -> const Point& { return at(mesh_.points, w); };
	const auto isOutOfPlane = [&](VertexId corner) {
		return orient3d(pointOf(s[0]), pointOf(s[1]), pointOf(s[2]), pointOf(corner)) != 0;
	};
	if (std::any_of(t.begin(), t.end(), isOutOfPlane)) {
		return true;
	}
	int sign = 0;
	const int axis = projectionAxis(s, mesh_.points, sign);
	return orient2d(exact(a), exact(v), exact(b), axis) == 0;
}

// The holes that the faces of a star leave: one if they are one group, two if they are two groups
// that meet in a straight line through the vertex. False if they are neither.
bool Merger::listHoles(std::uint32_t v, const Star& star, std::vector<Hole>& holes) const {
	const std::size_t n = star.size();
	const auto groupOf = [&](std::size_t i) { return faces_[star[i % n].face].group; };
	std::vector<std::size_t> changes;  // where another group begins
	for (std::size_t i = 0; i < n; ++i) {
		if (groupOf(i) != groupOf(i + n - 1)) {
			changes.push_back(i);
		}
	}
	if (changes.empty()) {
		holes.push_back(holeOf(star, 0, n));
		return true;
	}
	if (changes.size() != 2) {
		return false;
	}
	const std::uint32_t a = star[changes[0]].from, b = star[changes[1]].from;
	if (!isStraight(a, v, b, star[changes[0]].face, star[changes[1]].face) || !isFree(a, b)) {
		return false;
	}
	holes.push_back(holeOf(star, changes[0], changes[1]));
	holes.push_back(holeOf(star, changes[1], changes[0] + n));
	return true;
}

// Puts other faces in place of those of a star.
void Merger::replace(const Star& star, const std::vector<StarFace>& filling) {
	for (const LinkEdge& e : star) {
		faces_[e.face].alive = false;
	}
	for (const StarFace& face : filling) {
		for (const std::uint32_t corner : face.corners) {
			addFaceAt(corner, static_cast<std::uint32_t>(faces_.size()));
		}
		faces_.push_back(face);
	}
}

// Removes a vertex if the holes that it leaves can be filled.
void Merger::tryRemove(std::uint32_t v) {
	Star star;
	std::vector<Hole> holes;
	if (isFixed_[v] != 0 || !findStar(v, star) || !listHoles(v, star, holes)) {
		return;
	}
	std::vector<StarFace> filling;
	if (std::all_of(holes.begin(), holes.end(),
	                [&](const Hole& hole) { return fill(hole, v, filling); })) {
		replace(star, filling);
		removed_[v] = 1;
	}
}

// Writes the faces back: those that stay in their order, then the new ones.
void Merger::compactFaces() {
	std::vector<std::uint8_t> gone(block_.triangles.size(), 0);
	IndexTriangles triangles;
	HugeVector<FaceSource> sources;
	for (std::size_t f = 0; f < faces_.size(); ++f) {
		if (f < originalCount_ && !faces_[f].alive) {
			gone[faces_[f].origin] = 1;
		} else if (f >= originalCount_ && faces_[f].alive) {
			triangles.push_back(faces_[f].corners);
			sources.push_back(block_.faceSource[faces_[f].origin]);
		}
	}
	removeFaces(gone, block_);
	block_.triangles.insert(block_.triangles.end(), triangles.begin(), triangles.end());
	block_.faceSource.insert(block_.faceSource.end(), sources.begin(), sources.end());
	// Faces merged across input faces may have points of the curve as corners wherever they are.
	block_.firstPiece = wholeBlock() ? 0 : block_.firstPiece;
}

Status Merger::run() {
	Status status = wholeBlock() ? Status{} : listFlatEdges(arrangement_, monitor_, flatEdges_);
	if (!status.ok()) {
		return status;
	}
	listCandidates();
	keepCopies();
	if (candidates_.empty()) {
		return status;
	}
	collectFaces();
	groupFaces();
	originalCount_ = faces_.size();
	removed_.assign(block_.points.size(), 0);
	sortCandidates();
	constexpr std::size_t kPoll = 1024;
	for (std::size_t i = 0; i < candidates_.size(); ++i) {
		if (i % kPoll == 0 && pollCancelled(monitor_)) {
			status.code = StatusCode::Cancelled;
			return status;
		}
		tryRemove(candidates_[i]);
	}
	if (originalCount_ < faces_.size()) {
		compactFaces();
		removeVertices(removed_, block_);
	}
	return status;
}

}  // namespace

Status mergeFragments(const Arrangement& arrangement, Monitor& monitor, Block& block) {
	const Options& options = arrangement.options;
	return options.mergeFragments || options.mergeCoplanar
	           ? Merger(arrangement, monitor, block).run()
	           : Status{};
}

}  // namespace index_boolean
