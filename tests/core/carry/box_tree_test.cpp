// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A tree of boxes finds what looking at each box finds.
#include <vcg_ext/carry/box_tree.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace index_boolean {
namespace {

bool contains(const BoundingBox& box, const Point& p) {
	bool inside = true;
	for (std::size_t axis = 0; axis < 3; ++axis) {
		inside = inside && box.lo[axis] <= p[axis] && p[axis] <= box.hi[axis];
	}
	return inside;
}

// On a grid of points, so that borders are met; a third of them without end in one direction.
std::vector<BoundingBox> randomBoxes(std::mt19937& random, std::size_t count, double scale) {
	std::vector<BoundingBox> boxes(count);
	for (BoundingBox& box : boxes) {
		for (std::size_t axis = 0; axis < 3; ++axis) {
			box.lo[axis] = scale * (static_cast<double>(random() % 20) - 10);
			box.hi[axis] = box.lo[axis] + scale * static_cast<double>(random() % 4);
		}
		if (random() % 3 == 0) {
			const std::size_t axis = random() % 3;
			box.lo[axis] = -HUGE_VAL;
			box.hi[axis] = HUGE_VAL;
		}
	}
	return boxes;
}

TEST(BoxTree, findsWhatLookingAtEachBoxFinds) {
	std::mt19937 random(1);
	for (const std::size_t count : {0, 1, 7, 8, 9, 64, 65, 1000}) {
		for (const double scale : {1.0, 0x1p-1074, 0x1p1019}) {
			const std::vector<BoundingBox> boxes = randomBoxes(random, count, scale);
			const BoxTree tree(boxes);
			for (int i = 0; i < 200; ++i) {
				Point p;
				for (double& x : p) {
					x = scale * (static_cast<double>(random() % 26) - 12);
				}
				std::vector<std::uint32_t> found, expected;
				tree.find(p, found);
				std::sort(found.begin(), found.end());
				for (std::uint32_t box = 0; box < boxes.size(); ++box) {
					if (contains(boxes[box], p)) {
						expected.push_back(box);
					}
				}
				EXPECT_EQ(found, expected);
			}
		}
	}
}

}  // namespace
}  // namespace index_boolean
