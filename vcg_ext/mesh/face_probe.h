// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: some faces and a length; out: how far points are from the nearest face, as far as that is not
// beyond the length, and whether whole segments are within it. By doubles.
#pragma once

#include "vcg_ext/exact/box_tree.h"
#include "vcg_ext/mesh/mesh_arrays.h"

#include <vector>

namespace index_boolean {

// How far a point is from a triangle. Complexity: O(1).
double distanceToTriangle(const Point& p, const std::array<Point, 3>& t);

class FaceProbe {
public:
	// \param points borrowed \param faces of these \param reach the greatest length that is asked
	// for Throws std::bad_alloc. Complexity: O(n log n).
	FaceProbe(const Points& points, std::vector<IndexTriangle> faces, double reach);

	// How far a point is from the nearest face; infinite if that is beyond reach.
	// Complexity: O(log n) for most surfaces.
	double distanceTo(const Point& p) const;

	// Whether each point of a segment is within a length of a face. A face is convex: where both
	// ends are that near to one, all between them is, too; else each half is asked.
	// \param length at most reach. Complexity: some 50 times the above for each face along it.
	bool isSegmentWithin(const Point& a, const Point& b, double length) const;

private:
	std::array<Point, 3> cornersOf(std::uint32_t face) const;
	template <class Visit>
	void visitNear(const Point& p, Visit&& visit) const;
	bool isWithin(const Point& a, const Point& b, double length, int depth) const;

	const Points& points_;
	std::vector<IndexTriangle> faces_;
	BoxTree tree_;  // of their boxes, each wider by reach on all sides
};

}  // namespace index_boolean
