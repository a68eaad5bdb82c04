// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: both operands' triangles; out: boxes near both. First goes what lies beyond the common box,
// then what shares no cell of a grid with the other operand. The cells are as small as nodes six
// levels down the octree, where the paper's rule for dead nodes leaves little.
#include "vcg_ext/arrange/face_boxes.h"

#include "vcg_ext/base/huge_vector.h"
#include "vcg_ext/base/parallel.h"
#include "vcg_ext/exact/bounding_box.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace index_boolean {

namespace {

constexpr std::size_t kGrain = 8192;

// A vertex in the frame. `beyond` holds, as bits, the sides of the common box that it lies beyond:
// a face with all corners beyond one of them meets no face of the other operand.
struct FramePoint {
	std::array<float, 3> x;
	std::uint32_t beyond;
};

// The common box and the map of its coordinates to a cube about the origin, about of size 1.
struct Frame {
	BoundingBox box;
	Point centre;
	double scale;
	float halfSize;

	FramePoint map(const Point& point) const {
		FramePoint result{};
		for (unsigned axis = 0; axis < 3; ++axis) {
			const double lo = box.lo[axis];
			const double hi = box.hi[axis];
			const double inside = std::min(std::max(point[axis], lo), hi);
			const auto x = static_cast<float>((inside - centre[axis]) * scale);
			result.x[axis] = std::min(std::max(x, -halfSize), halfSize);
			result.beyond |= (point[axis] < lo ? 1U : 0U) << (2 * axis);
			result.beyond |= (point[axis] > hi ? 2U : 0U) << (2 * axis);
		}
		return result;
	}
};

Frame makeFrame(const BoundingBox& common) {
	Frame frame{};
	frame.box = common;
	frame.centre = common.centre();
	int exponent = 0;
	std::frexp(common.halfSize(), &exponent);
	const int scaleExponent = std::min(-exponent, 1000);  // a larger power is no double
	frame.scale = std::ldexp(1.0, scaleExponent);
	frame.halfSize = static_cast<float>(std::ldexp(1.0, exponent + scaleExponent));
	return frame;
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

// Both operands in the frame.
class FrameMesh {
public:
	FrameMesh(const MeshArrays& mesh, const Frame& frame, int threads, Monitor& monitor)
	    : mesh_(mesh), frame_(frame), threads_(threads), monitor_(monitor) {}

	Status mapVertices() {
		points_.resize(mesh_.points.size());
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
		return parallelForChunks(faceCount(operand), kGrain, threads_, monitor_,
		                         [&](std::size_t chunk, std::size_t begin, std::size_t end) {
			                         for (std::size_t f = first + begin; f < first + end; ++f) {
				                         visitBox(f,
				                                  [&](const FaceBox& box) { visit(chunk, box); });
			                         }
		                         });
	}

	// Lists the boxes for which keep(box) answers true.
	template <class Keep>
	Status collectBoxes(OperandId operand, Keep keep, HugeVector<FaceBox>& out) const {
		std::vector<HugeVector<FaceBox>> parts(chunkCount(faceCount(operand), kGrain));
		const Status status = forEachBox(operand, [&](std::size_t chunk, const FaceBox& box) {
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

	std::size_t faceCount(OperandId operand) const { return mesh_.faceOffsets.size(operand); }

private:
	template <class Visit>
	void visitBox(std::size_t face, Visit visit) const {
		if (mesh_.quietTwin(makeId<FaceTag>(face)) != Twin::None) {
			return;
		}
		const FramePoint& p = points_[mesh_.triangles[face][0].value];
		const FramePoint& q = points_[mesh_.triangles[face][1].value];
		const FramePoint& r = points_[mesh_.triangles[face][2].value];
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

	const MeshArrays& mesh_;
	Frame frame_;
	int threads_;
	Monitor& monitor_;
	HugeVector<FramePoint> points_;
};

// The larger operand's faces are looked at once, the smaller one's twice: to mark its cells, and
// against the cells of the larger one's faces that are left.
Status collectNearBoxes(const FrameMesh& faces, FaceBoxes& out) {
	constexpr std::size_t kFew = 2048;  // faces, below which clearing the grids costs more
	if (faces.faceCount(kFirst) + faces.faceCount(kSecond) < kFew) {
		const auto keepAll = [](const FaceBox&) { return true; };
		const Status status = faces.collectBoxes(kFirst, keepAll, out.operand[kFirst]);
		return status.ok() ? faces.collectBoxes(kSecond, keepAll, out.operand[kSecond]) : status;
	}
	const OperandId small = faces.faceCount(kFirst) <= faces.faceCount(kSecond) ? kFirst : kSecond;
	const OperandId large = otherOf(small);
	CellGrid ofSmall(out.halfSize);
	CellGrid ofLarge(out.halfSize);
	Status status =
	    faces.forEachBox(small, [&](std::size_t, const FaceBox& box) { ofSmall.mark(box); });
	if (!status.ok()) {
		return status;
	}
	const auto markIfNear = [&](const FaceBox& box) {
		const bool near = ofSmall.meets(box);
		if (near) {
			ofLarge.mark(box);
		}
		return near;
	};
	status = faces.collectBoxes(large, markIfNear, out.operand[large]);
	if (!status.ok()) {
		return status;
	}
	const auto isNear = [&](const FaceBox& box) { return ofLarge.meets(box); };
	return faces.collectBoxes(small, isNear, out.operand[small]);
}

}  // namespace

Status collectFaceBoxes(const MeshArrays& mesh, int threads, Monitor& monitor, FaceBoxes& out) {
	out = {};
	Status status;
	PerOperand<BoundingBox> boxes;
	for (const OperandId k : boxes.operands()) {
		status = findBoundingBox(mesh.points.data() + mesh.vertexOffsets.begin(k),
		                         mesh.vertexOffsets.size(k), threads, monitor, boxes[k]);
		if (!status.ok()) {
			return status;
		}
	}
	const BoundingBox common = commonBox(boxes[kFirst], boxes[kSecond]);
	if (common.empty()) {
		return status;
	}
	const Frame frame = makeFrame(common);
	FrameMesh faces(mesh, frame, threads, monitor);
	out.halfSize = frame.halfSize;
	status = faces.mapVertices();
	return status.ok() ? collectNearBoxes(faces, out) : status;
}

}  // namespace index_boolean
