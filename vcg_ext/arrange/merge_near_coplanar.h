// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: a surface as it is stored, and a tolerance; out: the same with walls of one polygon where
// connected faces lie within it of one plane, with one edge where a chain of border vertices lies
// within it of a line, without the vertices that then bear nothing, in constrained Delaunay
// triangles.
// Guarantee: no vertex moves; no point of either surface is farther than the tolerance from the
// other; closed stays closed, with as many components, holes and handles; the exact search finds
// nothing wrong at any new face. Which vertices go depends on the geometry and the classes alone.
//
// The tolerance is shared out: 0.8 of it is the thickness of the slab around a region's plane, 0.4
// is how far what goes from between regions may be from the edge that stands for it. Old and new
// faces of a region lie in its slab and have one outline as seen along its normal, but for what
// edges have moved it aside: so a point of one has one of the other above or below it, within the
// slab, or one at an edge, aside too; sqrt(0.8^2 + 0.4^2) < 0.9, and the rest is for roundings.
// Slivers lower than 0.4 of it may be turned anyhow, and so stand out from their region: of each
// that goes the longest side must be within half of the tolerance of what is left, and each vertex
// that goes within 0.9 of it. All is measured from the surface as it is given: nothing drifts.
// Why not edge by edge, with a quadric or a running bound: bounds that add up forbid in the end
// what the surface allows, and depend on the order.
#pragma once

#include "vcg_ext/mesh/plane_regions.h"

namespace index_boolean {

// What is merged, and how far.
struct NearCoplanarInput {
	const Points& points;
	const IndexTriangles& triangles;
	const std::vector<std::uint32_t>& faceClass;   // only faces of one class become one
	const std::vector<std::uint32_t>& wrongFaces;  // that meet others wrongly already, and stay
	double tolerance;                              // above 0
	int threads;
};

// The surface afterwards, of the same points: first the faces that stay, in their order.
struct NearCoplanarMerge {
	IndexTriangles triangles;
	std::vector<std::uint32_t> origin;  // per face: one of the surface that it is or stands for
	std::vector<std::uint32_t> gone;    // vertices, ascending
	double largestMove = 0;             // of one of these, to the surface that is left
	std::size_t firstNew = 0;           // faces from here on are new

	bool any() const { return !gone.empty(); }
};

// Merges what is nearly coplanar.
// \param out replaced; without a vertex that went there is nothing in it
// \return Ok, Cancelled, OutOfMemory, InternalError. Throws std::bad_alloc.
// Complexity: O(n) in parallel, and O(k log k) for k faces near a neighbour's plane, a few times
// where the search finds something.
Status mergeNearCoplanar(const NearCoplanarInput& input, Monitor& monitor, NearCoplanarMerge& out);

}  // namespace index_boolean
