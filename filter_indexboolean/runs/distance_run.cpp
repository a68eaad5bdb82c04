// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The surface is prepared, its tree is built, all points are asked.
#include "runs/distance_run.h"

#include <cmath>
#include <limits>
#include <new>
#include <utility>

namespace index_boolean {

namespace {

constexpr double kPreparing = 0.45, kBuilding = 0.1, kQuerying = 0.45;  // shares of a run

Status query(const SignedDistance& distance, const Points& points, const DistanceRequest& request,
             Monitor& monitor, DistanceResult& result) {
	monitor.beginStage("measuring distances", 0, 1);
	const Stopwatch time;
	const Status status = distance.sample({points.data(), points.size(), result.samples.data()},
	                                      request.distance, request.options.threads, monitor);
	result.secondsQuery = time.seconds();
	return status;
}

}  // namespace

DistanceStatistics statisticsOf(const std::vector<DistanceSample>& samples) {
	DistanceStatistics s{};
	constexpr double kInfinity = std::numeric_limits<double>::infinity();
	s.min = kInfinity;
	s.max = -kInfinity;
	double sum = 0, sumOfSquares = 0, sumOfAbsolutes = 0;
	for (const DistanceSample& sample : samples) {
		const double d = sample.distance;
		s.inside += sample.sign < 0 ? 1 : 0;
		if (std::isnan(d)) {
			++(sample.sign == 0 ? s.noNumber : s.beyond);
			continue;
		}
		++s.count;
		s.min = std::fmin(s.min, d);
		s.max = std::fmax(s.max, d);
		s.largest = std::fmax(s.largest, std::fabs(d));
		sum += d;
		sumOfSquares += d * d;
		sumOfAbsolutes += std::fabs(d);
	}
	const auto n = static_cast<double>(s.count);
	if (s.count == 0) {
		s.min = s.max = s.largest = std::numeric_limits<double>::quiet_NaN();
	}
	s.mean = sum / n;  // not a number if there are none
	s.rms = std::sqrt(sumOfSquares / n);
	s.meanAbsolute = sumOfAbsolutes / n;
	return s;
}

Status runDistance(MeshArrays surface, const Points& points, const DistanceRequest& request,
                   Progress& progress, double share, DistanceResult& result) {
	try {
		const Stopwatch building;
		Monitor preparing = progress.nextPhase(share * kPreparing);
		preparing.beginStage("preparing the surface", 0, 1);
		Reference reference;
		SignedDistance distance;
		Status status = prepareReference(std::move(surface), request.options, request.isSigned,
		                                 preparing, reference);
		if (!status.ok()) {
			return status;
		}
		result.isClosed = reference.isClosed;
		result.isSigned = reference.isSigned;
		result.isResolved = reference.isResolved;
		result.wasInsideOut = reference.wasInsideOut;
		result.selfIntersecting = reference.selfIntersecting;
		Monitor treeMonitor = progress.nextPhase(share * kBuilding);
		treeMonitor.beginStage("building the tree", 0, 1);
		status = distance.build(std::move(reference), request.options.threads, treeMonitor);
		if (!status.ok()) {
			return status;
		}
		result.secondsBuild = building.seconds();
		result.samples.resize(points.size());
		Monitor querying = progress.nextPhase(share * kQuerying);
		status = query(distance, points, request, querying, result);
		result.statistics = statisticsOf(result.samples);
		return status;
	} catch (const std::bad_alloc&) {
		return statusOf(StatusCode::OutOfMemory);
	}
}

}  // namespace index_boolean
