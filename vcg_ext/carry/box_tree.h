// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: boxes; out: those that a point lies in, without looking at all of them.
// Guarantee: by comparing coordinates alone, so exact; a box may be without end in a direction.
#pragma once

#include "vcg_ext/exact/bounding_box.h"

#include <cstdint>
#include <vector>

namespace index_boolean {

// Boxes in an order that keeps neighbours together, and boxes around each few of them.
class BoxTree {
public:
	// \param boxes none of them empty. Throws std::bad_alloc.
	// Complexity: O(n log n).
	explicit BoxTree(std::vector<BoundingBox> boxes);

	// Appends the boxes that a point lies in, their borders included, by index, in no order.
	// Throws std::bad_alloc. Any thread may ask.
	// Complexity: O(log n + k) for k boxes near the point, as long as boxes overlap little.
	void find(const Point& p, std::vector<std::uint32_t>& out) const;

private:
	void findBelow(const Point& p, std::size_t level, std::size_t box,
	               std::vector<std::uint32_t>& out) const;

	std::vector<std::uint32_t> order_;              // of the boxes, by index
	std::vector<std::vector<BoundingBox>> levels_;  // the boxes in order; around each few of them;
	                                                // and so on up to one
};

}  // namespace index_boolean
