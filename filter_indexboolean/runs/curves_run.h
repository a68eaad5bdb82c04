// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: both operands' arrays; out: the curve as polylines and the sub-surfaces that it bounds, with
// all that the result map and the log report. Free of MeshLab: any host's adapter runs it.
#pragma once

#include "runs/progress.h"
#include "runs/run_report.h"

#include <vcg_ext/index_boolean.h>

#include <vector>

namespace index_boolean {

struct CurvesResult {
	RunReport report;
	CurveLines curves;
	SubSurfaces surfaces;  // that the loops bound
};

// \param input  moved in
// \param result meaningful only if the status is Ok
// \return any StatusCode
Status runCurves(MeshArrays input, const InputAgain& again, const Options& options,
                 Progress& progress, CurvesResult& result);

}  // namespace index_boolean
