// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pairs of faces against brute force: every two faces that meet are listed once; others may be, if
// their boxes, in the doubles as given, touch or differ by a float's rounding only.
#include "core/shapes.h"

#include <vcg_ext/arrange/octree_pairs.h>
#include <vcg_ext/arrange/triangle_contact.h>
#include <vcg_ext/exact/exact_sign.h>

#include <gtest/gtest.h>

#include <limits>
#include <random>

using namespace index_boolean;
using shapes::Mesh;

namespace {

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

Pairs found(const MeshArrays& mesh, const Options& options = {}) {
	Monitor monitor;
	std::vector<FacePair> pairs;
	const Status status = findPairs(mesh, options, monitor, pairs);
	EXPECT_EQ(status.code, StatusCode::Ok);
	Pairs result;
	for (const FacePair& pair : pairs) {
		result.emplace_back(pair.a.value, pair.b.value);
	}
	return result;
}

struct Box {
	Point lo, hi;
};

std::vector<Box> faceBoxes(const MeshArrays& mesh) {
	std::vector<Box> boxes;
	for (const Triangle& t : mesh.triangles) {
		Box box{at(mesh.points, t[0]), at(mesh.points, t[0])};
		for (const VertexId v : t) {
			for (std::size_t axis = 0; axis < 3; ++axis) {
				box.lo[axis] = std::min(box.lo[axis], at(mesh.points, v)[axis]);
				box.hi[axis] = std::max(box.hi[axis], at(mesh.points, v)[axis]);
			}
		}
		boxes.push_back(box);
	}
	return boxes;
}

// The widest gap between two boxes along an axis; at most 0 if they touch or overlap.
double gap(const Box& a, const Box& b) {
	double widest = -std::numeric_limits<double>::infinity();
	for (std::size_t axis = 0; axis < 3; ++axis) {
		widest = std::max({widest, b.lo[axis] - a.hi[axis], a.lo[axis] - b.hi[axis]});
	}
	return widest;
}

// Half of the longest side of the box that both operands have in common.
double halfSizeOfCommonBox(const MeshArrays& mesh) {
	double half = 0;
	for (std::size_t axis = 0; axis < 3; ++axis) {
		double lo = -std::numeric_limits<double>::infinity();
		double hi = -lo;
		for (const OperandId k : mesh.operands()) {
			double first = mesh.points[mesh.vertexOffsets.begin(k)][axis];
			double last = first;
			for (std::size_t v = mesh.vertexOffsets.begin(k); v < mesh.vertexOffsets.end(k); ++v) {
				first = std::min(first, mesh.points[v][axis]);
				last = std::max(last, mesh.points[v][axis]);
			}
			lo = std::max(lo, first);
			hi = std::min(hi, last);
		}
		half = std::max(half, hi / 2 - lo / 2);
	}
	return half;
}

// Whether the corners of `face` lie strictly on one side of the plane of `plane`.
bool parts(const MeshArrays& mesh, std::uint32_t plane, std::uint32_t face) {
	const Triangle& p = mesh.triangles[plane];
	int sum = 0;
	for (const VertexId v : mesh.triangles[face]) {
		sum += orient3d(at(mesh.points, p[0]), at(mesh.points, p[1]), at(mesh.points, p[2]),
		                at(mesh.points, v));
	}
	return sum == 3 || sum == -3;
}

bool apart(const MeshArrays& mesh, std::uint32_t a, std::uint32_t b) {
	return parts(mesh, a, b) || parts(mesh, b, a);
}

bool hasArea(const MeshArrays& mesh, std::uint32_t face) {
	const Triangle& t = mesh.triangles[face];
	const Point &a = at(mesh.points, t[0]), &b = at(mesh.points, t[1]), &c = at(mesh.points, t[2]);
	return orient2d(a, b, c, 0) != 0 || orient2d(a, b, c, 1) != 0 || orient2d(a, b, c, 2) != 0;
}

// False for faces without area: their contacts are not defined.
bool meet(const MeshArrays& mesh, std::uint32_t a, std::uint32_t b) {
	PairContact contact;
	return hasArea(mesh, a) && hasArea(mesh, b) && contactOf(mesh, {{a}, {b}}, contact) &&
	       contact.count > 0;
}

// Checks the list of pairs, under several options, against all pairs. \return the number of those
// whose boxes meet
std::size_t expectAllPairs(const Mesh& first, const Mesh& second) {
	const MeshArrays mesh = shapes::arrays(first, second);
	const std::vector<Box> boxes = faceBoxes(mesh);
	Pairs expected;
	std::size_t boxesMeet = 0;
	for (std::uint32_t a = 0; a < mesh.faceOffsets.begin(kSecond); ++a) {
		for (std::uint32_t b = mesh.faceOffsets.begin(kSecond); b < mesh.faceOffsets.total(); ++b) {
			if (gap(boxes[a], boxes[b]) > 0) {
				continue;
			}
			++boxesMeet;
			if (meet(mesh, a, b)) {
				expected.emplace_back(a, b);
			}
		}
	}
	const Pairs pairs = found(mesh);
	EXPECT_TRUE(std::is_sorted(pairs.begin(), pairs.end()));
	EXPECT_EQ(std::adjacent_find(pairs.begin(), pairs.end()), pairs.end()) << "a pair twice";
	EXPECT_TRUE(std::includes(pairs.begin(), pairs.end(), expected.begin(), expected.end()));
	const double rounding = std::ldexp(halfSizeOfCommonBox(mesh), -22);
	for (const auto& [a, b] : pairs) {
		EXPECT_LE(gap(boxes[a], boxes[b]), rounding) << a << ' ' << b;
	}
	for (const auto& [depth, leafSize, threads] :
	     {std::array{1, 0, 1}, {20, 1, 1}, {20, 0, 8}, {3, 40, 2}, {12, 1000, 1}, {7, 2, 2}}) {
		Options options;
		options.octreeMaxDepth = depth;
		options.octreeLeafSize = leafSize;
		options.threads = threads;
		const Pairs others = found(mesh, options);
		EXPECT_TRUE(std::includes(others.begin(), others.end(), expected.begin(), expected.end()))
		    << depth << ' ' << leafSize << ' ' << threads;
	}
	return boxesMeet;
}

// Triangles, each with its own vertices, with corners up to `reach` about a centre.
template <class Centre>
Mesh triangleSoup(std::size_t count, double reach, std::mt19937& random, Centre centre) {
	std::uniform_real_distribution<double> offset(-reach, reach);
	Mesh mesh;
	for (std::size_t i = 0; i < count; ++i) {
		const Point c = centre();
		const auto first = static_cast<std::uint32_t>(mesh.points.size());
		for (int corner = 0; corner < 3; ++corner) {
			mesh.points.push_back(
			    {c[0] + offset(random), c[1] + offset(random), c[2] + offset(random)});
		}
		mesh.triangles.push_back({first, first + 1, first + 2});
	}
	return mesh;
}

Mesh uniformSoup(std::size_t count, double reach, std::mt19937& random) {
	std::uniform_real_distribution<double> place(-1, 1);
	return triangleSoup(count, reach, random, [&]() -> Point {
		return {place(random), place(random), place(random)};
	});
}

Mesh mapped(Mesh mesh, double scale, Point offset) {
	for (Point& p : mesh.points) {
		for (std::size_t axis = 0; axis < 3; ++axis) {
			p[axis] = p[axis] * scale + offset[axis];
		}
	}
	return mesh;
}

// `count` triangles around one vertex, their other corners on a circle about it.
Mesh fan(std::uint32_t count, Point apex, double radius, double height) {
	Mesh mesh;
	mesh.points.push_back(apex);
	for (std::uint32_t i = 0; i < count; ++i) {
		const double angle = 2 * shapes::kPi * i / count;
		mesh.points.push_back({apex[0] + radius * std::cos(angle),
		                       apex[1] + radius * std::sin(angle), apex[2] + height});
		mesh.triangles.push_back({0, i + 1, i + 1 == count ? 1 : i + 2});
	}
	return mesh;
}

// A square wall in the plane axis = place, of 2 n n triangles on a grid of dyadic numbers.
Mesh wall(std::size_t axis, double place, std::uint32_t n) {
	Mesh mesh;
	for (std::uint32_t i = 0; i <= n; ++i) {
		for (std::uint32_t j = 0; j <= n; ++j) {
			Point p{};
			p[axis] = place;
			p[(axis + 1) % 3] = 2.0 * i / n - 1;
			p[(axis + 2) % 3] = 2.0 * j / n - 1;
			mesh.points.push_back(p);
		}
	}
	for (std::uint32_t i = 0; i < n; ++i) {
		for (std::uint32_t j = 0; j < n; ++j) {
			const std::uint32_t v = i * (n + 1) + j;
			mesh.triangles.push_back({v, v + n + 1, v + n + 2});
			mesh.triangles.push_back({v, v + n + 2, v + 1});
		}
	}
	return mesh;
}

Mesh singleTriangle(Point p, Point q, Point r) { return {{p, q, r}, {{0, 1, 2}}}; }

}  // namespace

TEST(OctreePairs, smallTrianglesAgreeWithBruteForce) {
	for (unsigned seed = 1; seed <= 6; ++seed) {
		SCOPED_TRACE(seed);
		std::mt19937 random(seed);
		const Mesh a = uniformSoup(1500, 0.05, random);
		EXPECT_GT(expectAllPairs(a, uniformSoup(1500, 0.05, random)), 100U);
	}
}

TEST(OctreePairs, longTrianglesAgreeWithBruteForce) {
	for (unsigned seed = 1; seed <= 4; ++seed) {
		SCOPED_TRACE(seed);
		std::mt19937 random(seed);
		const Mesh a = uniformSoup(400, 1, random);
		EXPECT_GT(expectAllPairs(a, uniformSoup(400, 1, random)), 10000U);
	}
}

TEST(OctreePairs, fewHugeAgainstManySmallAgreeWithBruteForce) {
	std::mt19937 random(3);
	const Mesh huge = uniformSoup(5, 4, random);
	const Mesh small = uniformSoup(5000, 0.02, random);
	EXPECT_GT(expectAllPairs(huge, small), 1000U);
	EXPECT_GT(expectAllPairs(small, huge), 1000U);
}

TEST(OctreePairs, clustersFarFromEachOtherAgreeWithBruteForce) {
	std::mt19937 random(7);
	std::normal_distribution<double> normal(0, 1e-4);
	const auto cluster = [&]() -> Point {
		const double corner = (random() & 1U) != 0 ? 0.7 : -0.7;
		return {corner + normal(random), corner + normal(random), corner + normal(random)};
	};
	const Mesh a = triangleSoup(1500, 1e-5, random, cluster);
	EXPECT_GT(expectAllPairs(a, triangleSoup(1500, 1e-5, random, cluster)), 100U);
}

TEST(OctreePairs, wallsInThePlanesBetweenNodesAgreeWithBruteForce) {
	for (std::size_t axis = 0; axis < 3; ++axis) {
		SCOPED_TRACE(axis);
		EXPECT_GT(expectAllPairs(wall(axis, 0, 16), wall(axis, 0, 8)), 512U);
		EXPECT_GT(expectAllPairs(wall(axis, 0.5, 16), wall((axis + 1) % 3, -0.25, 16)), 64U);
		EXPECT_GT(expectAllPairs(wall(axis, 1, 8), wall((axis + 2) % 3, -1, 8)), 16U);
	}
}

TEST(OctreePairs, gridCoordinatesWithManyTiesAgreeWithBruteForce) {
	for (unsigned seed = 1; seed <= 6; ++seed) {
		SCOPED_TRACE(seed);
		std::mt19937 random(seed);
		Mesh a = uniformSoup(600, 0.3, random);
		Mesh b = uniformSoup(600, 0.3, random);
		for (Mesh* mesh : {&a, &b}) {
			for (Point& p : mesh->points) {
				for (double& x : p) {
					x = std::round(x * 8) / 8;
				}
			}
		}
		EXPECT_GT(expectAllPairs(a, b), 1000U);
	}
}

TEST(OctreePairs, facesAroundOneVertexAgreeWithBruteForce) {
	std::mt19937 random(5);
	EXPECT_GT(expectAllPairs(fan(3000, {0, 0, 0}, 1, 0.1), uniformSoup(500, 0.2, random)), 1000U);
	EXPECT_GT(expectAllPairs(fan(700, {0, 0, 0}, 1, 0.1), fan(500, {0, 0, 0}, 0.9, -0.1)), 10000U);
	EXPECT_GT(expectAllPairs(fan(700, {0.3, 0, 0}, 1, 0.1), fan(500, {0.3, 1e-9, 0}, 1, 0.2)),
	          10000U);
}

// The first `common` vertices of the second mesh are those of the first one.
MeshArrays withCommonVertices(const Mesh& a, const Mesh& b, std::uint32_t common) {
	MeshArrays mesh = shapes::arrays(a, b);
	const std::uint32_t second = mesh.vertexOffsets.begin(kSecond);
	for (std::uint32_t f = mesh.faceOffsets.begin(kSecond); f < mesh.faceOffsets.total(); ++f) {
		for (VertexId& v : mesh.triangles[f]) {
			v.value -= v.value < second + common ? second : 0;
		}
	}
	return mesh;
}

// Checks that all pairs with more in common than one common vertex are listed, and that each face
// at such a vertex is in a pair. \return how many pairs are listed
std::size_t expectPairsOfFans(const MeshArrays& mesh) {
	const Pairs pairs = found(mesh);
	EXPECT_TRUE(std::is_sorted(pairs.begin(), pairs.end()));
	EXPECT_EQ(std::adjacent_find(pairs.begin(), pairs.end()), pairs.end()) << "a pair twice";
	const std::uint32_t second = mesh.faceOffsets.begin(kSecond), all = mesh.faceOffsets.total();
	std::vector<bool> touched(all), listed(all);
	for (const auto& [a, b] : pairs) {
		PairContact contact;
		EXPECT_TRUE(contactOf(mesh, {{a}, {b}}, contact));
		listed[a] = listed[a] || contact.count > 0;
		listed[b] = listed[b] || contact.count > 0;
	}
	for (std::uint32_t a = 0; a < second; ++a) {
		for (std::uint32_t b = second; b < all; ++b) {
			PairContact contact;
			EXPECT_TRUE(contactOf(mesh, {{a}, {b}}, contact));
			touched[a] = touched[a] || contact.count > 0;
			touched[b] = touched[b] || contact.count > 0;
			if (contact.count > 1) {
				EXPECT_TRUE(std::binary_search(pairs.begin(), pairs.end(), std::pair(a, b)));
			}
		}
	}
	EXPECT_EQ(listed, touched);
	for (const auto& [depth, leafSize, threads] :
	     {std::array{1, 0, 1}, {20, 1, 2}, {3, 40, 2}, {12, 1000, 1}}) {
		Options options;
		options.octreeMaxDepth = depth;
		options.octreeLeafSize = leafSize;
		options.threads = threads;
		EXPECT_EQ(found(mesh, options), pairs) << depth << ' ' << leafSize << ' ' << threads;
	}
	return pairs.size();
}

TEST(OctreePairs, fansAtACommonVertexHaveFewPairs) {
	const Mesh a = fan(700, {0.3, 0, 0}, 1, 0.5);
	const Mesh below = fan(500, {0.3, 0, 0}, 0.9, -0.1), inside = fan(500, {0.3, 0, 0}, 0.5, 0.5);
	EXPECT_LE(expectPairsOfFans(withCommonVertices(a, below, 1)), 1200U);
	EXPECT_LE(expectPairsOfFans(withCommonVertices(a, inside, 1)), 1200U);
	for (const double angle : {0.1, 0.8, 3.0}) {
		SCOPED_TRACE(angle);
		Mesh across = fan(500, {0.3, 0, 0}, 0.7, 0.4);
		for (Point& p : across.points) {
			p = {0.3 + std::cos(angle) * (p[0] - 0.3) - std::sin(angle) * p[2], p[1],
			     std::sin(angle) * (p[0] - 0.3) + std::cos(angle) * p[2]};
		}
		across.points[0] = a.points[0];
		EXPECT_LE(expectPairsOfFans(withCommonVertices(a, across, 1)), 2000U);
	}
}

TEST(OctreePairs, fansAtACommonVertexAtTheLimitsOfDoubleAreRight) {
	const Mesh a = fan(150, {0, 0, 0}, 1, 0.5), b = fan(140, {0, 0, 0}, 0.9, 0.5);
	for (const double scale : {1.7e308, 1e300, 1e-300, 1e-310, 1e-318}) {
		SCOPED_TRACE(scale);
		expectPairsOfFans(
		    withCommonVertices(mapped(a, scale, {0, 0, 0}), mapped(b, scale, {0, 0, 0}), 1));
	}
}

// Around one axis, all faces of both fans at its two ends: all pairs are listed, each once.
TEST(OctreePairs, fansWithACommonEdgeHaveAllPairs) {
	const auto pages = [](std::uint32_t count, double first) {
		Mesh mesh{{{0, 0, 0}, {0, 0, 1}}, {}};
		for (std::uint32_t i = 0; i < count; ++i) {
			const double angle = first + 2 * shapes::kPi * i / count;
			mesh.points.push_back({std::cos(angle), std::sin(angle), 0.5});
			mesh.triangles.push_back({0, 1, i + 2});
		}
		return mesh;
	};
	const MeshArrays mesh = withCommonVertices(pages(100, 0), pages(90, 0.01), 2);
	EXPECT_EQ(expectPairsOfFans(mesh), 9000U);
}

// Seen from the common vertex, the faces of one fan are long arcs, far from their chords; those of
// the other one are short arcs across.
TEST(OctreePairs, longArcsOfAFanAgreeWithBruteForce) {
	Mesh a, b;
	a.points.push_back({0, 0, 0});
	b.points.push_back({0, 0, 0});
	const auto add = [](Mesh& mesh, double angle, double height) {
		mesh.points.push_back({std::cos(angle), std::sin(angle), height});
		return static_cast<std::uint32_t>(mesh.points.size() - 1);
	};
	for (std::uint32_t i = 0; i < 40; ++i) {
		const std::uint32_t from = add(a, 0.9 * i, 0.001 * i - 0.02);
		a.triangles.push_back({0, from, add(a, 0.9 * i + 1 + 0.05 * i, 0.001 * i - 0.02)});
	}
	for (std::uint32_t i = 0; i < 900; ++i) {
		const std::uint32_t from = add(b, 0.01 * i, -0.1);
		b.triangles.push_back({0, from, add(b, 0.01 * i, 0.1)});
	}
	EXPECT_GT(expectPairsOfFans(withCommonVertices(a, b, 1)), 5000U);
}

// Several fans within one leaf, and faces that belong to two of them.
TEST(OctreePairs, manyFansInOneLeafAreRight) {
	Mesh a, b;
	for (std::uint32_t i = 0; i < 4; ++i) {
		a.points.push_back({1e-4 * i, 1e-5 * i * i, 0});
	}
	b.points = a.points;
	for (const auto& [mesh, height] : {std::pair{&a, 0.5}, {&b, -0.5}}) {
		for (std::uint32_t i = 0; i < 300; ++i) {
			const double angle = 2 * shapes::kPi * i / 300;
			const auto corner = static_cast<std::uint32_t>(mesh->points.size());
			mesh->points.push_back({std::cos(angle), std::sin(angle), height});
			mesh->points.push_back({std::cos(angle + 0.02), std::sin(angle + 0.02), height});
			mesh->triangles.push_back({i % 4, corner, corner + 1});
			if (i % 3 == 0) {
				mesh->triangles.push_back({i % 4, (i + 1) % 4, corner});
			}
		}
	}
	expectPairsOfFans(withCommonVertices(a, b, 4));
}

// Thin faces of a fan, and upright walls on a circle about it: all boxes of a quarter meet, but
// each wall crosses a few faces only.
TEST(OctreePairs, thinFacesThatLieAskewHaveFewPairs) {
	constexpr std::uint32_t kCount = 800;
	for (const double tilt : {0.0, 0.3}) {
		SCOPED_TRACE(tilt);
		Mesh flat = fan(kCount, {0, 0, 0}, 1, 0), ring;
		flat.points[0] = {0.01, 0.02, 0};
		for (Point& p : flat.points) {
			p[2] = tilt * (p[0] + p[1]);
		}
		for (std::uint32_t i = 0; i < kCount; ++i) {
			const double angle = 2 * shapes::kPi * i / kCount;
			ring.points.push_back({0.7 * std::cos(angle), 0.7 * std::sin(angle), -1});
			ring.points.push_back({0.7 * std::cos(angle), 0.7 * std::sin(angle), 1});
			const std::uint32_t here = 2 * i, next = 2 * ((i + 1) % kCount);
			ring.triangles.push_back({here, next, here + 1});
			ring.triangles.push_back({next, next + 1, here + 1});
		}
		EXPECT_GT(expectAllPairs(flat, ring), 100 * kCount);
		EXPECT_LT(found(shapes::arrays(flat, ring)).size(), 80 * kCount);
		EXPECT_LT(found(shapes::arrays(ring, flat)).size(), 80 * kCount);
	}
}

TEST(OctreePairs, closedSurfacesAgreeWithBruteForce) {
	const Mesh sphere = shapes::sphere(20, {0, 0, 0}, 1);
	EXPECT_GT(expectAllPairs(sphere, shapes::sphere(24, {0.7, 0.3, 0.1}, 1)), 100U);
	EXPECT_GT(expectAllPairs(sphere, sphere), 1520U);
	EXPECT_GT(expectAllPairs(shapes::box({-2, -0.1, -0.1}, {2, 0.1, 0.1}), sphere), 50U);
}

TEST(OctreePairs, coordinatesAtTheLimitsOfDoubleAgreeWithBruteForce) {
	std::mt19937 random(11);
	const Mesh a = uniformSoup(500, 0.05, random);
	const Mesh b = uniformSoup(500, 0.05, random);
	for (const double scale : {1.7e308, 1e300, 1e30, 1e-30, 1e-300, 1e-310, 1e-320}) {
		SCOPED_TRACE(scale);
		expectAllPairs(mapped(a, scale / 1.06, {0, 0, 0}), mapped(b, scale / 1.06, {0, 0, 0}));
	}
	expectAllPairs(mapped(a, 1.6e308, {0, 0, 0}), mapped(b, 1e-300, {0, 0, 0}));
}

TEST(OctreePairs, placesFarFromTheOriginAddNoPairs) {
	std::mt19937 random(13);
	const Mesh a = uniformSoup(800, 0.05, random);
	const Mesh b = uniformSoup(800, 0.05, random);
	for (const double offset : {1e6, 1e12}) {
		SCOPED_TRACE(offset);
		const Point place = {offset, -offset, offset / 3};
		expectAllPairs(mapped(a, 1, place), mapped(b, 1, place));
	}
}

// In general position rounding leaves no doubt, so what a plane parts is never listed.
TEST(OctreePairs, facesThatAPlanePartsAreNoPair) {
	std::mt19937 random(17);
	const Mesh a = uniformSoup(400, 0.5, random);
	const MeshArrays mesh = shapes::arrays(a, uniformSoup(400, 0.5, random));
	const Pairs pairs = found(mesh);
	EXPECT_GT(pairs.size(), 1000U);
	for (const auto& [first, second] : pairs) {
		EXPECT_FALSE(apart(mesh, first, second)) << first << ' ' << second;
	}
}

TEST(OctreePairs, boxesThatTouchArePairs) {
	const Mesh a = singleTriangle({-1, -1, -1}, {0, 0, 0}, {-1, 0, -1});
	EXPECT_EQ(expectAllPairs(a, singleTriangle({0, 0, 0}, {1, 1, 1}, {1, 0, 1})), 1U);
	EXPECT_EQ(expectAllPairs(a, singleTriangle({-0.0, 0, 0}, {1, -1, 1}, {1, -1, 1})), 1U);
	const double beyond = std::numeric_limits<double>::denorm_min();
	EXPECT_EQ(expectAllPairs(a, singleTriangle({beyond, 0, 0}, {1, 1, 1}, {1, 0, 1})), 0U);
}

TEST(OctreePairs, operandsApartHaveNoPairs) {
	const Mesh a = shapes::sphere(10, {0, 0, 0}, 1);
	EXPECT_TRUE(found(shapes::arrays(a, shapes::sphere(10, {3, 0, 0}, 1))).empty());
	EXPECT_TRUE(found(shapes::arrays(a, shapes::sphere(10, {1.9, 1.9, 1.9}, 1))).empty());
}

TEST(OctreePairs, verticesWithoutFacesAreIgnored) {
	Mesh a = shapes::sphere(10, {0, 0, 0}, 1);
	Mesh b = shapes::sphere(10, {1, 0.2, 0.1}, 1);
	const Pairs pairs = found(shapes::arrays(a, b));
	const double infinity = std::numeric_limits<double>::infinity();
	const double nan = std::numeric_limits<double>::quiet_NaN();
	for (Mesh* mesh : {&a, &b}) {
		mesh->points.push_back({nan, nan, nan});
		mesh->points.push_back({infinity, infinity, infinity});
		mesh->points.push_back({-infinity, -infinity, -infinity});
	}
	EXPECT_EQ(found(shapes::arrays(a, b)), pairs);
}

// Else all faces would share a few cells, and their pairs would be tested one by one.
TEST(FaceBoxes, verticesWithoutFacesFarAwayMakeNoBoxCoarse) {
	Mesh a = shapes::sphere(40, {0, 0, 0}, 1);
	Mesh b = shapes::sphere(40, {1, 0.2, 0.1}, 1);
	Monitor monitor;
	FaceBoxes clean;
	ASSERT_TRUE(collectFaceBoxes(shapes::arrays(a, b), 0, monitor, clean).ok());
	EXPECT_LT(clean.operand[kFirst].size(), a.triangles.size() / 2);
	const Pairs pairs = found(shapes::arrays(a, b));
	for (const Point& stray : {Point{1e9, 1e9, 1e9}, Point{0, -40, 0}, Point{1e300, -1e-300, 7}}) {
		Mesh c = a, d = b;
		c.points.push_back(stray);
		d.points.push_back(stray);
		const MeshArrays mesh = shapes::arrays(c, d);
		FaceBoxes boxes;
		ASSERT_TRUE(collectFaceBoxes(mesh, 0, monitor, boxes).ok());
		for (const OperandId k : clean.operand.operands()) {
			EXPECT_LE(boxes.operand[k].size(), clean.operand[k].size());
		}
		EXPECT_EQ(found(mesh), pairs);
	}
}

TEST(OctreePairs, listDoesNotDependOnTheThreads) {
	const Mesh a = shapes::sphere(160, {0, 0, 0}, 1);
	const MeshArrays mesh = shapes::arrays(a, shapes::sphere(170, {0.1, 0.03, 0.02}, 1));
	Options options;
	options.threads = 1;
	const Pairs pairs = found(mesh, options);
	EXPECT_GT(pairs.size(), 5000U);
	for (const int threads : {0, 2, 3, 8}) {
		options.threads = threads;
		for (int repeat = 0; repeat < 3; ++repeat) {
			EXPECT_EQ(found(mesh, options), pairs) << threads;
		}
	}
}

// One leaf in which most pairs meet along the sweep's axis, whichever it is, but never in space:
// the gap is smaller than a cell of the grid.
TEST(OctreePairs, cancelIsHeardInsideOneLeaf) {
	constexpr int kCount = 20000;
	const auto add = [](Mesh& mesh, Point lo, Point hi) {
		const auto first = static_cast<std::uint32_t>(mesh.points.size());
		for (const Point& p : {lo, Point{hi[0], hi[1], lo[2]}, hi}) {
			mesh.points.push_back(p);
		}
		mesh.triangles.push_back({first, first + 1, first + 2});
	};
	Mesh a, b;
	add(a, {0.9, 0.9, 0.9}, {1, 1, 1});
	for (int i = 0; i < kCount; ++i) {
		add(a, {0, 0, 0}, {0.4, 0.4, 0.4});
		Point lo{};
		lo[static_cast<std::size_t>(i % 3)] = 0.4001;
		add(b, lo, {1, 1, 1});
	}
	const MeshArrays mesh = shapes::arrays(a, b);
	Options options;
	options.octreeMaxDepth = 1;
	for (const int threads : {1, 2}) {
		options.threads = threads;
		int calls = 0;
		Monitor monitor([&calls](double, const char*) { return ++calls < 4; });
		monitor.beginStage("pairs", 0, 1);
		std::vector<FacePair> pairs;
		EXPECT_EQ(findPairs(mesh, options, monitor, pairs).code, StatusCode::Cancelled);
		EXPECT_EQ(calls, 4);
	}
}
