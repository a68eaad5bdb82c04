// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The run behind the filters that measure distances, driven through the host's kind of callback.
#include "watched_host.h"

#include <runs/distance_run.h>

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

namespace index_boolean {
namespace {

using namespace watched_host;

MeshArrays unitBox() {
	MeshArrays arrays;
	arrays.vertexOffsets = OperandOffsets(1);
	arrays.faceOffsets = OperandOffsets(1);
	appendBox({0, 0, 0}, {1, 1, 1}, kFirst, arrays);
	return arrays;
}

DistanceRequest searchedRequest() {
	DistanceRequest request;
	request.options.selfIntersections = SelfIntersections::Resolve;
	return request;
}

Status measureWith(int cancelAt, const Points& points, DistanceResult& result) {
	Progress progress = watch(cancelAt);
	return runDistance(unitBox(), points, searchedRequest(), progress, 1, result);
}

TEST(DistanceRun, theHostSeesPercentsThatNeverFallOnItsOwnThread) {
	DistanceResult result;
	ASSERT_TRUE(measureWith(0, {{2, 0.5, 0.5}}, result).ok());
	expectGoodManners();
	for (const char* stage :
	     {"preparing the surface", "building the tree", "measuring distances"}) {
		EXPECT_EQ(seen.stages.count(stage), 1u) << stage;
	}
}

TEST(DistanceRun, aHostThatAnswersFalseCancelsAtEveryCall) {
	expectCancelledAtEveryCall([](int call) {
		DistanceResult result;
		return measureWith(call, {{2, 0.5, 0.5}, {0.5, 0.5, 0.25}}, result);
	});
}

// A sphere, from whose centre all faces are about as far, so that each point takes long.
MeshArrays sphereArrays(std::uint32_t rings) {
	MeshArrays arrays;
	arrays.vertexOffsets = OperandOffsets(1);
	arrays.faceOffsets = OperandOffsets(1);
	const double pi = std::acos(-1.0);
	const std::uint32_t sectors = 2 * rings;
	for (std::uint32_t i = 0; i <= rings; ++i) {
		for (std::uint32_t j = 0; j < sectors; ++j) {
			const bool isPole = i == 0 || i == rings;
			const double t = pi * i / rings, p = isPole ? 0 : 2 * pi * j / sectors;
			arrays.points.push_back({isPole ? 0 : std::sin(t) * std::cos(p),
			                         isPole ? 0 : std::sin(t) * std::sin(p),
			                         i == 0       ? 1
			                         : i == rings ? -1
			                                      : std::cos(t)});
		}
	}
	for (std::uint32_t i = 0; i < rings; ++i) {
		for (std::uint32_t j = 0; j < sectors; ++j) {
			const VertexId a{i * sectors + j}, b{(i + 1) * sectors + j},
			    c{(i + 1) * sectors + (j + 1) % sectors}, d{i * sectors + (j + 1) % sectors};
			arrays.triangles.push_back({a, b, c});
			arrays.triangles.push_back({a, c, d});
		}
	}
	arrays.vertexOffsets.setEnd(kFirst, arrays.points.size());
	arrays.faceOffsets.setEnd(kFirst, arrays.triangles.size());
	return arrays;
}

TEST(DistanceRun, aRunIsCancelledWithinATenthOfASecond) {
	using Clock = std::chrono::steady_clock;
	Clock::time_point asked;
	bool isAsked = false;
	Progress progress([&](double, const char* stage) {
		if (!isAsked && std::string(stage) == "measuring distances") {
			isAsked = true;
			asked = Clock::now();
		}
		return !isAsked;
	});
	const Points points(100'000, Point{0, 0, 0});
	DistanceResult result;
	const Status status =
	    runDistance(sphereArrays(60), points, searchedRequest(), progress, 1, result);
	EXPECT_EQ(status.code, StatusCode::Cancelled);
	ASSERT_TRUE(isAsked);
	EXPECT_LT(std::chrono::duration<double>(Clock::now() - asked).count(), 0.1);
}

DistanceSample sampleOf(double distance, int sign) {
	DistanceSample sample;
	sample.distance = distance;
	sample.sign = sign;
	return sample;
}

TEST(DistanceRun, statisticsAreThoseOfWhatIsMeasured) {
	const double nan = std::numeric_limits<double>::quiet_NaN();
	const DistanceStatistics s =
	    statisticsOf({sampleOf(-3, -1), sampleOf(1, 1), sampleOf(0, 0), sampleOf(2, 1),
	                  sampleOf(nan, -1), sampleOf(nan, 0)});
	EXPECT_EQ(s.min, -3);
	EXPECT_EQ(s.max, 2);
	EXPECT_EQ(s.mean, 0);
	EXPECT_EQ(s.rms, std::sqrt(14.0 / 4));
	EXPECT_EQ(s.meanAbsolute, 1.5);
	EXPECT_EQ(s.largest, 3);
	EXPECT_EQ(s.count, 4u);
	EXPECT_EQ(s.beyond, 1u);
	EXPECT_EQ(s.noNumber, 1u);
	EXPECT_EQ(s.inside, 2u);
	const DistanceStatistics none = statisticsOf({});
	EXPECT_TRUE(std::isnan(none.min) && std::isnan(none.mean) && std::isnan(none.rms));
}

TEST(DistanceRun, aSurfaceWithoutFacesIsRefused) {
	MeshArrays nothing;
	nothing.vertexOffsets = OperandOffsets(1);
	nothing.faceOffsets = OperandOffsets(1);
	Progress progress = watch(0);
	DistanceResult result;
	EXPECT_EQ(runDistance(nothing, {{0, 0, 0}}, searchedRequest(), progress, 1, result).code,
	          StatusCode::EmptyOperand);
}

}  // namespace
}  // namespace index_boolean
