// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The search for self-intersections against all pairs of faces in rational arithmetic: what two
// faces have in common, as a convex polygon, against their common corners.
#include "core/shapes.h"
#include "support/meeting_oracle.h"

#include <vcg_ext/arrange/operands.h>
#include <vcg_ext/arrange/self_intersections.h>

#include <gtest/gtest.h>

#include <set>

namespace index_boolean {
namespace {

using namespace shapes;

using namespace oracle;

ExactPolygon exactTriangle(const MeshArrays& mesh, std::size_t face) {
	const Triangle& t = mesh.triangles[face];
	return oracle::exactTriangle(mesh.points, {t[0].value, t[1].value, t[2].value});
}

bool meetWrongly(const MeshArrays& mesh, std::size_t a, std::size_t b) {
	return oracle::meetWrongly(exactTriangle(mesh, a), exactTriangle(mesh, b));
}

// Whether the first two faces that meet wrongly do so at the place, up to rounding.
bool isPlaceOfFirst(const MeshArrays& mesh, OperandId operand, const Point& place) {
	for (std::uint32_t a = mesh.faceOffsets.begin(operand); a < mesh.faceOffsets.end(operand);
	     ++a) {
		for (std::uint32_t b = a + 1; b < mesh.faceOffsets.end(operand); ++b) {
			if (!meetWrongly(mesh, a, b)) {
				continue;
			}
			const ExactPolygon part = commonPart(exactTriangle(mesh, a), exactTriangle(mesh, b));
			return std::any_of(part.begin(), part.end(), [&place](const ExactVector& p) {
				double distance = 0;
				for (std::size_t axis = 0; axis < 3; ++axis) {
					distance += std::fabs(p[axis].convert_to<double>() - place[axis]);
				}
				return distance < 1e-12;
			});
		}
	}
	return false;
}

// The faces of one operand that meet others of it wrongly, numbered from its first on.
std::vector<std::uint32_t> expectedFaces(const MeshArrays& mesh, OperandId operand) {
	std::set<std::uint32_t> faces;
	const std::uint32_t begin = mesh.faceOffsets.begin(operand),
	                    end = mesh.faceOffsets.end(operand);
	for (std::uint32_t a = begin; a < end; ++a) {
		for (std::uint32_t b = a + 1; b < end; ++b) {
			if (meetWrongly(mesh, a, b)) {
				faces.insert({a - begin, b - begin});
			}
		}
	}
	return {faces.begin(), faces.end()};
}

const Mesh kAway = box({100, 100, 100}, {101, 102, 103});

Arrangement asked(const Mesh& a, const Mesh& b, Options options = {}) {
	Arrangement arrangement;
	arrangement.mesh = arrays(a, b);
	arrangement.options = options;
	arrangement.options.selfIntersections = SelfIntersections::Refuse;
	return arrangement;
}

Arrangement prepared(const Mesh& a, const Mesh& b, Options options = {}) {
	Arrangement arrangement = asked(a, b, options);
	Monitor monitor;
	const Status status = prepareOperands(arrangement, monitor);
	EXPECT_TRUE(status.ok()) << describe(status);
	return arrangement;
}

Status found(const Arrangement& arrangement) {
	Monitor monitor;
	return checkSelfIntersections(arrangement, monitor);
}

void expectNone(const Mesh& mesh) {
	for (const Status& status : {found(prepared(mesh, kAway)), found(prepared(kAway, mesh))}) {
		EXPECT_EQ(status.code, StatusCode::Ok) << describe(status);
	}
}

// Expects exactly the faces that rational arithmetic gives, in either operand; returns the status.
Status expectFound(const Mesh& mesh) {
	Status status;
	for (int operand : {1, 0}) {
		const Arrangement arrangement =
		    operand == 0 ? prepared(mesh, kAway) : prepared(kAway, mesh);
		status = found(arrangement);
		EXPECT_EQ(status.code, StatusCode::SelfIntersecting) << statusName(status.code);
		EXPECT_EQ(status.operand, operand);
		EXPECT_EQ(status.faces,
		          expectedFaces(arrangement.mesh, {static_cast<std::uint32_t>(operand)}));
		EXPECT_EQ(status.count, status.faces.size());
		EXPECT_TRUE(status.hasPlace);
	}
	return status;
}

// Unit cells: random ones of a cube of `span` cells a side. Neighbours share no wall; where cells
// touch at an edge or a corner only, the surface is not manifold.
Mesh cells(std::mt19937& random, int span, double share) {
	std::bernoulli_distribution solid(share);
	std::set<std::array<int, 3>> all;
	for (int i = 0; i < span * span * span; ++i) {
		if (solid(random)) {
			all.insert({i % span, i / span % span, i / span / span});
		}
	}
	Mesh mesh;
	for (const auto& cell : all) {
		const Point low{double(cell[0]), double(cell[1]), double(cell[2])};
		const Mesh cube = box(low, {low[0] + 1, low[1] + 1, low[2] + 1});
		Mesh walls;
		walls.points = cube.points;
		for (std::size_t wall = 0; wall < 6; ++wall) {
			std::array<int, 3> beside = cell;  // walls come as z-, z+, y-, y+, x-, x+
			beside[2 - wall / 2] += wall % 2 == 0 ? -1 : 1;
			if (all.count(beside) == 0) {
				walls.triangles.insert(walls.triangles.end(),
				                       {cube.triangles[2 * wall], cube.triangles[2 * wall + 1]});
			}
		}
		mesh = joined(mesh, walls);
	}
	return mesh;
}

// A tetrahedron with outward faces.
Mesh tetrahedron(Point a, Point b, Point c, Point d) {
	Mesh m;
	m.points = {a, b, c, d};
	m.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
	return volumeOf(m.points, m.triangles) < 0 ? turned(m) : m;
}

TEST(SelfIntersections, cleanMeshesHaveNone) {
	expectNone(box({0, 0, 0}, {1, 1, 1}));
	expectNone(sphere(30, {1e6, 0, 0}, 1));
	expectNone(torus(40, 20, 1, 0.4));
	expectNone(soup(sphere(8, {0, 0, 0}, 1)));
	expectNone(joined(sphere(12, {0, 0, 0}, 1), turned(sphere(9, {0, 0, 0}, 0.5))));
}

TEST(SelfIntersections, componentsThatMeetInCommonCornersAndEdgesHaveNone) {
	const Mesh unit = box({0, 0, 0}, {1, 1, 1});
	expectNone(joined(unit, box({1, 1, 1}, {2, 2, 2})));
	expectNone(joined(unit, box({1, 1, 0}, {2, 2, 1})));
	for (unsigned seed = 0; seed < 60; ++seed) {
		SCOPED_TRACE("seed " + std::to_string(seed));
		std::mt19937 random(seed);
		const Mesh mesh = cells(random, 4, 0.15 + 0.1 * (seed % 7));
		if (!mesh.triangles.empty()) {
			expectNone(permuted(mesh, random));
		}
	}
}

TEST(SelfIntersections, nestedShellsDoNotMeet) {
	expectNone(joined(box({0, 0, 0}, {10, 10, 10}), box({2, 2, 2}, {6, 6, 6})));
}

TEST(SelfIntersections, overlappingBoxesAreFound) {
	const Mesh overlapping = joined(box({0, 0, 0}, {4, 4, 4}), box({3, -1, -1.5}, {9, 5, 5.25}));
	const Status status = expectFound(overlapping);
	EXPECT_DOUBLE_EQ(status.place[0], 3);  // both cross in the plane of the second one's wall
}

TEST(SelfIntersections, everyKindOfWrongContactIsFound) {
	const Mesh unit = box({0, 0, 0}, {4, 4, 4});
	const struct {
		const char* what;
		Mesh other;
		Point place;
	} cases[] = {
	    {"a corner in a face", tetrahedron({1, 2, 4}, {0, 2, 9}, {2, 1, 9}, {2, 3, 9}), {1, 2, 4}},
	    {"a corner on an edge", tetrahedron({4, 1, 4}, {5, 1, 9}, {7, 0, 9}, {7, 3, 9}), {4, 1, 4}},
	    {"an edge across an edge",
	     tetrahedron({5, 1, 3}, {3, 1, 5}, {6, 0, 6}, {6, 2, 6}),
	     {4, 1, 4}},
	    {"an edge on an edge", box({4, 1, 4}, {5, 2, 5}), {4, 1, 4}},
	    {"a box on a face", box({1, 0.5, 4}, {2, 1, 5}), {1, 0.5, 4}},
	    {"a box of equal width on a face", box({0, 0, 4}, {4, 1, 5}), {4, 1, 4}},
	};
	for (const auto& c : cases) {
		SCOPED_TRACE(c.what);
		EXPECT_EQ(expectFound(joined(unit, c.other)).place, c.place);
	}
}

TEST(SelfIntersections, aFaceThereTwiceIsFound) {
	for (const std::array<std::uint32_t, 3>& again :
	     {std::array{5u, 7u, 4u}, std::array{7u, 5u, 4u}}) {
		Mesh doubled = box({0, 0, 0}, {1, 1, 1});
		ASSERT_EQ(doubled.triangles[2], (std::array{4u, 5u, 7u}));
		doubled.triangles.push_back(again);
		const Status status = found(asked(kAway, doubled));
		EXPECT_EQ(status.faces, (std::vector<std::uint32_t>{2, 12}));
		EXPECT_EQ(status.operand, 1);
	}
}

// Triangles with corners among a few grid points: corners in common, crossings, touching of every
// kind, coplanar overlaps, equal ones.
Mesh gridTriangles(std::mt19937& random, int width, int height, std::size_t count) {
	std::set<Point> places;
	while (places.size() < 9) {
		places.insert({double(random() % unsigned(width)), double(random() % unsigned(width)),
		               double(random() % unsigned(height))});
	}
	Mesh mesh;
	mesh.points.assign(places.begin(), places.end());
	while (mesh.triangles.size() < count) {
		const std::array<std::uint32_t, 3> t{
		    std::uint32_t(random() % 9), std::uint32_t(random() % 9), std::uint32_t(random() % 9)};
		if (!isFlat(oracle::exactTriangle(mesh.points, t))) {
			mesh.triangles.push_back(t);
		}
	}
	return mesh;
}

TEST(SelfIntersections, randomTrianglesOnAGridAreJudgedAsByRationalArithmetic) {
	int clean = 0;
	for (unsigned seed = 0; seed < 600; ++seed) {
		SCOPED_TRACE("seed " + std::to_string(seed));
		std::mt19937 random(seed);
		const Mesh mesh = gridTriangles(random, 4, 1 + static_cast<int>(seed % 4), 2 + seed % 5);
		Options options;
		options.octreeLeafSize = static_cast<int>(seed % 2);
		const Arrangement arrangement = asked(kAway, mesh, options);
		const Status status = found(arrangement);
		const std::vector<std::uint32_t> expected = expectedFaces(arrangement.mesh, kSecond);
		clean += expected.empty() ? 1 : 0;
		ASSERT_EQ(status.faces, expected);
		ASSERT_EQ(status.ok(), expected.empty());
		ASSERT_TRUE(status.ok() || isPlaceOfFirst(arrangement.mesh, kSecond, status.place));
	}
	EXPECT_GT(clean, 60);
	EXPECT_LT(clean, 540);
}

TEST(SelfIntersections, theFirstOperandIsNamedBeforeTheSecond) {
	const Mesh both = joined(box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3}));
	EXPECT_EQ(found(prepared(both, both)).operand, 0);
}

TEST(SelfIntersections, facesAreNumberedAsGiven) {
	const Mesh first = box({0, 0, 0}, {4, 4, 4});
	Mesh collapsed = first;
	collapsed.triangles.insert(collapsed.triangles.begin() + 2, {0, 0, 1});
	const Mesh other = tetrahedron({1, 2, 4}, {0, 2, 9}, {2, 1, 9}, {2, 3, 9});
	std::vector<std::uint32_t> expected = found(prepared(joined(first, other), kAway)).faces;
	ASSERT_FALSE(expected.empty());
	for (std::uint32_t& face : expected) {
		face += face >= 2 ? 1 : 0;
	}
	EXPECT_EQ(found(prepared(joined(collapsed, other), kAway)).faces, expected);
}

TEST(SelfIntersections, anyMagnitudeIsSearched) {
	const Mesh both = joined(sphere(6, {0, 0, 0}, 1), sphere(7, {1, 0.25, 0.125}, 1));
	const Status expected = found(prepared(both, kAway));
	ASSERT_EQ(expected.code, StatusCode::SelfIntersecting);
	for (const int exponent : {-1040, -300, 300, 1020}) {
		Mesh scaled = box({0, 0, 0}, {4, 4, 4});
		scaled = joined(scaled, tetrahedron({1, 2, 4}, {0, 2, 9}, {2, 1, 9}, {2, 3, 9}));
		const Status unscaled = found(prepared(scaled, kAway));
		for (Point& p : scaled.points) {
			for (double& x : p) {
				x = std::ldexp(x, exponent);
			}
		}
		EXPECT_EQ(found(prepared(scaled, kAway)).faces, unscaled.faces) << exponent;
	}
	Mesh stray = both;
	stray.points.push_back({1e300, -1e300, std::nan("")});
	EXPECT_EQ(found(prepared(stray, kAway)).faces, expected.faces);
}

TEST(SelfIntersections, manyFacesAroundOneVertexHaveNone) {
	Mesh cone;
	constexpr std::uint32_t kSides = 1500;
	cone.points = {{0, 0, 1}, {0, 0, 0}};
	for (std::uint32_t i = 0; i < kSides; ++i) {
		const double angle = 2 * kPi * i / kSides;
		cone.points.push_back({std::cos(angle), std::sin(angle), 0});
		const std::uint32_t next = 2 + (i + 1) % kSides;
		cone.triangles.push_back({0, 2 + i, next});
		cone.triangles.push_back({1, next, 2 + i});
	}
	expectNone(cone);
}

TEST(SelfIntersections, theResultDependsOnNeitherThreadsNorTheOctree) {
	for (unsigned seed = 0; seed < 20; ++seed) {
		SCOPED_TRACE("seed " + std::to_string(seed));
		std::mt19937 random(seed);
		Mesh tangle = placed(torus(60, 30, 1, 0.4), random, 0.2);
		for (std::uint32_t n = 2; n < 10; ++n) {
			tangle = joined(tangle, placed(sphere(n, {0, 0, 0}, 1), random, 0.2));
		}
		tangle = permuted(tangle, random);
		const Status expected = found(prepared(tangle, kAway));
		ASSERT_EQ(expected.code, StatusCode::SelfIntersecting);
		for (const auto& [depth, leafSize, threads] :
		     {std::array{12, 0, 1}, {12, 0, 8}, {3, 40, 2}, {20, 1, 1}, {1, 0, 1}}) {
			Options options;
			options.octreeMaxDepth = depth;
			options.octreeLeafSize = leafSize;
			options.threads = threads;
			const Status status = found(prepared(tangle, kAway, options));
			EXPECT_EQ(status.faces, expected.faces);
			EXPECT_EQ(status.place, expected.place);
		}
	}
}

TEST(SelfIntersections, nothingIsSearchedUnlessAsked) {
	const Mesh both = joined(box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3}));
	Arrangement arrangement = prepared(both, kAway);
	arrangement.options.selfIntersections = SelfIntersections::Trust;
	EXPECT_TRUE(found(arrangement).ok());
}

TEST(SelfIntersections, aRunIsRefusedFarFromTheOtherOperandOnlyIfAsked) {
	const Mesh both = joined(box({0, 0, 0}, {4, 4, 4}), box({3, -1, -1.5}, {9, 5, 5.25}));
	Options options;
	options.selfIntersections = SelfIntersections::Refuse;
	const BooleanRun r = run(kAway, both, options);
	EXPECT_EQ(r.status.code, StatusCode::SelfIntersecting);
	EXPECT_EQ(r.status.operand, 1);
	EXPECT_FALSE(r.status.faces.empty());
	EXPECT_NE(describe(r.status).find("intersects itself: "), std::string::npos);
	EXPECT_TRUE(run(kAway, box({0, 0, 0}, {4, 4, 4}), options).status.ok());
}

TEST(SelfIntersections, theSearchIsCancelled) {
	const Arrangement arrangement = prepared(sphere(20, {0, 0, 0}, 1), kAway);
	Monitor monitor([](double, const char*) { return false; });
	monitor.beginStage("test", 0, 1);
	EXPECT_EQ(checkSelfIntersections(arrangement, monitor).code, StatusCode::Cancelled);
}

}  // namespace
}  // namespace index_boolean
