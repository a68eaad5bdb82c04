// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The exchange with vcglib, on meshes in float and in double that are none of MeshLab's.
#include <vcg_ext/mesh/mesh_arrays_vcg.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace index_boolean {
namespace {

class FloatVertex;
class FloatFace;
struct FloatTypes
    : vcg::UsedTypes<vcg::Use<FloatVertex>::AsVertexType, vcg::Use<FloatFace>::AsFaceType> {};
class FloatVertex : public vcg::Vertex<FloatTypes, vcg::vertex::Coord3f, vcg::vertex::Normal3f,
                                       vcg::vertex::BitFlags> {};
class FloatFace
    : public vcg::Face<FloatTypes, vcg::face::VertexRef, vcg::face::Normal3f, vcg::face::BitFlags> {
};
using FloatMesh = vcg::tri::TriMesh<std::vector<FloatVertex>, std::vector<FloatFace>>;

class DoubleVertex;
class DoubleFace;
struct DoubleTypes
    : vcg::UsedTypes<vcg::Use<DoubleVertex>::AsVertexType, vcg::Use<DoubleFace>::AsFaceType> {};
class DoubleVertex : public vcg::Vertex<DoubleTypes, vcg::vertex::Coord3d, vcg::vertex::Normal3d,
                                        vcg::vertex::BitFlags> {};
class DoubleFace : public vcg::Face<DoubleTypes, vcg::face::VertexRef, vcg::face::Normal3d,
                                    vcg::face::BitFlags> {};
using DoubleMesh = vcg::tri::TriMesh<std::vector<DoubleVertex>, std::vector<DoubleFace>>;

struct Surface {
	Points points;
	IndexTriangles triangles;
};

Surface tetrahedron(double size) {
	return {{{0, 0, 0}, {size, 0, 0}, {0, size, 0}, {0, 0, size}},
	        {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

// A closed torus of n x n quads, large enough for several threads.
Surface torus(std::uint32_t n) {
	Surface surface;
	const double step = 2 * std::acos(-1.0) / n;
	for (std::uint32_t i = 0; i < n; ++i) {
		for (std::uint32_t j = 0; j < n; ++j) {
			const double u = step * i, v = step * j, r = 2 + std::cos(v);
			surface.points.push_back({r * std::cos(u), r * std::sin(u), std::sin(v)});
			const std::uint32_t a = i * n + j, b = (i + 1) % n * n + j;
			const std::uint32_t c = (i + 1) % n * n + (j + 1) % n, d = i * n + (j + 1) % n;
			surface.triangles.push_back({a, b, c});
			surface.triangles.push_back({a, c, d});
		}
	}
	return surface;
}

// In several ranges, if the surface is large.
template <class Mesh>
void write(const Surface& surface, Mesh& mesh, const std::vector<std::uint8_t>& faux = {}) {
	constexpr std::size_t kRange = 1000;
	Monitor monitor;
	SurfaceWriter<Mesh> writer(surface.points, surface.triangles, faux, mesh);
	ASSERT_TRUE(writer.begin(monitor).ok());
	ASSERT_TRUE(writer.findVertexNormals(monitor).ok());
	for (std::size_t f = 0; f < surface.triangles.size(); f += kRange) {
		writer.appendFaces(f, std::min(f + kRange, surface.triangles.size()));
	}
	for (std::size_t v = 0; v < surface.points.size(); v += kRange) {
		writer.appendVertices(v, std::min(v + kRange, surface.points.size()));
	}
}

template <class Mesh>
LiveElements read(const Mesh& mesh, const vcg::Matrix44<typename Mesh::ScalarType>& transform,
                  OperandId operand, MeshArrays& arrays) {
	Monitor monitor;
	OperandElements elements;
	EXPECT_TRUE(appendOperand(mesh, transform, operand, monitor, arrays, elements).ok());
	return elements.faces;
}

template <class Mesh>
class MeshArraysVcg : public testing::Test {
public:
	using Matrix = vcg::Matrix44<typename Mesh::ScalarType>;
};
using Meshes = testing::Types<FloatMesh, DoubleMesh>;
TYPED_TEST_SUITE(MeshArraysVcg, Meshes);

TYPED_TEST(MeshArraysVcg, whatIsWrittenReadsBackUnchanged) {
	const Surface surface = tetrahedron(0.75);
	TypeParam mesh;
	write(surface, mesh);
	MeshArrays arrays;
	const LiveElements faces = read(mesh, TestFixture::Matrix::Identity(), kFirst, arrays);
	EXPECT_EQ(arrays.points, surface.points);
	ASSERT_EQ(arrays.triangles.size(), surface.triangles.size());
	for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
		EXPECT_EQ(faces[i], i);
		for (std::size_t corner = 0; corner < 3; ++corner) {
			EXPECT_EQ(arrays.triangles[i][corner].value, surface.triangles[i][corner]);
		}
	}
	EXPECT_EQ(mesh.bbox.min, (typename TypeParam::CoordType(0, 0, 0)));
	EXPECT_EQ(mesh.bbox.max, (typename TypeParam::CoordType(0.75, 0.75, 0.75)));
}

TYPED_TEST(MeshArraysVcg, coordinatesAreTheMeshsOwnProductWithTheMatrix) {
	TypeParam mesh;
	write(torus(12), mesh);
	typename TestFixture::Matrix matrix, shift;
	matrix.SetRotateRad(typename TypeParam::ScalarType(0.7), {1, 2, 3});
	shift.SetTranslate(typename TypeParam::ScalarType(0.1), 20, -3);
	matrix = shift * matrix;
	MeshArrays arrays;
	read(mesh, matrix, kFirst, arrays);
	for (std::size_t i = 0; i < mesh.vert.size(); ++i) {
		const typename TypeParam::CoordType expected = matrix * mesh.vert[i].cP();
		for (int axis = 0; axis < 3; ++axis) {
			EXPECT_EQ(arrays.points[i][static_cast<std::size_t>(axis)],
			          static_cast<double>(expected[axis]));
		}
	}
}

TYPED_TEST(MeshArraysVcg, theSecondOperandFollowsTheFirst) {
	TypeParam first, second;
	write(tetrahedron(1), first);
	write(torus(5), second);
	MeshArrays arrays;
	read(first, TestFixture::Matrix::Identity(), kFirst, arrays);
	read(second, TestFixture::Matrix::Identity(), kSecond, arrays);
	EXPECT_EQ(arrays.vertexOffsets, (OperandOffsets{4, 29}));
	EXPECT_EQ(arrays.faceOffsets, (OperandOffsets{4, 54}));
	EXPECT_EQ(arrays.triangles[4][0], VertexId{4});
}

// No mesh that large is needed: the counts are looked at before anything else.
TYPED_TEST(MeshArraysVcg, countsBeyondTheLimitAreRefusedBeforeAnythingIsRead) {
	TypeParam first, tooManyVertices, tooManyFaces;
	write(tetrahedron(1), first);
	tooManyVertices.vn = std::numeric_limits<int>::max();
	tooManyFaces.fn = std::numeric_limits<int>::max() - 3;
	MeshArrays arrays;
	read(first, TestFixture::Matrix::Identity(), kFirst, arrays);
	for (const auto& [mesh, count] : {std::pair<const TypeParam*, std::size_t>{&tooManyVertices, 4},
	                                  std::pair<const TypeParam*, std::size_t>{&tooManyFaces, 1}}) {
		Monitor monitor;
		OperandElements elements;
		const Status status = appendOperand(*mesh, TestFixture::Matrix::Identity(), kSecond,
		                                    monitor, arrays, elements);
		EXPECT_EQ(status.code, StatusCode::TooLarge);
		EXPECT_EQ(status.count, (std::size_t{1} << 31) - 1 + count);
		EXPECT_EQ(arrays.points.size(), 4u);
		EXPECT_EQ(arrays.triangles.size(), 4u);
	}
}

TYPED_TEST(MeshArraysVcg, deletedElementsAreLeftOutAndFacesAreFoundAgain) {
	using Allocator = vcg::tri::Allocator<TypeParam>;
	TypeParam mesh;
	Surface surface = tetrahedron(1);
	surface.points.insert(surface.points.begin() + 1, Point{9, 9, 9});
	surface.triangles = {{0, 3, 2}, {1, 1, 1}, {0, 2, 4}, {0, 4, 3}, {2, 3, 4}};
	write(surface, mesh);
	Allocator::DeleteFace(mesh, mesh.face[1]);
	Allocator::DeleteVertex(mesh, mesh.vert[1]);
	MeshArrays arrays;
	const LiveElements faces = read(mesh, TestFixture::Matrix::Identity(), kFirst, arrays);
	EXPECT_EQ(arrays.points, tetrahedron(1).points);
	ASSERT_EQ(arrays.triangles.size(), 4u);
	EXPECT_EQ(arrays.triangles[3], (Triangle{VertexId{1}, VertexId{2}, VertexId{3}}));
	EXPECT_EQ(faces.positions, (std::vector<std::uint32_t>{0, 2, 3, 4}));
}

TYPED_TEST(MeshArraysVcg, aCornerThatIsNoLiveVertexHasNoId) {
	TypeParam mesh, other;
	write(tetrahedron(1), mesh);
	write(tetrahedron(1), other);
	mesh.face[0].V(0) = nullptr;
	mesh.face[1].V(1) = &other.vert[0];
	vcg::tri::Allocator<TypeParam>::DeleteVertex(mesh, mesh.vert[3]);
	MeshArrays arrays;
	read(mesh, TestFixture::Matrix::Identity(), kFirst, arrays);
	EXPECT_EQ(arrays.triangles[0][0], VertexId::none());
	EXPECT_EQ(arrays.triangles[1][1], VertexId::none());
	EXPECT_EQ(arrays.triangles[3][2], VertexId::none());
	EXPECT_EQ(arrays.triangles[3][1], VertexId{2});
}

TYPED_TEST(MeshArraysVcg, normalsAreUnitVectorsAlongTheFacesAtEverySize) {
	using Limits = std::numeric_limits<typename TypeParam::ScalarType>;
	for (const int exponent : {Limits::min_exponent + 3, 0, Limits::max_exponent - 3}) {
		TypeParam mesh;
		write(tetrahedron(std::ldexp(1, exponent)), mesh);
		const double third = 1 / std::sqrt(3.0);
		EXPECT_EQ(mesh.face[0].N(), (typename TypeParam::CoordType(0, 0, -1)));
		for (int axis = 0; axis < 3; ++axis) {
			EXPECT_NEAR(mesh.face[3].N()[axis], third, 1e-7) << "size 2^" << exponent;
			EXPECT_NEAR(mesh.vert[0].N()[axis], -third, 1e-7) << "size 2^" << exponent;
		}
	}
}

TYPED_TEST(MeshArraysVcg, anEmptySurfaceMakesAnEmptyMesh) {
	TypeParam mesh;
	write(Surface{}, mesh);
	EXPECT_EQ(mesh.vn, 0);
	EXPECT_EQ(mesh.fn, 0);
	EXPECT_TRUE(mesh.bbox.IsNull());
}

TYPED_TEST(MeshArraysVcg, vertexNormalsAreTheFacesWeightedByArea) {
	const Surface surface = torus(100);
	TypeParam mesh;
	write(surface, mesh);
	// Of the differences of the mesh's coordinates, which are a hundredth of these.
	constexpr double tolerance =
	    1000 * std::numeric_limits<typename TypeParam::ScalarType>::epsilon();
	std::vector<vcg::Point3d> sums(surface.points.size(), vcg::Point3d(0, 0, 0));
	for (const auto& face : mesh.face) {
		for (int corner = 0; corner < 3; ++corner) {
			const auto normal = (face.cP(1) - face.cP(0)) ^ (face.cP(2) - face.cP(0));
			sums[vcg::tri::Index(mesh, face.cV(corner))] += vcg::Point3d::Construct(normal);
		}
	}
	for (std::size_t i = 0; i < surface.points.size(); ++i) {
		const auto normal = vcg::Point3d::Construct(mesh.vert[i].N());
		ASSERT_LT((normal - sums[i].Normalize()).Norm(), tolerance) << "vertex " << i;
	}
}

TYPED_TEST(MeshArraysVcg, fauxEdgesAreReadAndWritten) {
	TypeParam plain, quads;
	write(tetrahedron(1), plain);
	const Surface many = torus(200);
	std::vector<std::uint8_t> faux;
	for (std::size_t i = 0; i < many.triangles.size(); ++i) {
		faux.push_back(static_cast<std::uint8_t>(i % 8));
	}
	write(many, quads, faux);
	EXPECT_TRUE(quads.face[5].IsF(0) && !quads.face[5].IsF(1) && quads.face[5].IsF(2));
	vcg::tri::Allocator<TypeParam>::DeleteFace(quads, quads.face[1]);

	MeshArrays none, first, second;
	read(plain, TestFixture::Matrix::Identity(), kFirst, none);
	EXPECT_TRUE(none.faux.empty());
	read(quads, TestFixture::Matrix::Identity(), kFirst, first);
	read(plain, TestFixture::Matrix::Identity(), kSecond, first);
	read(plain, TestFixture::Matrix::Identity(), kFirst, second);
	read(quads, TestFixture::Matrix::Identity(), kSecond, second);
	faux.erase(faux.begin() + 1);
	std::vector<std::uint8_t> before(4, 0), behind = faux;
	behind.insert(behind.end(), 4, 0);
	before.insert(before.end(), faux.begin(), faux.end());
	EXPECT_EQ(first.faux, behind);
	EXPECT_EQ(second.faux, before);
}

TYPED_TEST(MeshArraysVcg, aCancelledMonitorStopsReadingAndWriting) {
	const Surface surface = tetrahedron(1);
	TypeParam mesh;
	write(surface, mesh);
	Monitor monitor([](double, const char*) { return false; });
	monitor.beginStage("cancelled", 0, 1);
	MeshArrays arrays;
	OperandElements elements;
	EXPECT_EQ(
	    appendOperand(mesh, TestFixture::Matrix::Identity(), kFirst, monitor, arrays, elements)
	        .code,
	    StatusCode::Cancelled);
	TypeParam other;
	const std::vector<std::uint8_t> faux;
	SurfaceWriter<TypeParam> writer(surface.points, surface.triangles, faux, other);
	EXPECT_EQ(writer.begin(monitor).code, StatusCode::Cancelled);
	EXPECT_EQ(writer.findVertexNormals(monitor).code, StatusCode::Cancelled);
}

}  // namespace
}  // namespace index_boolean
