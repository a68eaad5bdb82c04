// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parameters in; both layers measured, then both written; the result map out.
#include "filters/compute_index_boolean_distance.h"

#include "layers/distance_request.h"
#include "texts/messages.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace index_boolean {

namespace {

constexpr FilterId kFilter = FilterId::ComputeIndexBooleanDistance;
constexpr double kReadShare = 0.04, kMeasureShare = 0.44;  // of each layer

// Where layers are measured, and which of them.
struct Places {
	bool atVertices, atFaces, bothWays;
};

// A layer and what was measured of it.
struct Way {
	MeasuredLayer read;
	DistanceResult result;
};

Places readPlaces(const ParameterValues& values) {
	const Places places{values.getBool("at_vertices"), values.getBool("at_faces"),
	                    values.getBool("both_ways")};
	if (!places.atVertices && !places.atFaces) {
		throw Refusal(nothingMeasuredMessage());
	}
	return places;
}

// Measures one layer from the other.
void measure(const Places& places, const DistanceRequest& request, OperandId measured,
             const LayerNames& names, PerOperand<Way>& ways, Progress& progress) {
	const OperandId other = otherOf(measured);
	const Points points = pointsToMeasure(ways[measured].read, places.atVertices, places.atFaces);
	refuseSurface(runDistance(ways[other].read.arrays, points, request, progress, kMeasureShare,
	                          ways[measured].result),
	              other, ways[other].read, names);
}

// The largest distance in both directions; not a number if some are not known.
double hausdorffOf(const PerOperand<Way>& ways) {
	double largest = 0;
	for (const Way& way : ways) {
		const DistanceStatistics& s = way.result.statistics;
		largest = s.beyond > 0 || s.count == 0 ? std::numeric_limits<double>::quiet_NaN()
		                                       : std::fmax(largest, s.largest);
		if (std::isnan(largest)) {
			break;
		}
	}
	return largest;
}

void writeWay(const ParameterValues& values, const DistanceRequest& request, const Places& places,
              const PerOperand<Way>& ways, OperandId measured, double range) {
	DistanceWriting writing;
	writing.samples = &ways[measured].result.samples;
	writing.atVertices = places.atVertices;
	writing.atFaces = places.atFaces;
	writing.maximum = request.distance.maximum;
	writing.negate = request.distance.negate;
	writing.direction = values.getBool("direction");
	writing.closest = values.getBool("closest");
	writing.color = values.getBool("color");
	writing.colorRange = range;
	writing.closestFaces = &ways[otherOf(measured)].read.elements.faces;
	refuseUnlessOk(writeDistances(writing, ways[measured].read), LayerNames{});
}

// The result map and the log's lines.
FilterOutput outputOf(const PerOperand<Way>& ways, const PerOperand<bool>& isMeasured,
                      const LayerNames& names) {
	const PerOperand<const char*> suffixes{"_first", "_second"};
	FilterOutput output;
	double build = 0, query = 0;
	for (const OperandId operand : ways.operands()) {
		if (!isMeasured[operand]) {
			continue;
		}
		const DistanceResult& result = ways[operand].result;
		const LayerName& reference = names[otherOf(operand)];
		addDistances(result.statistics, suffixes[operand], output.map);
		build += result.secondsBuild;
		query += result.secondsQuery;
		const auto add = [&output](const std::vector<std::string>& messages) {
			output.messages.insert(output.messages.end(), messages.begin(), messages.end());
		};
		add(distanceReferenceMessages(result, reference));
		add({distanceMessage(result.statistics, names[operand], reference)});
		add(noDistanceMessages(result.statistics, names[operand]));
	}
	if (isMeasured[kSecond]) {
		const double hausdorff = hausdorffOf(ways);
		output.map["hausdorff"] = hausdorff;
		output.messages.push_back(hausdorffMessage(hausdorff));
	}
	output.map["seconds_build"] = build;
	output.map["seconds_query"] = query;
	return output;
}

}  // namespace

FilterOutput computeIndexBooleanDistance(const ParameterValues& values, MeshDocument& document,
                                         HostCallback* callback) {
	const OperandLayers operands = findOperandLayers(kFilter, values, document);
	const LayerNames& names = operands.names;
	DistanceRequest request = readDistanceRequest(kFilter, values);
	request.isSigned = values.getBool("signed");
	const Places places = readPlaces(values);
	Progress progress(progressCallback(callback));

	PerOperand<Way> ways;
	for (const OperandId operand : ways.operands()) {
		refuseSurface(
		    readMeasured(*operands.layers[operand], progress, kReadShare, ways[operand].read),
		    operand, ways[operand].read, names);
	}
	const bool hasFaces = !ways[kFirst].read.arrays.triangles.empty();
	const PerOperand<bool> isMeasured{true, places.bothWays && hasFaces};
	double range = 0;
	for (const OperandId operand : ways.operands()) {
		if (isMeasured[operand]) {
			measure(places, request, operand, names, ways, progress);
			range = std::fmax(range, ways[operand].result.statistics.largest);
		}
	}
	for (const OperandId operand : ways.operands()) {
		if (isMeasured[operand]) {
			writeWay(values, request, places, ways, operand, range);
		}
	}
	FilterOutput output = outputOf(ways, isMeasured, names);
	if (values.getBool("color")) {
		output.messages.push_back(distanceColourMessage(range, request.isSigned));
	}
	if (places.bothWays && !hasFaces) {
		output.messages.push_back(oneWayMessage(names[kFirst]));
	}
	return output;
}

}  // namespace index_boolean
