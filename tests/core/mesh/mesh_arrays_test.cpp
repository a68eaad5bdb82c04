// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shapes.h"

#include <gtest/gtest.h>

#include <vcg_ext/index_boolean.h>

#include <limits>
#include <optional>
#include <random>

namespace {

using namespace index_boolean;
using shapes::Mesh;

Status join(const Mesh& a, const Mesh& b, int threads, MeshArrays& out) {
	Monitor monitor;
	return joinSurfaces({viewOf(a.points, a.triangles), viewOf(b.points, b.triangles)}, threads,
	                    monitor, out);
}

TEST(JoinSurfaces, arraysAreThoseOfBothOperandsForAnyThreads) {
	const Mesh large = shapes::sphere(200, {0, 0, 0}, 1);  // of several chunks
	const Mesh small = shapes::box({0, 0, 0}, {1, 2, 3});
	for (const int threads : {1, 2, 5}) {
		for (const auto& [a, b] : {std::pair(large, small), std::pair(small, large)}) {
			const MeshArrays expected = shapes::arrays(a, b);
			MeshArrays joined;
			joined.faux = {1};  // is replaced
			ASSERT_TRUE(join(a, b, threads, joined).ok());
			EXPECT_EQ(joined.points, expected.points);
			EXPECT_EQ(joined.triangles, expected.triangles);
			EXPECT_EQ(joined.vertexOffsets, expected.vertexOffsets);
			EXPECT_EQ(joined.faceOffsets, expected.faceOffsets);
			EXPECT_TRUE(joined.faux.empty());
		}
	}
}

TEST(JoinSurfaces, aCornerThatNamesNoPointIsFoundLater) {
	const Mesh good = shapes::box({0, 0, 0}, {1, 1, 1});
	for (const std::uint32_t bad : {8u, 9u, std::numeric_limits<std::uint32_t>::max() - 7}) {
		Mesh broken = good;
		broken.triangles[5][2] = bad;
		for (const int operand : {0, 1}) {
			MeshArrays joined;
			ASSERT_TRUE(
			    (operand == 0 ? join(broken, good, 0, joined) : join(good, broken, 0, joined))
			        .ok());
			Monitor monitor;
			Arrangement arrangement;
			const Status status = arrange(joined, {}, monitor, arrangement);
			EXPECT_EQ(status.code, StatusCode::IndexOutOfRange);
			EXPECT_EQ(status.operand, operand);
			EXPECT_EQ(status.faces, std::vector<std::uint32_t>{5});
		}
	}
}

TEST(JoinSurfaces, moreThanIdsCanCountIsRefusedUnread) {
	constexpr std::size_t kHalf = std::size_t{1} << 30;
	const SurfaceView points{nullptr, kHalf, nullptr, 0}, faces{nullptr, 0, nullptr, kHalf};
	Monitor monitor;
	MeshArrays joined;
	for (const SurfaceView& view : {points, faces}) {
		const Status status = joinSurfaces({view, view}, 0, monitor, joined);
		EXPECT_EQ(status.code, StatusCode::TooLarge);
		EXPECT_EQ(status.count, 2 * kHalf);
	}
}

TEST(HugeVector, aCountBeyondAllMemoryIsAnExceptionNotAShortArray) {
	HugeVector<Point> points;
	EXPECT_ANY_THROW(points.resize(points.max_size() + 1));
	EXPECT_ANY_THROW(HugeAllocator<Point>{}.allocate(std::numeric_limits<std::size_t>::max() / 8));
	EXPECT_TRUE(points.empty());
}

TEST(HugeVector, newItemsHaveAValueUnlessTheyAreForOverwrite) {
	constexpr std::size_t kCount = std::size_t{1} << 20;
	const PageReuse pages;
	for (int i = 0; i < 2; ++i) {
		HugeVector<std::uint64_t>(kCount, 7);  // leaves its memory to the next
		HugeVector<std::uint64_t> counted(kCount);
		EXPECT_EQ(std::count(counted.begin(), counted.end(), 0u), kCount);
		HugeVector<std::uint64_t> resized(3, 5);
		resized.resize(kCount);
		EXPECT_EQ(std::count(resized.begin(), resized.end(), 0u), kCount - 3);
		resized.resize(2);
		resized.emplace_back();
		EXPECT_EQ(resized, (HugeVector<std::uint64_t>{5, 5, 0}));
		resized.resizeForOverwrite(kCount);
		EXPECT_EQ(resized.size(), kCount);
		EXPECT_EQ(resized[1], 5u);
		EXPECT_EQ(HugeVector<std::uint64_t>::forOverwrite(kCount).size(), kCount);
	}
}

// Whatever is kept and divided, no two arrays that live share a byte, and none lose one.
TEST(PageReuse, arraysKeepWhatTheyHoldWhileMemoryGoesRound) {
	std::mt19937 random(7);
	const PageReuse outer;
	std::vector<HugeVector<std::uint32_t>> live(12);
	for (int round = 0; round < 200; ++round) {
		const std::optional<PageReuse> inner =
		    round % 3 == 0 ? std::optional<PageReuse>(std::in_place) : std::nullopt;
		const std::size_t i = random() % live.size();
		for (const std::uint32_t value : live[i]) {
			ASSERT_EQ(value, i * 1000003);
		}
		live[i] = HugeVector<std::uint32_t>::forOverwrite(random() % (std::size_t{3} << 19));
		std::fill(live[i].begin(), live[i].end(), static_cast<std::uint32_t>(i * 1000003));
	}
}

#if defined(__linux__) && !defined(INDEX_BOOLEAN_HEAP_ONLY)
TEST(PageReuse, givesTheSameMemoryAgain) {
	constexpr std::size_t kCount = std::size_t{1} << 20;
	const PageReuse pages;
	const void* first = HugeVector<std::uint64_t>::forOverwrite(kCount).data();
	EXPECT_EQ(HugeVector<std::uint64_t>::forOverwrite(kCount).data(), first);
	EXPECT_EQ(reinterpret_cast<std::uintptr_t>(first) % 4096, 0u);
}
#endif

TEST(JoinSurfaces, takesThreeOperands) {
	const Mesh box = shapes::box({0, 0, 0}, {1, 1, 1});
	const SurfaceView view = viewOf(box.points, box.triangles);
	Monitor monitor;
	MeshArrays joined;
	ASSERT_TRUE(joinSurfaces({view, view, view}, 0, monitor, joined).ok());
	EXPECT_EQ(joined.vertexOffsets, (OperandOffsets{8, 16, 24}));
	EXPECT_EQ(joined.faceOffsets, (OperandOffsets{12, 24, 36}));
	EXPECT_EQ(joined.operands().count(), 3u);
	EXPECT_EQ(joined.faceClass.size(), 3u);
	for (std::uint32_t f = 0; f < joined.triangles.size(); ++f) {
		const OperandId operand = joined.operandOf({f});
		EXPECT_EQ(operand.value, f / 12);
		EXPECT_EQ(joined.triangles[f][0].value / 8, operand.value);
	}
}

TEST(OperandOffsets, ofOperandsWithoutElementsNameNone) {
	OperandOffsets offsets(4);
	EXPECT_EQ(offsets.total(), 0u);
	offsets.setEnd({1}, 5);
	offsets.setEnd({3}, 7);
	EXPECT_EQ(offsets, (OperandOffsets{0, 5, 5, 7}));
	EXPECT_EQ(offsets.operandOf(0), OperandId{1});
	EXPECT_EQ(offsets.operandOf(4), OperandId{1});
	EXPECT_EQ(offsets.operandOf(5), OperandId{3});
	EXPECT_EQ(offsets.begin({3}), 5u);
	EXPECT_EQ(offsets.size({2}), 0u);
}

}  // namespace
