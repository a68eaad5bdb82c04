// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The surface at a suspect vertex is taken apart into umbrellas: its faces there, joined across
// their edges two and two. Each umbrella gets a copy of the vertex.
//
//     a        b     Four faces at an edge, seen along it; 1 and 2 are solid. Across the solid they
//       .  1 .       are paired a b, c d: two wedges that touch. Across the void they are paired
//         . .        b c, d a: one solid around two voids that touch. Pairs are matched as brackets
//          .         are, so they never cross.
//         . .
//       .  2 .       Two pairs come apart iff their umbrellas differ at one end of the edge at
//     d        c     least: that end has two copies then, and the edge is two edges.
//
// Why the solid stays: a copy is where the vertex was, so no triangle moves. Why closed stays
// closed: each face is paired, at each of its edges with a suspect end, with one that runs along
// that edge the other way, and both get the same copies of its ends.
// Why a manifold comes out, once no two pairs at an edge have both ends in common: each edge then
// has the two faces of one pair, and the faces at each copy of a suspect vertex are one umbrella;
// a vertex that is not suspect had one before.
// Why pairs come apart, where the order of faces around edges is that of a solid: cut off a small
// ball around a vertex. On its sphere, the solid and the void are regions, each edge is a point,
// and an umbrella is a closed line between them. If two pairs across the solid at one edge have a
// line in common, it borders one region of the solid and passes the point twice; then a closed
// curve within that region and through the point parts the voids to both sides of it, and pairs
// across the void are on different lines. Where a fan has more pairs, or several fans change, that
// parts some of them; the rest are looked at again.
#include "vcg_ext/solids/manifold_copies.h"

#include "vcg_ext/arrange/radial_order.h"
#include "vcg_ext/base/bucket_sort.h"
#include "vcg_ext/base/edge_table.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/base/union_find.h"
#include "vcg_ext/exact/exact_sign.h"
#include "vcg_ext/exact/nearest_float.h"
#include "vcg_ext/exact/zero_area.h"

#include <algorithm>
#include <functional>
#include <iterator>

namespace index_boolean {

namespace {

std::size_t next(std::size_t corner) { return corner == 2 ? 0 : corner + 1; }

// The corners of a half-edge's face at the ends of the edge.
std::size_t cornerAtLow(const HalfEdge& h) { return h.forward ? h.corner : next(h.corner); }
std::size_t cornerAtHigh(const HalfEdge& h) { return h.forward ? next(h.corner) : h.corner; }

// Two half-edges, by their indices, that are one edge of the manifold.
struct Pair {
	std::uint32_t first, second;
};

// An edge with more than two faces: its half-edges in their order around it, and their pairs.
struct Fan {
	std::vector<std::uint32_t> around;
	std::vector<Pair> pairs;
	bool acrossVoid = false;
};

// A face at an edge from one vertex of a block to another: it runs along the edge, or against it.
struct FanFace {
	std::uint32_t face, apex;
	bool forward;
};

// Sorts the faces at the edge from `low` to `high` around it; false if that cannot be.
using SortFan =
    std::function<bool(std::uint32_t low, std::uint32_t high, const std::vector<FanFace>& faces,
                       std::vector<RadialPlace>& places)>;

class Separator {
public:
	Separator(Block& block, SortFan sortFan, Monitor& monitor)
	    : block_(block), sortFan_(std::move(sortFan)), monitor_(monitor), corners_(0) {}

	Status run(std::size_t firstFace);

	// Whether two pairs of faces at one edge still have both ends in common.
	bool anyInCommon() {
		return std::any_of(fans_.begin(), fans_.end(),
		                   [this](const Fan& fan) { return !pairsInCommon(fan).empty(); });
	}

	// Puts a midpoint into each pair of faces at the fans that could not be pulled apart.
	void insertMidpoints(OutputScalar scalar);

private:
	struct Half;
	using Ends = std::pair<std::uint32_t, std::uint32_t>;
	void reserveHalfEdges(std::size_t firstFace);
	void collectHalfEdges(std::size_t firstFace);
	Status sortHalfEdges();
	void findPairs();
	void addFan(std::uint32_t begin, std::uint32_t end);
	void pairUp(Fan& fan) const;
	void uniteUmbrellas();
	void pairAcrossVoid();
	void unite(const Pair& pair);
	Ends endsOf(const Pair& pair) const;
	std::vector<Pair> pairsInCommon(const Fan& fan);
	void copyVertices();
	void addMidpoints(const std::vector<Pair>& pairs, OutputScalar scalar,
	                  std::vector<Half>& halves);
	bool splitFaces(std::vector<Half>& halves);

	bool isSuspect(std::uint32_t v) const { return block_.suspect[v] != 0; }
	std::uint32_t cornerAt(std::uint32_t halfEdge, bool low) const {
		const HalfEdge& h = halfEdges_[halfEdge];
		const std::size_t corner = low ? cornerAtLow(h) : cornerAtHigh(h);
		return 3 * h.face + static_cast<std::uint32_t>(corner);
	}

	Block& block_;
	SortFan sortFan_;
	Monitor& monitor_;
	std::vector<std::uint32_t> faces_;  // of the block, at suspect vertices
	std::vector<HalfEdge> halfEdges_;   // of these, listed locally, with a suspect end; by edge
	std::vector<Pair> simplePairs_;     // at edges with two faces
	std::vector<Fan> fans_;
	UnionFind corners_;       // of the listed faces, three each; sets: umbrellas
	std::vector<Ends> ends_;  // of a fan's pairs, while they are compared
};

// One of the two faces at a split edge: its edge from the given corner on gets a midpoint.
struct Separator::Half {
	std::uint32_t face;  // of the block
	std::uint8_t corner;
	std::uint32_t midpoint;
};

// Around an edge with many faces, arrays that grow cost more than counting first.
void Separator::reserveHalfEdges(std::size_t firstFace) {
	std::size_t faces = 0, halfEdges = 0;
	for (std::size_t f = firstFace; f < block_.triangles.size(); ++f) {
		const auto& t = block_.triangles[f];
		const std::size_t suspect =
		    (isSuspect(t[0]) ? 1U : 0U) + (isSuspect(t[1]) ? 1U : 0U) + (isSuspect(t[2]) ? 1U : 0U);
		faces += suspect > 0 ? 1 : 0;
		halfEdges += suspect == 1 ? 2 : (suspect > 1 ? 3 : 0);
	}
	faces_.reserve(faces);
	halfEdges_.reserve(halfEdges);
	simplePairs_.reserve(halfEdges / 2);
}

void Separator::collectHalfEdges(std::size_t firstFace) {
	reserveHalfEdges(firstFace);
	for (std::size_t f = firstFace; f < block_.triangles.size(); ++f) {
		const auto& t = block_.triangles[f];
		if (!isSuspect(t[0]) && !isSuspect(t[1]) && !isSuspect(t[2])) {
			continue;
		}
		const auto face = static_cast<std::uint32_t>(faces_.size());
		faces_.push_back(static_cast<std::uint32_t>(f));
		for (std::size_t i = 0; i < 3; ++i) {
			const std::uint32_t from = t[i], to = t[next(i)];
			if (isSuspect(from) || isSuspect(to)) {
				halfEdges_.push_back(makeHalfEdge(from, to, face, i));
			}
		}
	}
}

// By their higher vertex first: a vertex that many edges share is old, and so the lower one of most
// of them, while each higher one has few.
Status Separator::sortHalfEdges() {
	return bucketSort(
	    halfEdges_, block_.points.size(), [](const HalfEdge& h) { return h.high; },
	    [](const HalfEdge& a, const HalfEdge& b) {
		    return a.high != b.high ? a.high < b.high
		           : a.low != b.low ? a.low < b.low
		                            : a.face < b.face;
	    },
	    1, monitor_);
}

// \pre the half-edges are sorted
void Separator::findPairs() {
	forEachSortedEdge(halfEdges_.begin(), halfEdges_.end(), [this](auto first, auto last) {
		const auto begin = static_cast<std::uint32_t>(first - halfEdges_.begin());
		const auto end = static_cast<std::uint32_t>(last - halfEdges_.begin());
		if (end - begin == 2) {
			simplePairs_.push_back({begin, begin + 1});
		} else {
			addFan(begin, end);
		}
	});
}

void Separator::addFan(std::uint32_t begin, std::uint32_t end) {
	Fan fan;
	std::vector<FanFace> faces;
	faces.reserve(end - begin);
	fan.around.reserve(end - begin);
	for (std::uint32_t h = begin; h < end; ++h) {
		const std::uint32_t face = faces_[halfEdges_[h].face];
		const std::size_t apex = next(next(halfEdges_[h].corner));
		faces.push_back({face, block_.triangles[face][apex], halfEdges_[h].forward});
	}
	std::vector<RadialPlace> places;
	if (sortFan_(halfEdges_[begin].low, halfEdges_[begin].high, faces, places)) {
		// In one place, the face that ends a solid comes before one that begins another. What then
		// is alike only rounding has brought together: the order is that of coordinates, seen along
		// the edge from its smaller end.
		const Points& points = block_.points;
		const HalfEdge& edge = halfEdges_[begin];
		const bool againstEdge = points[edge.high] < points[edge.low];
		const auto before = [&](RadialPlace a, RadialPlace b) {
			const FanFace &f = faces[a.index], &g = faces[b.index];
			if (a.slot != b.slot || f.forward != g.forward) {
				return a.slot != b.slot ? a.slot < b.slot : f.forward;
			}
			return againstEdge ? points[g.apex] < points[f.apex] : points[f.apex] < points[g.apex];
		};
		std::stable_sort(places.begin(), places.end(), before);
		for (const RadialPlace place : places) {
			fan.around.push_back(begin + place.index);
		}
	} else {
		for (std::uint32_t h = begin; h < end; ++h) {
			fan.around.push_back(h);
		}
	}
	pairUp(fan);
	fans_.push_back(std::move(fan));
}

// Going round counter-clockwise, a reverse face enters a solid and a forward face leaves it. Pairs
// are matched as brackets are, from where the fewest are open.
void Separator::pairUp(Fan& fan) const {
	const std::size_t n = fan.around.size();
	const auto opens = [&](std::size_t i) {
		return halfEdges_[fan.around[i % n]].forward == fan.acrossVoid;
	};
	std::size_t start = 0;
	int depth = 0, least = 0;
	for (std::size_t i = 0; i < n; ++i) {
		depth += opens(i) ? 1 : -1;
		if (depth < least) {
			least = depth;
			start = i + 1;
		}
	}
	fan.pairs.clear();
	fan.pairs.reserve(n / 2);
	std::vector<std::uint32_t> open;
	for (std::size_t i = start; i < start + n; ++i) {
		if (opens(i)) {
			open.push_back(fan.around[i % n]);
		} else if (!open.empty()) {
			fan.pairs.push_back({open.back(), fan.around[i % n]});
			open.pop_back();
		}
	}
}

void Separator::unite(const Pair& pair) {
	for (const bool low : {true, false}) {
		corners_.unite(cornerAt(pair.first, low), cornerAt(pair.second, low));
	}
}

void Separator::uniteUmbrellas() {
	corners_ = UnionFind(3 * faces_.size());
	for (const Pair& pair : simplePairs_) {
		unite(pair);
	}
	for (const Fan& fan : fans_) {
		for (const Pair& pair : fan.pairs) {
			unite(pair);
		}
	}
	corners_.flatten();
}

// What tells a pair of faces from others at the same edge: its umbrellas at both ends. A vertex
// that is not suspect gets no copies.
Separator::Ends Separator::endsOf(const Pair& pair) const {
	const HalfEdge& edge = halfEdges_[pair.first];
	const std::uint32_t low = isSuspect(edge.low) ? corners_.root(cornerAt(pair.first, true)) : 0;
	const std::uint32_t high =
	    isSuspect(edge.high) ? corners_.root(cornerAt(pair.first, false)) : 0;
	return {low, high};
}

// The pairs of a fan that have both ends in common with another one.
std::vector<Pair> Separator::pairsInCommon(const Fan& fan) {
	ends_.clear();
	for (const Pair& pair : fan.pairs) {
		ends_.push_back(endsOf(pair));
	}
	std::sort(ends_.begin(), ends_.end());
	std::vector<Pair> pairs;
	if (std::adjacent_find(ends_.begin(), ends_.end()) == ends_.end()) {
		return pairs;
	}
	std::copy_if(fan.pairs.begin(), fan.pairs.end(), std::back_inserter(pairs),
	             [this](const Pair& pair) {
		             const auto alike = std::equal_range(ends_.begin(), ends_.end(), endsOf(pair));
		             return alike.second - alike.first > 1;
	             });
	return pairs;
}

// One umbrella keeps the vertex, each other one gets a copy.
void Separator::copyVertices() {
	std::vector<std::uint32_t> keeper(block_.points.size(), kNone);
	std::vector<std::uint32_t> vertexOf(3 * faces_.size(), kNone);  // per umbrella
	for (std::uint32_t corner = 0; corner < 3 * faces_.size(); ++corner) {
		std::uint32_t& vertex = block_.triangles[faces_[corner / 3]][corner % 3];
		if (!isSuspect(vertex)) {
			continue;
		}
		const std::uint32_t umbrella = corners_.root(corner);
		std::uint32_t& own = vertexOf[umbrella];
		if (own == kNone && keeper[vertex] == kNone) {
			own = keeper[vertex] = vertex;
		} else if (own == kNone) {
			own = static_cast<std::uint32_t>(block_.points.size());
			block_.points.push_back(Point(block_.points[vertex]));
			block_.vertexSource.push_back(VertexId(block_.vertexSource[vertex]));
			block_.suspect.push_back(1);
			keeper.push_back(own);
			++block_.verticesCopied;
		}
		vertex = own;
	}
}

// Fans whose pairs across the solid do not come apart are paired across the void.
void Separator::pairAcrossVoid() {
	bool changed = false;
	for (Fan& fan : fans_) {
		if (!pairsInCommon(fan).empty()) {
			fan.acrossVoid = changed = true;
			pairUp(fan);
		}
	}
	if (changed) {
		uniteUmbrellas();
	}
}

Status Separator::run(std::size_t firstFace) {
	const auto poll = [this] {
		return statusOf(pollCancelled(monitor_) ? StatusCode::Cancelled : StatusCode::Ok);
	};
	collectHalfEdges(firstFace);
	Status status = sortHalfEdges();
	if (status.ok()) {
		findPairs();
		uniteUmbrellas();
		pairAcrossVoid();
		status = poll();
	}
	if (status.ok()) {
		copyVertices();
	}
	return status;
}

// The point half-way between two, as the output scalar has it.
Point middle(const Point& a, const Point& b, OutputScalar scalar) {
	Point m;
	for (std::size_t k = 0; k < 3; ++k) {
		m[k] = a[k] / 2 + b[k] / 2;
		if (scalar == OutputScalar::Float) {
			m[k] = nearestFloat(m[k]);
		}
	}
	return m;
}

// A midpoint for each of the pairs at one edge, for the two faces of the pair. None if the edge is
// too short for one.
void Separator::addMidpoints(const std::vector<Pair>& pairs, OutputScalar scalar,
                             std::vector<Half>& halves) {
	const auto point = [&](const HalfEdge& h, std::size_t corner) -> const Point& {
		return block_.points[block_.triangles[faces_[h.face]][corner]];
	};
	const HalfEdge& edge = halfEdges_[pairs[0].first];
	const Point a = point(edge, cornerAtLow(edge)), b = point(edge, cornerAtHigh(edge));
	const Point m = middle(a, b, scalar);
	const auto isTooShort = [&](std::uint32_t h) {
		const Point& apex = point(halfEdges_[h], next(next(halfEdges_[h].corner)));
		return hasZeroArea(a, m, apex) || hasZeroArea(m, b, apex);
	};
	if (std::any_of(pairs.begin(), pairs.end(), [&](const Pair& pair) {
		    return isTooShort(pair.first) || isTooShort(pair.second);
	    })) {
		return;
	}
	for (const Pair& pair : pairs) {
		const auto vertex = static_cast<std::uint32_t>(block_.points.size());
		block_.points.push_back(m);
		block_.vertexSource.push_back(VertexId::none());
		block_.suspect.push_back(0);
		for (const std::uint32_t h : {pair.first, pair.second}) {
			halves.push_back({faces_[halfEdges_[h].face], halfEdges_[h].corner, vertex});
		}
	}
}

// The pieces of a triangle whose edge i, from corner i to the next, is cut at middles[i], or not if
// that is kNone.
IndexTriangles cutTriangle(const IndexTriangle& t, const IndexTriangle& middles,
                           const Points& points) {
	const auto cuts = 3 - std::count(middles.begin(), middles.end(), kNone);
	if (cuts == 3) {
		return {{t[0], middles[0], middles[2]},
		        {t[1], middles[1], middles[0]},
		        {t[2], middles[2], middles[1]},
		        {middles[0], middles[1], middles[2]}};
	}
	std::size_t i = 0;  // cut, but not the one before; or cut alone
	while (middles[i] == kNone || (cuts == 2 && middles[next(i)] == kNone)) {
		++i;
	}
	const std::uint32_t x = t[next(i)], y = t[next(next(i))], z = t[i];
	const std::uint32_t m = middles[i];
	if (cuts == 1) {
		return {{z, m, y}, {m, x, y}};
	}
	const std::uint32_t other = middles[next(i)];  // between x and y
	if (points[y] < points[z]) {                   // the diagonal from the smaller corner
		return {{m, x, other}, {m, other, y}, {z, m, y}};
	}
	return {{m, x, other}, {z, m, other}, {z, other, y}};
}

// Splits faces at the midpoints on their edges. False, and nothing changed, if a piece would have
// no area.
bool Separator::splitFaces(std::vector<Half>& halves) {
	std::sort(halves.begin(), halves.end(),
	          [](const Half& a, const Half& b) { return a.face < b.face; });
	IndexTriangles pieces;
	std::vector<std::uint32_t> parents;
	const auto sameFace = [](const Half& a, const Half& b) { return a.face == b.face; };
	forEachGroup(halves.begin(), halves.end(), sameFace, [&](auto first, auto last) {
		const std::uint32_t face = first->face;
		IndexTriangle middles{kNone, kNone, kNone};
		for (auto half = first; half != last; ++half) {
			middles[half->corner] = half->midpoint;
		}
		for (const IndexTriangle& piece :
		     cutTriangle(block_.triangles[face], middles, block_.points)) {
			pieces.push_back(piece);
			parents.push_back(face);
		}
	});
	const auto& points = block_.points;
	if (std::any_of(pieces.begin(), pieces.end(), [&](const IndexTriangle& t) {
		    return hasZeroArea(points[t[0]], points[t[1]], points[t[2]]);
	    })) {
		return false;
	}
	for (std::size_t i = 0; i < pieces.size(); ++i) {
		if (i == 0 || parents[i] != parents[i - 1]) {
			block_.triangles[parents[i]] = pieces[i];
		} else {
			block_.triangles.push_back(pieces[i]);
			block_.faceSource.push_back(FaceSource(block_.faceSource[parents[i]]));
		}
	}
	return true;
}

void Separator::insertMidpoints(OutputScalar scalar) {
	const std::size_t pointCount = block_.points.size();
	std::vector<Half> halves;
	const auto edgeOf = [this](const Fan& fan) {
		const HalfEdge& h = halfEdges_[fan.around[0]];
		return std::array{h.low, h.high};
	};
	std::sort(fans_.begin(), fans_.end(),
	          [&](const Fan& a, const Fan& b) { return edgeOf(a) < edgeOf(b); });
	for (const Fan& fan : fans_) {
		const std::vector<Pair> pairs = pairsInCommon(fan);
		if (!pairs.empty()) {
			addMidpoints(pairs, scalar, halves);
		}
	}
	if (splitFaces(halves)) {
		block_.verticesCopied += block_.points.size() - pointCount;
		return;
	}
	block_.points.resize(pointCount);
	block_.vertexSource.resize(pointCount);
	block_.suspect.resize(pointCount);
}

// One round separates the sheets at an edge into two groups at least, unless the order of faces
// around edges contradicts itself: rounds are repeated while they help.
template <class Finish>
Status separate(Block& block, std::size_t firstFace, const SortFan& sortFan, Monitor& monitor,
                Finish&& finish) {
	while (true) {
		const std::size_t copied = block.verticesCopied;
		Separator separator(block, sortFan, monitor);
		const Status status = separator.run(firstFace);
		if (!status.ok() || !separator.anyInCommon()) {
			return status;
		}
		if (block.verticesCopied == copied) {
			finish(separator);
			return status;
		}
	}
}

}  // namespace

Status copyNonManifold(const Arrangement& arrangement, Monitor& monitor, Block& block) {
	if (!block.anySuspect()) {
		return {};
	}
	const auto sortFan = [&](std::uint32_t low, std::uint32_t high,
	                         const std::vector<FanFace>& faces, std::vector<RadialPlace>& places) {
		std::vector<HalfPlane> halfPlanes;
		halfPlanes.reserve(faces.size());
		for (const FanFace& f : faces) {
			const FaceSource& source = block.faceSource[f.face];
			halfPlanes.push_back({source.face, f.forward != source.turned});
		}
		return sortAround(arrangement, block.vertexSource[low], block.vertexSource[high],
		                  halfPlanes, places);
	};
	bool isApart = true;
	const Status status = separate(block, block.anySuspectOffCurve ? 0 : block.firstPiece, sortFan,
	                               monitor, [&isApart](Separator&) { isApart = false; });
	block.isApart = status.ok() && isApart;
	return status;
}

Status copyNonManifoldAsStored(OutputScalar scalar, Monitor& monitor, Block& block) {
	if (!block.anySuspect()) {
		return {};
	}
	const auto sortFan = [&](std::uint32_t low, std::uint32_t high,
	                         const std::vector<FanFace>& faces, std::vector<RadialPlace>& places) {
		const Point &a = block.points[low], &b = block.points[high];
		const auto apex = [&](std::uint32_t i) -> const Point& {
			return block.points[faces[i].apex];
		};
		const auto turn = [&](std::uint32_t i, std::uint32_t j) {
			return orient3d(a, b, apex(i), apex(j));
		};
		// In one plane with the first: seen along an axis in which that has area.
		const auto sameSide = [&](std::uint32_t i) {
			int axis = 0, first = 0;
			while ((first = orient2d(a, b, apex(0), axis)) == 0) {
				++axis;
			}
			return orient2d(a, b, apex(i), axis) == first;
		};
		const AngleHint hint(a, b);
		const auto angle = [&](std::uint32_t i) { return hint(apex(i)); };
		sortRadially(faces.size(), turn, sameSide, angle, places);
		return true;
	};
	return separate(block, 0, sortFan, monitor,
	                [scalar](Separator& separator) { separator.insertMidpoints(scalar); });
}

}  // namespace index_boolean
