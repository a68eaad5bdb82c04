// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: both operands' arrays and a request; out: the blocks asked for, audited, with all that the
// result map and the log report. Free of MeshLab: any host's adapter runs it.
#pragma once

#include "runs/attribute_request.h"
#include "runs/progress.h"
#include "runs/run_report.h"

#include <vcg_ext/index_boolean.h>

#include <vector>

namespace index_boolean {

struct BooleanRequest {
	Options options;
	std::vector<Operation> operations;  // in the order of the layers
	bool curves = false;                // and the curve as polylines
	AttributeRequest attributes;        // of the blocks
};

struct BooleanResult {
	RunReport report;
	std::vector<Block> blocks;              // one for each operation requested
	Audit audit;                            // of these blocks
	std::vector<AttributeSources> sources;  // of each block, if wanted
	std::vector<std::size_t> openEdges;     // of each block, by index: at seams
	CurveLines curves;                      // if requested
};

// \param input    moved in
// \param progress of which kRunShare is used up
// \param result   meaningful only if the status is Ok
// \return any StatusCode
Status runBoolean(MeshArrays input, const InputAgain& again, const BooleanRequest& request,
                  Progress& progress, BooleanResult& result);

// What the phases take of the progress bar; the rest is the adapter's.
constexpr double kArrangeShare = 0.52, kBlocksShare = 0.14, kAuditShare = 0.08,
                 kSourcesShare = 0.05, kCurvesShare = 0.01;
constexpr double kRunShare =
    kArrangeShare + kBlocksShare + kAuditShare + kSourcesShare + kCurvesShare;

}  // namespace index_boolean
