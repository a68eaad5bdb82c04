// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Blocks with merged walls: chains do not grow, what must stay stays, and a run without a tolerance
// is what it was.
#include "core/near_coplanar.h"
#include "core/wrong_faces.h"

#include <vcg_ext/exact/coordinate_hash.h>

#include <gtest/gtest.h>

#include <set>

namespace index_boolean {
namespace {

using namespace shapes;

Options merging(double tolerance, OutputScalar scalar = OutputScalar::Double) {
	Options options;
	options.mergeTolerance = tolerance;
	options.outputScalar = scalar;
	return options;
}

Mesh meshOf(const Block& block) {
	Mesh m;
	m.points = block.points;
	m.triangles = block.triangles;
	m.faux = block.faux;
	return m;
}

Mesh stored(Mesh m, OutputScalar scalar) {
	for (Point& p : m.points) {
		for (double& c : p) {
			c = scalar == OutputScalar::Float ? static_cast<double>(static_cast<float>(c)) : c;
		}
	}
	return m;
}

// A cube with the middle 0, turned anyhow.
Mesh turnedCube(std::mt19937& random) {
	return placed(box({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}), random, 0);
}

}  // namespace

// Each of the cubes cuts six planes into the ball that is left; its corners have three faces. So
// there are 6 k polygons, and with Euler's formula 2 (6 k - 2) corners and twice as many triangles.
TEST(MergeWalls, turnedCubesHaveThePolygonsOfTheirPlanes) {
	for (const OutputScalar scalar : {OutputScalar::Double, OutputScalar::Float}) {
		std::mt19937 random(3);
		const double tolerance = scalar == OutputScalar::Float ? 4e-7 : 2e-12;
		Mesh ball = stored(turnedCube(random), scalar);
		for (std::size_t k = 2; k <= 12; ++k) {
			const BooleanRun r =
			    run(ball, stored(turnedCube(random), scalar), merging(tolerance, scalar));
			ASSERT_TRUE(r.status.ok()) << describe(r.status);
			const Block& block = r.block(Operation::Intersection);
			EXPECT_EQ(block.certificate.count(), 0);
			EXPECT_EQ(faultsOf(block.points, block.triangles), 0U);
			EXPECT_EQ(block.triangles.size(), 4 * (6 * k - 2) - 4) << "step " << k;
			ball = meshOf(block);
		}
	}
}

TEST(MergeWalls, withoutAToleranceNothingIsTakenAway) {
	std::mt19937 random(4);
	const Mesh a = shaken(squaredCube(3, random), 1e-13, random);
	const BooleanRun r = run(a, turnedCube(random), merging(0));
	for (const Block& block : r.blocks) {
		EXPECT_EQ(block.wallMerge.vertices, 0U);
		EXPECT_EQ(block.wallMerge.largestMove, 0);
		for (const StageTime& time : block.stageTimes) {
			EXPECT_NE(std::string(time.stage), "merge_walls");
		}
	}
}

// What is not merged keeps its bits, and each element its source.
TEST(MergeWalls, verticesThatStayAreThoseOfTheirSources) {
	std::mt19937 random(5);
	const BooleanRun r = run(shaken(squaredCube(4, random), 1e-13, random),
	                         placed(squaredCube(3, random), random, 0.3), merging(1e-11));
	for (const Block& block : r.blocks) {
		EXPECT_GT(block.wallMerge.vertices, 0U);
		ASSERT_EQ(block.points.size(), block.vertexSource.size());
		ASSERT_EQ(block.triangles.size(), block.faceSource.size());
		for (std::size_t v = 0; v < block.points.size(); ++v) {
			EXPECT_EQ(block.points[v], r.arrangement.coordinates(block.vertexSource[v]));
		}
		// A face's source lies in the plane that the face lies in, with its front the same way.
		for (std::size_t f = 0; f < block.triangles.size(); ++f) {
			const IndexTriangle& t = block.triangles[f];
			const FaceSource& source = block.faceSource[f];
			const Triangle& s = at(r.arrangement.mesh.triangles, source.face);
			const Points& points = r.arrangement.mesh.points;
			const auto normal = [](const Point& a, const Point& b, const Point& c) {
				std::array<double, 3> n{};
				for (std::size_t i = 0; i < 3; ++i) {
					const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
					n[i] = (b[j] - a[j]) * (c[k] - a[k]) - (b[k] - a[k]) * (c[j] - a[j]);
				}
				const double length = std::hypot(n[0], n[1], n[2]);
				return std::array<double, 3>{n[0] / length, n[1] / length, n[2] / length};
			};
			const auto n = normal(block.points[t[0]], block.points[t[1]], block.points[t[2]]);
			const auto m = normal(at(points, s[0]), at(points, s[1]), at(points, s[2]));
			EXPECT_NEAR(n[0] * m[0] + n[1] * m[1] + n[2] * m[2], source.turned ? -1 : 1, 1e-6);
		}
	}
}

TEST(MergeWalls, facesOfOtherClassesStayApart) {
	std::mt19937 random(6);
	const Mesh a = squaredCube(4, random), b = box({0.5, 0.25, 0.5}, {2, 0.75, 2});
	for (const bool isClassed : {false, true}) {
		MeshArrays input = arrays(a, b);
		if (isClassed) {  // by columns of squares
			input.faceClass = {classesByHalf(a, 1, 0, 1), std::vector<std::uint32_t>(12, 2)};
		}
		Monitor monitor;
		Arrangement arrangement;
		ASSERT_TRUE(arrange(std::move(input), merging(1e-9), monitor, arrangement).ok());
		Block block;
		ASSERT_TRUE(extractBlock(arrangement, Operation::FirstMinusSecond, monitor, block).ok());
		std::size_t atSeam = 0;
		for (const Point& p : block.points) {
			atSeam += p[1] == 0.5 ? 1 : 0;
		}
		EXPECT_EQ(atSeam, isClassed ? 5U : 0U);  // of an L, but for its inner corner
		EXPECT_EQ(block.certificate.count(), 0);
	}
}

// Quads of a layer stay quads, and their corners stay.
TEST(MergeWalls, polygonsStayPolygons) {
	std::mt19937 random(7);
	Mesh cube = box({0, 0, 0}, {1, 1, 1});
	for (const IndexTriangle& t : cube.triangles) {
		std::uint8_t mask = 0;
		for (std::size_t i = 0; i < 3; ++i) {
			const Point &p = cube.points[t[i]], &q = cube.points[t[(i + 1) % 3]];
			const int differ =
			    (p[0] != q[0] ? 1 : 0) + (p[1] != q[1] ? 1 : 0) + (p[2] != q[2] ? 1 : 0);
			if (differ == 2) {
				markFaux(mask, i);
			}
		}
		cube.faux.push_back(mask);
	}
	Mesh column = cube;  // of two storeys, whose walls stay apart
	for (const Point& p : cube.points) {
		column.points.push_back({p[0], p[1], p[2] + 1});
	}
	column.triangles.clear();
	column.faux.clear();
	for (std::uint32_t storey = 0; storey < 2; ++storey) {
		for (std::size_t f = 0; f < cube.triangles.size(); ++f) {
			const IndexTriangle& t = cube.triangles[f];
			const double z = cube.points[t[0]][2];
			const bool isLevel = z == cube.points[t[1]][2] && z == cube.points[t[2]][2];
			if (!isLevel || (z == 1) == (storey == 1)) {
				column.triangles.push_back(
				    {t[0] + 8 * storey, t[1] + 8 * storey, t[2] + 8 * storey});
				column.faux.push_back(cube.faux[f]);
			}
		}
	}
	const BooleanRun r = run(column, box({5, 5, 5}, {6, 6, 6}), merging(1e-9));
	ASSERT_TRUE(r.status.ok()) << describe(r.status);
	const Block& block = r.block(Operation::FirstMinusSecond);
	EXPECT_EQ(block.triangles.size(), 20U);
	EXPECT_EQ(std::count_if(block.faux.begin(), block.faux.end(),
	                        [](std::uint8_t mask) { return mask != 0; }),
	          20);
}

TEST(MergeWalls, isTheSameInAnyNumberingAndForAnyThreads) {
	std::mt19937 random(8);
	for (int i = 0; i < 6; ++i) {
		const OutputScalar scalar = i % 2 == 0 ? OutputScalar::Double : OutputScalar::Float;
		Options options = merging(scalar == OutputScalar::Float ? 1e-6 : 1e-12, scalar);
		const Mesh a = stored(placed(squaredCube(5, random), random, 1), scalar);
		const Mesh b = stored(placed(squaredCube(4, random), random, 1), scalar);
		const BooleanRun r = run(a, b, options);
		for (const int threads : {1, 2, 3}) {
			options.threads = threads;
			const BooleanRun other = run(permuted(b, random), permuted(a, random), options);
			EXPECT_EQ(geometry(other.block(Operation::Union)), geometry(r.block(Operation::Union)));
			EXPECT_EQ(geometry(other.block(Operation::Intersection)),
			          geometry(r.block(Operation::Intersection)));
			EXPECT_EQ(geometry(other.block(Operation::SecondMinusFirst)),
			          geometry(r.block(Operation::FirstMinusSecond)));
		}
	}
}

// Without a search nothing is told of faces that hold, but what is merged is searched all the same.
TEST(MergeWalls, isSafeWithoutACertificate) {
	std::mt19937 random(9);
	Options options = merging(1e-11);
	options.certify = false;
	const BooleanRun r =
	    run(shaken(squaredCube(4, random), 1e-13, random), turnedCube(random), options);
	for (const Block& block : r.blocks) {
		EXPECT_FALSE(block.certificate.isKnown);
		EXPECT_GT(block.wallMerge.vertices, 0U);
		EXPECT_EQ(faultsOf(block.points, block.triangles), 0U);
	}
}

}  // namespace index_boolean
