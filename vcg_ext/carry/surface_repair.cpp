// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Volumes are of the same triangles, with other places.
#include "vcg_ext/carry/surface_repair.h"

#include "vcg_ext/arrange/places.h"

#include <algorithm>

namespace index_boolean {

namespace {

void setChange(const BlockMeasure& before, const BlockMeasure& after, SurfaceRepair& repair) {
	repair.volumeChange = before.closed && after.closed ? after.volume - before.volume : 0;
	repair.vanishedComponents = before.components - std::min(before.components, after.components);
}

}  // namespace

BlockMeasure measureUnrepaired(const Arrangement& arrangement, const SourcedMesh& mesh,
                               SurfaceRepair& repair) {
	if (arrangement.movedPlaces.empty()) {
		return {};
	}
	Points points = mesh.points;
	for (std::size_t v = 0; v < points.size(); ++v) {
		const VertexId source = mesh.vertexSource[v];
		if (arrangement.movedPlaces.count(source) != 0) {
			points[v] = roundedPlace(arrangement, source);
			++repair.movedVertices;
		}
	}
	return measureSurface(points, mesh.triangles, arrangement.options.threads);
}

void compareWithUnrepaired(const Arrangement& arrangement, const BlockMeasure& before,
                           const SourcedMesh& mesh, SurfaceRepair& repair) {
	if (arrangement.movedPlaces.empty()) {
		return;
	}
	setChange(before, measureSurface(mesh.points, mesh.triangles, arrangement.options.threads),
	          repair);
}

std::size_t countMoved(const Arrangement& arrangement, const SourcedMesh& mesh) {
	std::size_t moved = 0;
	for (std::size_t v = 0; v < mesh.points.size(); ++v) {
		const VertexId source = mesh.vertexSource[v];
		const bool isNamed = source != VertexId::none();
		moved += isNamed && mesh.points[v] != roundedPlace(arrangement, source) ? 1 : 0;
	}
	return moved;
}

void compareWithExact(const Arrangement& arrangement, const SourcedMesh& exact,
                      const SourcedMesh& mesh, SurfaceRepair& repair) {
	Points points = exact.points;
	for (std::size_t v = 0; v < points.size(); ++v) {
		const VertexId source = exact.vertexSource[v];
		points[v] = source == VertexId::none() ? points[v] : roundedPlace(arrangement, source);
	}
	const int threads = arrangement.options.threads;
	repair.movedVertices = countMoved(arrangement, mesh);
	setChange(measureSurface(points, exact.triangles, threads),
	          measureSurface(mesh.points, mesh.triangles, threads), repair);
}

}  // namespace index_boolean
