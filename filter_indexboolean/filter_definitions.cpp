// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The texts and defaults of the filters and their parameters.
#include "filter_definitions.h"

#include <algorithm>
#include <cctype>

namespace index_boolean {

namespace {

const char* const kPaper =
    "<br>See:<br>"
    "<i>Gang Mei, John C. Tipper</i><br>"
    "<b>\"Simple and Robust Boolean Operations for Triangulated Surfaces\"</b><br>"
    "arXiv:1308.4434, 2013; with <i>Meijun Zhou, Jiayu Qin</i>: Mathematics 11(12), 2713, 2023";

const char* const kBooleanHelp =
    "Intersects two closed layers <b>once</b> and adds a new layer for each block asked for: "
    "union, intersection, both differences, symmetric difference.<br>"
    "<b>Exact:</b> there is no tolerance; new points are rounded once, faces that are not cut keep "
    "every bit of their coordinates, and the new layers are closed.<br>"
    "<b>The layers</b> must be closed, consistently oriented and free of self-intersections, with "
    "any number of components and cavities. One that is inside out is turned, faces that are there "
    "twice are taken once, and the log says so. One that cannot be used is refused with its defect "
    "and what to do, and the faces in question are left selected.<br>"
    "The layers' matrices are applied. An empty block is an empty layer.<br>";

FilterDefinition booleanDefinition() {
	using Kind = ParameterKind;
	return {
	    FilterId::GenerateIndexBoolean,
	    "generate_index_boolean",
	    "Index Boolean: Union, Intersection and Differences",
	    std::string(kBooleanHelp) + kPaper,
	    {
	        {"first_mesh", Kind::Layer, 0, 0, 0, false, "First layer",
	         "The first operand, A: a closed surface."},
	        {"second_mesh", Kind::Layer, 1, 0, 0, false, "Second layer",
	         "The second operand, B: a closed surface, another layer than the first."},
	        {"union", Kind::Bool, 1, 0, 1, false, "Union",
	         "A new layer with the boundary of all that is inside A or inside B."},
	        {"intersection", Kind::Bool, 1, 0, 1, false, "Intersection",
	         "A new layer with the boundary of all that is inside both A and B."},
	        {"first_minus_second", Kind::Bool, 1, 0, 1, false, "First minus second",
	         "A new layer with the boundary of all that is inside A and not inside B."},
	        {"second_minus_first", Kind::Bool, 1, 0, 1, false, "Second minus first",
	         "A new layer with the boundary of all that is inside B and not inside A."},
	        {"symmetric_difference", Kind::Bool, 0, 0, 1, false, "Symmetric difference",
	         "A new layer with the boundary of all that is inside exactly one of A and B."},
	        {"merge_fragments", Kind::Bool, 1, 0, 1, false, "Merge fragments",
	         "Cuts that separate nothing in a block are undone: fragments of one face become one "
	         "again, and new points on its edges that serve nothing are dropped. Off: all cuts "
	         "stay, "
	         "so that blocks that touch have the same faces there."},
	        {"merge_coplanar", Kind::Bool, 0, 0, 1, false, "Merge coplanar faces",
	         "Neighbouring faces of a block that are exactly coplanar are merged too, and vertices "
	         "inside straight edges are dropped: the fewest faces, at the cost of vertices and "
	         "edges of the layers. Off: vertices of the layers stay."},
	        {"weld_non_manifold", Kind::Bool, 0, 0, 1, false, "Weld non-manifold vertices",
	         "Where a block meets itself in an edge or a vertex, it keeps one vertex instead of "
	         "copies: edges with four faces. Off: copies of vertices pull the faces apart, so that "
	         "each block is a manifold mesh."},
	        {"check_self_intersections", Kind::Bool, 0, 0, 1, false, "Check for self-intersections",
	         "Searches each layer for faces that meet others of the same layer anywhere but in a "
	         "common vertex or edge, before anything else; a layer that has any is refused, and "
	         "all of them are selected. Off: self-intersections are noticed only where the other "
	         "layer comes near."},
	        {"octree_max_depth", Kind::Int, 12, 1, 20, true, "Octree: maximum depth",
	         "How often the octree that finds the pairs of faces to intersect may divide a node: "
	         "1 to 20. Changes the running time, never the result."},
	        {"octree_leaf_size", Kind::Int, 0, 0, 1000, true, "Octree: leaf size",
	         "A node with a faces of A and b faces of B is not divided further if a times b is at "
	         "most the square of this number: 0 to 1000. 0 lets the cost decide. Changes the "
	         "running time, never the result."},
	    },
	};
}

// The end of a file's name, as in "ply" and "3ds", rather than of a number, as in "25" or "5 cube".
bool isFileSuffix(const std::string& text) {
	constexpr std::size_t kLongest = 4;
	const auto isLetter = [](unsigned char c) { return std::isalpha(c) != 0; };
	const auto isOther = [](unsigned char c) { return std::isalnum(c) == 0; };
	return text.size() <= kLongest && std::any_of(text.begin(), text.end(), isLetter) &&
	       std::none_of(text.begin(), text.end(), isOther);
}

}  // namespace

const char* const kPluginName = "FilterIndexBoolean";
const char* const kVendor = "The Index Boolean authors";

const std::vector<FilterDefinition>& filterDefinitions() {
	static const std::vector<FilterDefinition> definitions{booleanDefinition()};
	return definitions;
}

const FilterDefinition& filterDefinition(FilterId id) {
	return filterDefinitions()[static_cast<std::size_t>(id)];
}

const ParameterDefinition& parameterDefinition(FilterId id, const std::string& name) {
	const std::vector<ParameterDefinition>& parameters = filterDefinition(id).parameters;
	return *std::find_if(parameters.begin(), parameters.end(),
	                     [&](const ParameterDefinition& p) { return name == p.name; });
}

std::string nameInLabel(std::string label) {
	const std::size_t dot = label.rfind('.');
	if (dot != std::string::npos && isFileSuffix(label.substr(dot + 1)))
		label.erase(dot);
	std::replace(label.begin(), label.end(), '.', '_');
	return label;
}

std::string blockLabel(Operation operation, const std::string& first, const std::string& second) {
	const BlockDefinition& block = kBlockDefinitions[static_cast<std::size_t>(operation)];
	const std::string& left = block.swapped ? second : first;
	const std::string& right = block.swapped ? first : second;
	return nameInLabel(left) + " " + block.infix + " " + nameInLabel(right);
}

}  // namespace index_boolean
