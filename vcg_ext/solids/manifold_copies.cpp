// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The faces at a suspect vertex that are paired across their edges form umbrellas; each umbrella
// gets a copy of the vertex. So two pairs of faces at one edge come apart iff their umbrellas
// differ at one end of it at least.
#include "vcg_ext/solids/manifold_copies.h"

#include "vcg_ext/arrange/radial_order.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/base/union_find.h"
#include "vcg_ext/exact/exact_sign.h"
#include "vcg_ext/exact/zero_area.h"

#include <algorithm>
#include <functional>

namespace index_boolean {

namespace {

constexpr std::uint32_t kNone = 0xffffffffu;

std::size_t next(std::size_t corner) { return corner == 2 ? 0 : corner + 1; }

// A face's edge between the vertices low < high. The face is listed locally; the edge leaves its
// given corner. `forward`: it runs from low to high.
struct HalfEdge {
	std::uint32_t low, high;
	std::uint32_t face;
	std::uint8_t corner;
	bool forward;

	bool sameEdge(const HalfEdge& other) const { return low == other.low && high == other.high; }
	std::size_t cornerAtLow() const { return forward ? corner : next(corner); }
	std::size_t cornerAtHigh() const { return forward ? next(corner) : corner; }
};

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
	bool anyInCommon() const {
		return std::any_of(fans_.begin(), fans_.end(),
		                   [this](const Fan& fan) { return !pairsInCommon(fan).empty(); });
	}

	// Puts a midpoint into each pair of faces at the fans that could not be pulled apart.
	void insertMidpoints(OutputScalar scalar);

private:
	struct Split;
	void collectHalfEdges(std::size_t firstFace);
	void findPairs();
	void addFan(std::size_t begin, std::size_t end);
	void pairUp(Fan& fan) const;
	void uniteUmbrellas();
	void unite(const Pair& pair);
	using Ends = std::pair<std::uint32_t, std::uint32_t>;
	Ends endsOf(const Pair& pair) const;
	std::vector<Pair> pairsInCommon(const Fan& fan) const;
	void copyVertices();
	void addMidpoints(const std::vector<Pair>& pairs, OutputScalar scalar,
	                  std::vector<Split>& splits);
	bool splitFaces(std::vector<Split>& splits);

	bool isSuspect(std::uint32_t v) const { return block_.suspect[v] != 0; }
	std::uint32_t cornerAt(std::uint32_t halfEdge, bool low) const {
		const HalfEdge& h = halfEdges_[halfEdge];
		const std::size_t corner = low ? h.cornerAtLow() : h.cornerAtHigh();
		return 3 * h.face + static_cast<std::uint32_t>(corner);
	}

	Block& block_;
	SortFan sortFan_;
	Monitor& monitor_;
	std::vector<std::uint32_t> faces_;  // of the block, at suspect vertices
	std::vector<HalfEdge> halfEdges_;   // with a suspect end; sorted by edge
	std::vector<Pair> simplePairs_;     // at edges with two faces
	std::vector<Fan> fans_;
	UnionFind corners_;  // of the listed faces, three each; sets: umbrellas
};

// The part of a face at one side of a split edge.
struct Separator::Split {
	std::uint32_t face;  // of the block
	std::uint8_t corner;
	std::uint32_t midpoint;
};

void Separator::collectHalfEdges(std::size_t firstFace) {
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
				halfEdges_.push_back({std::min(from, to), std::max(from, to), face,
				                      static_cast<std::uint8_t>(i), from < to});
			}
		}
	}
	std::sort(halfEdges_.begin(), halfEdges_.end(), [](const HalfEdge& a, const HalfEdge& b) {
		return a.low != b.low     ? a.low < b.low
		       : a.high != b.high ? a.high < b.high
		                          : a.face < b.face;
	});
}

void Separator::findPairs() {
	for (std::size_t begin = 0; begin < halfEdges_.size();) {
		std::size_t end = begin + 1;
		while (end < halfEdges_.size() && halfEdges_[end].sameEdge(halfEdges_[begin])) {
			++end;
		}
		if (end - begin == 2) {
			simplePairs_.push_back(
			    {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(begin + 1)});
		} else {
			addFan(begin, end);
		}
		begin = end;
	}
}

void Separator::addFan(std::size_t begin, std::size_t end) {
	Fan fan;
	std::vector<FanFace> faces;
	for (std::size_t h = begin; h < end; ++h) {
		const std::uint32_t face = faces_[halfEdges_[h].face];
		const std::size_t apex = next(next(halfEdges_[h].corner));
		faces.push_back({face, block_.triangles[face][apex], halfEdges_[h].forward});
	}
	std::vector<RadialPlace> places;
	if (sortFan_(halfEdges_[begin].low, halfEdges_[begin].high, faces, places)) {
		// In one place, the face that ends a solid comes before one that begins another.
		const auto before = [&](RadialPlace a, RadialPlace b) {
			const bool aEnds = halfEdges_[begin + a.index].forward;
			const bool bEnds = halfEdges_[begin + b.index].forward;
			return a.slot != b.slot ? a.slot < b.slot : aEnds && !bEnds;
		};
		std::stable_sort(places.begin(), places.end(), before);
		for (const RadialPlace place : places) {
			fan.around.push_back(static_cast<std::uint32_t>(begin + place.index));
		}
	} else {
		for (std::size_t h = begin; h < end; ++h) {
			fan.around.push_back(static_cast<std::uint32_t>(h));
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
std::vector<Pair> Separator::pairsInCommon(const Fan& fan) const {
	std::vector<Pair> pairs;
	for (const Pair& pair : fan.pairs) {
		const auto sameEnds = [&](const Pair& p) { return endsOf(p) == endsOf(pair); };
		if (std::count_if(fan.pairs.begin(), fan.pairs.end(), sameEnds) > 1) {
			pairs.push_back(pair);
		}
	}
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

Status Separator::run(std::size_t firstFace) {
	collectHalfEdges(firstFace);
	Status status;
	if (pollCancelled(monitor_)) {
		status.code = StatusCode::Cancelled;
		return status;
	}
	findPairs();
	uniteUmbrellas();
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
	if (pollCancelled(monitor_)) {
		status.code = StatusCode::Cancelled;
		return status;
	}
	copyVertices();
	return status;
}

// The point half-way between two, as the output scalar has it.
Point middle(const Point& a, const Point& b, OutputScalar scalar) {
	Point m;
	for (std::size_t k = 0; k < 3; ++k) {
		m[k] = a[k] / 2 + b[k] / 2;
		if (scalar == OutputScalar::Float) {
			m[k] = static_cast<double>(static_cast<float>(m[k]));
		}
	}
	return m;
}

// A midpoint for each of the pairs at one edge, for the two faces of the pair. None if the edge is
// too short for one.
void Separator::addMidpoints(const std::vector<Pair>& pairs, OutputScalar scalar,
                             std::vector<Split>& splits) {
	const auto point = [&](const HalfEdge& h, std::size_t corner) -> const Point& {
		return block_.points[block_.triangles[faces_[h.face]][corner]];
	};
	const HalfEdge& edge = halfEdges_[pairs[0].first];
	const Point a = point(edge, edge.cornerAtLow()), b = point(edge, edge.cornerAtHigh());
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
			splits.push_back({faces_[halfEdges_[h].face], halfEdges_[h].corner, vertex});
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
bool Separator::splitFaces(std::vector<Split>& splits) {
	std::sort(splits.begin(), splits.end(),
	          [](const Split& a, const Split& b) { return a.face < b.face; });
	IndexTriangles pieces;
	std::vector<std::uint32_t> parents;
	for (std::size_t i = 0; i < splits.size();) {
		const std::uint32_t face = splits[i].face;
		IndexTriangle middles{kNone, kNone, kNone};
		for (; i < splits.size() && splits[i].face == face; ++i) {
			middles[splits[i].corner] = splits[i].midpoint;
		}
		for (const IndexTriangle& piece :
		     cutTriangle(block_.triangles[face], middles, block_.points)) {
			pieces.push_back(piece);
			parents.push_back(face);
		}
	}
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
	std::vector<Split> splits;
	for (const Fan& fan : fans_) {
		const std::vector<Pair> pairs = pairsInCommon(fan);
		if (!pairs.empty()) {
			addMidpoints(pairs, scalar, splits);
		}
	}
	if (splitFaces(splits)) {
		block_.verticesCopied += block_.points.size() - pointCount;
		return;
	}
	block_.points.resize(pointCount);
	block_.vertexSource.resize(pointCount);
	block_.suspect.resize(pointCount);
}

bool anySuspect(const Block& block) {
	return std::find(block.suspect.begin(), block.suspect.end(), 1) != block.suspect.end();
}

// One round separates the sheets at an edge into two groups at least, unless the order of faces
// around edges contradicts itself: rounds are repeated while they help. Why: around a vertex, the
// surface leaves closed lines on a small sphere. Where two solids at an edge have a line in common,
// they are one solid elsewhere, so that two of the voids between them are parted.
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
	if (!anySuspect(block)) {
		return {};
	}
	const auto sortFan = [&](std::uint32_t low, std::uint32_t high,
	                         const std::vector<FanFace>& faces, std::vector<RadialPlace>& places) {
		std::vector<HalfPlane> halfPlanes;
		for (const FanFace& f : faces) {
			const FaceSource& source = block.faceSource[f.face];
			halfPlanes.push_back({source.face, f.forward != source.turned});
		}
		return sortAround(arrangement, block.vertexSource[low], block.vertexSource[high],
		                  halfPlanes, places);
	};
	return separate(block, block.anySuspectOffCurve ? 0 : block.firstPiece, sortFan, monitor,
	                [](Separator&) {});
}

Status copyNonManifoldAsStored(OutputScalar scalar, Monitor& monitor, Block& block) {
	if (!anySuspect(block)) {
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
		sortRadially(faces.size(), turn, sameSide, places);
		return true;
	};
	return separate(block, 0, sortFan, monitor,
	                [scalar](Separator& separator) { separator.insertMidpoints(scalar); });
}

}  // namespace index_boolean
