// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The lines along each axis lie in a grid, in which each face looks for those that pass its box.
// Rounding keeps order, so boxes of rounded corners leave no line out.
#include "vcg_ext/parts/line_hits.h"

#include "vcg_ext/arrange/places.h"
#include "vcg_ext/arrange/self_intersecting.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/exact/exact_sign.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace index_boolean {

namespace {

struct Range {
	double low, high;

	bool has(double x) const { return x >= low && x <= high; }
};

// Equal parts of a range; the larger a coordinate, the higher its part's number.
class Scale {
public:
	Scale() = default;
	Scale(Range range, std::size_t parts) : range_(range), last_(parts - 1) {
		const double perUnit = static_cast<double>(parts) / (range.high / 2 - range.low / 2);
		perUnit_ = std::isfinite(perUnit) ? perUnit : 0;
	}

	std::size_t partOf(double x) const {
		const double inside = std::min(std::max(x, range_.low), range_.high);
		const double part = (inside / 2 - range_.low / 2) * perUnit_;
		return part < static_cast<double>(last_) ? static_cast<std::size_t>(part) : last_;
	}

private:
	Range range_{0, 0};
	std::size_t last_ = 0;
	double perUnit_ = 0;
};

// The lines along one axis, in a square grid of about as many cells.
class Bundle {
public:
	void build(std::size_t axis, const std::vector<AxisLine>& lines) {
		u_ = (axis + 1) % 3;
		v_ = (axis + 2) % 3;
		for (std::uint32_t i = 0; i < lines.size(); ++i) {
			if (static_cast<std::size_t>(lines[i].axis) == axis) {
				sorted_.emplace_back(0, i);
			}
		}
		side_ = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(sorted_.size()))));
		if (sorted_.empty()) {
			return;
		}
		uScale_ = scaleOf(u_, lines);
		vScale_ = scaleOf(v_, lines);
		first_.assign(side_ * side_ + 1, 0);
		for (auto& [cell, line] : sorted_) {
			cell = uScale_.partOf(lines[line].place[u_]) * side_ +
			       vScale_.partOf(lines[line].place[v_]);
			++first_[cell + 1];
		}
		std::partial_sum(first_.begin(), first_.end(), first_.begin());
		std::sort(sorted_.begin(), sorted_.end());
	}

	// Calls visit(line) for each line with a place in the ranges.
	template <class Visit>
	void visit(Range u, Range v, const std::vector<AxisLine>& lines, Visit&& visitLine) const {
		const std::size_t lastRow = uScale_.partOf(u.high);
		for (std::size_t row = uScale_.partOf(u.low); row <= lastRow; ++row) {
			const std::size_t begin = first_[row * side_ + vScale_.partOf(v.low)];
			const std::size_t end = first_[row * side_ + vScale_.partOf(v.high) + 1];
			for (std::size_t i = begin; i < end; ++i) {
				const Point& place = lines[sorted_[i].second].place;
				if (u.has(place[u_]) && v.has(place[v_])) {
					visitLine(sorted_[i].second);
				}
			}
		}
	}

	bool empty() const { return sorted_.empty(); }

private:
	Scale scaleOf(std::size_t axis, const std::vector<AxisLine>& lines) const {
		const double first = lines[sorted_[0].second].place[axis];
		Range range{first, first};
		for (const auto& [cell, line] : sorted_) {
			range.low = std::min(range.low, lines[line].place[axis]);
			range.high = std::max(range.high, lines[line].place[axis]);
		}
		return {range, side_};
	}

	std::size_t u_ = 0, v_ = 0, side_ = 0;
	Scale uScale_, vScale_;
	std::vector<std::pair<std::size_t, std::uint32_t>> sorted_;  // cell, line
	std::vector<std::size_t> first_;                             // per cell, in sorted_
};

// A hit with its coordinate along the line, correctly rounded.
struct DeepHit {
	LineHit hit;
	double depth;
};

class Caster {
public:
	Caster(const Arrangement& arrangement, const SurfaceComplex& complex,
	       const std::vector<AxisLine>& lines)
	    : arrangement_(arrangement), complex_(complex), lines_(lines) {
		for (std::size_t axis = 0; axis < 3; ++axis) {
			bundles_[axis].build(axis, lines);
		}
	}

	// Adds the hits of one face.
	void hit(std::uint32_t face, std::vector<DeepHit>& out) const;
	// Compares where a line meets two faces: -1, 0, +1.
	int compare(const DeepHit& a, const DeepHit& b) const;

private:
	using Ends = std::array<Point, 2>;

	static Ends endsOf(const AxisLine& line);
	ExactPoint pointOn(std::uint32_t face, const Ends& ends) const;
	Range rangeOf(const Triangle& t, std::size_t axis) const {
		const double a = arrangement_.coordinates(t[0])[axis];
		const double b = arrangement_.coordinates(t[1])[axis];
		const double c = arrangement_.coordinates(t[2])[axis];
		return {std::min({a, b, c}), std::max({a, b, c})};
	}
	std::array<const Point*, 3> planeOf(std::uint32_t face) const {
		const Points& points = arrangement_.mesh.points;
		const Triangle& t = at(arrangement_.mesh.triangles, complex_.faces[face].source());
		return {&at(points, t[0]), &at(points, t[1]), &at(points, t[2])};
	}

	const Arrangement& arrangement_;
	const SurfaceComplex& complex_;
	const std::vector<AxisLine>& lines_;
	std::array<Bundle, 3> bundles_;
};

void Caster::hit(std::uint32_t face, std::vector<DeepHit>& out) const {
	const Triangle& t = complex_.faces[face].corners;
	for (std::size_t axis = 0; axis < 3; ++axis) {
		if (bundles_[axis].empty()) {
			continue;
		}
		const auto hitLine = [&](std::uint32_t line) {
			if (const int side = meets(arrangement_, lines_[line], t); side != 0) {
				const Ends ends = endsOf(lines_[line]);
				out.push_back({{line, face, side > 0}, pointOn(face, ends).rounded[axis]});
			}
		};
		bundles_[axis].visit(rangeOf(t, (axis + 1) % 3), rangeOf(t, (axis + 2) % 3), lines_,
		                     hitLine);
	}
}

// Two points of a line.
Caster::Ends Caster::endsOf(const AxisLine& line) {
	Ends ends{line.place, line.place};
	ends[0][static_cast<std::size_t>(line.axis)] = 0;
	ends[1][static_cast<std::size_t>(line.axis)] = 1;
	return ends;
}

// Where a line meets the plane of a face; borrows the ends.
ExactPoint Caster::pointOn(std::uint32_t face, const Ends& ends) const {
	const std::array<const Point*, 3> plane = planeOf(face);
	ExactPoint p = ExactPoint::linePlane({&ends[0], &ends[1], plane[0], plane[1], plane[2]});
	roundPoint(p);
	return p;
}

int Caster::compare(const DeepHit& a, const DeepHit& b) const {
	if (a.depth != b.depth) {
		return a.depth < b.depth ? -1 : 1;  // rounding keeps the order
	}
	const AxisLine& line = lines_[a.hit.line];
	const Ends ends = endsOf(line);
	int order = compareCoordinate(pointOn(a.hit.face, ends), pointOn(b.hit.face, ends), line.axis);
	for (const int along : {nextCorner(line.axis), previousCorner(line.axis)}) {
		order = order != 0
		            ? order
		            : compareSlopes(planeOf(a.hit.face), planeOf(b.hit.face), line.axis, along);
	}
	return order;
}

// Two faces that are not the same overlap here.
Status refuseOverlap(const Arrangement& arrangement, FaceId face) {
	const MeshArrays& mesh = arrangement.mesh;
	return selfIntersecting(arrangement, mesh.operandOf(face), {face},
	                        at(mesh.points, at(mesh.triangles, face)[0]));
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
	std::vector<std::vector<DeepHit>> chunks(chunkCount(complex.faces.size(), kGrain));
	Status status =
	    parallelForChunks(complex.faces.size(), kGrain, arrangement.options.threads, monitor,
	                      [&](std::size_t chunk, std::size_t begin, std::size_t end) {
		                      for (std::size_t face = begin; face < end; ++face) {
			                      caster.hit(static_cast<std::uint32_t>(face), chunks[chunk]);
		                      }
	                      });
	std::vector<DeepHit> found;
	for (const std::vector<DeepHit>& chunk : chunks) {
		found.insert(found.end(), chunk.begin(), chunk.end());
	}
	std::sort(found.begin(), found.end(), [&](const DeepHit& a, const DeepHit& b) {
		return a.hit.line != b.hit.line ? a.hit.line < b.hit.line : caster.compare(a, b) < 0;
	});
	hits.clear();
	for (std::size_t i = 0; i < found.size() && status.ok(); ++i) {
		const bool isFirst = i == 0 || found[i - 1].hit.line != found[i].hit.line;
		if (!isFirst && caster.compare(found[i - 1], found[i]) == 0) {
			status = refuseOverlap(arrangement, complex.faces[found[i].hit.face].source());
		}
		hits.push_back(found[i].hit);
	}
	return status;
}

}  // namespace index_boolean
