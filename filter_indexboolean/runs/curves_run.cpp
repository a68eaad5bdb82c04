// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One arrangement, then its sub-surfaces and polylines.
#include "runs/curves_run.h"

#include <utility>

namespace index_boolean {

namespace {

constexpr double kArrangingShare = 0.75, kDrawingShare = 0.05;

}  // namespace

Status runCurves(MeshArrays input, const InputAgain& again, const Options& options,
                 Progress& progress, CurvesResult& result) {
	const Stopwatch total;
	Arrangement arrangement;
	Monitor arranging = progress.nextPhase(kArrangingShare);
	Split split;
	Status status =
	    splitOperandSurfaces(std::move(input), again, options, arranging, arrangement, split);
	if (!status.ok()) {
		return status;
	}
	result.report = reportOf(arrangement);
	result.surfaces = std::move(split.surfaces);
	result.report.addStages(split.stageTimes);

	Monitor drawing = progress.nextPhase(kDrawingShare);
	status = extractCurve(arrangement, drawing, result.curves);
	result.report.seconds = total.seconds();
	return status;
}

}  // namespace index_boolean
