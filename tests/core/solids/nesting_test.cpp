// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which components of one operand may lie where, also where they touch: whatever corner a face
// lists first, and along whichever axis the walls run.
#include "core/shapes.h"

#include <gtest/gtest.h>

namespace index_boolean {
namespace {

using namespace shapes;

const Mesh kUnitBox = box({0, 0, 0}, {1, 1, 1});
const Mesh kFarBox = box({10, 10, 10}, {11, 12, 13});
constexpr double kFarVolume = 6;

// A tetrahedron whose first face begins with `tip`, turned right side out.
Mesh tetrahedron(Point tip, const std::array<Point, 3>& base) {
	Mesh m;
	m.points = {tip, base[0], base[1], base[2]};
	m.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
	return volumeOf(m.points, m.triangles) < 0 ? turned(m) : m;
}

// Every way to name the axes, and to list the corners of faces and the faces themselves.
template <class Check>
void forEachView(const Mesh& layer, Check&& check) {
	std::mt19937 random(7);
	for (std::size_t axis = 0; axis < 3; ++axis) {
		for (int order = 0; order < 8; ++order) {
			Mesh view = order == 0 ? layer : permuted(layer, random);
			for (Point& p : view.points) {
				p = {p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3]};
			}
			SCOPED_TRACE(axis);
			check(view);
		}
	}
}

void expectAccepted(const Mesh& layer) {
	const double volume = volumeOf(layer.points, layer.triangles);
	forEachView(layer, [volume](const Mesh& view) {
		const BooleanRun r = run(view, kFarBox);
		ASSERT_TRUE(r.status.ok()) << describe(r.status);
		EXPECT_NEAR(r.volume(Operation::Union), volume + kFarVolume, 1e-12);
		EXPECT_TRUE(r.block(Operation::Intersection).triangles.empty());
		EXPECT_TRUE(r.audit.blocks[0].closed);
	});
}

void expectNested(const Mesh& layer) {
	forEachView(layer, [](const Mesh& view) {
		const BooleanRun r = run(view, kFarBox);
		EXPECT_EQ(r.status.code, StatusCode::NestedComponents) << describe(r.status);
		EXPECT_EQ(r.status.operand, 0);
	});
}

TEST(Nesting, aTetrahedronMayTouchAWallFromOutside) {
	const std::array<Point, 3> base{{{-1, .2, .2}, {-1, .8, .3}, {-1, .5, .9}}};
	expectAccepted(joined(kUnitBox, tetrahedron({0, .5, .5}, base)));
	expectAccepted(joined(tetrahedron({0, .5, .5}, base), kUnitBox));
}

TEST(Nesting, aTetrahedronThatTouchesAWallFromInsideIsNested) {
	const std::array<Point, 3> base{{{.5, .2, .2}, {.5, .8, .3}, {.5, .5, .9}}};
	expectNested(joined(kUnitBox, tetrahedron({1, .5, .5}, base)));
	expectNested(joined(tetrahedron({1, .5, .5}, base), kUnitBox));
	// Turned, it is a cavity.
	expectAccepted(joined(kUnitBox, turned(tetrahedron({1, .5, .5}, base))));
}

TEST(Nesting, boxesMayTouchInPartOfTheirWalls) {
	expectAccepted(joined(kUnitBox, box({1, .5, .25}, {2, 1.5, 1.25})));
	expectAccepted(joined(kUnitBox, box({1, .25, .25}, {2, .75, .75})));
	expectAccepted(joined(kUnitBox, box({.25, 1, -1}, {.75, 2, 2})));
}

// Of these bricks the middle one has every wall covered by others.
TEST(Nesting, aBrickMayBeWalledIn) {
	Mesh wall = box({0, 0, 0}, {2, 2, 2});
	wall = joined(wall, box({-1, -1, -2}, {3, 3, 0}));
	wall = joined(wall, box({-1.5, -1.5, 2}, {3.5, 3.5, 4}));
	wall = joined(wall, box({-2, -.5, 0}, {0, 2.5, 2}));
	wall = joined(wall, box({2, -.5, 0}, {4, 2.5, 2}));
	wall = joined(wall, box({.25, -2, .25}, {1.5, 0, 1.5}));
	expectAccepted(joined(wall, box({.25, 2, .5}, {1.5, 4, 1.75})));
}

TEST(Nesting, aBoxInsideThatSharesPartOfAWallIsNested) {
	expectNested(joined(kUnitBox, box({.5, .25, .25}, {1, .75, .75})));
	expectAccepted(joined(kUnitBox, turned(box({.5, .25, .25}, {1, .75, .75}))));
}

TEST(Nesting, solidsInCavitiesMayTouchTheirWalls) {
	const Mesh shell = joined(box({0, 0, 0}, {8, 8, 8}), turned(box({1, 1, 1}, {7, 7, 7})));
	expectAccepted(joined(shell, box({1, 2, 2}, {3, 4, 4})));
	expectAccepted(joined(shell, box({2, 3, 4}, {3, 4, 5})));
	expectNested(joined(shell, turned(box({2, 3, 4}, {3, 4, 5}))));
}

// What takes quadratic time or memory if queries are told apart along one axis only.
TEST(Nesting, wallsAndTowersOfBoxesAreAccepted) {
	for (std::size_t axis = 0; axis < 3; ++axis) {
		Mesh wall, tower;
		for (int i = 0; i < 40; ++i) {
			Point low{0, 0, 0}, high{1, 1, 1};
			low[axis] = 2 * i;
			high[axis] = 2 * i + 1;
			low[(axis + 1) % 3] = .25 * (i % 2);
			tower = joined(tower, box(low, high));
			for (int j = 0; j < 10; ++j) {
				low[(axis + 1) % 3] = 2 * j;
				high[(axis + 1) % 3] = 2 * j + 1;
				wall = joined(wall, box(low, high));
			}
		}
		const Mesh far = box({-5, -5, -5}, {-4, -4, -4});
		EXPECT_DOUBLE_EQ(run(wall, far).volume(Operation::Union), 400 + 1);
		EXPECT_DOUBLE_EQ(run(tower, far).volume(Operation::Union), 20 * 1.75 + 1);
	}
}

}  // namespace
}  // namespace index_boolean
