// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the faces of a surface, and a distance; out: which of them, joined across edges, lie within
// that distance of one plane. Guarantee: the regions depend on the geometry and the classes alone,
// in any numbering and for any number of threads. Which faces are near is told by doubles: nothing
// else is decided by it.
// Source: region growing, as in Lafarge & Mallet, "Creating large-scale city models from 3D-point
// clouds" (2012).
#pragma once

#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/status.h"
#include "vcg_ext/mesh/mesh_arrays.h"

#include <vector>

namespace index_boolean {

// A plane that faces lie near, with their fronts where its normal points.
struct NearPlane {
	Point origin{}, normal{};  // of length 1; all zero: of a face too small to tell
	int axis = 0, front = 0;   // of the normal's largest component, and its sign; 0: none

	// How far above the plane a point is. O(1).
	double height(const Point& p) const {
		return normal[0] * (p[0] - origin[0]) + normal[1] * (p[1] - origin[1]) +
		       normal[2] * (p[2] - origin[2]);
	}
};

// A surface whose faces are to be merged. Borrows all.
struct ClassedSurface {
	const Points& points;
	const IndexTriangles& triangles;
	const std::vector<std::uint32_t>& faceClass;  // faces of different classes stay apart
	const std::vector<std::uint32_t>& place;      // per vertex: the first vertex in its place
};

// The regions of a surface: those of several faces by number, and then each other face by itself.
struct PlaneRegions {
	std::vector<NearPlane> planes;      // of the regions of several faces
	std::vector<std::uint32_t> ofFace;  // a number of theirs, or planes.size() + the face
	// Per face, across the edge from corner i on: the face of its class that it is joined to there,
	// none other having that edge; else kNone.
	HugeVector<IndexTriangle> neighbours;

	bool isSingle(std::uint32_t region) const { return region >= planes.size(); }
};

// The plane of a face by its places, whichever corner comes first. Complexity: O(1).
NearPlane planeOfFace(const Points& points, const IndexTriangle& face);

// The square of twice a face's area, and its least height over a side.
struct FaceSize {
	double squaredArea, leastHeight;
};

// The size of a face by its places, likewise. Complexity: O(1).
FaceSize sizeOfFace(const Points& points, const IndexTriangle& face);

// Finds the regions: from the largest face that is left on, what hangs together near a plane that
// is fitted to it until no more comes in. A face whose least height is within reach may be turned
// anyhow; any other one must have its front where the plane has it.
// \param reach how far a corner may be from the plane \param out replaced
// \return Ok, Cancelled or OutOfMemory. Throws std::bad_alloc.
// Complexity: O(n) in parallel, and O(k log k) for k faces with a neighbour near their plane.
Status findPlaneRegions(const ClassedSurface& surface, double reach, int threads, Monitor& monitor,
                        PlaneRegions& out);

}  // namespace index_boolean
