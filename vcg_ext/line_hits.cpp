// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Each face looks for the lines that pass its box: along each axis those in its range by binary
// search. Rounding keeps order, so boxes of rounded corners leave no line out.
#include "line_hits.h"

#include "exact_sign.h"
#include "parallel.h"
#include "weld.h"

#include <algorithm>

namespace index_boolean {

namespace {

// The lines along one axis, sorted by the first of the coordinates that place them.
struct Bundle {
	std::vector<std::pair<double, std::uint32_t>> lines;
};

struct Range {
	double low, high;
};

class Caster {
public:
	Caster(const Arrangement& arrangement, const SurfaceComplex& complex,
	       const std::vector<AxisLine>& lines)
	    : arrangement_(arrangement), complex_(complex), lines_(lines) {
		for (std::uint32_t i = 0; i < lines.size(); ++i) {
			const auto u = static_cast<std::size_t>(nextCorner(lines[i].axis));
			bundles_[static_cast<std::size_t>(lines[i].axis)].lines.emplace_back(lines[i].place[u],
			                                                                     i);
		}
		for (Bundle& bundle : bundles_) {
			std::sort(bundle.lines.begin(), bundle.lines.end());
		}
	}

	// Adds the hits of one face.
	void hit(std::uint32_t face, std::vector<LineHit>& out) const;
	// Compares where a line meets two faces: -1, 0, +1.
	int compare(const LineHit& a, const LineHit& b) const;

private:
	Range rangeOf(const Triangle& t, std::size_t axis) const {
		const double a = arrangement_.coordinates(t[0])[axis];
		const double b = arrangement_.coordinates(t[1])[axis];
		const double c = arrangement_.coordinates(t[2])[axis];
		return {std::min({a, b, c}), std::max({a, b, c})};
	}
	std::array<const Point*, 3> planeOf(std::uint32_t face) const {
		const std::vector<Point>& points = arrangement_.mesh.points;
		const Triangle& t = at(arrangement_.mesh.triangles, complex_.faces[face].source());
		return {&at(points, t[0]), &at(points, t[1]), &at(points, t[2])};
	}

	const Arrangement& arrangement_;
	const SurfaceComplex& complex_;
	const std::vector<AxisLine>& lines_;
	std::array<Bundle, 3> bundles_;
};

void Caster::hit(std::uint32_t face, std::vector<LineHit>& out) const {
	const Triangle& t = complex_.faces[face].corners;
	for (std::size_t axis = 0; axis < 3; ++axis) {
		const auto& lines = bundles_[axis].lines;
		if (lines.empty()) {
			continue;
		}
		const Range u = rangeOf(t, (axis + 1) % 3);
		const Range v = rangeOf(t, (axis + 2) % 3);
		auto it = std::lower_bound(lines.begin(), lines.end(), std::make_pair(u.low, 0u));
		for (; it != lines.end() && it->first <= u.high; ++it) {
			const AxisLine& line = lines_[it->second];
			const double place = line.place[(axis + 2) % 3];
			if (place < v.low || place > v.high) {
				continue;
			}
			if (const int side = meets(arrangement_, line, t); side != 0) {
				out.push_back({it->second, face, side > 0});
			}
		}
	}
}

int Caster::compare(const LineHit& a, const LineHit& b) const {
	const AxisLine& line = lines_[a.line];
	Point low = line.place, high = line.place;
	low[static_cast<std::size_t>(line.axis)] = 0;
	high[static_cast<std::size_t>(line.axis)] = 1;
	const std::array<const Point*, 3> planeA = planeOf(a.face), planeB = planeOf(b.face);
	ExactPoint p = ExactPoint::linePlane({&low, &high, planeA[0], planeA[1], planeA[2]});
	ExactPoint q = ExactPoint::linePlane({&low, &high, planeB[0], planeB[1], planeB[2]});
	roundPoint(p);
	roundPoint(q);
	int order = compareCoordinate(p, q, line.axis);
	for (const int along : {nextCorner(line.axis), previousCorner(line.axis)}) {
		order = order != 0 ? order : compareSlopes(planeA, planeB, line.axis, along);
	}
	return order;
}

}  // namespace

int sideOfLine(const Arrangement& arrangement, VertexId a, VertexId b, const AxisLine& line) {
	const ExactPoint p = exactPoint(arrangement, a), q = exactPoint(arrangement, b);
	const int side = orient2d(p, q, ExactPoint::explicitPoint(line.place), line.axis);
	if (side != 0) {
		return side;
	}
	// The derivative by the first coordinate of the place is p_v - q_v, by the second q_u - p_u.
	const int first = compareCoordinate(p, q, previousCorner(line.axis));
	return first != 0 ? first : compareCoordinate(q, p, nextCorner(line.axis));
}

int meets(const Arrangement& arrangement, const AxisLine& line, const Triangle& t) {
	const int side = sideOfLine(arrangement, t[0], t[1], line);
	const bool inside = side != 0 && sideOfLine(arrangement, t[1], t[2], line) == side &&
	                    sideOfLine(arrangement, t[2], t[0], line) == side;
	return inside ? side : 0;
}

Status castLines(const Arrangement& arrangement, const SurfaceComplex& complex,
                 const std::vector<AxisLine>& lines, Monitor& monitor, std::vector<LineHit>& hits) {
	constexpr std::size_t kGrain = 1 << 14;
	const Caster caster(arrangement, complex, lines);
	std::vector<std::vector<LineHit>> chunks(chunkCount(complex.faces.size(), kGrain));
	Status status =
	    parallelForChunks(complex.faces.size(), kGrain, arrangement.options.threads, monitor,
	                      [&](std::size_t chunk, std::size_t begin, std::size_t end) {
		                      for (std::size_t face = begin; face < end; ++face) {
			                      caster.hit(static_cast<std::uint32_t>(face), chunks[chunk]);
		                      }
	                      });
	hits.clear();
	for (const std::vector<LineHit>& chunk : chunks) {
		hits.insert(hits.end(), chunk.begin(), chunk.end());
	}
	std::sort(hits.begin(), hits.end(), [&](const LineHit& a, const LineHit& b) {
		return a.line != b.line ? a.line < b.line : caster.compare(a, b) < 0;
	});
	for (std::size_t i = 0; i + 1 < hits.size() && status.ok(); ++i) {
		if (hits[i].line == hits[i + 1].line && caster.compare(hits[i], hits[i + 1]) == 0) {
			const FaceId source = complex.faces[hits[i].face].source();
			status.code = StatusCode::SelfIntersecting;
			status.operand = arrangement.mesh.operandOf(source);
			status.count = 1;
			status.faces = {arrangement.givenFace(source)};
			status.hasPlace = true;
			status.place = at(arrangement.mesh.points, at(arrangement.mesh.triangles, source)[0]);
		}
	}
	return status;
}

}  // namespace index_boolean
