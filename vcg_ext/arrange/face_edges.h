// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: the lines and the ranked points of one face; out: the edges of its planar problem, each once,
// and what each of them is. Guarantee: by index alone.
#pragma once

#include "vcg_ext/arrange/face_points.h"

#include <algorithm>
#include <array>
#include <vector>

namespace index_boolean {

// An edge of the planar problem. Fixed are those that part regions or bound the face: a segment of
// the curve, an interval of the face's border, or both.
struct FaceEdge {
	PlanarEdge ranks;
	bool isFixed = false, isBorder = false;
	bool isRising = false;  // the segment runs from the lower to the higher rank
	SegmentId segment = SegmentId::none();
	NodeId interval = NodeId::none();  // of a border edge with both ends on the other operand
	// The pieces to the right and to the left of the way from the lower to the higher rank; entered
	// once the face is triangulated.
	std::array<std::uint32_t, 2> pieces{kNone, kNone};

	std::size_t pieceCount() const {
		return (pieces[0] != kNone ? 1U : 0U) + (pieces[1] != kNone ? 1U : 0U);
	}
};

// The edges of one face after another, in the order in which they were named, in memory that is
// used again.
class FaceEdges {
public:
	// Replaces the edges by those that are fixed: the face's segments, then what else its border
	// consists of. \param most how many edges there may be in all, with those named later
	// \return false if two segments have the same ends, or if there are too many.
	// Throws std::bad_alloc. O(most).
	bool fix(const Arrangement& arrangement, const FaceLines& lines, const FacePoints& points,
	         std::size_t most);

	// The edge between two points given by rank, which is new if it has not been named yet; or null
	// if there is no room for one more. Valid until the edges are replaced. O(1).
	FaceEdge* named(std::uint32_t a, std::uint32_t b);

	ConstRange<FaceEdge> others() const {
		return {edges_.data() + fixedCount_, edges_.data() + edges_.size()};
	}
	ConstRange<FaceEdge> fixed() const { return {edges_.data(), edges_.data() + fixedCount_}; }
	const std::vector<FaceEdge>& all() const { return edges_; }

private:
	void reset(std::size_t most);
	// Of the edge with these ends, or the free one for it.
	std::size_t slotOf(PlanarEdge ranks) const;
	bool fixSegments(const Curve& curve, const FaceLines& lines, const FacePoints& points);
	bool fixSide(const Arrangement& arrangement, const FaceSide& side, const FacePoints& points);

	std::vector<FaceEdge> edges_;
	std::size_t fixedCount_ = 0;  // the first of them
	std::size_t most_ = 0;
	std::vector<std::uint32_t> slots_;  // open addressing: 1 + the place among the edges, or 0
	unsigned shift_ = 0;
};

inline std::size_t FaceEdges::slotOf(PlanarEdge ranks) const {
	constexpr std::uint64_t kMultiplier = 0x9e3779b97f4a7c15u;  // 2^64 / golden ratio
	const std::uint64_t key = std::uint64_t{ranks.left} << 32 | ranks.right;
	std::size_t slot = key * kMultiplier >> shift_;
	for (; slots_[slot] != 0; slot = (slot + 1) & (slots_.size() - 1)) {
		const PlanarEdge& found = edges_[slots_[slot] - 1].ranks;
		if (found.left == ranks.left && found.right == ranks.right) {
			break;
		}
	}
	return slot;
}

inline FaceEdge* FaceEdges::named(std::uint32_t a, std::uint32_t b) {
	const PlanarEdge ranks{std::min(a, b), std::max(a, b)};
	const std::size_t slot = slotOf(ranks);
	if (slots_[slot] != 0) {
		return &edges_[slots_[slot] - 1];
	}
	if (edges_.size() == most_) {
		return nullptr;
	}
	edges_.push_back({ranks});
	slots_[slot] = static_cast<std::uint32_t>(edges_.size());
	return &edges_.back();
}

}  // namespace index_boolean
