// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One vertex after another goes, with the faces around it, which fall into runs: neighbours of one
// region. Between runs are border edges.
//
//      c ------- b        No border edge: one region all around. The polygon of the edges opposite
//      | \     / |        v is filled without it.
//      d -- v == x        Border edges, here from v to x and to y: v goes to the end u of one of
//      | //    \ |        them. The others become edges from u; each run leaves a polygon with u
//      y ------- a        for v. With two of them, u is x or y, and v must be beside the edge
//                         x y; with more, v must be near u.
//
// Why a run may be turned anyhow: slivers and steps between walls that nearly coincide are seen
// from their sides, and have no area or a wrong sign along the axis. Only the faces that fill a
// polygon must turn its way; where they all do, the polygon is seen to be simple.
//
// Why closed stays closed, and as it hangs together: it is the contraction of the edge v u and
// flips within regions. Sides are counted on each edge of the new faces: an edge opposite v has as
// many as before, a cut two and none elsewhere, an edge from u as many as that from v had. (A run
// that is one face with u in it vanishes; the face beyond takes its side.) No new face lies on the
// three corners of another.
//
// Why nothing drifts: regions, planes and corners are those of the surface as it was, and what has
// gone beside an edge is remembered with the edge that replaces it, and measured again whenever
// that one is replaced.
//
// Vertices are taken in the order of a hash of their places: like chance, which keeps polygons
// small, but the same in every numbering. Those whose faces have changed are asked again.
#include "vcg_ext/mesh/merge_regions.h"

#include "vcg_ext/base/parallel.h"
#include "vcg_ext/base/sorted_list.h"
#include "vcg_ext/base/vectors.h"
#include "vcg_ext/exact/coordinate_hash.h"
#include "vcg_ext/exact/polygon_fill.h"
#include "vcg_ext/mesh/region_flips.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace index_boolean {

namespace {

constexpr std::size_t kMostFacesAtVertex = 4096;  // of a vertex with more, none is asked

// The edge opposite a vertex in one of its faces.
struct Sector {
	std::uint32_t from, to;
	std::uint32_t face;  // of the work
};

// Neighbouring faces of one region at a vertex, by the corners opposite; of a cycle, which ends
// where it begins, each once.
struct Run {
	std::vector<std::uint32_t> corners;
	std::uint32_t region, origin;
	bool isCycle;
};

// What a vertex is replaced with.
struct Change {
	std::vector<RegionFace> faces;
	std::vector<std::array<std::uint32_t, 2>> vanished;  // edges on which a run has vanished
	std::uint32_t target = kNone;                        // what the vertex goes to, if to any
};

class RegionMerger {
public:
	RegionMerger(const ClassedSurface& surface, const PlaneRegions& regions,
	             const MergeLimits& limits, const KeptParts& kept, Monitor& monitor)
	    : surface_(surface), regions_(regions), limits_(limits), kept_(kept), monitor_(monitor) {}

	Status run(MergedFaces& out);

private:
	using Edge = std::array<std::uint32_t, 2>;
	static constexpr std::uint8_t kShort = 1,
	                              kOfSeveral = 2;  // of candidates, while they are listed

	std::uint32_t placeOf(std::uint32_t v) const { return surface_.place[v]; }
	const Point& at(std::uint32_t v) const { return surface_.points[v]; }
	static Edge edgeBetween(std::uint32_t a, std::uint32_t b) {
		return {std::min(a, b), std::max(a, b)};
	}
	Edge edgeOf(std::uint32_t a, std::uint32_t b) const {
		return edgeBetween(placeOf(a), placeOf(b));
	}
	static std::uint64_t keyOf(const Edge& e) { return std::uint64_t{e[0]} << 32 | e[1]; }
	NearPlane planeOf(std::uint32_t region) const {
		return regions_.isSingle(region)
		           ? planeOfFace(surface_.points,
		                         surface_.triangles[region - regions_.planes.size()])
		           : regions_.planes[region];
	}
	void listCandidates();
	void collectFaces();
	void addFace(const RegionFace& face);
	// The faces at a place, without dead ones from here on.
	const std::vector<std::uint32_t>& facesAt(std::uint32_t place) {
		std::vector<std::uint32_t>& list = lists_[place];
		const auto isDead = [this](std::uint32_t f) { return isAlive_[f] == 0; };
		list.erase(std::remove_if(list.begin(), list.end(), isDead), list.end());
		return list;
	}
	void tryRemove(std::uint32_t v);
	bool listSectors(std::uint32_t v, std::vector<Sector>& sectors);
	bool listRuns(const std::vector<Sector>& sectors, std::vector<Run>& runs) const;
	bool listTargets(std::uint32_t v, const std::vector<Run>& runs,
	                 std::vector<std::uint32_t>& ends, std::vector<std::uint32_t>& targets) const;
	bool makeChange(const std::vector<Run>& runs, std::uint32_t target, Change& change);
	bool fillRun(const Run& run, std::uint32_t target, Change& change);
	std::size_t outsideFacesAt(const Edge& edge, std::uint32_t v);
	bool isFaceElsewhere(const IndexTriangle& t, std::uint32_t v);
	bool staysSurface(std::uint32_t v, const std::vector<Sector>& sectors,
	                  const std::vector<Run>& runs, const Change& change);
	bool staysBeside(std::uint32_t v, const std::vector<std::uint32_t>& ends, std::uint32_t target,
	                 std::vector<std::pair<Edge, std::uint32_t>>& beside) const;
	void apply(std::uint32_t v, const std::vector<Sector>& sectors, const Change& change);
	void write(MergedFaces& out) const;

	const ClassedSurface& surface_;
	const PlaneRegions& regions_;
	const MergeLimits& limits_;
	const KeptParts& kept_;
	Monitor& monitor_;
	std::vector<std::uint32_t> candidates_;
	std::vector<std::uint8_t> isCandidate_;  // per vertex
	std::vector<std::uint8_t> isNear_;       // per vertex: a face of a candidate has it
	std::vector<RegionFace> faces_;
	std::vector<std::uint8_t> isAlive_;              // per face of these
	std::vector<std::vector<std::uint32_t>> lists_;  // per place, of them, dead ones too
	std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> beside_;  // what went, by edge
	std::vector<std::uint8_t> isTouched_;  // per region of several faces: it has new faces
	std::vector<std::uint32_t> gone_, again_;
	std::size_t originalCount_ = 0;  // of the faces, those of the surface
};

// The border edges at each vertex, as far as they are few: where they lead.
class BorderEnds {
public:
	explicit BorderEnds(std::size_t vertices) : ends_(vertices, {kNone, kNone, kNone}) {}

	void add(std::uint32_t v, std::uint32_t end) {
		for (std::uint32_t& known : ends_[v]) {
			if (known == kNone || known == end) {
				known = end;
				return;
			}
		}
	}
	// Whether there are three or more.
	bool areMany(std::uint32_t v) const { return ends_[v][2] != kNone; }
	const std::array<std::uint32_t, 3>& at(std::uint32_t v) const { return ends_[v]; }

private:
	HugeVector<std::array<std::uint32_t, 3>> ends_;
};

// Vertices that may bear nothing: those inside a region, those between two regions in a line that
// may be straight once others have gone, and those that are joined to one nearby. Copies in one
// place stay.
void RegionMerger::listCandidates() {
	const std::size_t n = surface_.points.size();
	isCandidate_.assign(n, 0);
	BorderEnds borders(n);
	const double near = limits_.aside * limits_.aside;
	for (std::size_t f = 0; f < surface_.triangles.size(); ++f) {
		const IndexTriangle& t = surface_.triangles[f];
		const bool isSingle = regions_.isSingle(regions_.ofFace[f]);
		for (std::size_t i = 0; i < 3; ++i) {
			const std::uint32_t v = t[i], w = t[i == 2 ? 0 : i + 1];
			const std::uint32_t other = regions_.neighbours[f][i];
			const bool isShort = squaredDistance(at(v), at(w)) <= near;
			const std::uint8_t mark = isShort ? kShort : isSingle ? std::uint8_t{0} : kOfSeveral;
			for (const std::uint32_t end : {v, w}) {
				isCandidate_[end] = static_cast<std::uint8_t>(isCandidate_[end] | mark);
			}
			if (other == kNone || regions_.ofFace[other] != regions_.ofFace[f]) {
				borders.add(v, w);
				borders.add(w, v);
			}
		}
	}
	const auto mayBeStraight = [&](std::uint32_t v) {
		constexpr double kWider = 16;  // the square of how much farther it may be now
		const auto& ends = borders.at(v);
		return !borders.areMany(v) &&
		       (ends[1] == kNone ||
		        squaredDistanceToSegment(at(v), at(ends[0]), at(ends[1])) <= kWider * near);
	};
	for (std::uint32_t v = 0; v < n; ++v) {
		const std::uint8_t marks = isCandidate_[v];
		isCandidate_[v] =
		    (marks & kShort) != 0 || ((marks & kOfSeveral) != 0 && mayBeStraight(v)) ? 1 : 0;
	}
	for (std::uint32_t v = 0; v < n; ++v) {
		if (placeOf(v) != v) {
			isCandidate_[v] = isCandidate_[placeOf(v)] = 0;
		}
		if (kept_.vertices[v] != 0) {
			isCandidate_[v] = 0;
		}
	}
	for (std::uint32_t v = 0; v < n; ++v) {
		if (isCandidate_[v] != 0) {
			candidates_.push_back(v);
		}
	}
}

// The faces at candidates, and those at the corners of these: all that may have an edge in common
// with a new face.
void RegionMerger::collectFaces() {
	const std::size_t n = surface_.points.size();
	isNear_.assign(n, 0);
	const auto hasAny = [this](const IndexTriangle& t, const std::vector<std::uint8_t>& marks) {
		return marks[placeOf(t[0])] != 0 || marks[placeOf(t[1])] != 0 || marks[placeOf(t[2])] != 0;
	};
	for (const IndexTriangle& t : surface_.triangles) {
		if (hasAny(t, isCandidate_)) {
			for (const std::uint32_t v : t) {
				isNear_[placeOf(v)] = 1;
			}
		}
	}
	lists_.resize(n);
	for (std::uint32_t f = 0; f < surface_.triangles.size(); ++f) {
		if (hasAny(surface_.triangles[f], isNear_)) {
			addFace({surface_.triangles[f], regions_.ofFace[f], f});
		}
	}
	originalCount_ = faces_.size();
	isTouched_.assign(regions_.planes.size(), 0);
}

void RegionMerger::addFace(const RegionFace& face) {
	for (const std::uint32_t v : face.corners) {
		if (isNear_[placeOf(v)] != 0) {
			lists_[placeOf(v)].push_back(static_cast<std::uint32_t>(faces_.size()));
		}
	}
	faces_.push_back(face);
	isAlive_.push_back(1);
}

// The edges opposite a vertex by their places. False if there are none, or too many.
bool RegionMerger::listSectors(std::uint32_t v, std::vector<Sector>& sectors) {
	for (const std::uint32_t f : facesAt(placeOf(v))) {
		const IndexTriangle& t = faces_[f].corners;
		const std::size_t i = t[0] == v ? 0 : t[1] == v ? 1 : 2;
		sectors.push_back({t[(i + 1) % 3], t[(i + 2) % 3], f});
	}
	std::sort(sectors.begin(), sectors.end(), [this](const Sector& a, const Sector& b) {
		return a.from != b.from
		           ? at(a.from) < at(b.from) || (at(a.from) == at(b.from) && a.from < b.from)
		           : at(a.to) < at(b.to);
	});
	return sectors.size() >= 1 && sectors.size() <= kMostFacesAtVertex;
}

// The runs of a star, in the order of where they begin. False if some cannot be told apart: a cycle
// beside other faces, or a run that ends where it begins.
bool RegionMerger::listRuns(const std::vector<Sector>& sectors, std::vector<Run>& runs) const {
	const std::size_t n = sectors.size();
	std::vector<std::array<std::uint32_t, 2>> ends;  // of edges, with the sector that ends there
	for (std::uint32_t s = 0; s < n; ++s) {
		ends.push_back({sectors[s].to, s});
	}
	std::sort(ends.begin(), ends.end());
	std::vector<std::array<std::uint32_t, 2>> begins;
	for (std::uint32_t s = 0; s < n; ++s) {
		begins.push_back({sectors[s].from, s});
	}
	std::sort(begins.begin(), begins.end());
	const auto only = [](const std::vector<std::array<std::uint32_t, 2>>& list, std::uint32_t v) {
		const auto it = std::lower_bound(list.begin(), list.end(), std::array{v, 0u});
		const bool isThere = it != list.end() && (*it)[0] == v;
		const bool isOnly = isThere && (it + 1 == list.end() || (it[1])[0] != v);
		return isOnly ? (*it)[1] : kNone;
	};
	const auto regionOf = [&](std::uint32_t s) { return faces_[sectors[s].face].region; };
	std::vector<std::uint32_t> next(n, kNone);
	std::vector<std::uint8_t> isFollowed(n, 0);  // whether another sector leads to it
	for (std::uint32_t s = 0; s < n; ++s) {
		const std::uint32_t after = only(begins, sectors[s].to);
		if (after != kNone && only(ends, sectors[s].to) == s && regionOf(after) == regionOf(s)) {
			next[s] = after;
			isFollowed[after] = 1;
		}
	}
	std::vector<std::uint8_t> isDone(n, 0);
	const auto walk = [&](std::uint32_t first) {
		Run run{{sectors[first].from}, regionOf(first), faces_[sectors[first].face].origin, false};
		std::uint32_t s = first;
		for (; s != kNone && isDone[s] == 0; s = next[s]) {
			isDone[s] = 1;
			run.corners.push_back(sectors[s].to);
		}
		run.isCycle = s != kNone;
		if (run.isCycle) {
			run.corners.pop_back();
		}
		runs.push_back(std::move(run));
	};
	for (const bool isForCycles : {false, true}) {
		for (std::uint32_t s = 0; s < n; ++s) {
			if (isDone[s] == 0 && (isForCycles || isFollowed[s] == 0)) {
				walk(s);
			}
		}
	}
	return runs.size() == 1 || std::none_of(runs.begin(), runs.end(), [](const Run& run) {
		       return run.isCycle || run.corners.front() == run.corners.back();
	       });
}

// The ends of border edges at a vertex, and those that it may go to, best first; none where there
// are no border edges. False if it may go nowhere.
bool RegionMerger::listTargets(std::uint32_t v, const std::vector<Run>& runs,
                               std::vector<std::uint32_t>& ends,
                               std::vector<std::uint32_t>& targets) const {
	if (runs.size() == 1 && runs.front().isCycle) {
		return true;
	}
	for (const Run& run : runs) {
		ends.push_back(run.corners.front());
		ends.push_back(run.corners.back());
	}
	sortUnique(ends);
	std::vector<std::uint32_t> places;
	for (const std::uint32_t end : ends) {
		places.push_back(placeOf(end));
	}
	sortUnique(places);
	if (places.size() != ends.size() || ends.size() < 2) {
		return false;  // the surface meets itself along one of these edges, or ends in one
	}
	std::sort(ends.begin(), ends.end(), [&](std::uint32_t a, std::uint32_t b) {
		const double toA = squaredDistance(at(v), at(a)), toB = squaredDistance(at(v), at(b));
		return toA != toB ? toA < toB : at(a) < at(b);
	});
	if (ends.size() == 2) {
		targets = {ends.front()};
		return true;
	}
	for (const std::uint32_t end : ends) {
		if (squaredDistance(at(v), at(end)) <= limits_.aside * limits_.aside &&
		    kept_.vertices[end] == 0) {
			targets.push_back(end);
		}
	}
	return !targets.empty();
}

// Fills what one run leaves. False if that does not succeed.
bool RegionMerger::fillRun(const Run& run, std::uint32_t target, Change& change) {
	std::vector<std::uint32_t> corners = run.corners;
	const NearPlane plane = planeOf(run.region);
	if (!run.isCycle && corners.front() != target && corners.back() != target) {
		if (std::fabs(plane.height(at(target))) > limits_.reach) {
			return false;
		}
		corners.push_back(target);
	}
	if (corners.size() == 2) {
		change.vanished.push_back(edgeOf(corners[0], corners[1]));
		return true;
	}
	SeenPolygon polygon{{}, plane.axis, plane.front};
	const auto byPlace = [this](std::uint32_t a, std::uint32_t b) { return at(a) < at(b); };
	std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end(), byPlace),
	            corners.end());
	for (const std::uint32_t corner : corners) {
		polygon.corners.push_back(at(corner));
	}
	std::vector<std::array<std::size_t, 3>> triangles;
	const auto mayCut = [&](std::size_t a, std::size_t b) {
		return outsideFacesAt(edgeOf(corners[a], corners[b]), kNone) == 0;
	};
	if (plane.front == 0 || !fillPolygon(polygon, mayCut, triangles)) {
		return false;
	}
	for (const auto& [i, j, k] : triangles) {
		change.faces.push_back({{corners[i], corners[j], corners[k]}, run.region, run.origin});
	}
	return true;
}

bool RegionMerger::makeChange(const std::vector<Run>& runs, std::uint32_t target, Change& change) {
	change = {};
	change.target = target;
	return std::all_of(runs.begin(), runs.end(),
	                   [&](const Run& run) { return fillRun(run, target, change); });
}

// How many faces have an edge, but for those at a vertex.
std::size_t RegionMerger::outsideFacesAt(const Edge& edge, std::uint32_t v) {
	const bool firstIsShorter = lists_[edge[0]].size() < lists_[edge[1]].size();
	const std::uint32_t shorter = edge[firstIsShorter ? 0 : 1],
	                    other = edge[firstIsShorter ? 1 : 0];
	std::size_t count = 0;
	for (const std::uint32_t f : facesAt(shorter)) {
		const IndexTriangle& t = faces_[f].corners;
		bool hasOther = false, hasVertex = false;
		for (const std::uint32_t corner : t) {
			hasOther = hasOther || placeOf(corner) == other;
			hasVertex = hasVertex || corner == v;
		}
		count += hasOther && !hasVertex ? 1 : 0;
	}
	return count;
}

// Whether a face that is not at a vertex lies on the same three places.
bool RegionMerger::isFaceElsewhere(const IndexTriangle& t, std::uint32_t v) {
	const auto has = [this](const IndexTriangle& face, std::uint32_t place) {
		return placeOf(face[0]) == place || placeOf(face[1]) == place || placeOf(face[2]) == place;
	};
	const std::vector<std::uint32_t>& list = facesAt(placeOf(t[0]));
	return std::any_of(list.begin(), list.end(), [&](std::uint32_t f) {
		const IndexTriangle& face = faces_[f].corners;
		return has(face, placeOf(t[1])) && has(face, placeOf(t[2])) && !has(face, placeOf(v));
	});
}

// Whether each edge has as many faces as it should have when a vertex has gone.
bool RegionMerger::staysSurface(std::uint32_t v, const std::vector<Sector>& sectors,
                                const std::vector<Run>& runs, const Change& change) {
	struct Sides {
		Edge edge;
		int made = 0, lost = 0, moved = 0, vanished = 0;
	};
	std::vector<Sides> all;
	for (const RegionFace& face : change.faces) {
		for (std::size_t i = 0; i < 3; ++i) {
			all.push_back({edgeOf(face.corners[i], face.corners[(i + 1) % 3]), 1, 0, 0, 0});
		}
	}
	for (const Sector& s : sectors) {
		all.push_back({edgeOf(s.from, s.to), 0, 1, 0, 0});
	}
	for (const Run& run : runs) {
		for (const std::uint32_t end : {run.corners.front(), run.corners.back()}) {
			if (!run.isCycle && end != change.target) {
				all.push_back({edgeOf(end, change.target), 0, 0, 1, 0});
			}
		}
	}
	for (const Edge& edge : change.vanished) {
		all.push_back({edge, 0, 0, 0, 1});
	}
	std::sort(all.begin(), all.end(),
	          [](const Sides& a, const Sides& b) { return a.edge < b.edge; });
	for (std::size_t i = 0; i < all.size();) {
		Sides sum{all[i].edge};
		for (; i < all.size() && all[i].edge == sum.edge; ++i) {
			sum.made += all[i].made;
			sum.lost += all[i].lost;
			sum.moved += all[i].moved;
			sum.vanished += all[i].vanished;
		}
		const bool isOpposite = sum.lost > 0 && sum.moved == 0;
		if (isOpposite) {
			if (sum.made != sum.lost) {
				return false;
			}
			continue;
		}
		const auto outside = static_cast<int>(outsideFacesAt(sum.edge, v));
		const int expected = sum.moved > 0 ? sum.moved - sum.vanished : 2;
		if (sum.made != expected || outside != sum.vanished || sum.lost != sum.vanished) {
			return false;
		}
	}
	return std::none_of(change.faces.begin(), change.faces.end(),
	                    [&](const RegionFace& face) { return isFaceElsewhere(face.corners, v); });
}

// Whether all that has gone from between regions stays beside an edge: the vertex itself, and what
// is remembered of its border edges. \param beside what is to be remembered, and with which edge
bool RegionMerger::staysBeside(std::uint32_t v, const std::vector<std::uint32_t>& ends,
                               std::uint32_t target,
                               std::vector<std::pair<Edge, std::uint32_t>>& beside) const {
	const double most = limits_.aside * limits_.aside;
	const auto remembered = [&](std::uint32_t end, auto&& visit) {
		const auto it = beside_.find(keyOf(edgeOf(v, end)));
		return it == beside_.end() || std::all_of(it->second.begin(), it->second.end(), visit);
	};
	const auto isBesideAny = [&](std::uint32_t gone) {
		double least = HUGE_VAL;
		Edge nearest{};
		for (const std::uint32_t end : ends) {
			if (end != target) {
				const double d = squaredDistanceToSegment(at(gone), at(end), at(target));
				if (d < least) {
					least = d;
					nearest = edgeOf(end, target);
				}
			}
		}
		beside.push_back({nearest, gone});
		return least <= most;
	};
	return isBesideAny(v) && remembered(target, isBesideAny) &&
	       std::all_of(ends.begin(), ends.end(), [&](std::uint32_t end) {
		       return end == target || remembered(end, [&](std::uint32_t gone) {
			              beside.push_back({edgeOf(end, target), gone});
			              return squaredDistanceToSegment(at(gone), at(end), at(target)) <= most;
		              });
	       });
}

void RegionMerger::apply(std::uint32_t v, const std::vector<Sector>& sectors,
                         const Change& change) {
	for (const Sector& s : sectors) {
		isAlive_[s.face] = 0;
		if (!regions_.isSingle(faces_[s.face].region)) {
			isTouched_[faces_[s.face].region] = 1;
		}
		beside_.erase(keyOf(edgeOf(v, s.from)));
		beside_.erase(keyOf(edgeOf(v, s.to)));
		for (const std::uint32_t corner : {s.from, s.to}) {
			if (isCandidate_[corner] != 0) {
				again_.push_back(corner);
			}
		}
	}
	for (const RegionFace& face : change.faces) {
		addFace(face);
	}
	gone_.push_back(v);
	isCandidate_[v] = 0;
}

// Takes a vertex away if what it leaves can be filled.
void RegionMerger::tryRemove(std::uint32_t v) {
	std::vector<Sector> sectors;
	std::vector<Run> runs;
	std::vector<std::uint32_t> ends, targets;
	if (isCandidate_[v] == 0 || !listSectors(v, sectors) || !listRuns(sectors, runs) ||
	    !listTargets(v, runs, ends, targets)) {
		return;
	}
	const bool isInside = ends.empty();
	if (isInside) {
		targets = {kNone};
	}
	for (const std::uint32_t target : targets) {
		Change change;
		std::vector<std::pair<Edge, std::uint32_t>> beside;
		if ((isInside || staysBeside(v, ends, target, beside)) &&
		    makeChange(runs, target, change) && staysSurface(v, sectors, runs, change)) {
			apply(v, sectors, change);
			for (const auto& [edge, gone] : beside) {
				beside_[keyOf(edge)].push_back(gone);
			}
			return;
		}
	}
}

void RegionMerger::write(MergedFaces& out) const {
	std::vector<std::uint8_t> isGone(surface_.triangles.size(), 0);
	for (std::size_t i = 0; i < originalCount_; ++i) {
		const std::uint32_t f = faces_[i].origin;
		isGone[f] = isAlive_[i] == 0 || faces_[i].corners != surface_.triangles[f] ? 1 : 0;
	}
	for (std::uint32_t f = 0; f < isGone.size(); ++f) {
		if (isGone[f] == 0) {
			out.triangles.push_back(surface_.triangles[f]);
			out.origin.push_back(f);
			out.region.push_back(regions_.ofFace[f]);
		}
	}
	out.firstNew = out.triangles.size();
	for (std::size_t i = 0; i < faces_.size(); ++i) {
		if (isAlive_[i] != 0 && (i >= originalCount_ || isGone[faces_[i].origin] != 0)) {
			out.triangles.push_back(faces_[i].corners);
			out.origin.push_back(faces_[i].origin);
			out.region.push_back(faces_[i].region);
		}
	}
	out.gone = gone_;
}

Status RegionMerger::run(MergedFaces& out) {
	constexpr std::size_t kPoll = 1 << 10;
	listCandidates();
	if (candidates_.empty()) {
		return {};
	}
	collectFaces();
	std::vector<std::uint32_t> round = std::move(candidates_);
	Status status;
	while (!round.empty() && status.ok()) {
		sortByHash(
		    round, [this](std::uint32_t v) { return at(v); },
		    [this](std::uint32_t v, std::uint32_t w) { return at(v) < at(w); });
		again_.clear();
		status = inOrderFor(round.size(), kPoll, monitor_, [&](std::size_t begin, std::size_t end) {
			for (std::size_t i = begin; i < end; ++i) {
				tryRemove(round[i]);
			}
		});
		sortUnique(again_);
		round = again_;
	}
	if (!status.ok() || gone_.empty()) {
		return status;
	}
	status = flipRegions({surface_, regions_, isTouched_, kept_.faces}, isAlive_, monitor_, faces_);
	write(out);
	return status;
}

}  // namespace

Status mergeRegions(const ClassedSurface& surface, const PlaneRegions& regions,
                    const MergeLimits& limits, const KeptParts& kept, Monitor& monitor,
                    MergedFaces& out) {
	out = {};
	return RegionMerger(surface, regions, limits, kept, monitor).run(out);
}

}  // namespace index_boolean
