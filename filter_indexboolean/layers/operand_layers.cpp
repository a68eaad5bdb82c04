// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// All layers are found and named before anything is read from them.
#include "layers/operand_layers.h"

#include <cmath>
#include <utility>

namespace index_boolean {

MeshModel* findOperand(FilterId filter, const char* name, const ParameterValues& values,
                       MeshDocument& document) {
	const int id = values.getInt(name);
	MeshModel* layer = findLayer(document, id);
	if (layer == nullptr) {
		throw Refusal(unknownLayerMessage(parameterDefinition(filter, name), id));
	}
	return layer;
}

LayerName nameOf(const MeshModel& layer) {
	const std::string label = layer.label().toStdString();
	return {label.empty() ? "layer " + std::to_string(layer.id()) : label, layer.id()};
}

OperandLayers findOperandLayers(FilterId filter, const ParameterValues& values,
                                MeshDocument& document) {
	OperandLayers operands;
	operands.layers = {findOperand(filter, "first_mesh", values, document),
	                   findOperand(filter, "second_mesh", values, document)};
	operands.kind = takenFor(filter);
	operands.names = {nameOf(*operands.layers[kFirst]), nameOf(*operands.layers[kSecond])};
	if (operands.layers[kFirst] == operands.layers[kSecond]) {
		throw Refusal(sameLayerMessage(operands.names[kFirst]));
	}
	return operands;
}

LayerDirectory layerDirectory(const MeshDocument& document) {
	std::vector<ListedLayer> layers;
	for (const MeshModel* layer : layersOf(document)) {
		layers.push_back({nameOf(*layer), layer->label().toStdString(), layer->isVisible(),
		                  layer->cm.fn > 0, isResultLayer(*layer)});
	}
	return LayerDirectory(std::move(layers));
}

LayerName layerGiven(FilterId filter, const char* parameter, const ParameterValues& values,
                     MeshDocument& document) {
	return nameOf(*findOperand(filter, parameter, values, document));
}

void hideLayers(const OperandLayers& operands) {
	for (MeshModel* layer : operands.layers) {
		hideLayer(*layer);
	}
}

OperandLayers layersNamed(const std::vector<LayerName>& names, MeshDocument& document) {
	OperandLayers operands{PerOperand<MeshModel*>(names.size()), LayerNames(names.size())};
	for (const OperandId operand : operands.names.operands()) {
		operands.names[operand] = names[operand.value];
		operands.layers[operand] = findLayer(document, names[operand.value].id);
	}
	return operands;
}

int numberInRange(FilterId filter, const char* name, const ParameterValues& values) {
	const ParameterDefinition& definition = parameterDefinition(filter, name);
	const int number = values.getInt(name);
	if (number < definition.minimum || number > definition.maximum) {
		throw Refusal(outOfRangeMessage(definition, number));
	}
	return number;
}

double lengthInRange(FilterId filter, const char* name, const ParameterValues& values) {
	const double length = values.getLength(name);
	if (!(length >= 0 && std::isfinite(length))) {
		throw Refusal(badLengthMessage(parameterDefinition(filter, name), length));
	}
	return length;
}

Options readCommonOptions(FilterId filter, const ParameterValues& values) {
	Options options;
	options.octreeMaxDepth = numberInRange(filter, "octree_max_depth", values);
	options.octreeLeafSize = numberInRange(filter, "octree_leaf_size", values);
	options.outputScalar =
	    sizeof(Scalarm) == sizeof(float) ? OutputScalar::Float : OutputScalar::Double;
	options.selfIntersections = static_cast<SelfIntersections>(values.getInt("self_intersections"));
	options.windingRule = static_cast<WindingRule>(values.getInt("winding_rule"));
	options.weldDistance = lengthInRange(filter, "weld_distance", values);
	return options;
}

Options readSurfaceOptions(FilterId filter, const ParameterValues& values) {
	Options options = readCommonOptions(filter, values);
	options.mergeTolerance = lengthInRange(filter, "merge_tolerance", values);
	options.certify = values.getBool("certify");
	if (values.getInt("certify_as") == static_cast<int>(CertifyAs::Float)) {
		options.outputScalar = OutputScalar::Float;
	}
	return options;
}

void refuseUnlessOk(const Status& status, const LayerNames& names, TakenFor kind) {
	if (!status.ok()) {
		throw Refusal(refusalMessage(status, names, kind));
	}
}

void selectDefect(const Status& status, const OperandArrays& read, const OperandLayers& operands) {
	const OperandId operand = operandOf(status);
	if (!status.faces.empty()) {
		selectFaces(status.faces, read.elements[operand].faces, *operands.layers[operand]);
	}
}

void refuseDefect(const Status& status, const OperandArrays& read, const OperandLayers& operands) {
	selectDefect(status, read, operands);
	refuseUnlessOk(status, operands.names, operands.kind);
}

InputAgain inputAgain(const OperandLayers& operands, const OperandArrays& read,
                      Progress& progress) {
	return [&operands, &progress, faceClass = read.arrays.faceClass](MeshArrays& out) {
		OperandArrays again;
		const Status status = readLayers(operands.layers, progress, again);
		out = std::move(again.arrays);
		out.faceClass = faceClass;
		return status;
	};
}

OperandArrays readOperands(const OperandLayers& operands, Progress& progress) {
	OperandArrays read;
	refuseUnlessOk(readLayers(operands.layers, progress, read), operands.names);
	return read;
}

}  // namespace index_boolean
