// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whatever the limit of counts, a run is refused as too large where it is reached, or it is as
// without: the limit is lowered to show that.
#include "core/shapes.h"

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace index_boolean {
namespace {

using namespace shapes;

// n bars side by side, in x or in y direction, with their tops and bottoms in common planes.
Mesh bars(int n, bool alongX) {
	Mesh all;
	for (int i = 0; i < n; ++i) {
		const double low = 2 * i + (alongX ? 0.25 : 0.5), high = low + 1;
		const double end = 2 * n + 1;
		all = joined(all, alongX ? box({-1, low, 0}, {end, high, 1})
		                         : box({low, -1, 0}, {high, end, 1}));
	}
	return all;
}

// Runs two meshes under each limit from 0 to the first that suffices.
// \return how many limits each stage has refused
std::map<std::string, int> stagesThatRefuse(const Mesh& a, const Mesh& b) {
	std::map<std::string, int> stages;
	const BooleanRun unlimited = run(a, b);
	EXPECT_TRUE(unlimited.status.ok()) << describe(unlimited.status);
	for (Options options{}; !::testing::Test::HasFailure(); ++options.mostElements) {
		options.mostElements = stages.empty() ? 0 : options.mostElements;
		SCOPED_TRACE("at most " + std::to_string(options.mostElements));
		const BooleanRun limited = run(a, b, options);
		if (limited.status.ok()) {
			for (std::size_t k = 0; k < unlimited.blocks.size(); ++k) {
				EXPECT_EQ(limited.blocks[k].triangles, unlimited.blocks[k].triangles);
			}
			break;
		}
		EXPECT_EQ(limited.status.code, StatusCode::TooLarge);
		EXPECT_GT(limited.status.count, options.mostElements);
		++stages[limited.arrangement.stageTimes.back().stage];
	}
	return stages;
}

TEST(TooLarge, eachStageThatNumbersRefusesWhatItsNumbersCannotTell) {
	const std::map<std::string, int> stages = stagesThatRefuse(bars(2, true), bars(2, false));
	for (const char* stage : {"operands", "curve_points", "cut_lines", "retriangulate"}) {
		EXPECT_EQ(stages.count(stage), 1U) << stage;
	}
	EXPECT_EQ(stages.size(), 4U);
}

TEST(TooLarge, aFaceWithManyPiecesIsRefusedToo) {
	const Mesh plate = box({-10, -10, -10}, {10, 10, 0});
	const std::map<std::string, int> stages = stagesThatRefuse(plate, sphere(16, {0, 0, 0.1}, 8));
	EXPECT_EQ(stages.count("operands"), 1U);
	EXPECT_EQ(stages.count("retriangulate"), 1U);
}

}  // namespace
}  // namespace index_boolean
