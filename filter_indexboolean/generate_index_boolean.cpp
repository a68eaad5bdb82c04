// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parameters in, layers and result map out. The steps are in generateIndexBoolean.
#include "generate_index_boolean.h"

#include "boolean_run.h"
#include "curve_layer.h"
#include "layers.h"
#include "messages.h"
#include "operand_layers.h"
#include "stopwatch.h"

#include <utility>

namespace index_boolean {

namespace {

constexpr FilterId kFilter = FilterId::GenerateIndexBoolean;

Options readOptions(const ParameterValues& values) {
	Options options = readCommonOptions(kFilter, values);
	options.mergeFragments = values.getBool("merge_fragments");
	options.mergeCoplanar = values.getBool("merge_coplanar");
	options.weldNonManifold = values.getBool("weld_non_manifold");
	return options;
}

std::vector<Operation> readOperations(const ParameterValues& values) {
	std::vector<Operation> operations;
	for (const BlockDefinition& block : kBlockDefinitions) {
		if (values.getBool(operationName(block.operation)))
			operations.push_back(block.operation);
	}
	if (operations.empty())
		throw Refusal(nothingRequestedMessage());
	return operations;
}

std::vector<LayerContent> contentsOf(const BooleanResult& result, const BooleanRequest& request,
                                     const OperandArrays& read, const LayerNames& names) {
	std::vector<LayerContent> contents;
	for (const Block& block : result.blocks) {
		LayerContent content;
		content.label =
		    QString::fromStdString(blockLabel(block.operation, names[0].label, names[1].label));
		content.points = &block.points;
		content.triangles = &block.triangles;
		content.faux = &block.faux;
		contents.push_back(std::move(content));
	}
	if (request.curves)
		contents.push_back(curveContent(result.curves, read, names));
	return contents;
}

std::vector<int> idsOf(const std::vector<MeshModel*>& layers) {
	std::vector<int> ids;
	for (const MeshModel* layer : layers)
		ids.push_back(layer->id());
	return ids;
}

std::vector<std::string> findings(const BooleanResult& result, bool curves,
                                  const AdapterSeconds& seconds, const LayerNames& names) {
	std::vector<std::string> messages = operandMessages(result.turned, result.duplicates, names);
	for (std::size_t i = 0; i < result.blocks.size(); ++i) {
		const Block& block = result.blocks[i];
		messages.push_back(block.triangles.empty()
		                       ? emptyBlockMessage(block.operation, names)
		                       : blockMessage(block, result.audit.blocks[i], names));
	}
	if (curves)
		messages.push_back(curvesMessage(result.curves, result.loopCounts, names));
	messages.push_back(timeMessage(seconds.total, result.seconds));
	return messages;
}

}  // namespace

FilterOutput generateIndexBoolean(const ParameterValues& values, MeshDocument& document,
                                  HostCallback* callback) {
	const Stopwatch total;
	const OperandLayers operands = findOperandLayers(kFilter, values, document);
	const BooleanRequest request{readOptions(values), readOperations(values),
	                             values.getBool("curves")};
	Progress progress(progressCallback(callback));
	AdapterSeconds seconds{};

	OperandArrays read = readOperands(operands, progress);
	seconds.readLayers = total.seconds();

	BooleanResult result;
	refuseDefect(runBoolean(std::move(read.arrays), request, progress, result), read, operands);

	const Stopwatch writing;
	std::vector<MeshModel*> layers;
	const std::vector<LayerContent> contents = contentsOf(result, request, read, operands.names);
	refuseUnlessOk(addLayers(contents, progress, document, layers), operands.names);
	seconds.writeLayers = writing.seconds();

	seconds.total = total.seconds();
	return {resultMap(result, idsOf(layers), seconds),
	        findings(result, request.curves, seconds, operands.names)};
}

}  // namespace index_boolean
