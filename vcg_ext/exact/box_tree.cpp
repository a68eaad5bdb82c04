// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Halves by where boxes begin, along the axis on which they begin farthest apart.
#include "vcg_ext/exact/box_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace index_boolean {

namespace {

constexpr std::uint32_t kLeafSize = 8;

// Where a box begins; 0 in a direction in which it has no end.
double beginOf(const BoundingBox& box, std::size_t axis) {
	return std::isfinite(box.lo[axis]) ? box.lo[axis] : 0;
}

}  // namespace

BoxTree::BoxTree(std::vector<BoundingBox> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
	std::iota(order_.begin(), order_.end(), 0u);
	if (!boxes_.empty()) {
		nodes_.reserve(boxes_.size() / 2 + 1);  // a leaf holds four or more
		build(0, static_cast<std::uint32_t>(boxes_.size()));
	}
}

BoundingBox BoxTree::boxAround(std::uint32_t begin, std::uint32_t end) const {
	BoundingBox around = boxes_[order_[begin]];
	for (std::uint32_t i = begin + 1; i < end; ++i) {
		const BoundingBox& box = boxes_[order_[i]];
		for (std::size_t k = 0; k < 3; ++k) {
			around.lo[k] = std::min(around.lo[k], box.lo[k]);
			around.hi[k] = std::max(around.hi[k], box.hi[k]);
		}
	}
	return around;
}

void BoxTree::build(std::uint32_t begin, std::uint32_t end) {
	const auto index = static_cast<std::uint32_t>(nodes_.size());
	nodes_.push_back({boxAround(begin, end), begin, end, 0});
	if (end - begin <= kLeafSize) {
		return;
	}
	Point low{}, high{};  // of the boxes' beginnings
	for (std::size_t k = 0; k < 3; ++k) {
		low[k] = high[k] = beginOf(boxes_[order_[begin]], k);
	}
	for (std::uint32_t i = begin; i < end; ++i) {
		for (std::size_t k = 0; k < 3; ++k) {
			low[k] = std::min(low[k], beginOf(boxes_[order_[i]], k));
			high[k] = std::max(high[k], beginOf(boxes_[order_[i]], k));
		}
	}
	const std::array<double, 3> spread{high[0] / 2 - low[0] / 2, high[1] / 2 - low[1] / 2,
	                                   high[2] / 2 - low[2] / 2};
	const auto axis =
	    static_cast<std::size_t>(std::max_element(spread.begin(), spread.end()) - spread.begin());
	const std::uint32_t middle = begin + (end - begin) / 2;
	std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
	                 [this, axis](std::uint32_t a, std::uint32_t b) {
		                 return beginOf(boxes_[a], axis) < beginOf(boxes_[b], axis);
	                 });
	build(begin, middle);
	nodes_[index].right = static_cast<std::uint32_t>(nodes_.size());
	build(middle, end);
}

}  // namespace index_boolean
