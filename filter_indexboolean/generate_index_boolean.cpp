// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parameters in, layers and result map out. The steps are in generateIndexBoolean.
#include "generate_index_boolean.h"

#include "boolean_run.h"
#include "layers.h"
#include "messages.h"
#include "operand_layers.h"
#include "stopwatch.h"

#include <utility>

namespace index_boolean {

namespace {

constexpr FilterId kFilter = FilterId::GenerateIndexBoolean;

Options readOptions(const ParameterValues& values) {
	Options options;
	options.octreeMaxDepth = numberInRange(kFilter, "octree_max_depth", values);
	options.octreeLeafSize = numberInRange(kFilter, "octree_leaf_size", values);
	options.outputScalar =
	    sizeof(Scalarm) == sizeof(float) ? OutputScalar::Float : OutputScalar::Double;
	options.mergeFragments = values.getBool("merge_fragments");
	options.mergeCoplanar = values.getBool("merge_coplanar");
	options.weldNonManifold = values.getBool("weld_non_manifold");
	options.checkSelfIntersections = values.getBool("check_self_intersections");
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

std::vector<QString> blockLabels(const std::vector<Operation>& operations,
                                 const LayerNames& names) {
	std::vector<QString> labels;
	for (const Operation operation : operations)
		labels.push_back(
		    QString::fromStdString(blockLabel(operation, names[0].label, names[1].label)));
	return labels;
}

std::vector<int> idsOf(const std::vector<MeshModel*>& layers) {
	std::vector<int> ids;
	for (const MeshModel* layer : layers)
		ids.push_back(layer->id());
	return ids;
}

std::vector<std::string> findings(const BooleanResult& result, const AdapterSeconds& seconds,
                                  const LayerNames& names) {
	std::vector<std::string> messages;
	for (std::size_t k = 0; k < names.size(); ++k) {
		if (result.turned[k])
			messages.push_back(turnedMessage(names[k]));
		const std::size_t once = result.duplicates.takenOnce[k];
		const std::size_t cancelled = result.duplicates.cancelledPairs[k];
		if (once + cancelled > 0)
			messages.push_back(duplicatesMessage(names[k], once, cancelled));
	}
	for (std::size_t i = 0; i < result.blocks.size(); ++i) {
		const Block& block = result.blocks[i];
		messages.push_back(block.triangles.empty()
		                       ? emptyBlockMessage(block.operation, names)
		                       : blockMessage(block, result.audit.blocks[i], names));
	}
	messages.push_back(timeMessage(seconds.total, result.seconds));
	return messages;
}

}  // namespace

FilterOutput generateIndexBoolean(const ParameterValues& values, MeshDocument& document,
                                  HostCallback* callback) {
	const Stopwatch total;
	const OperandLayers operands = findOperandLayers(kFilter, values, document);
	const BooleanRequest request{readOptions(values), readOperations(values)};
	Progress progress(progressCallback(callback));
	AdapterSeconds seconds{};

	OperandArrays read;
	refuseUnlessOk(readLayers(operands.layers, progress, read), operands.names);
	seconds.readLayers = total.seconds();

	BooleanResult result;
	const Status status = runBoolean(std::move(read.arrays), request, progress, result);
	selectDefect(status, read, operands);
	refuseUnlessOk(status, operands.names);

	const Stopwatch writing;
	std::vector<MeshModel*> layers;
	const std::vector<QString> labels = blockLabels(request.operations, operands.names);
	refuseUnlessOk(addLayers(result.blocks, labels, progress, document, layers), operands.names);
	seconds.writeLayers = writing.seconds();

	seconds.total = total.seconds();
	return {resultMap(result, idsOf(layers), seconds), findings(result, seconds, operands.names)};
}

}  // namespace index_boolean
