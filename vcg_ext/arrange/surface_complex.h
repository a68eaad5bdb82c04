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

// A triangle of the arrangement: an input face that is not cut, or a piece of one. Where several
// input faces have it, it is one triangle with several sources.
struct RefinedFace {
	Triangle corners;      // turned as its first source
	FaceId source;         // the input face that it is, or is a piece of: of several, the smallest
	std::uint32_t piece;   // the piece that it is of that source, or kNone
	std::uint32_t others;  // its other sources: SurfaceComplex::others from here on, or kNone
};

// A source of a triangle but for its first. `opposed`: it is turned the other way.
struct OtherSource {
	FaceId face;
	bool opposed, isLast;
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
	HugeVector<RefinedFace> faces;    // the uncut ones in the order of their sources, then pieces
	std::vector<OtherSource> others;  // of triangles with several sources, ascending for each
	HugeVector<std::uint8_t> plain;   // per input vertex; empty: no vertex is plain
	std::vector<std::uint32_t> nearFaces;  // faces; ascending
	HugeVector<HalfEdgeId> mates;      // per half-edge: the one across, or none() at a parting edge
	                                   // and between two plain vertices
	std::vector<PartingEdge> parting;  // sorted by low, then by high
	std::vector<HalfEdgeId> halfEdges;  // of the parting edges

	// Calls visit(input face, whether it is turned the other way) for each source of a triangle.
	template <class Visit>
	void visitSources(const RefinedFace& face, Visit&& visit) const {
		visit(face.source, false);
		for (std::size_t i = face.others; i != kNone; i = others[i].isLast ? kNone : i + 1) {
			visit(others[i].face, others[i].opposed);
		}
	}

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
