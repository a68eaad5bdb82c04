// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the curve; out: what one touched face has to respect: the points on its three edges, in
// order, and the segments and vertices inside it. Guarantee: by index alone.
#pragma once

#include "vcg_ext/arrange/arrangement.h"

#include <array>
#include <vector>

namespace index_boolean {

// Neighbours in an array, which it borrows.
template <class T>
struct ConstRange {
	const T* first;
	const T* last;

	const T* begin() const { return first; }
	const T* end() const { return last; }
};

// One edge of a face, the way the face runs.
struct FaceSide {
	std::vector<VertexId> points;  // a corner, the points on the edge, the next corner
	const CutEdge* cut = nullptr;  // the edge among the curve's, or null if it is none of them

	// The number, among the curve's, of the interval from points[i] to the next. \pre cut
	std::uint32_t interval(std::size_t i) const {
		const bool isReversed = points.back() < points.front();
		const std::size_t fromLow = isReversed ? points.size() - 2 - i : i;
		return cut->firstInterval + static_cast<std::uint32_t>(fromLow);
	}
};

// What one face has to respect.
struct FaceLines {
	FaceId face;
	std::array<FaceSide, 3> sides;  // from corner i on
	ConstRange<FaceSegment> segments;
	ConstRange<FaceVertex> vertices;  // inside the face; ends of segments or not

	// Nothing is on the face but its corners.
	bool areEmpty() const;
};

// The node of the interval from points[i] of a side to the next, which has one of its own if both
// are on the other operand and the interval is not known to lie on it; else none.
// \pre no segment runs along the interval. Complexity: O(1).
NodeId intervalNode(const Arrangement& arrangement, const FaceSide& side, std::size_t i);

// The segments on a face, in order. Borrows the curve.
// Complexity: O(log s) for s segments on all faces.
ConstRange<FaceSegment> segmentsOn(const Curve& curve, FaceId face);

// Finds the lines of one face after another. Any thread may ask.
class FaceLineFinder {
public:
	// Borrows the arrangement, whose curve is complete. O(n + c) for n vertices and c cut edges.
	// Throws std::bad_alloc.
	explicit FaceLineFinder(const Arrangement& arrangement);

	// \param face  a touched one
	// \param lines replaced; their memory is used again. They borrow the curve
	// Throws std::bad_alloc. Complexity: O(k + log s) for k points on the face's edges and s
	// segments on all faces; finding a cut edge takes O(1) unless many have about the same end.
	void find(FaceId face, FaceLines& lines) const;

private:
	std::size_t bucketOf(VertexId low) const { return low.value >> shift_; }
	const CutEdge* cutEdge(VertexId a, VertexId b) const;
	void findSide(VertexId from, VertexId to, FaceSide& side) const;

	const Arrangement& arrangement_;
	unsigned shift_ = 0;
	std::vector<std::uint32_t> firsts_;  // cut edges per bucket of lower ends; the end of all last
};

}  // namespace index_boolean
