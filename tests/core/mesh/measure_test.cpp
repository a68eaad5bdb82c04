// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Volume, area, components and closedness of surfaces for which they are known exactly.
#include "core/shapes.h"

#include <vcg_ext/mesh/measure.h>

#include <gtest/gtest.h>

#include <limits>
#include <random>

using namespace index_boolean;
using shapes::Mesh;

namespace {

BlockMeasure measure(const Mesh& mesh, int threads = 0) {
	return measureSurface(mesh.points, mesh.triangles, threads);
}

Mesh mapped(Mesh mesh, double scale, Point offset) {
	for (Point& p : mesh.points) {
		for (std::size_t axis = 0; axis < 3; ++axis) {
			p[axis] = p[axis] * scale + offset[axis];
		}
	}
	return mesh;
}

// Six times the volume of a mesh with integer coordinates below 2^40, exactly.
__int128 sixVolumes(const Mesh& mesh) {
	const auto coordinate = [&mesh](std::uint32_t vertex, std::size_t axis) {
		return static_cast<__int128>(mesh.points[vertex][axis]);
	};
	__int128 sum = 0;
	for (const auto& t : mesh.triangles) {
		for (std::size_t axis = 0; axis < 3; ++axis) {
			const std::size_t next = (axis + 1) % 3;
			const std::size_t after = (axis + 2) % 3;
			sum += coordinate(t[0], axis) * (coordinate(t[1], next) * coordinate(t[2], after) -
			                                 coordinate(t[1], after) * coordinate(t[2], next));
		}
	}
	return sum;
}

}  // namespace

TEST(Measure, boxHasItsVolumeAndArea) {
	const BlockMeasure box = measure(shapes::box({1, 2, 3}, {2, 4, 6}));
	EXPECT_EQ(box.volume, 6);
	EXPECT_EQ(box.area, 22);
	EXPECT_EQ(box.components, 1U);
	EXPECT_TRUE(box.closed);
	EXPECT_EQ(measure(shapes::turned(shapes::box({1, 2, 3}, {2, 4, 6}))).volume, -6);
}

TEST(Measure, nothingHasNoVolume) {
	for (const Mesh& mesh : {Mesh{}, Mesh{{{0, 0, 0}, {1, 1, 1}}, {}}}) {
		const BlockMeasure nothing = measure(mesh);
		EXPECT_EQ(nothing.volume, 0);
		EXPECT_EQ(nothing.area, 0);
		EXPECT_EQ(nothing.components, 0U);
		EXPECT_TRUE(nothing.closed);
	}
}

TEST(Measure, volumeIsExactUpToAFewRoundings) {
	for (unsigned seed = 1; seed <= 5; ++seed) {
		SCOPED_TRACE(seed);
		std::mt19937 random(seed);
		Mesh mesh = shapes::placed(shapes::sphere(200, {0, 0, 0}, 8e6), random, 3e6);
		for (Point& p : mesh.points) {
			for (double& x : p) {
				x = std::round(x);
			}
		}
		const double exact = static_cast<double>(sixVolumes(mesh)) / 6;
		EXPECT_NEAR(measure(mesh).volume / exact, 1, 1e-15);
	}
}

// The same roundings, over and over in the same direction.
TEST(Measure, manySmallPartsBesideALargeOneAreNotRoundedAway) {
	Mesh mesh = shapes::box({-0x1p32, -0x1p32, -0x1p32}, {0x1p32, 0x1p32, 0x1p32});
	for (int i = 0; i < 600; ++i) {
		mesh = shapes::joined(
		    mesh, shapes::box({87654321, 7654321, 654321}, {87665432, 7676543, 687654}));
	}
	const double exact = static_cast<double>(sixVolumes(mesh)) / 6;
	EXPECT_NEAR(measure(mesh).volume / exact, 1, 3e-16);
}

TEST(Measure, distanceFromTheOriginCostsNothing) {
	const Mesh box = shapes::box({0, 0, 0}, {1, 1, 1});
	EXPECT_EQ(measure(mapped(box, 1, {0x1p50, -0x1p50, 0x1p49})).volume, 1);
	const Mesh sphere = mapped(shapes::sphere(40, {0, 0, 0}, 1), 0x1p12, {0, 0, 0});
	Mesh rounded = sphere;
	for (Point& p : rounded.points) {
		for (double& x : p) {
			x = std::round(x);
		}
	}
	EXPECT_NEAR(measure(mapped(rounded, 1, {0x1p40, 0x1p40, 0x1p40})).volume /
	                measure(rounded).volume,
	            1, 1e-15);
}

TEST(Measure, scaleByAPowerOfTwoScalesExactly) {
	const Mesh sphere = shapes::sphere(20, {0.1, 0.2, 0.3}, 1);
	const BlockMeasure one = measure(sphere);
	for (const int exponent : {-330, -100, 3, 100, 330}) {
		SCOPED_TRACE(exponent);
		const BlockMeasure scaled = measure(mapped(sphere, std::ldexp(1, exponent), {0, 0, 0}));
		EXPECT_EQ(scaled.volume, std::ldexp(one.volume, 3 * exponent));
		EXPECT_EQ(scaled.area, std::ldexp(one.area, 2 * exponent));
	}
}

TEST(Measure, volumesBeyondDoubleAreInfiniteOrZero) {
	const double infinity = std::numeric_limits<double>::infinity();
	const Mesh box = shapes::box({-1, -1, -1}, {1, 1, 1});
	const BlockMeasure huge = measure(mapped(box, std::numeric_limits<double>::max(), {0, 0, 0}));
	EXPECT_EQ(huge.volume, infinity);
	EXPECT_EQ(huge.area, infinity);
	EXPECT_TRUE(huge.closed);
	EXPECT_EQ(measure(mapped(shapes::turned(box), 1e200, {0, 0, 0})).volume, -infinity);
	const BlockMeasure tiny =
	    measure(mapped(box, std::numeric_limits<double>::denorm_min(), {0, 0, 0}));
	EXPECT_EQ(tiny.volume, 0);
	EXPECT_EQ(tiny.area, 0);
	EXPECT_TRUE(tiny.closed);
	EXPECT_EQ(measure(mapped(box, 1e-320, {0, 0, 0})).volume, 0);
	const Point somewhere = {3, 4, 5};
	EXPECT_EQ(measure(Mesh{{somewhere, somewhere, somewhere}, {{0, 1, 2}, {2, 1, 0}}}).volume, 0);
}

TEST(Measure, componentsAreConnectedByVertices) {
	const Mesh box = shapes::box({0, 0, 0}, {1, 1, 1});
	const Mesh other = shapes::box({1, 1, 1}, {2, 2, 2});
	Mesh two = shapes::joined(box, other);
	EXPECT_EQ(measure(two).components, 2U);
	EXPECT_EQ(measure(two).volume, 2);
	for (auto& t : two.triangles) {
		for (std::uint32_t& v : t) {
			v = v == 8 ? 7 : v;  // (1, 1, 1) of both
		}
	}
	EXPECT_EQ(measure(two).components, 1U);
	EXPECT_TRUE(measure(two).closed);
}

TEST(Measure, verticesWithoutFacesAreNoComponents) {
	Mesh box = shapes::box({0, 0, 0}, {1, 1, 1});
	box.points.push_back({0.5, 0.5, 0.5});
	EXPECT_EQ(measure(box).components, 1U);
}

TEST(Measure, openAndConflictingSurfacesAreNotClosed) {
	Mesh open = shapes::box({0, 0, 0}, {1, 1, 1});
	open.triangles.pop_back();
	EXPECT_FALSE(measure(open).closed);
	Mesh conflicting = shapes::box({0, 0, 0}, {1, 1, 1});
	std::swap(conflicting.triangles[0][0], conflicting.triangles[0][1]);
	EXPECT_FALSE(measure(conflicting).closed);
}

TEST(Measure, figuresDoNotDependOnTheThreads) {
	std::mt19937 random(2);
	Mesh many;
	for (int i = 0; i < 30; ++i) {
		many = shapes::joined(many, shapes::placed(shapes::sphere(30, {0, 0, 0}, 1), random, 50));
	}
	many = shapes::permuted(many, random);
	const BlockMeasure one = measure(many, 1);
	EXPECT_EQ(one.components, 30U);
	for (const int threads : {0, 2, 3, 8}) {
		for (int repeat = 0; repeat < 3; ++repeat) {
			const BlockMeasure other = measure(many, threads);
			EXPECT_EQ(other.volume, one.volume);
			EXPECT_EQ(other.area, one.area);
			EXPECT_EQ(other.components, one.components);
			EXPECT_TRUE(other.closed);
		}
	}
}
