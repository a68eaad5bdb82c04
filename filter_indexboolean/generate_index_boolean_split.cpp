// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parameters in, layers and result map out. The steps are in generateIndexBooleanSplit.
#include "generate_index_boolean_split.h"

#include "layers.h"
#include "messages.h"
#include "operand_layers.h"
#include "split_layers.h"
#include "split_run.h"
#include "stopwatch.h"

#include <utility>

namespace index_boolean {

namespace {

constexpr FilterId kFilter = FilterId::GenerateIndexBooleanSplit;

SplitRequest readRequest(const ParameterValues& values) {
	SplitRequest request;
	request.options = readCommonOptions(kFilter, values);
	request.subSurfaces = {values.getBool("sub_surfaces_first"),
	                       values.getBool("sub_surfaces_second")};
	request.subBlocks = values.getBool("sub_blocks");
	request.separateLayers = values.getBool("separate_layers");
	request.maxLayers = static_cast<std::size_t>(numberInRange(kFilter, "max_layers", values));
	if (!request.subSurfaces[0] && !request.subSurfaces[1] && !request.subBlocks)
		throw Refusal(noPiecesRequestedMessage());
	return request;
}

// Faces are numbered by the core as it was given them; here they get their positions in the layers.
ScalarAttribute sourceFaces(const SplitLayer& layer, const OperandArrays& read) {
	const auto of = [&layer](FaceNumber number) -> const std::vector<std::int32_t>& {
		return layer.numbers[static_cast<std::size_t>(number)];
	};
	const std::vector<std::int32_t>&meshes = of(FaceNumber::SourceMesh),
	      &faces = of(FaceNumber::SourceFace);
	ScalarAttribute attribute{kFaceNumberNames[static_cast<std::size_t>(FaceNumber::SourceFace)],
	                          {}};
	for (std::size_t i = 0; i < faces.size(); ++i) {
		const LiveElements& live = read.faces[static_cast<std::size_t>(meshes[i])];
		attribute.values.push_back(
		    static_cast<std::int32_t>(live[static_cast<std::size_t>(faces[i])]));
	}
	return attribute;
}

LayerContent contentOf(const SplitLayer& layer, const OperandArrays& read) {
	LayerContent content;
	content.label = QString::fromStdString(layer.label);
	content.points = &layer.points;
	content.triangles = &layer.triangles;
	for (std::size_t k = 0; k < layer.numbers.size(); ++k) {
		if (static_cast<FaceNumber>(k) == FaceNumber::SourceFace)
			content.faceAttributes.push_back(sourceFaces(layer, read));
		else if (static_cast<FaceNumber>(k) != FaceNumber::SubBlock ||
		         layer.kind == PieceKind::SubBlocks)
			content.faceAttributes.push_back({kFaceNumberNames[k], layer.numbers[k]});
	}
	for (const Colour& c : layer.colours)
		content.faceColours.emplace_back(c[0], c[1], c[2], std::uint8_t{255});
	return content;
}

std::vector<LayerContent> contentsOf(const std::vector<SplitLayer>& layers,
                                     const OperandArrays& read) {
	std::vector<LayerContent> contents;
	for (const SplitLayer& layer : layers)
		contents.push_back(contentOf(layer, read));
	return contents;
}

PieceLayers layersByKind(const std::vector<SplitLayer>& layers,
                         const std::vector<MeshModel*>& added) {
	PieceLayers ids;
	for (std::size_t i = 0; i < layers.size(); ++i)
		ids[static_cast<std::size_t>(layers[i].kind)].push_back(added[i]->id());
	return ids;
}

std::vector<std::string> findings(const SplitResult& result, const SplitRequest& request,
                                  const AdapterSeconds& seconds, const LayerNames& names) {
	const Arrangement& arrangement = result.arrangement;
	std::vector<std::string> messages =
	    operandMessages(arrangement.turned, arrangement.duplicates, names);
	for (std::size_t operand = 0; operand < 2; ++operand) {
		if (request.subSurfaces[operand])
			messages.push_back(subSurfacesMessage(result, operand, names));
	}
	if (request.subBlocks)
		messages.push_back(subBlocksMessage(result, names));
	if (request.separateLayers && !hasLayerForEachPiece(result, request))
		messages.push_back(tooManyLayersMessage(pieceCount(result, request), request.maxLayers));
	messages.push_back(timeMessage(seconds.total, result.seconds));
	return messages;
}

}  // namespace

FilterOutput generateIndexBooleanSplit(const ParameterValues& values, MeshDocument& document,
                                       HostCallback* callback) {
	const Stopwatch total;
	const OperandLayers operands = findOperandLayers(kFilter, values, document);
	const SplitRequest request = readRequest(values);
	Progress progress(progressCallback(callback));
	AdapterSeconds seconds{};

	OperandArrays read = readOperands(operands, progress);
	seconds.readLayers = total.seconds();

	SplitResult result;
	refuseDefect(runSplit(std::move(read.arrays), request, progress, result), read, operands);

	const Stopwatch writing;
	const std::vector<SplitLayer> layers = splitLayers(result, request, operands.names);
	std::vector<MeshModel*> added;
	refuseUnlessOk(addLayers(contentsOf(layers, read), progress, document, added), operands.names);
	seconds.writeLayers = writing.seconds();
	seconds.total = total.seconds();
	return {resultMap(result, layersByKind(layers, added), seconds),
	        findings(result, request, seconds, operands.names)};
}

}  // namespace index_boolean
