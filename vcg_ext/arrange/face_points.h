// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the lines of one face; out: the points of its planar problem, ranked from left to right, and
// their orientation. Guarantee: exact; nothing else asks geometry when a face is cut.
#pragma once

#include "vcg_ext/arrange/face_lines.h"
#include "vcg_ext/exact/exact_sign.h"
#include "vcg_ext/exact/in_circle.h"
#include "vcg_ext/exact/planar_sweep.h"

#include <algorithm>
#include <vector>

namespace index_boolean {

// A point of the planar problem and the face's edges that it lies on, as bits.
struct FacePoint {
	VertexId id;
	std::uint8_t onEdges;

	bool isCorner() const { return (onEdges & (onEdges - 1)) != 0; }
};

// The points of one face after another, in memory that is used again. A rank is a point's place in
// lexicographic order of the exact coordinates, projected along an axis.
class FacePoints final : public PlanarOrientation {
public:
	// Borrows the arrangement.
	explicit FacePoints(const Arrangement& arrangement) : arrangement_(arrangement) {}

	// Replaces the points by the face's corners, the points on its edges, the ends of its segments
	// and the vertices inside it, each once. They have no ranks yet. \return false if two points of
	// the border have one name. Throws std::bad_alloc. O(n log n).
	bool collect(const FaceLines& lines);

	// Replaces the points by these, in their order; copies may be among them. O(n).
	void take(const std::vector<VertexId>& points);

	// \param axis along which to project, as projectionAxis finds it
	// \return false if two points lie in one place: copies, or else an operand touches itself
	// there.
	//         Copies have ranks in the order in which they were taken.
	// Throws std::bad_alloc. O(n log n).
	bool rank(int axis);

	std::size_t size() const { return points_.size(); }
	std::size_t borderCount() const { return borderCount_; }  // of points on the face's edges
	const FacePoint& at(std::uint32_t rank) const { return points_[order_[rank]]; }

	// \pre one of the points, after collect. O(log n).
	std::uint32_t rankOf(VertexId id) const;
	// Of the i-th point, after take.
	std::uint32_t rankAt(std::size_t i) const { return rankOf_[i]; }
	// Which of the taken points has a rank.
	std::uint32_t indexAt(std::uint32_t rank) const { return order_[rank]; }

	// Two coordinates of each point, by rank, in the scalar in which they are delivered.
	const std::vector<PlanarPlace>& places() const { return places_; }

	// The orientation of three points by rank, see PlanarOrientation. Three on one edge of the
	// face are collinear by name.
	int operator()(std::uint32_t a, std::uint32_t b, std::uint32_t c) const override;

private:
	// A point by its first rounded coordinate.
	struct First {
		double x;
		std::uint32_t point;
	};

	void sortByPlace();
	void findPlaces();
	bool isBefore(std::uint32_t a, std::uint32_t b) const;
	ExactPoint exact(std::uint32_t i) const;
	int exactOrientation(std::uint32_t i, std::uint32_t j, std::uint32_t k) const;

	const Arrangement& arrangement_;
	int axis_ = 0;
	std::size_t borderCount_ = 0;
	std::vector<FacePoint> points_;      // by id, or as taken
	std::vector<PlanarPoint> rounded_;   // of each
	std::vector<First> firsts_;          // by rank
	std::vector<std::uint32_t> order_;   // by rank: which of the points it is
	std::vector<std::uint32_t> rankOf_;  // of each
	std::vector<PlanarPlace> places_;    // by rank
};

inline std::uint32_t FacePoints::rankOf(VertexId id) const {
	const auto it =
	    std::lower_bound(points_.begin(), points_.end(), id,
	                     [](const FacePoint& p, VertexId wanted) { return p.id < wanted; });
	return rankOf_[static_cast<std::size_t>(it - points_.begin())];
}

inline int FacePoints::operator()(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
	const std::uint32_t i = order_[a], j = order_[b], k = order_[c];
	if ((points_[i].onEdges & points_[j].onEdges & points_[k].onEdges) != 0) {
		return 0;
	}
	const int sign = orient2d(rounded_[i], rounded_[j], rounded_[k]);
	return sign != kUnknownSign ? sign : exactOrientation(i, j, k);
}

}  // namespace index_boolean
