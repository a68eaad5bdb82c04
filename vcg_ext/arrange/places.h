// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: a vertex or a point of the curve; out: the exact place that its name stands for, an order of
// such places, and the place as delivered. Guarantee: exact; rounded once, and moved only by
// repair_places.
#pragma once

#include "vcg_ext/arrange/arrangement.h"
#include "vcg_ext/exact/exact_sign.h"

namespace index_boolean {

// The point that a name stands for, by its simplices, not rounded unless it is a vertex; borrows
// the mesh's points. Complexity: O(1).
ExactPoint exactPointOf(const MeshArrays& mesh, const PointName& name);

// The simplices that define a vertex or a curve point; borrows the arrangement's points.
// \param vertex an input vertex or a numbered curve point
// Complexity: O(1).
ExactPoint exactPoint(const Arrangement& arrangement, VertexId vertex);

// An order of vertices that depends on their places only: by the rounded coordinates,
// lexicographically, then, if all three are equal, by the exact ones. \return -1, 0, +1
// Complexity: O(1); a few comparisons unless the places are nearly the same.
int comparePlaces(const Arrangement& arrangement, VertexId a, VertexId b);

// A direction along which two different places differ: an axis, and +1 if the coordinate rises from
// the first to the second, else -1.
struct AxisDirection {
	int axis, sign;
};

// The axis along which the rounded places are farthest apart, or, if these are equal, the first
// one along which the exact ones differ. sign is 0 if they do not. Complexity: O(1).
AxisDirection directionBetween(const Arrangement& arrangement, VertexId from, VertexId to);

// Whether a vertex is stored in its exact place for sure: an input vertex that has not been moved,
// if its coordinates are numbers of the output scalar. Complexity: O(log m) for m moved places.
bool isStoredExactly(const Arrangement& arrangement, VertexId vertex);

// Whether any input vertex is not stored where it was given, in double. Complexity: O(1).
inline bool anyInputMoved(const Arrangement& arrangement) {
	const auto& moved = arrangement.movedPlaces;  // input vertices come first
	return !moved.empty() && !arrangement.isCurvePoint(moved.begin()->first);
}

// A number in a scalar, and how far the next larger one of that scalar is from its size; from the
// largest one, the next smaller. Complexity: O(1).
double inScalar(double x, OutputScalar scalar);
double gapAt(double x, OutputScalar scalar);

// Whether a scalar holds all coordinates of some points, and these points in it.
// Complexity: O(n), O(1) for doubles.
bool isStoredExactly(const Points& points, OutputScalar scalar);
void roundPlaces(OutputScalar scalar, Points& points);

// The exact place of a vertex, rounded once to the output scalar. Complexity: O(1).
Point roundedPlace(const Arrangement& arrangement, VertexId vertex);

// A vertex's coordinates as they are delivered: its moved place if it has one, else the rounded
// one. Complexity: O(log m) for m moved places.
Point outputCoordinates(const Arrangement& arrangement, VertexId vertex);

}  // namespace index_boolean
