// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Volumes are of the same triangles, with other places.
#include "vcg_ext/solids/block_repair.h"

#include "vcg_ext/arrange/places.h"

#include <algorithm>

namespace index_boolean {

namespace {

void setChange(const BlockMeasure& before, const BlockMeasure& after, BlockRepair& repair) {
	repair.volumeChange = after.volume - before.volume;
	repair.vanishedComponents = before.components - std::min(before.components, after.components);
}

}  // namespace

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
	setChange(before, after, block.repair);
}

Status compareWithExact(const Arrangement& arrangement, const Block& exact, Block& block) {
	Points points = exact.points;
	for (std::size_t v = 0; v < points.size(); ++v) {
		points[v] = roundedPlace(arrangement, exact.vertexSource[v]);
	}
	block.repair.movedVertices = 0;
	for (std::size_t v = 0; v < block.points.size(); ++v) {
		const VertexId source = block.vertexSource[v];
		const bool isMoved =
		    source != VertexId::none() && block.points[v] != roundedPlace(arrangement, source);
		block.repair.movedVertices += isMoved ? 1 : 0;
	}
	const int threads = arrangement.options.threads;
	const BlockMeasure before = measureSurface(points, exact.triangles, threads);
	const BlockMeasure after = measureSurface(block.points, block.triangles, threads);
	setChange(before, after, block.repair);
	return {};
}

}  // namespace index_boolean
