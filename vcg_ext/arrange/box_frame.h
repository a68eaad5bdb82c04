// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the box of what is to be searched; out: a map of it to floats in a cube about the origin.
// Guarantee: the map never swaps two numbers along an axis, so that boxes that touch or overlap
// still do, without a margin.
#pragma once

#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/base/status.h"
#include "vcg_ext/exact/bounding_box.h"
#include "vcg_ext/mesh/mesh_arrays.h"

#include <algorithm>

namespace index_boolean {

// The map of a box to a cube from -halfSize to halfSize, a power of two near 1.
struct BoxFrame {
	Point centre{};
	double scale = 1;
	float halfSize = 1;

	// \param x a coordinate inside the box
	float map(double x, std::size_t axis) const {
		const auto mapped = static_cast<float>((x - centre[axis]) * scale);
		return std::min(std::max(mapped, -halfSize), halfSize);
	}
};

// The frame about a box that is not empty. Complexity: O(1).
BoxFrame makeBoxFrame(const BoundingBox& box);

// The box of the corners of faces: a stray vertex, which no face uses, does not count.
// \param count  how many faces
// \param faceAt faceAt(i): the index of face i < count
// \param out    empty if there are none
// \return Ok, Cancelled or OutOfMemory. Complexity: O(count), in parallel.
template <class FaceAt>
Status findBoxOfFaces(const MeshArrays& mesh, std::size_t count, FaceAt&& faceAt, int threads,
                      Monitor& monitor, BoundingBox& out) {
	constexpr std::size_t kGrain = 8192;
	std::vector<BoundingBox> parts(chunkCount(count, kGrain), emptyBox());
	const Status status = parallelForChunks(
	    count, kGrain, threads, monitor,
	    [&](std::size_t chunk, std::size_t begin, std::size_t end) {
		    BoundingBox box = emptyBox();
		    for (std::size_t i = begin; i < end; ++i) {
			    for (const VertexId v : mesh.triangles[static_cast<std::size_t>(faceAt(i))]) {
				    box.add(at(mesh.points, v));
			    }
		    }
		    parts[chunk] = box;
	    });
	out = joinedBox(parts.data(), parts.size());
	return status;
}

}  // namespace index_boolean
