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

// Adds up what each stage took for all meshes.
void addTimes(const std::vector<StageTime>& times, std::vector<StageTime>& sums) {
	for (const StageTime& time : times) {
		const auto sameStage = [&](const StageTime& sum) {
			return std::string(sum.stage) == time.stage;
		};
		const auto sum = std::find_if(sums.begin(), sums.end(), sameStage);
		if (sum == sums.end())
			sums.push_back(time);
		else
			sum->seconds += time.seconds;
	}
}

Status collectSurfaceMeshes(const SplitRequest& request, Monitor& monitor, SplitResult& result) {
	Status status;
	for (std::size_t operand = 0; operand < 2 && status.ok(); ++operand) {
		SplitMesh& mesh = result.surfaceMeshes[operand];
		if (request.subSurfaces[operand]) {
			status = extractSubSurfaces(result.arrangement, result.split, operand, monitor, mesh);
			addTimes(mesh.stageTimes, result.stageTimes);
		}
	}
	return status;
}

Status collectBlockMeshes(Monitor& monitor, SplitResult& result) {
	Status status;
	result.blockMeshes.resize(result.split.blocks.all.size());
	for (std::size_t i = 0; i < result.blockMeshes.size() && status.ok(); ++i) {
		status = extractSubBlock(result.arrangement, result.split, makeId<SubBlockTag>(i), monitor,
		                         result.blockMeshes[i]);
		addTimes(result.blockMeshes[i].stageTimes, result.stageTimes);
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
		addTimes(result.split.stageTimes, result.stageTimes);
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
