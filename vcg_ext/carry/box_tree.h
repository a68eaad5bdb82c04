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

// Boxes, halved again and again by where their middles lie.
class BoxTree {
public:
	// \param boxes none of them empty; copied. Throws std::bad_alloc.
	// Complexity: O(n log n).
	explicit BoxTree(const std::vector<BoundingBox>& boxes);

	// Appends the boxes that a point lies in, their borders included, by index, in no order.
	// Throws std::bad_alloc. Any thread.
	// Complexity: O(log n + k) for k boxes near the point, as long as boxes overlap little.
	void find(const Point& p, std::vector<std::uint32_t>& out) const;

private:
	// The boxes order_[first .. last). The lower half is the next node, the upper one is `upper`;
	// kNone in a node that has no halves.
	struct Node {
		BoundingBox box;
		std::uint32_t first, last, upper;
	};

	void build(const std::vector<BoundingBox>& boxes, std::uint32_t first, std::uint32_t last);
	void find(const Point& p, std::uint32_t node, std::vector<std::uint32_t>& out) const;

	std::vector<std::uint32_t> order_;  // of the boxes, by index
	std::vector<BoundingBox> boxes_;    // in that order
	std::vector<Node> nodes_;
};

}  // namespace index_boolean
