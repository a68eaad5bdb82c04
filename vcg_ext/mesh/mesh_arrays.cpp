// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/mesh/mesh_arrays.h"

#include "vcg_ext/base/parallel.h"
#include "vcg_ext/mesh/mesh_checks.h"

#include <algorithm>

namespace index_boolean {

namespace {

constexpr std::size_t kGrain = 1 << 15;

// A corner by its vertex's id. Beyond the surface's own points it shall be nobody's.
VertexId cornerIn(const SurfaceView& surface, std::uint32_t begin, std::uint32_t corner) {
	return corner < surface.pointCount ? VertexId{begin + corner} : VertexId::none();
}

}  // namespace

Status joinSurfaces(const std::array<SurfaceView, 2>& surfaces, int threads, Monitor& monitor,
                    MeshArrays& out) try {
	out = MeshArrays{};
	Status status = checkCounts(surfaces[0].pointCount + surfaces[1].pointCount,
	                            surfaces[0].triangleCount + surfaces[1].triangleCount);
	for (std::size_t k = 0; k < 2 && status.ok(); ++k) {
		const SurfaceView& surface = surfaces[k];
		const std::uint32_t begin = out.vertexBegin[k];
		out.vertexBegin[k + 1] = begin + static_cast<std::uint32_t>(surface.pointCount);
		out.faceBegin[k + 1] = out.faceBegin[k] + static_cast<std::uint32_t>(surface.triangleCount);
	}
	if (!status.ok()) {
		return status;
	}
	out.points.resize(out.vertexBegin[2]);
	out.triangles.resize(out.faceBegin[2]);
	for (std::size_t k = 0; k < 2 && status.ok(); ++k) {
		const SurfaceView& surface = surfaces[k];
		const std::uint32_t first = out.vertexBegin[k];
		Point* points = out.points.data() + first;
		Triangle* triangles = out.triangles.data() + out.faceBegin[k];
		status = parallelFor(
		    surface.pointCount, kGrain, threads, monitor, [&](std::size_t begin, std::size_t end) {
			    std::copy(surface.points + begin, surface.points + end, points + begin);
		    });
		if (status.ok()) {
			status = parallelFor(surface.triangleCount, kGrain, threads, monitor,
			                     [&](std::size_t begin, std::size_t end) {
				                     for (std::size_t f = begin; f < end; ++f) {
					                     const IndexTriangle& t = surface.triangles[f];
					                     triangles[f] = {cornerIn(surface, first, t[0]),
					                                     cornerIn(surface, first, t[1]),
					                                     cornerIn(surface, first, t[2])};
				                     }
			                     });
		}
	}
	return status;
} catch (const std::bad_alloc&) {
	return statusOf(StatusCode::OutOfMemory);
}

}  // namespace index_boolean
