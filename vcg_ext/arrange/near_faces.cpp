// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: faces; out: those near the suspect ones. A cell is told from coordinates by operations that
// never swap two numbers: a point that two faces have in common lies in a cell of both.
#include "vcg_ext/arrange/near_faces.h"

#include "vcg_ext/base/parallel.h"
#include "vcg_ext/exact/bounding_box.h"
#include "vcg_ext/mesh/vertex_table.h"

#include <algorithm>
#include <array>

namespace index_boolean {

namespace {

constexpr std::size_t kGrain = 1 << 14;
constexpr std::uint32_t kCells = 128;  // along an axis; no box reaches the first one and the last

BoundingBox boxOf(const FacesView& faces, std::size_t face) {
	BoundingBox box = emptyBox();
	for (const std::uint32_t v : faces[face]) {
		box.add(faces.point(v));
	}
	return box;
}

// A cell's number along each axis, a byte each, and in the last byte a bit for each side of the box
// that it lies beyond: two cells beyond one side have a bit in common.
using Cell = std::uint32_t;
constexpr Cell kBeyond = 0x3f000000;
constexpr Cell kNearSet = 0x40000000;  // a cell of the set is this one or beside it

// Whether two cells are one or beside each other. \pre numbers along axes below 128
bool areBeside(Cell a, Cell b) {
	constexpr Cell kAxes = 0xffffff, kOne = 0x010101, kMoreThanThree = 0xfcfcfc;
	const Cell difference = (a & kAxes) + kOne - (b & kAxes);  // plus one, along each axis
	return (difference & kMoreThanThree) == 0 && ((difference + kOne) & kMoreThanThree) == 0;
}

// Cells by their number along each axis, from `first` to `last`, both included.
struct CellRange {
	std::array<std::uint32_t, 3> first, last;

	template <std::size_t n>
	explicit CellRange(const std::array<Cell, n>& cells) {
		for (unsigned axis = 0; axis < 3; ++axis) {
			first[axis] = last[axis] = cells[0] >> 8 * axis & 0xff;
			for (const Cell cell : cells) {
				first[axis] = std::min(first[axis], cell >> 8 * axis & 0xff);
				last[axis] = std::max(last[axis], cell >> 8 * axis & 0xff);
			}
		}
	}
};

// A set of cells, a bit each: those along x are one row of two words.
class CellGrid {
public:
	explicit CellGrid(const BoundingBox& box) : rows_(kCells * kCells), spread_(rows_) {
		constexpr double kInside = kCells - 2 - 0x1p-20;  // the upper end is inside, too
		constexpr double kMost = 0x1p1000;                // and no infinity times zero
		for (std::size_t axis = 0; axis < 3; ++axis) {
			const double half = box.hi[axis] / 2 - box.lo[axis] / 2;
			halfLow_[axis] = box.lo[axis] / 2;
			perHalfUnit_[axis] = std::min(kInside / 2 / half, kMost);
		}
	}

	// What lies before the box is in the first cell along an axis, what lies behind it in the last,
	// but for what rounding takes in.
	Cell cellOf(const Point& point) const {
		Cell cell = 0;
		for (unsigned axis = 0; axis < 3; ++axis) {
			const std::uint32_t along = cellAlong(point[axis], axis);
			cell |= along << 8 * axis;
			cell |= (along == 0 ? 1U : 0U) << (24 + axis);
			cell |= (along == kCells - 1 ? 1U : 0U) << (27 + axis);
		}
		const Row& row = spread_[rowOf(cell)];
		const std::uint32_t x = cell & 0xff;
		return cell | ((row[x / 64] >> x % 64 & 1) != 0 ? kNearSet : 0);
	}

	// Whether the box around three points in these cells reaches a cell of the set. Most faces are
	// small: all cells of their boxes are beside that of a corner.
	bool isNear(const std::array<Cell, 3>& corners) const {
		const auto [a, b, c] = corners;
		return (a & b & c & kBeyond) == 0 &&
		       ((a & kNearSet) != 0 || !areBeside(a, b) || !areBeside(a, c)) &&
		       anyRow(CellRange(corners), [this](std::size_t row, const Row& cells) {
			       return ((rows_[row][0] & cells[0]) | (rows_[row][1] & cells[1])) != 0;
		       });
	}

	void add(const BoundingBox& box) {
		anyRow(CellRange(std::array{cellOf(box.lo), cellOf(box.hi)}),
		       [this](std::size_t row, const Row& cells) {
			       rows_[row][0] |= cells[0];
			       rows_[row][1] |= cells[1];
			       return false;
		       });
	}

	// To be called when all are added, before cells are marked as near the set.
	void spread() {
		spread_ = rows_;
		for (Row& row : spread_) {
			const Row before = row;
			row[0] |= before[0] << 1 | before[0] >> 1 | before[1] << 63;
			row[1] |= before[1] << 1 | before[1] >> 1 | before[0] >> 63;
		}
		spreadAlong(1);
		spreadAlong(kCells);
	}

private:
	using Row = std::array<std::uint64_t, 2>;

	static std::size_t rowOf(Cell cell) {
		return kCells * (cell >> 16 & 0xff) + (cell >> 8 & 0xff);
	}

	// To the rows that are `step` before and behind. (From the end of a slice to the begin of the
	// next one, too: more cells than need be are near.)
	void spreadAlong(std::size_t step) {
		for (std::size_t first = 0; first < step; ++first) {
			Row carried{};
			for (std::size_t i = first; i < spread_.size(); i += step) {
				const Row own = spread_[i];
				const Row next = i + step < spread_.size() ? spread_[i + step] : Row{};
				spread_[i] = {carried[0] | own[0] | next[0], carried[1] | own[1] | next[1]};
				carried = own;
			}
		}
	}

	// Never swaps two numbers, and no difference overflows. A vertex that no face has may be no
	// number: any cell will do.
	std::uint32_t cellAlong(double x, std::size_t axis) const {
		double cell = 1 + (x / 2 - halfLow_[axis]) * perHalfUnit_[axis];
		cell = cell > 0 ? cell : 0;
		return static_cast<std::uint32_t>(cell < kCells - 1 ? cell : kCells - 1);
	}

	static std::uint64_t bitsFrom(std::uint32_t first) {
		return first < 64 ? ~std::uint64_t{0} << first : 0;
	}

	// Calls visit(row, cells) for the rows of a range until it says true. \return whether it has
	template <class Visit>
	static bool anyRow(const CellRange& range, Visit&& visit) {
		const std::uint32_t from = range.first[0], end = range.last[0] + 1U;
		const Row cells{bitsFrom(from) & ~bitsFrom(end),
		                bitsFrom(from < 64 ? 0 : from - 64) & ~bitsFrom(end < 64 ? 0 : end - 64)};
		for (std::size_t z = range.first[2]; z <= range.last[2]; ++z) {
			for (std::size_t y = range.first[1]; y <= range.last[1]; ++y) {
				if (visit(kCells * z + y, cells)) {
					return true;
				}
			}
		}
		return false;
	}

	std::array<double, 3> halfLow_{}, perHalfUnit_{};
	std::vector<Row> rows_, spread_;  // the set; all cells that are in it or beside it
};

// A set of vertices that knows how many smaller ones there are of each: their new indices.
class VertexRanks {
public:
	explicit VertexRanks(std::size_t vertexCount) : words_(vertexCount / 64 + 1), before_(words_) {}

	void add(std::uint32_t v) { words_[v / 64] |= std::uint64_t{1} << v % 64; }

	// To be called when all are added. \return how many there are
	std::uint32_t count() {
		std::uint32_t sum = 0;
		for (std::size_t i = 0; i < words_.size(); ++i) {
			before_[i] = sum;
			sum += bitCount(words_[i]);
		}
		return sum;
	}

	std::uint32_t rank(std::uint32_t v) const {
		const std::uint64_t below = (std::uint64_t{1} << v % 64) - 1;
		return static_cast<std::uint32_t>(before_[v / 64]) + bitCount(words_[v / 64] & below);
	}

private:
	static std::uint32_t bitCount(std::uint64_t x) {
		x -= x >> 1U & 0x5555555555555555U;
		x = (x & 0x3333333333333333U) + (x >> 2U & 0x3333333333333333U);
		x = (x + (x >> 4U)) & 0x0f0f0f0f0f0f0f0fU;
		return static_cast<std::uint32_t>(x * 0x0101010101010101U >> 56U);
	}

	std::vector<std::uint64_t> words_, before_;
};

// The faces that reach a cell of the grid, by the cells of their corners.
Status collectNear(const FacesView& faces, const CellGrid& grid, int threads, Monitor& monitor,
                   std::vector<std::uint32_t>& out) {
	const Points& points = faces.points();
	auto cells = HugeVector<Cell>::forOverwrite(points.size());
	std::vector<std::vector<std::uint32_t>> parts(chunkCount(faces.count(), kGrain));
	const Status status = inOrder(
	    [&] {
		    return parallelFor(points.size(), kGrain, threads, monitor,
		                       [&](std::size_t begin, std::size_t end) {
			                       for (std::size_t v = begin; v < end; ++v) {
				                       cells[v] = grid.cellOf(points[v]);
			                       }
		                       });
	    },
	    [&] {
		    return parallelForChunks(
		        faces.count(), kGrain, threads, monitor,
		        [&](std::size_t chunk, std::size_t begin, std::size_t end) {
			        for (std::size_t f = begin; f < end; ++f) {
				        const IndexTriangle t = faces[f];
				        if (grid.isNear({cells[t[0]], cells[t[1]], cells[t[2]]})) {
					        parts[chunk].push_back(static_cast<std::uint32_t>(f));
				        }
			        }
		        });
	    });
	for (const std::vector<std::uint32_t>& part : parts) {
		out.insert(out.end(), part.begin(), part.end());
	}
	return status;
}

// Corners in one place get one index, that of the first of them.
void weld(FacesApart& faces) {
	VertexTable table(faces.points, faces.points.size());
	std::vector<std::uint32_t> keeper(faces.points.size());
	for (std::uint32_t v = 0; v < keeper.size(); ++v) {
		keeper[v] = table.findOrAdd(v);
	}
	for (IndexTriangle& t : faces.triangles) {
		t = {keeper[t[0]], keeper[t[1]], keeper[t[2]]};
	}
}

}  // namespace

Status findNearFaces(const FacesView& faces, const std::vector<std::uint8_t>& isSuspect,
                     int threads, Monitor& monitor, std::vector<std::uint32_t>& out) {
	std::vector<BoundingBox> suspects;
	for (std::size_t face = 0; face < faces.count(); ++face) {
		if (isSuspect[face] != 0) {
			suspects.push_back(boxOf(faces, face));
		}
	}
	return findFacesNear(faces, suspects, threads, monitor, out);  // a box is near itself
}

Status findFacesNear(const FacesView& faces, const std::vector<BoundingBox>& boxes, int threads,
                     Monitor& monitor, std::vector<std::uint32_t>& out) {
	out.clear();
	CellGrid grid(joinedBox(boxes.data(), boxes.size()));
	const Status status =
	    inOrderFor(boxes.size(), kGrain, monitor, [&](std::size_t begin, std::size_t end) {
		    std::for_each(boxes.begin() + static_cast<std::ptrdiff_t>(begin),
		                  boxes.begin() + static_cast<std::ptrdiff_t>(end),
		                  [&grid](const BoundingBox& box) { grid.add(box); });
	    });
	if (!status.ok() || boxes.empty()) {
		return status;
	}
	grid.spread();
	return collectNear(faces, grid, threads, monitor, out);
}

void copyFaces(const FacesView& faces, const std::vector<std::uint32_t>& which, FacesApart& out) {
	VertexRanks ranks(faces.points().size());
	for (const std::uint32_t face : which) {
		for (const std::uint32_t v : faces[face]) {
			ranks.add(v);
		}
	}
	out.points.resizeForOverwrite(ranks.count());
	out.triangles.resizeForOverwrite(which.size());
	for (std::size_t i = 0; i < which.size(); ++i) {
		const IndexTriangle t = faces[which[i]];
		for (std::size_t corner = 0; corner < 3; ++corner) {
			const std::uint32_t v = ranks.rank(t[corner]);
			out.triangles[i][corner] = v;
			out.points[v] = faces.point(t[corner]);
		}
	}
	weld(out);
}

}  // namespace index_boolean
