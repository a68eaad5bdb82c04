// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: a pyramid; out: pairs, judged. Two blocks of eight leaves go through four flat loops: pairs
// of leaves; rows, which are a face of one leaf and all of another; rows with boxes that meet; the
// faces of a row without a certified corner in common. Lists are appended to without a branch,
// whatever is found, since no processor can guess what comes: nearly all pairs are neighbours, of
// which the last loop leaves nearly none.
#include "vcg_ext/arrange/pyramid_descent.h"

#include "vcg_ext/base/parallel.h"

#include <cstring>

namespace index_boolean {

namespace {

constexpr std::size_t kEnoughTasks = 2048;
constexpr std::size_t kTasksAtATime = 4;
constexpr std::size_t kPollBlocks = 256;  // pairs of blocks between two looks at the monitor

// The lanes of each set, in order, and how many there are.
struct LaneTable {
	std::array<std::array<std::uint8_t, 8>, 256> lanes{};
	std::array<std::uint8_t, 256> count{};

	constexpr LaneTable() {
		for (unsigned set = 0; set < 256; ++set) {
			for (unsigned lane = 0; lane < 8; ++lane) {
				if ((set >> lane & 1U) != 0) {
					lanes[set][count[set]++] = static_cast<std::uint8_t>(lane);
				}
			}
		}
	}
};
constexpr LaneTable kLaneTable;

constexpr Lanes kAllLanes = 255;

// The lanes from one on, or behind it: of an item against itself, each pair once.
constexpr Lanes lanesFrom(std::size_t lane) { return kAllLanes << lane & kAllLanes; }
constexpr Lanes lanesBehind(std::size_t lane) { return lanesFrom(lane + 1); }

// Two items of a level, the first one not behind the second.
struct ItemPair {
	std::uint32_t a, b;
};

// Calls visit(pair) for the pairs of children of two items that meet.
template <class Visit>
void forEachChildPair(const HugeVector<EightBoxes>& level, ItemPair items, Visit&& visit) {
	const EightBoxes &a = level[items.a], &b = level[items.b];
	for (std::uint32_t k = 0; k < 8; ++k) {
		const Lanes lanes =
		    lanesThatMeet(b, a, k) & (items.a == items.b ? lanesFrom(k) : kAllLanes);
		for (std::uint32_t i = 0; i < kLaneTable.count[lanes]; ++i) {
			visit(ItemPair{8 * items.a + k, 8 * items.b + kLaneTable.lanes[lanes][i]});
		}
	}
}

// A list of pairs of a number and a lane, with room for as many as two blocks give.
template <class Number, std::size_t kMost>
struct LaneList {
	std::array<Number, kMost + 8> number;
	std::array<std::uint8_t, kMost + 8> lane;
	std::size_t size = 0;

	// Adds (n, lane) for all lanes of a set.
	void add(std::size_t n, Lanes lanes) {
		std::memcpy(&lane[size], kLaneTable.lanes[lanes].data(), 8);
		for (std::size_t i = 0; i < 8; ++i) {
			number[size + i] = static_cast<Number>(n);
		}
		size += kLaneTable.count[lanes];
	}
};

// The faces of a leaf that have a certified corner in common with one face of a leaf.
Lanes lanesWithCommonStar(const FaceLeaf& leaf, const FaceLeaf& other, std::size_t lane) {
	std::array<std::uint32_t, 3> star{};
	for (std::size_t corner = 0; corner < 3; ++corner) {
		const std::uint32_t s = other.stars[corner][lane];
		star[corner] = s - (s == kNone ? 1U : 0U);  // a number that no star has
	}
	const std::uint32_t x = star[0], y = star[1], z = star[2];
	std::array<std::uint32_t, 8> masks;
	for (unsigned i = 0; i < 8; ++i) {
		const std::uint32_t p = leaf.stars[0][i], q = leaf.stars[1][i], r = leaf.stars[2][i];
		masks[i] = maskOf(p == x) | maskOf(p == y) | maskOf(p == z) | maskOf(q == x) |
		           maskOf(q == y) | maskOf(q == z) | maskOf(r == x) | maskOf(r == y) |
		           maskOf(r == z);
	}
	return lanesOf(masks);
}

// The descent below pairs of items. One object per thread's chunk.
class Descent {
public:
	Descent(const SearchedSurface& surface, const BoxPyramid& pyramid, Monitor& monitor,
	        PairJudge& judge)
	    : surface_(surface), pyramid_(pyramid), monitor_(monitor), judge_(judge) {}

	// \param level of the two items
	void visit(std::size_t level, ItemPair items) {
		if (monitor_.cancelled()) {
			return;
		}
		if (level == 0) {
			visitBlocks(items);
		} else {
			forEachChildPair(pyramid_.levels[level], items,
			                 [&](ItemPair below) { visit(level - 1, below); });
		}
	}

private:
	struct Row {
		std::uint16_t row;
		std::uint8_t lanes;
	};

	void visitBlocks(ItemPair blocks);
	void findLeafPairs(ItemPair blocks);
	void findRows(ItemPair blocks);
	std::size_t findHits(ItemPair blocks);
	void judgeRow(const FaceLeaf& a, std::size_t lane, const FaceLeaf& b, Lanes lanes);

	const FaceLeaf& leafOfA(ItemPair blocks, std::size_t pair) const {
		return pyramid_.leaves[8 * std::size_t{blocks.a} + leafPairs_.number[pair]];
	}
	const FaceLeaf& leafOfB(ItemPair blocks, std::size_t pair) const {
		return pyramid_.leaves[8 * std::size_t{blocks.b} + leafPairs_.lane[pair]];
	}

	const SearchedSurface& surface_;
	const BoxPyramid& pyramid_;
	Monitor& monitor_;
	PairJudge& judge_;
	std::size_t blocksSeen_ = 0;
	LaneList<std::uint8_t, 64> leafPairs_;  // a leaf of a, a leaf of b
	LaneList<std::uint16_t, 512> rows_;     // a pair of leaves, a face of the first one
	std::array<Row, 512> hits_;             // rows, and which faces of the second leaf
};

void Descent::findLeafPairs(ItemPair blocks) {
	const EightBoxes& a = pyramid_.levels[0][blocks.a];
	const EightBoxes& b = pyramid_.levels[0][blocks.b];
	leafPairs_.size = 0;
	for (std::size_t k = 0; k < 8; ++k) {
		const Lanes wanted = blocks.a == blocks.b ? lanesFrom(k) : kAllLanes;
		leafPairs_.add(k, lanesThatMeet(b, a, k) & wanted);
	}
}

void Descent::findRows(ItemPair blocks) {
	const EightBoxes& b = pyramid_.levels[0][blocks.b];
	rows_.size = 0;
	for (std::size_t pair = 0; pair < leafPairs_.size; ++pair) {
		rows_.add(pair, lanesThatMeet(leafOfA(blocks, pair).boxes, b, leafPairs_.lane[pair]));
	}
}

// \return how many rows have hits
std::size_t Descent::findHits(ItemPair blocks) {
	std::size_t count = 0;
	for (std::size_t row = 0; row < rows_.size; ++row) {
		const FaceLeaf& a = leafOfA(blocks, rows_.number[row]);
		const FaceLeaf& b = leafOfB(blocks, rows_.number[row]);
		const Lanes wanted = &a == &b ? lanesBehind(rows_.lane[row]) : kAllLanes;
		const Lanes lanes = lanesThatMeet(b.boxes, a.boxes, rows_.lane[row]) & wanted;
		hits_[count] = {static_cast<std::uint16_t>(row), static_cast<std::uint8_t>(lanes)};
		count += lanes != 0 ? 1 : 0;
	}
	return count;
}

void Descent::visitBlocks(ItemPair blocks) {
	if (++blocksSeen_ % kPollBlocks == 0 && pollCancelled(monitor_)) {
		return;
	}
	findLeafPairs(blocks);
	findRows(blocks);
	const std::size_t count = findHits(blocks);
	for (std::size_t hit = 0; hit < count; ++hit) {
		const std::size_t row = hits_[hit].row, lane = rows_.lane[row];
		const FaceLeaf& a = leafOfA(blocks, rows_.number[row]);
		const FaceLeaf& b = leafOfB(blocks, rows_.number[row]);
		const Lanes left = hits_[hit].lanes & ~lanesWithCommonStar(b, a, lane);
		if (left != 0) {
			judgeRow(a, lane, b, left);
		}
	}
}

void Descent::judgeRow(const FaceLeaf& a, std::size_t lane, const FaceLeaf& b, Lanes lanes) {
	const std::uint32_t f = a.faces[lane];
	const bool isSuspect = surface_.suspects(f);
	for (std::size_t i = 0; i < kLaneTable.count[lanes]; ++i) {
		const std::uint32_t g = b.faces[kLaneTable.lanes[lanes][i]];
		if (isSuspect || surface_.suspects(g)) {
			judge_.judge(f, g);
		}
	}
}

}  // namespace

Status descendPyramid(const SearchedSurface& surface, const BoxPyramid& pyramid, Monitor& monitor,
                      PairJudge& judge) {
	std::size_t level = pyramid.levels.size() - 1;
	std::vector<ItemPair> tasks{{0, 0}}, below;
	for (; level > 0 && tasks.size() < kEnoughTasks; --level) {
		below.clear();
		for (const ItemPair& task : tasks) {
			forEachChildPair(pyramid.levels[level], task,
			                 [&](ItemPair pair) { below.push_back(pair); });
		}
		tasks.swap(below);
	}
	return parallelFor(tasks.size(), kTasksAtATime, surface.threads, monitor,
	                   [&](std::size_t begin, std::size_t end) {
		                   Descent descent(surface, pyramid, monitor, judge);
		                   for (std::size_t i = begin; i < end; ++i) {
			                   descent.visit(level, tasks[i]);
		                   }
	                   });
}

}  // namespace index_boolean
