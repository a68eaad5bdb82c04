// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Volumes are of the same triangles, with other places.
#include "vcg_ext/carry/surface_repair.h"

#include "vcg_ext/arrange/places.h"

#include <algorithm>

namespace index_boolean {

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
	const BlockMeasure after =
	    measureSurface(mesh.points, mesh.triangles, arrangement.options.threads);
	repair.volumeChange = before.closed && after.closed ? after.volume - before.volume : 0;
	repair.vanishedComponents = before.components - std::min(before.components, after.components);
}

}  // namespace index_boolean
