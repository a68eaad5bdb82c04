// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What hangs together around plain vertices is a patch. What is then united are sides of patches:
// front with front where two run alike, front with back where they do not. A surface whose two
// sides become one is one-sided.
#include "vcg_ext/parts/sub_surfaces.h"

#include "vcg_ext/arrange/places.h"
#include "vcg_ext/base/concurrent_sets.h"
#include "vcg_ext/base/huge_vector.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/mesh/boundary_checksum.h"

#include <algorithm>

namespace index_boolean {

namespace {

constexpr std::size_t kGrain = 1 << 14;

// Consecutive faces of the complex whose fronts are, or whose backs are, one side of a set of
// patches.
struct FaceRun {
	std::uint32_t begin, end;
	std::uint32_t side;      // in front of them, by the root of its set
	std::uint32_t smallest;  // of the faces
	Point least;             // the place of its first corner in lexicographic order, as rounded
	SurfaceSums sums;        // seen from the front of the root
};

class SubSurfaceFinder {
public:
	SubSurfaceFinder(const Arrangement& arrangement, Monitor& monitor, SubSurfaces& out)
	    : arrangement_(arrangement), monitor_(monitor), out_(out), complex_(out.complex),
	      vertexCount_(arrangement.mesh.points.size()) {}

	Status run();

private:
	Status unitePatches();
	void numberPatches();
	Status uniteSides();
	void uniteAcross(HalfEdgeId h);
	Status listRuns();
	void listRuns(std::uint32_t begin, std::uint32_t end, std::vector<FaceRun>& runs) const;
	void addFace(std::uint32_t face, FaceRun& run) const;
	std::vector<const FaceRun*> inOrderOfFaces(const std::vector<const FaceRun*>& best) const;
	void numberSubSurfaces();
	void addSubSurface(std::uint32_t smallest);
	Status listFaces();
	Status traceCycles();
	void listCycles();
	BoundaryCycle trace(HalfEdgeId start, std::vector<std::uint8_t>& visited) const;
	void beginAtSmallest(BoundaryCycle& cycle) const;
	void findSubSurfacesAtLoops();

	// Calls body(begin, end) for ranges of n items, on all threads.
	template <class Body>
	Status forRanges(std::size_t n, Body&& body) {
		return parallelFor(n, kGrain, arrangement_.options.threads, monitor_, body);
	}

	std::uint32_t patchOf(VertexId plain) const { return patch_[patches_.root(plain.value)]; }
	// Of the front of a patch, the root of its side's set.
	std::uint32_t sideOf(std::uint32_t patch) const { return sides_.root(2 * patch); }
	int compare(VertexId a, VertexId b) const { return comparePlaces(arrangement_, a, b); }
	Triangle cornersInOrder(std::uint32_t face) const;
	bool isSmaller(const Triangle& a, const Triangle& b) const;
	bool isBefore(std::uint32_t face, const Point& least, std::uint32_t than,
	              const Point& leastOfOther) const;

	const Arrangement& arrangement_;
	Monitor& monitor_;
	SubSurfaces& out_;
	const SurfaceComplex& complex_;
	std::size_t vertexCount_;          // of the input
	ConcurrentSets patches_;           // of input vertices
	HugeVector<std::uint32_t> patch_;  // per root of these sets: its number
	std::uint32_t patchCount_ = 0;
	std::vector<std::uint32_t> nearPatch_;    // per near face
	ConcurrentSets sides_;                    // 2 * patch: its front; 2 * patch + 1: its back
	std::vector<std::vector<FaceRun>> runs_;  // per chunk of the faces
	std::vector<SubSurfaceId> ofSet_;         // per root patch
	std::vector<const FaceRun*> smallest_;    // per sub-surface: the run with its smallest face
};

// All faces at a plain vertex are one patch.
Status SubSurfaceFinder::unitePatches() {
	const std::size_t n = vertexCount_;
	patches_ = ConcurrentSets(n);
	const auto makeSets = [this](std::size_t begin, std::size_t end) {
		patches_.makeSets(begin, end);
	};
	const auto flatten = [this](std::size_t begin, std::size_t end) {
		patches_.flatten(begin, end);
	};
	const auto isPlain = [this](VertexId v) { return complex_.isPlain(v); };
	const auto unite = [&](std::size_t begin, std::size_t end) {
		for (std::size_t face = begin; face < end; ++face) {
			const Triangle& t = complex_.faces[face].corners;
			const auto first = std::find_if(t.begin(), t.end(), isPlain);
			if (first == t.end()) {
				continue;
			}
			const auto corner = [&](std::size_t i) {
				return (isPlain(t[i]) ? t[i] : *first).value;
			};
			patches_.unite({corner(0), corner(1), corner(2)});
		}
	};
	return inOrder([&] { return forRanges(n, makeSets); },
	               [&] { return forRanges(complex_.faces.size(), unite); },
	               [&] { return forRanges(n, flatten); });
}

// A near face without a plain vertex is a patch of its own.
void SubSurfaceFinder::numberPatches() {
	patch_.resizeForOverwrite(vertexCount_);
	for (std::uint32_t v = 0; v < vertexCount_; ++v) {
		if (patches_.root(v) == v && complex_.isPlain({v})) {
			patch_[v] = patchCount_++;
		}
	}
	nearPatch_.resize(complex_.nearFaces.size());
	for (std::uint32_t n = 0; n < nearPatch_.size(); ++n) {
		const Triangle& t = complex_.faces[complex_.nearFaces[n]].corners;
		const auto plain =
		    std::find_if(t.begin(), t.end(), [this](VertexId v) { return complex_.isPlain(v); });
		nearPatch_[n] = plain == t.end() ? patchCount_++ : patchOf(*plain);
	}
}

// Unites the sides of a near face with those across one of its edges.
void SubSurfaceFinder::uniteAcross(HalfEdgeId h) {
	const HalfEdgeId mate = at(complex_.mates, h);
	if (mate == HalfEdgeId::none() || mate < h) {
		return;
	}
	const std::uint32_t a = 2 * nearPatch_[h.value / 3], b = 2 * nearPatch_[mate.value / 3];
	const std::uint32_t flip = complex_.beginOf(h) == complex_.beginOf(mate) ? 1 : 0;
	sides_.unite(a, b + flip);
	sides_.unite(a + 1, b + 1 - flip);
}

Status SubSurfaceFinder::uniteSides() {
	const std::size_t n = 2 * std::size_t{patchCount_};
	sides_ = ConcurrentSets(n);
	sides_.makeSets(0, n);
	const auto unite = [this](std::size_t begin, std::size_t end) {
		for (std::size_t h = begin; h < end; ++h) {
			uniteAcross(makeId<HalfEdgeTag>(h));
		}
	};
	const auto flatten = [this](std::size_t begin, std::size_t end) { sides_.flatten(begin, end); };
	return inOrder([&] { return forRanges(complex_.mates.size(), unite); },
	               [&] { return forRanges(n, flatten); });
}

// The corners of a face in lexicographic order of their places.
Triangle SubSurfaceFinder::cornersInOrder(std::uint32_t face) const {
	Triangle t = complex_.faces[face].corners;
	std::sort(t.begin(), t.end(), [this](VertexId a, VertexId b) { return compare(a, b) < 0; });
	return t;
}

// Of faces by their corners in that order.
bool SubSurfaceFinder::isSmaller(const Triangle& a, const Triangle& b) const {
	for (std::size_t i = 0; i < 3; ++i) {
		if (const int order = compare(a[i], b[i]); order != 0) {
			return order < 0;
		}
	}
	return false;
}

// As isSmaller, for faces of which the places of their first corners are known.
bool SubSurfaceFinder::isBefore(std::uint32_t face, const Point& least, std::uint32_t than,
                                const Point& leastOfOther) const {
	return least < leastOfOther ||
	       (least == leastOfOther && isSmaller(cornersInOrder(face), cornersInOrder(than)));
}

void SubSurfaceFinder::addFace(std::uint32_t face, FaceRun& run) const {
	const Triangle& t = complex_.faces[face].corners;
	const Point &p = arrangement_.coordinates(t[0]), &q = arrangement_.coordinates(t[1]),
	            &r = arrangement_.coordinates(t[2]);
	const double x = std::min(std::min(p[0], q[0]), r[0]);
	if (run.smallest == kNone || x <= run.least[0]) {
		const Point& least = std::min(std::min(p, q), r);
		if (run.smallest == kNone || isBefore(face, least, run.smallest, run.least)) {
			run.smallest = face;
			run.least = least;
		}
	}
	const bool turned = run.side % 2 != 0;
	const SumFrame& frame = out_.frame;
	addTriangle(frame.map(p), frame.map(turned ? r : q), frame.map(turned ? q : r), run.sums);
}

// The runs of the faces [begin, end), which are all looked at once.
void SubSurfaceFinder::listRuns(std::uint32_t begin, std::uint32_t end,
                                std::vector<FaceRun>& runs) const {
	auto next = std::lower_bound(complex_.nearFaces.begin(), complex_.nearFaces.end(), begin);
	FaceRun run{begin, begin, kNone, kNone, {}, {}};
	for (std::uint32_t face = begin; face < end; ++face) {
		const bool isNear = next != complex_.nearFaces.end() && *next == face;
		const std::uint32_t patch =
		    isNear ? nearPatch_[static_cast<std::size_t>(next++ - complex_.nearFaces.begin())]
		           : patchOf(complex_.faces[face].corners[0]);
		const std::uint32_t side = sideOf(patch);
		if (run.side != side) {
			if (run.end != run.begin) {
				runs.push_back(run);
			}
			run = {face, face, side, kNone, {}, {}};
		}
		addFace(face, run);
		run.end = face + 1;
	}
	runs.push_back(run);
}

Status SubSurfaceFinder::listRuns() {
	const Points& points = arrangement_.mesh.points;
	const int threads = arrangement_.options.threads;
	BoundingBox box{};
	const Status status = findBoundingBox(points.data(), points.size(), threads, monitor_, box);
	out_.frame = makeSumFrame(box);
	runs_.resize(chunkCount(complex_.faces.size(), kGrain));
	const auto listChunk = [this](std::size_t chunk, std::size_t begin, std::size_t end) {
		listRuns(static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end), runs_[chunk]);
	};
	return status.ok()
	           ? parallelForChunks(complex_.faces.size(), kGrain, threads, monitor_, listChunk)
	           : status;
}

// Adds a sub-surface, whose smallest face is given.
void SubSurfaceFinder::addSubSurface(std::uint32_t smallest) {
	const SubSurfaceId id = makeId<SubSurfaceTag>(out_.all.size());
	SubSurface surface{};
	surface.number = PerOperand<std::int32_t>(arrangement_.mesh.operands().count());
	std::fill(surface.number.begin(), surface.number.end(), -1);
	complex_.visitSources(complex_.faces[smallest], [&](FaceId source, bool) {
		const OperandId operand = arrangement_.mesh.operandOf(source);
		if (surface.number[operand] < 0) {
			surface.number[operand] = static_cast<std::int32_t>(out_.ofOperand[operand].size());
			out_.ofOperand[operand].push_back(id);
		}
	});
	const Triangle& corners = complex_.faces[smallest].corners;
	const Triangle ordered = cornersInOrder(smallest);
	const auto first = std::find(corners.begin(), corners.end(), ordered[0]) - corners.begin();
	const auto second = static_cast<std::size_t>(nextCorner(static_cast<int>(first)));
	surface.frontFirst = corners[second] != ordered[1];
	out_.all.push_back(surface);
}

// Sub-surfaces in the order of their smallest faces, given one run with that face of each.
std::vector<const FaceRun*>
SubSurfaceFinder::inOrderOfFaces(const std::vector<const FaceRun*>& best) const {
	struct Keyed {
		Triangle corners;
		const FaceRun* run;
	};
	std::vector<Keyed> keyed;
	for (const FaceRun* run : best) {
		if (run != nullptr) {
			keyed.push_back({cornersInOrder(run->smallest), run});
		}
	}
	std::sort(keyed.begin(), keyed.end(),
	          [this](const Keyed& a, const Keyed& b) { return isSmaller(a.corners, b.corners); });
	std::vector<const FaceRun*> order;
	for (const Keyed& k : keyed) {
		order.push_back(k.run);
	}
	return order;
}

// Sub-surfaces are numbered in the order of their smallest faces.
void SubSurfaceFinder::numberSubSurfaces() {
	// Per root patch: the run with the smallest face, and the sums of all.
	std::vector<const FaceRun*> best(patchCount_);
	std::vector<SurfaceSums> sums(patchCount_);
	std::vector<std::uint32_t> faceCount(patchCount_);
	for (const std::vector<FaceRun>& chunk : runs_) {
		for (const FaceRun& run : chunk) {
			const FaceRun*& least = best[run.side / 2];
			if (least == nullptr ||
			    isBefore(run.smallest, run.least, least->smallest, least->least)) {
				least = &run;
			}
			sums[run.side / 2].add(run.sums, 1);
			faceCount[run.side / 2] += run.end - run.begin;
		}
	}
	ofSet_.resize(patchCount_);
	std::uint32_t first = 0;
	for (const FaceRun* run : inOrderOfFaces(best)) {
		const std::uint32_t patch = run->side / 2;
		ofSet_[patch] = makeId<SubSurfaceTag>(out_.all.size());
		addSubSurface(run->smallest);
		SubSurface& surface = out_.all.back();
		surface.oneSided = sides_.root(2 * patch) == sides_.root(2 * patch + 1);
		surface.area = areaOf(sums[patch], out_.frame);
		surface.faceCount = faceCount[patch];
		surface.firstFace = first;
		first += surface.faceCount;
		smallest_.push_back(run);
		out_.sums.emplace_back();
		out_.sums.back().add(sums[patch], run->side % 2 == 0 ? 1 : -1);
	}
}

// Lists the faces of each sub-surface, the smallest one first.
Status SubSurfaceFinder::listFaces() {
	const std::size_t n = complex_.faces.size();
	std::vector<std::uint32_t> next;
	for (const SubSurface& surface : out_.all) {
		next.push_back(surface.firstFace + 1);
	}
	std::vector<std::vector<std::uint32_t>> places(runs_.size());
	for (std::size_t chunk = 0; chunk < runs_.size(); ++chunk) {
		for (const FaceRun& run : runs_[chunk]) {
			const SubSurfaceId id = ofSet_[run.side / 2];
			const std::uint32_t smallest = at(smallest_, id)->smallest;
			places[chunk].push_back(at(next, id));
			at(next, id) += run.end - run.begin;
			at(next, id) -= smallest >= run.begin && smallest < run.end ? 1 : 0;
		}
	}
	out_.ofFace.resizeForOverwrite(n);
	out_.turned.resizeForOverwrite(n);
	out_.faces.resizeForOverwrite(n);
	const auto fill = [&](std::size_t chunk, std::size_t, std::size_t) {
		for (std::size_t i = 0; i < runs_[chunk].size(); ++i) {
			const FaceRun& run = runs_[chunk][i];
			const SubSurfaceId id = ofSet_[run.side / 2];
			const FaceRun& first = *at(smallest_, id);
			std::fill(&out_.ofFace[run.begin], &out_.ofFace[0] + run.end, id);
			std::fill(&out_.turned[run.begin], &out_.turned[0] + run.end,
			          run.side % 2 != first.side % 2 ? 1 : 0);
			std::uint32_t place = places[chunk][i];
			for (std::uint32_t face = run.begin; face < run.end; ++face) {
				const bool isFirst = face == first.smallest;
				out_.faces[isFirst ? at(out_.all, id).firstFace : place++] = face;
			}
		}
	};
	return parallelForChunks(n, kGrain, arrangement_.options.threads, monitor_, fill);
}

bool passesEachEdgeTwice(const std::vector<VertexId>& cycle) {
	std::vector<std::pair<VertexId, VertexId>> edges;
	for (std::size_t i = 0; i < cycle.size(); ++i) {
		edges.push_back(std::minmax(cycle[i], cycle[i + 1 < cycle.size() ? i + 1 : 0]));
	}
	std::sort(edges.begin(), edges.end());
	bool twice = edges.size() % 2 == 0;
	for (std::size_t i = 0; i + 1 < edges.size() && twice; i += 2) {
		twice = edges[i] == edges[i + 1];
	}
	return twice;
}

// Starts at the smallest point of the cycle, and there with the smallest next one.
void SubSurfaceFinder::beginAtSmallest(BoundaryCycle& cycle) const {
	std::vector<VertexId>& points = cycle.points;
	std::size_t best = 0;
	for (std::size_t i = 1; i < points.size(); ++i) {
		int order = compare(points[i], points[best]);
		if (order == 0) {
			order = compare(points[(i + 1) % points.size()], points[(best + 1) % points.size()]);
		}
		best = order < 0 ? i : best;
	}
	std::rotate(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(best), points.end());
}

// Follows the boundary from a half-edge on, with the sub-surface on its left as seen from its
// front.
BoundaryCycle SubSurfaceFinder::trace(HalfEdgeId start, std::vector<std::uint8_t>& visited) const {
	const std::uint32_t face = complex_.faceAt(start);
	BoundaryCycle cycle{out_.ofFace[face], false, {}};
	VertexId point = out_.turned[face] != 0 ? complex_.endOf(start) : complex_.beginOf(start);
	HalfEdgeId h = start;
	std::uint64_t once = 0;  // the hashes of edges that have been passed an odd number of times
	do {
		at(visited, h) = 1;
		cycle.points.push_back(point);
		const VertexId begin = complex_.beginOf(h), end = complex_.endOf(h);
		once ^= signedEdgeHash(std::min(begin, end).value, std::max(begin, end).value);
		point = begin == point ? end : begin;
		h = complex_.turnAround(h, point);
	} while (h != start);
	cycle.isSlit = once == 0 && passesEachEdgeTwice(cycle.points);
	beginAtSmallest(cycle);
	return cycle;
}

Status SubSurfaceFinder::traceCycles() {
	constexpr std::size_t kStarts = 64;  // a cycle may be long
	std::vector<std::uint8_t> visited(complex_.mates.size());
	const auto traceFrom = [&](std::size_t begin, std::size_t end) {
		for (std::size_t i = begin; i < end; ++i) {
			if (at(visited, complex_.halfEdges[i]) == 0) {
				out_.cycles.push_back(trace(complex_.halfEdges[i], visited));
			}
		}
	};
	const Status status = inOrderFor(complex_.halfEdges.size(), kStarts, monitor_, traceFrom);
	if (status.ok()) {
		listCycles();
	}
	return status;
}

void SubSurfaceFinder::listCycles() {
	const auto before = [this](const BoundaryCycle& a, const BoundaryCycle& b) {
		if (a.of != b.of) {
			return a.of < b.of;
		}
		return std::lexicographical_compare(
		    a.points.begin(), a.points.end(), b.points.begin(), b.points.end(),
		    [this](VertexId p, VertexId q) { return compare(p, q) < 0; });
	};
	std::sort(out_.cycles.begin(), out_.cycles.end(), before);
	for (std::uint32_t i = 0; i < out_.cycles.size(); ++i) {
		SubSurface& surface = at(out_.all, out_.cycles[i].of);
		surface.firstCycle = surface.cycleCount == 0 ? i : surface.firstCycle;
		++surface.cycleCount;
		surface.closedCycles += out_.cycles[i].isSlit ? 0 : 1;
	}
}

// A loop's sub-surfaces are those at any of its edges.
void SubSurfaceFinder::findSubSurfacesAtLoops() {
	for (const Loop& loop : arrangement_.loops) {
		std::vector<SubSurfaceId> found;
		if (const PartingEdge* edge = complex_.partingEdge(loop.points[0], loop.points[1])) {
			for (std::uint32_t i = edge->first; i < edge->first + edge->count; ++i) {
				found.push_back(out_.ofFace[complex_.faceAt(complex_.halfEdges[i])]);
			}
		}
		std::sort(found.begin(), found.end());
		found.erase(std::unique(found.begin(), found.end()), found.end());
		out_.atLoop.push_back(std::move(found));
	}
}

Status SubSurfaceFinder::run() {
	return inOrder(
	    [this] {
		    return buildComplex(arrangement_, ComplexOf::Everything, monitor_, out_.complex);
	    },
	    [this] { return unitePatches(); },
	    [this] {
		    numberPatches();
		    return uniteSides();
	    },
	    [this] { return listRuns(); },
	    [this] {
		    numberSubSurfaces();
		    return listFaces();
	    },
	    [this] { return traceCycles(); },
	    [this] {
		    findSubSurfacesAtLoops();
		    return Status{};
	    });
}

}  // namespace

Status findSubSurfaces(const Arrangement& arrangement, Monitor& monitor, SubSurfaces& out) {
	out = SubSurfaces{};
	out.ofOperand = PerOperand<std::vector<SubSurfaceId>>(arrangement.mesh.operands().count());
	return SubSurfaceFinder(arrangement, monitor, out).run();
}

}  // namespace index_boolean
