// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What may be nearer than the best is looked at, the nearest boxes first. A box is passed over only
// if it is farther than the best by more than all roundings together, so that the faces that decide
// are always looked at, whatever the tree's shape.
#include "vcg_ext/distance/face_tree.h"

#include "vcg_ext/distance/face_tree_builder.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

// One source for processors with two and with four doubles side by side: no product is fused into a
// sum (-ffp-contract=off), so the results are the same.
#if defined(__x86_64__) && defined(__linux__) && defined(__GNUC__) && !defined(__clang__) &&       \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define INDEXBOOLEAN_WIDE __attribute__((target_clones("avx2", "default")))
#else
#define INDEXBOOLEAN_WIDE
#endif

namespace index_boolean {

namespace {

// The error of a face's distance is below 2^-45 (d + l), that of a box's below 2^-48 (d + R); each
// has its double here.
constexpr double kRelativeSlack = 0x1p-44;

struct Waiting {
	double squared;
	std::uint32_t child;
};

// The square of the distance beyond which a box holds nothing that counts.
inline double limitOf(double squared, double slack) {
	const double distance = std::sqrt(squared);
	const double limit = distance + distance * kRelativeSlack + slack;
	return limit * limit * (1 + 0x1p-50);
}

[[gnu::always_inline]] inline void boxDistances(const FaceTreeNode& node, const Point& centred,
                                                FourNumbers& out) {
	for (std::size_t k = 0; k < kLanes; ++k) {
		double sum = 0;
		for (std::size_t axis = 0; axis < 3; ++axis) {
			const double below = double{node.lo[axis][k]} - centred[axis];
			const double above = centred[axis] - double{node.hi[axis][k]};
			const double outside = below > above ? below : above;
			const double gap = outside > 0 ? outside : 0;
			sum += gap * gap;
		}
		out[k] = sum;
	}
}

// Puts the children that may count on the stack, the nearest on top.
[[gnu::always_inline]] inline std::size_t push(const FaceTreeNode& node, const FourNumbers& squared,
                                               double limit, Waiting* stack, std::size_t count) {
	const std::size_t first = count;
	for (std::size_t k = 0; k < kLanes; ++k) {
		if (!(squared[k] <= limit)) {
			continue;
		}
		std::size_t at = count++;
		for (; at > first && stack[at - 1].squared < squared[k]; --at) {
			stack[at] = stack[at - 1];
		}
		stack[at] = {squared[k], node.child[k]};
	}
	return count;
}

}  // namespace

Status FaceTree::build(const Points& points, const IndexTriangles& triangles, int threads,
                       Monitor& monitor) {
	BuiltTree built;
	const Status status = buildFaceTree(points, triangles, threads, monitor, built);
	frame_ = built.frame;
	nodes_ = std::move(built.nodes);
	blocks_ = std::move(built.blocks);
	slack_ = kRelativeSlack * (frame_.longestEdge + 4 * frame_.halfSize);
	return status;
}

// Whether a face comes first of two that are equally near.
bool FaceTree::isBefore(const NearFace& a, const NearFace& b) const {
	const auto places = [this](const NearFace& near) {
		const FaceBlock& f = blocks_[near.block];
		const std::size_t k = near.lane;
		return std::make_tuple(f.origin[0][k], f.origin[1][k], f.origin[2][k], f.first[0][k],
		                       f.first[1][k], f.first[2][k], f.second[0][k], f.second[1][k],
		                       f.second[2][k], f.face[k]);
	};
	return places(a) < places(b);
}

[[gnu::always_inline]] inline void FaceTree::lookAt(std::uint32_t block, const Point& scaled,
                                                    NearFace& best) const {
	FourNumbers squared;
	squaredDistances(blocks_[block], scaled, squared);
	for (std::uint32_t lane = 0; lane < kLanes; ++lane) {
		if (!(squared[lane] <= best.squared) || blocks_[block].face[lane] == kNone) {
			continue;
		}
		const NearFace near{squared[lane], block, lane};
		if (near.squared < best.squared || !best.isFound() || isBefore(near, best)) {
			best = near;
		}
	}
}

INDEXBOOLEAN_WIDE
NearFace FaceTree::nearest(const Point& scaled, const NearFace& begin) const {
	const Point centred{scaled[0] - frame_.centre[0], scaled[1] - frame_.centre[1],
	                    scaled[2] - frame_.centre[2]};
	std::array<Waiting, kLanes * kDeepestTree> stack;
	stack[0] = {0, 0};
	std::size_t count = 1;
	NearFace best = begin;
	double limit = limitOf(best.squared, slack_);
	while (count > 0) {
		const Waiting next = stack[--count];
		if (next.squared > limit) {
			continue;
		}
		if ((next.child & FaceTreeNode::kBlockBit) != 0) {
			const double before = best.squared;
			lookAt(next.child & ~FaceTreeNode::kBlockBit, scaled, best);
			limit = best.squared < before ? limitOf(best.squared, slack_) : limit;
			continue;
		}
		FourNumbers squared;
		boxDistances(nodes_[next.child], centred, squared);
		count = push(nodes_[next.child], squared, limit, stack.data(), count);
	}
	return best;
}

NearFace FaceTree::distanceTo(const NearFace& face, const Point& scaled) const {
	FourNumbers squared;
	squaredDistances(blocks_[face.block], scaled, squared);
	return {squared[face.lane], face.block, face.lane};
}

}  // namespace index_boolean
