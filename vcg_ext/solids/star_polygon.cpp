// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
//          r            The centre v sees all of the polygon: each corner lies further round than
//        .    .         the one before. An ear is a corner q at which the polygon turns left, and
//      .        . q     for which v is not to the right of the cut from the corner before it, p, to
//    v         .        the one after it, r.
//      .     .
//        . p            Why an ear has no other corner in it: the triangle p q r lies in what v
//        sees
//                       between p and r, and there the polygon has no corner but q.
//
// Why the rest is a star again: p and r are less than half a turn apart as seen from v, or exactly
// that where v lies on the cut; what v saw beyond the cut has gone, all else is as it was. Once v
// lies on the border, it stays there: an ear that has v on one of its sides, or in it, stays.
// Why there mostly is an ear: a polygon with more than three corners has two ears that do not
// overlap, and v cannot lie in both; if it lies on the cut of each that is left, that will do.
// Whatever happens, each triangle that comes out turns left, and together they have the polygon's
// border; where no ear is found there is no answer.
#include "vcg_ext/solids/star_polygon.h"

namespace index_boolean {

namespace {

// Corners in a ring, which are cut off one after another.
class Ring {
public:
	explicit Ring(std::size_t n) : next_(n), previous_(n), size_(n) {
		for (std::size_t i = 0; i < n; ++i) {
			next_[i] = i + 1 == n ? 0 : i + 1;
			previous_[i] = i == 0 ? n - 1 : i - 1;
		}
	}

	std::size_t next(std::size_t i) const { return next_[i]; }
	std::size_t previous(std::size_t i) const { return previous_[i]; }
	std::size_t size() const { return size_; }
	void cutOff(std::size_t i) {
		next_[previous_[i]] = next_[i];
		previous_[next_[i]] = previous_[i];
		--size_;
	}

private:
	std::vector<std::size_t> next_, previous_;
	std::size_t size_;
};

class StarFiller {
public:
	explicit StarFiller(const StarPolygon& polygon)
	    : polygon_(polygon), ring_(polygon.corners.size()) {}

	bool run(const std::function<bool(std::size_t, std::size_t)>& isFree,
	         std::vector<std::array<std::size_t, 3>>& out);

private:
	bool findEar(std::size_t& corner) const;
	bool isEar(std::size_t corner, int leastSide) const;
	// +1: c lies to the left of the line from a to b.
	int turn(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c) const {
		return polygon_.front * orient2d(a, b, c, polygon_.axis);
	}
	bool turnsLeft(std::size_t i, std::size_t j, std::size_t k) const {
		return turn(polygon_.corners[i], polygon_.corners[j], polygon_.corners[k]) > 0;
	}

	const StarPolygon& polygon_;
	Ring ring_;
};

// \param leastSide of the cut, on which the centre is: 1: to its left; 0: on it at least
bool StarFiller::isEar(std::size_t corner, int leastSide) const {
	const std::size_t before = ring_.previous(corner), after = ring_.next(corner);
	return turnsLeft(before, corner, after) &&
	       turn(polygon_.corners[before], polygon_.corners[after], polygon_.centre) >= leastSide;
}

// The next ear from a corner on; one with the centre on its cut only if there is no better one.
bool StarFiller::findEar(std::size_t& corner) const {
	for (const int leastSide : {1, 0}) {
		for (std::size_t tried = 0; tried <= ring_.size(); ++tried) {
			if (isEar(corner, leastSide)) {
				return true;
			}
			corner = ring_.next(corner);
		}
	}
	return false;
}

bool StarFiller::run(const std::function<bool(std::size_t, std::size_t)>& isFree,
                     std::vector<std::array<std::size_t, 3>>& out) {
	std::size_t corner = 0;
	while (ring_.size() > 3) {
		if (!findEar(corner)) {
			return false;
		}
		const std::size_t before = ring_.previous(corner), after = ring_.next(corner);
		if (!isFree(before, after)) {
			return false;
		}
		out.push_back({before, corner, after});
		ring_.cutOff(corner);
		corner = ring_.next(after);  // the next but one: no long thin fans
	}
	const std::size_t second = ring_.next(corner), third = ring_.next(second);
	out.push_back({corner, second, third});
	return turnsLeft(corner, second, third);
}

}  // namespace

bool fillStar(const StarPolygon& polygon,
              const std::function<bool(std::size_t, std::size_t)>& isFree,
              std::vector<std::array<std::size_t, 3>>& out) {
	return StarFiller(polygon).run(isFree, out);
}

}  // namespace index_boolean
