// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A table of places, filled in the order of the faces' vertices.
#include "vcg_ext/mesh/soup_weld.h"

#include "vcg_ext/mesh/vertex_table.h"

#include <algorithm>
#include <numeric>

namespace index_boolean {

namespace {

// Welds the corners of the faces [begin, end), whose vertices lie in [first, last).
// \return whether two vertices were in one place
bool weld(MeshArrays& mesh, std::uint32_t begin, std::uint32_t end, std::uint32_t first,
          std::uint32_t last) {
	std::vector<std::uint8_t> isUsed(last - first, 0);
	for (std::uint32_t face = begin; face < end; ++face) {
		for (const VertexId v : mesh.triangles[face]) {
			isUsed[v.value - first] = 1;
		}
	}
	std::vector<std::uint32_t> stands(last - first);
	std::iota(stands.begin(), stands.end(), first);
	VertexTable table(mesh.points,
	                  static_cast<std::size_t>(std::count(isUsed.begin(), isUsed.end(), 1)));
	bool any = false;
	for (std::uint32_t v = first; v < last; ++v) {
		if (isUsed[v - first] != 0) {
			stands[v - first] = table.findOrAdd(v);
			any = any || stands[v - first] != v;
		}
	}
	for (std::uint32_t face = begin; any && face < end; ++face) {
		for (VertexId& v : mesh.triangles[face]) {
			v = {stands[v.value - first]};
		}
	}
	return any;
}

}  // namespace

void weldEachOperand(MeshArrays& mesh, PerOperand<bool>& welded) {
	welded = PerOperand<bool>(mesh.operands().count());
	for (const OperandId operand : mesh.operands()) {
		welded[operand] = weld(mesh, mesh.faceOffsets.begin(operand), mesh.faceOffsets.end(operand),
		                       mesh.vertexOffsets.begin(operand), mesh.vertexOffsets.end(operand));
	}
}

void weldOperandsTogether(MeshArrays& mesh) {
	weld(mesh, 0, mesh.faceOffsets.total(), 0, mesh.vertexOffsets.total());
}

}  // namespace index_boolean
