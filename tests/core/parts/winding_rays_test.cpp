// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Winding numbers of random meshes on a small grid, so that queries lie on vertices, edges, faces
// and in planes of walls along each axis, against a count in
// integers, at a point that is moved by fractions small enough for the grid.
#include "core/shapes.h"

#include <vcg_ext/parts/winding_rays.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <gtest/gtest.h>

namespace index_boolean {
namespace {

using namespace shapes;

using Integer = boost::multiprecision::int256_t;
using Vector = std::array<Integer, 3>;

Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

Vector cross(const Vector& a, const Vector& b) {
	return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Integer dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

int volumeSign(const Vector& a, const Vector& b, const Vector& c) {
	return dot(a, cross(b, c)).sign();
}

// With coordinates below 5, what a plane says of a vector is an integer below 2^9: so e = 2^-12,
// e^2 and a step of 2^-36 times a normal are as good as infinitely small against each other.
constexpr int kBits = 46, kMove = 12, kStep = 36;

Vector scaled(const Point& p) {
	Vector v;
	for (std::size_t k = 0; k < 3; ++k) {
		v[k] = Integer(static_cast<int>(p[k])) << kBits;
	}
	return v;
}

// A closed surface through random grid points: boundaries of boxes and tetrahedra.
Mesh randomMesh(std::mt19937& random, int tetrahedra) {
	Mesh m = joined(gridBox(random, 2), turned(gridBox(random, 2)));
	while (tetrahedra > 0) {
		Mesh t;
		for (int i = 0; i < 4; ++i) {
			t.points.push_back({static_cast<double>(random() % 5),
			                    static_cast<double>(random() % 5),
			                    static_cast<double>(random() % 5)});
		}
		t.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
		if (volumeOf(t.points, t.triangles) != 0) {
			m = joined(m, t);
			--tetrahedra;
		}
	}
	return m;
}

// The winding number around p, off the surface, by a ray in a direction that passes no edge.
int windingAround(const Mesh& m, const Vector& p) {
	const Vector direction{1009, 2741, 7919};
	int winding = 0;
	for (const auto& t : m.triangles) {
		const Vector a = minus(scaled(m.points[t[0]]), p), b = minus(scaled(m.points[t[1]]), p),
		             c = minus(scaled(m.points[t[2]]), p);
		const int turn = volumeSign(a, b, direction);
		EXPECT_NE(turn, 0);
		if (volumeSign(b, c, direction) == turn && volumeSign(c, a, direction) == turn &&
		    volumeSign(a, b, c) == turn) {
			winding += turn;
		}
	}
	return winding;
}

bool isOn(const Mesh& m, const Vector& p) {
	return std::any_of(m.triangles.begin(), m.triangles.end(), [&](const auto& t) {
		const Vector a = scaled(m.points[t[0]]), b = scaled(m.points[t[1]]),
		             c = scaled(m.points[t[2]]);
		const Vector normal = cross(minus(b, a), minus(c, a));
		const auto isLeft = [&](const Vector& u, const Vector& v) {
			return dot(normal, cross(minus(v, u), minus(p, u))) >= 0;
		};
		return dot(normal, minus(p, a)) == 0 && isLeft(a, b) && isLeft(b, c) && isLeft(c, a);
	});
}

// The place p0 + e (p1 - p0) + e^2 (p2 - p0) in a face, and `step` steps in front of it.
Vector placeIn(const Mesh& m, const std::array<std::uint32_t, 3>& t, int step) {
	const Vector p0 = scaled(m.points[t[0]]);
	const Vector u = minus(scaled(m.points[t[1]]), p0), v = minus(scaled(m.points[t[2]]), p0);
	const Vector normal = cross(u, v);  // scaled twice
	Vector p{};
	for (std::size_t k = 0; k < 3; ++k) {
		const Integer out = (normal[k] >> (kBits + kStep)) * step;
		p[k] = p0[k] + (u[k] >> kMove) + (v[k] >> (2 * kMove)) + out;
	}
	return p;
}

TEST(WindingRays, facesAsTheCountInIntegers) {
	std::mt19937 random(11);
	std::size_t onSurface = 0, inside = 0;
	for (int round = 0; round < 400; ++round) {
		const Mesh asked = randomMesh(random, 3), counted = randomMesh(random, 5);
		const MeshArrays mesh = arrays(asked, counted);
		std::vector<WindingQuery> queries(asked.triangles.size());
		for (std::uint32_t f = 0; f < queries.size(); ++f) {
			queries[f] = queryInside(mesh, {f});
		}
		Monitor monitor;
		ASSERT_TRUE(findWindings(mesh, kSecond, {}, 1, monitor, queries).ok());
		for (std::uint32_t f = 0; f < queries.size(); ++f) {
			const auto& t = asked.triangles[f];
			ASSERT_EQ(queries[f].inFront, windingAround(counted, placeIn(asked, t, 1)))
			    << round << ' ' << f;
			ASSERT_EQ(queries[f].behind, windingAround(counted, placeIn(asked, t, -1)))
			    << round << ' ' << f;
			onSurface += queries[f].onSurface ? 1 : 0;
			inside += queries[f].behind != 0 ? 1 : 0;
		}
	}
	EXPECT_GT(onSurface, 20u);
	EXPECT_GT(inside, 300u);
}

TEST(WindingRays, verticesAsTheCountInIntegers) {
	std::mt19937 random(12);
	std::size_t inside = 0, off = 0;
	for (int round = 0; round < 400; ++round) {
		const Mesh asked = randomMesh(random, 3), counted = randomMesh(random, 5);
		const MeshArrays mesh = arrays(asked, counted);
		std::vector<WindingQuery> queries(asked.points.size());
		for (std::uint32_t v = 0; v < queries.size(); ++v) {
			queries[v].from = {v};
		}
		Monitor monitor;
		ASSERT_TRUE(findWindings(mesh, kSecond, {}, 1, monitor, queries).ok());
		for (std::uint32_t v = 0; v < queries.size(); ++v) {
			Vector p = scaled(asked.points[v]);
			if (isOn(counted, p)) {
				continue;
			}
			p = {p[0] + 8191, p[1] + 1237, p[2] + 99};  // along no edge's plane
			const int expected = windingAround(counted, p);
			ASSERT_FALSE(queries[v].onSurface);
			ASSERT_EQ(queries[v].inFront, expected) << round << ' ' << v;
			ASSERT_EQ(queries[v].behind, expected);
			++off;
			inside += expected != 0 ? 1 : 0;
		}
	}
	EXPECT_GT(off, 1000u);
	EXPECT_GT(inside, 100u);
}

TEST(WindingRays, ownFacesCanBeIgnored) {
	const Mesh nested = joined(box({0, 0, 0}, {4, 4, 4}), box({1, 1, 1}, {2, 2, 2}));
	const MeshArrays mesh = arrays(nested, box({9, 9, 9}, {10, 10, 10}));
	std::vector<WindingQuery> queries(2);
	queries[0] = queryInside(mesh, {0});
	queries[1] = queryInside(mesh, {12});
	const auto isOwn = [](std::size_t query, FaceId face) { return face.value / 12 == query; };
	Monitor monitor;
	ASSERT_TRUE(findWindings(mesh, kFirst, isOwn, 1, monitor, queries).ok());
	EXPECT_EQ(queries[0].behind, 0);
	EXPECT_EQ(queries[1].behind, 1);
	EXPECT_EQ(queries[1].inFront, 1);
}

}  // namespace
}  // namespace index_boolean
