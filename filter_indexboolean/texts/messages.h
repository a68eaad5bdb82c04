// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: what happened (a Status, an unusable parameter, a finding); out: the sentences that the user
// reads. Each refusal names the layer, the defect, how many, where, and what to do about it.
#pragma once

#include "runs/distance_run.h"
#include "runs/split_run.h"
#include "texts/filter_definitions.h"
#include "texts/layer_names.h"
#include "texts/split_names.h"

#include <vcg_ext/index_boolean.h>

#include <string>
#include <vector>

namespace index_boolean {

// The operand that a status speaks of; the first, if it speaks of none alone.
OperandId operandOf(const Status& status);

// What a filter takes its layers for decides what can be done about one that it refuses.
enum class TakenFor { Solid, Surface, Reference };
TakenFor takenFor(FilterId filter);

// Why the run was refused. The status is not Ok.
std::string refusalMessage(const Status& status, const LayerNames& layers,
                           TakenFor kind = TakenFor::Solid);

// The parameter names a layer that the document does not have.
std::string unknownLayerMessage(const ParameterDefinition& parameter, int id);
std::string sameLayerMessage(const LayerName& layer);
std::string outOfRangeMessage(const ParameterDefinition& parameter, int value);
std::string badLengthMessage(const ParameterDefinition& parameter, double length);
std::string nothingRequestedMessage();

// An exception of the host or the standard library, which no input should lead to.
std::string unexpectedMessage(const char* what);

// The core has turned the layer's faces: it was inside out, or its matrix mirrors it.
std::string turnedMessage(const LayerName& layer);

// The layers that a word for a set of them leaves out, since they have <what>. At least one.
std::string leftOutMessage(const std::string& word, const std::vector<LayerName>& layers,
                           const std::string& what);

// Half a sentence: several layers have a label; a word stands for no layer at all.
std::string severalLayersProblem(const std::string& label, const std::vector<int>& ids);
std::string emptySetProblem(const std::string& word);

// Faces of the layer were turned against their neighbours.
std::string turnedAlikeMessage(const LayerName& layer, std::size_t faces);

// Faces of the layer meet others of it wrongly, and that has been resolved.
std::string resolvedMessage(const LayerName& layer, std::size_t faces);

// Of these, some are triangles that concave polygons were read as.
std::string foldedFansMessage(const LayerName& layer, std::size_t polygons);

// Faces of the layer on the same three vertices as others have been left out: `takenOnce` that are
// equal to another, `cancelledPairs` of opposite ones. Not both are 0.
std::string duplicatesMessage(const LayerName& layer, std::size_t takenOnce,
                              std::size_t cancelledPairs);

// Vertices of layers were moved to the places of others, by weld_distance.
std::string weldedMessage(const VertexWeld& weld);

// What was done to the layers: of each of these, what is true.
std::vector<std::string> operandMessages(const RunReport& report, const LayerNames& layers);

// The layer does not carry these attributes, which another one does. At least one.
std::string lackingAttributesMessage(const LayerName& layer,
                                     const std::vector<std::string>& attributes);

// What a block is like, for those who see the log and not the result map.
std::string blockMessage(const std::string& label, const Block& block, const BlockMeasure& measure);

// No place is inside the statement with that label, or the layer.
std::string nothingInsideMessage(const std::string& label);

// Which layer each number in source_mesh stands for.
std::string operandNumbersMessage(const LayerNames& layers);

// Walls of a new layer, or of all pieces, were merged by merge_tolerance.
std::string mergedMessage(const std::string& what, const WallMerge& merge);

// All of the run's surfaces hold as they are stored.
std::string certifiedMessage(std::size_t surfaces, OutputScalar scalar);

// Faces of a new layer, more than none, that are flat or meet others wrongly as they are stored.
std::string uncertifiedMessage(const std::string& label, std::size_t faces, OutputScalar scalar);

// How many loops the curve has, of which kinds, and how long it is.
std::string curvesMessage(const CurveLines& curves, const LoopCounts& counts,
                          const LayerNames& layers);

// Of the split of a list, or of two layers.
std::string noPiecesRequestedMessage(bool isList);

// A clip is asked for, and a layer that takes part in it is not in the list of layers.
std::string clipOutOfListMessage(const ParameterDefinition& clip, const LayerName& layer);

// Why the run was refused: an operand is not closed, but is to clip another one.
std::string openSolidMessage(const Status& status, const LayerNames& layers);

// How many pieces there are and of which kinds.
std::string subSurfacesMessage(const SplitResult& result, OperandId operand,
                               const SplitNames& names);
std::string subBlocksMessage(const SplitResult& result, const SplitNames& names);

// What a clip is like.
std::string clipMessage(const Clip& clip, const SplitMesh& mesh, const BlockMeasure& measure,
                        const SplitNames& names);

// Why the pieces have not got a layer each.
std::string tooManyLayersMessage(std::size_t pieces, std::size_t maxLayers);

// How long the run took: as a whole, and its arithmetic.
std::string timeMessage(double totalSeconds, double coreSeconds);

// The block has no face: says what that means for the two layers.
std::string emptyBlockMessage(Operation operation, const LayerNames& layers);

// What was found of the layer that distances were measured to, as far as it is worth a sentence.
std::vector<std::string> distanceReferenceMessages(const DistanceResult& result,
                                                   const LayerName& layer);

// The distances of a layer from another one in numbers.
std::string distanceMessage(const DistanceStatistics& statistics, const LayerName& layer,
                            const LayerName& reference);

// What colours mean; what had no distance, empty if there was nothing such.
std::string distanceColourMessage(double range, bool isSigned);
std::vector<std::string> noDistanceMessages(const DistanceStatistics& statistics,
                                            const LayerName& layer);

// Distances of the second layer from the first were asked for, which has no faces.
std::string oneWayMessage(const LayerName& first);

std::string hausdorffMessage(double distance);
std::string nothingMeasuredMessage();

}  // namespace index_boolean
