// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// For tests of merging: boxes with walls of many faces, and how far two surfaces are from each
// other, without code of the core.
#pragma once

#include "core/shapes.h"

#include <functional>
#include <map>

namespace index_boolean::shapes {

// The unit cube with n by n squares on each side, each cut along a diagonal by chance.
inline Mesh squaredCube(std::uint32_t n, std::mt19937& random) {
	Mesh m;
	std::map<Point, std::uint32_t> numbers;
	const auto vertex = [&](std::size_t axis, double side, std::uint32_t i, std::uint32_t j) {
		Point p{};
		p[axis] = side;
		p[(axis + 1) % 3] = static_cast<double>(i) / n;
		p[(axis + 2) % 3] = static_cast<double>(j) / n;
		const auto next = static_cast<std::uint32_t>(m.points.size());
		const auto [it, isNew] = numbers.emplace(p, next);
		if (isNew) {
			m.points.push_back(p);
		}
		return it->second;
	};
	for (std::size_t axis = 0; axis < 3; ++axis) {
		for (const double side : {0.0, 1.0}) {
			for (std::uint32_t i = 0; i < n; ++i) {
				for (std::uint32_t j = 0; j < n; ++j) {
					std::array<std::uint32_t, 4> q{
					    vertex(axis, side, i, j), vertex(axis, side, i + 1, j),
					    vertex(axis, side, i + 1, j + 1), vertex(axis, side, i, j + 1)};
					if (side == 0) {
						std::swap(q[1], q[3]);
					}
					std::rotate(q.begin(), q.begin() + (random() % 2), q.end());
					m.triangles.push_back({q[0], q[1], q[2]});
					m.triangles.push_back({q[0], q[2], q[3]});
				}
			}
		}
	}
	return m;
}

// A class for each face of a unit cube: one below the middle of an axis, and one above.
inline std::vector<std::uint32_t> classesByHalf(const Mesh& m, std::size_t axis,
                                                std::uint32_t below, std::uint32_t above) {
	std::vector<std::uint32_t> classes;
	for (const IndexTriangle& t : m.triangles) {
		const double sum = m.points[t[0]][axis] + m.points[t[1]][axis] + m.points[t[2]][axis];
		classes.push_back(sum < 1.5 ? below : above);
	}
	return classes;
}

// Each coordinate moved by chance, by less than a size.
inline Mesh shaken(Mesh m, double size, std::mt19937& random) {
	std::uniform_real_distribution<double> move(-size, size);
	for (Point& p : m.points) {
		for (double& c : p) {
			c += move(random);
		}
	}
	return m;
}

inline double distanceToTriangle(const Point& p, const std::array<Point, 3>& t) {
	// The nearest point by descent over the corners' weights, exactly where it is at a feature.
	using Real = long double;
	const auto dot = [](const std::array<Real, 3>& a, const std::array<Real, 3>& b) {
		return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
	};
	const auto from = [](const Point& a, const Point& b) {
		return std::array<Real, 3>{Real(b[0]) - a[0], Real(b[1]) - a[1], Real(b[2]) - a[2]};
	};
	const auto toSegment = [&](const Point& a, const Point& b) {
		const auto u = from(a, b), w = from(a, p);
		const Real length = dot(u, u);
		const Real s = length > 0 ? std::min(Real(1), std::max(Real(0), dot(u, w) / length)) : 0;
		const std::array<Real, 3> off{w[0] - s * u[0], w[1] - s * u[1], w[2] - s * u[2]};
		return std::sqrt(dot(off, off));
	};
	Real least = std::min({toSegment(t[0], t[1]), toSegment(t[1], t[2]), toSegment(t[2], t[0])});
	const auto u = from(t[0], t[1]), v = from(t[0], t[2]), w = from(t[0], p);
	const std::array<Real, 3> n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
	                            u[0] * v[1] - u[1] * v[0]};
	const Real size = dot(n, n);
	if (size > 0) {
		const std::array<Real, 3> wv{w[1] * v[2] - w[2] * v[1], w[2] * v[0] - w[0] * v[2],
		                             w[0] * v[1] - w[1] * v[0]};
		const std::array<Real, 3> uw{u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2],
		                             u[0] * w[1] - u[1] * w[0]};
		const Real s = dot(wv, n) / size, r = dot(uw, n) / size;
		if (s >= 0 && r >= 0 && s + r <= 1) {
			least = std::min(least, std::fabs(dot(n, w)) / std::sqrt(size));
		}
	}
	return static_cast<double>(least);
}

// The greatest distance of points of one surface from another: of its corners, of the middles of
// its sides, and of points of its faces taken by chance.
inline double greatestDistance(const Points& points, const IndexTriangles& from,
                               const Points& otherPoints, const IndexTriangles& to) {
	std::mt19937 random(7);
	std::uniform_real_distribution<double> share(0, 1);
	double most = 0;
	for (const IndexTriangle& t : from) {
		for (int k = 0; k < 24; ++k) {
			double a = k < 7 ? std::array{1.0, 0.0, 0.0, 0.5, 0.5, 0.0, 1.0 / 3}[k] : share(random);
			double b = k < 7 ? std::array{0.0, 1.0, 0.0, 0.5, 0.0, 0.5, 1.0 / 3}[k] : share(random);
			if (a + b > 1) {
				a = 1 - a;
				b = 1 - b;
			}
			Point p{};
			for (std::size_t i = 0; i < 3; ++i) {
				p[i] = a * points[t[0]][i] + b * points[t[1]][i] + (1 - a - b) * points[t[2]][i];
			}
			double least = HUGE_VAL;
			for (const IndexTriangle& s : to) {
				least = std::min(least, distanceToTriangle(p, {otherPoints[s[0]], otherPoints[s[1]],
				                                               otherPoints[s[2]]}));
			}
			most = std::max(most, least);
		}
	}
	return most;
}

// Vertices less edges plus faces.
inline int eulerNumber(const IndexTriangles& triangles) {
	std::map<std::uint32_t, int> vertices;
	std::map<std::array<std::uint32_t, 2>, int> edges;
	for (const IndexTriangle& t : triangles) {
		for (std::size_t i = 0; i < 3; ++i) {
			++vertices[t[i]];
			++edges[{std::min(t[i], t[(i + 1) % 3]), std::max(t[i], t[(i + 1) % 3])}];
		}
	}
	return static_cast<int>(vertices.size()) - static_cast<int>(edges.size()) +
	       static_cast<int>(triangles.size());
}

}  // namespace index_boolean::shapes
