// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The keys of the result map.
#include "result_map.h"

#include <algorithm>

namespace index_boolean {

namespace {

// Counts of elements are below 2^31 by the core's limit.
int toInt(std::size_t count) { return static_cast<int>(count); }

// A stage's name as a part of a key: "octree pairs" gives "octree_pairs".
std::string keyOf(std::string stage) {
	std::replace(stage.begin(), stage.end(), ' ', '_');
	return stage;
}

void addBlock(const Block& block, const BlockMeasure& measure, int layerId, ResultMap& map) {
	const std::string name = operationName(block.operation);
	map[name + "_layer"] = layerId;
	map[name + "_volume"] = measure.volume;
	map[name + "_area"] = measure.area;
	map[name + "_faces"] = toInt(block.triangles.size());
	map[name + "_components"] = toInt(measure.components);
	map[name + "_closed"] = measure.closed;
}

}  // namespace

ResultMap resultMap(const BooleanResult& result, const std::vector<int>& layerIds,
                    const AdapterSeconds& seconds) {
	ResultMap map;
	std::size_t zeroAreaFaces = 0;
	for (std::size_t i = 0; i < result.blocks.size(); ++i) {
		addBlock(result.blocks[i], result.audit.blocks[i], layerIds[i], map);
		zeroAreaFaces += result.blocks[i].zeroAreaFacesRemoved;
	}
	map["volume_law_residual"] = result.audit.volumeLawResidual;
	map["loops_open"] = toInt(result.loopCounts.open);
	map["loops_hard_closed"] = toInt(result.loopCounts.hardClosed);
	map["loops_soft_closed"] = toInt(result.loopCounts.softClosed);
	map["zero_area_faces_removed"] = toInt(zeroAreaFaces);
	for (const StageTime& time : result.stageTimes)
		map["seconds_" + keyOf(time.stage)] = time.seconds;
	map["seconds_read_layers"] = seconds.readLayers;
	map["seconds_write_layers"] = seconds.writeLayers;
	map["seconds_core"] = result.seconds;
	map["seconds_total"] = seconds.total;
	return map;
}

}  // namespace index_boolean
