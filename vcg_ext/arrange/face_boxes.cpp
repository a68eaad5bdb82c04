// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: both operands' triangles; out: boxes near both. First goes what lies beyond the common box,
// then what shares no cell of a grid with the other operand. The cells are as small as nodes six
// levels down the octree, where the paper's rule for dead nodes leaves little.
// The first common box is that of all vertices, the quickest to have. If vertices far away, which
// no face uses, have blown it up, all that is listed huddles in a few cells: then once more, from
// the listed faces alone.
#include "vcg_ext/arrange/face_boxes.h"

#include "vcg_ext/arrange/box_frame.h"
#include "vcg_ext/base/huge_vector.h"
#include "vcg_ext/base/parallel.h"

#include <algorithm>
#include <atomic>

namespace index_boolean {

namespace {

constexpr std::size_t kGrain = 8192;

// A vertex in the frame. `beyond` holds, as bits, the sides of the common box that it lies beyond:
// a face with all corners beyond one of them meets no face of the other operand.
struct FramePoint {
	std::array<float, 3> x;
	std::uint32_t beyond;
};

// The common box and its map.
struct CommonFrame {
	explicit CommonFrame(const BoundingBox& common) : box(common), cube(makeBoxFrame(common)) {}

	FramePoint map(const Point& point) const {
		FramePoint result{};
		for (unsigned axis = 0; axis < 3; ++axis) {
			const double lo = box.lo[axis];
			const double hi = box.hi[axis];
			result.x[axis] = cube.map(std::min(std::max(point[axis], lo), hi), axis);
			result.beyond |= (point[axis] < lo ? 1U : 0U) << (2 * axis);
			result.beyond |= (point[axis] > hi ? 2U : 0U) << (2 * axis);
		}
		return result;
	}

	BoundingBox box;
	BoxFrame cube;
};

// Calls visit(box) with the box of a face, unless it lies beyond one side of the common box.
template <class Visit>
void visitBox(const FramePoint& p, const FramePoint& q, const FramePoint& r, std::size_t face,
              Visit&& visit) {
	if ((p.beyond & q.beyond & r.beyond) != 0) {
		return;
	}
	FaceBox box{};
	for (std::size_t axis = 0; axis < 3; ++axis) {
		box.lo[axis] = std::min(std::min(p.x[axis], q.x[axis]), r.x[axis]);
		box.hi[axis] = std::max(std::max(p.x[axis], q.x[axis]), r.x[axis]);
	}
	box.face = static_cast<std::uint32_t>(face);
	visit(box);
}

// The cells that one operand's boxes reach, of 64 along each axis of the cube, a bit each. Threads
// mark at the same time.
class CellGrid {
public:
	explicit CellGrid(float halfSize) : rows_(kSide * kSide), middle_((kSide - 1) / 2.0F) {
		cellsPerUnit_ = middle_ / halfSize;
		for (auto& row : rows_) {
			row.store(0, std::memory_order_relaxed);
		}
	}

	void mark(const FaceBox& box) {
		anyRow(box, [](std::atomic<std::uint64_t>& row, std::uint64_t cells) {
			if ((row.load(std::memory_order_relaxed) & cells) != cells) {
				row.fetch_or(cells, std::memory_order_relaxed);
			}
			return false;
		});
	}

	bool meets(const FaceBox& box) {
		return anyRow(box, [](std::atomic<std::uint64_t>& row, std::uint64_t cells) {
			return (row.load(std::memory_order_relaxed) & cells) != 0;
		});
	}

private:
	static constexpr int kSide = 64;

	// From 0 to kSide - 1. Never swaps two coordinates: boxes that meet share a cell.
	int cellAt(float x) const { return static_cast<int>(x * cellsPerUnit_ + middle_); }

	std::atomic<std::uint64_t>& rowAt(int y, int z) {
		return rows_[static_cast<std::size_t>(z * kSide + y)];
	}

	// Calls visit(row, cells) for the rows that a box reaches until one call answers true. Most
	// boxes reach one or two rows along y and z: four calls, some for one row again, cost less than
	// loops whose length no processor can guess.
	template <class Visit>
	bool anyRow(const FaceBox& box, Visit visit) {
		constexpr std::uint64_t kRow = ~std::uint64_t{0};
		const std::uint64_t cells =
		    kRow << cellAt(box.lo[0]) & kRow >> (kSide - 1 - cellAt(box.hi[0]));
		const int firstY = cellAt(box.lo[1]);
		const int lastY = cellAt(box.hi[1]);
		const int firstZ = cellAt(box.lo[2]);
		const int lastZ = cellAt(box.hi[2]);
		bool any = visit(rowAt(firstY, firstZ), cells);
		any |= visit(rowAt(lastY, firstZ), cells);
		any |= visit(rowAt(firstY, lastZ), cells);
		any |= visit(rowAt(lastY, lastZ), cells);
		if (lastY - firstY <= 1 && lastZ - firstZ <= 1) {
			return any;
		}
		for (int z = firstZ; z <= lastZ; ++z) {
			for (int y = firstY; y <= lastY && !any; ++y) {
				any = visit(rowAt(y, z), cells);
			}
		}
		return any;
	}

	std::vector<std::atomic<std::uint64_t>> rows_;
	float middle_;
	float cellsPerUnit_;
};

// All faces of both operands but for quiet ones, from vertices that are mapped once.
class AllFaces {
public:
	AllFaces(const MeshArrays& mesh, const CommonFrame& frame, int threads, Monitor& monitor)
	    : mesh_(mesh), frame_(frame), threads_(threads), monitor_(monitor) {}

	Status mapVertices() {
		points_.resizeForOverwrite(mesh_.points.size());
		return parallelFor(mesh_.points.size(), kGrain, threads_, monitor_,
		                   [&](std::size_t begin, std::size_t end) {
			                   for (std::size_t i = begin; i < end; ++i) {
				                   points_[i] = frame_.map(mesh_.points[i]);
			                   }
		                   });
	}

	// Calls visit(chunk, box) for the boxes of an operand's faces that reach the common box.
	template <class Visit>
	Status forEachBox(OperandId operand, Visit visit) const {
		const std::size_t first = mesh_.faceOffsets.begin(operand);
		return parallelForChunks(
		    count(operand), kGrain, threads_, monitor_,
		    [&](std::size_t chunk, std::size_t begin, std::size_t end) {
			    for (std::size_t f = first + begin; f < first + end; ++f) {
				    if (mesh_.quietTwin(makeId<FaceTag>(f)) == Twin::None) {
					    const Triangle& t = mesh_.triangles[f];
					    visitBox(points_[t[0].value], points_[t[1].value], points_[t[2].value], f,
					             [&](const FaceBox& box) { visit(chunk, box); });
				    }
			    }
		    });
	}

	std::size_t count(OperandId operand) const { return mesh_.faceOffsets.size(operand); }

private:
	const MeshArrays& mesh_;
	const CommonFrame& frame_;
	int threads_;
	Monitor& monitor_;
	HugeVector<FramePoint> points_;
};

// The faces that have been listed in another frame. They may be few: no vertex else is looked at.
class ListedFaces {
public:
	using Lists = PerOperand<HugeVector<FaceBox>>;

	ListedFaces(const MeshArrays& mesh, Lists listed, int threads, Monitor& monitor)
	    : mesh_(mesh), listed_(std::move(listed)), threads_(threads), monitor_(monitor) {}

	// Finds the box that both operands' listed faces have in common.
	Status findCommonBox(BoundingBox& out) const {
		PerOperand<BoundingBox> boxes;
		const Status status = forEachOperand(boxes.operands(), [&](OperandId k) {
			return findBoxOfFaces(
			    mesh_, count(k), [&](std::size_t i) { return listed_[k][i].face; }, threads_,
			    monitor_, boxes[k]);
		});
		out = commonBox(boxes[kFirst], boxes[kSecond]);
		return status;
	}

	// The lists, in a frame in which they are to be looked at or taken back.
	void setFrame(const CommonFrame& frame) { frame_ = &frame; }
	Lists release() { return std::move(listed_); }

	// Calls visit(chunk, box) for the boxes of an operand's faces that reach the common box.
	template <class Visit>
	Status forEachBox(OperandId operand, Visit visit) const {
		const auto corner = [&](VertexId v) { return frame_->map(at(mesh_.points, v)); };
		return parallelForChunks(count(operand), kGrain, threads_, monitor_,
		                         [&](std::size_t chunk, std::size_t begin, std::size_t end) {
			                         for (std::size_t i = begin; i < end; ++i) {
				                         const std::uint32_t face = listed_[operand][i].face;
				                         const Triangle& t = mesh_.triangles[face];
				                         visitBox(corner(t[0]), corner(t[1]), corner(t[2]), face,
				                                  [&](const FaceBox& box) { visit(chunk, box); });
			                         }
		                         });
	}

	std::size_t count(OperandId operand) const { return listed_[operand].size(); }

private:
	const MeshArrays& mesh_;
	Lists listed_;
	const CommonFrame* frame_ = nullptr;
	int threads_;
	Monitor& monitor_;
};

// Lists the boxes for which keep(box) answers true.
template <class Faces, class Keep>
Status collectBoxes(const Faces& faces, OperandId operand, Keep keep, HugeVector<FaceBox>& out) {
	std::vector<HugeVector<FaceBox>> parts(chunkCount(faces.count(operand), kGrain));
	const Status status = faces.forEachBox(operand, [&](std::size_t chunk, const FaceBox& box) {
		if (keep(box)) {
			parts[chunk].push_back(box);
		}
	});
	std::size_t count = 0;
	for (const HugeVector<FaceBox>& part : parts) {
		count += part.size();
	}
	out.reserve(count);
	for (const HugeVector<FaceBox>& part : parts) {
		out.insert(out.end(), part.begin(), part.end());
	}
	return status;
}

// The larger operand's faces are looked at once, the smaller one's twice: to mark its cells, and
// against the cells of the larger one's faces that are left.
template <class Faces>
Status collectNearBoxes(const Faces& faces, FaceBoxes& out) {
	constexpr std::size_t kFew = 2048;  // faces, below which clearing the grids costs more
	if (faces.count(kFirst) + faces.count(kSecond) < kFew) {
		const auto keepAll = [](const FaceBox&) { return true; };
		return forEachOperand(out.operand.operands(), [&](OperandId operand) {
			return collectBoxes(faces, operand, keepAll, out.operand[operand]);
		});
	}
	const OperandId small = faces.count(kFirst) <= faces.count(kSecond) ? kFirst : kSecond;
	const OperandId large = otherOf(small);
	CellGrid ofSmall(out.frame.halfSize);
	CellGrid ofLarge(out.frame.halfSize);
	const auto markSmall = [&](std::size_t, const FaceBox& box) { ofSmall.mark(box); };
	const auto markIfNear = [&](const FaceBox& box) {
		const bool near = ofSmall.meets(box);
		if (near) {
			ofLarge.mark(box);
		}
		return near;
	};
	const auto isNear = [&](const FaceBox& box) { return ofLarge.meets(box); };
	return inOrder([&] { return faces.forEachBox(small, markSmall); },
	               [&] { return collectBoxes(faces, large, markIfNear, out.operand[large]); },
	               [&] { return collectBoxes(faces, small, isNear, out.operand[small]); });
}

// Whether what both operands' boxes have in common takes so little of the cube that four of the
// octree's levels, and of the grid's, tell nothing apart.
bool isHuddled(const FaceBoxes& boxes) {
	std::array<float, 3> lo, hi;
	lo.fill(-boxes.frame.halfSize);
	hi.fill(boxes.frame.halfSize);
	for (const HugeVector<FaceBox>& operand : boxes.operand) {
		std::array<float, 3> low, high;
		low.fill(boxes.frame.halfSize);
		high.fill(-boxes.frame.halfSize);
		for (const FaceBox& box : operand) {
			for (std::size_t axis = 0; axis < 3; ++axis) {
				low[axis] = std::min(low[axis], box.lo[axis]);
				high[axis] = std::max(high[axis], box.hi[axis]);
			}
		}
		for (std::size_t axis = 0; axis < 3; ++axis) {
			lo[axis] = std::max(lo[axis], low[axis]);
			hi[axis] = std::min(hi[axis], high[axis]);
		}
	}
	const float longest = std::max({hi[0] - lo[0], hi[1] - lo[1], hi[2] - lo[2]});
	return longest < boxes.frame.halfSize / 8;
}

// Lists the faces in a frame of their own while that is worth it: each time the frame has shrunk
// at least to a half, so that this ends.
// \param common the common box of the frame in which faces have been listed
Status narrow(const MeshArrays& mesh, BoundingBox common, int threads, Monitor& monitor,
              FaceBoxes& boxes) {
	while (!boxes.operand[kFirst].empty() && !boxes.operand[kSecond].empty() && isHuddled(boxes)) {
		ListedFaces faces(mesh, std::move(boxes.operand), threads, monitor);
		BoundingBox smaller;
		Status status = faces.findCommonBox(smaller);
		smaller = commonBox(smaller, common);
		boxes.operand = {};
		if (!status.ok() || smaller.empty()) {
			return status;
		}
		if (!(smaller.halfSize() < common.halfSize() / 2)) {
			boxes.operand = faces.release();
			return status;
		}
		common = smaller;
		const CommonFrame frame(common);
		faces.setFrame(frame);
		boxes.frame = frame.cube;
		status = collectNearBoxes(faces, boxes);
		if (!status.ok()) {
			return status;
		}
	}
	return {};
}

}  // namespace

Status collectFaceBoxes(const MeshArrays& mesh, int threads, Monitor& monitor, FaceBoxes& out) {
	out = {};
	PerOperand<BoundingBox> boxes;
	Status status = forEachOperand(boxes.operands(), [&](OperandId k) {
		return findBoundingBox(mesh.points.data() + mesh.vertexOffsets.begin(k),
		                       mesh.vertexOffsets.size(k), threads, monitor, boxes[k]);
	});
	const BoundingBox common = commonBox(boxes[kFirst], boxes[kSecond]);
	if (!status.ok() || common.empty()) {
		return status;
	}
	const CommonFrame frame(common);
	out.frame = frame.cube;
	AllFaces faces(mesh, frame, threads, monitor);
	return inOrder([&] { return faces.mapVertices(); },
	               [&] { return collectNearBoxes(faces, out); },
	               [&] { return narrow(mesh, common, threads, monitor, out); });
}

}  // namespace index_boolean
