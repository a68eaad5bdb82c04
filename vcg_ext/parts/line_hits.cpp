// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Faces that lie above no start, so far as boxes tell, are left out at once: with few lines nearly
// all. Of the others each line asks the lowest first, and none that begin above its first hit.
#include "vcg_ext/parts/line_hits.h"

#include "vcg_ext/arrange/places.h"
#include "vcg_ext/arrange/self_intersecting.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/parts/axis_lines.h"

#include <algorithm>
#include <limits>

namespace index_boolean {

namespace {

// What one line has met so far.
struct Met {
	std::uint32_t line;
	AxisLine upwards;
	std::vector<std::uint32_t> near;  // faces of the complex whose planes hold the start's corner
	std::uint32_t far = kNone;        // the first one beyond
	double limit = std::numeric_limits<double>::infinity();  // what begins above is not the first
};

class Caster {
public:
	Caster(const Arrangement& arrangement, const SurfaceComplex& complex,
	       const std::vector<LineStart>& starts, Monitor& monitor)
	    : arrangement_(arrangement), complex_(complex), starts_(starts), monitor_(monitor) {}

	Status run(std::vector<LineHit>& hits);

private:
	// The hits of some lines, and a face that overlaps another there, or kNone.
	struct Found {
		std::vector<LineHit> hits;
		std::uint32_t overlap = kNone;
	};

	Status findCandidates();
	void cast(std::uint32_t line, Found& found) const;
	bool take(std::uint32_t face, Met& met) const;
	bool append(Met& met, Found& found) const;
	AxisLine lineFrom(const LineStart& start) const;
	Status refuseOverlap(std::uint32_t face) const;

	const Triangle& cornersOf(std::uint32_t face) const { return complex_.faces[face].corners; }
	const Point& beginOf(const LineStart& start) const {
		return arrangement_.coordinates(cornersOf(start.face)[start.corner]);
	}
	BoundingBox boxOf(std::uint32_t face) const {
		const Triangle& t = cornersOf(face);
		return boxOfThree(arrangement_.coordinates(t[0]), arrangement_.coordinates(t[1]),
		                  arrangement_.coordinates(t[2]));
	}
	PlaneCorners planeOf(std::uint32_t face) const {
		const Points& points = arrangement_.mesh.points;
		const Triangle& t = at(arrangement_.mesh.triangles, complex_.faces[face].source);
		return {&at(points, t[0]), &at(points, t[1]), &at(points, t[2])};
	}
	int facingOf(std::uint32_t face, const AxisLine& line) const {
		const Triangle& t = cornersOf(face);
		return meets({exactPoint(arrangement_, t[0]), exactPoint(arrangement_, t[1]),
		              exactPoint(arrangement_, t[2])},
		             line);
	}
	FaceOnLine onLine(std::uint32_t face, const AxisLine& line) const {
		return {planeOf(face), facingOf(face, line)};
	}

	const Arrangement& arrangement_;
	const SurfaceComplex& complex_;
	const std::vector<LineStart>& starts_;
	Monitor& monitor_;
	std::vector<std::uint32_t> candidates_;  // faces of the complex
	BoxTree tree_;                           // over the candidates
};

// The faces above any start.
Status Caster::findCandidates() {
	constexpr std::size_t kGrain = 1 << 14;
	Points begins;
	for (const LineStart& start : starts_) {
		begins.push_back(beginOf(start));
	}
	const LineField field(kLineAxis, begins);
	std::vector<std::vector<std::uint32_t>> chunks(chunkCount(complex_.faces.size(), kGrain));
	const auto list = [&](std::size_t chunk, std::size_t begin, std::size_t end) {
		for (std::size_t f = begin; f < end; ++f) {
			const auto face = static_cast<std::uint32_t>(f);
			if (field.anyBelow(boxOf(face))) {
				chunks[chunk].push_back(face);
			}
		}
	};
	const Status status = parallelForChunks(complex_.faces.size(), kGrain,
	                                        arrangement_.options.threads, monitor_, list);
	for (const std::vector<std::uint32_t>& chunk : chunks) {
		candidates_.insert(candidates_.end(), chunk.begin(), chunk.end());
	}
	std::vector<BoundingBox> boxes;
	boxes.reserve(candidates_.size());
	for (const std::uint32_t face : candidates_) {
		boxes.push_back(boxOf(face));
	}
	tree_ = BoxTree(std::move(boxes));
	return status;
}

AxisLine Caster::lineFrom(const LineStart& start) const {
	const Triangle& t = cornersOf(start.face);
	const std::uint32_t k = start.corner;
	return {kLineAxis,
	        {exactPoint(arrangement_, t[k]), exactPoint(arrangement_, t[(k + 1) % 3]),
	         exactPoint(arrangement_, t[(k + 2) % 3])}};
}

// Looks at one face for one line. \return false if the start lies on it
bool Caster::take(std::uint32_t face, Met& met) const {
	const AxisLine& line = met.upwards;
	const int facing = facingOf(face, line);
	if (facing == 0) {
		return true;
	}
	const PlaneCorners plane = planeOf(face);
	const int side = sideOfPlane(plane, line);
	if (side == 0 || side == facing) {
		return side != 0;  // on it, or above it
	}
	if (orient3d(plane, line.near[0]) == 0) {
		met.near.push_back(face);
	} else if (met.far == kNone || compareAlong({plane, facing}, onLine(met.far, line), line) < 0) {
		met.far = face;
		met.limit = std::min(met.limit, boxOf(face).hi[kLineAxis]);
	}
	return true;
}

// Adds a line's hits in their order. \return false if two are in one place
bool Caster::append(Met& met, Found& found) const {
	std::vector<std::pair<FaceOnLine, std::uint32_t>> sorted;
	for (const std::uint32_t face : met.near) {
		sorted.emplace_back(onLine(face, met.upwards), face);
	}
	const auto compare = [&met](const auto& a, const auto& b) {
		return compareAlong(a.first, b.first, met.upwards);
	};
	std::sort(sorted.begin(), sorted.end(),
	          [&](const auto& a, const auto& b) { return compare(a, b) < 0; });
	const std::uint32_t start = starts_[met.line].face;
	found.hits.push_back({met.line, start, facingOf(start, met.upwards) > 0, false});
	for (std::size_t i = 0; i < sorted.size(); ++i) {
		if (i > 0 && compare(sorted[i - 1], sorted[i]) == 0) {
			return false;
		}
		found.hits.push_back({met.line, sorted[i].second, sorted[i].first.facing > 0, false});
	}
	if (met.far != kNone) {
		found.hits.push_back({met.line, met.far, facingOf(met.far, met.upwards) > 0, true});
	}
	return true;
}

void Caster::cast(std::uint32_t line, Found& found) const {
	const LineStart& start = starts_[line];
	Met met{line, lineFrom(start), {}};
	const BoundingBox begin{beginOf(start), beginOf(start)};
	std::uint32_t overlap = kNone;
	const auto enters = [&](const BoundingBox& box) {
		return mayMeet(kLineAxis, begin, box) && box.lo[kLineAxis] <= met.limit;
	};
	tree_.visit(kLineAxis, enters, [&](std::uint32_t candidate) {
		const std::uint32_t face = candidates_[candidate];
		if (face != start.face && !take(face, met)) {
			overlap = std::min(overlap, face);
		}
	});
	if (!append(met, found)) {
		overlap = std::min(overlap, met.near[0]);
	}
	found.overlap = std::min(found.overlap, overlap);
}

// Two faces that are not the same overlap here.
Status Caster::refuseOverlap(std::uint32_t face) const {
	const FaceId source = complex_.faces[face].source;
	const MeshArrays& mesh = arrangement_.mesh;
	return selfIntersecting(arrangement_, mesh.operandOf(source), {source},
	                        at(mesh.points, at(mesh.triangles, source)[0]));
}

Status Caster::run(std::vector<LineHit>& hits) {
	constexpr std::size_t kGrain = 1 << 6;
	std::vector<Found> chunks(chunkCount(starts_.size(), kGrain));
	Status status = findCandidates();
	if (status.ok()) {
		status = parallelForChunks(starts_.size(), kGrain, arrangement_.options.threads, monitor_,
		                           [&](std::size_t chunk, std::size_t begin, std::size_t end) {
			                           for (std::size_t line = begin; line < end; ++line) {
				                           cast(static_cast<std::uint32_t>(line), chunks[chunk]);
			                           }
		                           });
	}
	hits.clear();
	for (std::size_t i = 0; i < chunks.size() && status.ok(); ++i) {
		hits.insert(hits.end(), chunks[i].hits.begin(), chunks[i].hits.end());
		if (chunks[i].overlap != kNone) {
			status = refuseOverlap(chunks[i].overlap);
		}
	}
	return status;
}

}  // namespace

Status findLineHits(const Arrangement& arrangement, const SurfaceComplex& complex,
                    const std::vector<LineStart>& starts, Monitor& monitor,
                    std::vector<LineHit>& hits) {
	return Caster(arrangement, complex, starts, monitor).run(hits);
}

}  // namespace index_boolean
