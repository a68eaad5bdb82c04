// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sub-surfaces, sub-blocks and loops of any two surfaces: laws, counts, and what must not depend on
// how the input is numbered.
#include "shapes.h"

#include <gtest/gtest.h>

namespace index_boolean {
namespace {

using namespace shapes;

struct SplitRun {
	Status status;
	Arrangement arrangement;
	Split split;
	std::array<SplitMesh, 2> surfaces;
	std::vector<SplitMesh> blocks;
};

SplitRun splitOf(const Mesh& a, const Mesh& b, Options options = {}) {
	SplitRun r;
	Monitor monitor;
	r.status = arrangeSurfaces(arrays(a, b), options, monitor, r.arrangement);
	if (r.status.ok()) {
		r.status = split(r.arrangement, monitor, r.split);
	}
	for (std::size_t k = 0; k < 2 && r.status.ok(); ++k) {
		r.status = extractSubSurfaces(r.arrangement, r.split, k, monitor, r.surfaces[k]);
	}
	for (std::uint32_t i = 0; i < r.split.blocks.all.size() && r.status.ok(); ++i) {
		r.blocks.emplace_back();
		r.status = extractSubBlock(r.arrangement, r.split, {i}, monitor, r.blocks.back());
	}
	return r;
}

// An n by m grid of squares over [x0, x1] x [y0, y1], at height z(x, y).
template <class Height>
Mesh sheet(int n, int m, std::array<double, 4> xy, Height&& z) {
	Mesh s;
	for (int i = 0; i <= n; ++i) {
		for (int j = 0; j <= m; ++j) {
			const double x = xy[0] + (xy[1] - xy[0]) * i / n, y = xy[2] + (xy[3] - xy[2]) * j / m;
			s.points.push_back({x, y, z(x, y)});
		}
	}
	const auto id = [m](int i, int j) { return static_cast<std::uint32_t>(i * (m + 1) + j); };
	for (int i = 0; i < n; ++i) {
		for (int j = 0; j < m; ++j) {
			s.triangles.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
			s.triangles.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
		}
	}
	return s;
}

Mesh flatSheet(int n, std::array<double, 4> xy, double height) {
	return sheet(n, n, xy, [height](double, double) { return height; });
}

TEST(Split, sheetThroughBoxGivesTwoBlocks) {
	const SplitRun r = splitOf(box({0, 0, 0}, {1, 1, 1}), flatSheet(3, {-1, 2, -1, 2}, 0.25));
	ASSERT_TRUE(r.status.ok()) << describe(r.status);
	EXPECT_EQ(r.arrangement.loopCounts.hardClosed, 1u);
	EXPECT_EQ(r.split.surfaces.ofOperand[0].size(), 2u);
	EXPECT_EQ(r.split.surfaces.ofOperand[1].size(), 2u);
	ASSERT_EQ(r.blocks.size(), 2u);
	EXPECT_NEAR(r.split.blocks.all[0].volume, 0.25, 1e-14);
	EXPECT_NEAR(r.split.blocks.all[1].volume, 0.75, 1e-14);
	for (const SplitMesh& block : r.blocks) {
		EXPECT_TRUE(isClosed(block.triangles));
	}
}

}  // namespace
}  // namespace index_boolean
