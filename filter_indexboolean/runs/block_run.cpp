// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Each block, then the audit, then what the blocks' elements carry.
#include "runs/block_run.h"

namespace index_boolean {

namespace {

Status extractBlocks(const BlockReader& reader, Progress& progress, std::vector<Block>& blocks) {
	blocks.resize(reader.count);
	for (std::size_t i = 0; i < reader.count; ++i) {
		Monitor monitor = progress.nextPhase(kBlocksShare / static_cast<double>(reader.count));
		const Status status = reader.extract(i, monitor, blocks[i]);
		if (!status.ok()) {
			return status;
		}
	}
	return {};
}

// Adds up what each stage took for all blocks.
void addBlockTimes(const std::vector<Block>& blocks, std::vector<StageTime>& times) {
	const std::size_t first = times.size();
	for (const Block& block : blocks) {
		for (std::size_t i = 0; i < block.stageTimes.size(); ++i) {
			if (first + i == times.size()) {
				times.push_back({block.stageTimes[i].stage, 0});
			}
			times[first + i].seconds += block.stageTimes[i].seconds;
		}
	}
}

// Certificates suppose operands that do not meet themselves.
void forgetCertificates(std::vector<Block>& blocks) {
	for (Block& block : blocks) {
		block.certificate = Certificate{};
	}
}

Status countAllOpenEdges(int threads, Monitor& monitor, BlocksResult& result) {
	Status status;
	result.openEdges.resize(result.blocks.size());
	for (std::size_t i = 0; i < result.blocks.size() && status.ok(); ++i) {
		status = countOpenEdges(result.blocks[i], threads, monitor, result.openEdges[i]);
	}
	return status;
}

}  // namespace

Status readBlocks(const Arrangement& arrangement, const BlockReader& reader,
                  const BlocksRequest& request, Progress& progress, BlocksResult& result) {
	Status status = extractBlocks(reader, progress, result.blocks);
	if (!status.ok()) {
		return status;
	}
	addBlockTimes(result.blocks, result.report.stageTimes);
	if (!arrangement.areOperandsKnown()) {
		forgetCertificates(result.blocks);
	}

	const Stopwatch auditTime;
	Monitor auditing = progress.nextPhase(kAuditShare);
	auditing.beginStage("audit", 0, 1);
	status = reader.audit(result.blocks, auditing, result.audit);
	if (!status.ok()) {
		return status;
	}
	result.report.addStage("audit", auditTime);

	// Vertices that part here have been audited as one: a block is closed across its seams.
	const Stopwatch sourcesTime;
	Monitor finding = progress.nextPhase(kSourcesShare);
	finding.beginStage("attributes", 0, 1);
	if (request.attributes.given) {
		status =
		    findSources(arrangement, request.attributes, finding, result.blocks, result.sources);
	}
	if (!status.ok()) {
		return status;
	}
	result.report.addStage("attributes", sourcesTime);
	status = countAllOpenEdges(arrangement.options.threads, finding, result);

	if (status.ok() && request.curves) {
		Monitor drawing = progress.nextPhase(kCurvesShare);
		status = extractCurve(arrangement, drawing, result.curves);
	}
	return status;
}

}  // namespace index_boolean
