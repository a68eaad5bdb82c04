// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cracked layers: welded by a distance, refused where that leads too far, and told which distance
// would close them.
#include "core/any_operands.h"

#include <vcg_ext/mesh/closing_distance.h>
#include <vcg_ext/mesh/near_vertices.h>

#include <gtest/gtest.h>

#include <limits>
#include <set>

namespace index_boolean {
namespace {

using shapes::Mesh;

// A soup whose corners are moved by up to `most` along each axis.
Mesh cracked(const Mesh& m, double most, std::mt19937& random) {
	Mesh soup = shapes::soup(m);
	std::uniform_real_distribution<double> by(-most, most);
	for (Point& p : soup.points) {
		p = {p[0] + by(random), p[1] + by(random), p[2] + by(random)};
	}
	return soup;
}

// The same by at most one step of each coordinate.
Mesh crackedByUlps(const Mesh& m, std::mt19937& random) {
	Mesh soup = shapes::soup(m);
	constexpr double kInfinity = std::numeric_limits<double>::infinity();
	for (Point& p : soup.points) {
		for (double& x : p) {
			const std::array<double, 3> choice{x, std::nextafter(x, kInfinity),
			                                   std::nextafter(x, -kInfinity)};
			x = choice[random() % 3];
		}
	}
	return soup;
}

Status weld(double distance, MeshArrays& arrays, VertexWeld& out) {
	Monitor monitor;
	return weldNearVertices(distance, monitor, arrays, out);
}

double closingDistanceOf(const Mesh& m) {
	Monitor monitor;
	double distance = -1;
	EXPECT_TRUE(findClosingDistance(shapes::arrays(m, m), kSecond, monitor, distance).ok());
	return distance;
}

// Blocks of two operands by the entry that the filter has.
struct OperandsRun {
	Status status;
	Arrangement arrangement;
	std::vector<Block> blocks;
	Audit audit;
};

OperandsRun runOperands(const Mesh& a, const Mesh& b, const Options& options) {
	OperandsRun r;
	Monitor monitor;
	const auto again = [&](MeshArrays& out) {
		out = shapes::arrays(a, b);
		return Status{};
	};
	r.status = arrangeOperands(shapes::arrays(a, b), again, options, monitor, r.arrangement);
	for (const Operation o : {Operation::Union, Operation::Intersection}) {
		r.blocks.emplace_back();
		if (r.status.ok()) {
			r.status = extractBlock(r.arrangement, o, monitor, r.blocks.back());
		}
	}
	if (r.status.ok()) {
		r.status = audit(r.arrangement, r.blocks, monitor, r.audit);
	}
	return r;
}

Options welding(double distance) {
	Options options;
	options.weldDistance = distance;
	return options;
}

const Mesh& ball() {
	static const Mesh mesh = shapes::sphere(7, {0.1, 0.2, 0.3}, 1);
	return mesh;
}

const Mesh& cube() {
	static const Mesh mesh = shapes::box({0, 0, 0}, {2, 2, 2});
	return mesh;
}

TEST(NearVertices, becomeTheFirstOfThemInOneOperandAlone) {
	Mesh a = shapes::box({0, 0, 0}, {1, 1, 1}), b = a;
	a.points.push_back({1 - 1e-3, 1, 1});
	a.triangles[10][2] = 8;  // one corner of one face, beside the box's
	b.points[0] = {1e-4, 0, 0};
	MeshArrays arrays = shapes::arrays(a, b);
	const Points given = arrays.points;
	VertexWeld out;
	ASSERT_TRUE(weld(1.1e-3, arrays, out).ok());
	EXPECT_EQ(out.moved, 1u);  // of (1, 1, 1) and the vertex beside it the latter comes first
	EXPECT_DOUBLE_EQ(out.largestMove, 1e-3);
	for (std::size_t v = 0; v < given.size(); ++v) {
		const Point expected = v == 7 ? Point{1 - 1e-3, 1, 1} : given[v];
		EXPECT_EQ(arrays.points[v], expected) << v;
	}
	ASSERT_TRUE(weld(0, arrays, out).ok());
	EXPECT_EQ(out.moved, 0u);
}

TEST(NearVertices, thatNoFaceUsesOrThatAreNotFiniteDoNotCount) {
	constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
	Mesh a = cube();
	a.points.insert(a.points.end(), {{-1e-9, 0, 0}, {kNan, 0, 0}, {1e300 * 1e300, 0, 0}});
	a.triangles.push_back({0, 9, 10});
	a.triangles.push_back({0, 1, 77});  // names no vertex
	MeshArrays arrays = shapes::arrays(cube(), a);
	const std::size_t first = cube().points.size();
	VertexWeld out;
	ASSERT_TRUE(weld(0.5, arrays, out).ok());
	EXPECT_EQ(out.moved, 0u);
	EXPECT_EQ(arrays.points[first], (Point{0, 0, 0}));
}

TEST(NearVertices, thatChainsLinkTooFarApartAreRefusedWithTheirFaces) {
	const Mesh row = shapes::sphere(30, {5, 0, 0}, 1);  // edges of up to 0.1
	MeshArrays arrays = shapes::arrays(cube(), row);
	const Points given = arrays.points;
	VertexWeld out;
	const Status status = weld(0.2, arrays, out);
	ASSERT_EQ(status.code, StatusCode::WeldTooWide);
	EXPECT_EQ(status.operand, 1);
	EXPECT_EQ(status.count, 1u);
	EXPECT_EQ(status.faces.size(), row.triangles.size());
	EXPECT_EQ(status.place, *std::min_element(row.points.begin(), row.points.end()));
	EXPECT_EQ(arrays.points, given);
	EXPECT_EQ(runOperands(cube(), row, welding(0.2)).status.code, StatusCode::WeldTooWide);
}

TEST(NearVertices, closeACrackedLayerInAnyNumbering) {
	std::mt19937 random(7);
	const double whole = shapes::volumeOf(ball().points, ball().triangles);
	for (int run = 0; run < 4; ++run) {
		const double most = run == 0 ? 0 : std::pow(10.0, -3 * run);
		const Mesh soup = run == 0 ? crackedByUlps(ball(), random) : cracked(ball(), most, random);
		const double distance = run == 0 ? 1e-14 : 4 * most;
		const OperandsRun open = runOperands(soup, cube(), {});
		EXPECT_EQ(open.status.code, StatusCode::NotClosed);
		const OperandsRun r = runOperands(soup, cube(), welding(distance));
		ASSERT_TRUE(r.status.ok()) << describe(r.status);
		EXPECT_GT(r.arrangement.vertexWeld.moved, soup.points.size() / 2);
		EXPECT_GT(r.arrangement.vertexWeld.largestMove, 0);
		EXPECT_LE(r.arrangement.vertexWeld.largestMove, 2 * distance);
		EXPECT_NEAR(r.audit.blocks[0].volume + r.audit.blocks[1].volume, 8 + whole,
		            20 * distance + 1e-13);
		const OperandsRun other =
		    runOperands(shapes::permuted(soup, random), cube(), welding(distance));
		for (std::size_t b = 0; b < 2; ++b) {
			EXPECT_EQ(shapes::geometry(other.blocks[b]), shapes::geometry(r.blocks[b]));
		}
	}
}

TEST(NearVertices, ofLayersThatMeetThemselvesAreWeldedInTheSecondRun) {
	std::mt19937 random(2);
	const Mesh two = shapes::joined(cube(), shapes::box({1, 1, 1}, {3, 3, 3}));
	const Mesh other = shapes::box({-1, -1, -1}, {0.5, 0.5, 0.5});
	const OperandsRun r = runOperands(cracked(two, 1e-9, random), other, welding(1e-8));
	ASSERT_TRUE(r.status.ok()) << describe(r.status);
	EXPECT_TRUE(r.arrangement.isSoup);
	EXPECT_GT(r.arrangement.vertexWeld.moved, 40u);
	EXPECT_NEAR(r.audit.blocks[0].volume, 15 + 3.375 - 0.125, 1e-6);
}

TEST(NearVertices, areWeldedForSplittingToo) {
	std::mt19937 random(4);
	const Mesh soup = cracked(cube(), 1e-9, random);
	const Mesh sheet{{{-1, -1, 1}, {3, -1, 1}, {3, 3, 1}, {-1, 3, 1}}, {{0, 1, 2}, {0, 2, 3}}};
	const auto blocksWith = [&](double distance) {
		Monitor monitor;
		Arrangement arrangement;
		Split parts;
		const auto again = [&](MeshArrays& out) {
			out = shapes::arrays(soup, sheet);
			return Status{};
		};
		EXPECT_TRUE(splitOperands(shapes::arrays(soup, sheet), again, welding(distance), monitor,
		                          arrangement, parts)
		                .ok());
		return parts.blocks.all.size();
	};
	EXPECT_EQ(blocksWith(0), 0u);
	EXPECT_EQ(blocksWith(1e-8), 2u);
}

// --- the distance that a refusal names ----------------------------------------------------------

TEST(ClosingDistance, isFoundForCracksAndTheNextSmallerNumberLeavesThemOpen) {
	std::mt19937 random(9);
	const std::array<double, 3> digits{1, 2, 5};
	for (int run = 0; run < 5; ++run) {
		const Mesh soup = run == 0 ? crackedByUlps(ball(), random)
		                           : cracked(ball(), std::pow(10.0, -2 - run), random);
		const double distance = closingDistanceOf(soup);
		ASSERT_GT(distance, 0);
		const OperandsRun refused = runOperands(soup, cube(), {});
		EXPECT_EQ(refused.status.code, StatusCode::NotClosed);
		EXPECT_EQ(refused.status.closingDistance, distance);
		EXPECT_TRUE(runOperands(soup, cube(), welding(distance)).status.ok());
		const double smaller = distance * (distance < 2e-15 ? 0.1 : 0.39);
		EXPECT_FALSE(runOperands(soup, cube(), welding(smaller)).status.ok());
		const double power = std::pow(10.0, std::floor(std::log10(distance * 1.0000001)));
		EXPECT_TRUE(std::any_of(digits.begin(), digits.end(), [&](double digit) {
			return std::fabs(distance / power - digit) < 1e-6;
		})) << distance;
	}
}

TEST(ClosingDistance, isNoneForAHoleNorForACrackBesideOne) {
	std::mt19937 random(6);
	Mesh hole = ball();
	hole.triangles.erase(hole.triangles.begin() + 50);
	EXPECT_EQ(closingDistanceOf(hole), 0);
	EXPECT_EQ(closingDistanceOf(cracked(hole, 1e-8, random)), 0);
	EXPECT_EQ(runOperands(hole, cube(), {}).status.closingDistance, 0);
	const Mesh sheet{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
	EXPECT_EQ(closingDistanceOf(sheet), 0);
}

TEST(ClosingDistance, isNoneForAHoleThatIsSmallButNoCrack) {
	Mesh spot = ball();
	const auto [a, b, c] = spot.triangles[20];  // has a hole in its middle, and six faces around it
	spot.triangles.erase(spot.triangles.begin() + 20);
	const auto p = static_cast<std::uint32_t>(spot.points.size()), q = p + 1, r = p + 2;
	const std::array<std::uint32_t, 3> corners{a, b, c};
	Point middle{};
	for (const std::uint32_t corner : corners) {
		for (std::size_t k = 0; k < 3; ++k) {
			middle[k] += spot.points[corner][k] / 3;
		}
	}
	for (const std::uint32_t corner : corners) {
		Point near = middle;
		for (std::size_t k = 0; k < 3; ++k) {
			near[k] += 1e-6 * (spot.points[corner][k] - middle[k]);
		}
		spot.points.push_back(near);
	}
	for (const IndexTriangle& t :
	     {IndexTriangle{a, b, p}, IndexTriangle{b, q, p}, IndexTriangle{b, c, q},
	      IndexTriangle{c, r, q}, IndexTriangle{c, a, r}, IndexTriangle{a, p, r}}) {
		spot.triangles.push_back(t);
	}
	EXPECT_EQ(closingDistanceOf(spot), 0);
	spot.triangles.push_back({p, q, r});
	EXPECT_TRUE(runOperands(spot, cube(), {}).status.ok());
}

TEST(ClosingDistance, isNoneWhereALayerIsAsSmallAsNumbersAre) {
	constexpr double kTiny = std::numeric_limits<double>::denorm_min();
	const Mesh sheet{{{0, 0, 0}, {kTiny, 0, 0}, {0, kTiny, 0}}, {{0, 1, 2}}};
	EXPECT_EQ(closingDistanceOf(sheet), 0);
	constexpr double kHuge = std::numeric_limits<double>::max();
	const Mesh large{{{-kHuge, 0, 0}, {kHuge, 0, 0}, {0, kHuge, 0}}, {{0, 1, 2}}};
	EXPECT_EQ(closingDistanceOf(large), 0);
}

}  // namespace
}  // namespace index_boolean
