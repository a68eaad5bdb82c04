// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: a run's result and the ids of its layers; out: the map that a filter returns. Only bool, int,
// double and the host's list of numbers: hosts drop every other type without a word.
#pragma once

#include "runs/boolean_run.h"
#include "runs/curves_run.h"
#include "runs/distance_run.h"
#include "runs/split_run.h"
#include "texts/filter_definitions.h"

#include <QVariant>

#include <map>
#include <string>
#include <vector>

namespace index_boolean {

using ResultMap = std::map<std::string, QVariant>;

// What the adapter has measured around the run.
struct AdapterSeconds {
	double readLayers, writeLayers, total;
};

// \param layerIds the id of each block's layer, in the order of result.blocks; then the curves'
ResultMap resultMap(const BooleanResult& result, const std::vector<int>& layerIds,
                    const AdapterSeconds& seconds);

// The ids of the layers of each kind of pieces; none of what was not asked for.
using PieceLayers = std::array<std::vector<int>, kPieceKindCount>;

ResultMap resultMap(const SplitResult& result, const PieceLayers& layerIds,
                    const AdapterSeconds& seconds);

ResultMap resultMap(const CurvesResult& result, int layerId, const AdapterSeconds& seconds);

// The statistics of distances, each key with a suffix; added to a map.
void addDistances(const DistanceStatistics& statistics, const std::string& suffix, ResultMap& map);

}  // namespace index_boolean
