// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the arrangement; out: its sub-surfaces: the parts that the curve, borders and edges where an
// operand is no manifold cut the operands into, with their boundary cycles.
// Guarantee: every triangle of the arrangement lies in exactly one; their order depends on
// coordinates only, not on the numbering of vertices and faces nor on the order of the operands.
// Source: Mei & Tipper 2013, step 5 and definitions 4 to 6, by union instead of advancing fronts.
#pragma once

#include "vcg_ext/arrange/surface_complex.h"
#include "vcg_ext/exact/surface_sums.h"
#include "vcg_ext/parts/stored_triangles.h"

namespace index_boolean {

using SubSurfaceId = Id<struct SubSurfaceTag>;

// One component of a sub-surface's boundary: its points in order, the first not repeated.
struct BoundaryCycle {
	SubSurfaceId of;
	bool isSlit;  // it goes along each of its edges twice: there and back along a cut that ends
	              // within the sub-surface, and so bounds nothing
	std::vector<VertexId> points;
};

// Triangles that hang together, all with the same owners: a part of one operand, or of both where
// they coincide.
struct SubSurface {
	PerOperand<std::int32_t> number;       // its id among the sub-surfaces of each operand, or -1
	std::uint32_t firstFace, faceCount;    // SubSurfaces::faces[firstFace .. + faceCount)
	std::uint32_t firstCycle, cycleCount;  // SubSurfaces::cycles[firstCycle .. + cycleCount)
	std::uint32_t closedCycles;            // of these, the ones that are not slits
	double area;
	bool oneSided;    // like a Moebius strip: it has no front
	bool frontFirst;  // of its two sides, whatever way it is turned

	// The paper's private and public: more than one closed loop has a share in it.
	bool isPublic() const { return closedCycles > 1; }
};

struct SubSurfaces {
	SurfaceComplex complex;
	std::vector<SubSurface> all;
	HugeVector<SubSurfaceId> ofFace;  // per face of the complex
	// Per face of the complex: it is turned the other way than its sub-surface, whose front is that
	// of its lexicographically smallest face.
	HugeVector<std::uint8_t> turned;
	HugeVector<std::uint32_t> faces;                  // of the complex, by sub-surface
	PerOperand<std::vector<SubSurfaceId>> ofOperand;  // by number
	std::vector<BoundaryCycle> cycles;                // by sub-surface
	std::vector<std::vector<SubSurfaceId>> atLoop;    // per loop of the arrangement; ascending
	std::vector<SurfaceSums> sums;                    // per sub-surface, seen from its front
	SumFrame frame;                                   // of the sums
	StoredTriangles stored;  // in place of the complex's, if these do not hold as they are stored,
	                         // or have been merged
	WallMerge wallMerge;     // what that has done to all of them
};

// Finds the sub-surfaces of an arrangement.
// \return Ok, Cancelled, OutOfMemory, InternalError
// Complexity: O(n + k log k) for n triangles, k of them at the curve.
Status findSubSurfaces(const Arrangement& arrangement, Monitor& monitor, SubSurfaces& out);

}  // namespace index_boolean
