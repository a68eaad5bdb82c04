// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What every output that is a surface consists of: a mesh, and where each of its elements came
// from.
#pragma once

#include "vcg_ext/base/mesh_types.h"

#include <vector>

namespace index_boolean {

// The input face that an output face is or is a piece of, and whether the output turned it over.
struct FaceSource {
	FaceId face;
	bool turned;
};

// Whether a mesh holds as it is stored, see carry/certificates.h.
struct Certificate {
	bool isKnown = false;
	std::vector<std::uint32_t> faces;  // that are flat, or meet others wrongly; ascending

	// Of those faces, or -1 if it is not known.
	std::int64_t count() const { return isKnown ? static_cast<std::int64_t>(faces.size()) : -1; }
};

// What merging walls that are nearly coplanar has done to a mesh, see solids/merge_walls.h.
struct WallMerge {
	std::size_t vertices = 0;  // that it has taken away
	double largestMove = 0;    // how far one of these is from the surface that is left
};

// Arrays are parallel: points with vertexSource, triangles with faceSource and, unless it is empty,
// faux. Triangles index `points`. A vertexSource is an input vertex or a curve point.
struct SourcedMesh {
	Points points;
	HugeVector<VertexId> vertexSource;
	IndexTriangles triangles;
	HugeVector<FaceSource> faceSource;
	std::vector<std::uint8_t> faux;  // as in MeshArrays; empty if no face has a faux edge
	std::size_t zeroAreaFacesRemoved = 0;
	Certificate certificate;
	WallMerge wallMerge;
};

}  // namespace index_boolean
