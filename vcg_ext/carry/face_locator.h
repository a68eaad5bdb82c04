// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: vertices of a finished mesh and the input faces that faces at them came from; out: where each
// vertex lies in its face, or in another one of its polygon, as a mean of corners as given.
// Guarantee: which face it lies in is decided exactly; of several it is always the first.
#pragma once

#include "vcg_ext/arrange/given_faces.h"
#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/status.h"
#include "vcg_ext/exact/bounding_box.h"
#include "vcg_ext/mesh/sourced_mesh.h"

namespace index_boolean {

// A point of an input face, as the mean of the corners that the face was given with. No weight is
// negative; their sum is 1 to 2^-38.
struct PlaceInFace {
	FaceId face;
	std::array<double, 3> weights;
	bool isThere;  // else the weights are those of a point nearby
};

// A vertex of the mesh whose place in an input face is wanted.
struct WantedPlace {
	FaceId face;
	std::uint32_t vertex;

	friend bool operator==(const WantedPlace& a, const WantedPlace& b) {
		return a.face == b.face && a.vertex == b.vertex;
	}
	friend bool operator<(const WantedPlace& a, const WantedPlace& b) {
		return a.face != b.face ? a.face < b.face : a.vertex < b.vertex;
	}
};

// Places of a mesh's vertices in input faces. Borrows all that it is made of; any thread may ask.
class FaceLocator {
public:
	// Complexity: O(1).
	FaceLocator(const Arrangement& arrangement, const GivenTriangles& given,
	            const SourcedMesh& mesh)
	    : arrangement_(arrangement), given_(given), mesh_(mesh) {}

	GivenFace givenFace(FaceId face) const { return givenFaceOf(arrangement_, face); }
	Triangle givenTriangle(FaceId face) const { return given_(givenFace(face)); }

	// The corner of a given triangle that a vertex of the mesh is, or -1. O(1).
	int cornerOf(const Triangle& given, std::uint32_t vertex) const;

	// Where vertices of the mesh lie in their input faces or, if outside of one, in the first face
	// in one plane and one polygon with it. \param out replaced: the place of each that is wanted
	// \return Ok, Cancelled or OutOfMemory
	// Complexity: O(k) for k places; if any lies outside of its own face, O(n + m log k) more for n
	// input faces, m of them in the same polygons.
	Status locate(const std::vector<WantedPlace>& wanted, Monitor& monitor,
	              std::vector<PlaceInFace>& out) const;

private:
	struct PartSearch;

	bool isAt(VertexId input, std::uint32_t vertex) const;
	int cornerOfName(const Triangle& given, std::uint32_t id) const;
	int cornerOpposite(const Triangle& given, std::uint32_t low, std::uint32_t high) const;
	int zeroCorner(const Triangle& given, VertexId v) const;
	std::array<double, 3> weightsIn(const Triangle& given, std::uint32_t vertex) const;
	bool placeIn(FaceId face, std::uint32_t vertex, PlaceInFace& place) const;
	FaceId partOf(FaceId face) const { return at(arrangement_.polygons.flat, face); }
	const Point& placeOf(std::uint32_t vertex) const;
	BoundingBox boxOf(FaceId face, std::size_t along) const;
	Status locateInParts(const std::vector<WantedPlace>& wanted,
	                     const std::vector<std::size_t>& missing, Monitor& monitor,
	                     std::vector<PlaceInFace>& out) const;

	const Arrangement& arrangement_;
	const GivenTriangles& given_;
	const SourcedMesh& mesh_;
};

inline bool FaceLocator::isAt(VertexId input, std::uint32_t vertex) const {
	const VertexId source = mesh_.vertexSource[vertex];
	if (source == input) {
		return true;
	}
	const Points& points = arrangement_.mesh.points;
	return source.value < points.size() && at(points, source) == at(points, input);
}

inline int FaceLocator::cornerOf(const Triangle& given, std::uint32_t vertex) const {
	for (int j = 0; j < 3; ++j) {
		if (isAt(given[static_cast<std::size_t>(j)], vertex)) {
			return j;
		}
	}
	return -1;
}

}  // namespace index_boolean
