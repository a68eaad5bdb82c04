// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: a run's result and the ids of its layers; out: the map that a filter returns. Only bool, int,
// double and the host's list of numbers: hosts drop every other type without a word.
#pragma once

#include "runs/boolean_run.h"
#include "runs/curves_run.h"
#include "runs/distance_run.h"
#include "runs/expression_run.h"
#include "runs/split_run.h"
#include "texts/filter_definitions.h"
#include "texts/layer_names.h"
#include "texts/split_names.h"

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

// \param operands the layers of the expression's operands
ResultMap resultMap(const ExpressionResult& result, const LayerNames& operands,
                    const std::vector<int>& layerIds, const AdapterSeconds& seconds);

// The same of one layer that has been resolved.
ResultMap resultMap(const ExpressionResult& result, int layerId, const AdapterSeconds& seconds);

// The ids of the layers of pieces; none of what was not asked for.
struct PieceLayers {
	PerOperand<std::vector<int>> subSurfaces;  // of each operand
	std::vector<int> subBlocks;
	std::vector<int> clips;  // in the order of the request
};

// \param clips as they have been asked for
ResultMap resultMap(const SplitResult& result, const std::vector<Clip>& clips,
                    const SplitNames& names, const PieceLayers& layerIds,
                    const AdapterSeconds& seconds);

ResultMap resultMap(const CurvesResult& result, int layerId, const AdapterSeconds& seconds);

// The statistics of distances, each key with a suffix; added to a map.
void addDistances(const DistanceStatistics& statistics, const std::string& suffix, ResultMap& map);

}  // namespace index_boolean
