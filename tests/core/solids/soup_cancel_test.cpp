// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A large soup is given up soon, whatever is being done with it. Times are of the processor, of one
// thread: other programs on the machine do not count.
#include "core/any_operands.h"

#include <gtest/gtest.h>

#include <ctime>
#include <string>

namespace index_boolean {
namespace {

using namespace shapes;

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define SLOW_BUILD
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || !defined(NDEBUG)
#define SLOW_BUILD
#endif
// Windows has no such times: clock() is the time of day, other programs and all.
#ifdef _WIN32
#define SLOW_BUILD
#endif

#ifdef SLOW_BUILD
constexpr double kLongest = 1;  // seconds
constexpr std::uint32_t kRows = 60;
#else
constexpr double kLongest = 0.1;
constexpr std::uint32_t kRows = 300;
#endif

double processorSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// Two spheres that overlap in one layer, without a common vertex, and a third that crosses both. Of
// one that they are, a part is turned wrongly.
std::vector<Mesh> largeLayers(std::uint32_t rows) {
	Mesh spheres = layer({sphere(rows, {0, 0, 0}, 1), sphere(rows, {0.7, 0.3, 0.1}, 1)});
	for (std::size_t f = 0; f < spheres.triangles.size() / 5; ++f) {
		std::swap(spheres.triangles[f][1], spheres.triangles[f][2]);
	}
	return {soup(spheres), sphere(rows / 2, {0.2, 0.9, 0.3}, 1)};
}

Status arrangeAndUnite(const std::vector<Mesh>& layers, Monitor& monitor) {
	std::vector<SurfaceView> views;
	for (const Mesh& m : layers) {
		views.push_back(viewOf(m.points, m.triangles));
	}
	MeshArrays arrays;
	Arrangement arrangement;
	Block block;
	return inOrder(
	    [&] { return joinSurfaces(views, 1, monitor, arrays); },
	    [&] { return arrangeCells(std::move(arrays), onOneThread(), monitor, arrangement); },
	    [&] { return extractBlock(arrangement, inAny, monitor, block); });
}

TEST(SoupCancel, isAskedForAgainAndAgain) {
	const std::vector<Mesh> layers = largeLayers(kRows);
	double last = processorSeconds(), longest = 0;
	std::string before, where;
	Monitor monitor([&](double, const char* stage) {
		const double now = processorSeconds();
		if (now - last > longest) {
			longest = now - last;
			where = before + " to " + stage;
		}
		last = now;
		before = stage;
		return true;
	});
	ASSERT_TRUE(arrangeAndUnite(layers, monitor).ok());
	EXPECT_LT(longest, kLongest) << where;
}

TEST(SoupCancel, endsARunSoonAtAnyStage) {
	const std::vector<Mesh> layers = largeLayers(kRows / 3);
	std::vector<std::string> stages;
	Monitor listening([&stages](double, const char* stage) {
		if (stages.empty() || stages.back() != stage) {
			stages.push_back(stage);
		}
		return true;
	});
	ASSERT_TRUE(arrangeAndUnite(layers, listening).ok());
	ASSERT_GE(stages.size(), 8U);
	for (std::size_t k = 1; k < stages.size(); k += 3) {
		double asked = 0;
		Monitor monitor([&](double, const char* stage) {
			asked = processorSeconds();
			return stage != stages[k];
		});
		EXPECT_EQ(arrangeAndUnite(layers, monitor).code, StatusCode::Cancelled) << stages[k];
		EXPECT_LT(processorSeconds() - asked, kLongest) << stages[k];
	}
}

}  // namespace
}  // namespace index_boolean
