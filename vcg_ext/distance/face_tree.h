// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: faces with area; out: the one nearest to a point, and those that boxes cannot rule out for a
// question of the caller's. Guarantee: what is found depends on the faces' places only: not on how
// they are numbered, nor on threads. A node has four children, so that their boxes are looked at
// side by side; a leaf has up to four faces. Boxes are floats, rounded outwards.
// Source: Wald, Benthin, Boulos 2008 (wide trees); Wald 2007 (binned surface area heuristic).
#pragma once

#include "vcg_ext/base/mesh_types.h"
#include "vcg_ext/base/monitor.h"
#include "vcg_ext/base/status.h"
#include "vcg_ext/distance/face_block.h"
#include "vcg_ext/exact/bounding_box.h"

#include <limits>
#include <vector>

namespace index_boolean {

// Boxes of a node's children. A child is a node, a block of faces (kBlockBit), or none.
struct alignas(64) FaceTreeNode {
	std::array<std::array<float, kLanes>, 3> lo, hi;
	std::array<std::uint32_t, kLanes> child;
	static constexpr std::uint32_t kBlockBit = 0x80000000;
};

// The places of a tree are its surface's, times a power of two.
struct TreeFrame {
	double scale = 1;
	Point centre{};          // scaled; of the surface's box
	double halfSize = 0;     // of the scaled box's longest side
	double longestEdge = 0;  // scaled

	Point scaled(const Point& p) const { return {p[0] * scale, p[1] * scale, p[2] * scale}; }
};

// A face of a tree, and how far it is.
struct NearFace {
	double squared = std::numeric_limits<double>::infinity();
	std::uint32_t block = kNone, lane = 0;

	bool isFound() const { return block != kNone; }
};

class FaceTree {
public:
	// \param points    finite \param triangles with area; at least one, at most 2^31 - 1
	// \param threads   0: as many as there are
	// \return Ok, Cancelled, OutOfMemory. Throws std::bad_alloc.
	// Complexity: O(n log n), in parallel but for the first node. About 200 bytes a face.
	Status build(const Points& points, const IndexTriangles& triangles, int threads,
	             Monitor& monitor);

	const TreeFrame& frame() const { return frame_; }
	std::uint32_t faceOf(const NearFace& near) const { return blocks_[near.block].face[near.lane]; }
	NearestInFace nearestIn(const NearFace& near, const Point& scaled) const {
		return nearestInFace(blocks_[near.block], near.lane, scaled);
	}

	// The face nearest to a point, as doubles tell: of equally near ones the first by its places.
	// \param scaled in the tree's scale, with squares that are finite
	// \param begin  a face, which bounds the search, with its distance; or one that is not found,
	//               with the square of the distance beyond which none is looked for
	// \return `begin` if none is nearer
	// Complexity: O(log n) as expected for points near the surface; O(n) where many are as near.
	NearFace nearest(const Point& scaled, const NearFace& begin) const;

	// A face's squared distance, as `nearest` would find it. Complexity: O(1).
	NearFace distanceTo(const NearFace& face, const Point& scaled) const;

	// Calls visit(face) for each face, but for those whose box, or a box around it, is none that
	// may(lo, hi) calls possible: lo(axis) and hi(axis) are its bounds, about the frame's centre.
	template <class May, class Visit>
	void visit(May&& may, Visit&& visit) const;

private:
	bool isBefore(const NearFace& a, const NearFace& b) const;
	void lookAt(std::uint32_t block, const Point& scaled, NearFace& best) const;

	TreeFrame frame_;
	std::vector<FaceTreeNode> nodes_;
	HugeVector<FaceBlock> blocks_;
	double slack_ = 0;
};

template <class May, class Visit>
void FaceTree::visit(May&& may, Visit&& visit) const {
	std::array<std::uint32_t, 256> waiting;  // as deep as the builder lets the tree become
	std::size_t count = 0;
	waiting[count++] = 0;
	while (count > 0) {
		const FaceTreeNode& node = nodes_[waiting[--count]];
		for (std::size_t k = 0; k < kLanes; ++k) {
			const std::uint32_t child = node.child[k];
			const auto lo = [&](std::size_t axis) { return double{node.lo[axis][k]}; };
			const auto hi = [&](std::size_t axis) { return double{node.hi[axis][k]}; };
			if (child == kNone || !may(lo, hi)) {
				continue;
			}
			if ((child & FaceTreeNode::kBlockBit) == 0) {
				waiting[count++] = child;
				continue;
			}
			for (const std::uint32_t face : blocks_[child & ~FaceTreeNode::kBlockBit].face) {
				if (face != kNone) {
					visit(face);
				}
			}
		}
	}
}

}  // namespace index_boolean
