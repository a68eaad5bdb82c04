// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: points; out: their box. Minima and maxima of fixed chunks, then of the chunks.
#include "vcg_ext/exact/bounding_box.h"

#include "vcg_ext/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace index_boolean {

namespace {

constexpr std::size_t kGrain = 16384;
constexpr double kMax = std::numeric_limits<double>::max();

// The box of those coordinates that `counts` accepts.
template <class Counts>
BoundingBox boxOf(const Point* begin, const Point* end, Counts counts) {
	BoundingBox box = emptyBox();
	for (const Point* point = begin; point != end; ++point) {
		for (std::size_t axis = 0; axis < 3; ++axis) {
			const double x = (*point)[axis];
			if (counts(x)) {
				box.lo[axis] = x < box.lo[axis] ? x : box.lo[axis];
				box.hi[axis] = x > box.hi[axis] ? x : box.hi[axis];
			}
		}
	}
	return box;
}

bool isFinite(const BoundingBox& box) {
	const auto isNumber = [](double x) { return x >= -kMax && x <= kMax; };
	return std::all_of(box.lo.begin(), box.lo.end(), isNumber) &&
	       std::all_of(box.hi.begin(), box.hi.end(), isNumber);
}

// NaN passes, since comparisons with it are false; only an infinity in the box, which nearly no
// mesh has, asks for a second look.
BoundingBox finiteBoxOf(const Point* begin, const Point* end) {
	const BoundingBox box = boxOf(begin, end, [](double) { return true; });
	return isFinite(box) ? box : boxOf(begin, end, [](double x) { return std::fabs(x) <= kMax; });
}

}  // namespace

Point BoundingBox::centre() const {
	return {lo[0] / 2 + hi[0] / 2, lo[1] / 2 + hi[1] / 2, lo[2] / 2 + hi[2] / 2};
}

double BoundingBox::halfSize() const {
	return std::max({hi[0] / 2 - lo[0] / 2, hi[1] / 2 - lo[1] / 2, hi[2] / 2 - lo[2] / 2});
}

BoundingBox joinedBox(const BoundingBox* boxes, std::size_t count) {
	BoundingBox joined = emptyBox();
	for (std::size_t i = 0; i < count; ++i) {
		for (std::size_t axis = 0; axis < 3; ++axis) {
			joined.lo[axis] = std::min(joined.lo[axis], boxes[i].lo[axis]);
			joined.hi[axis] = std::max(joined.hi[axis], boxes[i].hi[axis]);
		}
	}
	return joined;
}

Status findBoundingBox(const Point* points, std::size_t count, int threads, Monitor& monitor,
                       BoundingBox& out) {
	std::vector<BoundingBox> parts(chunkCount(count, kGrain), emptyBox());
	const Status status =
	    parallelForChunks(count, kGrain, threads, monitor,
	                      [&](std::size_t chunk, std::size_t begin, std::size_t end) {
		                      parts[chunk] = finiteBoxOf(points + begin, points + end);
	                      });
	out = joinedBox(parts.data(), parts.size());
	return status;
}

BoundingBox commonBox(const BoundingBox& a, const BoundingBox& b) {
	BoundingBox common{};
	for (std::size_t axis = 0; axis < 3; ++axis) {
		common.lo[axis] = std::max(a.lo[axis], b.lo[axis]);
		common.hi[axis] = std::min(a.hi[axis], b.hi[axis]);
	}
	return common;
}

}  // namespace index_boolean
