// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// An ear is a corner at which the polygon turns its way, and whose triangle holds no other corner,
// not even on its sides. What is left when it is cut off is a simple polygon if that one was. After
// an ear the next corner but one is looked at: that makes no long fans.
#include "vcg_ext/exact/polygon_fill.h"

#include "vcg_ext/exact/exact_sign.h"

namespace index_boolean {

namespace {

constexpr std::size_t kMostCorners = 4096;

class EarCutter {
public:
	explicit EarCutter(const SeenPolygon& polygon) : polygon_(polygon) {
		for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
			ring_.push_back(i);
		}
	}

	bool run(const std::function<bool(std::size_t, std::size_t)>& mayCut,
	         std::vector<std::array<std::size_t, 3>>& out);

private:
	// +1: the way from i over j to k turns as the polygon does.
	int turn(std::size_t i, std::size_t j, std::size_t k) const {
		return polygon_.front * orient2d(polygon_.corners[i], polygon_.corners[j],
		                                 polygon_.corners[k], polygon_.axis);
	}
	std::size_t before(std::size_t at) const {
		return ring_[(at + ring_.size() - 1) % ring_.size()];
	}
	std::size_t after(std::size_t at) const { return ring_[(at + 1) % ring_.size()]; }
	bool isEar(std::size_t at) const;

	const SeenPolygon& polygon_;
	std::vector<std::size_t> ring_;  // the corners that are left
};

bool EarCutter::isEar(std::size_t at) const {
	const std::size_t p = before(at), q = ring_[at], r = after(at);
	if (turn(p, q, r) <= 0) {
		return false;
	}
	for (const std::size_t other : ring_) {
		if (other != p && other != q && other != r && turn(p, q, other) >= 0 &&
		    turn(q, r, other) >= 0 && turn(r, p, other) >= 0) {
			return false;
		}
	}
	return true;
}

bool EarCutter::run(const std::function<bool(std::size_t, std::size_t)>& mayCut,
                    std::vector<std::array<std::size_t, 3>>& out) {
	std::size_t at = 0, tried = 0;
	while (ring_.size() > 3 && tried < ring_.size()) {
		if (isEar(at) && mayCut(before(at), after(at))) {
			out.push_back({before(at), ring_[at], after(at)});
			ring_.erase(ring_.begin() + static_cast<std::ptrdiff_t>(at));
			tried = 0;
		} else {
			++tried;
		}
		at = (at + 1) % ring_.size();
	}
	out.push_back({ring_[0], ring_[1], ring_[2]});
	return ring_.size() == 3 && turn(ring_[0], ring_[1], ring_[2]) > 0;
}

}  // namespace

bool fillPolygon(const SeenPolygon& polygon,
                 const std::function<bool(std::size_t, std::size_t)>& mayCut,
                 std::vector<std::array<std::size_t, 3>>& out) {
	const std::size_t n = polygon.corners.size();
	return n >= 3 && n <= kMostCorners && EarCutter(polygon).run(mayCut, out);
}

}  // namespace index_boolean
