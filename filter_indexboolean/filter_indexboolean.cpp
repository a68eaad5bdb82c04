// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parameters in, layers and result map out. The steps are in generateIndexBoolean.
#include "filter_indexboolean.h"

#include "boolean_run.h"
#include "layers.h"
#include "messages.h"
#include "progress.h"
#include "result_map.h"
#include "stopwatch.h"

#include <new>
#include <utility>

using namespace index_boolean;

namespace {

// A run that the parameters have been found fit for.
struct Task {
	std::array<MeshModel*, 2> layers;
	LayerNames names;
	BooleanRequest request;
};

constexpr FilterId kBoolean = FilterId::GenerateIndexBoolean;

MLException refusal(const std::string& message) {
	return MLException(QString::fromStdString(message));
}

FilterId filterId(int filter) { return static_cast<FilterId>(filter); }

MeshModel* readLayer(const char* name, const RichParameterList& parameters,
                     MeshDocument& document) {
	const unsigned int id = parameters.getMeshId(name);
	MeshModel* layer = document.getMesh(id);
	if (layer == nullptr)
		throw refusal(
		    unknownLayerMessage(parameterDefinition(kBoolean, name), static_cast<int>(id)));
	return layer;
}

LayerName nameOf(const MeshModel& layer) {
	const std::string label = layer.label().toStdString();
	return {label.empty() ? "layer " + std::to_string(layer.id()) : label, layer.id()};
}

int readInt(const char* name, const RichParameterList& parameters) {
	const ParameterDefinition& definition = parameterDefinition(kBoolean, name);
	const int value = parameters.getInt(name);
	if (value < definition.minimum || value > definition.maximum)
		throw refusal(outOfRangeMessage(definition, value));
	return value;
}

Options readOptions(const RichParameterList& parameters) {
	Options options;
	options.octreeMaxDepth = readInt("octree_max_depth", parameters);
	options.octreeLeafSize = readInt("octree_leaf_size", parameters);
	options.outputScalar =
	    sizeof(Scalarm) == sizeof(float) ? OutputScalar::Float : OutputScalar::Double;
	options.mergeFragments = parameters.getBool("merge_fragments");
	options.mergeCoplanar = parameters.getBool("merge_coplanar");
	options.weldNonManifold = parameters.getBool("weld_non_manifold");
	options.checkSelfIntersections = parameters.getBool("check_self_intersections");
	return options;
}

std::vector<Operation> readOperations(const RichParameterList& parameters) {
	std::vector<Operation> operations;
	for (const BlockDefinition& block : kBlockDefinitions) {
		if (parameters.getBool(operationName(block.operation)))
			operations.push_back(block.operation);
	}
	if (operations.empty())
		throw refusal(nothingRequestedMessage());
	return operations;
}

Task readTask(const RichParameterList& parameters, MeshDocument& document) {
	Task task;
	task.layers = {readLayer("first_mesh", parameters, document),
	               readLayer("second_mesh", parameters, document)};
	task.names = {nameOf(*task.layers[0]), nameOf(*task.layers[1])};
	if (task.layers[0] == task.layers[1])
		throw refusal(sameLayerMessage(task.names[0]));
	task.request.operations = readOperations(parameters);
	task.request.options = readOptions(parameters);
	return task;
}

void throwUnlessOk(const Status& status, const Task& task) {
	if (!status.ok())
		throw refusal(refusalMessage(status, task.names));
}

// Leaves the offending faces selected.
void showDefect(const Status& status, const OperandArrays& operands, const Task& task) {
	const std::size_t operand = status.operand == 1 ? 1 : 0;
	if (!status.faces.empty())
		selectFaces(status.faces, operands.faces[operand], *task.layers[operand]);
}

std::vector<QString> blockLabels(const Task& task) {
	std::vector<QString> labels;
	for (const Operation operation : task.request.operations) {
		labels.push_back(QString::fromStdString(
		    blockLabel(operation, task.names[0].label, task.names[1].label)));
	}
	return labels;
}

std::vector<int> idsOf(const std::vector<MeshModel*>& layers) {
	std::vector<int> ids;
	for (const MeshModel* layer : layers)
		ids.push_back(layer->id());
	return ids;
}

std::vector<std::string> findings(const BooleanResult& result, const AdapterSeconds& seconds,
                                  const LayerNames& names) {
	std::vector<std::string> messages;
	for (std::size_t k = 0; k < names.size(); ++k) {
		if (result.turned[k])
			messages.push_back(turnedMessage(names[k]));
		const std::size_t once = result.duplicates.takenOnce[k];
		const std::size_t cancelled = result.duplicates.cancelledPairs[k];
		if (once + cancelled > 0)
			messages.push_back(duplicatesMessage(names[k], once, cancelled));
	}
	for (std::size_t i = 0; i < result.blocks.size(); ++i) {
		const Block& block = result.blocks[i];
		messages.push_back(block.triangles.empty()
		                       ? emptyBlockMessage(block.operation, names)
		                       : blockMessage(block, result.audit.blocks[i], names));
	}
	messages.push_back(timeMessage(seconds.total, result.seconds));
	return messages;
}

RichMesh layerParameter(const ParameterDefinition& definition, const MeshDocument& document) {
	unsigned int id = 0;
	int position = 0;
	for (const MeshModel& layer : document.meshIterator()) {
		if (position++ <= definition.defaultValue)
			id = static_cast<unsigned int>(layer.id());
	}
	return RichMesh(definition.name, id, &document, definition.label, definition.help,
	                definition.advanced);
}

void addParameter(const ParameterDefinition& definition, const MeshDocument& document,
                  RichParameterList& list) {
	switch (definition.kind) {
	case ParameterKind::Layer:
		list.addParam(layerParameter(definition, document));
		break;
	case ParameterKind::Bool:
		list.addParam(RichBool(definition.name, definition.defaultValue != 0, definition.label,
		                       definition.help, definition.advanced));
		break;
	case ParameterKind::Int:
		list.addParam(RichInt(definition.name, definition.defaultValue, definition.label,
		                      definition.help, definition.advanced));
		break;
	}
}

}  // namespace

FilterIndexBoolean::FilterIndexBoolean() {
	for (const FilterDefinition& filter : filterDefinitions()) {
		typeList.push_back(static_cast<ActionIDType>(filter.id));
		actionList.push_back(new QAction(filter.menuName, this));
	}
}

QString FilterIndexBoolean::pluginName() const { return kPluginName; }

QString FilterIndexBoolean::vendor() const { return kVendor; }

QString FilterIndexBoolean::filterName(ActionIDType filter) const {
	return filterDefinition(filterId(filter)).menuName;
}

QString FilterIndexBoolean::pythonFilterName(ActionIDType filter) const {
	return filterDefinition(filterId(filter)).pythonName;
}

QString FilterIndexBoolean::filterInfo(ActionIDType filter) const {
	return QString::fromStdString(filterDefinition(filterId(filter)).help);
}

FilterPlugin::FilterClass FilterIndexBoolean::getClass(const QAction*) const {
	return static_cast<FilterClass>(FilterPlugin::Layer | FilterPlugin::Remeshing);
}

FilterPlugin::FilterArity FilterIndexBoolean::filterArity(const QAction*) const {
	return FilterPlugin::FIXED;
}

// The operands are parameters, so nothing is asked of the current layer.
int FilterIndexBoolean::getPreConditions(const QAction*) const { return MeshModel::MM_NONE; }

// Of the layers that were there, only the selection may change.
int FilterIndexBoolean::postCondition(const QAction*) const {
	return MeshModel::MM_VERTFLAGSELECT | MeshModel::MM_FACEFLAGSELECT;
}

RichParameterList FilterIndexBoolean::initParameterList(const QAction* action,
                                                        const MeshDocument& document) {
	RichParameterList list;
	for (const ParameterDefinition& parameter : filterDefinition(filterId(ID(action))).parameters)
		addParameter(parameter, document, list);
	return list;
}

std::map<std::string, QVariant> FilterIndexBoolean::applyFilter(const QAction* action,
                                                                const RichParameterList& parameters,
                                                                MeshDocument& document,
                                                                unsigned int& postConditionMask,
                                                                vcg::CallBackPos* callback) {
	try {
		postConditionMask = static_cast<unsigned int>(postCondition(action));
		switch (filterId(ID(action))) {
		case FilterId::GenerateIndexBoolean:
			return generateIndexBoolean(parameters, document, callback);
		}
		wrongActionCalled(action);
		return {};
	} catch (const MLException&) {
		throw;
	} catch (const std::exception& error) {
		throw refusal(unexpectedMessage(error.what()));
	} catch (...) {
		throw refusal(unexpectedMessage("unknown exception"));
	}
}

ResultMap FilterIndexBoolean::generateIndexBoolean(const RichParameterList& parameters,
                                                   MeshDocument& document,
                                                   vcg::CallBackPos* callback) {
	const Stopwatch total;
	const Task task = readTask(parameters, document);
	Progress progress(progressCallback(callback));
	AdapterSeconds seconds{};

	OperandArrays operands;
	throwUnlessOk(readLayers(task.layers, progress, operands), task);
	seconds.readLayers = total.seconds();

	BooleanResult result;
	const Status status = runBoolean(std::move(operands.arrays), task.request, progress, result);
	showDefect(status, operands, task);
	throwUnlessOk(status, task);

	const Stopwatch writing;
	std::vector<MeshModel*> layers;
	throwUnlessOk(addLayers(result.blocks, blockLabels(task), progress, document, layers), task);
	seconds.writeLayers = writing.seconds();

	seconds.total = total.seconds();

	for (const std::string& message : findings(result, seconds, task.names))
		log(message);
	return resultMap(result, idsOf(layers), seconds);
}
