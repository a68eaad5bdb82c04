// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Operands at the edge of what is accepted, in both places, at the stage that judges them.
#include "core/shapes.h"
#include "support/stored_faces.h"

#include <vcg_ext/arrange/operands.h>

#include <gtest/gtest.h>

#include <chrono>

namespace index_boolean {
namespace {

using namespace shapes;

const Mesh kUnit = box({0, 0, 0}, {1, 1, 1});

Status prepared(const MeshArrays& mesh) {
	Arrangement arrangement;
	arrangement.mesh = mesh;
	Monitor monitor;
	return prepareOperands(arrangement, monitor);
}

void expectRefused(const Mesh& mesh, StatusCode code, std::size_t count) {
	for (const int operand : {0, 1}) {
		const Status status = prepared(operand == 0 ? arrays(mesh, kUnit) : arrays(kUnit, mesh));
		EXPECT_EQ(status.code, code) << statusName(status.code);
		EXPECT_EQ(status.operand, operand);
		EXPECT_EQ(status.count, count);
	}
}

TEST(Operands, noElementAtAllIsAnEmptyOperand) {
	expectRefused({}, StatusCode::EmptyOperand, 0);
	EXPECT_EQ(prepared(arrays({}, {})).operand, 0);
	EXPECT_EQ(prepared(MeshArrays{}).code, StatusCode::EmptyOperand);
}

TEST(Operands, verticesAloneAreAnEmptyOperand) {
	Mesh cloud = kUnit;
	cloud.triangles.clear();
	expectRefused(cloud, StatusCode::EmptyOperand, 0);
}

TEST(Operands, facesThatCollapseLeaveAnEmptyOperand) {
	Mesh collapsed = kUnit;
	collapsed.triangles = {{0, 0, 1}, {2, 3, 2}, {4, 4, 4}};
	expectRefused(collapsed, StatusCode::EmptyOperand, 0);
	Mesh point = kUnit;
	point.points.assign(8, Point{1, -0.0, 0});
	expectRefused(point, StatusCode::EmptyOperand, 0);
}

TEST(Operands, oneFaceIsOpen) {
	Mesh one = kUnit;
	one.triangles.resize(1);
	expectRefused(one, StatusCode::NotClosed, 3);
}

TEST(Operands, aFaceAndItsOppositeEncloseNothing) {
	Mesh flat = kUnit;
	flat.triangles = {{0, 1, 2}, {2, 1, 0}};
	expectRefused(flat, StatusCode::NoVolume, 0);
}

TEST(Operands, aShellThereTwiceIsOneAndAWallInBothDirectionsIsNone) {
	const Mesh twice = joined(kUnit, kUnit);
	const Mesh two = joined(kUnit, box({1, 0, 0}, {2, 1, 1}));
	const BooleanRun r = run(twice, two);
	ASSERT_TRUE(r.status.ok()) << describe(r.status);
	EXPECT_EQ(r.arrangement.duplicates.takenOnce, (PerOperand<std::size_t>{12, 0}));
	EXPECT_EQ(r.arrangement.duplicates.cancelledPairs, (PerOperand<std::size_t>{0, 2}));
	EXPECT_DOUBLE_EQ(r.volume(Operation::Union), 2);
	EXPECT_DOUBLE_EQ(r.volume(Operation::Intersection), 1);
	EXPECT_DOUBLE_EQ(r.volume(Operation::SecondMinusFirst), 1);
	EXPECT_TRUE(r.block(Operation::FirstMinusSecond).triangles.empty());
}

TEST(Operands, aVertexThatNoFaceUsesIsNotWeldedToTheOthersVertexThere) {
	const Mesh other = box({2, 2, 2}, {3, 3, 3});
	Mesh loose = kUnit;
	loose.points.insert(loose.points.end(), other.points.begin(), other.points.end());
	Mesh flat = loose;  // its faces in the same place cancel, and leave such vertices
	flat.triangles.push_back({8, 9, 10});
	flat.triangles.push_back({10, 9, 8});
	Options options;
	options.weldNonManifold = true;
	for (const Mesh& first : {loose, flat}) {
		const BooleanRun r = run(first, other, options), clean = run(kUnit, other, options);
		ASSERT_TRUE(r.status.ok()) << describe(r.status);
		for (std::size_t k = 0; k < r.blocks.size(); ++k) {
			EXPECT_EQ(brokenPromise(r.blocks[k]), "") << operationName(r.blocks[k].operation);
			EXPECT_EQ(geometry(r.blocks[k]), geometry(clean.blocks[k]));
		}
	}
}

TEST(Operands, manyUnusedVerticesThatAreNoNumbersCostNothing) {
	Mesh loose = kUnit;
	loose.points.resize(std::size_t{1} << 18, Point{std::nan(""), 0, HUGE_VAL});
	const auto start = std::chrono::steady_clock::now();
	EXPECT_TRUE(prepared(arrays(loose, loose)).ok());
	EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
}

TEST(Operands, aWallThatTwoOverlappingComponentsShareIsRefusedWithItsFaces) {
	Mesh wall;  // tetrahedra of heights 1 and 2 on one base
	wall.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 2}};
	wall.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3},
	                  {0, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 0, 4}};
	expectRefused(wall, StatusCode::SelfIntersecting, 2);
}

TEST(Operands, everyKindOfNumberThatIsNotFiniteIsRefusedInAnyCoordinate) {
	const double infinity = std::numeric_limits<double>::infinity();
	for (const double bad : {std::nan(""), -std::nan(""), infinity, -infinity}) {
		for (std::size_t axis = 0; axis < 3; ++axis) {
			Mesh mesh = kUnit;
			mesh.points[0][axis] = bad;
			expectRefused(mesh, StatusCode::NotFinite, 6);
		}
	}
}

TEST(Operands, numbersThatTheOutputScalarCannotHoldAreRefusedAsSuch) {
	const double largest = std::numeric_limits<float>::max();
	const double halfUlp = 0x1p103;
	Options options;
	options.outputScalar = OutputScalar::Float;
	for (const auto& [size, isHeld] :
	     {std::pair(largest, true), std::pair(std::nextafter(largest + halfUlp, 0), true),
	      std::pair(largest + halfUlp, false), std::pair(1e300, false)}) {
		const BooleanRun r = run(kUnit, box({-size, -size, -size}, {size, size, size}), options);
		EXPECT_EQ(r.status.code, isHeld ? StatusCode::Ok : StatusCode::BeyondFloat) << size;
		EXPECT_EQ(r.status.count, isHeld ? 0u : 12u);
	}
}

TEST(Operands, theLargestAndTheSmallestNumbersAreFinite) {
	const double largest = std::numeric_limits<double>::max();
	const double smallest = std::numeric_limits<double>::denorm_min();
	for (const double size : {largest, smallest}) {
		const Mesh mesh = box({-size, -size, -size}, {size, size, size});
		EXPECT_TRUE(prepared(arrays(mesh, kUnit)).ok()) << size;
	}
}

TEST(Operands, verticesThatDoNotExistAreRefused) {
	for (const std::uint32_t bad : {8u, 100u, 0x7fffffffu, 0xffffffffu}) {
		MeshArrays mesh = arrays(kUnit, kUnit);
		mesh.triangles[15][1] = VertexId{8 + bad};
		const Status status = prepared(mesh);
		EXPECT_EQ(status.code, StatusCode::IndexOutOfRange) << bad;
		EXPECT_EQ(status.operand, 1);
		EXPECT_EQ(status.faces, (std::vector<std::uint32_t>{3}));
	}
}

TEST(Operands, aVertexOfTheOtherOperandDoesNotExistInThisOne) {
	MeshArrays mesh = arrays(kUnit, kUnit);
	mesh.triangles[15][1] = VertexId{3};
	EXPECT_EQ(prepared(mesh).operand, 1);
	mesh = arrays(kUnit, kUnit);
	mesh.triangles[5][1] = VertexId{12};
	EXPECT_EQ(prepared(mesh).operand, 0);
}

}  // namespace
}  // namespace index_boolean
