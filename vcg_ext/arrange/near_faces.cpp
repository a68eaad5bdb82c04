// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: faces; out: those near the suspect ones. A cell is told from coordinates by operations that
// never swap two numbers: a point that two faces have in common lies in a cell of both.
#include "vcg_ext/arrange/near_faces.h"

#include "vcg_ext/base/index_table.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/exact/bounding_box.h"
#include "vcg_ext/exact/coordinate_hash.h"

#include <algorithm>
#include <array>

namespace index_boolean {

namespace {

constexpr std::size_t kGrain = 1 << 14;
constexpr std::size_t kCells = 64;  // along an axis

BoundingBox boxOf(const FacesView& faces, std::size_t face) {
	BoundingBox box = emptyBox();
	for (const std::uint32_t v : faces[face]) {
		box.add(faces.point(v));
	}
	return box;
}

// Cells by their number along each axis, from `first` to `last`, both included.
struct CellRange {
	std::array<std::size_t, 3> first, last;
};

// A set of cells, a bit each: those along x are one word.
class CellGrid {
public:
	explicit CellGrid(const BoundingBox& box) : box_(box) {
		for (std::size_t axis = 0; axis < 3; ++axis) {
			const double half = box.hi[axis] / 2 - box.lo[axis] / 2;
			perHalfUnit_[axis] = half > 0 ? kCells / 2 / half : 0;
		}
	}

	// Whether a face may reach one of the cells. Most do not reach their common box: one axis
	// often tells.
	bool isNear(const FacesView& faces, std::size_t face) const {
		const IndexTriangle t = faces[face];
		const Point &p = faces.point(t[0]), &q = faces.point(t[1]), &r = faces.point(t[2]);
		for (std::size_t axis = 0; axis < 3; ++axis) {
			if (std::max({p[axis], q[axis], r[axis]}) < box_.lo[axis] ||
			    std::min({p[axis], q[axis], r[axis]}) > box_.hi[axis]) {
				return false;
			}
		}
		return anyRow(rangeOf(boxOf(faces, face)), [this](std::size_t row, std::uint64_t cells) {
			return (rows_[row] & cells) != 0;
		});
	}

	void add(const BoundingBox& box) {
		anyRow(rangeOf(box), [this](std::size_t row, std::uint64_t cells) {
			rows_[row] |= cells;
			return false;
		});
	}

private:
	// Written so that no difference overflows; an infinity or NaN of tiny boxes is the last cell.
	std::size_t cellOf(double x, std::size_t axis) const {
		const double clamped = std::min(std::max(x, box_.lo[axis]), box_.hi[axis]);
		const double cell = (clamped / 2 - box_.lo[axis] / 2) * perHalfUnit_[axis];
		return cell < kCells - 1 ? static_cast<std::size_t>(cell) : kCells - 1;
	}

	CellRange rangeOf(const BoundingBox& box) const {
		CellRange range{};
		for (std::size_t axis = 0; axis < 3; ++axis) {
			range.first[axis] = cellOf(box.lo[axis], axis);
			range.last[axis] = cellOf(box.hi[axis], axis);
		}
		return range;
	}

	// Calls visit(row, cells) for the rows of a range until it says true. \return whether it has
	template <class Visit>
	static bool anyRow(const CellRange& range, Visit&& visit) {
		const std::uint64_t cells =
		    ~std::uint64_t{0} << range.first[0] & ~std::uint64_t{0} >> (kCells - 1 - range.last[0]);
		for (std::size_t z = range.first[2]; z <= range.last[2]; ++z) {
			for (std::size_t y = range.first[1]; y <= range.last[1]; ++y) {
				if (visit(kCells * z + y, cells)) {
					return true;
				}
			}
		}
		return false;
	}

	BoundingBox box_;
	std::array<double, 3> perHalfUnit_{};
	std::array<std::uint64_t, kCells * kCells> rows_{};
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

// Corners in one place get one index, that of the first of them.
void weld(FacesApart& faces) {
	const Points& points = faces.points;
	IndexTable table(points.size());
	std::vector<std::uint32_t> keeper(points.size());
	for (std::uint32_t v = 0; v < keeper.size(); ++v) {
		const auto isThere = [&](std::uint32_t w) { return points[w] == points[v]; };
		std::uint32_t& slot = table.slotOf(coordinateHash(points[v]), isThere);
		slot = slot == IndexTable::kNone ? v : slot;
		keeper[v] = slot;
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
	std::vector<std::vector<std::uint32_t>> parts(chunkCount(faces.count(), kGrain));
	const Status found =
	    parallelForChunks(faces.count(), kGrain, threads, monitor,
	                      [&](std::size_t chunk, std::size_t begin, std::size_t end) {
		                      for (std::size_t face = begin; face < end; ++face) {
			                      if (grid.isNear(faces, face)) {
				                      parts[chunk].push_back(static_cast<std::uint32_t>(face));
			                      }
		                      }
	                      });
	for (const std::vector<std::uint32_t>& part : parts) {
		out.insert(out.end(), part.begin(), part.end());
	}
	return found;
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
