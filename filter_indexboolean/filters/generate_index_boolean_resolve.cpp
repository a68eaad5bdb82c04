// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The expression of one operand, in terms of a filter.
#include "filters/generate_index_boolean_resolve.h"

#include "filters/block_layers.h"
#include "runs/expression_run.h"
#include "runs/stopwatch.h"
#include "texts/messages.h"

#include <utility>

namespace index_boolean {

namespace {

constexpr FilterId kFilter = FilterId::GenerateIndexBooleanResolve;

}  // namespace

FilterOutput generateIndexBooleanResolve(const ParameterValues& values, MeshDocument& document,
                                         HostCallback* callback) {
	const Stopwatch total;
	const OperandLayers operands =
	    layersNamed({layerGiven(kFilter, "mesh", values, document)}, document);
	ExpressionRequest request;
	request.options = readBlockOptions(kFilter, values);
	request.outerHull = values.getBool("outer_hull");
	Progress progress(progressCallback(callback));
	AdapterSeconds seconds{};

	OperandArrays read = readOperands(operands, progress);
	const std::unique_ptr<AttributeTransfer> transfer =
	    attributeTransfer(values, operands, request, read);
	seconds.readLayers = total.seconds();

	ExpressionResult result;
	const InputAgain again = inputAgain(operands, read, progress);
	refuseDefect(runExpression(std::move(read.arrays), again,
	                           expressionOfOne(request.options.windingRule), request, progress,
	                           result),
	             read, operands);

	const Stopwatch writing;
	const std::vector<std::string> labels{resolvedLabel(operands.names[kFirst])};
	std::vector<MeshModel*> layers;
	refuseUnlessOk(
	    addLayers(blockContents(result, labels, transfer.get()), progress, document, layers),
	    operands.names);
	seconds.writeLayers = writing.seconds();

	std::vector<std::string> messages = operandMessages(result.report, operands.names);
	const Block& block = result.blocks.front();
	messages.push_back(block.triangles.empty()
	                       ? nothingInsideMessage(labels.front())
	                       : blockMessage(labels.front(), block, result.audit.blocks.front()));
	addCertificateMessages(result, labels, request.options.outputScalar, messages);
	seconds.total = total.seconds();
	messages.push_back(timeMessage(seconds.total, result.report.seconds));
	return {resultMap(result, layers.front()->id(), seconds), messages};
}

}  // namespace index_boolean
