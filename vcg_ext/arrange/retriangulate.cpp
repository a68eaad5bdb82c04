// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Each cut face becomes a planar problem of its own: its corners, the points on its edges, the
// segments inside it, all known by index. Only their order and orientation are asked of geometry.
#include "vcg_ext/arrange/retriangulate.h"

#include "vcg_ext/arrange/places.h"
#include "vcg_ext/arrange/self_intersecting.h"
#include "vcg_ext/base/bucket_sort.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/exact/exact_sign.h"
#include "vcg_ext/exact/planar_sweep.h"

#include <algorithm>
#include <numeric>

namespace index_boolean {

namespace {

// What one face has to respect.
struct FaceLines {
	FaceId face;
	const FaceSegment* segments;
	const FaceSegment* segmentsEnd;
	const FaceDiagonal* diagonals;
	const FaceDiagonal* diagonalsEnd;
};

// The regions to both sides of a segment on one face, numbered within a chunk; or kNone.
struct FaceSides {
	SegmentId segment;
	FaceId face;
	std::uint32_t left, right;
};
constexpr std::uint32_t kNone = 0xffffffffu;

struct RegionLink {
	std::uint32_t region;
	NodeId other;
};

// What one chunk of cut faces gives.
struct ChunkPieces {
	std::vector<CutFace> cutFaces;
	Triangles pieces;
	std::vector<std::uint32_t> pieceRegion;
	std::vector<FaceSides> sides;
	std::vector<RegionLink> links;
	std::vector<RegionLink> cornerLinks;
	std::uint32_t regionCount = 0;
	FaceId failed = FaceId::none();
};

// A vertex of the planar problem and the parent's edges that it lies on, as bits.
struct LocalVertex {
	VertexId id;
	std::uint8_t onEdges;

	bool isCorner() const { return (onEdges & (onEdges - 1)) != 0; }
};

// An edge of the planar problem. Fixed are those that part regions or bound the face: a segment of
// the curve, an interval of the face's border, or both.
struct LocalEdge {
	PlanarEdge ranks;
	bool isFixed = false, isBorder = false;
	bool rising = false;  // the segment runs from the lower to the higher rank
	SegmentId segment = SegmentId::none();
	NodeId interval = NodeId::none();  // of a border edge with both ends on the other operand
	// The pieces to the right and to the left of the way from the lower to the higher rank.
	std::array<std::uint32_t, 2> pieces{kNone, kNone};
};

// The edges of a planar problem, each once, in the order in which they were named.
class LocalEdges {
public:
	// Empty again, with room for that many edges.
	void reset(std::size_t most) {
		edges_.clear();
		edges_.reserve(most);
		most_ = most;
		unsigned bits = 2;
		while (std::size_t{1} << bits < 2 * most) {
			++bits;
		}
		shift_ = 64 - bits;
		slots_.assign(std::size_t{1} << bits, 0);
	}

	// The edge between two points, which is new if it has not been named yet; or null if there is
	// no room for one more.
	LocalEdge* named(std::uint32_t a, std::uint32_t b) {
		constexpr std::uint64_t kMultiplier = 0x9e3779b97f4a7c15u;  // 2^64 / golden ratio
		const PlanarEdge ranks{std::min(a, b), std::max(a, b)};
		const std::uint64_t key = std::uint64_t{ranks.left} << 32 | ranks.right;
		std::size_t slot = key * kMultiplier >> shift_;
		for (; slots_[slot] != 0; slot = (slot + 1) & (slots_.size() - 1)) {
			LocalEdge& edge = edges_[slots_[slot] - 1];
			if (edge.ranks.left == ranks.left && edge.ranks.right == ranks.right) {
				return &edge;
			}
		}
		if (edges_.size() == most_) {
			return nullptr;
		}
		edges_.push_back({ranks});
		slots_[slot] = static_cast<std::uint32_t>(edges_.size());
		return &edges_.back();
	}

	const std::vector<LocalEdge>& all() const { return edges_; }

private:
	std::vector<LocalEdge> edges_;
	std::size_t most_ = 0;
	std::vector<std::uint32_t> slots_;  // open addressing: 1 + the place among the edges, or 0
	unsigned shift_ = 0;
};

// The points of a planar problem, as rounded; what these leave in doubt is asked of the exact ones.
class PlanarPoints {
public:
	explicit PlanarPoints(const Arrangement& arrangement) : arrangement_(arrangement) {}

	void assign(const std::vector<LocalVertex>& vertices, int axis) {
		vertices_ = &vertices;
		axis_ = axis;
		points_.clear();
		for (const LocalVertex& v : vertices) {
			const bool isExact = !arrangement_.isCurvePoint(v.id);
			points_.emplace_back(arrangement_.coordinates(v.id), isExact, axis);
		}
	}

	// Whether a comes before b in lexicographic order. Rounding is monotone: rounded coordinates
	// that differ have the order of the exact ones.
	bool isBefore(std::uint32_t a, std::uint32_t b) const {
		if (points_[a].x.value != points_[b].x.value) {
			return points_[a].x.value < points_[b].x.value;
		}
		const ExactPoint p = exact(a), q = exact(b);
		const int order = compareCoordinate(p, q, nextCorner(axis_));
		return order != 0 ? order < 0 : compareCoordinate(p, q, previousCorner(axis_)) < 0;
	}

	// Three points on one edge of the face are collinear by name.
	int orientation(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
		const std::vector<LocalVertex>& v = *vertices_;
		if ((v[a].onEdges & v[b].onEdges & v[c].onEdges) != 0) {
			return 0;
		}
		const int sign = orient2d(points_[a], points_[b], points_[c]);
		return sign != kUnknownSign ? sign : orient2d(exact(a), exact(b), exact(c), axis_);
	}

private:
	ExactPoint exact(std::uint32_t i) const { return exactPoint(arrangement_, (*vertices_)[i].id); }

	const Arrangement& arrangement_;
	const std::vector<LocalVertex>* vertices_ = nullptr;
	int axis_ = 0;
	std::vector<PlanarPoint> points_;
};

// The same for points given by rank.
class FaceOrientation : public PlanarOrientation {
public:
	FaceOrientation(const PlanarPoints& points, const std::vector<std::uint32_t>& order)
	    : points_(points), order_(order) {}

	int operator()(std::uint32_t a, std::uint32_t b, std::uint32_t c) const override {
		return points_.orientation(order_[a], order_[b], order_[c]);
	}

private:
	const PlanarPoints& points_;
	const std::vector<std::uint32_t>& order_;  // by rank
};

// Finds cut edges by their ends: few to search among begin with about the same lower end.
class CutEdgeFinder {
public:
	CutEdgeFinder(const std::vector<CutEdge>& edges, std::size_t vertexCount) : edges_(edges) {
		while (vertexCount >> shift_ > edges.size()) {
			++shift_;
		}
		firsts_.resize((vertexCount >> shift_) + 2);
		for (const CutEdge& e : edges) {
			++firsts_[bucketOf(e.low) + 1];
		}
		std::partial_sum(firsts_.begin(), firsts_.end(), firsts_.begin());
	}

	// The cut edge between two vertices, or null.
	const CutEdge* find(VertexId a, VertexId b) const {
		const std::pair<VertexId, VertexId> key = std::minmax(a, b);
		const auto begin = edges_.begin() + firsts_[bucketOf(key.first)];
		const auto end = edges_.begin() + firsts_[bucketOf(key.first) + 1];
		const auto it = std::lower_bound(
		    begin, end, key, [](const CutEdge& e, const std::pair<VertexId, VertexId>& k) {
			    return e.low != k.first ? e.low < k.first : e.high < k.second;
		    });
		const bool found = it != end && it->low == key.first && it->high == key.second;
		return found ? &*it : nullptr;
	}

private:
	std::size_t bucketOf(VertexId low) const { return low.value >> shift_; }

	const std::vector<CutEdge>& edges_;  // sorted
	unsigned shift_ = 0;
	std::vector<std::uint32_t> firsts_;  // per bucket of lower ends; the end of all last
};

// Retriangulates one face after another, with reused buffers.
class FaceCutter {
public:
	FaceCutter(const Arrangement& arrangement, const CutEdgeFinder& cutEdges, Monitor& monitor,
	           ChunkPieces& out)
	    : arrangement_(arrangement), cutEdges_(cutEdges), monitor_(monitor), out_(out),
	      points_(arrangement) {}

	// False if the lines cannot all be part of one triangulation, or if the run is cancelled.
	bool cut(const FaceLines& lines);

private:
	// For between the steps of a face that takes long.
	bool isStopped() const { return vertices_.size() > kMany && pollCancelled(monitor_); }

	void collectBorder();
	void collectInner(const FaceLines& lines);
	bool sortVertices();
	std::uint32_t rankOf(VertexId id) const;
	bool fixSegments(const FaceLines& lines);
	bool fixBorder();
	void collectPlanarEdges(const FaceLines& lines);
	bool findPieces();
	bool unitePieces();
	void numberRegions();
	void recordSides();
	void emit();

	static constexpr std::size_t kMany = 4096;

	const Arrangement& arrangement_;
	const CutEdgeFinder& cutEdges_;
	Monitor& monitor_;
	ChunkPieces& out_;

	FaceId face_{};
	const Triangle* corners_ = nullptr;
	int axis_ = 0;
	int sign_ = 1;
	std::array<std::vector<VertexId>, 3> side_;  // corner i, the points on edge i, corner i+1
	std::array<const CutEdge*, 3> cutEdge_{};
	std::vector<LocalVertex> vertices_;  // by id
	PlanarPoints points_;                // of the vertices
	std::vector<std::uint32_t> order_;   // by rank: which of the vertices it is
	std::vector<std::uint32_t> rankOfVertex_;
	LocalEdges edges_;
	std::size_t fixedCount_ = 0;  // of the edges the first are fixed
	std::vector<PlanarEdge> planarEdges_;
	PlanarSweep sweep_;
	std::vector<std::array<std::uint32_t, 3>> triangles_;
	std::vector<std::uint32_t> regionOf_;  // per triangle; a union-find while uniting
	std::vector<std::uint32_t> number_;    // of the region, while they are numbered
};

void FaceCutter::collectBorder() {
	const Curve& curve = arrangement_.curve;
	vertices_.clear();
	for (int i = 0; i < 3; ++i) {
		const auto k = static_cast<std::size_t>(i);
		const VertexId from = (*corners_)[k];
		const VertexId to = (*corners_)[static_cast<std::size_t>(nextCorner(i))];
		const auto onEdge = static_cast<std::uint8_t>(1 << i);
		const auto atCorner = static_cast<std::uint8_t>(onEdge | 1 << previousCorner(i));
		vertices_.push_back({from, atCorner});
		side_[k].assign(1, from);
		cutEdge_[k] = cutEdges_.find(from, to);
		if (cutEdge_[k] != nullptr) {
			const VertexId* points = curve.pointsOnEdges.data() + cutEdge_[k]->first;
			for (std::uint32_t p = 0; p < cutEdge_[k]->count; ++p) {
				side_[k].push_back(points[p]);
				vertices_.push_back({side_[k].back(), onEdge});
			}
			if (to < from) {
				std::reverse(side_[k].begin() + 1, side_[k].end());
			}
		}
		side_[k].push_back(to);
	}
}

void FaceCutter::collectInner(const FaceLines& lines) {
	const auto add = [this](VertexId v) { vertices_.push_back({v, 0}); };
	for (const FaceSegment* s = lines.segments; s != lines.segmentsEnd; ++s) {
		add(at(arrangement_.curve.segments, s->segment).begin);
		add(at(arrangement_.curve.segments, s->segment).end);
	}
	// Of equal ids the entry from the border comes first and stays.
	std::sort(vertices_.begin(), vertices_.end(), [](const LocalVertex& a, const LocalVertex& b) {
		return a.id != b.id ? a.id < b.id : a.onEdges > b.onEdges;
	});
	vertices_.erase(
	    std::unique(vertices_.begin(), vertices_.end(),
	                [](const LocalVertex& a, const LocalVertex& b) { return a.id == b.id; }),
	    vertices_.end());
}

// Ranks the vertices in lexicographic order of the projected exact coordinates. False if two of
// them lie in one place: their names differ, so an operand touches itself there.
bool FaceCutter::sortVertices() {
	points_.assign(vertices_, axis_);
	order_.resize(vertices_.size());
	std::iota(order_.begin(), order_.end(), 0u);
	const auto before = [this](std::uint32_t a, std::uint32_t b) { return points_.isBefore(a, b); };
	std::sort(order_.begin(), order_.end(), before);
	for (std::size_t i = 0; i + 1 < order_.size(); ++i) {
		if (!before(order_[i], order_[i + 1])) {
			return false;
		}
	}
	rankOfVertex_.resize(order_.size());
	for (std::uint32_t rank = 0; rank < order_.size(); ++rank) {
		rankOfVertex_[order_[rank]] = rank;
	}
	return true;
}

// \pre one of the vertices, which are sorted by id
std::uint32_t FaceCutter::rankOf(VertexId id) const {
	const auto it =
	    std::lower_bound(vertices_.begin(), vertices_.end(), id,
	                     [](const LocalVertex& v, VertexId wanted) { return v.id < wanted; });
	return rankOfVertex_[static_cast<std::size_t>(it - vertices_.begin())];
}

// False if two segments have the same ends.
bool FaceCutter::fixSegments(const FaceLines& lines) {
	for (const FaceSegment* s = lines.segments; s != lines.segmentsEnd; ++s) {
		const Segment& segment = at(arrangement_.curve.segments, s->segment);
		const std::uint32_t from = rankOf(segment.begin);
		const std::uint32_t to = rankOf(segment.end);
		LocalEdge* edge = edges_.named(from, to);
		if (edge == nullptr || edge->isFixed) {
			return false;
		}
		edge->isFixed = true;
		edge->rising = from < to;
		edge->segment = s->segment;
	}
	return true;
}

bool FaceCutter::fixBorder() {
	const auto vertexCount = static_cast<std::uint32_t>(arrangement_.mesh.points.size());
	for (int i = 0; i < 3; ++i) {
		const std::vector<VertexId>& side = side_[static_cast<std::size_t>(i)];
		const CutEdge* cutEdge = cutEdge_[static_cast<std::size_t>(i)];
		const bool reversed = side.back() < side.front();
		std::uint32_t to = rankOf(side[0]);
		for (std::size_t j = 0; j + 1 < side.size(); ++j) {
			const std::uint32_t from = to;
			to = rankOf(side[j + 1]);
			LocalEdge* edge = edges_.named(from, to);
			if (edge == nullptr) {
				return false;
			}
			edge->isBorder = true;
			if (edge->isFixed) {
				continue;  // a segment
			}
			edge->isFixed = true;
			const bool quiet =
			    arrangement_.mesh.isQuiet(side[j]) && arrangement_.mesh.isQuiet(side[j + 1]);
			if (arrangement_.isOnOther(side[j]) && arrangement_.isOnOther(side[j + 1]) && !quiet) {
				const std::size_t fromLow = reversed ? side.size() - 2 - j : j;
				edge->interval = {vertexCount + cutEdge->firstInterval +
				                  static_cast<std::uint32_t>(fromLow)};
			}
		}
	}
	return true;
}

// What the triangulation must contain: the fixed edges, which are the only ones so far, and the
// diagonals.
void FaceCutter::collectPlanarEdges(const FaceLines& lines) {
	planarEdges_.clear();
	for (const LocalEdge& edge : edges_.all()) {
		planarEdges_.push_back(edge.ranks);
	}
	for (const FaceDiagonal* d = lines.diagonals; d != lines.diagonalsEnd; ++d) {
		const auto [left, right] = std::minmax({rankOf(d->begin), rankOf(d->end)});
		planarEdges_.push_back({left, right});
	}
}

std::uint32_t findRoot(std::vector<std::uint32_t>& parent, std::uint32_t i) {
	while (parent[i] != i) {
		parent[i] = parent[parent[i]];
		i = parent[i];
	}
	return i;
}

// Finds the pieces beside each edge. False if two pieces lie on one side of an edge, or if there
// are more edges than there can be.
bool FaceCutter::findPieces() {
	for (std::uint32_t piece = 0; piece < triangles_.size(); ++piece) {
		for (int i = 0; i < 3; ++i) {
			const std::uint32_t from = triangles_[piece][static_cast<std::size_t>(i)];
			const std::uint32_t to = triangles_[piece][static_cast<std::size_t>(nextCorner(i))];
			LocalEdge* edge = edges_.named(from, to);
			std::uint32_t* beside = edge != nullptr ? &edge->pieces[from < to ? 1 : 0] : nullptr;
			if (beside == nullptr || *beside != kNone) {
				return false;
			}
			*beside = piece;
		}
	}
	return true;
}

// Joins pieces across edges that are not fixed. False unless every border edge has one piece and
// every other edge two, one on each side. With all pieces turned alike this proves that they cover
// the face once.
bool FaceCutter::unitePieces() {
	regionOf_.resize(triangles_.size());
	std::iota(regionOf_.begin(), regionOf_.end(), 0u);
	for (const LocalEdge& edge : edges_.all()) {
		const int count = (edge.pieces[0] != kNone ? 1 : 0) + (edge.pieces[1] != kNone ? 1 : 0);
		if (count != (edge.isBorder ? 1 : 2)) {
			return false;
		}
		if (!edge.isFixed) {
			const std::uint32_t a = findRoot(regionOf_, edge.pieces[0]);
			const std::uint32_t b = findRoot(regionOf_, edge.pieces[1]);
			regionOf_[std::max(a, b)] = std::min(a, b);
		}
	}
	return true;
}

// A root is the first piece of its region, so one pass in order numbers them all.
void FaceCutter::numberRegions() {
	number_.resize(regionOf_.size());
	for (std::uint32_t piece = 0; piece < regionOf_.size(); ++piece) {
		const std::uint32_t root = findRoot(regionOf_, piece);
		number_[piece] = root == piece ? out_.regionCount++ : number_[root];
	}
	regionOf_.swap(number_);
}

// Records what lies to both sides of the segments and behind the border's intervals.
void FaceCutter::recordSides() {
	const auto regionBeside = [this](const LocalEdge& edge, bool leftOfRising) {
		const std::uint32_t piece = edge.pieces[leftOfRising ? 1 : 0];
		return piece != kNone ? regionOf_[piece] : kNone;
	};
	for (std::size_t i = 0; i < fixedCount_; ++i) {
		const LocalEdge& edge = edges_.all()[i];
		if (edge.segment != SegmentId::none()) {
			out_.sides.push_back({edge.segment, face_, regionBeside(edge, edge.rising),
			                      regionBeside(edge, !edge.rising)});
		} else if (edge.interval != NodeId::none()) {
			out_.links.push_back({regionBeside(edge, edge.pieces[1] != kNone), edge.interval});
		}
	}
}

void FaceCutter::emit() {
	out_.cutFaces.push_back({face_, static_cast<std::uint32_t>(out_.pieces.size())});
	for (std::size_t piece = 0; piece < triangles_.size(); ++piece) {
		Triangle t{};
		for (std::size_t i = 0; i < 3; ++i) {
			const LocalVertex& v = vertices_[order_[triangles_[piece][i]]];
			t[i] = v.id;
			if (v.isCorner()) {
				auto& links = arrangement_.isOnOther(v.id) ? out_.cornerLinks : out_.links;
				links.push_back({regionOf_[piece], {v.id.value}});
			}
		}
		out_.pieces.push_back(t);
		out_.pieceRegion.push_back(regionOf_[piece]);
	}
}

bool FaceCutter::cut(const FaceLines& lines) {
	face_ = lines.face;
	corners_ = &at(arrangement_.mesh.triangles, face_);
	axis_ = projectionAxis(*corners_, arrangement_.mesh.points, sign_);
	if (axis_ < 0) {
		return false;  // no area: nothing can cross it
	}
	collectBorder();
	const std::size_t borderCount = vertices_.size();
	collectInner(lines);
	if (isStopped() || !sortVertices() || isStopped()) {
		return false;
	}
	if (2 * vertices_.size() < borderCount + 3) {
		return false;  // a corner or a point on an edge is named twice
	}
	// Euler: a polygon with b border points and n points in all has 2n - b - 2 triangles and
	// 3n - b - 3 edges.
	const std::size_t triangleCount = 2 * vertices_.size() - borderCount - 2;
	edges_.reset(triangleCount + vertices_.size() - 1);
	if (!fixSegments(lines) || !fixBorder()) {
		return false;
	}
	fixedCount_ = edges_.all().size();
	collectPlanarEdges(lines);
	const FaceOrientation orientation(points_, order_);
	const auto pointCount = static_cast<std::uint32_t>(vertices_.size());
	if (!sweep_.triangulate(pointCount, planarEdges_, orientation, monitor_, triangles_)) {
		return false;
	}
	if (triangles_.size() != triangleCount) {
		return false;
	}
	if (sign_ < 0) {
		for (auto& t : triangles_) {
			std::swap(t[1], t[2]);
		}
	}
	if (isStopped() || !findPieces() || !unitePieces()) {
		return false;
	}
	numberRegions();
	recordSides();
	emit();
	return true;
}

// The lines of each of the touched faces, which are sorted as the lines are.
FaceLines linesOf(const Curve& curve, FaceId face) {
	const auto range = [face](const auto& lines) {
		using Line = typename std::decay_t<decltype(lines)>::value_type;
		const auto begin =
		    std::lower_bound(lines.begin(), lines.end(), face,
		                     [](const Line& line, FaceId f) { return line.face < f; });
		auto end = begin;
		while (end != lines.end() && end->face == face) {
			++end;
		}
		const Line* data = lines.data();
		return std::make_pair(data + (begin - lines.begin()), data + (end - lines.begin()));
	};
	const auto segments = range(curve.faceSegments);
	const auto diagonals = range(curve.faceDiagonals);
	return {face, segments.first, segments.second, diagonals.first, diagonals.second};
}

// Where the parts of a chunk begin in the whole.
struct ChunkBegin {
	std::size_t cutFaces = 0, pieces = 0, sides = 0, links = 0, cornerLinks = 0;
	std::uint32_t node = 0;  // of its first region

	ChunkBegin next(const ChunkPieces& chunk) const {
		return {cutFaces + chunk.cutFaces.size(),
		        pieces + chunk.pieces.size(),
		        sides + chunk.sides.size(),
		        links + chunk.links.size(),
		        cornerLinks + chunk.cornerLinks.size(),
		        node + chunk.regionCount};
	}
};

// Writes one chunk to its place.
void place(const ChunkPieces& chunk, const ChunkBegin& begin, Refinement& out) {
	const auto node = [&begin](std::uint32_t region) {
		return region == kNone ? NodeId::none() : NodeId{region + begin.node};
	};
	const auto transform = [](const auto& from, auto& to, std::size_t first, auto&& change) {
		for (std::size_t i = 0; i < from.size(); ++i) {
			to[first + i] = change(from[i]);
		}
	};
	transform(chunk.cutFaces, out.cutFaces, begin.cutFaces, [&](const CutFace& f) {
		at(out.isCut, f.face) = 1;
		return CutFace{f.face, f.firstPiece + static_cast<std::uint32_t>(begin.pieces)};
	});
	transform(chunk.pieces, out.pieces, begin.pieces, [](const Triangle& t) { return t; });
	transform(chunk.pieceRegion, out.pieceRegion, begin.pieces, node);
	transform(chunk.sides, out.sides, begin.sides, [&](const FaceSides& s) {
		return SegmentSide{s.segment, s.face, node(s.left), node(s.right)};
	});
	const auto link = [&](const RegionLink& l) {
		return std::array<NodeId, 2>{node(l.region), l.other};
	};
	transform(chunk.links, out.links, begin.links, link);
	transform(chunk.cornerLinks, out.cornerLinks, begin.cornerLinks, link);
}

// Puts the chunks one after another.
Status concatenate(const std::vector<ChunkPieces>& chunks, const Arrangement& arrangement,
                   Monitor& monitor, Refinement& out) {
	std::vector<ChunkBegin> begins(1);
	begins.front().node = static_cast<std::uint32_t>(arrangement.mesh.points.size() +
	                                                 arrangement.curve.intervalCount());
	for (const ChunkPieces& chunk : chunks) {
		begins.push_back(begins.back().next(chunk));
	}
	const ChunkBegin& all = begins.back();
	out.nodeCount = all.node;
	out.isCut.assign(arrangement.mesh.triangles.size(), 0);
	out.cutFaces.resize(all.cutFaces);
	out.pieces.resize(all.pieces);
	out.pieceRegion.resize(all.pieces);
	out.sides.resize(all.sides);
	out.links.resize(all.links);
	out.cornerLinks.resize(all.cornerLinks);
	const int threads = arrangement.options.threads;
	Status status =
	    parallelFor(chunks.size(), 8, threads, monitor, [&](std::size_t begin, std::size_t end) {
		    for (std::size_t i = begin; i < end; ++i) {
			    place(chunks[i], begins[i], out);
		    }
	    });
	if (!status.ok()) {
		return status;
	}
	return bucketSort(
	    out.sides, arrangement.curve.segments.size(),
	    [](const SegmentSide& s) { return s.segment.value; },
	    [](const SegmentSide& a, const SegmentSide& b) {
		    return a.segment != b.segment ? a.segment < b.segment : a.face < b.face;
	    },
	    threads, monitor);
}

// The other operand's faces with segments on a face that could not be cut.
Status refuseFace(const Arrangement& arrangement, FaceId face) {
	const Curve& curve = arrangement.curve;
	const MeshArrays& mesh = arrangement.mesh;
	const OperandId operand = otherOf(mesh.operandOf(face));
	std::vector<FaceId> faces;
	std::vector<std::uint8_t> onFace(curve.segments.size());
	const FaceLines lines = linesOf(curve, face);
	for (const FaceSegment* s = lines.segments; s != lines.segmentsEnd; ++s) {
		at(onFace, s->segment) = 1;
	}
	for (const FaceSegment& s : curve.faceSegments) {
		if (at(onFace, s.segment) != 0 && mesh.operandOf(s.face) == operand) {
			faces.push_back(s.face);
		}
	}
	return selfIntersecting(arrangement, operand, faces,
	                        at(mesh.points, at(mesh.triangles, face)[0]));
}

}  // namespace

Status retriangulate(Arrangement& arrangement, Monitor& monitor) {
	constexpr std::size_t kGrain = 48;  // faces; less than what waking a thread costs
	const std::vector<FaceId>& faces = arrangement.curve.touchedFaces;
	const CutEdgeFinder cutEdges(arrangement.curve.cutEdges, arrangement.mesh.points.size());
	std::vector<ChunkPieces> chunks(chunkCount(faces.size(), kGrain));
	const Status status = parallelForChunks(
	    faces.size(), kGrain, arrangement.options.threads, monitor,
	    [&](std::size_t chunk, std::size_t begin, std::size_t end) {
		    FaceCutter cutter(arrangement, cutEdges, monitor, chunks[chunk]);
		    for (std::size_t i = begin; i < end && chunks[chunk].failed == FaceId::none(); ++i) {
			    if (!cutter.cut(linesOf(arrangement.curve, faces[i]))) {
				    chunks[chunk].failed = faces[i];
			    }
		    }
	    });
	if (!status.ok()) {
		return status;
	}
	for (const ChunkPieces& chunk : chunks) {
		if (chunk.failed != FaceId::none()) {
			return refuseFace(arrangement, chunk.failed);
		}
	}
	return concatenate(chunks, arrangement, monitor, arrangement.refinement);
}

}  // namespace index_boolean
