// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// in: faces in order; out: the pyramid of their boxes. Each thread makes eight leaves and the
// boxes that they have a level above.
#include "vcg_ext/arrange/box_pyramid.h"

#include "vcg_ext/base/parallel.h"

#include <algorithm>
#include <limits>

namespace index_boolean {

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr std::size_t kGrain = 512;  // items of a level

void makeEmpty(EightBoxes& boxes, std::size_t lane) {
	for (std::size_t axis = 0; axis < 3; ++axis) {
		boxes.lo[axis][lane] = kInfinity;
		boxes.hi[axis][lane] = -kInfinity;
	}
}

// Makes the box around eight boxes a lane of others.
void joinBoxes(const EightBoxes& boxes, EightBoxes& out, std::size_t lane) {
	for (std::size_t axis = 0; axis < 3; ++axis) {
		float lo = kInfinity, hi = -kInfinity;
		for (std::size_t i = 0; i < 8; ++i) {
			lo = boxes.lo[axis][i] < lo ? boxes.lo[axis][i] : lo;
			hi = boxes.hi[axis][i] > hi ? boxes.hi[axis][i] : hi;
		}
		out.lo[axis][lane] = lo;
		out.hi[axis][lane] = hi;
	}
}

// Numbers below 1 are 2^-24 apart at most, so that a margin of 2^-23 widens by more than 2^-24.
void setBoxes(const EightFaces& eight, float margin, EightBoxes& out) {
	for (std::size_t axis = 0; axis < 3; ++axis) {
		for (std::size_t lane = 0; lane < 8; ++lane) {
			const float a = eight.place[0][axis][lane], b = eight.place[1][axis][lane],
			            c = eight.place[2][axis][lane];
			const float lo = a < b ? a : b, hi = a < b ? b : a;
			out.lo[axis][lane] = (c < lo ? c : lo) - margin;
			out.hi[axis][lane] = (c > hi ? c : hi) + margin;
		}
	}
}

// What leaves are made of.
struct LeafSource {
	const SearchedSurface& surface;
	const FaceOrder& order;

	void make(std::size_t leaf, FaceLeaf& out) const {
		const FacesView& faces = surface.faces;
		const std::size_t first = 8 * leaf;
		const std::size_t count = std::min<std::size_t>(8, faces.count() - first);
		EightFaces eight;
		gatherEight(
		    faces, surface.points, count,
		    [&](std::size_t lane) { return order.face(first + lane); }, eight);
		setBoxes(eight, surface.boxMargin, out.boxes);
		out.stars = eight.star;
		for (std::size_t lane = 0; lane < 8; ++lane) {
			const bool isFace = lane < count;
			out.faces[lane] = isFace ? order.face(first + lane) : kNone;
			if (!isFace || surface.hasNoArea(out.faces[lane])) {
				makeEmpty(out.boxes, lane);
			}
		}
	}
};

// Makes an item of a level from what is below: makeBelow(k) gives the boxes of its child k.
template <class BoxesBelow>
void makeItem(std::size_t item, std::size_t countBelow, BoxesBelow&& below, EightBoxes& out) {
	for (std::size_t lane = 0; lane < 8; ++lane) {
		const std::size_t child = 8 * item + lane;
		if (child < countBelow) {
			joinBoxes(below(child), out, lane);
		} else {
			makeEmpty(out, lane);
		}
	}
}

}  // namespace

Status buildPyramid(const SearchedSurface& surface, const FaceOrder& order, Monitor& monitor,
                    BoxPyramid& out) {
	const LeafSource source{surface, order};
	out.leaves.resizeForOverwrite(chunkCount(surface.faces.count(), 8));
	out.levels.clear();
	const auto makeLeaf = [&](std::size_t leaf) -> const EightBoxes& {
		source.make(leaf, out.leaves[leaf]);
		return out.leaves[leaf].boxes;
	};
	Status status;
	std::size_t below = out.leaves.size();
	do {
		auto level = HugeVector<EightBoxes>::forOverwrite(chunkCount(below, 8));
		status = parallelFor(
		    level.size(), kGrain, surface.threads, monitor,
		    [&](std::size_t begin, std::size_t end) {
			    for (std::size_t i = begin; i < end; ++i) {
				    if (out.levels.empty()) {
					    makeItem(i, below, makeLeaf, level[i]);
				    } else {
					    const auto& boxes = out.levels.back();
					    makeItem(
					        i, below, [&](std::size_t k) -> const EightBoxes& { return boxes[k]; },
					        level[i]);
				    }
			    }
		    });
		below = level.size();
		out.levels.push_back(std::move(level));
	} while (below > 1 && status.ok());
	return status;
}

}  // namespace index_boolean
