// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One arrangement, its sub-surfaces and sub-blocks, the meshes asked for, then the audit.
#include "runs/split_run.h"

#include <utility>

namespace index_boolean {

namespace {

constexpr double kArrangingShare = 0.6, kMeshesShare = 0.1, kAuditShare = 0.05;

Status collectSurfaceMeshes(const SplitRequest& request, Progress& progress, SplitResult& result) {
	Status status;
	const double share = kMeshesShare / static_cast<double>(request.subSurfaces.size());
	for (const OperandId operand : request.subSurfaces.operands()) {
		SplitMesh& mesh = result.surfaceMeshes[operand];
		Monitor monitor = progress.nextPhase(share);
		if (request.subSurfaces[operand] && status.ok()) {
			status = extractSubSurfaces(result.arrangement, result.split, operand, monitor, mesh);
		}
	}
	return status;
}

Status collectBlockMeshes(Progress& progress, SplitResult& result) {
	Status status;
	const std::size_t count = result.split.blocks.all.size();
	result.blockMeshes.resize(count);
	for (std::size_t i = 0; i < count && status.ok(); ++i) {
		Monitor monitor = progress.nextPhase(kMeshesShare / static_cast<double>(count));
		status = extractSubBlock(result.arrangement, result.split, makeId<SubBlockTag>(i), monitor,
		                         result.blockMeshes[i]);
	}
	return status;
}

// Certificates suppose operands that do not meet themselves.
void forgetCertificates(SplitResult& result) {
	for (SplitMesh& mesh : result.surfaceMeshes) {
		mesh.certificate = Certificate{};
	}
	for (SplitMesh& mesh : result.blockMeshes) {
		mesh.certificate = Certificate{};
	}
}

}  // namespace

Status runSplit(MeshArrays input, const InputAgain& again, const SplitRequest& request,
                Progress& progress, SplitResult& result) {
	const Stopwatch total;
	Monitor arranging = progress.nextPhase(kArrangingShare);
	Status status = splitOperands(std::move(input), again, request.options, arranging,
	                              result.arrangement, result.split);
	RunReport& report = result.report;
	report = reportOf(result.arrangement);
	report.addStages(result.split.stageTimes);
	if (status.ok() && result.arrangement.isSoup) {
		report.insideOut = result.split.blocks.turned;
	}
	const Stopwatch meshesTime;
	if (status.ok()) {
		status = collectSurfaceMeshes(request, progress, result);
	}
	if (status.ok() && request.subBlocks) {
		status = collectBlockMeshes(progress, result);
	}
	if (!result.arrangement.areOperandsKnown()) {
		forgetCertificates(result);
	}
	report.addStage("split_meshes", meshesTime);
	if (status.ok()) {
		const Stopwatch auditTime;
		Monitor monitor = progress.nextPhase(kAuditShare);
		monitor.beginStage("audit", 0, 1);
		status = audit(result.arrangement, result.split, result.blockMeshes, monitor, result.audit);
		report.addStage("audit", auditTime);
	}
	report.seconds = total.seconds();
	return status;
}

}  // namespace index_boolean
