// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parameters in, layers and result map out. The steps are in generateIndexBoolean.
#include "filters/generate_index_boolean.h"

#include "filters/block_layers.h"
#include "layers/curve_layer.h"
#include "runs/boolean_run.h"
#include "runs/stopwatch.h"
#include "texts/messages.h"

#include <memory>
#include <utility>

namespace index_boolean {

namespace {

constexpr FilterId kFilter = FilterId::GenerateIndexBoolean;

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

std::vector<std::string> labelsOf(const std::vector<Operation>& operations,
                                  const LayerNames& names) {
	std::vector<std::string> labels;
	for (const Operation operation : operations) {
		labels.push_back(blockLabel(operation, names));
	}
	return labels;
}

std::vector<std::string> findings(const BooleanResult& result, const BooleanRequest& request,
                                  const AttributeTransfer* transfer, const AdapterSeconds& seconds,
                                  const LayerNames& names) {
	std::vector<std::string> messages = operandMessages(result.report, names);
	if (transfer != nullptr) {
		transfer->addMessages(names, messages);
	}
	const std::vector<std::string> labels = labelsOf(request.operations, names);
	for (std::size_t i = 0; i < result.blocks.size(); ++i) {
		const Block& block = result.blocks[i];
		messages.push_back(block.triangles.empty()
		                       ? emptyBlockMessage(block.operation, names)
		                       : blockMessage(labels[i], block, result.audit.blocks[i]));
	}
	addCertificateMessages(result, labels, request.options.outputScalar, messages);
	if (request.curves) {
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
	request.options = readBlockOptions(kFilter, values);
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
	std::vector<LayerContent> contents =
	    blockContents(result, labelsOf(request.operations, operands.names), transfer.get());
	if (request.curves) {
		contents.push_back(curveContent(result.curves, read, operands.names));
	}
	refuseUnlessOk(addLayers(contents, progress, document, layers), operands.names);
	seconds.writeLayers = writing.seconds();

	seconds.total = total.seconds();
	return {resultMap(result, idsOf(layers), seconds),
	        findings(result, request, transfer.get(), seconds, operands.names)};
}

}  // namespace index_boolean
