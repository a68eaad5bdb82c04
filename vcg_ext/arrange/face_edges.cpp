// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Segments are named before the border, so that an interval along which the curve runs is known as
// the segment that it is.
#include "vcg_ext/arrange/face_edges.h"

namespace index_boolean {

void FaceEdges::reset(std::size_t most) {
	edges_.clear();
	edges_.reserve(most);
	most_ = most;
	unsigned bits = 2;
	while (std::size_t{1} << bits < 2 * most) {
		++bits;
	}
	shift_ = 64 - bits;
	slots_.assign(std::size_t{1} << bits, 0);
}

bool FaceEdges::fixSegments(const Curve& curve, const FaceLines& lines, const FacePoints& points) {
	for (const FaceSegment& s : lines.segments) {
		const Segment& segment = at(curve.segments, s.segment);
		const std::uint32_t from = points.rankOf(segment.begin);
		const std::uint32_t to = points.rankOf(segment.end);
		FaceEdge* edge = named(from, to);
		if (edge == nullptr || edge->isFixed) {
			return false;
		}
		edge->isFixed = true;
		edge->isRising = from < to;
		edge->segment = s.segment;
	}
	return true;
}

bool FaceEdges::fixSide(const Arrangement& arrangement, const FaceSide& side,
                        const FacePoints& points) {
	std::uint32_t to = points.rankOf(side.points[0]);
	for (std::size_t i = 0; i + 1 < side.points.size(); ++i) {
		const std::uint32_t from = to;
		to = points.rankOf(side.points[i + 1]);
		FaceEdge* edge = named(from, to);
		if (edge == nullptr) {
			return false;
		}
		edge->isBorder = true;
		if (edge->isFixed) {
			continue;  // a segment
		}
		edge->isFixed = true;
		edge->interval = intervalNode(arrangement, side, i);
	}
	return true;
}

bool FaceEdges::fix(const Arrangement& arrangement, const FaceLines& lines,
                    const FacePoints& points, std::size_t most) {
	reset(most);
	bool isFixed = fixSegments(arrangement.curve, lines, points);
	for (const FaceSide& side : lines.sides) {
		isFixed = isFixed && fixSide(arrangement, side, points);
	}
	fixedCount_ = edges_.size();
	return isFixed;
}

}  // namespace index_boolean
