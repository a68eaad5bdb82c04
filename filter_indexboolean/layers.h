// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// MeshLab's layers and the core's arrays: two layers in, new layers out, and the selection that
// shows a defect. The only file of this folder that touches mesh elements.
#pragma once

#include "progress.h"

#include <vcg_ext/curve_lines.h>
#include <vcg_ext/mesh_arrays_vcg.h>
#include <vcg_ext/sourced_mesh.h>

#include <host_document.h>

#include <array>
#include <functional>
#include <vector>

namespace index_boolean {

// Both operands as the core reads them, and which elements of the layers theirs are.
struct OperandArrays {
	MeshArrays arrays;
	std::array<OperandElements, 2> elements;
};

// Reads both layers with their matrices applied. The layers are not changed.
// \return Ok, Cancelled, OutOfMemory
Status readLayers(const std::array<MeshModel*, 2>& layers, Progress& progress, OperandArrays& out);

// Replaces the layer's selection by faces of the operand that was read from it.
void selectFaces(const std::vector<std::uint32_t>& faces, const LiveElements& live,
                 MeshModel& layer);

// A number for each vertex or each face: the host's scalar attribute of that name.
struct ScalarAttribute {
	const char* name;
	std::vector<std::int32_t> values;
};

// What a new layer holds: a surface, or polylines. What is pointed to is borrowed.
struct LayerContent {
	QString label;  // the host appends a number to a label that is taken
	const SourcedMesh* surface = nullptr;
	const CurveLines* curves = nullptr;
	std::vector<ScalarAttribute> vertexAttributes, faceAttributes;
	std::vector<vcg::Color4b> faceColours;  // empty: the faces have none
	// Writes the vertices' normals, and whatever the operands carry. Empty: normals are those of
	// the faces.
	std::function<Status(Monitor&, MeshModel&)> writeAttributes;
};

// Adds a layer for each content, in order, and makes the first one current. Unless Ok, the document
// is as before.
// \param added replaced: the new layers, owned by the document
// \return Ok, Cancelled, OutOfMemory
Status addLayers(const std::vector<LayerContent>& contents, Progress& progress,
                 MeshDocument& document, std::vector<MeshModel*>& added);

}  // namespace index_boolean
