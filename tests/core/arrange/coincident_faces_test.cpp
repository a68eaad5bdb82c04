// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Operands that have faces in common: the answer is that of the laws, whether these faces are
// looked at or known beforehand.
#include "core/shapes.h"

#include <gtest/gtest.h>

namespace index_boolean {
namespace {

using namespace shapes;

constexpr std::uint32_t kSide = 8;  // squares along a wall's side

std::size_t quietCount(const BooleanRun& r) {
	const std::vector<Twin>& faces = r.arrangement.mesh.quietFaces;
	return faces.size() -
	       static_cast<std::size_t>(std::count(faces.begin(), faces.end(), Twin::None));
}

void expectRight(const BooleanRun& r, double a, double b, double both) {
	ASSERT_TRUE(r.status.ok()) << describe(r.status);
	const std::array<double, 5> expected{a + b - both, both, a - both, b - both, a + b - 2 * both};
	for (std::size_t k = 0; k < 5; ++k) {
		const Block& block = r.blocks[k];
		EXPECT_NEAR(volumeOf(block.points, block.triangles), expected[k], 1e-12 * (a + b))
		    << operationName(block.operation);
		EXPECT_TRUE(isManifold(block.triangles)) << operationName(block.operation);
	}
}

double volume(const Mesh& m) { return volumeOf(m.points, m.triangles); }

TEST(CoincidentFaces, identicalOperandsHaveNothingElse) {
	std::mt19937 random(3);
	const Mesh a = placed(sphere(15, {0, 0, 0}, 1), random, 1);
	const BooleanRun r = run(a, permuted(a, random));
	expectRight(r, volume(a), volume(a), volume(a));
	EXPECT_EQ(quietCount(r), 2 * a.triangles.size());
	EXPECT_TRUE(r.blocks[2].triangles.empty());
	EXPECT_EQ(r.audit.blocks[0].components, 1u);
	EXPECT_EQ(geometry(r.blocks[0]), geometry(r.blocks[1]));
}

// Some of one sphere's vertices are pulled inwards, so that the other has its common faces around
// dents of any shape, single faces among them.
TEST(CoincidentFaces, dentsOfAnyShapeAreRight) {
	for (std::uint32_t seed = 0; seed < 30; ++seed) {
		SCOPED_TRACE("seed " + std::to_string(seed));
		std::mt19937 random(seed);
		const Mesh a = sphere(10 + seed % 7, {0, 0, 0}, 1);
		Mesh b = a;
		std::bernoulli_distribution pull(0.01 * (seed % 30 + 1));
		for (Point& p : b.points) {
			const double scale = pull(random) ? 0.9 : 1;
			p = {p[0] * scale, p[1] * scale, p[2] * scale};
		}
		const BooleanRun r = run(a, permuted(b, random));
		const BooleanRun swapped = run(b, a);
		expectRight(r, volume(a), volume(b), volume(b));
		expectRight(swapped, volume(b), volume(a), volume(b));
		EXPECT_EQ(geometry(r.blocks[2]), geometry(swapped.blocks[3]));
		EXPECT_EQ(geometry(r.blocks[0]), geometry(swapped.blocks[0]));
	}
}

// Both spheres are moved inwards, each at its own vertices: they cross between common faces.
TEST(CoincidentFaces, crossingsBetweenCommonFacesAreRight) {
	std::size_t quiet = 0;
	for (std::uint32_t seed = 0; seed < 12; ++seed) {
		SCOPED_TRACE("seed " + std::to_string(seed));
		std::mt19937 random(seed);
		Mesh a = sphere(14, {0, 0, 0}, 1), b = a;
		std::bernoulli_distribution pull(0.05);
		for (Mesh* m : {&a, &b}) {
			for (Point& p : m->points) {
				const double scale = pull(random) ? 0.95 : 1;
				p = {p[0] * scale, p[1] * scale, p[2] * scale};
			}
		}
		const BooleanRun r = run(a, b);
		ASSERT_TRUE(r.status.ok()) << describe(r.status);
		EXPECT_LT(r.audit.volumeLawResidual, 1e-14);
		quiet += quietCount(r);
		for (const int threads : {1, 2, 8}) {
			Options options;
			options.threads = threads;
			const BooleanRun other = run(a, b, options);
			EXPECT_EQ(geometry(r.blocks[0]), geometry(other.blocks[0]));
		}
		EXPECT_EQ(geometry(r.blocks[1]), geometry(run(b, a).blocks[1]));
	}
	EXPECT_GT(quiet, 0u);
}

// A wall of many faces with a solid on either side of it.
TEST(CoincidentFaces, aCommonWallBetweenTwoSolidsGoes) {
	Mesh wall;  // a square sheet, bumpy
	for (std::uint32_t i = 0; i <= kSide; ++i) {
		for (std::uint32_t j = 0; j <= kSide; ++j) {
			const bool border = i == 0 || j == 0 || i == kSide || j == kSide;
			wall.points.push_back({1.0 * i, 1.0 * j, border ? 0 : 0.1 * ((i * 7 + j * 3) % 5)});
		}
	}
	const auto solidOn = [&](double height) {  // its rim joined to a point above or below
		Mesh m = wall;
		m.points.push_back({kSide / 2.0, kSide / 2.0, height});
		const auto apex = static_cast<std::uint32_t>(m.points.size() - 1);
		const auto id = [](std::uint32_t i, std::uint32_t j) { return i * (kSide + 1) + j; };
		for (std::uint32_t i = 0; i < kSide; ++i) {
			for (std::uint32_t j = 0; j < kSide; ++j) {
				m.triangles.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
				m.triangles.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
			}
			m.triangles.push_back({id(i + 1, 0), id(i, 0), apex});
			m.triangles.push_back({id(i, kSide), id(i + 1, kSide), apex});
			m.triangles.push_back({id(0, i), id(0, i + 1), apex});
			m.triangles.push_back({id(kSide, i + 1), id(kSide, i), apex});
		}
		return height < 0 ? m : turned(m);
	};
	const Mesh above = solidOn(5), below = solidOn(-5);
	const BooleanRun r = run(above, below);
	expectRight(r, volume(above), volume(below), 0);
	EXPECT_GT(quietCount(r), 0u);
	EXPECT_EQ(r.audit.blocks[0].components, 1u);
	EXPECT_EQ(geometry(r.blocks[2]).size(), above.triangles.size());
}

TEST(CoincidentFaces, componentsAreCountedWhereSomeAreCommon) {
	const Mesh common = sphere(8, {0, 0, 0}, 1);
	const Mesh a = joined(common, box({3, 0, 0}, {4, 1, 1}));
	const Mesh b = joined(common, joined(box({3.5, 0.5, 0.5}, {5, 2, 2}), sphere(6, {9, 9, 9}, 1)));
	const BooleanRun r = run(a, b);
	expectRight(r, volume(a), volume(b), volume(common) + 0.125);
	EXPECT_EQ(r.arrangement.labels.components, (PerOperand<std::uint32_t>{2, 3}));
	EXPECT_EQ(r.audit.blocks[0].components, 3u);
}

TEST(CoincidentFaces, aCommonCavityIsRight) {
	const Mesh hollow = joined(box({0, 0, 0}, {4, 4, 4}), turned(sphere(6, {2, 2, 2}, 1)));
	const Mesh ball = sphere(6, {2, 2, 2}, 1);
	const BooleanRun filled = run(hollow, ball);
	expectRight(filled, volume(hollow), volume(ball), 0);
	EXPECT_EQ(geometry(filled.blocks[0]).size(), 12u);
	expectRight(run(hollow, hollow), volume(hollow), volume(hollow), volume(hollow));
}

}  // namespace
}  // namespace index_boolean
