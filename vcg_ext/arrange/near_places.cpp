// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points are found by the cells of a grid that is as wide as they reach.
#include "vcg_ext/arrange/near_places.h"

#include "vcg_ext/arrange/places.h"
#include "vcg_ext/base/sorted_list.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace index_boolean {

namespace {

// A cell's number along each axis: a whole number, which may be larger than integers are.
using Cell = Point;

Cell cellOf(const Point& p, double width) {
	return {std::floor(p[0] / width), std::floor(p[1] / width), std::floor(p[2] / width)};
}

template <class Visit>
void visitAround(const Cell& cell, Visit&& visit) {
	for (int i = 0; i < 27; ++i) {
		visit(Cell{cell[0] + (i % 3 - 1), cell[1] + (i / 3 % 3 - 1), cell[2] + (i / 9 - 1)});
	}
}

bool areNear(const Point& a, const Point& b, double reach) {
	return std::fabs(a[0] - b[0]) <= reach && std::fabs(a[1] - b[1]) <= reach &&
	       std::fabs(a[2] - b[2]) <= reach;
}

// The cells in which one of the places lies, and those around them; ascending.
std::vector<Cell> cellsAround(const Points& places, double width) {
	std::vector<Cell> cells;
	cells.reserve(places.size());
	for (const Point& place : places) {
		cells.push_back(cellOf(place, width));
	}
	sortUnique(cells);
	std::vector<Cell> around;
	around.reserve(27 * cells.size());
	for (const Cell& cell : cells) {
		visitAround(cell, [&](const Cell& c) { around.push_back(c); });
	}
	sortUnique(around);
	return around;
}

// The points near the places, by cells.
class CellTable {
public:
	CellTable(const Points& points, const std::vector<Cell>& cells, double width) {
		for (std::uint32_t i = 0; i < points.size(); ++i) {
			const Cell cell = cellOf(points[i], width);
			if (std::binary_search(cells.begin(), cells.end(), cell)) {
				entries_.push_back({cell, i});
			}
		}
		std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
			return std::tie(a.cell, a.point) < std::tie(b.cell, b.point);
		});
	}

	std::vector<std::uint32_t> points() const {
		std::vector<std::uint32_t> all;
		for (const Entry& entry : entries_) {
			all.push_back(entry.point);
		}
		return all;
	}

	template <class Visit>
	void visitPointsIn(const Cell& cell, Visit&& visit) const {
		auto entry = std::lower_bound(entries_.begin(), entries_.end(), cell,
		                              [](const Entry& e, const Cell& c) { return e.cell < c; });
		for (; entry != entries_.end() && entry->cell == cell; ++entry) {
			visit(entry->point);
		}
	}

private:
	struct Entry {
		Cell cell;
		std::uint32_t point;
	};
	std::vector<Entry> entries_;
};

}  // namespace

double unitOf(const Points& points, OutputScalar scalar) {
	double largest = 0;
	for (const Point& p : points) {
		for (const double x : p) {
			largest = std::max(largest, std::fabs(x));
		}
	}
	return gapAt(largest, scalar);
}

std::size_t joinNearPlaces(const Points& places, const std::vector<std::uint8_t>& ranks,
                           double reach, Points& points) {
	const CellTable table(points, cellsAround(places, reach), reach);
	std::vector<std::uint32_t> order = table.points();
	std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
		return std::tie(ranks[a], points[a]) < std::tie(ranks[b], points[b]);
	});
	std::vector<std::uint8_t> isTaken(points.size(), 0);
	std::size_t moved = 0;
	for (const std::uint32_t center : order) {
		if (isTaken[center] != 0) {
			continue;
		}
		const Point place = points[center];
		visitAround(cellOf(place, reach), [&](const Cell& cell) {
			table.visitPointsIn(cell, [&](std::uint32_t other) {
				if (isTaken[other] == 0 && areNear(points[other], place, reach)) {
					isTaken[other] = 1;
					moved += points[other] != place ? 1 : 0;
					points[other] = place;  // it takes no others, so its place is not asked again
				}
			});
		});
	}
	return moved;
}

}  // namespace index_boolean
