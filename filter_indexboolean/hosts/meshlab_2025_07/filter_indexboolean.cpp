// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Definitions become the host's parameters, and back; what a filter does is in filter_run.
#include "filter_indexboolean.h"

#include <filters/filter_run.h>

#include <algorithm>

using namespace index_boolean;

namespace {

const FilterDefinition& definitionOf(int filter) {
	return filterDefinition(static_cast<FilterId>(filter));
}

// The layer that a dialog shows first; a document with too few layers gives its last.
unsigned int defaultLayer(const ParameterDefinition& definition, const MeshDocument& document) {
	const std::vector<int> ids = layerIds(document);
	if (ids.empty()) {
		return 0;
	}
	const auto position = static_cast<std::size_t>(definition.defaultValue);
	return static_cast<unsigned int>(ids[std::min(position, ids.size() - 1)]);
}

QStringList choicesOf(const ParameterDefinition& definition) {
	QStringList choices;
	for (const char* choice : definition.choices) {
		choices.append(choice);
	}
	return choices;
}

// What a percentage is of. Never 0: the host divides by it.
Scalarm diagonalOf(const MeshDocument& document) {
	const Scalarm diagonal = document.bbox().IsNull() ? 0 : document.bbox().Diag();
	return diagonal > 0 ? diagonal : 1;
}

void addParameter(const ParameterDefinition& definition, const MeshDocument& document,
                  RichParameterList& list) {
	switch (definition.kind) {
	case ParameterKind::Layer:
		list.addParam(RichMesh(definition.name, defaultLayer(definition, document), &document,
		                       definition.label, definition.help, definition.advanced));
		break;
	case ParameterKind::Bool:
		list.addParam(RichBool(definition.name, definition.defaultValue != 0, definition.label,
		                       definition.help, definition.advanced));
		break;
	case ParameterKind::Int:
		list.addParam(RichInt(definition.name, definition.defaultValue, definition.label,
		                      definition.help, definition.advanced));
		break;
	case ParameterKind::Choice:
		list.addParam(RichEnum(definition.name, definition.defaultValue, choicesOf(definition),
		                       definition.label, definition.help, definition.advanced));
		break;
	case ParameterKind::Length:
		list.addParam(RichPercentage(definition.name, Scalarm(definition.defaultValue), 0,
		                             diagonalOf(document), definition.label, definition.help,
		                             definition.advanced));
		break;
	}
}

int layerOf(const char* name, const RichParameterList& parameters) {
	return static_cast<int>(parameters.getMeshId(name));
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
	return definitionOf(filter).menuName;
}

QString FilterIndexBoolean::pythonFilterName(ActionIDType filter) const {
	return definitionOf(filter).pythonName;
}

QString FilterIndexBoolean::filterInfo(ActionIDType filter) const {
	return QString::fromStdString(definitionOf(filter).help);
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
	for (const ParameterDefinition& parameter : definitionOf(ID(action)).parameters) {
		addParameter(parameter, document, list);
	}
	return list;
}

std::map<std::string, QVariant> FilterIndexBoolean::applyFilter(const QAction* action,
                                                                const RichParameterList& parameters,
                                                                MeshDocument& document,
                                                                unsigned int& postConditionMask,
                                                                vcg::CallBackPos* callback) {
	try {
		postConditionMask = static_cast<unsigned int>(postCondition(action));
		const FilterDefinition& filter = definitionOf(ID(action));
		const ParameterValues values = readValues(
		    filter, parameters, [&](const char* name) { return layerOf(name, parameters); });
		const FilterOutput output = runFilter(filter.id, values, document, callback);
		for (const std::string& message : output.messages) {
			log(message);
		}
		return output.map;
	} catch (...) {
		throw MLException(QString::fromStdString(messageOfCaught()));
	}
}
