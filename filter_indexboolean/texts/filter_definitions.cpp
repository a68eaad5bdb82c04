// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The texts and defaults of the filters and their parameters.
#include "texts/filter_definitions.h"

#include "texts/text_place.h"

#include <algorithm>
#include <cctype>

namespace index_boolean {

namespace {

// Short: in MeshLab's windows a dialog is as high as its help and all its parameters.
const char* const kPaper =
    "After <i>Mei and Tipper</i>, <b>\"Simple and Robust Boolean Operations for Triangulated "
    "Surfaces\"</b>, arXiv:1308.4434, 2013";

const char* const kBooleanHelp =
    "Intersects two closed layers <b>once</b> and adds a new layer for each block asked for: "
    "union, intersection, both differences, symmetric difference.<br>"
    "<b>Exact:</b> new points are rounded once, faces that are not cut keep every bit of their "
    "coordinates, and the new layers are closed.<br>"
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
    "Cuts two layers by each other, open or closed, or any number of them, and gives <b>every "
    "piece</b>: the <i>sub-surfaces</i> that each layer falls into, and the <i>sub-blocks</i>, the "
    "closed parts of space that all layers together bound.<br>"
    "It also <b>clips</b>: an open surface by a closed one, to what lies inside it or outside. "
    "What lies on it counts as inside.<br>"
    "All decisions are exact. A line that ends inside a surface does not part it; a sheet that "
    "ends inside a solid parts nothing there.<br>"
    "Pieces have colours and numbers. Each face has the scalar attributes <b>source_mesh</b> (0 "
    "first, 1 second; or the number in the list), <b>source_face</b> (its face in that layer), "
    "<b>sub_surface</b>, "
    "<b>block_front</b> and <b>block_back</b> (the sub-blocks on its two sides), faces of "
    "sub-blocks <b>sub_block</b> too; numbers start at 0, -1 is the outside.<br>"
    "The layers' matrices are applied. A layer that meets itself is cut by itself, too.<br>";

// The grammar is as wide as a dialog may be, so that it is low: MeshLab 2020.09 scrolls no dialog.
const char* const kExpressionHelp =
    "Intersects <b>any number of closed layers once</b> and adds a new layer for each statement of "
    "an expression over them.<br>"
    "<b>Layers</b> are named by id (<tt>3</tt>) or by label in double quotes "
    "(<tt>\"left wall\"</tt>; <tt>\\\"</tt> is a quote in it). <tt>visible</tt> and <tt>all</tt> "
    "are lists of layers, but for those without faces and those that this plugin has made.<br>"
    "<b>Operators</b>, in Python's precedence: <tt>~a</tt> not; <tt>a * b</tt>, <tt>a &amp; b</tt> "
    "both; <tt>a + b</tt>, <tt>a | b</tt> any; <tt>a - b</tt> a without b; <tt>a ^ b</tt> one.<br>"
    "<b>Functions</b> take layers, lists and expressions: <tt>union</tt>, <tt>intersection</tt>, "
    "<tt>difference</tt> (the first without all others), <tt>xor</tt> (an odd number of them), "
    "<tt>at_least(2, all)</tt>. Behind a single layer that comes first a list leaves that one out: "
    "<tt>difference(3, all)</tt>. Of one layer that meets itself: <tt>odd(a)</tt>, "
    "<tt>positive(a)</tt>, <tt>nonzero(a)</tt>, <tt>winding(a, 2)</tt> (twice around, or more).<br>"
    "<b>Statements</b> are separated by <tt>;</tt> and may have a name, which is the label of the "
    "new layer and can be used in later ones: "
    "<tt>walls = 0 - 1; rest = at_least(2, all) - walls</tt>.<pre>"
    "text = statement { \";\" statement } [ \";\" ]    statement = [ name \"=\" ] or    "
    "item = \"visible\" | \"all\" | or\n"
    "or = xor { \"|\" xor }    xor = and { \"^\" and }    and = sum { \"&amp;\" sum }    "
    "sum = product { (\"+\" | \"-\") product }\n"
    "product = factor { \"*\" factor }    factor = \"~\" factor | \"(\" or \")\" | operand | name "
    "| call\n"
    "call = (\"union\" | \"intersection\" | \"difference\" | \"xor\") "
    "\"(\" item { \",\" item } \")\"\n"
    "     | \"at_least\" \"(\" digits \",\" item { \",\" item } \")\" "
    "| (\"odd\" | \"positive\" | \"nonzero\") \"(\" operand \")\"\n"
    "     | \"winding\" \"(\" operand \",\" [ \"-\" ] digits \")\"\n"
    "name = letter or _ { letter, digit or _ }    "
    "operand = digits | '\"' { any but \" and \\ | \\\" | \\\\ } '\"'</pre>"
    "A statement that is true of the outside is refused; a part of it may be. The layers must be "
    "closed; one that meets itself is what its winding rule calls inside. New points are rounded "
    "once.<br>";

const char* const kResolveHelp =
    "Makes <b>one layer that meets itself into a surface that does not</b>: the boundary of what "
    "its winding rule calls inside. Overlapping parts become one, walls inside go.<br>"
    "<b>Outer hull:</b> inside is all that cannot be reached from outside, so cavities are filled, "
    "too.<br>"
    "<b>Exact:</b> new points are rounded once, faces that are not cut keep every bit of their "
    "coordinates. The layer must be closed; an open one is refused, with its border selected. Its "
    "matrix is applied.<br>";

const char* const kSign =
    "<b>The sign is negative inside.</b> Of a closed layer it is exact: that of the winding number "
    "around each point, and 0 on the surface. A closed layer that meets itself is taken for what "
    "its winding rule says: inner walls count for nothing. Of an open layer the side of the "
    "nearest face, edge or vertex decides, and the log says so.<br>";

const char* const kDistanceHelp =
    "Measures how far each vertex and each face centre of one layer is from the nearest point of "
    "another layer, in both directions at once: how far is the scan from the design?<br>"
    "Values go to the layers themselves: vertex and face <b>quality</b>, colours, and the custom "
    "attribute <b>distance</b>; where asked for, <b>distance_direction</b>, <b>closest_point</b> "
    "and <b>closest_face</b>. The log and the result map have minimum, maximum, mean, root mean "
    "square, and the Hausdorff distance of the two sets of points.<br>";

const char* const kImplicitHelp =
    "Evaluates a layer as an implicit function at the vertices of another one, which may be a "
    "grid, a sampling or any cloud of points: the signed distance, on request its gradient (as "
    "normals and the custom attribute <b>distance_direction</b>), and which points are inside "
    "(selected).<br>"
    "Values go to the points' layer: vertex <b>quality</b> and the custom attribute "
    "<b>distance</b>.<br>";

const char* const kDistancePapers =
    "The layers' matrices are applied.<br>"
    "<br>See:<br><i>C. Quammen, C. Weigle, R. Taylor</i><br><b>\"Boolean Operations on Surfaces in "
    "VTK Without External Libraries\"</b><br>The VTK Journal, 2011, sections 3.1 and 3.2<br>"
    "<i>J. A. B&aelig;rentzen, H. Aan&aelig;s</i><br><b>\"Signed Distance Computation Using the "
    "Angle Weighted Pseudonormal\"</b><br>IEEE TVCG 11(3), 2005";

constexpr ParameterKind kBool = ParameterKind::Bool, kInt = ParameterKind::Int,
                        kChoice = ParameterKind::Choice, kText = ParameterKind::Text;

using ParameterList = std::vector<ParameterDefinition>;

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

const ParameterDefinition kMergeTolerance{
    "merge_tolerance",
    ParameterKind::Length,
    0,
    0,
    0,
    false,
    "Merge tolerance",
    "For models that are made in many steps, of which each cuts the walls of the one before once "
    "more. Connected faces of a new layer that lie within this of one plane become one polygon, "
    "chains of edges around it that lie within it of a straight line one edge, and vertices that "
    "then bear nothing go, where no attribute differs. No point of the surface moves farther. A "
    "length, or a percentage of the diagonal of the box around all layers; 1e-10 % undoes what "
    "rounding in double does. 0: only what is exactly coplanar is merged, as above.",
};

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

const ParameterDefinition kHideOperands{
    "hide_operands",
    kBool,
    0,
    0,
    1,
    false,
    "Hide the operands",
    "The layers that have been used are made invisible, so that the new ones can be seen."};

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

// How a block is finished, and what layers that meet themselves are: the same in all filters that
// make blocks.
ParameterList blockParameters() {
	return {
	    {"merge_fragments", kBool, 1, 0, 1, false, "Merge fragments",
	     "Cuts that separate nothing in a block are undone: fragments of one face become one "
	     "again, and new points on its edges that serve nothing are dropped. Off: all cuts "
	     "stay, so that blocks that touch have the same faces there."},
	    {"merge_coplanar", kBool, 0, 0, 1, false, "Merge coplanar faces",
	     "Neighbouring faces of a block that are exactly coplanar are merged too, and vertices "
	     "inside straight edges are dropped: the fewest faces, at the cost of vertices and "
	     "edges of the layers. Off: vertices of the layers stay."},
	    kMergeTolerance,
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
	     "vertices get those of the exact place in their face. Faces also get "
	     "source_mesh (the layer's number: 0 the first, 1 the second, ...) and source_face, "
	     "vertices source_mesh and source_vertex (-1: new)."},
	    {"duplicate_curve_vertices", kBool, 0, 0, 1, false, "Duplicate curve vertices",
	     "Where faces of different layers meet, each side gets vertices of its own, with the "
	     "values "
	     "of its own layer: hard edges in colours and normals. The blocks are closed once "
	     "equal "
	     "vertices are welded. Off: both sides share vertices, which have the values of the "
	     "first of them. Only with transfer_attributes."},
	    {"select_curve_vertices", kBool, 0, 0, 1, false, "Select curve vertices",
	     "The new layers' new vertices, which lie on the intersection curves, are left "
	     "selected, and no others. Only with transfer_attributes."},
	};
}

// Of two lists of parameters, one behind the other.
ParameterList operator+(ParameterList list, const ParameterList& more) {
	list.insert(list.end(), more.begin(), more.end());
	return list;
}

ParameterDefinition clipParameter(const char* name, const char* label, const char* help) {
	return {name, kBool, 0, 0, 1, false, label, help};
}

const ParameterDefinition kCutLayers{
    "layers",
    ParameterKind::Text,
    0,
    0,
    0,
    false,
    "Layers",
    "All layers that cut each other, in place of the first and the second: visible, all, or ids "
    "and labels separated by commas, labels in double quotes. Empty: the first and the second "
    "layer. visible and all leave out layers without faces and those that Index Boolean has made. "
    "A clip is of the first and the second layer all the same; they must be in the list."};

FilterDefinition booleanDefinition() {
	return {
	    FilterId::GenerateIndexBoolean,
	    "generate_index_boolean",
	    "Index Boolean: Union, Intersection and Differences",
	    std::string(kBooleanHelp) + kPaper,
	    ParameterList{
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
	    } + blockParameters() +
	        ParameterList{
	            {"curves", kBool, 0, 0, 1, false, "Intersection curves",
	             "A new layer with the lines in which A and B meet, as polylines: the same as that "
	             "of "
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
	        kCutLayers,
	        {"sub_surfaces_first", kBool, 1, 0, 1, false, "Sub-surfaces of the first",
	         "A new layer with A as it is cut by B, each sub-surface with a number and a colour. "
	         "Not used with a list of layers."},
	        {"sub_surfaces_second", kBool, 1, 0, 1, false, "Sub-surfaces of the second",
	         "A new layer with B as it is cut by A, each sub-surface with a number and a colour. "
	         "Not used with a list of layers."},
	        {"sub_surfaces", kBool, 1, 0, 1, false, "Sub-surfaces of each layer of the list",
	         "A new layer for each layer of the list, as all others cut it, each sub-surface with "
	         "a number and a colour. Used only with a list of layers."},
	        {"sub_blocks", kBool, 1, 0, 1, false, "Sub-blocks",
	         "A new layer with the closed boundaries of all parts of space that the layers bound, "
	         "each with a number and a colour."},
	        clipParameter("first_inside_second", "First inside second",
	                      "A new layer with what of A, open or closed, lies inside B or on it. B "
	                      "must be closed."),
	        clipParameter(
	            "first_outside_second", "First outside second",
	            "A new layer with what of A, open or closed, lies neither inside B nor on "
	            "it. B must be closed."),
	        clipParameter("second_inside_first", "Second inside first",
	                      "A new layer with what of B, open or closed, lies inside A or on it. A "
	                      "must be closed."),
	        clipParameter(
	            "second_outside_first", "Second outside first",
	            "A new layer with what of B, open or closed, lies neither inside A nor on "
	            "it. A must be closed."),
	        {"separate_layers", kBool, 0, 0, 1, false, "A layer for each piece",
	         "Each sub-surface and each sub-block gets a layer of its own, as long as these are at "
	         "most as many as stated below."},
	        {"max_layers", kInt, 64, 1, 1000, false, "Most layers",
	         "1 to 1000. If there are more pieces, all of a kind go into one layer, told apart by "
	         "their numbers and colours; the log says so."},
	        kMergeTolerance,
	        kSelfIntersections,
	        kWindingRule,
	        kWeldDistance,
	        kCertify,
	        kCertifyAs,
	        kHideOperands,
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

FilterDefinition expressionDefinition() {
	return {
	    FilterId::GenerateIndexBooleanExpression,
	    "generate_index_boolean_expression",
	    "Index Boolean: Expression over Layers",
	    std::string(kExpressionHelp) + kPaper,
	    ParameterList{
	        {"expression",
	         kText,
	         0,
	         0,
	         0,
	         false,
	         "Expression",
	         "What the new layers hold, for example 0 - 1, or union(visible), or "
	         "walls = 0 - 1; rest = at_least(2, all) - walls. Layers are named by their ids, or by "
	         "their labels in double quotes. The filter's help has the grammar.",
	         {},
	         "union(visible)"},
	    } + blockParameters() +
	        ParameterList{
	            {"curves", kBool, 0, 0, 1, false, "Intersection curves",
	             "A new layer with the lines in which different layers meet, as polylines."},
	            kHideOperands,
	            kOctreeMaxDepth,
	            kOctreeLeafSize,
	        },
	};
}

FilterDefinition resolveDefinition() {
	return {
	    FilterId::GenerateIndexBooleanResolve,
	    "generate_index_boolean_resolve",
	    "Index Boolean: Resolve Self-intersections",
	    std::string(kResolveHelp) + kPaper,
	    ParameterList{
	        layerParameter("mesh", ParameterDefinition::kCurrentLayer, "Layer",
	                       "The layer, A: a closed surface that may meet itself."),
	        {"outer_hull", kBool, 0, 0, 1, false, "Outer hull",
	         "Inside is all that cannot be reached from outside: cavities are filled, and walls "
	         "inside go, whatever the winding rule says. Off: inside is what the winding rule "
	         "calls so."},
	    } + blockParameters() +
	        ParameterList{
	            kOctreeMaxDepth,
	            kOctreeLeafSize,
	        },
	};
}

const ParameterDefinition kNegate{"negate",
                                  kBool,
                                  0,
                                  0,
                                  1,
                                  false,
                                  "Negate sign",
                                  "Positive inside and negative outside, and directions turned."};

const ParameterDefinition kMaxDistance{
    "max_distance",
    ParameterKind::Length,
    0,
    0,
    0,
    false,
    "Maximum distance",
    "Points farther away than this are not measured, which saves time: their custom attribute "
    "distance is no number (NaN), their quality this distance with its sign, their colour grey, "
    "and they are counted. A length, or a percentage of the diagonal of the box around all "
    "layers. 0: no maximum."};

FilterDefinition distanceDefinition() {
	return {
	    FilterId::ComputeIndexBooleanDistance,
	    "compute_index_boolean_distance",
	    "Index Boolean: Signed Distance between Two Layers",
	    std::string(kDistanceHelp) + kSign + kDistancePapers,
	    {
	        layerParameter("first_mesh", 0, "First layer",
	                       "The layer whose vertices and faces are measured: a surface, open or "
	                       "closed, or a cloud of points."),
	        layerParameter("second_mesh", 1, "Second layer",
	                       "The layer that distances are measured to: a surface, open or closed, "
	                       "another layer than the first."),
	        {"signed", kBool, 1, 0, 1, false, "Signed",
	         "Distances are negative inside the other layer. Off: never negative, to all faces as "
	         "they are, and no layer is searched for self-intersections."},
	        kNegate,
	        kSelfIntersections,
	        kWindingRule,
	        kWeldDistance,
	        {"at_vertices", kBool, 1, 0, 1, false, "At vertices",
	         "Vertices are measured: vertex quality and attributes."},
	        {"at_faces", kBool, 1, 0, 1, false, "At faces",
	         "The centres of faces are measured: face quality and attributes."},
	        {"both_ways", kBool, 1, 0, 1, false, "Both ways",
	         "The second layer's distances to the first are measured, too, unless that has no "
	         "faces."},
	        {"direction", kBool, 0, 0, 1, false, "Direction",
	         "The custom point attribute distance_direction: the unit vector in which the distance "
	         "grows, its gradient."},
	        {"closest", kBool, 0, 0, 1, false, "Closest point and face",
	         "The custom attributes closest_point and closest_face: the nearest point of the other "
	         "layer, with that layer's matrix applied, and the number of its face."},
	        kMaxDistance,
	        {"color", kBool, 1, 0, 1, false, "Colours",
	         "Vertices and faces are coloured by distance: blue below zero, white at zero, red "
	         "above. The range is symmetric around zero if distances are signed; the log has it."},
	    },
	    true,
	};
}

FilterDefinition implicitDefinition() {
	return {
	    FilterId::ComputeIndexBooleanImplicit,
	    "compute_index_boolean_implicit",
	    "Index Boolean: Implicit Function of a Layer",
	    std::string(kImplicitHelp) + kSign + kDistancePapers,
	    {
	        layerParameter("points_mesh", 0, "Points",
	                       "The layer at whose vertices the function is evaluated."),
	        layerParameter("reference_mesh", 1, "Surface",
	                       "The layer whose signed distance is the function: open or closed."),
	        {"gradient", kBool, 0, 0, 1, false, "Gradient",
	         "The function's gradient as vertex normals, and as the custom point attribute "
	         "distance_direction."},
	        {"select_inside", kBool, 1, 0, 1, false, "Select what is inside",
	         "The points inside the surface are left selected, and no others."},
	        kNegate,
	        kSelfIntersections,
	        kWindingRule,
	        kWeldDistance,
	        kMaxDistance,
	    },
	    true,
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

constexpr std::size_t kLongestLabel = 60;

std::string joinedLabel(const LayerName& left, const char* infix, const LayerName& right) {
	return nameInLabel(left) + " " + infix + " " + nameInLabel(right);
}

}  // namespace

const char* const kPluginName = "FilterIndexBoolean";
const char* const kVendor = "The Index Boolean authors";

const std::vector<FilterDefinition>& filterDefinitions() {
	static const std::vector<FilterDefinition> definitions{
	    booleanDefinition(), splitDefinition(),    curvesDefinition(),  expressionDefinition(),
	    resolveDefinition(), distanceDefinition(), implicitDefinition()};
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

std::string nameInLabel(const LayerName& layer) {
	std::string label = layer.label;
	const std::size_t dot = label.rfind('.');
	if (dot != std::string::npos && isFileSuffix(label.substr(dot + 1))) {
		label.erase(dot);
	}
	std::replace(label.begin(), label.end(), '.', '_');
	return label;
}

std::string blockLabel(Operation operation, const LayerNames& layers) {
	const BlockDefinition& block = kBlockDefinitions[static_cast<std::size_t>(operation)];
	const OperandId left = block.swapped ? kSecond : kFirst;
	return joinedLabel(layers[left], block.infix, layers[otherOf(left)]);
}

std::string curvesLabel(const LayerNames& layers) {
	if (layers.size() != 2) {
		return "curves of " + std::to_string(layers.size()) +
		       (layers.size() == 1 ? " layer" : " layers");
	}
	return joinedLabel(layers[kFirst], "curves", layers[kSecond]);
}

std::string statementLabel(const Statement& statement) {
	std::string label = statement.name.empty() ? statement.text : statement.name;
	std::replace(label.begin(), label.end(), '.', '_');
	std::replace_if(
	    label.begin(), label.end(), [](unsigned char c) { return c < ' '; }, ' ');
	return shortened(label, kLongestLabel);
}

std::string resolvedLabel(const LayerName& layer) { return nameInLabel(layer) + " resolved"; }

}  // namespace index_boolean
