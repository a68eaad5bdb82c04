// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One arrangement, then its sub-surfaces and polylines.
#include "runs/curves_run.h"

#include "runs/stopwatch.h"

#include <utility>

namespace index_boolean {

namespace {

constexpr double kArrangingShare = 0.6, kFindingShare = 0.15, kDrawingShare = 0.05;

}  // namespace

Status runCurves(MeshArrays input, const Options& options, Progress& progress,
                 CurvesResult& result) {
	const Stopwatch total;
	Arrangement arrangement;
	Monitor arranging = progress.nextPhase(kArrangingShare);
	Status status = arrangeSurfaces(std::move(input), options, arranging, arrangement);
	if (!status.ok()) {
		return status;
	}
	result.turned = arrangement.turned;
	result.duplicates = arrangement.duplicates;
	result.loopCounts = arrangement.loopCounts;
	result.stageTimes = arrangement.stageTimes;

	Monitor finding = progress.nextPhase(kFindingShare);
	Split split;
	status = splitSurfaces(arrangement, finding, split);
	if (!status.ok()) {
		return status;
	}
	result.surfaces = std::move(split.surfaces);
	result.stageTimes.push_back(split.stageTimes.front());

	Monitor drawing = progress.nextPhase(kDrawingShare);
	status = extractCurve(arrangement, drawing, result.curves);
	result.seconds = total.seconds();
	return status;
}

}  // namespace index_boolean
