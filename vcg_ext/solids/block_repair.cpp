// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Volumes are of the same triangles, with other places.
#include "vcg_ext/solids/block_repair.h"

#include "vcg_ext/arrange/places.h"

#include <algorithm>

namespace index_boolean {

BlockMeasure measureUnrepaired(const Arrangement& arrangement, Block& block) {
	if (arrangement.movedPlaces.empty()) {
		return {};
	}
	Points points = block.points;
	for (std::size_t v = 0; v < points.size(); ++v) {
		const VertexId source = block.vertexSource[v];
		if (arrangement.movedPlaces.count(source) != 0) {
			points[v] = roundedPlace(arrangement, source);
			++block.repair.movedVertices;
		}
	}
	return measureSurface(points, block.triangles, arrangement.options.threads);
}

void compareWithUnrepaired(const Arrangement& arrangement, const BlockMeasure& before,
                           Block& block) {
	if (arrangement.movedPlaces.empty()) {
		return;
	}
	const BlockMeasure after =
	    measureSurface(block.points, block.triangles, arrangement.options.threads);
	block.repair.volumeChange = after.volume - before.volume;
	block.repair.vanishedComponents =
	    before.components - std::min(before.components, after.components);
}

}  // namespace index_boolean
