// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: any number of operands' arrays and an expression over them; out: a block for each of its
// statements, audited, with all that the result map and the log report. Free of MeshLab: any host's
// adapter runs it.
#pragma once

#include "runs/block_run.h"

namespace index_boolean {

struct ExpressionRequest : BlocksRequest {
	bool outerHull = false;  // each statement is true of all that the outside does not reach
};

struct ExpressionResult : BlocksResult {
	std::size_t cells = 0;  // bounded ones
};

// \param input    the expression's operands in its order; moved in
// \param again    makes them once more, for a run that begins again
// \param progress of which kRunShare is used up
// \param result   meaningful only if the status is Ok
// \return any StatusCode
Status runExpression(MeshArrays input, const InputAgain& again, const Expression& expression,
                     const ExpressionRequest& request, Progress& progress,
                     ExpressionResult& result);

// The expression of one operand: what its winding rule calls inside.
Expression expressionOfOne(WindingRule rule);

}  // namespace index_boolean
