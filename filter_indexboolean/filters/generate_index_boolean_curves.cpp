// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parameters in, one layer and the result map out.
#include "filters/generate_index_boolean_curves.h"

#include "layers/curve_layer.h"
#include "layers/layers.h"
#include "layers/operand_layers.h"
#include "runs/curves_run.h"
#include "runs/stopwatch.h"
#include "texts/messages.h"

#include <utility>

namespace index_boolean {

namespace {

constexpr FilterId kFilter = FilterId::GenerateIndexBooleanCurves;

}  // namespace

FilterOutput generateIndexBooleanCurves(const ParameterValues& values, MeshDocument& document,
                                        HostCallback* callback) {
	const Stopwatch total;
	const OperandLayers operands = findOperandLayers(kFilter, values, document);
	Options options = readCommonOptions(kFilter, values);
	options.certify = false;  // lines have no faces that could meet wrongly
	Progress progress(progressCallback(callback));
	AdapterSeconds seconds{};

	OperandArrays read = readOperands(operands, progress);
	seconds.readLayers = total.seconds();

	CurvesResult result;
	const InputAgain again = inputAgain(operands, read, progress);
	refuseDefect(runCurves(std::move(read.arrays), again, options, progress, result), read,
	             operands);

	const Stopwatch writing;
	std::vector<MeshModel*> layers;
	refuseUnlessOk(
	    addLayers({curveContent(result.curves, read, operands.names)}, progress, document, layers),
	    operands.names);
	seconds.writeLayers = writing.seconds();
	seconds.total = total.seconds();

	std::vector<std::string> messages = operandMessages(result.report, operands.names);
	messages.push_back(curvesMessage(result.curves, result.report.loopCounts, operands.names));
	messages.push_back(timeMessage(seconds.total, result.report.seconds));
	return {resultMap(result, layers.front()->id(), seconds), messages};
}

}  // namespace index_boolean
