// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parameters in, layers and result map out. The steps are in generateIndexBoolean.
#include "filters/generate_index_boolean.h"

#include "attributes/attribute_transfer.h"
#include "layers/curve_layer.h"
#include "layers/layers.h"
#include "layers/operand_layers.h"
#include "runs/boolean_run.h"
#include "runs/stopwatch.h"
#include "texts/messages.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace index_boolean {

namespace {

constexpr FilterId kFilter = FilterId::GenerateIndexBoolean;

Options readOptions(const ParameterValues& values) {
	Options options = readSurfaceOptions(kFilter, values);
	options.mergeFragments = values.getBool("merge_fragments");
	options.mergeCoplanar = values.getBool("merge_coplanar");
	options.weldNonManifold = values.getBool("weld_non_manifold");
	return options;
}

std::vector<Operation> readOperations(const ParameterValues& values) {
	std::vector<Operation> operations;
	for (const BlockDefinition& block : kBlockDefinitions) {
		if (values.getBool(operationName(block.operation))) {
			operations.push_back(block.operation);
		}
	}
	if (operations.empty()) {
		throw Refusal(nothingRequestedMessage());
	}
	return operations;
}

// What carries the layers' attributes over, if that is wanted; completes the request and the arrays
// by what it needs.
std::unique_ptr<AttributeTransfer> attributeTransfer(const ParameterValues& values,
                                                     const OperandLayers& operands,
                                                     BooleanRequest& request, OperandArrays& read) {
	if (!values.getBool("transfer_attributes")) {
		return nullptr;
	}
	AttributeOptions options;
	options.partCurve = values.getBool("duplicate_curve_vertices");
	options.selectCurve = values.getBool("select_curve_vertices");
	auto transfer = std::make_unique<AttributeTransfer>(operands.layers, read, options);
	request.attributes = transfer->request();
	if (request.options.mergeCoplanar) {
		read.arrays.faceClass = transfer->faceClasses();
	}
	return transfer;
}

// \param transfer nullptr: no attributes are wanted
std::vector<LayerContent> contentsOf(const BooleanResult& result, const BooleanRequest& request,
                                     const OperandArrays& read, const AttributeTransfer* transfer,
                                     const LayerNames& names) {
	std::vector<LayerContent> contents;
	for (std::size_t i = 0; i < result.blocks.size(); ++i) {
		const Block& block = result.blocks[i];
		LayerContent content;
		content.label = QString::fromStdString(blockLabel(block.operation, names));
		content.surface = &block;
		content.selectedFaces = &block.certificate.faces;
		if (transfer != nullptr) {
			content.prepareAttributes = [&result, &block, transfer, i](MeshModel& layer,
			                                                           ElementWriters& writers) {
				transfer->prepare(block, result.sources[i], result.report.insideOut, layer,
				                  writers);
			};
		}
		contents.push_back(std::move(content));
	}
	if (request.curves) {
		contents.push_back(curveContent(result.curves, read, names));
	}
	return contents;
}

std::vector<int> idsOf(const std::vector<MeshModel*>& layers) {
	std::vector<int> ids;
	for (const MeshModel* layer : layers) {
		ids.push_back(layer->id());
	}
	return ids;
}

std::vector<std::string> findings(const BooleanResult& result, OutputScalar scalar, bool curves,
                                  const AttributeTransfer* transfer, const AdapterSeconds& seconds,
                                  const LayerNames& names) {
	std::vector<std::string> messages = operandMessages(result.report, names);
	if (transfer != nullptr) {
		transfer->addMessages(names, messages);
	}
	for (std::size_t i = 0; i < result.blocks.size(); ++i) {
		const Block& block = result.blocks[i];
		messages.push_back(block.triangles.empty()
		                       ? emptyBlockMessage(block.operation, names)
		                       : blockMessage(block, result.audit.blocks[i], names));
	}
	for (const Block& block : result.blocks) {
		if (!block.certificate.faces.empty()) {
			messages.push_back(uncertifiedMessage(blockLabel(block.operation, names),
			                                      block.certificate.faces.size(), scalar));
		}
	}
	if (std::all_of(result.blocks.begin(), result.blocks.end(),
	                [](const Block& block) { return block.certificate.count() == 0; })) {
		messages.push_back(certifiedMessage(result.blocks.size(), scalar));
	}
	if (curves) {
		messages.push_back(curvesMessage(result.curves, result.report.loopCounts, names));
	}
	messages.push_back(timeMessage(seconds.total, result.report.seconds));
	return messages;
}

}  // namespace

FilterOutput generateIndexBoolean(const ParameterValues& values, MeshDocument& document,
                                  HostCallback* callback) {
	const Stopwatch total;
	const OperandLayers operands = findOperandLayers(kFilter, values, document);
	BooleanRequest request;
	request.options = readOptions(values);
	request.operations = readOperations(values);
	request.curves = values.getBool("curves");
	Progress progress(progressCallback(callback));
	AdapterSeconds seconds{};

	OperandArrays read = readOperands(operands, progress);
	const std::unique_ptr<AttributeTransfer> transfer =
	    attributeTransfer(values, operands, request, read);
	seconds.readLayers = total.seconds();

	BooleanResult result;
	const InputAgain again = inputAgain(operands, read, progress);
	refuseDefect(runBoolean(std::move(read.arrays), again, request, progress, result), read,
	             operands);

	const Stopwatch writing;
	std::vector<MeshModel*> layers;
	const std::vector<LayerContent> contents =
	    contentsOf(result, request, read, transfer.get(), operands.names);
	refuseUnlessOk(addLayers(contents, progress, document, layers), operands.names);
	seconds.writeLayers = writing.seconds();

	seconds.total = total.seconds();
	return {resultMap(result, idsOf(layers), seconds),
	        findings(result, request.options.outputScalar, request.curves, transfer.get(), seconds,
	                 operands.names)};
}

}  // namespace index_boolean
