// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A tree finds what a look at every box finds, and looks at few.
#include <vcg_ext/exact/box_tree.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace index_boolean {
namespace {

bool overlap(const BoundingBox& a, const BoundingBox& b) { return !commonBox(a, b).empty(); }

BoundingBox randomBox(std::mt19937& random, std::uint32_t size) {
	BoundingBox box{};
	for (std::size_t k = 0; k < 3; ++k) {
		box.lo[k] = static_cast<double>(random() % 20);
		box.hi[k] = box.lo[k] + static_cast<double>(random() % size);
	}
	return box;
}

TEST(BoxTree, findsWhatALookAtEveryBoxFinds) {
	std::mt19937 random(1);
	for (std::size_t n = 0; n < 70; ++n) {
		std::vector<BoundingBox> boxes;
		for (std::size_t i = 0; i < n; ++i) {
			boxes.push_back(randomBox(random, n % 3 == 0 ? 1 : 6));  // a third of them are points
		}
		const BoxTree tree(boxes);
		for (int q = 0; q < 20; ++q) {
			const BoundingBox asked = randomBox(random, 8);
			std::vector<std::uint32_t> found, expected;
			tree.visit(
			    q % 3, [&](const BoundingBox& box) { return overlap(box, asked); },
			    [&](std::uint32_t i) { found.push_back(i); });
			for (std::uint32_t i = 0; i < n; ++i) {
				if (overlap(boxes[i], asked)) {
					expected.push_back(i);
				}
			}
			std::sort(found.begin(), found.end());
			EXPECT_EQ(found, expected);
		}
	}
}

TEST(BoxTree, looksAtFewOfManyBoxesAlsoInClusters) {
	std::vector<BoundingBox> boxes;
	for (int i = 0; i < 10000; ++i) {
		const double x = i < 9999 ? i * 1e-9 : 1e9;
		boxes.push_back({{x, 0, 0}, {x, 1, 1}});
	}
	const BoxTree tree(boxes);
	std::size_t looks = 0, found = 0;
	tree.visit(
	    0,
	    [&](const BoundingBox& box) {
		    ++looks;
		    return box.lo[0] <= 5e-6 && box.hi[0] >= 5e-6;
	    },
	    [&](std::uint32_t) { ++found; });
	EXPECT_LE(found, 1u);
	EXPECT_LT(looks, 100u);
}

TEST(BoxTree, whatBeginsLowerComesFirst) {
	std::vector<BoundingBox> boxes;
	for (int i = 0; i < 1000; ++i) {
		const double x = i * 7 % 1000;
		boxes.push_back({{x, 0, 0}, {x, 1, 1}});
	}
	double limit = 1e9;
	std::size_t visited = 0;
	BoxTree(boxes).visit(
	    0, [&](const BoundingBox& box) { return box.lo[0] <= limit; },
	    [&](std::uint32_t i) {
		    limit = std::min(limit, boxes[i].lo[0]);
		    ++visited;
	    });
	EXPECT_EQ(limit, 0);
	EXPECT_LT(visited, 20u);
}

}  // namespace
}  // namespace index_boolean
