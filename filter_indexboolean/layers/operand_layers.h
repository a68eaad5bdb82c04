// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the filters have in common: layers of the document, two by the parameters first_mesh and
// second_mesh or any number by a list, and the refusals that speak of them.
#pragma once

#include "layers/layers.h"
#include "runs/progress.h"
#include "texts/layer_list.h"
#include "texts/parameter_values.h"
#include "texts/refusal.h"

#include <vcg_ext/index_boolean.h>

namespace index_boolean {

struct OperandLayers {
	PerOperand<MeshModel*> layers;
	LayerNames names;
	TakenFor kind = TakenFor::Solid;
};

// The two layers that the parameters first_mesh and second_mesh name; throws Refusal unless there
// are two.
OperandLayers findOperandLayers(FilterId filter, const ParameterValues& values,
                                MeshDocument& document);

// What there is to know of all layers of the document, in its order, for lists of layers.
LayerDirectory layerDirectory(const MeshDocument& document);

// The layer that a parameter names; throws Refusal if there is none.
LayerName layerGiven(FilterId filter, const char* parameter, const ParameterValues& values,
                     MeshDocument& document);

// Makes the layers invisible.
void hideLayers(const OperandLayers& operands);

// The layers of the document that have been named, in that order. \pre each once, and it is there
OperandLayers layersNamed(const std::vector<LayerName>& names, MeshDocument& document);
// The layer that one parameter names; throws Refusal if there is none.
MeshModel* findOperand(FilterId filter, const char* name, const ParameterValues& values,
                       MeshDocument& document);

// What a layer is called in sentences.
LayerName nameOf(const MeshModel& layer);

// The parameter's number; throws Refusal if it is out of the range of its definition.
int numberInRange(FilterId filter, const char* name, const ParameterValues& values);

// The parameter's length; throws Refusal if it is negative or no number.
double lengthInRange(FilterId filter, const char* name, const ParameterValues& values);

// The options that every filter has: the search for self-intersections, the weld distance and the
// octree's limits, and the host's scalar.
Options readCommonOptions(FilterId filter, const ParameterValues& values);

// These, and those that filters have that make surfaces: certificates, and the scalar for them.
Options readSurfaceOptions(FilterId filter, const ParameterValues& values);

// Throws Refusal with the status's sentence.
void refuseUnlessOk(const Status& status, const LayerNames& names, TakenFor kind = TakenFor::Solid);

// Leaves the status's faces, if it has any, selected in the layer that they have been read from.
void selectDefect(const Status& status, const OperandArrays& read, const OperandLayers& operands);

// Throws Refusal with the status's sentence, and its faces selected.
void refuseDefect(const Status& status, const OperandArrays& read, const OperandLayers& operands);

// Reads the layers once more, for a run that begins again. Borrows the layers and the progress.
// \param read what has been read of them, of which the classes of faces are kept
InputAgain inputAgain(const OperandLayers& operands, const OperandArrays& read, Progress& progress);

// The operands' arrays; throws Refusal if they cannot be read.
OperandArrays readOperands(const OperandLayers& operands, Progress& progress);

}  // namespace index_boolean
