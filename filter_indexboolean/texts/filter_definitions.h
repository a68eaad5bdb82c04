// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What users see of the filters, as data: names, parameters, help texts. Free of any version of
// MeshLab's API, so that each host's adapter reads the same list.
#pragma once

#include "texts/layer_names.h"

#include <vcg_ext/index_boolean.h>

#include <array>
#include <string>
#include <vector>

namespace index_boolean {

enum class ParameterKind { Layer, Bool, Int, Choice, Text, Length };

struct ParameterDefinition {
	static constexpr int kCurrentLayer = -1;

	const char* name;
	ParameterKind kind;
	// Layer: the position in the document, or kCurrentLayer; Bool: 0 or 1; Choice: which of them;
	// Length: 0
	int defaultValue;
	int minimum, maximum;  // Int: the values that are accepted
	bool advanced;
	const char* label;
	const char* help;
	std::vector<const char*> choices = {};  // Choice: the words to choose from
	const char* defaultText = "";           // Text
};

// What results are certified as, in the order of the parameter certify_as.
enum class CertifyAs { Host, Float };

enum class FilterId {
	GenerateIndexBoolean,
	GenerateIndexBooleanSplit,
	GenerateIndexBooleanCurves,
	GenerateIndexBooleanExpression,
	GenerateIndexBooleanResolve,
	ComputeIndexBooleanDistance,
	ComputeIndexBooleanImplicit,
};

struct FilterDefinition {
	FilterId id;
	const char* pythonName;
	const char* menuName;
	std::string help;  // with simple HTML
	std::vector<ParameterDefinition> parameters;
	// It writes what it finds on the layers that are there; else it makes new ones.
	bool isMeasure = false;
};

// All filters of the plugin, in the order of the menu.
const std::vector<FilterDefinition>& filterDefinitions();

const FilterDefinition& filterDefinition(FilterId id);

// The parameter of that name; the filter must have it.
const ParameterDefinition& parameterDefinition(FilterId id, const std::string& name);

// A block that a user can ask for. Its parameter and its result keys are named by operationName.
struct BlockDefinition {
	Operation operation;
	bool swapped;       // the second layer's label comes first
	const char* infix;  // between the labels of the two layers
};

// In the order of the new layers.
constexpr std::array<BlockDefinition, kOperationCount> kBlockDefinitions{{
    {Operation::Union, false, "union"},
    {Operation::Intersection, false, "intersection"},
    {Operation::FirstMinusSecond, false, "minus"},
    {Operation::SecondMinusFirst, true, "minus"},
    {Operation::SymmetricDifference, false, "xor"},
}};

// A layer's label as a part of a new one: without the suffix of its file, and without dots. MeshLab
// takes what follows a dot for a suffix: "a.ply union b.ply" it would save as a.ply, over the
// operand, and a second layer of that label it would call "a(1).ply".
std::string nameInLabel(const LayerName& layer);

// The label of a block's layer: "A union B", "B minus A".
std::string blockLabel(Operation operation, const LayerNames& layers);

// The label of the polylines' layer: "A curves B"; of other than two layers, how many they are.
std::string curvesLabel(const LayerNames& layers);

// The label of a statement's layer: its name, else its text; of that, 60 characters, without dots.
std::string statementLabel(const Statement& statement);

// "A resolved".
std::string resolvedLabel(const LayerName& layer);

extern const char* const kPluginName;
extern const char* const kVendor;

}  // namespace index_boolean
