// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Halves have the same number of boxes, so the tree is never deep, wherever the boxes lie.
#include "vcg_ext/carry/box_tree.h"

#include "vcg_ext/base/ids.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace index_boolean {

namespace {

constexpr std::uint32_t kFew = 4;  // boxes that are not halved

bool contains(const BoundingBox& box, const Point& p) {
	return box.lo[0] <= p[0] && p[0] <= box.hi[0] && box.lo[1] <= p[1] && p[1] <= box.hi[1] &&
	       box.lo[2] <= p[2] && p[2] <= box.hi[2];
}

// 0 in a direction without end, where all middles are alike.
double middleOf(const BoundingBox& box, std::size_t axis) {
	return std::isfinite(box.lo[axis]) ? box.lo[axis] / 2 + box.hi[axis] / 2 : 0;
}

void extend(BoundingBox& box, const BoundingBox& by) {
	for (std::size_t axis = 0; axis < 3; ++axis) {
		box.lo[axis] = std::min(box.lo[axis], by.lo[axis]);
		box.hi[axis] = std::max(box.hi[axis], by.hi[axis]);
	}
}

}  // namespace

BoxTree::BoxTree(const std::vector<BoundingBox>& boxes) : order_(boxes.size()) {
	std::iota(order_.begin(), order_.end(), 0u);
	if (!boxes.empty()) {
		build(boxes, 0, static_cast<std::uint32_t>(boxes.size()));
	}
	for (const std::uint32_t box : order_) {
		boxes_.push_back(boxes[box]);
	}
}

void BoxTree::build(const std::vector<BoundingBox>& boxes, std::uint32_t first,
                    std::uint32_t last) {
	const std::size_t node = nodes_.size();
	nodes_.push_back({boxes[order_[first]], first, last, kNone});
	Point least, most;
	least.fill(HUGE_VAL);
	most.fill(-HUGE_VAL);
	for (std::uint32_t i = first; i < last; ++i) {
		const BoundingBox& box = boxes[order_[i]];
		extend(nodes_[node].box, box);
		for (std::size_t axis = 0; axis < 3; ++axis) {
			least[axis] = std::min(least[axis], middleOf(box, axis));
			most[axis] = std::max(most[axis], middleOf(box, axis));
		}
	}
	if (last - first <= kFew) {
		return;
	}
	std::size_t widest = 0;
	for (std::size_t axis = 1; axis < 3; ++axis) {
		widest = most[axis] - least[axis] > most[widest] - least[widest] ? axis : widest;
	}
	const std::uint32_t half = first + (last - first) / 2;
	std::nth_element(order_.begin() + first, order_.begin() + half, order_.begin() + last,
	                 [&](std::uint32_t a, std::uint32_t b) {
		                 return middleOf(boxes[a], widest) < middleOf(boxes[b], widest);
	                 });
	build(boxes, first, half);
	nodes_[node].upper = static_cast<std::uint32_t>(nodes_.size());
	build(boxes, half, last);
}

void BoxTree::find(const Point& p, std::vector<std::uint32_t>& out) const {
	if (!nodes_.empty()) {
		find(p, 0, out);
	}
}

void BoxTree::find(const Point& p, std::uint32_t node, std::vector<std::uint32_t>& out) const {
	const Node& n = nodes_[node];
	if (!contains(n.box, p)) {
		return;
	}
	if (n.upper != kNone) {
		find(p, node + 1, out);
		find(p, n.upper, out);
		return;
	}
	for (std::uint32_t i = n.first; i < n.last; ++i) {
		if (contains(boxes_[i], p)) {
			out.push_back(order_[i]);
		}
	}
}

}  // namespace index_boolean
