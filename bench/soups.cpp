// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "soups.h"

#include <cmath>
#include <random>

namespace index_boolean_bench {

namespace {

void append(const Surface& part, Surface& to) {
	const auto first = static_cast<std::uint32_t>(to.points.size());
	to.points.insert(to.points.end(), part.points.begin(), part.points.end());
	for (const auto& t : part.triangles) {
		to.triangles.push_back({first + t[0], first + t[1], first + t[2]});
	}
}

// Over a triangle that runs counter-clockwise seen from above.
Surface prismOver(const std::array<Point, 3>& base, double height) {
	Surface prism;
	for (const double z : {0.0, height}) {
		for (const Point& p : base) {
			prism.points.push_back({p[0], p[1], z});
		}
	}
	prism.triangles = {{0, 2, 1}, {3, 4, 5}};
	for (std::uint32_t i = 0; i < 3; ++i) {
		const std::uint32_t next = (i + 1) % 3;
		prism.triangles.push_back({i, next, next + 3});
		prism.triangles.push_back({i, next + 3, i + 3});
	}
	return prism;
}

// About an axis through the origin, by an angle whose sine and cosine are given.
Matrix turnAboutX(double cosine, double sine) {
	return {1, 0, 0, 0, 0, cosine, -sine, 0, 0, sine, cosine, 0};
}

}  // namespace

Surface makeStack(std::uint32_t count) {
	std::mt19937 random(1);
	const auto unit = [&random] { return static_cast<double>(random()) / 0x1p31 - 1; };
	Surface stack;
	for (std::uint32_t i = 0; i < count; ++i) {
		std::array<Point, 3> base{};
		double twiceArea = 0;
		while (twiceArea < 0.5) {
			for (Point& p : base) {
				p = {unit(), unit(), 0};
			}
			twiceArea = (base[1][0] - base[0][0]) * (base[2][1] - base[0][1]) -
			            (base[1][1] - base[0][1]) * (base[2][0] - base[0][0]);
		}
		append(prismOver(base, 1 + 0.01 * i), stack);
	}
	return stack;
}

Surface makeCrossedCones(std::uint32_t sides) {
	Surface cones = makeCone(sides), turned = cones;
	transform(turnAboutX(0.8, 0.6), turned);
	append(turned, cones);
	return cones;
}

Surface makeNearCopies(std::uint32_t faces) {
	constexpr int kCopies = 5;
	const Surface sphere = makeSphere(faces);
	const double edge = std::sqrt(29.0 / static_cast<double>(sphere.triangles.size()));
	Surface copies;
	for (int i = 0; i < kCopies; ++i) {
		Surface copy = sphere;
		transform(standardRotation(), copy);
		transform(turnAboutX(std::cos(0.2 * i * edge), std::sin(0.2 * i * edge)), copy);
		append(copy, copies);
	}
	return copies;
}

Surface makePencil(std::uint32_t count, double height) {
	constexpr double kRadius = 1024;  // corners are integers: the axis lies in the faces exactly
	constexpr double kHalfTurn = 3.141592653589793;
	Surface pencil;
	for (std::uint32_t i = 0; i < count; ++i) {
		const double angle = kHalfTurn * (i + 0.3) / count;
		const double x = std::round(kRadius * std::cos(angle));
		const double y = std::round(kRadius * std::sin(angle));
		const double width = 0.3 / count;
		append(prismOver({{{-x, -y, 0}, {x, y, 0}, {-width * y, width * x, 0}}}, height), pencil);
	}
	return pencil;
}

Surface makeSlabs(std::uint32_t count, double height) {
	const Surface cube = makeCube(1);
	Surface slabs;
	for (std::uint32_t i = 0; i < count; ++i) {
		Surface slab = cube;
		const double pitch = height / count;
		transform({3000, 0, 0, 77, 0, 3000, 0, 33, 0, 0, pitch / 2, pitch * (i + 0.5)}, slab);
		append(slab, slabs);
	}
	return slabs;
}

}  // namespace index_boolean_bench
