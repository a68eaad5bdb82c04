// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Solids of cubes on integer grids, of two sizes: every kind of contact occurs, crossing diagonals
// of coplanar faces, edges on edges, edges with four faces. Volumes are counted, not computed.
#include "core/shapes.h"

#include <gtest/gtest.h>

namespace index_boolean {
namespace {

using namespace shapes;

// Which unit cells of a cube of kSpan cells a side are solid.
constexpr int kSpan = 6;
using Cells = std::array<std::array<std::array<bool, kSpan>, kSpan>, kSpan>;

// Random blocks of the given side length in cells.
Cells randomCells(std::mt19937& random, int side, double share) {
	std::bernoulli_distribution solid(share);
	Cells cells{};
	const int count = kSpan / side;
	for (int x = 0; x < count; ++x) {
		for (int y = 0; y < count; ++y) {
			for (int z = 0; z < count; ++z) {
				const bool filled = solid(random);
				for (int i = 0; i < side * side * side; ++i) {
					cells[static_cast<std::size_t>(x * side + i % side)]
					     [static_cast<std::size_t>(y * side + i / side % side)]
					     [static_cast<std::size_t>(z * side + i / side / side)] = filled;
				}
			}
		}
	}
	return cells;
}

bool cellAt(const Cells& cells, std::array<int, 3> c) {
	for (const int i : c) {
		if (i < 0 || i >= kSpan) {
			return false;
		}
	}
	return cells[static_cast<std::size_t>(c[0])][static_cast<std::size_t>(c[1])]
	            [static_cast<std::size_t>(c[2])];
}

// The surface of the solid blocks of a side length: two triangles per square, along a random
// diagonal.
Mesh surface(const Cells& cells, int side, std::mt19937& random) {
	std::map<Point, std::uint32_t> ids;
	Mesh m;
	const auto vertex = [&](const std::array<int, 3>& p) {
		const Point q{static_cast<double>(p[0]), static_cast<double>(p[1]),
		              static_cast<double>(p[2])};
		const auto [it, isNew] = ids.emplace(q, static_cast<std::uint32_t>(m.points.size()));
		if (isNew) {
			m.points.push_back(q);
		}
		return it->second;
	};
	for (int i = 0; i < kSpan * kSpan * kSpan; ++i) {
		const std::array<int, 3> low{i % kSpan, i / kSpan % kSpan, i / kSpan / kSpan};
		const bool isCorner = low[0] % side == 0 && low[1] % side == 0 && low[2] % side == 0;
		if (!isCorner || !cellAt(cells, low)) {
			continue;
		}
		for (std::size_t axis = 0; axis < 3; ++axis) {
			for (const int direction : {0, 1}) {
				std::array<int, 3> beside = low;
				beside[axis] += direction == 1 ? side : -1;
				if (cellAt(cells, beside)) {
					continue;
				}
				std::array<std::uint32_t, 4> square{};
				for (std::size_t k = 0; k < 4; ++k) {
					std::array<int, 3> corner = low;
					corner[axis] += direction * side;
					corner[(axis + 1) % 3] += (k == 1 || k == 2) ? side : 0;
					corner[(axis + 2) % 3] += k >= 2 ? side : 0;
					square[k] = vertex(corner);
				}
				if (direction == 0) {
					std::swap(square[1], square[3]);
				}
				const std::size_t r = random() % 2;
				m.triangles.push_back({square[r], square[r + 1], square[r + 2]});
				m.triangles.push_back({square[r], square[r + 2], square[(r + 3) % 4]});
			}
		}
	}
	return m;
}

int volumeWhere(const Cells& a, const Cells& b, bool (*keep)(bool, bool)) {
	int count = 0;
	for (std::size_t i = 0; i < kSpan * kSpan * kSpan; ++i) {
		const std::size_t x = i % kSpan, y = i / kSpan % kSpan, z = i / kSpan / kSpan;
		count += keep(a[x][y][z], b[x][y][z]) ? 1 : 0;
	}
	return count;
}

// No two faces of a block on the same three places: no wall of no thickness, none doubled.
void expectNoDoubledFaces(const Block& block) {
	std::map<std::array<Point, 3>, int> faces;
	for (const auto& t : block.triangles) {
		std::array<Point, 3> c{block.points[t[0]], block.points[t[1]], block.points[t[2]]};
		std::sort(c.begin(), c.end());
		EXPECT_EQ(++faces[c], 1) << operationName(block.operation);
	}
}

TEST(VoxelContact, everyBlockHasTheCountedVolumeInAnyOrder) {
	constexpr std::array<bool (*)(bool, bool), 5> kTruth{
	    [](bool a, bool b) { return a || b; }, [](bool a, bool b) { return a && b; },
	    [](bool a, bool b) { return a && !b; }, [](bool a, bool b) { return b && !a; },
	    [](bool a, bool b) { return a != b; }};
	int answered = 0;
	for (std::uint32_t seed = 0; seed < 150; ++seed) {
		SCOPED_TRACE("seed " + std::to_string(seed));
		std::mt19937 random(seed);
		const int sideA = 1 + static_cast<int>(seed % 3),
		          sideB = 1 + static_cast<int>(seed / 3 % 3);
		const Cells a = randomCells(random, sideA, 0.15 + 0.1 * (seed % 7));
		const Cells b = randomCells(random, sideB, 0.15 + 0.1 * (seed % 5));
		const Mesh meshA = surface(a, sideA, random), meshB = surface(b, sideB, random);
		if (meshA.triangles.empty() || meshB.triangles.empty()) {
			continue;
		}
		const BooleanRun r = run(meshA, permuted(meshB, random));
		ASSERT_TRUE(r.status.ok()) << statusName(r.status.code) << ": " << describe(r.status);
		++answered;
		for (std::size_t k = 0; k < kTruth.size(); ++k) {
			EXPECT_NEAR(volumeOf(r.blocks[k].points, r.blocks[k].triangles),
			            volumeWhere(a, b, kTruth[k]), 1e-9)
			    << operationName(r.blocks[k].operation);
			EXPECT_TRUE(isClosed(r.blocks[k].triangles));
			EXPECT_TRUE(isManifold(r.blocks[k].triangles)) << operationName(r.blocks[k].operation);
			expectNoDoubledFaces(r.blocks[k]);
		}
		const BooleanRun other = run(meshB, meshA);
		ASSERT_TRUE(other.status.ok());
		EXPECT_EQ(geometry(r.blocks[0]), geometry(other.blocks[0]));
		EXPECT_EQ(geometry(r.blocks[1]), geometry(other.blocks[1]));
		EXPECT_EQ(geometry(r.blocks[2]), geometry(other.blocks[3]));
		EXPECT_EQ(geometry(r.blocks[4]), geometry(other.blocks[4]));
		if (HasFailure()) {
			return;
		}
	}
	EXPECT_GT(answered, 120);
}

}  // namespace
}  // namespace index_boolean
