// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the filters have in common: two layers of the document, by the parameters first_mesh and
// second_mesh, and the refusals that speak of them.
#pragma once

#include "layers/layers.h"
#include "runs/progress.h"
#include "texts/parameter_values.h"
#include "texts/refusal.h"

#include <vcg_ext/index_boolean.h>

namespace index_boolean {

struct OperandLayers {
	PerOperand<MeshModel*> layers;
	LayerNames names;
	TakenFor kind = TakenFor::Solid;
};

// The two layers that the parameters name; throws Refusal unless there are two.
OperandLayers findOperandLayers(FilterId filter, const ParameterValues& values,
                                MeshDocument& document);

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
void refuseUnlessOk(const Status& status, const LayerNames& names);

// The same, with the status's faces left selected in the layer that they have been read from.
void refuseDefect(const Status& status, const OperandArrays& read, const OperandLayers& operands);

// Reads the layers once more, for a run that begins again. Borrows the layers and the progress.
// \param read what has been read of them, of which the classes of faces are kept
InputAgain inputAgain(const OperandLayers& operands, const OperandArrays& read, Progress& progress);

// Both operands' arrays; throws Refusal if they cannot be read.
OperandArrays readOperands(const OperandLayers& operands, Progress& progress);

}  // namespace index_boolean
