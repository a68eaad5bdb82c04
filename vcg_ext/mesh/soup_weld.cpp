// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A table of places, filled in the order of the faces' vertices.
#include "vcg_ext/mesh/soup_weld.h"

#include "vcg_ext/base/parallel.h"
#include "vcg_ext/mesh/vertex_table.h"

#include <algorithm>

namespace index_boolean {

namespace {

constexpr std::size_t kGrain = 1 << 15;

struct Range {
	std::uint32_t begin, end;

	std::uint32_t size() const { return end - begin; }
};

Range facesOf(const MeshArrays& mesh, OperandId operand) {
	return {mesh.faceOffsets.begin(operand), mesh.faceOffsets.end(operand)};
}

Range verticesOf(const MeshArrays& mesh, OperandId operand) {
	return {mesh.vertexOffsets.begin(operand), mesh.vertexOffsets.end(operand)};
}

// Welds the corners of some faces, whose vertices lie in a range, one after another.
class RangeWeld {
public:
	RangeWeld(MeshArrays& mesh, Range faces, Range vertices, Monitor& monitor)
	    : mesh_(mesh), faces_(faces), vertices_(vertices), monitor_(monitor) {}

	// \param any whether two vertices were in one place
	Status run(bool& any) {
		any = false;
		isUsed_.assign(vertices_.size(), 0);
		const Status status = forEachCorner([this](VertexId& v) { isUsed_[indexOf(v)] = 1; });
		return inOrder([&] { return status; }, [&] { return findStandIns(any); },
		               [&] {
			               const auto replace = [this](VertexId& v) { v = {stands_[indexOf(v)]}; };
			               return any ? forEachCorner(replace) : Status{};
		               });
	}

private:
	std::uint32_t indexOf(VertexId v) const { return v.value - vertices_.begin; }

	template <class Body>
	Status forEachCorner(Body&& body) {
		return inOrderFor(faces_.size(), kGrain, monitor_, [&](std::size_t begin, std::size_t end) {
			for (std::size_t f = begin; f < end; ++f) {
				for (VertexId& v : mesh_.triangles[faces_.begin + f]) {
					body(v);
				}
			}
		});
	}

	Status findStandIns(bool& any) {
		stands_.resize(vertices_.size());
		VertexTable table(mesh_.points,
		                  static_cast<std::size_t>(std::count(isUsed_.begin(), isUsed_.end(), 1)));
		return inOrderFor(vertices_.size(), kGrain, monitor_,
		                  [&](std::size_t begin, std::size_t end) {
			                  for (std::size_t i = begin; i < end; ++i) {
				                  const auto v = vertices_.begin + static_cast<std::uint32_t>(i);
				                  stands_[i] = isUsed_[i] != 0 ? table.findOrAdd(v) : v;
				                  any = any || stands_[i] != v;
			                  }
		                  });
	}

	MeshArrays& mesh_;
	Range faces_, vertices_;
	Monitor& monitor_;
	std::vector<std::uint8_t> isUsed_;   // per vertex of the range
	std::vector<std::uint32_t> stands_;  // per vertex of the range: the first in its place
};

}  // namespace

Status weldEachOperand(MeshArrays& mesh, Monitor& monitor, PerOperand<bool>& welded) {
	welded = PerOperand<bool>(mesh.operands().count());
	return forEachOperand(mesh.operands(), [&](OperandId operand) {
		bool any = false;
		const Status status =
		    RangeWeld(mesh, facesOf(mesh, operand), verticesOf(mesh, operand), monitor).run(any);
		welded[operand] = any;
		return status;
	});
}

Status weldOperandsTogether(MeshArrays& mesh, Monitor& monitor) {
	bool any = false;
	return RangeWeld(mesh, {0, mesh.faceOffsets.total()}, {0, mesh.vertexOffsets.total()}, monitor)
	    .run(any);
}

}  // namespace index_boolean
