// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: meshes that have been read from one arrangement; out: of which elements of the operands each
// of them takes its attributes.
#pragma once

#include <vcg_ext/index_boolean.h>

#include <vector>

namespace index_boolean {

// What the caller says of the attributes that its operands carry.
struct AttributeRequest {
	GivenTriangles given;  // empty: no attributes are wanted
	SameAttributes same;
	AttributeNeeds needs;
};

// Finds the sources of all meshes' elements; their vertices part at the operands' seams.
// \pre attributes are wanted
// \param meshes  each a SourcedMesh; get copies of vertices, their surfaces stay the same
// \param sources replaced: of each mesh
// \return Ok, Cancelled, OutOfMemory, InternalError. Complexity: see attributeSources.
template <class Mesh>
Status findSources(const Arrangement& arrangement, const AttributeRequest& request,
                   Monitor& monitor, std::vector<Mesh>& meshes,
                   std::vector<AttributeSources>& sources) {
	Seams seams;
	Status status = operandSeams(arrangement, request.given, request.same, monitor, seams);
	sources.resize(meshes.size());
	const AttributeInput input{request.given, seams, request.needs};
	for (std::size_t i = 0; i < meshes.size() && status.ok(); ++i) {
		status = attributeSources(arrangement, input, monitor, meshes[i], sources[i]);
	}
	return status;
}

}  // namespace index_boolean
