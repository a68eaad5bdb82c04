// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The remedies are a table with one row for each StatusCode; the defect itself is described by the
// core, which knows its count and place.
#include "texts/messages.h"

#include <locale>
#include <sstream>

namespace index_boolean {

namespace {

constexpr const char* kReport =
    "Nothing was changed: no result is better than a wrong one. The layers, as they are, belong to "
    "the report.";

// What a sentence is about decides how it begins.
enum class Subject { OneLayer, AllLayers, Run };

struct Remedy {
	StatusCode code;
	Subject subject;
	const char* forSolid;    // what to do where the filter takes layers for solids,
	const char* forSurface;  // and for surfaces; null: the same
};

constexpr const char* kDoubleSided =
    "It is double-sided: each face is there once in each direction. \"Remove Duplicate Faces\" "
    "(meshing_remove_duplicate_faces) leaves one of each: a solid, if that is closed, else a sheet "
    "for generate_index_boolean_split (\"Index Boolean: Split into Sub-surfaces and Sub-blocks\").";

// Each of them is performed by tests/python/test_refusals.py, on layers that are refused so.
constexpr std::array<Remedy, kStatusCodeCount> kRemedies{{
    {StatusCode::Ok, Subject::Run, "", nullptr},
    {StatusCode::Cancelled, Subject::Run, "Run the filter again to get new layers.", nullptr},
    {StatusCode::OutOfMemory, Subject::Run,
     "Close other programs, or ask for fewer new layers at a time.", nullptr},
    {StatusCode::EmptyOperand, Subject::OneLayer,
     "Choose a layer with faces, and a weld_distance below the length of its edges.", nullptr},
    {StatusCode::NotFinite, Subject::OneLayer,
     "These faces are selected. If the layer's matrix is to blame, correct it. Else delete them "
     "with \"Delete Selected Faces and Vertices\" (meshing_remove_selected_vertices_and_faces); "
     "\"Close Holes\" (meshing_close_holes) then covers the hole that is left, without what was "
     "there.",
     "These faces are selected. If the layer's matrix is to blame, correct it. Else delete them "
     "with \"Delete Selected Faces and Vertices\" (meshing_remove_selected_vertices_and_faces)."},
    {StatusCode::IndexOutOfRange, Subject::OneLayer,
     "These faces are selected. The layer is damaged: load its file again.", nullptr},
    {StatusCode::TooLarge, Subject::AllLayers, "Cut them into parts first.", nullptr},
    {StatusCode::NotClosed, Subject::OneLayer,
     "The faces at these edges are selected. If it is a solid with holes, \"Close Holes\" "
     "(meshing_close_holes) closes those of up to maxholesize edges. If it is a sheet, "
     "generate_index_boolean_split (\"Index Boolean: Split into Sub-surfaces and Sub-blocks\") "
     "cuts with it.",
     nullptr},
    {StatusCode::NotOriented, Subject::OneLayer,
     "The faces at these edges are selected. No way of turning faces makes them agree. With "
     "winding_rule = odd it does not matter how they are turned.",
     nullptr},
    {StatusCode::NoVolume, Subject::OneLayer,
     "What has no inside is no solid. generate_index_boolean_split (\"Index Boolean: Split into "
     "Sub-surfaces and Sub-blocks\") takes it for a surface.",
     "What has no inside clips nothing: without a clip it is a surface like any other."},
    {StatusCode::NestedComponents, Subject::OneLayer, kReport, nullptr},
    {StatusCode::SelfIntersecting, Subject::OneLayer,
     "The faces found are selected. With self_intersections = resolve the layer is taken for what "
     "its winding rule says.",
     "The faces found are selected. With self_intersections = resolve the layer is cut by itself, "
     "too."},
    {StatusCode::InternalError, Subject::Run, kReport, nullptr},
    {StatusCode::WeldTooWide, Subject::OneLayer,
     "The faces at these vertices are selected. Choose a smaller weld_distance: one that is larger "
     "than the cracks and smaller than the edges.",
     nullptr},
    {StatusCode::BeyondFloat, Subject::OneLayer,
     "These faces are selected. With certify_as = host results are kept in double precision.",
     nullptr},
}};

constexpr bool rowsAreInOrder() {
	for (std::size_t i = 0; i < kRemedies.size(); ++i) {
		if (static_cast<std::size_t>(kRemedies[i].code) != i) {
			return false;
		}
	}
	return true;
}
static_assert(rowsAreInOrder(), "a row for each StatusCode, in its order");

std::string quoted(const LayerName& layer) {
	return "\"" + layer.label + "\" (id " + std::to_string(layer.id) + ")";
}

std::string counted(std::size_t count, const char* noun) {
	return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

// Six significant digits, whatever the program's locale.
std::string decimal(double number) {
	std::ostringstream text;
	text.imbue(std::locale::classic());
	text << number;
	return text.str();
}

// "a, b and c"; `last` stands before the last one.
std::string listed(const std::vector<std::string>& names, const char* last) {
	std::string list;
	for (std::size_t i = 0; i < names.size(); ++i) {
		list += i == 0 ? "" : i + 1 == names.size() ? last : ", ";
		list += names[i];
	}
	return list;
}

// All layers; of many, the first ones and how many more there are.
template <class Layers>
std::string allQuoted(const Layers& layers) {
	constexpr std::size_t kMost = 8;
	std::vector<std::string> names;
	for (const LayerName& layer : layers) {
		if (names.size() + 1 == kMost && layers.size() > kMost) {
			names.push_back(std::to_string(layers.size() - names.size()) + " more");
			break;
		}
		names.push_back(quoted(layer));
	}
	return listed(names, " and ");
}

std::string scalarName(OutputScalar scalar) {
	return scalar == OutputScalar::Float ? "single precision" : "double precision";
}

std::string noneRequested(const char* noun, const std::vector<std::string>& parameters) {
	return std::string("No ") + noun +
	       " is asked for. Set at least one of these to true: " + listed(parameters, ", ") + ".";
}

constexpr const char* kUnsignedReference =
    "What has no inside gives no signs. With self_intersections = trust distances are measured to "
    "its faces as they are.";

// What can be done about a layer that is taken for this. What distances are measured to may be
// open, as a surface, but is cut by nothing.
const char* wordsOf(const Remedy& remedy, TakenFor kind) {
	if (kind == TakenFor::Reference && remedy.code == StatusCode::NoVolume) {
		return kUnsignedReference;
	}
	const bool isCut = kind == TakenFor::Surface || remedy.code != StatusCode::SelfIntersecting;
	const bool isSurface = kind != TakenFor::Solid && isCut && remedy.forSurface != nullptr;
	return isSurface ? remedy.forSurface : remedy.forSolid;
}

// What describe(status) goes on from: the name of one layer, or a heading for its whole sentence.
std::string subjectOf(const Remedy& remedy, const Status& status, const LayerNames& layers) {
	switch (remedy.subject) {
	case Subject::OneLayer:
		return "Layer " + quoted(layers[operandOf(status)]) + " ";
	case Subject::AllLayers:
		return std::string(layers.size() == 1 ? "Layer " : "Layers ") + allQuoted(layers) + ": ";
	case Subject::Run:
		break;
	}
	return "Index Boolean: ";
}

}  // namespace

OperandId operandOf(const Status& status) {
	return status.operand < 0 ? kFirst
	                          : makeId<OperandTag>(static_cast<std::size_t>(status.operand));
}

TakenFor takenFor(FilterId filter) {
	switch (filter) {
	case FilterId::GenerateIndexBooleanSplit:
	case FilterId::GenerateIndexBooleanCurves:
		return TakenFor::Surface;
	case FilterId::ComputeIndexBooleanDistance:
	case FilterId::ComputeIndexBooleanImplicit:
		return TakenFor::Reference;
	default:
		return TakenFor::Solid;
	}
}

std::string refusalMessage(const Status& status, const LayerNames& layers, TakenFor kind) {
	const Remedy& remedy = kRemedies[static_cast<std::size_t>(status.code)];
	const std::string defect = subjectOf(remedy, status, layers) + describe(status) + ". ";
	if (status.closingDistance > 0) {
		return defect + "The faces at these edges are selected. They only just miss each other: " +
		       "with weld_distance = " + decimal(status.closingDistance) + " the layer is closed.";
	}
	if (status.code == StatusCode::EmptyOperand && status.count > 0) {
		return defect + kDoubleSided;
	}
	return defect + wordsOf(remedy, kind);
}

std::string unknownLayerMessage(const ParameterDefinition& parameter, int id) {
	return std::string("There is no layer with id ") + std::to_string(id) + ", which is given as " +
	       parameter.name + ". Choose a layer of the document.";
}

std::string sameLayerMessage(const LayerName& layer) {
	return "Layer " + quoted(layer) +
	       " is given as both first_mesh and second_mesh. Choose two layers; a layer is copied "
	       "with \"Duplicate Current layer\" (generate_copy_of_current_mesh).";
}

std::string badLengthMessage(const ParameterDefinition& parameter, double length) {
	return std::string(parameter.name) + " is " + decimal(length) +
	       ". Choose a length of 0 or more.";
}

std::string outOfRangeMessage(const ParameterDefinition& parameter, int value) {
	return std::string(parameter.name) + " is " + std::to_string(value) +
	       ". Choose a number from " + std::to_string(parameter.minimum) + " to " +
	       std::to_string(parameter.maximum) + ".";
}

std::string nothingRequestedMessage() {
	std::vector<std::string> names;
	for (const BlockDefinition& block : kBlockDefinitions) {
		names.emplace_back(operationName(block.operation));
	}
	return noneRequested("block", names);
}

std::string unexpectedMessage(const char* what) {
	return std::string("Index Boolean stopped on an unexpected error (") + what +
	       "). Nothing was changed.";
}

std::string turnedMessage(const LayerName& layer) {
	return "Layer " + quoted(layer) +
	       " is inside out, or mirrored by its matrix: its faces were taken right side out.";
}

std::string duplicatesMessage(const LayerName& layer, std::size_t takenOnce,
                              std::size_t cancelledPairs) {
	std::string text = "Layer " + quoted(layer) + " has faces on the same three vertices: ";
	if (takenOnce > 0) {
		text += counted(takenOnce, "duplicate face") + (takenOnce == 1 ? " was" : " were") +
		        " taken once";
	}
	if (cancelledPairs > 0) {
		text +=
		    (takenOnce > 0 ? ", " : "") + counted(cancelledPairs, "opposite pair") + " cancelled";
	}
	return text + ".";
}

std::string leftOutMessage(const std::string& word, const std::vector<LayerName>& layers,
                           const std::string& what) {
	const bool isOne = layers.size() == 1;
	return "\"" + word + "\" leaves out " + allQuoted(layers) + ", which " +
	       (isOne ? "has " : "have ") + what + (isOne ? "; name it" : "; name them") +
	       " by id or label to use " + (isOne ? "it" : "them") + " all the same.";
}

std::string severalLayersProblem(const std::string& label, const std::vector<int>& ids) {
	std::vector<std::string> names;
	for (const int id : ids) {
		names.push_back(std::to_string(id));
	}
	return "several layers have the label \"" + label + "\": name one of them by its id, " +
	       listed(names, " or ");
}

std::string emptySetProblem(const std::string& word) {
	return "\"" + word +
	       "\" stands for no layer: none has faces and has not been made by Index "
	       "Boolean";
}

std::string turnedAlikeMessage(const LayerName& layer, std::size_t faces) {
	return "Layer " + quoted(layer) + " has " + counted(faces, "face") +
	       (faces == 1 ? " that was" : " that were") + " turned as the neighbours are.";
}

std::string resolvedMessage(const LayerName& layer, std::size_t faces) {
	return "Layer " + quoted(layer) + " meets itself in " + counted(faces, "face") +
	       ", which have been resolved.";
}

std::string foldedFansMessage(const LayerName& layer, std::size_t polygons) {
	return "Layer " + quoted(layer) + " has " + counted(polygons, "polygon") +
	       " with triangles that lie on each other, as MeshLab's reader of PLY files makes of "
	       "concave polygons. Its reader of OBJ files does not.";
}

std::string weldedMessage(const VertexWeld& weld) {
	return std::to_string(weld.moved) + (weld.moved == 1 ? " vertex was" : " vertices were") +
	       " moved to the place of a neighbour, by " + decimal(weld.largestMove) + " at most.";
}

std::vector<std::string> operandMessages(const RunReport& report, const LayerNames& layers) {
	std::vector<std::string> messages;
	if (report.vertexWeld.moved > 0) {
		messages.push_back(weldedMessage(report.vertexWeld));
	}
	for (const OperandId operand : layers.operands()) {
		if (report.insideOut[operand]) {
			messages.push_back(turnedMessage(layers[operand]));
		}
		if (report.turnedAlike[operand] > 0) {
			messages.push_back(turnedAlikeMessage(layers[operand], report.turnedAlike[operand]));
		}
		if (report.selfIntersecting[operand] > 0) {
			messages.push_back(resolvedMessage(layers[operand], report.selfIntersecting[operand]));
		}
		if (report.foldedFans[operand] > 0) {
			messages.push_back(foldedFansMessage(layers[operand], report.foldedFans[operand]));
		}
		const std::size_t once = report.duplicates.takenOnce[operand];
		const std::size_t cancelled = report.duplicates.cancelledPairs[operand];
		if (once + cancelled > 0) {
			messages.push_back(duplicatesMessage(layers[operand], once, cancelled));
		}
	}
	return messages;
}

std::string lackingAttributesMessage(const LayerName& layer,
                                     const std::vector<std::string>& attributes) {
	return "Layer " + quoted(layer) + " has no " + listed(attributes, " and ") +
	       ": what comes of it has MeshLab's default there.";
}

std::string nothingInsideMessage(const std::string& label) {
	return "\"" + label + "\" is empty: it is true of no part of space.";
}

std::string operandNumbersMessage(const LayerNames& layers) {
	std::vector<std::string> names;
	for (const OperandId operand : layers.operands()) {
		names.push_back(std::to_string(operand.value) + " is " + quoted(layers[operand]));
	}
	return "Operands, by their numbers in source_mesh: " + listed(names, ", ") + ".";
}

std::string blockMessage(const std::string& label, const Block& block,
                         const BlockMeasure& measure) {
	return "\"" + label + "\": " + counted(block.triangles.size(), "face") + ", " +
	       counted(measure.components, "component") + ", volume " + decimal(measure.volume) +
	       ", area " + decimal(measure.area) + ".";
}

std::string mergedMessage(const std::string& what, const WallMerge& merge) {
	return what + ": " + std::to_string(merge.vertices) +
	       (merge.vertices == 1 ? " vertex" : " vertices") +
	       " went where walls were merged, from " + decimal(merge.largestMove) +
	       " beside them at most.";
}

std::string certifiedMessage(std::size_t surfaces, OutputScalar scalar) {
	return "Certified: as stored in " + scalarName(scalar) + ", the faces of " +
	       (surfaces == 1 ? "the new surface" : "each of the " + counted(surfaces, "new surface")) +
	       " meet in common vertices and edges only, and none is flat.";
}

std::string uncertifiedMessage(const std::string& label, std::size_t faces, OutputScalar scalar) {
	return "\"" + label + "\": " + counted(faces, "face") + (faces == 1 ? " is" : " are") +
	       " flat, or " + (faces == 1 ? "meets" : "meet") + " others wrongly, as stored in " +
	       scalarName(scalar) + ". " + (faces == 1 ? "It is" : "They are") +
	       " selected; the selection of the layers was not carried over.";
}

std::string curvesMessage(const CurveLines& curves, const LoopCounts& counts,
                          const LayerNames& layers) {
	const std::string label = "\"" + curvesLabel(layers) + "\"";
	if (curves.lines.empty()) {
		return label + " is empty: the layers do not meet in a line.";
	}
	double length = 0;
	for (const CurveLine& line : curves.lines) {
		length += line.length;
	}
	return label + ": " + counted(curves.lines.size(), "loop") + " (" +
	       std::to_string(counts.open) + " open, " + std::to_string(counts.hardClosed) +
	       " hard-closed, " + std::to_string(counts.softClosed) + " soft-closed), length " +
	       decimal(length) + ".";
}

std::string noPiecesRequestedMessage(bool isList) {
	std::vector<std::string> names;
	if (isList) {
		names.emplace_back("sub_surfaces");
	} else {
		names = {"sub_surfaces_first", "sub_surfaces_second"};
	}
	names.emplace_back("sub_blocks");
	for (const ClipDefinition& clip : kClipDefinitions) {
		names.emplace_back(clip.name);
	}
	return noneRequested("piece", names);
}

std::string clipOutOfListMessage(const ParameterDefinition& clip, const LayerName& layer) {
	return std::string(clip.name) + " is of first_mesh and second_mesh, and layer " +
	       quoted(layer) + " is not one of those that layers names. Add it there, or choose " +
	       "first_mesh and second_mesh among them, or leave layers empty.";
}

std::string openSolidMessage(const Status& status, const LayerNames& layers) {
	if (status.closingDistance > 0) {
		return refusalMessage(status, layers, TakenFor::Surface);
	}
	return "Layer " + quoted(layers[operandOf(status)]) + " " + describe(status) +
	       ". The faces at these edges are selected. What clips another layer must be closed, "
	       "since only then it has an inside: close it with \"Close Holes\" (meshing_close_holes). "
	       "The layer that is clipped may be open, and without a clip both may.";
}

std::string subSurfacesMessage(const SplitResult& result, OperandId operand,
                               const SplitNames& names) {
	std::size_t shared = 0, oneSided = 0, separating = 0;
	double area = 0;
	for (const SubSurfaceId id : result.split.surfaces.ofOperand[operand]) {
		const SubSurface& surface = at(result.split.surfaces.all, id);
		shared += surface.isPublic() ? 1 : 0;
		oneSided += surface.oneSided ? 1 : 0;
		separating += at(result.split.blocks.separates, id) != 0 ? 1 : 0;
		area += surface.area;
	}
	const std::size_t count = result.surfaceCount(operand);
	return "\"" + names.labelOf(Pieces::subSurfacesOf(operand)) +
	       "\": " + counted(count, "sub-surface") + " (" + std::to_string(count - shared) +
	       " private, " + std::to_string(shared) + " public; " + std::to_string(separating) +
	       " separating" +
	       (oneSided > 0 ? ", " + std::to_string(oneSided) + " one-sided" : std::string()) +
	       "), area " + decimal(area) + ".";
}

std::string subBlocksMessage(const SplitResult& result, const SplitNames& names) {
	const std::string label = "\"" + names.labelOf(Pieces::subBlocks()) + "\"";
	if (result.split.blocks.all.empty()) {
		return label + " is empty: the layers bound no part of space.";
	}
	double volume = 0;
	for (const SubBlock& block : result.split.blocks.all) {
		volume += block.volume;
	}
	return label + ": " + counted(result.split.blocks.all.size(), "sub-block") + ", volume " +
	       decimal(volume) + ".";
}

std::string clipMessage(const Clip& clip, const SplitMesh& mesh, const BlockMeasure& measure,
                        const SplitNames& names) {
	const std::string label = "\"" + names.labelOf(Pieces::of(clip)) + "\"";
	if (mesh.triangles.empty()) {
		return label + " is empty: nothing of " + quoted(names.layers[clip.surface]) + " lies " +
		       (clip.isInside ? "inside " : "outside ") + quoted(names.layers[clip.solid]) + ".";
	}
	return label + ": " + counted(mesh.triangles.size(), "face") + ", " +
	       counted(measure.components, "component") + ", area " + decimal(measure.area) + ".";
}

std::string tooManyLayersMessage(std::size_t pieces, std::size_t maxLayers) {
	return "There are " + std::to_string(pieces) + " pieces, more than max_layers (" +
	       std::to_string(maxLayers) +
	       "): all pieces of a kind are in one layer, told apart by the attributes sub_surface and "
	       "sub_block and by their colours.";
}

std::string timeMessage(double totalSeconds, double coreSeconds) {
	return "Index Boolean took " + decimal(totalSeconds) + " s, " + decimal(coreSeconds) +
	       " s of it without reading and writing layers.";
}

std::string emptyBlockMessage(Operation operation, const LayerNames& layers) {
	const std::string first = quoted(layers[kFirst]), second = quoted(layers[kSecond]);
	std::string reason;
	switch (operation) {
	case Operation::Union:
		reason = "neither layer encloses anything";
		break;
	case Operation::Intersection:
		reason = "the layers are disjoint";
		break;
	case Operation::FirstMinusSecond:
		reason = first + " lies within " + second;
		break;
	case Operation::SecondMinusFirst:
		reason = second + " lies within " + first;
		break;
	case Operation::SymmetricDifference:
		reason = "the layers enclose the same solid";
		break;
	}
	return "\"" + blockLabel(operation, layers) + "\" is empty: " + reason + ".";
}

std::vector<std::string> distanceReferenceMessages(const DistanceResult& result,
                                                   const LayerName& layer) {
	std::vector<std::string> messages;
	if (result.wasInsideOut) {
		messages.push_back(turnedMessage(layer));
	}
	if (result.isResolved) {
		messages.push_back("Layer " + quoted(layer) + " meets itself, in " +
		                   counted(result.selfIntersecting, "face") +
		                   ", or has components in each other: distances are to the boundary of "
		                   "what its winding rule calls inside.");
	}
	if (result.isSigned && !result.isClosed) {
		messages.push_back("Layer " + quoted(layer) +
		                   " is open: signs are those of the side of the nearest face, edge or "
		                   "vertex.");
	}
	return messages;
}

std::string distanceMessage(const DistanceStatistics& statistics, const LayerName& layer,
                            const LayerName& reference) {
	return "Distance of " + quoted(layer) + " from " + quoted(reference) + " at " +
	       counted(statistics.count, "point") + ": minimum " + decimal(statistics.min) +
	       ", maximum " + decimal(statistics.max) + ", mean " + decimal(statistics.mean) +
	       ", root mean square " + decimal(statistics.rms) + ", mean of absolute values " +
	       decimal(statistics.meanAbsolute) + ".";
}

std::string distanceColourMessage(double range, bool isSigned) {
	return "Colours: " +
	       (isSigned ? "blue at -" + decimal(range) + ", white at 0" : std::string("white at 0")) +
	       ", red at " + decimal(range) + ".";
}

std::vector<std::string> noDistanceMessages(const DistanceStatistics& statistics,
                                            const LayerName& layer) {
	std::vector<std::string> messages;
	if (statistics.beyond > 0) {
		messages.push_back("Layer " + quoted(layer) + ": " + counted(statistics.beyond, "point") +
		                   (statistics.beyond == 1 ? " is" : " are") +
		                   " farther away than max_distance, and not measured.");
	}
	if (statistics.noNumber > 0) {
		messages.push_back("Layer " + quoted(layer) + ": " + counted(statistics.noNumber, "point") +
		                   (statistics.noNumber == 1 ? " is" : " are") +
		                   " no place, with coordinates that are not finite, and not measured.");
	}
	return messages;
}

std::string oneWayMessage(const LayerName& first) {
	return "Layer " + quoted(first) +
	       " has no faces: distances from it are not measured, and there is no Hausdorff distance.";
}

std::string hausdorffMessage(double distance) {
	return "Hausdorff distance of the points measured: " + decimal(distance) + ".";
}

std::string nothingMeasuredMessage() {
	return noneRequested("place to measure at", {"at_vertices", "at_faces"});
}

}  // namespace index_boolean
