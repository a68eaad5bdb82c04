// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The texts and defaults of the filters and their parameters.
#include "texts/filter_definitions.h"

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
    "<b>The layers</b> must be closed and consistently oriented, with any number of components and "
    "cavities. One that meets itself is resolved, one that is inside out is turned, and the log "
    "says so. One that cannot be used is refused with its defect and what to do, and the faces in "
    "question are left selected.<br>"
    "The layers' matrices are applied. An empty block is an empty layer.<br>";

const char* const kCurvesHelp =
    "Makes a polyline layer of all lines in which two layers meet, open or closed: vertices and "
    "edges, exact points correctly rounded.<br>"
    "The lines are parted into loops: <i>hard-closed</i> ones are rings; <i>soft-closed</i> ones "
    "run from junction to junction, where more than two lines meet; <i>open</i> ones end at a "
    "border. Each loop has vertices of its own, which carry the scalar attributes <b>loop</b> (its "
    "number), <b>loop_kind</b> (0 open, 1 hard-closed, 2 soft-closed), <b>source_face_first</b> "
    "and <b>source_face_second</b> (a face of each layer that meets there).<br>"
    "The layers' matrices are applied. Of the file formats, OBJ keeps edges.<br>";

const char* const kSplitHelp =
    "Cuts two layers by each other, open or closed, and gives <b>every piece</b>: the "
    "<i>sub-surfaces</i> that each layer falls into, and the <i>sub-blocks</i>, the closed parts "
    "of space that both layers together bound. So a surface is cut by a surface, a solid by a "
    "sheet, a block by faults and horizons.<br>"
    "All decisions are exact. A line that ends inside a surface does not part it; a sheet that "
    "ends inside a solid parts nothing there.<br>"
    "Pieces have colours and numbers. Each face has the scalar attributes <b>source_mesh</b> (0 "
    "first, 1 second), <b>source_face</b> (its face in that layer), <b>sub_surface</b>, "
    "<b>block_front</b> and <b>block_back</b> (the sub-blocks on its two sides), faces of "
    "sub-blocks <b>sub_block</b> too; numbers start at 0, -1 is the outside. They do not depend on "
    "the order of vertices and faces.<br>"
    "The layers' matrices are applied. A layer that meets itself is cut by itself, too.<br>";

constexpr ParameterKind kBool = ParameterKind::Bool, kInt = ParameterKind::Int,
                        kChoice = ParameterKind::Choice;

ParameterDefinition layerParameter(const char* name, int position, const char* label,
                                   const char* help) {
	return {name, ParameterKind::Layer, position, 0, 0, false, label, help};
}

const ParameterDefinition kFirstSolid =
    layerParameter("first_mesh", 0, "First layer", "The first operand, A: a closed surface.");

const ParameterDefinition kSecondSolid =
    layerParameter("second_mesh", 1, "Second layer",
                   "The second operand, B: a closed surface, another layer than the first.");

const ParameterDefinition kFirstSurface =
    layerParameter("first_mesh", 0, "First layer", "The first operand, A: open or closed.");

const ParameterDefinition kSecondSurface =
    layerParameter("second_mesh", 1, "Second layer",
                   "The second operand, B: open or closed, another layer than the first.");

const ParameterDefinition kSelfIntersections{
    "self_intersections",
    kChoice,
    0,
    0,
    2,
    false,
    "Self-intersections",
    "What is done about a layer whose faces meet others of it anywhere but in a common vertex or "
    "edge. resolve: each layer is searched, and one that meets itself is taken for what its "
    "winding rule says. trust: no search, for layers that are known to be clean; what shows all "
    "the same is resolved. refuse: searched and refused, with the faces selected.",
    {"resolve", "trust", "refuse"}};

const ParameterDefinition kWindingRule{
    "winding_rule",
    kChoice,
    0,
    0,
    2,
    false,
    "Winding rule",
    "What is inside a layer that meets itself, by how often its surface winds around a place. "
    "nonzero: all places that it winds around. positive: only where it does so right side out. "
    "odd: where it does so an odd number of times; the faces may be turned anyhow.",
    {"nonzero", "positive", "odd"}};

const ParameterDefinition kWeldDistance{
    "weld_distance",
    ParameterKind::Length,
    0,
    0,
    0,
    false,
    "Weld distance",
    "For layers that are cracked: whose faces do not quite meet. Before anything else, vertices of "
    "one layer that are nearer to each other than this, and chains of such vertices, become one, "
    "at the place of the one that comes first by x, y and z. A length, or a percentage of the "
    "diagonal of the box around all layers. Refused if such a chain leads more than twice as far. "
    "0: nothing is moved."};

const ParameterDefinition kCertify{
    "certify",
    kBool,
    1,
    0,
    1,
    false,
    "Certify results",
    "Whether each new surface holds as it is stored is found out and told: no two of its faces "
    "have a point in common but on common vertices and edges, and none is flat. Where rounding "
    "has made it otherwise, new points are moved by a few units in the last place until it does "
    "hold; what is left is counted, and the faces concerned are selected. Off: nothing is "
    "searched, moved or told."};

const ParameterDefinition kCertifyAs{
    "certify_as",
    kChoice,
    0,
    0,
    1,
    false,
    "Certify as stored in",
    "The numbers that the results will be kept in. host: those of the layers. float: coordinates "
    "are rounded to single precision, as STL files and MeshLab's window have them, so that what "
    "is saved as such is what has been certified.",
    {"host", "float"}};

const ParameterDefinition kOctreeMaxDepth{
    "octree_max_depth",
    kInt,
    12,
    1,
    20,
    true,
    "Octree: maximum depth",
    "How often the octree that finds the pairs of faces to intersect may divide a node: 1 to 20. "
    "Changes the running time, never the result."};

const ParameterDefinition kOctreeLeafSize{
    "octree_leaf_size",
    kInt,
    0,
    0,
    1000,
    true,
    "Octree: leaf size",
    "A node with a faces of A and b faces of B is not divided further if a times b is at most the "
    "square of this number: 0 to 1000. 0 lets the cost decide. Changes the running time, never the "
    "result."};

FilterDefinition booleanDefinition() {
	return {
	    FilterId::GenerateIndexBoolean,
	    "generate_index_boolean",
	    "Index Boolean: Union, Intersection and Differences",
	    std::string(kBooleanHelp) + kPaper,
	    {
	        kFirstSolid,
	        kSecondSolid,
	        {"union", kBool, 1, 0, 1, false, "Union",
	         "A new layer with the boundary of all that is inside A or inside B."},
	        {"intersection", kBool, 1, 0, 1, false, "Intersection",
	         "A new layer with the boundary of all that is inside both A and B."},
	        {"first_minus_second", kBool, 1, 0, 1, false, "First minus second",
	         "A new layer with the boundary of all that is inside A and not inside B."},
	        {"second_minus_first", kBool, 1, 0, 1, false, "Second minus first",
	         "A new layer with the boundary of all that is inside B and not inside A."},
	        {"symmetric_difference", kBool, 0, 0, 1, false, "Symmetric difference",
	         "A new layer with the boundary of all that is inside exactly one of A and B."},
	        {"merge_fragments", kBool, 1, 0, 1, false, "Merge fragments",
	         "Cuts that separate nothing in a block are undone: fragments of one face become one "
	         "again, and new points on its edges that serve nothing are dropped. Off: all cuts "
	         "stay, so that blocks that touch have the same faces there."},
	        {"merge_coplanar", kBool, 0, 0, 1, false, "Merge coplanar faces",
	         "Neighbouring faces of a block that are exactly coplanar are merged too, and vertices "
	         "inside straight edges are dropped: the fewest faces, at the cost of vertices and "
	         "edges of the layers. Off: vertices of the layers stay."},
	        {"weld_non_manifold", kBool, 0, 0, 1, false, "Weld non-manifold vertices",
	         "Where a block meets itself in an edge or a vertex, it keeps one vertex instead of "
	         "copies: edges with four faces. Off: copies of vertices pull the faces apart, so that "
	         "each block is a manifold mesh."},
	        kSelfIntersections,
	        kWindingRule,
	        kWeldDistance,
	        kCertify,
	        kCertifyAs,
	        {"transfer_attributes", kBool, 1, 0, 1, false, "Transfer attributes",
	         "Whatever the layers carry is carried over: colours, qualities, normals, radii, "
	         "curvature directions, texture coordinates with their textures, selection, and the "
	         "user's scalar and point attributes. What is not cut keeps its values bit by bit, new "
	         "vertices get those of the exact place in their face. Faces also get source_mesh (0 "
	         "first, 1 second) and source_face, vertices source_mesh and source_vertex (-1: new)."},
	        {"duplicate_curve_vertices", kBool, 0, 0, 1, false, "Duplicate curve vertices",
	         "Where faces of both layers meet, each side gets vertices of its own, with the values "
	         "of its own layer: hard edges in colours and normals. The blocks are closed once "
	         "equal "
	         "vertices are welded. Off: both sides share vertices, which have the values of the "
	         "first layer. Only with transfer_attributes."},
	        {"select_curve_vertices", kBool, 0, 0, 1, false, "Select curve vertices",
	         "The new layers' new vertices, which lie on the intersection curves, are left "
	         "selected, and no others. Only with transfer_attributes."},
	        {"curves", kBool, 0, 0, 1, false, "Intersection curves",
	         "A new layer with the lines in which A and B meet, as polylines: the same as that of "
	         "\"Index Boolean: Intersection Curves\" (generate_index_boolean_curves)."},
	        kOctreeMaxDepth,
	        kOctreeLeafSize,
	    },
	};
}

FilterDefinition splitDefinition() {
	return {
	    FilterId::GenerateIndexBooleanSplit,
	    "generate_index_boolean_split",
	    "Index Boolean: Split into Sub-surfaces and Sub-blocks",
	    std::string(kSplitHelp) + kPaper,
	    {
	        kFirstSurface,
	        kSecondSurface,
	        {"sub_surfaces_first", kBool, 1, 0, 1, false, "Sub-surfaces of the first",
	         "A new layer with A as it is cut by B, each sub-surface with a number and a colour."},
	        {"sub_surfaces_second", kBool, 1, 0, 1, false, "Sub-surfaces of the second",
	         "A new layer with B as it is cut by A, each sub-surface with a number and a colour."},
	        {"sub_blocks", kBool, 1, 0, 1, false, "Sub-blocks",
	         "A new layer with the closed boundaries of all parts of space that A and B bound, "
	         "each with a number and a colour."},
	        {"separate_layers", kBool, 0, 0, 1, false, "A layer for each piece",
	         "Each sub-surface and each sub-block gets a layer of its own, as long as these are at "
	         "most as many as stated below."},
	        {"max_layers", kInt, 64, 1, 1000, false, "Most layers",
	         "1 to 1000. If there are more pieces, all of a kind go into one layer, told apart by "
	         "their numbers and colours; the log says so."},
	        kSelfIntersections,
	        kWindingRule,
	        kWeldDistance,
	        kCertify,
	        kCertifyAs,
	        kOctreeMaxDepth,
	        kOctreeLeafSize,
	    },
	};
}

FilterDefinition curvesDefinition() {
	return {
	    FilterId::GenerateIndexBooleanCurves,
	    "generate_index_boolean_curves",
	    "Index Boolean: Intersection Curves",
	    std::string(kCurvesHelp) + kPaper,
	    {
	        kFirstSurface,
	        kSecondSurface,
	        kSelfIntersections,
	        kWindingRule,
	        kWeldDistance,
	        kOctreeMaxDepth,
	        kOctreeLeafSize,
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

// A layer's label as a part of a new one: without the suffix of its file, and without dots. MeshLab
// takes what follows a dot for a suffix: "a.ply union b.ply" it would save as a.ply, over the
// operand, and a second layer of that label it would call "a(1).ply".
std::string nameInLabel(std::string label) {
	const std::size_t dot = label.rfind('.');
	if (dot != std::string::npos && isFileSuffix(label.substr(dot + 1))) {
		label.erase(dot);
	}
	std::replace(label.begin(), label.end(), '.', '_');
	return label;
}

std::string joinedLabel(const LayerName& left, const char* infix, const LayerName& right) {
	return nameInLabel(left.label) + " " + infix + " " + nameInLabel(right.label);
}

}  // namespace

const char* const kPluginName = "FilterIndexBoolean";
const char* const kVendor = "The Index Boolean authors";

const std::vector<FilterDefinition>& filterDefinitions() {
	static const std::vector<FilterDefinition> definitions{booleanDefinition(), splitDefinition(),
	                                                       curvesDefinition()};
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

std::string blockLabel(Operation operation, const LayerNames& layers) {
	const BlockDefinition& block = kBlockDefinitions[static_cast<std::size_t>(operation)];
	const OperandId left = block.swapped ? kSecond : kFirst;
	return joinedLabel(layers[left], block.infix, layers[otherOf(left)]);
}

std::string splitLabel(PieceKind kind, const LayerNames& layers) {
	switch (kind) {
	case PieceKind::SubSurfacesOfFirst:
		return joinedLabel(layers[kFirst], "cut by", layers[kSecond]);
	case PieceKind::SubSurfacesOfSecond:
		return joinedLabel(layers[kSecond], "cut by", layers[kFirst]);
	case PieceKind::SubBlocks:
		break;
	}
	return joinedLabel(layers[kFirst], "blocks", layers[kSecond]);
}

std::string curvesLabel(const LayerNames& layers) {
	return joinedLabel(layers[kFirst], "curves", layers[kSecond]);
}

}  // namespace index_boolean
