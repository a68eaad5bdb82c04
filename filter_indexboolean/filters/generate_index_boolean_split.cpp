// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parameters in, layers and result map out. The steps are in generateIndexBooleanSplit.
#include "filters/generate_index_boolean_split.h"

#include "attributes/attribute_transfer.h"
#include "layers/layers.h"
#include "layers/operand_layers.h"
#include "layers/split_layers.h"
#include "runs/split_run.h"
#include "runs/stopwatch.h"
#include "texts/messages.h"
#include "texts/split_names.h"

#include <algorithm>
#include <utility>

namespace index_boolean {

namespace {

constexpr FilterId kFilter = FilterId::GenerateIndexBooleanSplit;
constexpr double kSourcesShare = 0.05;

// The layers that cut each other, and what they are called.
struct SplitOperands {
	OperandLayers read;
	SplitNames names;
	std::vector<std::string> messages;  // on the list
};

bool isAnyClipAskedFor(const ParameterValues& values) {
	return std::any_of(kClipDefinitions.begin(), kClipDefinitions.end(),
	                   [&](const ClipDefinition& clip) { return values.getBool(clip.name); });
}

// Which operand of a list a layer is.
OperandId operandOfLayer(const LayerName& layer, const ParameterValues& values,
                         const LayerNames& list) {
	for (const OperandId operand : list.operands()) {
		if (list[operand].id == layer.id) {
			return operand;
		}
	}
	const auto clip = std::find_if(kClipDefinitions.begin(), kClipDefinitions.end(),
	                               [&](const ClipDefinition& c) { return values.getBool(c.name); });
	throw Refusal(clipOutOfListMessage(parameterDefinition(kFilter, clip->name), layer));
}

SplitOperands findSplitOperands(const ParameterValues& values, MeshDocument& document) {
	SplitOperands operands;
	const std::string& list = values.getText("layers");
	operands.names.isList = list.find_first_not_of(" \t\r\n") != std::string::npos;
	if (!operands.names.isList) {
		operands.read = findOperandLayers(kFilter, values, document);
		operands.names.layers = operands.read.names;
		return operands;
	}
	operands.read = layersNamed(
	    layersOfList("layers", list, layerDirectory(document), operands.messages), document);
	operands.read.kind = takenFor(kFilter);
	operands.names.layers = operands.read.names;
	operands.messages.push_back(operandNumbersMessage(operands.names.layers));
	if (isAnyClipAskedFor(values)) {
		const LayerNames two = findOperandLayers(kFilter, values, document).names;
		operands.names.first = operandOfLayer(two[kFirst], values, operands.names.layers);
		operands.names.second = operandOfLayer(two[kSecond], values, operands.names.layers);
	}
	return operands;
}

SplitRequest readRequest(const ParameterValues& values, const SplitNames& names) {
	SplitRequest request;
	request.options = readSurfaceOptions(kFilter, values);
	request.subSurfaces = PerOperand<bool>(names.layers.size());
	for (const OperandId operand : request.subSurfaces.operands()) {
		request.subSurfaces[operand] = values.getBool(
		    names.isList ? "sub_surfaces" : names.keyOf(Pieces::subSurfacesOf(operand)));
	}
	request.subBlocks = values.getBool("sub_blocks");
	request.separateLayers = values.getBool("separate_layers");
	request.maxLayers = static_cast<std::size_t>(numberInRange(kFilter, "max_layers", values));
	for (const ClipDefinition& clip : kClipDefinitions) {
		if (values.getBool(clip.name)) {
			const bool isFirst = clip.isFirstClipped;
			request.clips.push_back({isFirst ? names.first : names.second,
			                         isFirst ? names.second : names.first, clip.isInside});
		}
	}
	const auto& surfaces = request.subSurfaces;
	if (std::find(surfaces.begin(), surfaces.end(), true) == surfaces.end() && !request.subBlocks &&
	    request.clips.empty()) {
		throw Refusal(noPiecesRequestedMessage(names.isList));
	}
	return request;
}

// The attributes that this filter itself writes, beside those of where elements come from.
std::vector<const char*> attributeNames() {
	return {kFaceNumberNames.begin(), kFaceNumberNames.end()};
}

// The pieces' colours give way to the faces' own, if they have any.
LayerContent contentOf(const SplitLayer& layer, const AttributeSources& sources,
                       const AttributeTransfer& transfer, std::size_t operands) {
	LayerContent content;
	content.label = QString::fromStdString(layer.label);
	content.surface = &layer;
	content.selectedFaces = &layer.certificate.faces;
	content.prepareAttributes = [&, operands](MeshModel& model, ElementWriters& writers) {
		transfer.prepare(layer, sources, PerOperand<bool>(operands), model, writers);
	};
	for (std::size_t k = 0; k < layer.numbers.size(); ++k) {
		if (static_cast<FaceNumber>(k) != FaceNumber::SubBlock ||
		    layer.pieces.kind == PieceKind::SubBlocks) {
			content.faceAttributes.push_back({kFaceNumberNames[k], layer.numbers[k]});
		}
	}
	for (const Colour& c : layer.colours) {
		content.faceColours.emplace_back(c[0], c[1], c[2], std::uint8_t{255});
	}
	return content;
}

std::vector<LayerContent> contentsOf(const std::vector<SplitLayer>& layers,
                                     const std::vector<AttributeSources>& sources,
                                     const AttributeTransfer& transfer, std::size_t operands) {
	std::vector<LayerContent> contents;
	for (std::size_t i = 0; i < layers.size(); ++i) {
		contents.push_back(contentOf(layers[i], sources[i], transfer, operands));
	}
	return contents;
}

// Of each layer's elements.
Status findLayerSources(const AttributeTransfer& transfer, Progress& progress, SplitResult& result,
                        std::vector<SplitLayer>& layers, std::vector<AttributeSources>& sources) {
	const Stopwatch time;
	Monitor monitor = progress.nextPhase(kSourcesShare);
	Status status = findSources(result.arrangement, transfer.request(), monitor, layers, sources);
	result.report.addStage("attributes", time);
	return status;
}

PieceLayers layersByKind(const std::vector<SplitLayer>& layers,
                         const std::vector<MeshModel*>& added, std::size_t operands) {
	PieceLayers ids;
	ids.subSurfaces = PerOperand<std::vector<int>>(operands);
	for (std::size_t i = 0; i < layers.size(); ++i) {
		const Pieces& pieces = layers[i].pieces;
		switch (pieces.kind) {
		case PieceKind::SubSurfaces:
			ids.subSurfaces[pieces.operand].push_back(added[i]->id());
			break;
		case PieceKind::SubBlocks:
			ids.subBlocks.push_back(added[i]->id());
			break;
		case PieceKind::Clip:
			ids.clips.push_back(added[i]->id());
			break;
		}
	}
	return ids;
}

// One sentence for each kind of pieces that are not certified, or one for all.
void addCertificateMessages(const SplitResult& result, const SplitRequest& request,
                            const SplitNames& names, std::vector<std::string>& messages) {
	if (!request.options.certify) {
		return;
	}
	bool areAll = true;
	const auto add = [&](const Pieces& pieces, std::size_t faces) {
		if (faces > 0) {
			areAll = false;
			messages.push_back(
			    uncertifiedMessage(names.labelOf(pieces), faces, request.options.outputScalar));
		}
	};
	for (const OperandId operand : request.subSurfaces.operands()) {
		add(Pieces::subSurfacesOf(operand), result.surfaceMeshes[operand].certificate.faces.size());
	}
	std::size_t ofBlocks = 0;
	for (const SplitMesh& block : result.blockMeshes) {
		ofBlocks += block.certificate.faces.size();
	}
	add(Pieces::subBlocks(), ofBlocks);
	for (std::size_t i = 0; i < request.clips.size(); ++i) {
		add(Pieces::of(request.clips[i]), result.clipMeshes[i].certificate.faces.size());
	}
	if (areAll) {
		messages.push_back(certifiedMessage(pieceCount(result, request) + request.clips.size(),
		                                    request.options.outputScalar));
	}
}

std::vector<std::string> findings(const SplitResult& result, const SplitRequest& request,
                                  const AttributeTransfer& transfer, const AdapterSeconds& seconds,
                                  const SplitNames& names) {
	std::vector<std::string> messages = operandMessages(result.report, names.layers);
	transfer.addMessages(names.layers, messages);
	for (const OperandId operand : request.subSurfaces.operands()) {
		if (request.subSurfaces[operand]) {
			messages.push_back(subSurfacesMessage(result, operand, names));
		}
	}
	if (request.subBlocks) {
		messages.push_back(subBlocksMessage(result, names));
	}
	for (std::size_t i = 0; i < request.clips.size(); ++i) {
		messages.push_back(
		    clipMessage(request.clips[i], result.clipMeshes[i], result.clipMeasures[i], names));
	}
	if (result.split.surfaces.wallMerge.vertices > 0) {
		messages.push_back(mergedMessage("All pieces", result.split.surfaces.wallMerge));
	}
	addCertificateMessages(result, request, names, messages);
	if (request.separateLayers && !hasLayerForEachPiece(result, request)) {
		messages.push_back(tooManyLayersMessage(pieceCount(result, request), request.maxLayers));
	}
	messages.push_back(timeMessage(seconds.total, result.report.seconds));
	return messages;
}

// Throws Refusal unless Ok: of an operand that is not closed, as one that is to clip another.
void refuseSplit(const Status& status, const OperandArrays& read, const OperandLayers& operands) {
	if (status.code == StatusCode::NotClosed) {
		selectDefect(status, read, operands);
		throw Refusal(openSolidMessage(status, operands.names));
	}
	refuseDefect(status, read, operands);
}

}  // namespace

FilterOutput generateIndexBooleanSplit(const ParameterValues& values, MeshDocument& document,
                                       HostCallback* callback) {
	const Stopwatch total;
	SplitOperands split = findSplitOperands(values, document);
	const OperandLayers& operands = split.read;
	const std::size_t count = operands.names.size();
	const SplitRequest request = readRequest(values, split.names);
	Progress progress(progressCallback(callback));
	AdapterSeconds seconds{};

	OperandArrays read = readOperands(operands, progress);
	AttributeOptions attributes;
	attributes.reserved = attributeNames();
	const AttributeTransfer transfer(operands.layers, read, attributes);
	if (request.options.mergeTolerance > 0) {
		read.arrays.faceClass = transfer.faceClasses();
	}
	seconds.readLayers = total.seconds();

	SplitResult result;
	const InputAgain again = inputAgain(operands, read, progress);
	refuseSplit(runSplit(std::move(read.arrays), again, request, progress, result), read, operands);

	const Stopwatch writing;
	std::vector<SplitLayer> layers = splitLayers(result, request, split.names);
	std::vector<AttributeSources> sources;
	refuseUnlessOk(findLayerSources(transfer, progress, result, layers, sources), operands.names);
	std::vector<MeshModel*> added;
	refuseUnlessOk(
	    addLayers(contentsOf(layers, sources, transfer, count), progress, document, added),
	    operands.names);
	if (values.getBool("hide_operands")) {
		hideLayers(operands);
	}
	seconds.writeLayers = writing.seconds();
	seconds.total = total.seconds();
	std::vector<std::string>& messages = split.messages;
	for (std::string& message : findings(result, request, transfer, seconds, split.names)) {
		messages.push_back(std::move(message));
	}
	return {
	    resultMap(result, request.clips, split.names, layersByKind(layers, added, count), seconds),
	    messages};
}

}  // namespace index_boolean
