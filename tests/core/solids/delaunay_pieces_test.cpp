// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What triangles a block has where faces have been cut and merged: an edge that the block keeps on
// both sides stays one, and walls of both operands that coincide are cut alike.
#include "core/shapes.h"

#include <vcg_ext/exact/exact_sign.h>

#include <gtest/gtest.h>

#include <set>

namespace index_boolean {
namespace {

using namespace shapes;

// Right side out.
Mesh solid(const Mesh& m) { return volumeOf(m.points, m.triangles) > 0 ? m : turned(m); }

Mesh tetrahedron(const std::array<Point, 4>& corners) {
	Mesh m;
	m.points.assign(corners.begin(), corners.end());
	m.triangles = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
	return solid(m);
}

// A wedge with its lower edge from (1.5, 1, 2) to (3.5, 1, 2).
Mesh wedge() {
	Mesh m;
	m.points = {{1.5, 1, 2},   {3.5, 1, 2},   {1.5, 0.5, 4},
	            {3.5, 0.5, 4}, {1.5, 1.5, 4}, {3.5, 1.5, 4}};
	m.triangles = {{0, 2, 1}, {1, 2, 3}, {0, 1, 4}, {1, 5, 4},
	               {2, 4, 3}, {3, 4, 5}, {0, 4, 2}, {1, 3, 5}};
	return solid(m);
}

std::size_t facesAtEdge(const Block& block, const Point& a, const Point& b) {
	std::size_t count = 0;
	for (const IndexTriangle& t : block.triangles) {
		const auto has = [&](const Point& p) {
			return std::any_of(t.begin(), t.end(),
			                   [&](std::uint32_t v) { return block.points[v] == p; });
		};
		count += has(a) && has(b) ? 1 : 0;
	}
	return count;
}

// The sets of corners of all pieces of one operand that lie in the other's surface.
std::set<std::array<VertexId, 3>> overlaps(const Arrangement& arrangement, OperandId operand) {
	std::set<std::array<VertexId, 3>> found;
	const Refinement& refinement = arrangement.refinement;
	for (std::size_t i = 0; i < refinement.cutFaces.size(); ++i) {
		const Refinement::PieceRange pieces = refinement.piecesOf(i);
		for (std::size_t p = pieces.begin; p < pieces.end; ++p) {
			const Label label = arrangement.labels.piece[p];
			const bool isOn = label == Label::OnSame || label == Label::OnOpposite;
			if (isOn && arrangement.mesh.operandOf(refinement.cutFaces[i].face) == operand) {
				std::array<VertexId, 3> t = refinement.pieces[p];
				std::sort(t.begin(), t.end());
				found.insert(t);
			}
		}
	}
	return found;
}

// Walls at 45 degrees: two components of their normals are equal.
Mesh askew(Mesh m) {
	for (Point& p : m.points) {
		p = {p[0] - p[1], p[0] + p[1], p[2]};
	}
	return m;
}

}  // namespace

// Two tips beside the wedge's edge would have it flipped: counted by place it has four faces.
TEST(DelaunayPieces, aWedgeOnAPlateStandsOnAnEdgeOfIt) {
	const Mesh plate = box({0, 0, 0}, {4, 4, 2});
	for (const double side : {-1.0, 1.0}) {
		SCOPED_TRACE(side);
		const auto tip = [side](double way) {
			const double y = 1 + way * side * 0.1, far = 1 + way * side;
			return tetrahedron(
			    {Point{2.5, y, 2}, {2.4, far, 4}, {2.6, far, 4}, {2.5, far + way * side, 4}});
		};
		const Mesh standing = joined(joined(wedge(), tip(1)), tip(-1));
		const BooleanRun r = run(plate, standing);
		ASSERT_TRUE(r.status.ok()) << describe(r.status);
		const Block& both = r.block(Operation::Union);
		EXPECT_EQ(facesAtEdge(both, {1.5, 1, 2}, {3.5, 1, 2}), 4u);
		EXPECT_EQ(both.certificate.count(), 0);
		EXPECT_EQ(r.audit.blocks[0].components, 4u);
	}
}

TEST(DelaunayPieces, coincidingWallsAreCutAlike) {
	std::size_t compared = 0;
	for (std::uint32_t seed = 0; seed < 60; ++seed) {
		SCOPED_TRACE(seed);
		std::mt19937 random(seed);
		Mesh a = gridBox(random, 4), b = gridBox(random, 4);
		if (seed % 2 == 1) {
			a = askew(a);
			b = askew(b);
		}
		const BooleanRun r = run(permuted(a, random), permuted(b, random));
		ASSERT_TRUE(r.status.ok()) << describe(r.status);
		const auto first = overlaps(r.arrangement, kFirst);
		ASSERT_EQ(first, overlaps(r.arrangement, kSecond));
		compared += first.size();
	}
	EXPECT_GT(compared, 100u);
}

// One wall with 256 corners on a circle of whole numbers' worth of ties, against another wall.
TEST(DelaunayPieces, coincidingDisksAreCutAlike) {
	constexpr std::uint32_t kSides = 256;
	const auto disk = [](double low, double high) {
		Mesh m;
		for (const double z : {low, high}) {
			for (std::uint32_t i = 0; i < kSides; ++i) {
				const double angle = 2 * kPi * i / kSides;
				m.points.push_back({std::cos(angle), std::sin(angle), z});
			}
		}
		for (std::uint32_t i = 0; i < kSides; ++i) {
			const std::uint32_t next = (i + 1) % kSides;
			m.triangles.push_back({i, next, kSides + next});
			m.triangles.push_back({i, kSides + next, kSides + i});
			if (i > 0 && next > 0) {
				m.triangles.push_back({0, next, i});
				m.triangles.push_back({kSides, kSides + i, kSides + next});
			}
		}
		return m;
	};
	const BooleanRun r = run(disk(0, 1), box({-0.9, -0.9, 1}, {2, 0.95, 2}));
	ASSERT_TRUE(r.status.ok()) << describe(r.status);
	const auto first = overlaps(r.arrangement, kFirst);
	EXPECT_GT(first.size(), 100u);
	EXPECT_EQ(first, overlaps(r.arrangement, kSecond));
	for (const Block& block : r.blocks) {
		EXPECT_EQ(block.certificate.count(), 0) << operationName(block.operation);
	}
}

TEST(DelaunayPieces, theAxisIsAFunctionOfThePlane) {
	const Points points = [] {
		Points all;
		for (int x = -2; x <= 2; ++x) {
			for (int z = -2; z <= 2; ++z) {
				all.push_back({0.1 * x, -0.1 * x, 0.3 * z});  // in the plane x + y = 0
			}
		}
		return all;
	}();
	std::size_t count = 0;
	for (std::uint32_t i = 0; i < points.size(); ++i) {
		for (std::uint32_t j = 0; j < points.size(); ++j) {
			for (std::uint32_t k = 0; k < points.size(); ++k) {
				int sign = 0;
				const int axis =
				    projectionAxis({VertexId{i}, VertexId{j}, VertexId{k}}, points, sign);
				if (axis >= 0) {
					ASSERT_EQ(axis, 0);
					ASSERT_EQ(sign, orient2d(points[i], points[j], points[k], 0));
					++count;
				}
			}
		}
	}
	EXPECT_GT(count, 1000u);
}

}  // namespace index_boolean
