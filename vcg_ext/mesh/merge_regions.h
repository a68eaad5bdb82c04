// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: a surface and its regions near planes (plane_regions.h); out: the same surface without
// vertices that bear nothing, with constrained Delaunay triangles in each region that lost some.
// Guarantee: closed stays closed, a manifold a manifold, with as many components, holes and
// handles; each new face has its front where its region's plane has it, seen along the plane's
// axis, by exact signs; all corners of a region's faces are within reach of its plane; all vertices
// that went from border edges, those between regions, are within `aside` of an edge that stands for
// theirs. Which vertices go depends on the geometry alone. Whether faces meet wrongly afterwards is
// not asked. Faces around a vertex are taken run by run: neighbours of one region.
#pragma once

#include "vcg_ext/mesh/plane_regions.h"

namespace index_boolean {

// How far a surface may go.
struct MergeLimits {
	double reach;  // of a region's corners from its plane
	double aside;  // of a vertex between regions from the edge that replaces its own
};

// What stays as it is, per vertex of the surface, not 0: the vertex; and per face: its diagonals.
struct KeptParts {
	std::vector<std::uint8_t> vertices;
	std::vector<std::uint8_t> faces;
};

// The surface afterwards: the faces that stay in their order, then the others. If no vertex has
// gone there is nothing in it.
struct MergedFaces {
	IndexTriangles triangles;           // of the same points
	std::vector<std::uint32_t> origin;  // per face: one of the surface that it is or stands for
	std::vector<std::uint32_t> region;  // per face
	std::size_t firstNew = 0;           // faces from here on are new
	std::vector<std::uint32_t> gone;    // vertices, in the order in which they went
};

// Takes vertices away.
// \param out replaced
// \return Ok, Cancelled or OutOfMemory. Throws std::bad_alloc.
// Complexity: O(n) and O(k log k) for k faces at vertices with two faces of a region, or with an
// edge no longer than limits.aside, as long as no vertex has very many faces.
Status mergeRegions(const ClassedSurface& surface, const PlaneRegions& regions,
                    const MergeLimits& limits, const KeptParts& kept, Monitor& monitor,
                    MergedFaces& out);

}  // namespace index_boolean
