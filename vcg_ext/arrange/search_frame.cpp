// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: faces; out: their corners as floats. One pass over the faces for the box of the corners and
// their range of indices, since a vertex that no face has may be anywhere; one over the points.
#include "vcg_ext/arrange/search_frame.h"

#include "vcg_ext/arrange/frame_axes.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/base/vectors.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace index_boolean {

namespace {

constexpr std::size_t kGrain = 1 << 15;

// What the corners of some faces cover.
struct Extent {
	BoundingBox box = emptyBox();
	std::uint32_t lowest = kNone, highest = 0;
};

Extent extentOf(const FacesView& faces, std::size_t begin, std::size_t end) {
	Extent extent;
	for (std::size_t face = begin; face < end; ++face) {
		for (const std::uint32_t v : faces[face]) {
			extent.box.add(faces.point(v));
			extent.lowest = std::min(extent.lowest, v);
			extent.highest = std::max(extent.highest, v);
		}
	}
	return extent;
}

Status findExtent(const FacesView& faces, int threads, Monitor& monitor, Extent& out) {
	std::vector<Extent> parts(chunkCount(faces.count(), kGrain));
	const Status status =
	    parallelForChunks(faces.count(), kGrain, threads, monitor,
	                      [&](std::size_t chunk, std::size_t begin, std::size_t end) {
		                      parts[chunk] = extentOf(faces, begin, end);
	                      });
	for (const Extent& part : parts) {
		const std::array<BoundingBox, 2> both{out.box, part.box};
		out.box = joinedBox(both.data(), both.size());
		out.lowest = std::min(out.lowest, part.lowest);
		out.highest = std::max(out.highest, part.highest);
	}
	return status;
}

// The map of a box to a cube from -1 to 1: what it takes off each coordinate, a power of two, and
// axes if they are not the given ones.
struct Frame {
	Point centre;
	double scale;
	std::optional<Axes> axes{};

	Point map(const Point& point) const {
		const Point p = times(minus(point, centre), scale);
		return axes ? Point{dot((*axes)[0], p), dot((*axes)[1], p), dot((*axes)[2], p)} : p;
	}
};

// The centre is rounded, so that the sides' distances from it may differ; no number in the box is
// farther from it, as rounded, than they are.
Frame frameOf(const BoundingBox& box) {
	const Point centre = box.centre();
	double reach = 0;
	for (std::size_t axis = 0; axis < 3; ++axis) {
		reach = std::max({reach, box.hi[axis] - centre[axis], centre[axis] - box.lo[axis]});
	}
	int exponent = 0;
	std::frexp(reach, &exponent);
	return {centre, std::ldexp(1.0, std::min(-exponent, 1000))};  // a larger power is no double
}

}  // namespace

Status placeInFrame(SearchedSurface& surface, Monitor& monitor) {
	const FacesView& faces = surface.faces;
	FramePoints& out = surface.points;
	Extent extent;
	Status status = findExtent(faces, surface.threads, monitor, extent);
	if (!status.ok() || faces.count() == 0) {
		out.points.clear();
		return status;
	}
	Frame frame = frameOf(extent.box);
	frame.axes = guessFrameAxes(faces, extent.box, frame.scale);
	surface.boxMargin = frame.axes ? 0x1p-23F : 0.0F;
	frame.scale /= frame.axes ? 2 : 1;  // so that a turned cube's corners stay within 1
	out.first = extent.lowest;
	out.points.resizeForOverwrite(std::size_t{extent.highest} + 1 - extent.lowest);
	return parallelFor(out.points.size(), kGrain, surface.threads, monitor,
	                   [&](std::size_t begin, std::size_t end) {
		                   const Point* const from = faces.points().data() + extent.lowest;
		                   for (std::size_t i = begin; i < end; ++i) {
			                   const Point place = frame.map(from[i]);
			                   for (std::size_t axis = 0; axis < 3; ++axis) {
				                   out.points[i].place[axis] = static_cast<float>(place[axis]);
			                   }
		                   }
	                   });
}

}  // namespace index_boolean
