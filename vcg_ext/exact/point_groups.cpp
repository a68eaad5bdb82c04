// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Two grids, whose cells have powers of two as sides, so that the cell of a point is found without
// rounding. A small cell is at most half the distance wide: all points in it are linked. A large
// one is a few distances wide and lists the small ones in it: what a small cell may be linked to
// lies in the few large ones that its surroundings reach into. Small cells are compared by the
// boxes of their points, which nearly always tells, and else by halves of these.
#include "vcg_ext/exact/point_groups.h"

#include "vcg_ext/base/index_table.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/base/union_find.h"
#include "vcg_ext/exact/bounding_box.h"
#include "vcg_ext/exact/coordinate_hash.h"
#include "vcg_ext/exact/distance_order.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace index_boolean {

namespace {

constexpr std::size_t kPollCells = 4096;

// --- pairs of points ----------------------------------------------------------------------------

// Indices of points, which a search may bring into another order.
struct PointSet {
	std::uint32_t* begin;
	std::uint32_t* end;

	std::size_t size() const { return static_cast<std::size_t>(end - begin); }
};

BoundingBox boxOf(const Points& points, const PointSet& set) {
	BoundingBox box = emptyBox();
	std::for_each(set.begin, set.end, [&](std::uint32_t i) { box.add(points[i]); });
	return box;
}

// The ends of the shortest way from one box to another.
std::array<Point, 2> nearestPlaces(const BoundingBox& a, const BoundingBox& b) {
	std::array<Point, 2> places{a.lo, a.lo};
	for (std::size_t k = 0; k < 3; ++k) {
		if (a.hi[k] < b.lo[k]) {
			places[0][k] = a.hi[k];
			places[1][k] = b.lo[k];
		} else if (b.hi[k] < a.lo[k]) {
			places[1][k] = b.hi[k];
		}
	}
	return places;
}

// Looks for two points, one of each of two sets, that are nearer to each other than a distance.
struct NearerThan {
	double distance;

	bool mayBe(const BoundingBox& a, const BoundingBox& b) const {
		const auto [p, q] = nearestPlaces(a, b);
		return isTrue(p, q);
	}
	bool isTrue(const Point& p, const Point& q) const {
		return compareDistance(p, q, distance) < 0;
	}
};

// The same, for two points that are farther from each other than twice a distance. No two points in
// a box are farther from each other than its corners.
struct FartherThanTwice {
	double distance;

	bool mayBe(const BoundingBox& a, const BoundingBox& b) const {
		BoundingBox both = a;
		both.add(b.lo);
		both.add(b.hi);
		return isTrue(both.lo, both.hi);
	}
	bool isTrue(const Point& p, const Point& q) const {
		return compareDistance(p, q, distance, 2) > 0;
	}
};

// Divides sets until boxes or few points tell.
template <class Question>
class PairSearch {
public:
	PairSearch(const Points& points, const Question& question)
	    : points_(points), question_(question) {}

	// Whether it is true of any pair. The sets are the same or have nothing in common.
	bool any(const PointSet& a, const PointSet& b) const {
		if (!question_.mayBe(boxOf(points_, a), boxOf(points_, b))) {
			return false;
		}
		if (a.size() <= kFew && b.size() <= kFew) {
			return anyOfFew(a, b);
		}
		const bool isOne = a.begin == b.begin;
		const bool splitsFirst = isOne || a.size() >= b.size();
		const auto [low, high] = halves(splitsFirst ? a : b);
		if (isOne) {
			return any(low, high) || any(low, low) || any(high, high);
		}
		const PointSet& whole = splitsFirst ? b : a;
		return any(low, whole) || any(high, whole);
	}

private:
	static constexpr std::size_t kFew = 8;

	bool anyOfFew(const PointSet& a, const PointSet& b) const {
		return std::any_of(a.begin, a.end, [&](std::uint32_t i) {
			return std::any_of(b.begin, b.end, [&](std::uint32_t j) {
				return question_.isTrue(points_[i], points_[j]);
			});
		});
	}

	// Across the longest side of its box.
	std::array<PointSet, 2> halves(const PointSet& set) const {
		const BoundingBox box = boxOf(points_, set);
		std::size_t axis = 0;
		for (std::size_t k = 1; k < 3; ++k) {
			// Halved, lest the difference overflow; which side it is changes no answer.
			const double side = box.hi[k] / 2 - box.lo[k] / 2;
			axis = side > box.hi[axis] / 2 - box.lo[axis] / 2 ? k : axis;
		}
		std::uint32_t* const middle = set.begin + set.size() / 2;
		std::nth_element(set.begin, middle, set.end, [&](std::uint32_t i, std::uint32_t j) {
			return points_[i][axis] < points_[j][axis];
		});
		return {PointSet{set.begin, middle}, PointSet{middle, set.end}};
	}

	const Points& points_;
	Question question_;
};

// --- cells --------------------------------------------------------------------------------------

// The lower end of the cell that a coordinate lies in; never falls as the coordinate rises. Where
// numbers are farther from each other than a cell is wide, each is one of its own.
// \param side a power of two
double cellBegin(double coordinate, double side) {
	constexpr double kHasFraction = 0x1p53;
	const double cells = coordinate / side;
	return std::fabs(cells) < kHasFraction ? std::floor(cells) * side : coordinate;
}

Point cellBegin(const Point& p, double side) {
	return {cellBegin(p[0], side), cellBegin(p[1], side), cellBegin(p[2], side)};
}

// Cells by their places.
class CellTable {
	auto isAt(const Point& begin) const {
		return [this, &begin](std::uint32_t cell) { return begins_[cell] == begin; };
	}

public:
	// \param most how many cells there may be
	explicit CellTable(std::size_t most) : table_(most) {}

	// The number of a cell, from 0 on in the order of the first calls.
	std::uint32_t findOrAdd(const Point& begin) {
		std::uint32_t& slot = table_.slotOf(coordinateHash(begin), isAt(begin));
		if (slot == IndexTable::kNone) {
			slot = static_cast<std::uint32_t>(begins_.size());
			begins_.push_back(begin);
		}
		return slot;
	}

	// IndexTable::kNone if there is none.
	std::uint32_t find(const Point& begin) const {
		return table_.find(coordinateHash(begin), isAt(begin));
	}

	std::size_t size() const { return begins_.size(); }
	const Point& begin(std::size_t cell) const { return begins_[cell]; }

private:
	IndexTable table_;
	std::vector<Point> begins_;
};

// Items by the cell that each is in.
class CellLists {
public:
	// \param cells how many there are \param cellOf per item
	CellLists(std::size_t cells, const std::vector<std::uint32_t>& cellOf)
	    : begins_(cells + 1), items_(cellOf.size()) {
		for (const std::uint32_t cell : cellOf) {
			++begins_[cell + 1];
		}
		for (std::size_t cell = 0; cell < cells; ++cell) {
			begins_[cell + 1] += begins_[cell];
		}
		std::vector<std::uint32_t> next(begins_.begin(), begins_.end() - 1);
		for (std::size_t item = 0; item < cellOf.size(); ++item) {
			items_[next[cellOf[item]]++] = static_cast<std::uint32_t>(item);
		}
	}

	PointSet of(std::size_t cell) {
		return {items_.data() + begins_[cell], items_.data() + begins_[cell + 1]};
	}

private:
	std::vector<std::uint32_t> begins_, items_;
};

class GroupFinder {
public:
	GroupFinder(const Points& points, double distance)
	    : points_(points), distance_(distance), search_(points, NearerThan{distance}),
	      small_(points.size()) {
		// 2^(exponent - 1) <= distance < 2^exponent
		int exponent = 0;
		std::frexp(distance, &exponent);
		constexpr int kSmallest = -1074, kLargest = 1023;
		smallSide_ = std::ldexp(1.0, std::max(exponent - 2, kSmallest));
		largeSide_ = std::ldexp(1.0, std::min(std::max(exponent + 1, kSmallest), kLargest));
	}

	Status run(Monitor& monitor, std::vector<std::uint32_t>& smallest) {
		std::vector<std::uint32_t> smallOf(points_.size());
		for (std::size_t i = 0; i < points_.size(); ++i) {
			smallOf[i] = small_.findOrAdd(cellBegin(points_[i], smallSide_));
		}
		CellTable large(small_.size());
		std::vector<std::uint32_t> largeOf(small_.size());
		for (std::size_t cell = 0; cell < small_.size(); ++cell) {
			largeOf[cell] = large.findOrAdd(cellBegin(small_.begin(cell), largeSide_));
		}
		CellLists members(small_.size(), smallOf), contents(large.size(), largeOf);
		for (std::size_t cell = 0; cell < small_.size(); ++cell) {
			boxes_.push_back(boxOf(points_, members.of(cell)));
		}
		UnionFind groups(small_.size());
		const auto link = [&](std::size_t begin, std::size_t end) {
			for (std::size_t cell = begin; cell < end; ++cell) {
				linkCell(static_cast<std::uint32_t>(cell), large, members, contents, groups);
			}
		};
		const Status status = inOrderFor(small_.size(), kPollCells, monitor, link);
		if (status.ok()) {
			listSmallest(smallOf, groups, smallest);
		}
		return status;
	}

private:
	// Unites a small cell with those that come after it and are linked to it.
	void linkCell(std::uint32_t cell, const CellTable& large, CellLists& members,
	              CellLists& contents, UnionFind& groups) const {
		const PointSet own = members.of(cell);
		const BoundingBox& box = boxes_[cell];
		const auto linkTo = [&](std::uint32_t other) {
			if (other > cell && !areApart(box, boxes_[other]) &&
			    groups.find(cell) != groups.find(other) && search_.any(own, members.of(other))) {
				groups.unite(cell, other);
			}
		};
		std::array<std::vector<double>, 3> begins;
		for (std::size_t k = 0; k < 3; ++k) {
			begins[k] = largeCellsBetween(box.lo[k] - distance_, box.hi[k] + distance_);
		}
		for (const double x : begins[0]) {
			for (const double y : begins[1]) {
				for (const double z : begins[2]) {
					const std::uint32_t found = large.find({x, y, z});
					if (found != IndexTable::kNone) {
						const PointSet inside = contents.of(found);
						std::for_each(inside.begin, inside.end, linkTo);
					}
				}
			}
		}
	}

	// Whether one axis tells that no two points are near: a difference that is rounded to more than
	// the distance is more.
	bool areApart(const BoundingBox& a, const BoundingBox& b) const {
		return a.lo[0] - b.hi[0] > distance_ || b.lo[0] - a.hi[0] > distance_ ||
		       a.lo[1] - b.hi[1] > distance_ || b.lo[1] - a.hi[1] > distance_ ||
		       a.lo[2] - b.hi[2] > distance_ || b.lo[2] - a.hi[2] > distance_;
	}

	// Where the cells begin that have a number from one to another in them: as cells never fall, no
	// rounding of the two leaves one out. Mostly one or two.
	std::vector<double> largeCellsBetween(double from, double to) const {
		constexpr double kMost = std::numeric_limits<double>::max();
		double cell = cellBegin(std::max(from, -kMost), largeSide_);
		const double last = cellBegin(std::min(to, kMost), largeSide_);
		std::vector<double> begins{cell};
		while (cell < last) {
			// The lowest of all cells may begin at -2^1024, which is no double.
			const double next =
			    std::isinf(cell) ? 2 * (largeSide_ / 2 - 0x1p1023) : cell + largeSide_;
			cell = cell < next && next < last ? next : last;
			begins.push_back(cell);
		}
		return begins;
	}

	void listSmallest(const std::vector<std::uint32_t>& smallOf, UnionFind& groups,
	                  std::vector<std::uint32_t>& smallest) const {
		std::vector<std::uint32_t> ofRoot(small_.size(), kNone);
		for (std::uint32_t i = 0; i < points_.size(); ++i) {
			std::uint32_t& best = ofRoot[groups.find(smallOf[i])];
			best = best == kNone || points_[i] < points_[best] ? i : best;
		}
		smallest.resize(points_.size());
		for (std::size_t i = 0; i < points_.size(); ++i) {
			smallest[i] = ofRoot[groups.find(smallOf[i])];
		}
	}

	const Points& points_;
	double distance_;
	PairSearch<NearerThan> search_;
	CellTable small_;
	std::vector<BoundingBox> boxes_;  // of the points in each small cell
	double smallSide_ = 0, largeSide_ = 0;
};

// Whether one side of a box is longer than twice the distance: the points at both ends of it are.
bool hasLongSide(const BoundingBox& box, const FartherThanTwice& question) {
	for (std::size_t k = 0; k < 3; ++k) {
		Point low{}, high{};
		low[k] = box.lo[k];
		high[k] = box.hi[k];
		if (question.isTrue(low, high)) {
			return true;
		}
	}
	return false;
}

}  // namespace

Status groupPoints(const Points& points, double distance, Monitor& monitor,
                   std::vector<std::uint32_t>& smallest) {
	return GroupFinder(points, distance).run(monitor, smallest);
}

Status findWideGroups(const Points& points, const std::vector<std::uint32_t>& smallest,
                      double distance, Monitor& monitor, std::vector<std::uint32_t>& wide) {
	wide.clear();
	CellLists groups(points.size(), smallest);
	const FartherThanTwice question{distance};
	const PairSearch<FartherThanTwice> search(points, question);
	return inOrderFor(points.size(), kPollCells, monitor, [&](std::size_t begin, std::size_t end) {
		for (std::size_t i = begin; i < end; ++i) {
			const PointSet group = groups.of(i);
			if (group.size() < 2) {
				continue;
			}
			const BoundingBox box = boxOf(points, group);
			if (hasLongSide(box, question) || search.any(group, group)) {
				wide.push_back(static_cast<std::uint32_t>(i));
			}
		}
	});
}

}  // namespace index_boolean
