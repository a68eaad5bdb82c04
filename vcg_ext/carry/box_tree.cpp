// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The order is that of the middles along a curve that fills space: each bit of its number halves
// the space in another direction. Rounding there costs time at most.
#include "vcg_ext/carry/box_tree.h"

#include <algorithm>
#include <cmath>

namespace index_boolean {

namespace {

constexpr std::size_t kFew = 8;  // boxes in one of the next level
constexpr unsigned kBits = 21;   // of the number, in each direction

bool contains(const BoundingBox& box, const Point& p) {
	return box.lo[0] <= p[0] && p[0] <= box.hi[0] && box.lo[1] <= p[1] && p[1] <= box.hi[1] &&
	       box.lo[2] <= p[2] && p[2] <= box.hi[2];
}

void extend(BoundingBox& box, const BoundingBox& by) {
	for (std::size_t axis = 0; axis < 3; ++axis) {
		box.lo[axis] = std::min(box.lo[axis], by.lo[axis]);
		box.hi[axis] = std::max(box.hi[axis], by.hi[axis]);
	}
}

// 0 in a direction without end, where all middles are alike.
Point middleOf(const BoundingBox& box) {
	Point middle{};
	for (std::size_t axis = 0; axis < 3; ++axis) {
		const double m = box.lo[axis] / 2 + box.hi[axis] / 2;
		middle[axis] = std::isfinite(m) ? m : 0;
	}
	return middle;
}

// The bits of a number, three places apart.
std::uint64_t spread(std::uint64_t x) {
	x = (x | x << 32U) & 0x1f00000000ffffu;
	x = (x | x << 16U) & 0x1f0000ff0000ffu;
	x = (x | x << 8U) & 0x100f00f00f00f00fu;
	x = (x | x << 4U) & 0x10c30c30c30c30c3u;
	return (x | x << 2U) & 0x1249249249249249u;
}

// The place of a point of a box on the curve through that box.
std::uint64_t placeOnCurve(const Point& p, const BoundingBox& all) {
	std::uint64_t place = 0;
	for (std::size_t axis = 0; axis < 3; ++axis) {
		const double range = all.hi[axis] / 2 - all.lo[axis] / 2;  // halves do not overflow
		const double share = range > 0 ? (p[axis] / 2 - all.lo[axis] / 2) / range : 0;
		const double cell = share * static_cast<double>((1U << kBits) - 1);
		place |= spread(static_cast<std::uint64_t>(cell)) << axis;
	}
	return place;
}

std::vector<std::uint32_t> orderAlongCurve(const std::vector<BoundingBox>& boxes) {
	std::vector<Point> middles(boxes.size());
	std::transform(boxes.begin(), boxes.end(), middles.begin(), middleOf);
	BoundingBox all{middles.front(), middles.front()};
	for (const Point& p : middles) {
		extend(all, {p, p});
	}
	std::vector<std::pair<std::uint64_t, std::uint32_t>> places;
	places.reserve(boxes.size());
	for (std::uint32_t i = 0; i < boxes.size(); ++i) {
		places.emplace_back(placeOnCurve(middles[i], all), i);
	}
	std::sort(places.begin(), places.end());
	std::vector<std::uint32_t> order(boxes.size());
	std::transform(places.begin(), places.end(), order.begin(),
	               [](const auto& place) { return place.second; });
	return order;
}

}  // namespace

BoxTree::BoxTree(std::vector<BoundingBox> boxes) {
	if (boxes.empty()) {
		return;
	}
	order_ = orderAlongCurve(boxes);
	std::vector<BoundingBox> level;
	level.reserve(boxes.size());
	for (const std::uint32_t box : order_) {
		level.push_back(boxes[box]);
	}
	boxes = {};
	levels_.push_back(std::move(level));
	while (levels_.back().size() > 1) {
		const std::vector<BoundingBox>& below = levels_.back();
		std::vector<BoundingBox> above;
		for (std::size_t i = 0; i < below.size(); ++i) {
			if (i % kFew == 0) {
				above.push_back(below[i]);
			} else {
				extend(above.back(), below[i]);
			}
		}
		levels_.push_back(std::move(above));
	}
}

void BoxTree::find(const Point& p, std::vector<std::uint32_t>& out) const {
	if (!levels_.empty() && contains(levels_.back()[0], p)) {
		findBelow(p, levels_.size() - 1, 0, out);
	}
}

// \pre the point lies in the box
void BoxTree::findBelow(const Point& p, std::size_t level, std::size_t box,
                        std::vector<std::uint32_t>& out) const {
	if (level == 0) {
		out.push_back(order_[box]);
		return;
	}
	const std::vector<BoundingBox>& below = levels_[level - 1];
	const std::size_t end = std::min(below.size(), (box + 1) * kFew);
	for (std::size_t i = box * kFew; i < end; ++i) {
		if (contains(below[i], p)) {
			findBelow(p, level - 1, i, out);
		}
	}
}

}  // namespace index_boolean
