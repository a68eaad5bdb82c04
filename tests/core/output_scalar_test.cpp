// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Hosts in float and in double are given the same surfaces: the scalar changes how points are
// rounded and, since triangles are as round as the stored places allow, the diagonals within an
// input face; nothing else until rounded points are cleaned.
#include "core/shapes.h"

#include <vcg_ext/exact/nearest_float.h>
#include <vcg_ext/solids/manifold_copies.h>
#include <vcg_ext/solids/merge_fragments.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace index_boolean {
namespace {

using namespace shapes;

Mesh inFloat(Mesh mesh) {
	for (Point& p : mesh.points) {
		for (double& c : p) {
			c = static_cast<double>(static_cast<float>(c));
		}
	}
	return mesh;
}

// A block as it is before its points are cleaned.
Block uncleaned(const Arrangement& arrangement, Operation operation) {
	Monitor monitor;
	Block block;
	EXPECT_TRUE(collectBlock(arrangement, operation, monitor, block).ok());
	EXPECT_TRUE(copyNonManifold(arrangement, monitor, block).ok());
	EXPECT_TRUE(mergeFragments(arrangement, monitor, block).ok());
	return block;
}

// Half an ulp of the float away from the exact point, which is half an ulp of the double away.
bool isRoundedOnce(const Point& inFloatOnce, const Point& inDouble) {
	for (std::size_t k = 0; k < 3; ++k) {
		const auto f = static_cast<float>(inFloatOnce[k]);
		const float next = std::nextafter(std::fabs(f), std::numeric_limits<float>::infinity());
		const double ulp = static_cast<double>(next) - static_cast<double>(std::fabs(f));
		if (static_cast<double>(f) != inFloatOnce[k] ||
		    std::fabs(inFloatOnce[k] - inDouble[k]) > (0.5 + std::ldexp(1.0, -20)) * ulp) {
			return false;
		}
	}
	return true;
}

// How many of a block's faces are parts of each input face, by that and by which way they face.
std::map<std::pair<FaceId, bool>, std::size_t> facesPerSource(const Block& block) {
	std::map<std::pair<FaceId, bool>, std::size_t> counts;
	for (std::size_t f = 0; f < block.faceSource.size(); ++f) {
		++counts[{block.faceSource[f].face, block.faceSource[f].turned}];
	}
	return counts;
}

// Copies of a vertex are numbered as faces use them.
std::vector<std::pair<std::uint32_t, Point>> pointsBySource(const Block& block) {
	std::vector<std::pair<std::uint32_t, Point>> points;
	for (std::size_t v = 0; v < block.points.size(); ++v) {
		points.emplace_back(block.vertexSource[v].value, block.points[v]);
	}
	std::sort(points.begin(), points.end());
	return points;
}

void expectSameBlock(const Block& inDouble, const Block& inFloats) {
	EXPECT_EQ(facesPerSource(inDouble), facesPerSource(inFloats))
	    << operationName(inDouble.operation);
	const auto named = pointsBySource(inDouble), rounded = pointsBySource(inFloats);
	ASSERT_EQ(named.size(), rounded.size());
	for (std::size_t i = 0; i < named.size(); ++i) {
		ASSERT_EQ(named[i].first, rounded[i].first);
		ASSERT_TRUE(isRoundedOnce(rounded[i].second, named[i].second)) << "point " << i;
	}
}

std::array<BooleanRun, 2> runInBoth(const Mesh& a, const Mesh& b) {
	Options inDouble;
	inDouble.certify = false;  // points are where rounding puts them
	Options inFloats = inDouble;
	inFloats.outputScalar = OutputScalar::Float;
	return {run(a, b, inDouble), run(a, b, inFloats)};
}

TEST(OutputScalar, changesDiagonalsOnlyBeforePointsAreCleaned) {
	std::mt19937 random(41);
	std::size_t cleaned = 0;
	for (int i = 0; i < 12; ++i) {
		const double nearness = std::ldexp(1.0, -2 * i);  // down to an ulp of float
		const Mesh a = inFloat(sphere(12, {0, 0, 0}, 1));
		const Mesh b = inFloat(sphere(12, {nearness, nearness / 3, nearness / 7}, 1));
		const std::array<BooleanRun, 2> runs = runInBoth(a, permuted(b, random));
		ASSERT_TRUE(runs[0].status.ok() && runs[1].status.ok()) << describe(runs[1].status);
		for (int k = 0; k < kOperationCount; ++k) {
			const auto operation = static_cast<Operation>(k);
			expectSameBlock(uncleaned(runs[0].arrangement, operation),
			                uncleaned(runs[1].arrangement, operation));
			cleaned += runs[1].block(operation).zeroAreaFacesRemoved;
		}
	}
	EXPECT_GT(cleaned, 0u) << "no pair shows what happens before cleaning";
}

// As midpoints are made. A cast in place of the call fails here, compiled by GCC 12 at -O3.
TEST(OutputScalar, eachCoordinateOfAPointIsRounded) {
	std::mt19937 random(7);
	std::uniform_real_distribution<float> unit(-1, 1);
	for (int i = 0; i < 100; ++i) {
		Point a{}, b{}, m{};
		for (std::size_t k = 0; k < 3; ++k) {
			a[k] = static_cast<double>(unit(random));
			b[k] = static_cast<double>(unit(random));
		}
		for (std::size_t k = 0; k < 3; ++k) {
			m[k] = nearestFloat(a[k] / 2 + b[k] / 2);
		}
		for (const double x : m) {
			const volatile float stored = static_cast<float>(x);
			ASSERT_EQ(static_cast<double>(stored), x);
		}
	}
}

TEST(OutputScalar, changesDiagonalsOnlyWhereNothingIsCleaned) {
	std::mt19937 random(43);
	std::size_t compared = 0;
	for (int i = 0; i < 20; ++i) {
		const Mesh a = inFloat(placed(sphere(16, {0, 0, 0}, 1), random, 0.4));
		const Mesh b = inFloat(placed(torus(24, 12, 1, 0.3), random, 0.4));
		const std::array<BooleanRun, 2> runs = runInBoth(a, b);
		ASSERT_TRUE(runs[0].status.ok() && runs[1].status.ok()) << describe(runs[1].status);
		for (int k = 0; k < kOperationCount; ++k) {
			const auto operation = static_cast<Operation>(k);
			const Block &inDouble = runs[0].block(operation), &inFloats = runs[1].block(operation);
			if (inDouble.zeroAreaFacesRemoved + inFloats.zeroAreaFacesRemoved == 0) {
				expectSameBlock(inDouble, inFloats);
				++compared;
			}
		}
	}
	EXPECT_GT(compared, 50u);
}

}  // namespace
}  // namespace index_boolean
