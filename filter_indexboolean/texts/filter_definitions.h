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

enum class ParameterKind { Layer, Bool, Int, Choice, Length };

struct ParameterDefinition {
	const char* name;
	ParameterKind kind;
	int defaultValue;  // Layer: the position in the document; Bool: 0 or 1; Choice: which of them;
	                   // Length: 0
	int minimum, maximum;  // Int: the values that are accepted
	bool advanced;
	const char* label;
	const char* help;
	std::vector<const char*> choices = {};  // Choice: the words to choose from
};

// What results are certified as, in the order of the parameter certify_as.
enum class CertifyAs { Host, Float };

enum class FilterId {
	GenerateIndexBoolean,
	GenerateIndexBooleanSplit,
	GenerateIndexBooleanCurves,
};

struct FilterDefinition {
	FilterId id;
	const char* pythonName;
	const char* menuName;
	std::string help;  // with simple HTML
	std::vector<ParameterDefinition> parameters;
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

// The label of a block's layer: "A union B", "B minus A". In this and the others, the layers'
// labels are without suffixes and dots, which MeshLab would take for the new layer's suffix.
std::string blockLabel(Operation operation, const LayerNames& layers);

// The pieces that a split can give, in the order of the new layers.
enum class PieceKind : std::uint8_t { SubSurfacesOfFirst, SubSurfacesOfSecond, SubBlocks };
constexpr int kPieceKindCount = 3;

constexpr PieceKind subSurfacesOf(OperandId operand) {
	return operand == kFirst ? PieceKind::SubSurfacesOfFirst : PieceKind::SubSurfacesOfSecond;
}

// Their parameters and result keys.
constexpr std::array<const char*, kPieceKindCount> kPieceNames{
    {"sub_surfaces_first", "sub_surfaces_second", "sub_blocks"}};

// The label of a layer of pieces: "A cut by B", "B cut by A", "A blocks B".
std::string splitLabel(PieceKind kind, const LayerNames& layers);

// The label of the polylines' layer: "A curves B".
std::string curvesLabel(const LayerNames& layers);

extern const char* const kPluginName;
extern const char* const kVendor;

}  // namespace index_boolean
