// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: a surface, its tree and a point anywhere; out: whether the point lies on the surface, and how
// often a closed one winds around it. Guarantee: exact, by lines along the axis, and in the
// direction, in which the box of the surface ends next.
#pragma once

#include "vcg_ext/distance/face_tree.h"

namespace index_boolean {

// A surface with its tree and box. Borrows them.
struct SearchedFaces {
	const Points& points;
	const IndexTriangles& triangles;
	const FaceTree& tree;
	const BoundingBox& box;
};

// Whether a point lies on a face, its edges and corners included. \pre the face has area
// Complexity: O(1).
bool liesOnFace(const Point& p, const Point& a, const Point& b, const Point& c);

// Whether a point lies on the surface.
// Complexity: O(log n) as expected; as many faces are looked at as have it in their box.
bool liesOnSurface(const SearchedFaces& faces, const Point& p);

// The winding number of a closed surface around a point that does not lie on it.
// Complexity: O(sqrt(n)) as expected; as many faces are looked at as have a line through it in
// their box.
int windingAround(const SearchedFaces& faces, const Point& p);

}  // namespace index_boolean
