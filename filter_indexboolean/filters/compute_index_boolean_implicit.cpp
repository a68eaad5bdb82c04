// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parameters in; values at one layer's vertices, and the result map, out.
#include "filters/compute_index_boolean_implicit.h"

#include "layers/distance_request.h"
#include "texts/messages.h"

#include <utility>

namespace index_boolean {

namespace {

constexpr FilterId kFilter = FilterId::ComputeIndexBooleanImplicit;
constexpr double kReadShare = 0.04, kMeasureShare = 0.9;

}  // namespace

FilterOutput computeIndexBooleanImplicit(const ParameterValues& values, MeshDocument& document,
                                         HostCallback* callback) {
	MeshModel* const pointsLayer = findOperand(kFilter, "points_mesh", values, document);
	MeshModel* const surfaceLayer = findOperand(kFilter, "reference_mesh", values, document);
	const LayerNames names{nameOf(*pointsLayer), nameOf(*surfaceLayer)};
	const DistanceRequest request = readDistanceRequest(kFilter, values);
	Progress progress(progressCallback(callback));

	MeasuredLayer points, surface;
	refuseSurface(readMeasured(*pointsLayer, progress, kReadShare, points), kFirst, points, names);
	refuseSurface(readMeasured(*surfaceLayer, progress, kReadShare, surface), kSecond, surface,
	              names);
	DistanceResult result;
	refuseSurface(runDistance(std::move(surface.arrays), points.arrays.points, request, progress,
	                          kMeasureShare, result),
	              kSecond, surface, names);

	DistanceWriting writing;
	writing.samples = &result.samples;
	writing.atFaces = false;
	writing.maximum = request.distance.maximum;
	writing.negate = request.distance.negate;
	writing.direction = writing.normals = values.getBool("gradient");
	writing.selectInside = values.getBool("select_inside");
	refuseUnlessOk(writeDistances(writing, points), names);

	FilterOutput output;
	addDistances(result.statistics, "", output.map);
	output.map["inside"] = static_cast<int>(result.statistics.inside);
	output.map["seconds_build"] = result.secondsBuild;
	output.map["seconds_query"] = result.secondsQuery;
	output.messages = distanceReferenceMessages(result, names[kSecond]);
	output.messages.push_back(distanceMessage(result.statistics, names[kFirst], names[kSecond]));
	for (const std::string& message : noDistanceMessages(result.statistics, names[kFirst])) {
		output.messages.push_back(message);
	}
	return output;
}

}  // namespace index_boolean
