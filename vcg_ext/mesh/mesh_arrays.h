// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The arrays that the core works on: all operands' points and triangles in one numbering.
// in: surfaces as plain arrays (or, by mesh_arrays_vcg.h, any vcg::tri::TriMesh); out: one
// MeshArrays. Guarantee: no coordinate is changed.
#pragma once

#include "vcg_ext/base/mesh_types.h"
#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/per_operand.h"
#include "vcg_ext/base/status.h"

#include <vector>

namespace index_boolean {

// Whether a face coincides with one of the other operand's, and how that one is turned.
enum class Twin : std::uint8_t { None, SameWay, Opposite };

// Any number of operands. Triangles hold global vertex ids. Once welded, faces of an operand may
// use vertices of one before it, where both have one in the same place.
struct MeshArrays {
	Points points;
	Triangles triangles;
	OperandOffsets vertexOffsets;  // among the points
	OperandOffsets faceOffsets;    // among the triangles
	// Per face, bit i: the edge from its corner i on lies inside a polygon, which is one face to
	// the user (vcglib's faux edges). Empty if there is none.
	std::vector<std::uint8_t> faux;
	// Per operand and face as given: with options.mergeCoplanar, only faces of one class become
	// one. Empty: all faces are of one class.
	PerOperand<std::vector<std::uint32_t>> faceClass;
	// Once looked for, and only if there are any: a vertex is quiet if every face at it has a twin,
	// a face if its corners are. Nothing is known of the twins of other faces.
	std::vector<Twin> quietFaces;
	std::vector<std::uint8_t> quietVertices;

	Twin quietTwin(FaceId face) const {
		return quietFaces.empty() ? Twin::None : at(quietFaces, face);
	}
	bool isQuiet(VertexId v) const {
		return v.value < quietVertices.size() && at(quietVertices, v) != 0;
	}
	Operands operands() const { return faceOffsets.operands(); }
	OperandId operandOf(FaceId face) const { return faceOffsets.operandOf(face.value); }
};

// The places of a face's corners in lexicographic order: by them faces are told apart in any
// numbering. Complexity: O(1).
std::array<Point, 3> sortedPlaces(const MeshArrays& mesh, FaceId face);

// A surface in a caller's arrays: triangles index the points.
struct SurfaceView {
	const Point* points;
	std::size_t pointCount;
	const IndexTriangle* triangles;
	std::size_t triangleCount;
};

// A view of two arrays, which must outlive it.
template <class PointArray, class TriangleArray>
SurfaceView viewOf(const PointArray& points, const TriangleArray& triangles) {
	return {points.data(), points.size(), triangles.data(), triangles.size()};
}

// Copies surfaces, each an operand, into the arrays of one run. Corners are taken as they are: one
// that names no point of its own surface names none of its operand afterwards, and is found when
// the operands are prepared. \param threads 0: as many as there are \param out     replaced
// \return Ok, Cancelled, OutOfMemory, or TooLarge. Complexity: O(n), in parallel.
Status joinSurfaces(const std::vector<SurfaceView>& surfaces, int threads, Monitor& monitor,
                    MeshArrays& out);

// The mask of a face's faux edges, a bit for the edge from each corner on.
inline bool isFaux(std::uint8_t mask, std::size_t corner) { return (mask >> corner & 1U) != 0; }
inline void markFaux(std::uint8_t& mask, std::size_t corner) {
	mask = static_cast<std::uint8_t>(mask | 1U << corner);
}

// The faux edges of a face once it is turned over by swapping its corners 1 and 2.
constexpr std::uint8_t turnedFaux(std::uint8_t mask) {
	return static_cast<std::uint8_t>((mask & 2U) | (mask & 1U) << 2U | mask >> 2U);
}

}  // namespace index_boolean
