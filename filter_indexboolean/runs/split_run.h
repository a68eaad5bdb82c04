// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the operands' arrays and a request; out: the sub-surfaces and sub-blocks, their meshes and
// those of clips, and all that the result map and the log report. Free of MeshLab: any host's
// adapter runs it.
#pragma once

#include "runs/progress.h"
#include "runs/run_report.h"

#include <vcg_ext/index_boolean.h>

#include <vector>

namespace index_boolean {

struct SplitRequest {
	Options options;
	PerOperand<bool> subSurfaces{true, true};  // of each operand
	bool subBlocks = true;
	std::vector<Clip> clips;
	bool separateLayers = false;  // a layer for each piece
	std::size_t maxLayers = 64;   // above which separateLayers is not followed
};

// The arrangement, what it is cut into, the meshes of what was asked for, and their audit.
struct SplitResult {
	RunReport report;
	Arrangement arrangement;
	Split split;
	PerOperand<SplitMesh> surfaceMeshes;  // of each operand; empty unless asked for
	std::vector<SplitMesh> blockMeshes;   // of each block; none unless asked for
	std::vector<SplitMesh> clipMeshes;    // of each clip that is asked for
	std::vector<BlockMeasure> clipMeasures;
	SplitAudit audit;

	// How many sub-surfaces an operand has.
	std::size_t surfaceCount(OperandId operand) const {
		return split.surfaces.ofOperand[operand].size();
	}
};

// \param input    moved in: as many operands as request.subSurfaces has
// \param result   meaningful only if the status is Ok
// \return any StatusCode
Status runSplit(MeshArrays input, const InputAgain& again, const SplitRequest& request,
                Progress& progress, SplitResult& result);

}  // namespace index_boolean
