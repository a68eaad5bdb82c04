// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rounded coordinates are asked first; what they leave in doubt, the exact points decide.
#include "vcg_ext/arrange/face_points.h"

#include "vcg_ext/arrange/places.h"

#include <algorithm>

namespace index_boolean {

bool FacePoints::collect(const FaceLines& lines) {
	points_.clear();
	for (int i = 0; i < 3; ++i) {
		const std::vector<VertexId>& side = lines.sides[static_cast<std::size_t>(i)].points;
		const auto onEdge = static_cast<std::uint8_t>(1 << i);
		const auto atCorner = static_cast<std::uint8_t>(onEdge | 1 << previousCorner(i));
		points_.push_back({side.front(), atCorner});
		for (std::size_t k = 1; k + 1 < side.size(); ++k) {
			points_.push_back({side[k], onEdge});
		}
	}
	borderCount_ = points_.size();
	for (const FaceSegment& s : lines.segments) {
		const Segment& segment = index_boolean::at(arrangement_.curve.segments, s.segment);
		points_.push_back({segment.begin, 0});
		points_.push_back({segment.end, 0});
	}
	for (const FaceVertex& inside : lines.vertices) {
		points_.push_back({inside.vertex, 0});
	}
	// Of equal ids the entry from the border comes first and stays.
	std::sort(points_.begin(), points_.end(), [](const FacePoint& a, const FacePoint& b) {
		return a.id != b.id ? a.id < b.id : a.onEdges > b.onEdges;
	});
	bool isBorderSimple = true;
	const auto isSame = [&isBorderSimple](const FacePoint& a, const FacePoint& b) {
		const bool isOnce = a.onEdges == 0 || b.onEdges == 0;
		isBorderSimple = isBorderSimple && (a.id != b.id || isOnce);
		return a.id == b.id;
	};
	points_.erase(std::unique(points_.begin(), points_.end(), isSame), points_.end());
	return isBorderSimple;
}

void FacePoints::take(const std::vector<VertexId>& points) {
	points_.clear();
	borderCount_ = 0;
	for (const VertexId v : points) {
		points_.push_back({v, 0});
	}
}

ExactPoint FacePoints::exact(std::uint32_t i) const {
	return exactPoint(arrangement_, points_[i].id);
}

// Whether a comes before b in lexicographic order. Rounding is monotone: rounded coordinates that
// differ have the order of the exact ones.
bool FacePoints::isBefore(std::uint32_t a, std::uint32_t b) const {
	if (rounded_[a].x.value != rounded_[b].x.value) {
		return rounded_[a].x.value < rounded_[b].x.value;
	}
	const ExactPoint p = exact(a), q = exact(b);
	const int order = compareCoordinate(p, q, nextCorner(axis_));
	return order != 0 ? order < 0 : compareCoordinate(p, q, previousCorner(axis_)) < 0;
}

void FacePoints::findPlaces() {
	const bool isRounded = arrangement_.options.outputScalar == OutputScalar::Double &&
	                       arrangement_.movedPlaces.empty();
	places_.clear();
	for (const std::uint32_t i : order_) {
		if (isRounded) {
			places_.push_back({rounded_[i].x.value, rounded_[i].y.value});
		} else {
			const Point stored = outputCoordinates(arrangement_, points_[i].id);
			places_.push_back({stored[static_cast<std::size_t>(nextCorner(axis_))],
			                   stored[static_cast<std::size_t>(previousCorner(axis_))]});
		}
	}
}

// By the first rounded coordinate, kept beside each point, where that tells.
void FacePoints::sortByPlace() {
	firsts_.clear();
	for (std::uint32_t i = 0; i < points_.size(); ++i) {
		firsts_.push_back({rounded_[i].x.value, i});
	}
	std::sort(firsts_.begin(), firsts_.end(), [this](const First& p, const First& q) {
		if (p.x != q.x) {
			return p.x < q.x;
		}
		const bool areOne = points_[p.point].id == points_[q.point].id;
		return areOne ? p.point < q.point : isBefore(p.point, q.point);
	});
	order_.clear();
	for (const First& first : firsts_) {
		order_.push_back(first.point);
	}
}

bool FacePoints::rank(int axis) {
	axis_ = axis;
	rounded_.clear();
	for (const FacePoint& p : points_) {
		const bool isExact = !arrangement_.isCurvePoint(p.id);
		rounded_.emplace_back(arrangement_.coordinates(p.id), isExact, axis);
	}
	sortByPlace();
	bool areApart = true;
	for (std::size_t i = 0; i + 1 < order_.size(); ++i) {
		areApart = areApart && isBefore(order_[i], order_[i + 1]);
	}
	rankOf_.resize(order_.size());
	for (std::uint32_t rank = 0; rank < order_.size(); ++rank) {
		rankOf_[order_[rank]] = rank;
	}
	findPlaces();
	return areApart;
}

int FacePoints::exactOrientation(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
	return orient2d(exact(i), exact(j), exact(k), axis_);
}

}  // namespace index_boolean
