// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whole runs where a number type ends or the host has changed how it computes: the same triangles
// as in the middle of the range. And operands whose defects only winding numbers show.
#include "core/fp_environment.h"
#include "core/shapes.h"
#include "support/stored_faces.h"

#include <gtest/gtest.h>

#include <mutex>

namespace index_boolean {
namespace {

using namespace shapes;

// Their edges cross in points with integer coordinates.
const Mesh kBoxA = box({0, 0, 0}, {4, 4, 4});
const Mesh kBoxB = box({1, 2, 3}, {5, 6, 7});
const Mesh kBesideA = box({4, 1, 1}, {6, 3, 3});

Mesh scaled(Mesh m, double by) {
	for (Point& p : m.points) {
		for (double& c : p) {
			c *= by;
		}
	}
	return m;
}

void expectKeptPromises(const BooleanRun& r) {
	ASSERT_TRUE(r.status.ok()) << describe(r.status);
	for (const Block& block : r.blocks) {
		EXPECT_EQ(brokenPromise(block), "") << operationName(block.operation);
	}
}

// The same triangles, once the first run's are `by` times as large.
void expectSameGeometry(const BooleanRun& one, const BooleanRun& other, double by = 1) {
	ASSERT_EQ(one.blocks.size(), other.blocks.size());
	for (std::size_t k = 0; k < one.blocks.size(); ++k) {
		Block expected = one.blocks[k];
		expected.points = scaled({expected.points, {}}, by).points;
		EXPECT_EQ(geometry(expected), geometry(other.blocks[k]))
		    << operationName(expected.operation);
	}
}

TEST(Extremes, powersOfTwoFromTheSmallestNumberOnGiveTheSameTriangles) {
	for (const Mesh& other : {kBoxB, kBesideA, kBoxA}) {
		const BooleanRun reference = run(kBoxA, other);
		expectKeptPromises(reference);
		for (const double size : {0x1p-1074, 0x1p-1030, 0x1p-1000, 0x1p-100, 0x1p100, 0x1p1020}) {
			SCOPED_TRACE(size);
			const BooleanRun r = run(scaled(kBoxA, size), scaled(other, size));
			expectKeptPromises(r);
			expectSameGeometry(reference, r, size);
		}
	}
}

// Each operand's volume is a double, their union's is not: no law tells anything of it.
TEST(Extremes, volumesBeyondTheRangeOfDoubleLeaveTheLawsAside) {
	constexpr double kSide = 4.9e102;
	const BooleanRun r =
	    run(box({0, 0, 0}, {kSide, kSide, kSide}), box({kSide, 0, 0}, {2 * kSide, kSide, kSide}));
	expectKeptPromises(r);
	EXPECT_EQ(r.audit.blocks[0].volume, HUGE_VAL);
	EXPECT_LT(r.audit.blocks[2].volume, HUGE_VAL);
	EXPECT_EQ(r.audit.volumeLawResidual, 0);
}

TEST(Extremes, volumesBeyondTheRangeOfDoubleLeaveTheLawsOfASplitAside) {
	constexpr double kSide = 4.9e102;
	Monitor monitor;
	Arrangement arrangement;
	Split parts;
	SplitAudit measured;
	const Mesh a = box({0, 0, 0}, {2 * kSide, kSide, kSide});
	const Mesh b = box({kSide, 0, 0}, {3 * kSide, kSide, kSide});
	ASSERT_TRUE(arrangeSurfaces(arrays(a, b), {}, monitor, arrangement).ok());
	ASSERT_TRUE(split(arrangement, monitor, parts).ok());
	ASSERT_EQ(parts.blocks.all.size(), 3u);
	EXPECT_FALSE(std::isfinite(arrangement.volume[kFirst]));
	ASSERT_TRUE(audit(arrangement, parts, {}, monitor, measured).ok());
	EXPECT_EQ(measured.volumeLawResidual, 0);
}

// Rounded sizes: edges that crossed now pass each other closely.
TEST(Extremes, otherSizesKeepTheirPromises) {
	constexpr double kLargest = std::numeric_limits<double>::max() / 8;
	for (const double size : {1e-320, 1e-310, 1e-300, 1e-30, 1e30, 1e300, kLargest}) {
		SCOPED_TRACE(size);
		const BooleanRun r = run(scaled(kBoxA, size), scaled(kBoxB, size));
		expectKeptPromises(r);
		const double unit = std::ldexp(1, -std::ilogb(size));  // may be a little off the size
		const Block& both = r.block(Operation::Intersection);
		const Mesh large = scaled({both.points, both.triangles}, unit < HUGE_VAL ? unit : 0x1p1023);
		const double by = size * (unit < HUGE_VAL ? unit : 0x1p1023);
		EXPECT_NEAR(volumeOf(large.points, large.triangles), 6 * by * by * by, 1e-2 * by * by * by);
	}
}

TEST(Extremes, floatsFromTheSmallestOnGiveTheSameTriangles) {
	Options options;
	options.outputScalar = OutputScalar::Float;
	const BooleanRun reference = run(kBoxA, kBoxB, options);
	for (const double size : {0x1p-149, 0x1p-100, 0x1p100, 0x1p124}) {
		SCOPED_TRACE(size);
		const BooleanRun r = run(scaled(kBoxA, size), scaled(kBoxB, size), options);
		expectKeptPromises(r);
		expectSameGeometry(reference, r, size);
	}
}

// Below half of the smallest float, nothing of a block is left.
TEST(Extremes, blocksThatRoundToOnePointAreEmpty) {
	Options options;
	options.outputScalar = OutputScalar::Float;
	const BooleanRun r = run(scaled(kBoxA, 1e-100), scaled(kBoxB, 1e-100), options);
	expectKeptPromises(r);
	for (const Block& block : r.blocks) {
		EXPECT_TRUE(block.triangles.empty());
	}
}

TEST(Extremes, aSmallOperandInAHugeOneIsNotLost) {
	const BooleanRun r =
	    run(box({-1e300, -1e300, -1e300}, {1e300, 1e300, 1e300}), scaled(kBoxB, 1e-300));
	expectKeptPromises(r);
	EXPECT_EQ(r.block(Operation::Union).triangles.size(), 12u);
	EXPECT_EQ(r.block(Operation::Intersection).triangles.size(), 12u);
	EXPECT_EQ(r.block(Operation::FirstMinusSecond).triangles.size(), 24u);
	EXPECT_TRUE(r.block(Operation::SecondMinusFirst).triangles.empty());
}

TEST(Extremes, operandsFarFromTheOriginHaveExactVolumes) {
	const BooleanRun reference = run(kBoxA, kBoxB);
	Mesh a = kBoxA, b = kBoxB;
	for (Mesh* m : {&a, &b}) {
		for (Point& p : m->points) {
			for (double& c : p) {
				c += 4e6;  // 1e6 sizes
			}
		}
	}
	const BooleanRun far = run(a, b);
	expectKeptPromises(far);
	EXPECT_EQ(far.block(Operation::Union).triangles.size(),
	          reference.block(Operation::Union).triangles.size());
	EXPECT_DOUBLE_EQ(far.volume(Operation::Intersection), 3 * 2 * 1);
}

TEST(Extremes, negativeZeroOfOneOperandIsZeroOfTheOther) {
	const Mesh below = box({0, 0, -2}, {4, 4, 0});
	Mesh negative = below;
	for (Point& p : negative.points) {
		for (double& c : p) {
			c = c == 0 ? -0.0 : c;
		}
	}
	const BooleanRun reference = run(kBoxA, below), r = run(kBoxA, negative);
	expectKeptPromises(r);
	expectSameGeometry(reference, r);
	EXPECT_TRUE(r.block(Operation::Intersection).triangles.empty());
}

TEST(Extremes, facesWithTwoEqualCornersAreDropped) {
	Mesh m = kBoxA;
	m.points.push_back(m.points[1]);  // a seam: two vertices in one place
	m.triangles.insert(m.triangles.begin(), std::array<std::uint32_t, 3>{0, 0, 5});
	m.triangles.push_back({1, 8, 7});
	m.triangles.push_back({3, 3, 3});
	const BooleanRun reference = run(kBoxA, kBoxB), r = run(m, kBoxB);
	expectKeptPromises(r);
	expectSameGeometry(reference, r);
}

// What a thread finds after a run.
struct Environment {
	int rounding = FE_TONEAREST;
	bool isDefault = true;
};

std::vector<Environment> environmentsOfAllThreads(int threads) {
	std::mutex mutex;
	std::vector<Environment> found;
	onAllThreads(threads, [&] {
		const Environment here{std::fegetround(), environmentIsDefault()};
		const std::lock_guard<std::mutex> lock(mutex);
		found.push_back(here);
	});
	return found;
}

TEST(FloatingPointEnvironment, ofTheHostChangesNoByteAndIsGivenBack) {
	std::mt19937 random(5);
	const Mesh a = placed(sphere(120, {0, 0, 0}, 1), random, 0.1);
	const Mesh b = placed(torus(200, 100, 1, 0.4), random, 0.3);
	constexpr int kThreads = 2;
	Options options;
	options.threads = kThreads;
	const BooleanRun reference = run(a, b, options);
	expectKeptPromises(reference);
	spoilEnvironmentOfAllThreads(kThreads);
	const BooleanRun r = run(a, b, options);
	const std::vector<Environment> after = environmentsOfAllThreads(kThreads);
	restoreEnvironmentOfAllThreads(kThreads);
	for (const Environment& thread : after) {
		EXPECT_EQ(thread.rounding, FE_UPWARD);
		EXPECT_FALSE(thread.isDefault);
	}
	ASSERT_TRUE(r.status.ok()) << describe(r.status);
	for (std::size_t k = 0; k < r.blocks.size(); ++k) {
		EXPECT_EQ(r.blocks[k].triangles, reference.blocks[k].triangles);
		EXPECT_EQ(r.blocks[k].points, reference.blocks[k].points);
		EXPECT_EQ(r.audit.blocks[k].volume, reference.audit.blocks[k].volume);
		EXPECT_EQ(r.audit.blocks[k].area, reference.audit.blocks[k].area);
	}
	EXPECT_EQ(r.audit.volumeLawResidual, reference.audit.volumeLawResidual);
}

// Where the solid is entered twice, every law of volumes holds and the result would be wrong.
TEST(OverlapsInOneOperand, thatOnlyWindingNumbersShowAreRefusedWithTheirFaces) {
	const Mesh nested = joined(box({0, 0, 0}, {10, 10, 10}), box({2, 2, 2}, {6, 6, 6}));
	const Mesh inInner = box({5, 3, 3}, {7, 4, 4});
	const Mesh crossing = joined(box({0, 0, 0}, {4, 4, 4}), box({3, -1, -1}, {9, 5, 5}));
	const Mesh inBoth = box({3.5, 1, 1}, {5, 2, 2});
	struct Case {
		const Mesh& bad;
		const Mesh& good;
		StatusCode code;
	};
	for (const Case& c : {Case{nested, inInner, StatusCode::NestedComponents},
	                      Case{crossing, inBoth, StatusCode::SelfIntersecting}}) {
		for (const int operand : {0, 1}) {
			const BooleanRun r = operand == 0 ? run(c.bad, c.good) : run(c.good, c.bad);
			EXPECT_EQ(r.status.code, c.code) << statusName(r.status.code);
			EXPECT_EQ(r.status.operand, operand);
			EXPECT_GT(r.status.count, 0u);
			ASSERT_FALSE(r.status.faces.empty());
			EXPECT_LT(r.status.faces.back(), c.bad.triangles.size());
		}
	}
}

}  // namespace
}  // namespace index_boolean
