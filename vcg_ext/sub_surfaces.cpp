// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is united are not faces but their sides: front with front where two faces run alike, front
// with back where they do not. A surface whose two sides become one is one-sided.
#include "sub_surfaces.h"

#include "concurrent_sets.h"
#include "huge_pages.h"
#include "parallel.h"
#include "weld.h"

#include <algorithm>

namespace index_boolean {

namespace {

constexpr std::uint32_t kNoFace = 0xffffffffu;
constexpr std::size_t kGrain = 1 << 13;

class Finder {
public:
	Finder(const Arrangement& arrangement, Monitor& monitor, SubSurfaces& out)
	    : arrangement_(arrangement), monitor_(monitor), out_(out), complex_(out.complex) {}

	Status run();

private:
	void uniteSidesOf(std::uint32_t face);
	Status uniteSides();
	Status findSmallestFaces();
	Status numberSubSurfaces();
	Status listFaces();
	Status measure();
	Status traceCycles();
	void listCycles();
	BoundaryCycle trace(HalfEdgeId start, std::vector<std::uint8_t>& visited) const;
	void beginAtSmallest(BoundaryCycle& cycle) const;
	Status findSubSurfacesAtLoops();

	// Calls body(begin, end) for ranges of n items, on all threads.
	template <class Body>
	Status forRanges(std::size_t n, Body&& body) {
		return parallelFor(n, kGrain, arrangement_.options.threads, monitor_, body);
	}

	// Calls body(face) for all faces of the complex, ascending.
	template <class Body>
	Status forEachFace(Body&& body) {
		return inOrderFor(complex_.faces.size(), kGrain, monitor_,
		                  [&body](std::size_t begin, std::size_t end) {
			                  for (std::size_t face = begin; face < end; ++face) {
				                  body(static_cast<std::uint32_t>(face));
			                  }
		                  });
	}

	std::uint32_t rootOf(std::uint32_t face) const { return sides_.root(2 * face) / 2; }
	bool isTurned(std::uint32_t face) const { return sides_.root(2 * face) % 2 != 0; }
	int compare(VertexId a, VertexId b) const { return comparePlaces(arrangement_, a, b); }
	Triangle inOrder(std::uint32_t face) const;
	bool isSmaller(std::uint32_t face, std::uint32_t than) const;

	const Arrangement& arrangement_;
	Monitor& monitor_;
	SubSurfaces& out_;
	const SurfaceComplex& complex_;
	ConcurrentSets sides_;                 // 2 * face: its front; 2 * face + 1: its back
	std::vector<std::uint32_t> smallest_;  // per root face: the smallest of its set
};

// Unites the sides of a face with those across its edges.
void Finder::uniteSidesOf(std::uint32_t face) {
	for (std::uint32_t h = 3 * face; h < 3 * face + 3; ++h) {
		const HalfEdgeId mate = complex_.mates[h];
		if (mate == HalfEdgeId::none() || mate.value < h) {
			continue;
		}
		const std::uint32_t a = 2 * face, b = 2 * (mate.value / 3);
		const std::uint32_t flip = complex_.beginOf({h}) == complex_.beginOf(mate) ? 1 : 0;
		sides_.unite(a, b + flip);
		sides_.unite(a + 1, b + 1 - flip);
	}
}

Status Finder::uniteSides() {
	const std::size_t faceCount = complex_.faces.size();
	sides_ = ConcurrentSets(2 * faceCount);
	Status status = forRanges(faceCount, [this](std::size_t begin, std::size_t end) {
		sides_.makeSets(2 * begin, 2 * end);
	});
	if (status.ok()) {
		status = forRanges(faceCount, [this](std::size_t begin, std::size_t end) {
			for (std::size_t face = begin; face < end; ++face) {
				uniteSidesOf(static_cast<std::uint32_t>(face));
			}
		});
	}
	if (status.ok()) {
		status = forRanges(faceCount, [this](std::size_t begin, std::size_t end) {
			sides_.flatten(2 * begin, 2 * end);
		});
	}
	return status;
}

// The corners of a face in lexicographic order of their places.
Triangle Finder::inOrder(std::uint32_t face) const {
	Triangle t = complex_.faces[face].corners;
	std::sort(t.begin(), t.end(), [this](VertexId a, VertexId b) { return compare(a, b) < 0; });
	return t;
}

bool Finder::isSmaller(std::uint32_t face, std::uint32_t than) const {
	const Triangle a = inOrder(face), b = inOrder(than);
	for (std::size_t i = 0; i < 3; ++i) {
		if (const int order = compare(a[i], b[i]); order != 0) {
			return order < 0;
		}
	}
	return false;
}

Status Finder::findSmallestFaces() {
	const std::size_t faceCount = complex_.faces.size();
	const auto leftmost = [this](std::uint32_t face) {
		const Triangle& t = complex_.faces[face].corners;
		return std::min({arrangement_.coordinates(t[0])[0], arrangement_.coordinates(t[1])[0],
		                 arrangement_.coordinates(t[2])[0]});
	};
	assignHuge(smallest_, faceCount, kNoFace);
	const auto least = makeHuge<double>(faceCount);
	return forEachFace([&](std::uint32_t face) {
		const std::uint32_t root = rootOf(face);
		const double x = leftmost(face);
		std::uint32_t& best = smallest_[root];
		if (best == kNoFace || x < least[root] || (x == least[root] && isSmaller(face, best))) {
			best = face;
			least[root] = x;
		}
	});
}

Status Finder::numberSubSurfaces() {
	std::vector<std::uint32_t> order;  // the smallest faces
	for (const std::uint32_t face : smallest_) {
		if (face != kNoFace) {
			order.push_back(face);
		}
	}
	std::sort(order.begin(), order.end(),
	          [this](std::uint32_t a, std::uint32_t b) { return isSmaller(a, b); });
	const auto ofRoot = makeHuge<SubSurfaceId>(complex_.faces.size());
	for (const std::uint32_t face : order) {
		const SubSurfaceId id = makeId<SubSurfaceTag>(out_.all.size());
		SubSurface surface{};
		surface.number = {-1, -1};
		for (std::size_t operand = 0; operand < 2; ++operand) {
			if (complex_.faces[face].sources[operand] != FaceId::none()) {
				surface.number[operand] = static_cast<std::int32_t>(out_.ofOperand[operand].size());
				out_.ofOperand[operand].push_back(id);
			}
		}
		const Triangle& corners = complex_.faces[face].corners;
		const Triangle ordered = inOrder(face);
		const auto first = std::find(corners.begin(), corners.end(), ordered[0]) - corners.begin();
		const auto second = static_cast<std::size_t>(nextCorner(static_cast<int>(first)));
		surface.frontFirst = corners[second] != ordered[1];
		surface.oneSided = sides_.root(2 * face) == sides_.root(2 * face + 1);
		ofRoot[rootOf(face)] = id;
		out_.all.push_back(surface);
	}
	resizeHuge(out_.ofFace, complex_.faces.size());
	out_.turned.resize(complex_.faces.size());
	return forEachFace([&](std::uint32_t face) {
		const std::uint32_t root = rootOf(face);
		out_.ofFace[face] = ofRoot[root];
		out_.turned[face] = isTurned(face) != isTurned(smallest_[root]) ? 1 : 0;
		++at(out_.all, ofRoot[root]).faceCount;
	});
}

// The smallest face comes first.
Status Finder::listFaces() {
	std::uint32_t first = 0;
	std::vector<std::uint32_t> next;
	for (SubSurface& surface : out_.all) {
		surface.firstFace = first;
		next.push_back(first + 1);
		first += surface.faceCount;
	}
	resizeHuge(out_.faces, first);
	return forEachFace([&](std::uint32_t face) {
		const SubSurfaceId id = out_.ofFace[face];
		const bool isFirst = smallest_[rootOf(face)] == face;
		out_.faces[isFirst ? at(out_.all, id).firstFace : at(next, id)++] = face;
	});
}

// Sums in fixed chunks of the list of faces; a chunk has a part of one sub-surface or of several.
Status Finder::measure() {
	struct Part {
		SubSurfaceId of;
		SurfaceSums sums;
	};
	const int threads = arrangement_.options.threads;
	const Points& points = arrangement_.mesh.points;
	BoundingBox box{};
	Status status = findBoundingBox(points.data(), points.size(), threads, monitor_, box);
	out_.frame = makeSumFrame(box);
	std::vector<std::vector<Part>> chunks(chunkCount(out_.faces.size(), kGrain));
	const auto sumChunk = [&](std::size_t chunk, std::size_t begin, std::size_t end) {
		for (std::size_t i = begin; i < end; ++i) {
			const std::uint32_t face = out_.faces[i];
			if (chunks[chunk].empty() || chunks[chunk].back().of != out_.ofFace[face]) {
				chunks[chunk].push_back({out_.ofFace[face], {}});
			}
			std::array<Point, 3> p{};
			for (std::size_t k = 0; k < 3; ++k) {
				p[k] = out_.frame.map(arrangement_.coordinates(complex_.faces[face].corners[k]));
			}
			const bool turned = out_.turned[face] != 0;
			addTriangle(p[0], turned ? p[2] : p[1], turned ? p[1] : p[2],
			            chunks[chunk].back().sums);
		}
	};
	if (status.ok()) {
		status = parallelForChunks(out_.faces.size(), kGrain, threads, monitor_, sumChunk);
	}
	out_.sums.resize(out_.all.size());
	for (const std::vector<Part>& chunk : chunks) {
		for (const Part& part : chunk) {
			at(out_.sums, part.of).add(part.sums, 1);
		}
	}
	for (std::size_t i = 0; i < out_.all.size(); ++i) {
		out_.all[i].area = areaOf(out_.sums[i], out_.frame);
	}
	return status;
}

// Starts at the smallest point of the cycle, and there with the smallest next one.
void Finder::beginAtSmallest(BoundaryCycle& cycle) const {
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
BoundaryCycle Finder::trace(HalfEdgeId start, std::vector<std::uint8_t>& visited) const {
	BoundaryCycle cycle{out_.ofFace[start.value / 3], false, {}};
	const bool isTurned = out_.turned[start.value / 3] != 0;
	VertexId point = isTurned ? complex_.endOf(start) : complex_.beginOf(start);
	HalfEdgeId h = start;
	std::vector<std::pair<VertexId, VertexId>> edges;
	do {
		at(visited, h) = 1;
		cycle.points.push_back(point);
		edges.push_back(std::minmax(complex_.beginOf(h), complex_.endOf(h)));
		point = complex_.beginOf(h) == point ? complex_.endOf(h) : complex_.beginOf(h);
		h = complex_.turnAround(h, point);
	} while (h != start);
	std::sort(edges.begin(), edges.end());
	cycle.isSlit = edges.size() % 2 == 0;
	for (std::size_t i = 0; i + 1 < edges.size() && cycle.isSlit; i += 2) {
		cycle.isSlit = edges[i] == edges[i + 1];
	}
	beginAtSmallest(cycle);
	return cycle;
}

Status Finder::traceCycles() {
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

void Finder::listCycles() {
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
Status Finder::findSubSurfacesAtLoops() {
	for (const Loop& loop : arrangement_.loops) {
		std::vector<SubSurfaceId> found;
		if (const PartingEdge* edge = complex_.partingEdge(loop.points[0], loop.points[1])) {
			for (std::uint32_t i = edge->first; i < edge->first + edge->count; ++i) {
				found.push_back(out_.ofFace[complex_.halfEdges[i].value / 3]);
			}
		}
		std::sort(found.begin(), found.end());
		found.erase(std::unique(found.begin(), found.end()), found.end());
		out_.atLoop.push_back(std::move(found));
	}
	return {};
}

Status Finder::run() {
	Status status = buildComplex(arrangement_, ComplexOf::Everything, monitor_, out_.complex);
	for (const auto step : {&Finder::uniteSides, &Finder::findSmallestFaces,
	                        &Finder::numberSubSurfaces, &Finder::listFaces, &Finder::measure,
	                        &Finder::traceCycles, &Finder::findSubSurfacesAtLoops}) {
		if (status.ok()) {
			status = (this->*step)();
		}
	}
	return status;
}

}  // namespace

Status findSubSurfaces(const Arrangement& arrangement, Monitor& monitor, SubSurfaces& out) {
	out = SubSurfaces{};
	return Finder(arrangement, monitor, out).run();
}

}  // namespace index_boolean
