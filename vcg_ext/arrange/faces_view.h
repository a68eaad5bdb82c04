// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The faces of one surface in a caller's arrays, whichever type their corners have there.
#pragma once

#include "vcg_ext/mesh/mesh_arrays.h"

#include <cstddef>
#include <cstring>

namespace index_boolean {

// Borrows points and faces, which must outlive it. Faces are numbered from 0 on.
class FacesView {
public:
	FacesView(const Points& points, const IndexTriangle* first, std::size_t count)
	    : points_(&points), first_(first), count_(count) {}
	FacesView(const Points& points, const Triangle* first, std::size_t count)
	    : points_(&points), first_(first), count_(count) {}

	std::size_t count() const { return count_; }
	const Points& points() const { return *points_; }
	const Point& point(std::uint32_t vertex) const { return (*points_)[vertex]; }

	// The corners of a face, as indices of points.
	IndexTriangle operator[](std::size_t face) const {
		static_assert(sizeof(IndexTriangle) == sizeof(Triangle));
		IndexTriangle corners;
		const auto* const bytes = static_cast<const unsigned char*>(first_);
		std::memcpy(&corners, bytes + face * sizeof corners, sizeof corners);
		return corners;
	}

private:
	const Points* points_;
	const void* first_;
	std::size_t count_;
};

// The faces of one operand, numbered from its first on. Complexity: O(1).
inline FacesView facesOf(const MeshArrays& mesh, OperandId operand) {
	return {mesh.points, mesh.triangles.data() + mesh.faceOffsets.begin(operand),
	        mesh.faceOffsets.size(operand)};
}

}  // namespace index_boolean
