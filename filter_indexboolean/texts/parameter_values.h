// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a user has set, by the parameters' names: a layer's id, 0 or 1 of a switch, a number. The
// parameters of any host become this.
#pragma once

#include "texts/filter_definitions.h"

#include <map>
#include <string>

namespace index_boolean {

class ParameterValues {
public:
	// No layer's id, for a layer parameter that names none.
	static constexpr int kNoLayer = -1;

	void set(const std::string& name, int value) { values_[name] = value; }
	void setLength(const std::string& name, double length) { lengths_[name] = length; }

	bool getBool(const std::string& name) const { return getInt(name) != 0; }

	// The filter must have the parameter.
	int getInt(const std::string& name) const { return values_.at(name); }
	// The same; in the layers' unit, if it was given as a percentage, too.
	double getLength(const std::string& name) const { return lengths_.at(name); }

private:
	std::map<std::string, int> values_;
	std::map<std::string, double> lengths_;
};

// \param parameters any host's list of parameters
// \param layerOf    the id of the layer that a parameter of this name names, or kNoLayer
template <class HostParameters, class LayerOf>
ParameterValues readValues(const FilterDefinition& filter, const HostParameters& parameters,
                           LayerOf layerOf) {
	ParameterValues values;
	for (const ParameterDefinition& definition : filter.parameters) {
		const char* name = definition.name;
		switch (definition.kind) {
		case ParameterKind::Layer:
			values.set(name, layerOf(name));
			break;
		case ParameterKind::Bool:
			values.set(name, parameters.getBool(name) ? 1 : 0);
			break;
		case ParameterKind::Int:
			values.set(name, parameters.getInt(name));
			break;
		case ParameterKind::Choice:
			values.set(name, parameters.getEnum(name));
			break;
		case ParameterKind::Length:
			values.setLength(name, static_cast<double>(parameters.getAbsPerc(name)));
			break;
		}
	}
	return values;
}

}  // namespace index_boolean
