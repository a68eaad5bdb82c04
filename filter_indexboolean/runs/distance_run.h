// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the arrays of a surface and points; out: the points' distances from it, with all that the
// result map and the log report. Free of MeshLab: any host's adapter runs it.
#pragma once

#include "runs/progress.h"
#include "runs/stopwatch.h"

#include <vcg_ext/index_boolean.h>

#include <vector>

namespace index_boolean {

struct DistanceRequest {
	Options options;  // of the search for self-intersections, and the winding rule
	bool isSigned = true;
	DistanceOptions distance;
};

// Of all samples that have a distance; NaN if there are none.
struct DistanceStatistics {
	double min, max, mean, rms, meanAbsolute;
	double largest;            // of their absolute values
	std::size_t count = 0;     // of samples that have a distance
	std::size_t beyond = 0;    // farther than the maximum
	std::size_t noNumber = 0;  // the point is not finite
	std::size_t inside = 0;    // beyond the maximum, too
};

struct DistanceResult {
	// What was found of the surface.
	bool isClosed = false, isSigned = true, isResolved = false, wasInsideOut = false;
	std::size_t selfIntersecting = 0;
	std::vector<DistanceSample> samples;  // one for each point
	DistanceStatistics statistics{};
	double secondsBuild = 0, secondsQuery = 0;
};

// The statistics of some samples. Sums do not depend on threads. Complexity: O(n).
DistanceStatistics statisticsOf(const std::vector<DistanceSample>& samples);

// \param surface  one operand; moved in
// \param progress of which `share` is used up
// \param result   meaningful only if the status is Ok
// \return as prepareReference
Status runDistance(MeshArrays surface, const Points& points, const DistanceRequest& request,
                   Progress& progress, double share, DistanceResult& result);

}  // namespace index_boolean
