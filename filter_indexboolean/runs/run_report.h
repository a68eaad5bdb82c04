// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: an arrangement, and what a run measures; out: what every run, whichever it is, has to tell of
// the operands, the curve and the time, for the result map and the log.
#pragma once

#include "runs/stopwatch.h"

#include <vcg_ext/index_boolean.h>

#include <vector>

namespace index_boolean {

struct RunReport {
	PerOperand<bool> insideOut;  // as in the arrangement
	DuplicateFaces duplicates;
	LoopCounts loopCounts;
	PlaceRepair placeRepair;
	VertexWeld vertexWeld;
	bool isLabelledByCells = false;            // operands that may meet themselves: one soup
	PerOperand<std::size_t> turnedAlike;       // faces turned as their neighbours are
	PerOperand<std::size_t> selfIntersecting;  // faces of each that meet others of it wrongly
	PerOperand<std::size_t> foldedFans;        // if any do: polygons whose triangles overlap
	std::vector<StageTime> stageTimes;         // in the order of the stages
	double seconds = 0;                        // from arrays to arrays

	// The core's stages that have come to their end since.
	void addStages(const std::vector<StageTime>& times) {
		stageTimes.insert(stageTimes.end(), times.begin(), times.end());
	}
	// A stage of the run's own, which began with the stopwatch, has just come to its end.
	void addStage(const char* stage, const Stopwatch& time) {
		stageTimes.push_back({stage, time.seconds()});
	}
};

// The report of a run that has come as far as its arrangement.
inline RunReport reportOf(const Arrangement& arrangement) {
	RunReport report;
	report.insideOut = arrangement.insideOut;
	report.duplicates = arrangement.duplicates;
	report.loopCounts = arrangement.loopCounts;
	report.placeRepair = arrangement.placeRepair;
	report.vertexWeld = arrangement.vertexWeld;
	report.isLabelledByCells = arrangement.isSoup;
	report.turnedAlike = arrangement.turnedAlike;
	report.selfIntersecting = arrangement.selfIntersecting;
	report.foldedFans = PerOperand<std::size_t>(arrangement.selfIntersecting.size());
	for (const OperandId operand : report.foldedFans.operands()) {
		if (report.selfIntersecting[operand] > 0) {
			report.foldedFans[operand] = countFoldedFans(arrangement.mesh, operand);
		}
	}
	report.stageTimes = arrangement.stageTimes;
	return report;
}

}  // namespace index_boolean
