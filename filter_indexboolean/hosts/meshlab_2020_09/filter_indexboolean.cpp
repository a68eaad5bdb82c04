// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Definitions become the host's parameters, and back; what a filter does is in filter_run. What
// the host would end itself on (no layer to choose, an exception) is kept from it.
#include "filter_indexboolean.h"

#include <filters/filter_run.h>

#include <algorithm>

using namespace index_boolean;

namespace {

const FilterDefinition& definitionOf(int filter) {
	return filterDefinition(static_cast<FilterId>(filter));
}

// The host ends itself on a layer parameter in a document without layers: there it has none.
void addLayerParameter(const ParameterDefinition& definition, MeshDocument& document,
                       RichParameterList& list) {
	if (document.size() > 0) {
		const int position = std::min(definition.defaultValue, document.size() - 1);
		list.addParam(
		    RichMesh(definition.name, position, &document, definition.label, definition.help));
	}
}

QStringList choicesOf(const ParameterDefinition& definition) {
	QStringList choices;
	for (const char* choice : definition.choices) {
		choices.append(choice);
	}
	return choices;
}

// What a percentage is of. Never 0: the host divides by it.
Scalarm diagonalOf(MeshDocument& document) {
	const Scalarm diagonal = document.bbox().IsNull() ? 0 : document.bbox().Diag();
	return diagonal > 0 ? diagonal : 1;
}

void addParameter(const ParameterDefinition& definition, MeshDocument& document,
                  RichParameterList& list) {
	switch (definition.kind) {
	case ParameterKind::Layer:
		addLayerParameter(definition, document, list);
		break;
	case ParameterKind::Bool:
		list.addParam(RichBool(definition.name, definition.defaultValue != 0, definition.label,
		                       definition.help));
		break;
	case ParameterKind::Int:
		list.addParam(
		    RichInt(definition.name, definition.defaultValue, definition.label, definition.help));
		break;
	case ParameterKind::Choice:
		list.addParam(RichEnum(definition.name, definition.defaultValue, choicesOf(definition),
		                       definition.label, definition.help));
		break;
	case ParameterKind::Length:
		list.addParam(RichAbsPerc(definition.name, float(definition.defaultValue), 0,
		                          diagonalOf(document), definition.label, definition.help));
		break;
	}
}

int layerOf(const char* name, const RichParameterList& parameters) {
	const MeshModel* layer = parameters.getMesh(name);
	return layer != nullptr ? layer->id() : ParameterValues::kNoLayer;
}

}  // namespace

FilterIndexBoolean::FilterIndexBoolean() {
	for (const FilterDefinition& filter : filterDefinitions()) {
		typeList << static_cast<FilterIDType>(filter.id);
		actionList << new QAction(filter.menuName, this);
	}
}

QString FilterIndexBoolean::pluginName() const { return kPluginName; }

QString FilterIndexBoolean::filterName(FilterIDType filter) const {
	return definitionOf(filter).menuName;
}

QString FilterIndexBoolean::filterInfo(FilterIDType filter) const {
	return QString::fromStdString(definitionOf(filter).help);
}

QString FilterIndexBoolean::filterScriptFunctionName(FilterIDType filter) {
	return definitionOf(filter).pythonName;
}

MeshFilterInterface::FilterClass FilterIndexBoolean::getClass(QAction*) {
	return static_cast<FilterClass>(MeshFilterInterface::Layer | MeshFilterInterface::Remeshing);
}

MeshFilterInterface::FILTER_ARITY FilterIndexBoolean::filterArity(QAction*) const {
	return MeshFilterInterface::FIXED;
}

// Of the layers that were there, only the selection may change.
int FilterIndexBoolean::postCondition(QAction*) const {
	return MeshModel::MM_VERTFLAGSELECT | MeshModel::MM_FACEFLAGSELECT;
}

void FilterIndexBoolean::initParameterSet(QAction* action, MeshDocument& document,
                                          RichParameterList& list) {
	for (const ParameterDefinition& parameter : definitionOf(ID(action)).parameters) {
		addParameter(parameter, document, list);
	}
}

bool FilterIndexBoolean::applyFilter(QAction* action, MeshDocument& document,
                                     const RichParameterList& parameters,
                                     vcg::CallBackPos* callback) {
	try {
		const FilterDefinition& filter = definitionOf(ID(action));
		const ParameterValues values = readValues(
		    filter, parameters, [&](const char* name) { return layerOf(name, parameters); });
		const FilterOutput output = runFilter(filter.id, values, document, callback);
		for (const std::string& message : output.messages) {
			Log(message);
		}
		return true;
	} catch (...) {
		const std::string message = messageOfCaught();
		errorMessage = QString::fromStdString(message);
		Log(GLLogStream::WARNING, message);
		return false;
	}
}
