// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One arrangement for all statements, then each one's cells, and the block that these are.
#include "runs/expression_run.h"

#include <utility>

namespace index_boolean {

namespace {

std::vector<CellSet> cellsOf(const Arrangement& arrangement, const Expression& expression,
                             bool outerHull) {
	return outerHull ? std::vector<CellSet>(expression.statements.size(), boundedCells(arrangement))
	                 : cellsOf(expression, arrangement);
}

}  // namespace

Status runExpression(MeshArrays input, const InputAgain& again, const Expression& expression,
                     const ExpressionRequest& request, Progress& progress,
                     ExpressionResult& result) {
	const Stopwatch total;
	Arrangement arrangement;
	Monitor arranging = progress.nextPhase(kArrangeShare);
	Status status = arrangeExpression(std::move(input), again, expression, request.options,
	                                  arranging, arrangement);
	if (!status.ok()) {
		return status;
	}
	result.report = reportOf(arrangement);
	const std::vector<CellSet> cells = cellsOf(arrangement, expression, request.outerHull);
	const std::vector<CellSet> asStoredCells =
	    arrangement.again == nullptr
	        ? cells
	        : cellsOf(asStored(arrangement), expression, request.outerHull);
	result.cells = arrangement.cells.windings.size() - 1;
	const BlockReader reader{cells.size(),
	                         [&](std::size_t i, Monitor& monitor, Block& out) {
		                         return extractBlock(arrangement, cells[i], asStoredCells[i],
		                                             monitor, out);
	                         },
	                         [&](const std::vector<Block>& blocks, Monitor& monitor, Audit& out) {
		                         return audit(arrangement, blocks, cells, monitor, out);
	                         }};
	status = readBlocks(arrangement, reader, request, progress, result);
	result.report.seconds = total.seconds();
	return status;
}

Expression expressionOfOne(WindingRule rule) {
	OperandNames names;
	names.byDigits = [](const std::string&) { return NamedOperand{true, 0, {}}; };
	Expression expression;
	readExpression("0", names, rule, expression);
	return expression;
}

}  // namespace index_boolean
