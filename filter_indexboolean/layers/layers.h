// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// MeshLab's layers and the core's arrays: layers in, new layers out, and the selection that
// shows a defect.
#pragma once

#include "layers/layer_writer.h"
#include "runs/progress.h"

#include <vcg_ext/mesh/mesh_arrays_vcg.h>

#include <host_document.h>

#include <vector>

namespace index_boolean {

// The operands as the core reads them, and which elements of the layers theirs are.
struct OperandArrays {
	MeshArrays arrays;
	PerOperand<OperandElements> elements;
};

// Reads layers, each an operand, with their matrices applied. The layers are not changed.
// \param out replaced
// \return Ok, Cancelled, OutOfMemory
Status readLayers(const PerOperand<MeshModel*>& layers, Progress& progress, OperandArrays& out);

// Whether this plugin has made the layer. A mark that it bears tells; files do not keep it.
bool isResultLayer(const MeshModel& layer);

// Replaces the layer's selection by faces of the operand that was read from it.
void selectFaces(const std::vector<std::uint32_t>& faces, const LiveElements& live,
                 MeshModel& layer);

// Adds a layer for each content, in order, each with the mark of a result, and makes the first one
// current. Unless Ok, the document
// is as before.
// \param added replaced: the new layers, owned by the document
// \return Ok, Cancelled, OutOfMemory
Status addLayers(const std::vector<LayerContent>& contents, Progress& progress,
                 MeshDocument& document, std::vector<MeshModel*>& added);

}  // namespace index_boolean
