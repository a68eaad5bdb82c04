// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One arrangement, its sub-surfaces and sub-blocks, then the meshes asked for.
#include "split_run.h"

#include "stopwatch.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace index_boolean {

namespace {

constexpr double kArrangingShare = 0.4, kFindingShare = 0.2, kMeshesShare = 0.1;

Status collectSurfaceMeshes(const SplitRequest& request, Monitor& monitor, SplitResult& result) {
	Status status;
	for (std::size_t operand = 0; operand < 2 && status.ok(); ++operand) {
		SplitMesh& mesh = result.surfaceMeshes[operand];
		if (request.subSurfaces[operand])
			status = extractSubSurfaces(result.arrangement, result.split, operand, monitor, mesh);
	}
	return status;
}

Status collectBlockMeshes(Monitor& monitor, SplitResult& result) {
	Status status;
	result.blockMeshes.resize(result.split.blocks.all.size());
	for (std::size_t i = 0; i < result.blockMeshes.size() && status.ok(); ++i) {
		status = extractSubBlock(result.arrangement, result.split, makeId<SubBlockTag>(i), monitor,
		                         result.blockMeshes[i]);
	}
	return status;
}

// The blocks inside an operand have its volume in all, each counted as often as it is wound around.
// \return the largest difference, relative to both volumes; 0 for open operands, which have none
double volumeLawResidual(const Arrangement& arrangement, const SubBlocks& blocks) {
	double most = 0;
	for (std::size_t operand = 0; operand < 2; ++operand) {
		double sum = 0;
		for (const SubBlock& block : blocks.all)
			sum += block.windings[operand] * block.volume;
		most = std::max(most, std::fabs(sum - arrangement.volume[operand]));
	}
	const double scale = arrangement.volume[0] + arrangement.volume[1];
	return most == 0 ? 0 : most / scale;
}

}  // namespace

Status runSplit(MeshArrays input, const SplitRequest& request, Progress& progress,
                SplitResult& result) {
	const Stopwatch total;
	Monitor arranging = progress.nextPhase(kArrangingShare);
	Status status =
	    arrangeSurfaces(std::move(input), request.options, arranging, result.arrangement);
	result.stageTimes = result.arrangement.stageTimes;
	if (status.ok()) {
		Monitor monitor = progress.nextPhase(kFindingShare);
		status = split(result.arrangement, monitor, result.split);
		const std::vector<StageTime>& times = result.split.stageTimes;
		result.stageTimes.insert(result.stageTimes.end(), times.begin(), times.end());
	}
	if (status.ok()) {
		Monitor monitor = progress.nextPhase(kMeshesShare);
		status = collectSurfaceMeshes(request, monitor, result);
	}
	if (status.ok() && request.subBlocks) {
		Monitor monitor = progress.nextPhase(kMeshesShare);
		status = collectBlockMeshes(monitor, result);
	}
	result.volumeLawResidual = volumeLawResidual(result.arrangement, result.split.blocks);
	result.seconds = total.seconds();
	return status;
}

}  // namespace index_boolean
