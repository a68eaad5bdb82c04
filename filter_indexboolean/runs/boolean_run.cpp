// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One arrangement, then each operation's block from it.
#include "runs/boolean_run.h"

#include <utility>

namespace index_boolean {

Status runBoolean(MeshArrays input, const InputAgain& again, const BooleanRequest& request,
                  Progress& progress, BooleanResult& result) {
	const Stopwatch total;
	Arrangement arrangement;
	Monitor arranging = progress.nextPhase(kArrangeShare);
	Status status =
	    arrangeOperands(std::move(input), again, request.options, arranging, arrangement);
	if (!status.ok()) {
		return status;
	}
	result.report = reportOf(arrangement);
	const BlockReader reader{request.operations.size(),
	                         [&](std::size_t i, Monitor& monitor, Block& out) {
		                         return extractBlock(arrangement, request.operations[i], monitor,
		                                             out);
	                         },
	                         [&](const std::vector<Block>& blocks, Monitor& monitor, Audit& out) {
		                         return audit(arrangement, blocks, monitor, out);
	                         }};
	status = readBlocks(arrangement, reader, request, progress, result);
	result.report.seconds = total.seconds();
	return status;
}

}  // namespace index_boolean
