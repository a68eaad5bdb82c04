// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which sides of parts that no edge joins face the same part of space: nested, linked, in rows,
// touching in a vertex, and thinner than coordinates can tell.
#include "core/shapes.h"

#include <gtest/gtest.h>

namespace index_boolean {
namespace {

using namespace shapes;

const Mesh kFarBox = box({100, 100, 100}, {101, 101, 101});

struct SplitRun {
	Status status;
	Arrangement arrangement;
	Split split;

	// Ascending.
	std::vector<double> volumes() const {
		std::vector<double> all;
		for (const SubBlock& block : split.blocks.all) {
			all.push_back(block.volume);
		}
		std::sort(all.begin(), all.end());
		return all;
	}
};

SplitRun splitOf(const Mesh& a, const Mesh& b) {
	SplitRun r;
	Monitor monitor;
	r.status = arrangeSurfaces(arrays(a, b), {}, monitor, r.arrangement);
	if (r.status.ok()) {
		r.status = split(r.arrangement, monitor, r.split);
	}
	EXPECT_TRUE(r.status.ok()) << describe(r.status);
	return r;
}

// Volumes of the sub-blocks, in all ways to turn the axes and to number vertices and faces.
void expectVolumes(const Mesh& a, const Mesh& b, std::vector<double> volumes) {
	std::mt19937 random(3);
	std::sort(volumes.begin(), volumes.end());
	for (std::size_t view = 0; view < 6; ++view) {
		std::array<Mesh, 2> meshes{permuted(a, random), permuted(b, random)};
		const double sign = view < 3 ? 1 : -1;
		for (Mesh& mesh : meshes) {
			for (Point& p : mesh.points) {
				p = {sign * p[view % 3], sign * p[(view + 1) % 3], sign * p[(view + 2) % 3]};
			}
		}
		const std::vector<double> found = splitOf(meshes[0], meshes[1]).volumes();
		ASSERT_EQ(found.size(), volumes.size()) << "view " << view;
		for (std::size_t i = 0; i < found.size(); ++i) {
			EXPECT_NEAR(found[i], volumes[i], 1e-12 * volumes[i]);
		}
	}
}

TEST(SubBlocks, aNeedleThinnerThanAnUlpIsOneCell) {
	const Mesh far = box({0, 0, 0}, {1, 1, 1});
	const SplitRun r = splitOf(shapes::needleThinnerThanAnUlp(), far);
	EXPECT_EQ(r.split.blocks.all.size(), 2u);
	const BooleanRun blocks = run(shapes::needleThinnerThanAnUlp(), far);
	EXPECT_TRUE(blocks.status.ok()) << describe(blocks.status);
}

TEST(SubBlocks, rowsOfCubesAreOneCellEach) {
	for (std::size_t axis = 0; axis < 3; ++axis) {
		Mesh row;
		for (int i = 0; i < 50; ++i) {
			Point low{0, 0, 0}, high{1, 1, 1};
			low[axis] = 2 * i;
			high[axis] = 2 * i + 1;
			row = joined(row, box(low, high));
		}
		const std::vector<double> found = splitOf(row, box({-9, -9, -9}, {-8, -8, -8})).volumes();
		EXPECT_EQ(found, std::vector<double>(51, 1.0));
	}
}

TEST(SubBlocks, nestedShellsAreCellsInEachOther) {
	Mesh shells;
	std::vector<double> volumes{1};
	for (int i = 1; i <= 20; ++i) {
		const double r = i, inner = i - 1;
		const Mesh shell = box({-r, -r, -r}, {r, r, r});
		shells = joined(shells, i % 3 == 0 ? turned(shell) : shell);
		volumes.push_back(8 * (r * r * r - inner * inner * inner));
	}
	expectVolumes(shells, kFarBox, volumes);
}

TEST(SubBlocks, chainsOfLinkedRingsFaceOneOutside) {
	Mesh chain;
	for (int i = 0; i < 5; ++i) {
		Mesh ring = torus(16, 8, 2, 0.25);
		for (Point& p : ring.points) {
			p = i % 2 == 0 ? Point{p[0] + 2.5 * i, p[1], p[2]} : Point{p[0] + 2.5 * i, p[2], -p[1]};
		}
		chain = joined(chain, ring);
	}
	Mesh shell = joined(box({-9, -9, -9}, {20, 9, 9}), box({-10, -10, -10}, {21, 10, 10}));
	const double ring = volumeOf(torus(16, 8, 2, 0.25).points, torus(16, 8, 2, 0.25).triangles);
	std::vector<double> volumes(5, ring);
	volumes.push_back(1);
	expectVolumes(chain, kFarBox, volumes);
	volumes.push_back(29 * 18 * 18 - 5 * ring);
	volumes.push_back(31 * 20 * 20 - 29 * 18 * 18);
	expectVolumes(joined(chain, shell), kFarBox, volumes);
}

Mesh tetrahedron(Point tip, double size, double depth) {
	Mesh m;
	m.points = {tip,
	            {tip[0] - depth, tip[1] - size, tip[2] - size},
	            {tip[0] - depth, tip[1] + size, tip[2] - size},
	            {tip[0] - depth, tip[1], tip[2] + size}};
	m.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
	return volumeOf(m.points, m.triangles) < 0 ? turned(m) : m;
}

// Cones in each other with a common tip, each axis and direction once at the top: no vertex of the
// inner ones need be away from the outer ones.
TEST(SubBlocks, conesInEachOtherWithACommonTip) {
	const double outer = 4 * 4 * 6 * 2 / 3., middle = 2 * 2 * 5 * 2 / 3., inner = 4 * 2 / 3.;
	const Mesh cones = joined(tetrahedron({0, 0, 0}, 4, 6),
	                          joined(tetrahedron({0, 0, 0}, 2, 5), tetrahedron({0, 0, 0}, 1, 4)));
	expectVolumes(cones, kFarBox, {1, inner, middle - inner, outer - middle});
	// Two of them beside each other in the outer one, which tip lies in a cavity.
	Mesh left = tetrahedron({0, 0, 0}, 1, 4), right = left;
	for (std::size_t i = 1; i < 4; ++i) {
		left.points[i][1] -= 1.25;
		right.points[i][1] += 1.25;
	}
	const Mesh pair = joined(tetrahedron({0, 0, 0}, 8, 6), joined(left, right));
	const double all = 8 * 8 * 6 * 2 / 3.;
	const Mesh around = box({-20, -20, -20}, {20, 20, 20});
	expectVolumes(joined(pair, around), kFarBox, {1, inner, inner, all - 2 * inner, 64000 - all});
	// Tip on tip: the one is above the other.
	Mesh mirrored = turned(tetrahedron({0, 0, 0}, 2, 5));
	for (Point& p : mirrored.points) {
		p = {-p[0], p[1], p[2]};
	}
	expectVolumes(joined(cones, mirrored), kFarBox,
	              {1, inner, middle, middle - inner, outer - middle});
}

// A tent of faces that all run along the lines' axis has a top, too.
TEST(SubBlocks, openSheetsPartNothing) {
	Mesh sheet;
	sheet.points = {{0, 0, 0}, {3, 0, 0}, {3, 1, 1}, {0, 1, 1}, {3, -1, 2}, {0, -1, 2}};
	sheet.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 4, 1}, {0, 5, 4}};
	for (const double turn : {0., 1.}) {
		Mesh shell = box({-9, -9, -9}, {9, 9, 9});
		shell = turn > 0 ? turned(shell) : shell;
		expectVolumes(joined(sheet, shell), kFarBox, {1, 18 * 18 * 18});
	}
	expectVolumes(sheet, kFarBox, {1});
}

// A shell touched from inside and outside by vertices, in all places a face has.
TEST(SubBlocks, verticesOnWallsOfTheSameOperand) {
	const Mesh shell = box({0, 0, 0}, {8, 8, 8});
	const double tet = 2 / 3. * 2;
	for (const Point& tip : {Point{8, 4, 4.5}, Point{8, 4, 4}, Point{8, 2, 4}}) {
		const Mesh inside = tetrahedron(tip, 1, 2);
		expectVolumes(joined(shell, inside), kFarBox, {1, tet, 512 - tet});
	}
	for (const Point& tip : {Point{0, 4, 4.5}, Point{0, 4, 4}, Point{0, 2, 4}}) {
		expectVolumes(joined(shell, tetrahedron(tip, 1, 2)), kFarBox, {1, tet, 512});
	}
}

}  // namespace
}  // namespace index_boolean
