// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "vcg_ext/mesh/mesh_arrays.h"

#include "vcg_ext/base/parallel.h"
#include "vcg_ext/mesh/element_counts.h"

#include <algorithm>

namespace index_boolean {

std::array<Point, 3> sortedPlaces(const MeshArrays& mesh, FaceId face) {
	const Triangle& t = at(mesh.triangles, face);
	std::array<Point, 3> places{at(mesh.points, t[0]), at(mesh.points, t[1]),
	                            at(mesh.points, t[2])};
	std::sort(places.begin(), places.end());
	return places;
}

namespace {

constexpr std::size_t kGrain = 1 << 15;

// A corner by its vertex's id. Beyond the surface's own points it shall be nobody's.
VertexId cornerIn(const SurfaceView& surface, std::uint32_t begin, std::uint32_t corner) {
	return corner < surface.pointCount ? VertexId{begin + corner} : VertexId::none();
}

}  // namespace

Status joinSurfaces(const std::vector<SurfaceView>& surfaces, int threads, Monitor& monitor,
                    MeshArrays& out) try {
	out = MeshArrays{};
	out.vertexOffsets = OperandOffsets(surfaces.size());
	out.faceOffsets = OperandOffsets(surfaces.size());
	out.faceClass = PerOperand<std::vector<std::uint32_t>>(surfaces.size());
	std::size_t pointCount = 0, faceCount = 0;
	Status status;
	for (const OperandId operand : out.operands()) {
		pointCount += surfaces[operand.value].pointCount;
		faceCount += surfaces[operand.value].triangleCount;
		status = checkCounts(pointCount, faceCount);
		if (!status.ok()) {
			return status;
		}
		out.vertexOffsets.setEnd(operand, pointCount);
		out.faceOffsets.setEnd(operand, faceCount);
	}
	out.points.resizeForOverwrite(pointCount);
	out.triangles.resizeForOverwrite(faceCount);
	for (std::size_t k = 0; k < surfaces.size() && status.ok(); ++k) {
		const SurfaceView& surface = surfaces[k];
		const std::uint32_t first = out.vertexOffsets.begin(makeId<OperandTag>(k));
		Point* points = out.points.data() + first;
		Triangle* triangles = out.triangles.data() + out.faceOffsets.begin(makeId<OperandTag>(k));
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
