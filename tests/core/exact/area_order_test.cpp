// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Areas and volumes that differ in the last bit, or not at all.
#include "core/shapes.h"

#include <vcg_ext/exact/area_order.h>

#include <gtest/gtest.h>

namespace index_boolean {
namespace {

// Triangles, each with corners of its own.
struct Sets {
	Points points;
	std::array<Triangles, 2> of;

	void add(std::size_t set, const Point& a, const Point& b, const Point& c) {
		const auto first = static_cast<std::uint32_t>(points.size());
		for (const Point& p : {a, b, c}) {
			points.push_back(p);
		}
		of[set].push_back({VertexId{first}, VertexId{first + 1}, VertexId{first + 2}});
	}
	int areas() const {
		Monitor monitor;
		return compareAreas(points, of[0], of[1], monitor);
	}
	int volumes() const {
		Monitor monitor;
		return compareVolumesBelow(points, of[0], of[1], monitor);
	}
};

// A triangle against itself in random parts around a point of it: areas are sums of roots of
// numbers that are squares times the same number.
Sets partedTriangle(std::mt19937& random, double scale) {
	const auto integer = [&](int most) {
		return static_cast<double>(random() % static_cast<unsigned>(2 * most + 1)) - most;
	};
	std::array<Point, 3> t{};
	for (Point& p : t) {
		p = {scale * integer(1000), scale * integer(1000), scale * integer(1000) + scale / 8};
	}
	const double u = 7 + integer(6), v = 7 + integer(6), w = 32 - u - v;
	Point inside{};
	for (std::size_t k = 0; k < 3; ++k) {
		inside[k] = (u * t[0][k] + v * t[1][k] + w * t[2][k]) / 32;
	}
	Sets sets;
	sets.add(0, t[0], t[1], t[2]);
	for (std::size_t i = 0; i < 3; ++i) {
		sets.add(1, t[i], t[(i + 1) % 3], inside);
	}
	return sets;
}

TEST(AreaOrder, aTriangleHasTheAreaOfItsParts) {
	std::mt19937 random(1);
	for (const double scale : {1., 0x1p-400, 0x1p400}) {
		for (int n = 0; n < 100; ++n) {
			Sets sets = partedTriangle(random, scale);
			EXPECT_EQ(sets.areas(), 0);
			sets.of[1].pop_back();
			EXPECT_EQ(sets.areas(), 1);
			std::swap(sets.of[0], sets.of[1]);
			EXPECT_EQ(sets.areas(), -1);
		}
	}
}

TEST(AreaOrder, oneUlpDecides) {
	for (const double height : {1., 0x1p-600, 0x1p600}) {
		Sets sets;
		sets.add(0, {0, 0, 0}, {3, 0, 0}, {0, 0, height});
		sets.add(1, {0, 0, 0}, {1, 0, 0}, {0, height, 0});
		sets.add(1, {0, 0, 0}, {0, 2, 0}, {height, 0, 0});
		EXPECT_EQ(sets.areas(), 0);
		sets.points[4][0] = std::nextafter(1., 2.);
		EXPECT_EQ(sets.areas(), -1);
		sets.points[4][0] = std::nextafter(1., 0.);
		EXPECT_EQ(sets.areas(), 1);
	}
}

TEST(AreaOrder, volumesBelowAreExact) {
	Sets sets;
	sets.add(0, {1, 0, 0}, {0, 1, 0}, {0, 0, 1});
	sets.add(1, {1, 0, 0}, {0, 1, 0}, {0, 0, 1});
	EXPECT_EQ(sets.volumes(), 0);
	sets.points[5][2] = std::nextafter(1., 2.);
	EXPECT_EQ(sets.volumes(), -1);
	std::swap(sets.of[0][0][1], sets.of[0][0][2]);
	std::swap(sets.of[1][0][1], sets.of[1][0][2]);
	EXPECT_EQ(sets.volumes(), 1);
}

TEST(AreaOrder, nothingIsLessThanSomething) {
	Sets sets;
	EXPECT_EQ(sets.areas(), 0);
	EXPECT_EQ(sets.volumes(), 0);
	sets.add(0, {0, 0, 0}, {1, 1, 1}, {2, 2, 2});
	EXPECT_EQ(sets.areas(), 0);
	sets.add(1, {0, 0, 0}, {0x1p-500, 0, 0}, {0, 0x1p-500, 0});
	EXPECT_EQ(sets.areas(), -1);
}

}  // namespace
}  // namespace index_boolean
