// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: both operands' arrays and a request; out: the blocks asked for, audited, with all that the
// result map and the log report. Free of MeshLab: any host's adapter runs it.
#pragma once

#include "runs/block_run.h"

#include <vector>

namespace index_boolean {

struct BooleanRequest : BlocksRequest {
	std::vector<Operation> operations;  // in the order of the layers
};

using BooleanResult = BlocksResult;  // one block for each operation requested

// \param input    moved in
// \param progress of which kRunShare is used up
// \param result   meaningful only if the status is Ok
// \return any StatusCode
Status runBoolean(MeshArrays input, const InputAgain& again, const BooleanRequest& request,
                  Progress& progress, BooleanResult& result);

}  // namespace index_boolean
