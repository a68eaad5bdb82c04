// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One arrangement, its sub-surfaces and sub-blocks, the meshes asked for, then the audit. Whether
// what clips others is a solid is asked before any mesh is made.
#include "runs/split_run.h"

#include <utility>

namespace index_boolean {

namespace {

constexpr double kArrangingShare = 0.5, kMeshesShare = 0.08, kClipsShare = 0.04, kAuditShare = 0.05;

Status collectSurfaceMeshes(const SplitRequest& request, Progress& progress, SplitResult& result) {
	Status status;
	result.surfaceMeshes = PerOperand<SplitMesh>(request.subSurfaces.size());
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

Status collectClipMeshes(const SplitRequest& request, Progress& progress, SplitResult& result) {
	Status status;
	const std::size_t count = request.clips.size();
	result.clipMeshes.resize(count);
	for (std::size_t i = 0; i < count && status.ok(); ++i) {
		Monitor monitor = progress.nextPhase(kClipsShare / static_cast<double>(count));
		status = extractClip(result.arrangement, result.split, request.clips[i], monitor,
		                     result.clipMeshes[i]);
	}
	return status;
}

Status collectMeshes(const SplitRequest& request, Progress& progress, SplitResult& result) {
	return inOrder(
	    [&] { return collectSurfaceMeshes(request, progress, result); },
	    [&] { return request.subBlocks ? collectBlockMeshes(progress, result) : Status{}; },
	    [&] { return collectClipMeshes(request, progress, result); });
}

Status auditMeshes(const SplitRequest& request, Monitor& monitor, SplitResult& result) {
	Status status =
	    audit(result.arrangement, result.split, result.blockMeshes, monitor, result.audit);
	result.clipMeasures.resize(request.clips.size());
	for (std::size_t i = 0; i < request.clips.size() && status.ok(); ++i) {
		status = audit(result.arrangement, result.split, request.clips[i], result.clipMeshes[i],
		               monitor, result.clipMeasures[i]);
	}
	return status;
}

// Ok, or why what is to clip others does not. Where it begins again, the bar does not go on.
Status checkSolids(const SplitRequest& request, const InputAgain& again, Monitor& monitor,
                   SplitResult& result) {
	std::vector<OperandId> solids;
	for (const Clip& clip : request.clips) {
		solids.push_back(clip.solid);
	}
	return requireSolids(solids, again, monitor, result.arrangement, result.split);
}

// Certificates suppose operands that do not meet themselves.
void forgetCertificates(SplitResult& result) {
	for (SplitMesh& mesh : result.surfaceMeshes) {
		mesh.certificate = Certificate{};
	}
	for (std::vector<SplitMesh>* meshes : {&result.blockMeshes, &result.clipMeshes}) {
		for (SplitMesh& mesh : *meshes) {
			mesh.certificate = Certificate{};
		}
	}
}

}  // namespace

Status runSplit(MeshArrays input, const InputAgain& again, const SplitRequest& request,
                Progress& progress, SplitResult& result) {
	const Stopwatch total;
	Monitor arranging = progress.nextPhase(kArrangingShare);
	Status status = inOrder(
	    [&] {
		    return splitOperands(std::move(input), again, request.options, arranging,
		                         result.arrangement, result.split);
	    },
	    [&] { return checkSolids(request, again, arranging, result); });
	RunReport& report = result.report;
	report = reportOf(result.arrangement);
	report.addStages(result.split.stageTimes);
	if (status.ok() && result.arrangement.isSoup) {
		report.insideOut = result.split.blocks.turned;
	}
	const Stopwatch meshesTime;
	if (status.ok()) {
		status = collectMeshes(request, progress, result);
	}
	if (!result.arrangement.areOperandsKnown()) {
		forgetCertificates(result);
	}
	report.addStage("split_meshes", meshesTime);
	if (status.ok()) {
		const Stopwatch auditTime;
		Monitor monitor = progress.nextPhase(kAuditShare);
		monitor.beginStage("audit", 0, 1);
		status = auditMeshes(request, monitor, result);
		report.addStage("audit", auditTime);
	}
	report.seconds = total.seconds();
	return status;
}

}  // namespace index_boolean
