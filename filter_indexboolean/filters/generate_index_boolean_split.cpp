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

#include <utility>

namespace index_boolean {

namespace {

constexpr FilterId kFilter = FilterId::GenerateIndexBooleanSplit;
constexpr double kSourcesShare = 0.05;

SplitRequest readRequest(const ParameterValues& values) {
	SplitRequest request;
	request.options = readSurfaceOptions(kFilter, values);
	request.subSurfaces = {values.getBool("sub_surfaces_first"),
	                       values.getBool("sub_surfaces_second")};
	request.subBlocks = values.getBool("sub_blocks");
	request.separateLayers = values.getBool("separate_layers");
	request.maxLayers = static_cast<std::size_t>(numberInRange(kFilter, "max_layers", values));
	if (!request.subSurfaces[kFirst] && !request.subSurfaces[kSecond] && !request.subBlocks) {
		throw Refusal(noPiecesRequestedMessage());
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
		    layer.kind == PieceKind::SubBlocks) {
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
                         const std::vector<MeshModel*>& added) {
	PieceLayers ids;
	for (std::size_t i = 0; i < layers.size(); ++i) {
		ids[static_cast<std::size_t>(layers[i].kind)].push_back(added[i]->id());
	}
	return ids;
}

// One sentence for each kind of pieces that are not certified, or one for all.
void addCertificateMessages(const SplitResult& result, const SplitRequest& request,
                            const LayerNames& names, std::vector<std::string>& messages) {
	if (!request.options.certify) {
		return;
	}
	bool areAll = true;
	const auto add = [&](PieceKind kind, std::size_t faces) {
		if (faces > 0) {
			areAll = false;
			messages.push_back(
			    uncertifiedMessage(splitLabel(kind, names), faces, request.options.outputScalar));
		}
	};
	for (const OperandId operand : request.subSurfaces.operands()) {
		add(subSurfacesOf(operand), result.surfaceMeshes[operand].certificate.faces.size());
	}
	std::size_t ofBlocks = 0;
	for (const SplitMesh& block : result.blockMeshes) {
		ofBlocks += block.certificate.faces.size();
	}
	add(PieceKind::SubBlocks, ofBlocks);
	if (areAll) {
		messages.push_back(
		    certifiedMessage(pieceCount(result, request), request.options.outputScalar));
	}
}

std::vector<std::string> findings(const SplitResult& result, const SplitRequest& request,
                                  const AttributeTransfer& transfer, const AdapterSeconds& seconds,
                                  const LayerNames& names) {
	std::vector<std::string> messages = operandMessages(result.report, names);
	transfer.addMessages(names, messages);
	for (const OperandId operand : request.subSurfaces.operands()) {
		if (request.subSurfaces[operand]) {
			messages.push_back(subSurfacesMessage(result, operand, names));
		}
	}
	if (request.subBlocks) {
		messages.push_back(subBlocksMessage(result, names));
	}
	addCertificateMessages(result, request, names, messages);
	if (request.separateLayers && !hasLayerForEachPiece(result, request)) {
		messages.push_back(tooManyLayersMessage(pieceCount(result, request), request.maxLayers));
	}
	messages.push_back(timeMessage(seconds.total, result.report.seconds));
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
	AttributeOptions attributes;
	attributes.reserved = attributeNames();
	const AttributeTransfer transfer(operands.layers, read, attributes);
	seconds.readLayers = total.seconds();

	SplitResult result;
	const InputAgain again = inputAgain(operands, read, progress);
	refuseDefect(runSplit(std::move(read.arrays), again, request, progress, result), read,
	             operands);

	const Stopwatch writing;
	std::vector<SplitLayer> layers = splitLayers(result, request, operands.names);
	std::vector<AttributeSources> sources;
	refuseUnlessOk(findLayerSources(transfer, progress, result, layers, sources), operands.names);
	std::vector<MeshModel*> added;
	refuseUnlessOk(addLayers(contentsOf(layers, sources, transfer, operands.names.size()), progress,
	                         document, added),
	               operands.names);
	seconds.writeLayers = writing.seconds();
	seconds.total = total.seconds();
	return {resultMap(result, layersByKind(layers, added), seconds),
	        findings(result, request, transfer, seconds, operands.names)};
}

}  // namespace index_boolean
