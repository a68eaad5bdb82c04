// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: what happened (a Status, an unusable parameter, a finding); out: the sentences that the user
// reads. Each refusal names the layer, the defect, how many, where, and what to do about it.
#pragma once

#include "runs/split_run.h"
#include "texts/filter_definitions.h"
#include "texts/layer_names.h"

#include <vcg_ext/index_boolean.h>

#include <string>
#include <vector>

namespace index_boolean {

// The operand that a status speaks of; the first, if it speaks of none alone.
OperandId operandOf(const Status& status);

// What a filter takes its layers for decides what can be done about one that it refuses.
enum class TakenFor { Solid, Surface };
TakenFor takenFor(FilterId filter);

// Why the run was refused. The status is not Ok.
std::string refusalMessage(const Status& status, const LayerNames& layers,
                           TakenFor kind = TakenFor::Solid);

// The parameter names a layer that the document does not have.
std::string unknownLayerMessage(const ParameterDefinition& parameter, int id);
std::string sameLayerMessage(const LayerName& layer);
std::string badLengthMessage(const ParameterDefinition& parameter, double length);
std::string outOfRangeMessage(const ParameterDefinition& parameter, int value);
std::string nothingRequestedMessage();

// An exception of the host or the standard library, which no input should lead to.
std::string unexpectedMessage(const char* what);

// The core has turned the layer's faces: it was inside out, or its matrix mirrors it.
std::string turnedMessage(const LayerName& layer);

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

// The layer does not carry these attributes, which the other one does. At least one.
std::string lackingAttributesMessage(const LayerName& layer,
                                     const std::vector<std::string>& attributes);

// What a block is like, for those who see the log and not the result map.
std::string blockMessage(const Block& block, const BlockMeasure& measure, const LayerNames& layers);

// All of the run's surfaces hold as they are stored.
std::string certifiedMessage(std::size_t surfaces, OutputScalar scalar);

// Faces of a new layer, more than none, that are flat or meet others wrongly as they are stored.
std::string uncertifiedMessage(const std::string& label, std::size_t faces, OutputScalar scalar);

// How many loops the curve has, of which kinds, and how long it is.
std::string curvesMessage(const CurveLines& curves, const LoopCounts& counts,
                          const LayerNames& layers);

std::string noPiecesRequestedMessage();

// How many pieces there are and of which kinds.
std::string subSurfacesMessage(const SplitResult& result, OperandId operand,
                               const LayerNames& layers);
std::string subBlocksMessage(const SplitResult& result, const LayerNames& layers);

// Why the pieces have not got a layer each.
std::string tooManyLayersMessage(std::size_t pieces, std::size_t maxLayers);

// How long the run took: as a whole, and its arithmetic.
std::string timeMessage(double totalSeconds, double coreSeconds);

// The block has no face: says what that means for the two layers.
std::string emptyBlockMessage(Operation operation, const LayerNames& layers);

}  // namespace index_boolean
