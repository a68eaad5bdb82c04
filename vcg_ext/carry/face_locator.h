// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: a vertex of a finished mesh and the input face that a face at it came from; out: where the
// vertex lies in that face, or in another one of its polygon, as a mean of corners as given.
// Guarantee: which face it lies in is decided exactly; of several it is always the first.
#pragma once

#include "vcg_ext/arrange/given_faces.h"
#include "vcg_ext/exact/box_tree.h"
#include "vcg_ext/mesh/sourced_mesh.h"

#include <memory>
#include <mutex>

namespace index_boolean {

// A point of an input face, as the mean of the corners that the face was given with. No weight is
// negative; their sum is 1 to 2^-38.
struct PlaceInFace {
	FaceId face;
	std::array<double, 3> weights;
	bool isThere;  // else the weights are those of a point nearby
};

// Places of a mesh's vertices in input faces. Borrows all that it is made of; any thread may ask.
class FaceLocator {
public:
	// Throws std::bad_alloc. Complexity: O(1), or O(n) for n input faces if there are polygons.
	FaceLocator(const Arrangement& arrangement, const GivenTriangles& given,
	            const SourcedMesh& mesh);

	GivenFace givenFace(FaceId face) const { return givenFaceOf(arrangement_, face); }
	Triangle givenTriangle(FaceId face) const { return given_(givenFace(face)); }

	// The corner of a given triangle that a vertex of the mesh is, or -1. O(1).
	int cornerOf(const Triangle& given, std::uint32_t vertex) const;

	// Where a vertex of the mesh lies in an input face or, if outside of it, in the first face in
	// one plane and one polygon with it. Throws std::bad_alloc.
	// Complexity: O(log n) if it is outside of its own face, of a polygon of n faces; else O(1).
	PlaceInFace locate(FaceId face, std::uint32_t vertex) const;

private:
	// The faces of a large flat part of a polygon by their boxes, once one is looked for there.
	struct LargePart {
		std::uint32_t part;
		std::once_flag isBuilt;
		std::unique_ptr<BoxTree> tree;
	};

	bool isAt(VertexId input, std::uint32_t vertex) const;
	int cornerOfName(const Triangle& given, std::uint32_t id) const;
	int cornerOpposite(const Triangle& given, std::uint32_t low, std::uint32_t high) const;
	int zeroCorner(const Triangle& given, VertexId v) const;
	std::array<double, 3> weightsIn(const Triangle& given, std::uint32_t vertex) const;
	bool placeIn(FaceId face, std::uint32_t vertex, PlaceInFace& place) const;
	void listLargeParts();
	BoundingBox boxOf(FaceId face) const;
	const BoxTree& treeOf(std::uint32_t part) const;
	std::vector<FaceId> facesNear(std::uint32_t part, std::uint32_t vertex) const;

	const Arrangement& arrangement_;
	const GivenTriangles& given_;
	const SourcedMesh& mesh_;
	// Faces by the flat part of their polygon: those of part r are members_[begin_[r] ...).
	std::vector<std::uint32_t> begin_;
	std::vector<FaceId> members_;
	std::unique_ptr<LargePart[]> largeParts_;  // by part
	std::size_t largePartCount_ = 0;
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
