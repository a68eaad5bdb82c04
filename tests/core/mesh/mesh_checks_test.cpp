// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The limit of counts; closedness by checksum and by search, against a count of directed edges that
// shares no code.
#include "core/shapes.h"

#include <vcg_ext/mesh/boundary_checksum.h>
#include <vcg_ext/mesh/element_counts.h>
#include <vcg_ext/mesh/unmatched_edges.h>

#include <gtest/gtest.h>

#include <random>

using namespace index_boolean;
using shapes::Mesh;

namespace {

using Corners = std::array<std::uint32_t, 3>;

Triangles typed(const IndexTriangles& triangles) {
	Triangles result;
	for (const Corners& t : triangles) {
		result.push_back({VertexId{t[0]}, VertexId{t[1]}, VertexId{t[2]}});
	}
	return result;
}

std::uint64_t checksum(const IndexTriangles& triangles, int threads = 0) {
	Monitor monitor;
	std::uint64_t sum = 1;
	EXPECT_TRUE(boundaryChecksum(triangles.data(), triangles.data() + triangles.size(), threads,
	                             monitor, sum)
	                .ok());
	return sum;
}

UnmatchedEdges unmatched(const IndexTriangles& triangles) {
	const Triangles all = typed(triangles);
	UnmatchedEdges found;
	findUnmatchedEdges(all.data(), all.data() + all.size(), found);
	return found;
}

void expectClosed(const IndexTriangles& triangles) {
	EXPECT_EQ(checksum(triangles), 0U);
	const UnmatchedEdges found = unmatched(triangles);
	EXPECT_EQ(found.borderEdges, 0U);
	EXPECT_EQ(found.conflictingEdges, 0U);
	EXPECT_TRUE(found.faces.empty());
}

const IndexTriangles kTetrahedron = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

}  // namespace

TEST(MeshChecks, countsUpToTheLimitAreAccepted) {
	constexpr std::size_t kLimit = (std::size_t{1} << 31) - 1;
	for (const std::size_t count : {std::size_t{0}, std::size_t{1}, kLimit}) {
		EXPECT_TRUE(checkCounts(count, kLimit).ok());
		EXPECT_TRUE(checkCounts(kLimit, count).ok());
	}
}

TEST(MeshChecks, countsBeyondTheLimitAreTooLarge) {
	constexpr std::size_t kTwoTo31 = std::size_t{1} << 31;
	for (const std::size_t count : {kTwoTo31, kTwoTo31 + 1, 2 * kTwoTo31, 2 * kTwoTo31 + 7}) {
		for (const Status& status :
		     {checkCounts(count, 12), checkCounts(8, count), checkCounts(count, count)}) {
			EXPECT_EQ(status.code, StatusCode::TooLarge);
			EXPECT_EQ(status.count, count);
			EXPECT_EQ(status.operand, -1);
			EXPECT_NE(describe(status).find(std::to_string(count)), std::string::npos);
		}
	}
}

TEST(MeshChecks, aLowerLimitHoldsAndAHigherOneDoesNot) {
	EXPECT_TRUE(checkCounts(7, 5, 7).ok());
	EXPECT_EQ(checkCounts(7, 8, 7).count, 8U);
	EXPECT_EQ(checkCounts(8, 7, 7).code, StatusCode::TooLarge);
	EXPECT_EQ(checkCounts(std::size_t{1} << 31, 0, std::size_t{1} << 40).code,
	          StatusCode::TooLarge);
}

TEST(MeshChecks, numberingsGoTwiceAsFar) {
	constexpr std::size_t kMost = (std::size_t{1} << 32) - 2;  // so that no number is none()
	EXPECT_TRUE(checkNumbering(kMost).ok());
	EXPECT_TRUE(checkNumbering(14, 7).ok());
	EXPECT_EQ(checkNumbering(15, 7).count, 15U);
	for (const std::size_t most : {std::size_t{1} << 31, std::size_t{1} << 63}) {
		EXPECT_EQ(checkNumbering(kMost + 1, most).code, StatusCode::TooLarge);
		EXPECT_EQ(checkNumbering(kMost + 1, most).count, kMost + 1);
	}
}

TEST(MeshChecks, closedSurfacesAreClosed) {
	expectClosed({});
	expectClosed(kTetrahedron);
	expectClosed(shapes::box({0, 0, 0}, {1, 1, 1}).triangles);
	expectClosed(shapes::sphere(60, {0, 0, 0}, 1).triangles);
	expectClosed(shapes::turned(shapes::torus(20, 10, 2, 1)).triangles);
}

TEST(MeshChecks, edgesWithFourFacesAreClosed) {
	IndexTriangles twoOnOneEdge = kTetrahedron;
	for (const Corners& t : kTetrahedron) {
		Corners other{};
		for (std::size_t i = 0; i < 3; ++i) {
			other[i] = t[i] < 2 ? t[i] : t[i] + 10;
		}
		twoOnOneEdge.push_back(other);
	}
	expectClosed(twoOnOneEdge);
}

TEST(MeshChecks, missingFaceIsThreeBorders) {
	IndexTriangles open = kTetrahedron;
	open.erase(open.begin());  // (0, 2, 1)
	EXPECT_NE(checksum(open), 0U);
	const UnmatchedEdges found = unmatched(open);
	EXPECT_EQ(found.borderEdges, 3U);
	EXPECT_EQ(found.conflictingEdges, 0U);
	EXPECT_EQ(found.firstEdge, (std::array<VertexId, 2>{VertexId{0}, VertexId{1}}));
	EXPECT_EQ(found.faces, (std::vector<std::uint32_t>{0, 1, 2}));
}

TEST(MeshChecks, turnedFaceIsThreeConflicts) {
	IndexTriangles turned = kTetrahedron;
	std::swap(turned[2][0], turned[2][1]);  // (2, 1, 3)
	EXPECT_NE(checksum(turned), 0U);
	const UnmatchedEdges found = unmatched(turned);
	EXPECT_EQ(found.borderEdges, 0U);
	EXPECT_EQ(found.conflictingEdges, 3U);
	EXPECT_EQ(found.firstEdge, (std::array<VertexId, 2>{VertexId{1}, VertexId{2}}));
	EXPECT_EQ(found.faces, (std::vector<std::uint32_t>{0, 1, 2, 3}));
}

TEST(MeshChecks, bordersComeBeforeConflicts) {
	IndexTriangles both = kTetrahedron;
	std::swap(both[0][0], both[0][1]);
	both.push_back({7, 8, 9});
	const UnmatchedEdges found = unmatched(both);
	EXPECT_EQ(found.borderEdges, 3U);
	EXPECT_EQ(found.conflictingEdges, 3U);
	EXPECT_EQ(found.firstEdge, (std::array<VertexId, 2>{VertexId{7}, VertexId{8}}));
	EXPECT_EQ(found.faces, (std::vector<std::uint32_t>{0, 1, 2, 3, 4}));
	for (Corners& t : both) {
		for (std::uint32_t& v : t) {
			v = 9 - v;  // now the borders have the smaller vertices
		}
	}
	EXPECT_EQ(unmatched(both).firstEdge, (std::array<VertexId, 2>{VertexId{0}, VertexId{1}}));
}

TEST(MeshChecks, thirdFaceAtAnEdgeIsABorder) {
	IndexTriangles flap = kTetrahedron;
	flap.push_back({0, 1, 9});
	const UnmatchedEdges found = unmatched(flap);
	EXPECT_EQ(found.borderEdges, 3U);
	EXPECT_EQ(found.faces, (std::vector<std::uint32_t>{0, 1, 4}));
}

TEST(MeshChecks, doubledFaceIsFound) {
	IndexTriangles doubled = kTetrahedron;
	doubled.push_back(doubled[0]);
	EXPECT_NE(checksum(doubled), 0U);
	EXPECT_EQ(unmatched(doubled).borderEdges, 3U);
	doubled.push_back(doubled[0]);
	EXPECT_NE(checksum(doubled), 0U);
	EXPECT_EQ(unmatched(doubled).conflictingEdges, 3U);
}

TEST(MeshChecks, checksumAndSearchAgreeWithCounting) {
	for (unsigned seed = 1; seed <= 300; ++seed) {
		SCOPED_TRACE(seed);
		std::mt19937 random(seed);
		IndexTriangles triangles;
		for (unsigned i = 0; i < 4 + seed % 3; ++i) {
			const Corners t = kTetrahedron[random() % 4];
			triangles.push_back((random() & 1U) != 0 ? t : Corners{t[1], t[0], t[2]});
		}
		const bool closed = shapes::isClosed(triangles);
		EXPECT_EQ(checksum(triangles) == 0, closed);
		const UnmatchedEdges found = unmatched(triangles);
		EXPECT_EQ(found.borderEdges + found.conflictingEdges == 0, closed);
		EXPECT_EQ(found.faces.empty(), closed);
	}
}

// Around this hexagon the sums of an edge's two vertices cancel, and so would a hash of the sum.
TEST(MeshChecks, checksumTellsEdgesApart) {
	const std::array<std::uint32_t, 6> hexagon = {0, 12, 1, 10, 2, 11};
	IndexTriangles cone;
	for (std::size_t i = 0; i < 6; ++i) {
		cone.push_back({50, hexagon[i], hexagon[(i + 1) % 6]});
	}
	EXPECT_NE(checksum(cone), 0U);
}

TEST(MeshChecks, checksumDependsOnNeitherThreadsNorOrderNorKindOfIndex) {
	IndexTriangles triangles = shapes::sphere(120, {0, 0, 0}, 1).triangles;
	triangles.pop_back();
	const std::uint64_t sum = checksum(triangles, 1);
	EXPECT_NE(sum, 0U);
	for (const int threads : {0, 2, 8}) {
		EXPECT_EQ(checksum(triangles, threads), sum);
	}
	const Triangles all = typed(triangles);
	Monitor monitor;
	std::uint64_t ofTyped = 0;
	EXPECT_TRUE(boundaryChecksum(all.data(), all.data() + all.size(), 0, monitor, ofTyped).ok());
	EXPECT_EQ(ofTyped, sum);
	std::mt19937 random(1);
	std::shuffle(triangles.begin(), triangles.end(), random);
	EXPECT_EQ(checksum(triangles), sum);
}

TEST(MeshChecks, checksumIsCancelled) {
	const IndexTriangles triangles = shapes::sphere(20, {0, 0, 0}, 1).triangles;
	Monitor monitor([](double, const char*) { return false; });
	monitor.beginStage("test", 0, 1);
	std::uint64_t sum = 0;
	EXPECT_EQ(
	    boundaryChecksum(triangles.data(), triangles.data() + triangles.size(), 1, monitor, sum)
	        .code,
	    StatusCode::Cancelled);
}
