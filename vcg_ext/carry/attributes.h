// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: a finished block or split mesh; out: of which input elements each of its vertices, faces and
// corners takes its attributes, and with which weights.
// Guarantee: what was not cut has exactly one source; what was cut has the weights of the exact
// point, and none where that is so. No value is looked at: the caller knows what its meshes carry.
// Source: the interpolation of point data in Quammen, Weigle & Taylor 2011 (VTK).
#pragma once

#include "vcg_ext/arrange/given_faces.h"
#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/status.h"
#include "vcg_ext/carry/seams.h"
#include "vcg_ext/mesh/sourced_mesh.h"

namespace index_boolean {

// The mean of a given face's corners. No weight is negative; their sum is 1 to 2^-38.
struct AttributeMix {
	GivenFace face;
	std::array<double, 3> weights;
};

// Where the attributes of a mesh's elements come from.
struct AttributeSources {
	HugeVector<GivenFace> face;  // per face
	// Per face and corner: which corner of the given face it is, or 3 + the index of a mix. Empty
	// unless asked for.
	IndexTriangles corner;
	// Per vertex: a vertex as given, or, from vertexCount on, vertexCount + the index of a mix; and
	// whether the faces that it stands for have been turned over.
	HugeVector<std::uint32_t> vertex;
	HugeVector<std::uint8_t> turned;
	std::uint32_t vertexCount = 0;  // of both operands as given
	std::vector<AttributeMix> mixes;

	bool isMix(std::size_t v) const { return vertex[v] >= vertexCount; }
	const AttributeMix& mixOfVertex(std::size_t v) const { return mixes[vertex[v] - vertexCount]; }
};

struct AttributeNeeds {
	bool corners = false;    // the sources of corners too
	bool partCurve = false;  // a vertex that faces of both operands have becomes two
};

// What is known of the attributes as given. Borrows the first two.
struct AttributeInput {
	const GivenTriangles& triangles;
	const Seams& seams;
	AttributeNeeds needs;
};

// Finds the sources. A vertex of both operands takes its attributes of the first. Along seams, and
// at new vertices on them, each side gets a vertex of its own: the mesh is then closed once equal
// coordinates are welded.
// \param mesh  gets copies of vertices; its surface stays the same
// \param out   replaced; only meaningful if the status is Ok
// \return Ok, Cancelled, OutOfMemory, or InternalError: a vertex of the mesh has no face
// Complexity: O(n) for n faces, O(k log k) for k corners that are none of their given face.
Status findAttributeSources(const Arrangement& arrangement, const AttributeInput& input,
                            Monitor& monitor, SourcedMesh& mesh, AttributeSources& out);

}  // namespace index_boolean
