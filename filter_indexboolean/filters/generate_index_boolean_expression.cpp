// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parameters in, layers and result map out. The steps are in generateIndexBooleanExpression.
#include "filters/generate_index_boolean_expression.h"

#include "filters/block_layers.h"
#include "layers/curve_layer.h"
#include "runs/expression_run.h"
#include "runs/stopwatch.h"
#include "texts/messages.h"
#include "texts/text_place.h"

#include <set>
#include <utility>

namespace index_boolean {

namespace {

constexpr FilterId kFilter = FilterId::GenerateIndexBooleanExpression;

// Names the document's layers for an expression, by their ids.
class DocumentNames {
public:
	explicit DocumentNames(const MeshDocument& document) : directory_(layerDirectory(document)) {}

	OperandNames names() {
		return {[this](const std::string& digits) { return named(directory_.byId(digits)); },
		        [this](const std::string& label) { return named(directory_.byLabel(label)); },
		        [this](const std::string& word) { return listed(word); }};
	}

	// The layers with these ids, all of which have been found.
	std::vector<LayerName> layers(const std::vector<std::uint32_t>& ids) const {
		std::vector<LayerName> layers;
		for (const std::uint32_t id : ids) {
			layers.push_back(directory_.byId(std::to_string(id)).layer->name);
		}
		return layers;
	}

	// What the lists that have been asked for leave out.
	std::vector<std::string> messages() const {
		std::vector<std::string> all;
		for (const LayerSet set : asked_) {
			for (std::string& message : directory_.leftOutMessages(set)) {
				all.push_back(std::move(message));
			}
		}
		return all;
	}

private:
	static NamedOperand named(const FoundLayer& found) {
		return found.layer != nullptr
		           ? NamedOperand{true, static_cast<std::uint32_t>(found.layer->name.id), {}}
		           : NamedOperand{false, 0, found.problem};
	}

	std::vector<std::uint32_t> listed(const std::string& word) {
		LayerSet set{};
		isLayerSet(word, set);
		asked_.insert(set);
		std::vector<std::uint32_t> ids;
		for (const ListedLayer* layer : directory_.listed(set)) {
			ids.push_back(static_cast<std::uint32_t>(layer->name.id));
		}
		return ids;
	}

	LayerDirectory directory_;
	std::set<LayerSet> asked_;
};

Expression readText(const std::string& text, WindingRule rule, DocumentNames& names) {
	Expression expression;
	const auto problem = readExpression(text, names.names(), rule, expression);
	if (problem) {
		throw Refusal(messageAtPlace("Expression", text, problem->begin, problem->what + "."));
	}
	return expression;
}

std::vector<std::string> labelsOf(const Expression& expression) {
	std::vector<std::string> labels;
	for (const Statement& statement : expression.statements) {
		labels.push_back(statementLabel(statement));
	}
	return labels;
}

void addFindings(const ExpressionResult& result, const std::vector<std::string>& labels,
                 OutputScalar scalar, std::vector<std::string>& messages) {
	for (std::size_t i = 0; i < result.blocks.size(); ++i) {
		const Block& block = result.blocks[i];
		messages.push_back(block.triangles.empty()
		                       ? nothingInsideMessage(labels[i])
		                       : blockMessage(labels[i], block, result.audit.blocks[i]));
	}
	addCertificateMessages(result, labels, scalar, messages);
}

}  // namespace

FilterOutput generateIndexBooleanExpression(const ParameterValues& values, MeshDocument& document,
                                            HostCallback* callback) {
	const Stopwatch total;
	ExpressionRequest request;
	request.options = readBlockOptions(kFilter, values);
	request.curves = values.getBool("curves");
	DocumentNames documentNames(document);
	const Expression expression =
	    readText(values.getText("expression"), request.options.windingRule, documentNames);
	const OperandLayers operands = layersNamed(documentNames.layers(expression.operands), document);
	Progress progress(progressCallback(callback));
	AdapterSeconds seconds{};

	OperandArrays read = readOperands(operands, progress);
	const std::unique_ptr<AttributeTransfer> transfer =
	    attributeTransfer(values, operands, request, read);
	seconds.readLayers = total.seconds();

	ExpressionResult result;
	const InputAgain again = inputAgain(operands, read, progress);
	refuseDefect(
	    runExpression(std::move(read.arrays), again, expression, request, progress, result), read,
	    operands);

	const Stopwatch writing;
	const std::vector<std::string> labels = labelsOf(expression);
	std::vector<LayerContent> contents = blockContents(result, labels, transfer.get());
	if (request.curves) {
		contents.push_back(curveContent(result.curves, read, operands.names));
	}
	std::vector<MeshModel*> layers;
	refuseUnlessOk(addLayers(contents, progress, document, layers), operands.names);
	if (values.getBool("hide_operands")) {
		hideLayers(operands);
	}
	seconds.writeLayers = writing.seconds();

	std::vector<std::string> messages = documentNames.messages();
	messages.push_back(operandNumbersMessage(operands.names));
	for (std::string& message : operandMessages(result.report, operands.names)) {
		messages.push_back(std::move(message));
	}
	if (transfer != nullptr) {
		transfer->addMessages(operands.names, messages);
	}
	addFindings(result, labels, request.options.outputScalar, messages);
	if (request.curves) {
		messages.push_back(curvesMessage(result.curves, result.report.loopCounts, operands.names));
	}
	seconds.total = total.seconds();
	messages.push_back(timeMessage(seconds.total, result.report.seconds));
	return {resultMap(result, operands.names, idsOf(layers), seconds), messages};
}

}  // namespace index_boolean
