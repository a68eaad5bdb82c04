// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One vertex after another goes: the faces around it, all in one plane or in two, are replaced by a
// triangulation of the polygon they leave. Seen from the vertex that polygon is a star, so cutting
// off ears needs no search among other corners. The order is that of a hash of the coordinates:
// like chance, which keeps the polygons small, but the same in every numbering.
#include "vcg_ext/solids/merge_fragments.h"

#include "vcg_ext/arrange/joined_polygons.h"
#include "vcg_ext/arrange/places.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/base/union_find.h"
#include "vcg_ext/exact/coordinate_hash.h"
#include "vcg_ext/exact/exact_sign.h"

#include <algorithm>

namespace index_boolean {

namespace {

// A face at a vertex that may go. Faces of one group lie in one plane and are joined; `origin` is
// the block's face that it is, or that it replaces with others.
struct LocalFace {
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

// The polygon that faces of one group leave, from the vertex that went.
struct Hole {
	std::vector<std::uint32_t> corners;  // counter-clockwise seen from outside
	std::uint32_t group;
	std::uint32_t origin;
};

class Merger {
public:
	Merger(const Arrangement& arrangement, Monitor& monitor, Block& block)
	    : arrangement_(arrangement), mesh_(arrangement.mesh), monitor_(monitor), block_(block) {}

	Status run();

private:
	void listCandidates();
	void collectFaces();
	void groupByParent();
	void groupByPlane();
	std::array<std::uint32_t, 2> classOf(FaceId face) const;
	bool coplanar(std::uint32_t f, std::uint32_t g) const;
	bool liesInPolygon(VertexId v) const;
	void keepCopies();
	void sortCandidates();
	Points linkPoints(std::uint32_t v) const;
	bool findStar(std::uint32_t v, std::vector<LinkEdge>& star) const;
	void tryRemove(std::uint32_t v);
	bool fill(const Hole& hole, std::uint32_t v, std::vector<LocalFace>& out) const;
	bool isFree(std::uint32_t a, std::uint32_t b) const;
	void compact();

	bool wholeBlock() const { return arrangement_.options.mergeCoplanar; }
	ExactPoint exact(std::uint32_t v) const {
		return exactPoint(arrangement_, block_.vertexSource[v]);
	}
	const Point& place(std::uint32_t v) const {
		return arrangement_.coordinates(block_.vertexSource[v]);
	}
	const FaceSource& sourceOf(std::uint32_t face) const {
		return block_.faceSource[faces_[face].origin];
	}

	const Arrangement& arrangement_;
	const MeshArrays& mesh_;
	Monitor& monitor_;
	Block& block_;
	std::vector<std::uint8_t> isCandidate_;  // per vertex of the block
	std::vector<std::uint8_t> isFixed_;      // per vertex of the block: an input face's corner
	std::vector<std::uint32_t> candidates_;
	std::vector<LocalFace> faces_;
	std::vector<std::vector<std::uint32_t>> facesAt_;  // per vertex of the block; dead ones too
	std::vector<std::uint8_t> removed_;                // per vertex of the block
	std::size_t originalCount_ = 0;                    // of the faces, those of the block
};

// Whether a point of the curve lies inside a polygon, on an edge of its triangulation: the curve
// may pass straight through it.
bool Merger::liesInPolygon(VertexId v) const {
	const auto& edges = arrangement_.polygons.flatEdges;
	if (edges.empty() || !arrangement_.isCurvePoint(v)) {
		return false;
	}
	const PointName& name = at(arrangement_.curve.names, arrangement_.pointOf(v));
	return name.kind == PointKind::EdgeFace &&
	       std::binary_search(edges.begin(), edges.end(),
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
	std::size_t kept = 0;
	for (std::size_t i = 0, end = 0; i < candidates_.size(); i = end) {
		while (end < candidates_.size() && source(candidates_[end]) == source(candidates_[i])) {
			++end;
		}
		if (end - i == 1) {
			candidates_[kept++] = candidates_[i];
		}
	}
	candidates_.resize(kept);
}

void Merger::collectFaces() {
	const bool all = wholeBlock() || block_.anySuspectOffCurve;
	facesAt_.resize(block_.points.size());
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
		for (const std::uint32_t v : t) {
			facesAt_[v].push_back(face);
			if (std::find(parent.begin(), parent.end(), block_.vertexSource[v]) != parent.end()) {
				isFixed_[v] = wholeBlock() ? 0 : 1;
			}
		}
	}
}

// Faces of a polygon that lie in one plane count as one input face.
void Merger::groupByParent() {
	const std::vector<FaceId>& flat = arrangement_.polygons.flat;
	for (LocalFace& face : faces_) {
		const FaceSource& source = block_.faceSource[face.origin];
		const FaceId parent = flat.empty() ? source.face : at(flat, source.face);
		face.group = 2 * parent.value + (source.turned ? 1 : 0);
	}
}

// What the face must have in common with others to become one with them; see MeshArrays.
std::array<std::uint32_t, 2> Merger::classOf(FaceId face) const {
	const OperandId operand = mesh_.operandOf(face);
	const std::vector<std::uint32_t>& classes = mesh_.faceClass[operand];
	return classes.empty() ? std::array{0u, 0u}
	                       : std::array{1u, classes[arrangement_.givenFace(face)]};
}

// Whether two neighbouring faces lie in one plane, with fronts to the same side, and may be one.
bool Merger::coplanar(std::uint32_t f, std::uint32_t g) const {
	const FaceSource& a = sourceOf(f);
	const FaceSource& b = sourceOf(g);
	if (a.face == b.face) {
		return a.turned == b.turned;
	}
	if (classOf(a.face) != classOf(b.face)) {
		return false;
	}
	const int front = commonFront(mesh_, a.face, b.face);
	return front != 0 && (front > 0) == (a.turned == b.turned);
}

void Merger::groupByPlane() {
	struct Side {
		std::uint32_t low, high, face;
	};
	std::vector<Side> sides;
	for (std::uint32_t f = 0; f < faces_.size(); ++f) {
		for (std::size_t i = 0; i < 3; ++i) {
			const auto edge =
			    std::minmax(faces_[f].corners[i], faces_[f].corners[i == 2 ? 0 : i + 1]);
			sides.push_back({edge.first, edge.second, f});
		}
	}
	std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
		return a.low != b.low     ? a.low < b.low
		       : a.high != b.high ? a.high < b.high
		                          : a.face < b.face;
	});
	UnionFind planes(faces_.size());
	for (std::size_t i = 0; i < sides.size();) {
		std::size_t end = i + 1;
		while (end < sides.size() && sides[end].low == sides[i].low &&
		       sides[end].high == sides[i].high) {
			++end;
		}
		if (end - i == 2 && coplanar(sides[i].face, sides[i + 1].face)) {
			planes.unite(sides[i].face, sides[i + 1].face);
		}
		i = end;
	}
	for (std::uint32_t f = 0; f < faces_.size(); ++f) {
		faces_[f].group = planes.find(f);
	}
}

// The places of a vertex's neighbours, sorted: what tells copies of one vertex apart.
Points Merger::linkPoints(std::uint32_t v) const {
	Points points;
	for (const std::uint32_t face : facesAt_[v]) {
		for (const std::uint32_t corner : faces_[face].corners) {
			points.push_back(place(corner));
		}
	}
	std::sort(points.begin(), points.end());
	return points;
}

void Merger::sortCandidates() {
	struct Key {
		std::uint64_t hash;
		std::uint32_t vertex;
	};
	std::vector<Key> keys;
	for (const std::uint32_t v : candidates_) {
		keys.push_back({coordinateHash(place(v)), v});
	}
	std::sort(keys.begin(), keys.end(), [this](const Key& a, const Key& b) {
		if (a.hash != b.hash) {
			return a.hash < b.hash;
		}
		if (place(a.vertex) != place(b.vertex)) {
			return place(a.vertex) < place(b.vertex);
		}
		return a.vertex != b.vertex && linkPoints(a.vertex) < linkPoints(b.vertex);
	});
	std::transform(keys.begin(), keys.end(), candidates_.begin(),
	               [](const Key& key) { return key.vertex; });
}

// The edges opposite a vertex in cyclic order, from its lexicographically smallest neighbour on.
// False if they are not one cycle.
bool Merger::findStar(std::uint32_t v, std::vector<LinkEdge>& star) const {
	std::vector<LinkEdge> edges;
	for (const std::uint32_t face : facesAt_[v]) {
		const LocalFace& f = faces_[face];
		for (std::size_t i = 0; f.alive && i < 3; ++i) {
			if (f.corners[i] == v) {
				edges.push_back({f.corners[(i + 1) % 3], f.corners[(i + 2) % 3], face});
			}
		}
	}
	const auto byFrom = [](const LinkEdge& a, const LinkEdge& b) { return a.from < b.from; };
	std::sort(edges.begin(), edges.end(), byFrom);
	star.clear();
	if (edges.empty()) {
		return false;
	}
	const auto first =
	    std::min_element(edges.begin(), edges.end(), [this](const LinkEdge& a, const LinkEdge& b) {
		    return place(a.from) < place(b.from);
	    });
	std::uint32_t from = first->from;
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
	const std::uint32_t fewer = facesAt_[a].size() < facesAt_[b].size() ? a : b;
	const std::uint32_t other = fewer == a ? b : a;
	return std::none_of(facesAt_[fewer].begin(), facesAt_[fewer].end(), [&](std::uint32_t face) {
		const LocalFace& f = faces_[face];
		return f.alive && std::find(f.corners.begin(), f.corners.end(), other) != f.corners.end();
	});
}

// A polygon whose corners are cut off one after another.
class Polygon {
public:
	explicit Polygon(std::size_t n) : next_(n), previous_(n), size_(n) {
		for (std::size_t i = 0; i < n; ++i) {
			next_[i] = i + 1 == n ? 0 : i + 1;
			previous_[i] = i == 0 ? n - 1 : i - 1;
		}
	}

	std::size_t next(std::size_t i) const { return next_[i]; }
	std::size_t previous(std::size_t i) const { return previous_[i]; }
	std::size_t size() const { return size_; }
	void cutOff(std::size_t i) {
		next_[previous_[i]] = next_[i];
		previous_[next_[i]] = previous_[i];
		--size_;
	}

private:
	std::vector<std::size_t> next_, previous_;
	std::size_t size_;
};

// Cuts the hole into triangles, ear by ear. A corner is an ear if the polygon turns left there and
// the vertex v, from which all of the polygon is seen, stays on the left of the cut; on the cut, if
// there is no better ear. False if that does not succeed, or if a cut is an edge elsewhere.
bool Merger::fill(const Hole& hole, std::uint32_t v, std::vector<LocalFace>& out) const {
	const FaceSource& source = block_.faceSource[hole.origin];
	int sign = 0;
	const int axis = projectionAxis(at(mesh_.triangles, source.face), mesh_.points, sign);
	sign = source.turned ? -sign : sign;
	std::vector<ExactPoint> points;
	for (const std::uint32_t corner : hole.corners) {
		points.push_back(exact(corner));
	}
	const ExactPoint centre = exact(v);
	const auto emit = [&](std::size_t i, std::size_t j, std::size_t k) {
		out.push_back(
		    {{hole.corners[i], hole.corners[j], hole.corners[k]}, hole.group, hole.origin, true});
	};
	Polygon polygon(points.size());
	std::size_t i = 0, misses = 0;
	int least = 1;  // what the side of the centre has to be
	while (polygon.size() > 3) {
		const std::size_t before = polygon.previous(i), after = polygon.next(i);
		if (sign * orient2d(points[before], points[i], points[after], axis) > 0 &&
		    sign * orient2d(points[before], points[after], centre, axis) >= least) {
			if (!isFree(hole.corners[before], hole.corners[after])) {
				return false;
			}
			emit(before, i, after);
			polygon.cutOff(i);
			i = polygon.next(after);  // the next but one: no long thin fans
			misses = 0;
			least = 1;
			continue;
		}
		i = after;
		if (++misses > polygon.size()) {
			if (least == 0) {
				return false;
			}
			least = 0;
			misses = 0;
		}
	}
	const std::size_t j = polygon.next(i), k = polygon.next(j);
	if (sign * orient2d(points[i], points[j], points[k], axis) <= 0) {
		return false;
	}
	emit(i, j, k);
	return true;
}

// Removes a vertex if all its faces are one group, or two groups that meet in a straight line
// through it.
void Merger::tryRemove(std::uint32_t v) {
	std::vector<LinkEdge> star;
	if (!findStar(v, star)) {
		return;
	}
	const std::size_t n = star.size();
	std::vector<std::size_t> changes;  // where another group begins
	for (std::size_t i = 0; i < n; ++i) {
		if (faces_[star[i].face].group != faces_[star[(i + n - 1) % n].face].group) {
			changes.push_back(i);
		}
	}
	if (isFixed_[v] != 0 || (!changes.empty() && changes.size() != 2)) {
		return;
	}
	std::vector<Hole> holes;
	const auto addHole = [&](std::size_t begin, std::size_t end) {
		const LocalFace& face = faces_[star[begin % n].face];
		Hole hole{{}, face.group, face.origin};
		for (std::size_t i = begin; i <= end; ++i) {
			hole.corners.push_back(star[i % n].from);
		}
		holes.push_back(std::move(hole));
	};
	if (changes.empty()) {
		addHole(0, n - 1);
	} else {
		const std::uint32_t a = star[changes[0]].from, b = star[changes[1]].from;
		const Triangle& parent = at(mesh_.triangles, sourceOf(star[0].face).face);
		int sign = 0;
		const int axis = projectionAxis(parent, mesh_.points, sign);
		if (orient2d(exact(a), exact(v), exact(b), axis) != 0 || !isFree(a, b)) {
			return;
		}
		addHole(changes[0], changes[1]);
		addHole(changes[1], changes[0] + n);
	}
	std::vector<LocalFace> filling;
	for (const Hole& hole : holes) {
		if (hole.corners.size() < 3 || !fill(hole, v, filling)) {
			return;
		}
	}
	for (const LinkEdge& e : star) {
		faces_[e.face].alive = false;
	}
	for (const LocalFace& face : filling) {
		for (const std::uint32_t corner : face.corners) {
			facesAt_[corner].push_back(static_cast<std::uint32_t>(faces_.size()));
		}
		faces_.push_back(face);
	}
	removed_[v] = 1;
}

// Writes the faces back: those that stay in their order, then the new ones. Takes the removed
// vertices out.
void Merger::compact() {
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
	std::size_t kept = 0, keptBeforePieces = 0;
	for (std::size_t f = 0; f < gone.size(); ++f) {
		if (gone[f] == 0) {
			keptBeforePieces += f < block_.firstPiece ? 1 : 0;
			block_.triangles[kept] = block_.triangles[f];
			block_.faceSource[kept++] = block_.faceSource[f];
		}
	}
	block_.triangles.resize(kept);
	block_.faceSource.resize(kept);
	block_.triangles.insert(block_.triangles.end(), triangles.begin(), triangles.end());
	block_.faceSource.insert(block_.faceSource.end(), sources.begin(), sources.end());
	// Faces merged across input faces may have points of the curve as corners wherever they are.
	block_.firstPiece = wholeBlock() ? 0 : keptBeforePieces;

	std::vector<std::uint32_t> newIndex(block_.points.size());
	std::uint32_t count = 0;
	for (std::size_t v = 0; v < newIndex.size(); ++v) {
		newIndex[v] = count;
		if (removed_[v] == 0) {
			block_.points[count] = block_.points[v];
			block_.vertexSource[count] = block_.vertexSource[v];
			block_.suspect[count++] = block_.suspect[v];
		}
	}
	block_.points.resize(count);
	block_.vertexSource.resize(count, VertexId::none());
	block_.suspect.resize(count);
	for (IndexTriangle& t : block_.triangles) {
		t = {newIndex[t[0]], newIndex[t[1]], newIndex[t[2]]};
	}
}

Status Merger::run() {
	Status status;
	listCandidates();
	keepCopies();
	if (candidates_.empty()) {
		return status;
	}
	collectFaces();
	if (wholeBlock()) {
		groupByPlane();
	} else {
		groupByParent();
	}
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
		compact();
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
