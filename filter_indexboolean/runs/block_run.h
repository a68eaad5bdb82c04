// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What all runs that make blocks have in common: in: an arrangement and how each block is read from
// it; out: the blocks, audited, with all that the result map and the log report. Free of MeshLab:
// any host's adapter runs it.
#pragma once

#include "runs/attribute_request.h"
#include "runs/progress.h"
#include "runs/run_report.h"

#include <vcg_ext/index_boolean.h>

#include <functional>
#include <vector>

namespace index_boolean {

struct BlocksRequest {
	Options options;
	bool curves = false;          // and the curve as polylines
	AttributeRequest attributes;  // of the blocks
};

struct BlocksResult {
	RunReport report;
	std::vector<Block> blocks;              // in the order of the layers
	Audit audit;                            // of these blocks
	std::vector<AttributeSources> sources;  // of each block, if wanted
	std::vector<std::size_t> openEdges;     // of each block, by index: at seams
	CurveLines curves;                      // if requested
};

// How a run's blocks are read from its arrangement, and audited.
struct BlockReader {
	std::size_t count;
	std::function<Status(std::size_t block, Monitor&, Block& out)> extract;
	std::function<Status(const std::vector<Block>&, Monitor&, Audit& out)> audit;
};

// Reads, audits and completes the blocks.
// \param result of which the report is begun; the rest is replaced
// \return any StatusCode
Status readBlocks(const Arrangement& arrangement, const BlockReader& reader,
                  const BlocksRequest& request, Progress& progress, BlocksResult& result);

// What the phases take of the progress bar; the rest is the adapter's.
constexpr double kArrangeShare = 0.52, kBlocksShare = 0.14, kAuditShare = 0.08,
                 kSourcesShare = 0.05, kCurvesShare = 0.01;
constexpr double kRunShare =
    kArrangeShare + kBlocksShare + kAuditShare + kSourcesShare + kCurvesShare;

}  // namespace index_boolean
