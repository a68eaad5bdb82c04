// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: vertices, one after another; out: for each the first one in its place. Guarantee: places are
// compared as numbers, so that both zeros are one.
#pragma once

#include "vcg_ext/base/index_table.h"
#include "vcg_ext/base/mesh_types.h"
#include "vcg_ext/exact/coordinate_hash.h"

namespace index_boolean {

// Vertices by their coordinates. Borrows the points, which may grow meanwhile.
class VertexTable {
	auto isAt(const Point& p) const {
		return [this, &p](std::uint32_t vertex) { return points_[vertex] == p; };
	}

public:
	// \param most how many vertices may be put there. Throws std::bad_alloc. O(most).
	VertexTable(const Points& points, std::size_t most) : points_(points), table_(most) {}

	// The vertex at this one's place; if there is none yet, this one, which is put there. O(1) as
	// expected.
	std::uint32_t findOrAdd(std::uint32_t vertex) {
		const Point& p = points_[vertex];
		std::uint32_t& slot = table_.slotOf(coordinateHash(p), isAt(p));
		if (slot == IndexTable::kNone) {
			slot = vertex;
		}
		return slot;
	}

	// The vertex at a place, or IndexTable::kNone. O(1) as expected.
	std::uint32_t vertexAt(const Point& p) const { return table_.find(coordinateHash(p), isAt(p)); }

private:
	const Points& points_;
	IndexTable table_;
};

}  // namespace index_boolean
