// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the refined surfaces; out: their triangles, coincident ones merged, and how they hang
// together: across an edge with exactly two triangles that have the same owners the surface goes
// on; every other edge (of the curve, of a border, where an operand is no manifold) parts it.
// Guarantee: by indices alone.
#pragma once

#include "vcg_ext/arrange/arrangement.h"
#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/status.h"

namespace index_boolean {

// A triangle of the arrangement: an input face that is not cut, or a piece of one. Where both
// operands have it, it is one triangle with two sources.
struct RefinedFace {
	Triangle corners;               // turned as the first of its sources
	std::array<FaceId, 2> sources;  // per operand: the face that it is, or is a piece of; or none()
	bool opposed;                   // it has two sources, and the second is turned the other way

	// The input face that `corners` is turned as.
	FaceId source() const { return sources[0] != FaceId::none() ? sources[0] : sources[1]; }
	bool hasOwnersOf(const RefinedFace& other) const {
		return (sources[0] == FaceId::none()) == (other.sources[0] == FaceId::none()) &&
		       (sources[1] == FaceId::none()) == (other.sources[1] == FaceId::none());
	}
};

// Edge i of the near face n is the half-edge 3 * n + i; it runs from corner i to the next one.
using HalfEdgeId = Id<struct HalfEdgeTag>;

// An edge that parts the surfaces: halfEdges[first .. first + count).
struct PartingEdge {
	VertexId low, high;  // low < high
	std::uint32_t first, count;
};

// Triangles and how they hang together. Around a plain vertex all do, in one umbrella that runs one
// way; only the near faces, those with a corner that is not plain, need be looked at edge by edge.
struct SurfaceComplex {
	HugeVector<RefinedFace> faces;   // the uncut ones in the order of their sources, then pieces
	HugeVector<std::uint8_t> plain;  // per input vertex; empty: no vertex is plain
	std::vector<std::uint32_t> nearFaces;  // faces; ascending
	HugeVector<HalfEdgeId> mates;      // per half-edge: the one across, or none() at a parting edge
	                                   // and between two plain vertices
	std::vector<PartingEdge> parting;  // sorted by low, then by high
	std::vector<HalfEdgeId> halfEdges;  // of the parting edges

	bool isPlain(VertexId v) const { return v.value < plain.size() && at(plain, v) != 0; }
	std::uint32_t faceAt(HalfEdgeId h) const { return nearFaces[h.value / 3]; }
	const RefinedFace& faceOf(HalfEdgeId h) const { return faces[faceAt(h)]; }
	VertexId beginOf(HalfEdgeId h) const { return faceOf(h).corners[h.value % 3]; }
	VertexId endOf(HalfEdgeId h) const { return faceOf(h).corners[(h.value + 1) % 3]; }
	// The parting edge between two vertices, or null.
	const PartingEdge* partingEdge(VertexId a, VertexId b) const;
	// From a half-edge at a parting edge, goes round its end `around` across the faces that hang
	// together there; the half-edge at a parting edge where that comes to an end.
	HalfEdgeId turnAround(HalfEdgeId from, VertexId around) const;
};

// Builds the complex of all triangles, or only of the pieces with a corner at an irregular point of
// the curve: everything around these points, and whole there.
// \pre arrangement.nonManifold is known
// \return Ok, Cancelled, OutOfMemory. Complexity: O(n) for n triangles.
enum class ComplexOf : std::uint8_t { Everything, IrregularPoints };
Status buildComplex(const Arrangement& arrangement, ComplexOf part, Monitor& monitor,
                    SurfaceComplex& out);

}  // namespace index_boolean
