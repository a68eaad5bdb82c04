// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: both operands' arrays; out: faces whose corners in one place are one vertex. Guarantee: by
// equality of coordinates alone (0 is -0), the first vertex at each place stands for all.
#pragma once

#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/status.h"
#include "vcg_ext/mesh/mesh_arrays.h"

#include <cmath>
#include <vector>

namespace index_boolean {

// Whether all coordinates are numbers of at most this size.
inline bool isWithin(const Point& p, double most) {
	return std::fabs(p[0]) <= most && std::fabs(p[1]) <= most && std::fabs(p[2]) <= most;
}

// Welds vertices by their coordinates: first those of each operand; once it is known which of them
// faces still use, those of the second to those of the first. Vertices that are not finite are left
// aside: no face may use them. Borrows the arrays. O(n) in all, in parallel; all steps return Ok,
// Cancelled or OutOfMemory.
class CornerWelder {
public:
	CornerWelder(MeshArrays& mesh, int threads, Monitor& monitor)
	    : mesh_(mesh), threads_(threads), monitor_(monitor) {}

	// Finds the vertices that may have another in their place.
	// \param most    the largest coordinate that the output scalar holds
	// \param inRange whether all coordinates are finite, and at most that
	Status findSuspects(double most, bool& inRange);

	// Replaces each corner by the first vertex of its operand with the same coordinates.
	// \param welded which operands have two vertices in one place
	Status weldWithinOperands(PerOperand<bool>& welded);

	// Where vertices of both operands coincide, they are one vertex from here on. A vertex that no
	// face of the first operand uses (any more) is none of its vertices.
	Status weldSecondToFirst();

private:
	// A vertex and the one that stands for it.
	struct Move {
		std::uint32_t vertex, to;
	};

	Status replaceCorners(const std::vector<Move>& moves, std::size_t firstFace);
	std::vector<bool> usedByFirst() const;

	MeshArrays& mesh_;
	int threads_;
	Monitor& monitor_;
	PerOperand<std::vector<std::uint32_t>> suspects_;  // per operand, ascending
};

}  // namespace index_boolean
