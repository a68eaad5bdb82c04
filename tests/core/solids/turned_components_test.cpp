// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Thin components that lie where they may not are dropped; all others stay.
#include "core/shapes.h"

#include <vcg_ext/exact/exact_sign.h>
#include <vcg_ext/solids/turned_components.h>

#include <gtest/gtest.h>

namespace index_boolean {
namespace {

using namespace shapes;

constexpr double kThin = 0x1p-52;

// A flake in the plane z, so thin.
Mesh flake(double x, double z, double thickness = kThin) {
	return box({x, 1, z}, {x + 1, 2, z + thickness});
}

Block blockOf(const Mesh& mesh) {
	Block block;
	block.points = mesh.points;
	block.triangles = mesh.triangles;
	for (std::uint32_t f = 0; f < mesh.triangles.size(); ++f) {
		block.faceSource.push_back({FaceId{f}, false});
	}
	for (std::uint32_t v = 0; v < mesh.points.size(); ++v) {
		block.vertexSource.push_back({v});
	}
	block.suspect.assign(mesh.points.size(), 0);
	return block;
}

// How many components are dropped; the rest is as it was.
std::size_t dropped(const Mesh& kept, const Mesh& other, bool certify = true) {
	Arrangement arrangement;
	arrangement.options.certify = certify;
	Monitor monitor;
	Block block = blockOf(joined(kept, other));
	const auto before = geometry(block);
	EXPECT_TRUE(dropTurnedComponents(arrangement, 0, monitor, block).ok());
	EXPECT_EQ(geometry(block),
	          block.repair.vanishedComponents > 0 ? geometry(blockOf(kept)) : before);
	EXPECT_EQ(block.points.size(), block.vertexSource.size());
	EXPECT_EQ(block.points.size(), block.suspect.size());
	return block.repair.vanishedComponents;
}

const Mesh kCube = box({0, 0, 0}, {4, 4, 4});

TEST(TurnedComponents, aFlakeOutsideStaysUnlessItIsInsideOut) {
	const Mesh outside = flake(6, 0.5);
	EXPECT_EQ(dropped(kCube, outside), 0U);
	EXPECT_EQ(dropped(kCube, turned(outside)), 1U);
	EXPECT_EQ(dropped(kCube, turned(outside), false), 0U);  // not asked for
}

TEST(TurnedComponents, aCavityStaysUnlessItIsFilled) {
	const Mesh inside = flake(1, 0.5);
	EXPECT_EQ(dropped(kCube, turned(inside)), 0U);
	EXPECT_EQ(dropped(kCube, inside), 1U);
}

TEST(TurnedComponents, whatLiesInOneThatIsDroppedGoesToo) {
	// Right if the flake around it were there: a cavity of it.
	const Mesh wide = turned(flake(1, 8, 0x1p-48));
	const Mesh within = box({1.25, 1.25, 8 + 0x1p-50}, {1.5, 1.5, 8 + 0x1p-49});
	EXPECT_EQ(dropped(kCube, joined(wide, turned(within))), 2U);
}

TEST(TurnedComponents, whatIsNotThinIsNotAskedFor) {
	EXPECT_EQ(dropped(kCube, turned(flake(1, 8, 0.5))), 0U);
}

// Needles have no area but rounding.
TEST(TurnedComponents, aNeedleIsThin) {
	Mesh needle;
	needle.points = {{6, 0, 0}, {7, 0.1, 0.3}, {7, 0.1 + 0x1p-54, 0.3}, {7, 0.1, 0.3 + 0x1p-53}};
	needle.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
	const MeshArrays mesh = arrays(needle, needle);
	const bool isOut =
	    exactVolumeSign(mesh.points, mesh.triangles.data(), mesh.triangles.data() + 4) > 0;
	EXPECT_EQ(dropped(kCube, isOut ? needle : turned(needle)), 0U);
	EXPECT_EQ(dropped(kCube, isOut ? turned(needle) : needle), 1U);
}

}  // namespace
}  // namespace index_boolean
