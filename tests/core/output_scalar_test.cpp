// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Hosts in float and in double are given the same blocks: the scalar changes how points are
// rounded, and nothing else until rounded points are cleaned.
#include "core/shapes.h"

#include <vcg_ext/solids/manifold_copies.h>
#include <vcg_ext/solids/merge_fragments.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

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

void expectSameBlock(const Block& inDouble, const Block& inFloats) {
	EXPECT_EQ(inDouble.triangles, inFloats.triangles) << operationName(inDouble.operation);
	EXPECT_EQ(inDouble.vertexSource, inFloats.vertexSource);
	ASSERT_EQ(inDouble.points.size(), inFloats.points.size());
	for (std::size_t i = 0; i < inDouble.points.size(); ++i) {
		ASSERT_TRUE(isRoundedOnce(inFloats.points[i], inDouble.points[i])) << "point " << i;
	}
}

std::array<BooleanRun, 2> runInBoth(const Mesh& a, const Mesh& b) {
	Options inFloats;
	inFloats.outputScalar = OutputScalar::Float;
	return {run(a, b), run(a, b, inFloats)};
}

TEST(OutputScalar, changesNoConnectivityBeforePointsAreCleaned) {
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

TEST(OutputScalar, changesNoConnectivityAtAllWhereNothingIsCleaned) {
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
