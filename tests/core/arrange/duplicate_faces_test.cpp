// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Faces on the same three vertices, against a count of each triple and direction.
#include "core/shapes.h"

#include <vcg_ext/arrange/duplicate_faces.h>

#include <gtest/gtest.h>

namespace index_boolean {
namespace {

using namespace shapes;

using Corners = std::array<std::uint32_t, 3>;

Arrangement cleaned(const Mesh& a, const Mesh& b, int threads = 0) {
	Arrangement arrangement;
	arrangement.mesh = arrays(a, b);
	arrangement.options.threads = threads;
	Monitor monitor;
	EXPECT_TRUE(removeDuplicateFaces(arrangement, monitor).ok());
	EXPECT_EQ(arrangement.mesh.faceOffsets.total(), arrangement.mesh.triangles.size());
	return arrangement;
}

// The faces of one operand, by vertices of that operand.
IndexTriangles facesOf(const Arrangement& arrangement, OperandId operand) {
	const MeshArrays& mesh = arrangement.mesh;
	IndexTriangles faces;
	for (std::uint32_t face = mesh.faceOffsets.begin(operand); face < mesh.faceOffsets.end(operand);
	     ++face) {
		Corners corners{};
		for (std::size_t i = 0; i < 3; ++i) {
			corners[i] = mesh.triangles[face][i].value - mesh.vertexOffsets.begin(operand);
		}
		faces.push_back(corners);
	}
	return faces;
}

std::vector<std::uint32_t> givenFaces(const Arrangement& arrangement, OperandId operand) {
	std::vector<std::uint32_t> given;
	for (std::uint32_t face = arrangement.mesh.faceOffsets.begin(operand);
	     face < arrangement.mesh.faceOffsets.end(operand); ++face) {
		given.push_back(arrangement.givenFace({face}));
	}
	return given;
}

using Pair = PerOperand<std::size_t>;

const Mesh kUnit = box({0, 0, 0}, {1, 1, 1});

// Two tetrahedra on one base that runs the same way in both: they overlap.
Mesh doubledWall() {
	Mesh m;
	m.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 2}};
	m.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3},
	               {2, 1, 0}, {0, 1, 4}, {1, 2, 4}, {2, 0, 4}};
	return m;
}

TEST(DuplicateFaces, aMeshWithoutThemIsLeftAlone) {
	for (const Mesh& mesh : {kUnit, sphere(30, {0, 0, 0}, 1), torus(9, 7, 2, 1)}) {
		const Arrangement arrangement = cleaned(mesh, kUnit);
		EXPECT_EQ(facesOf(arrangement, kFirst), mesh.triangles);
		EXPECT_EQ(facesOf(arrangement, kSecond), kUnit.triangles);
		EXPECT_TRUE(arrangement.faceGiven.empty());
		EXPECT_EQ(arrangement.duplicates.cancelledPairs, (Pair{0, 0}));
		EXPECT_EQ(arrangement.duplicates.takenOnce, (Pair{0, 0}));
	}
}

TEST(DuplicateFaces, equalFacesOfBothOperandsAreNoDuplicates) {
	Arrangement arrangement;
	arrangement.mesh = arrays(kUnit, kUnit);
	for (Triangle& t : arrangement.mesh.triangles) {
		for (VertexId& v : t) {
			v.value %= 8;  // as after welding
		}
	}
	Monitor monitor;
	ASSERT_TRUE(removeDuplicateFaces(arrangement, monitor).ok());
	EXPECT_EQ(arrangement.mesh.triangles.size(), 24u);
}

TEST(DuplicateFaces, aWallInBothDirectionsCancels) {
	Mesh two;  // boxes side by side on twelve vertices
	for (std::uint32_t i = 0; i < 12; ++i) {
		two.points.push_back({double(i % 3), double(i / 3 % 2), double(i / 6)});
	}
	for (const std::uint32_t shift : {0u, 1u}) {
		for (const Corners& t : kUnit.triangles) {
			Corners corners{};
			for (std::size_t i = 0; i < 3; ++i) {
				corners[i] = t[i] % 2 + t[i] / 2 * 3 + shift;
			}
			two.triangles.push_back(corners);
		}
	}
	const Arrangement arrangement = cleaned(kUnit, two);
	EXPECT_EQ(arrangement.duplicates.cancelledPairs, (Pair{0, 2}));
	EXPECT_EQ(arrangement.duplicates.takenOnce, (Pair{0, 0}));
	const IndexTriangles faces = facesOf(arrangement, kSecond);
	EXPECT_EQ(faces.size(), 20u);
	EXPECT_TRUE(isClosed(faces));
	EXPECT_DOUBLE_EQ(volumeOf(two.points, faces), 2);
	EXPECT_EQ(facesOf(arrangement, kFirst), kUnit.triangles);
}

TEST(DuplicateFaces, equalFacesAreTakenOnceWhereTheOperandIsClosedThatWay) {
	Mesh oneTwice = kUnit;
	oneTwice.triangles.insert(oneTwice.triangles.begin() + 5, {3, 0, 2});  // the first, rotated
	const Arrangement one = cleaned(oneTwice, kUnit);
	EXPECT_EQ(facesOf(one, kFirst), kUnit.triangles);
	EXPECT_EQ(one.duplicates.takenOnce, (Pair{1, 0}));
	EXPECT_EQ(givenFaces(one, kFirst),
	          (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 6, 7, 8, 9, 10, 11, 12}));
	EXPECT_EQ(givenFaces(one, kSecond),
	          (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}));

	Mesh allTwice = kUnit;
	allTwice.triangles.insert(allTwice.triangles.end(), kUnit.triangles.begin(),
	                          kUnit.triangles.end());
	const Arrangement all = cleaned(kUnit, allTwice);
	EXPECT_EQ(facesOf(all, kSecond), kUnit.triangles);
	EXPECT_EQ(all.duplicates.takenOnce, (Pair{0, 12}));
	EXPECT_EQ(all.duplicates.cancelledPairs, (Pair{0, 0}));
}

TEST(DuplicateFaces, anOperandThatIsClosedWithAllOfItsEqualFacesOnlyOverlapsItself) {
	const Mesh wall = doubledWall();
	ASSERT_TRUE(isClosed(wall.triangles));
	for (const int operand : {0, 1}) {
		Arrangement arrangement;
		arrangement.mesh = operand == 0 ? arrays(wall, kUnit) : arrays(kUnit, wall);
		Monitor monitor;
		const Status status = removeDuplicateFaces(arrangement, monitor);
		EXPECT_EQ(status.code, StatusCode::SelfIntersecting);
		EXPECT_EQ(status.operand, operand);
		EXPECT_EQ(status.faces, (std::vector<std::uint32_t>{0, 4}));
		EXPECT_EQ(status.count, 2u);
		EXPECT_TRUE(status.hasPlace);
		EXPECT_EQ(status.place, (Point{0, 0, 0}));
	}
}

TEST(DuplicateFaces, equalFacesOfAnOpenOperandStay) {
	Mesh open = kUnit;
	open.triangles.push_back(open.triangles[3]);
	open.triangles.erase(open.triangles.begin());
	const Arrangement arrangement = cleaned(open, kUnit);
	EXPECT_EQ(facesOf(arrangement, kFirst), open.triangles);
	EXPECT_EQ(arrangement.duplicates.takenOnce, (Pair{0, 0}));
}

TEST(DuplicateFaces, oppositeFacesCancelBeforeEqualOnesAreCounted) {
	Mesh thrice = kUnit;  // face 0 three times, and once in reverse
	thrice.triangles.push_back({0, 2, 3});
	thrice.triangles.push_back({3, 2, 0});
	thrice.triangles.push_back({2, 3, 0});
	const Arrangement arrangement = cleaned(thrice, kUnit);
	EXPECT_EQ(facesOf(arrangement, kFirst), kUnit.triangles);
	EXPECT_EQ(arrangement.duplicates.cancelledPairs, (Pair{1, 0}));
	EXPECT_EQ(arrangement.duplicates.takenOnce, (Pair{1, 0}));
}

TEST(DuplicateFaces, anOperandThatCancelsAltogetherIsLeftToBeRefused) {
	Mesh flat;
	flat.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
	flat.triangles = {{0, 1, 2}, {0, 2, 1}};
	const Arrangement arrangement = cleaned(flat, kUnit);
	EXPECT_EQ(facesOf(arrangement, kFirst), flat.triangles);
	EXPECT_EQ(arrangement.duplicates.cancelledPairs, (Pair{0, 0}));
}

TEST(DuplicateFaces, indicesAsGivenAreKeptFromBefore) {
	Mesh oneTwice = kUnit;
	oneTwice.triangles.push_back(oneTwice.triangles[0]);
	Arrangement arrangement;
	arrangement.mesh = arrays(oneTwice, oneTwice);
	for (std::uint32_t face = 0; face < 26; ++face) {
		arrangement.faceGiven.push_back(100 + face);
	}
	Monitor monitor;
	ASSERT_TRUE(removeDuplicateFaces(arrangement, monitor).ok());
	std::vector<std::uint32_t> expected;
	for (std::uint32_t face = 0; face < 12; ++face) {
		expected.push_back(100 + face);
	}
	EXPECT_EQ(givenFaces(arrangement, kFirst), expected);
	for (std::uint32_t& face : expected) {
		face += 13;
	}
	EXPECT_EQ(givenFaces(arrangement, kSecond), expected);
}

// What must be left of random faces, whose directions are told by the parity of their corners;
// nothing if they overlap.
IndexTriangles expectedFaces(const IndexTriangles& all) {
	std::map<Corners, int> net;  // by corners in ascending order
	const auto sign = [](const Corners& c) {
		const int rises = (c[0] < c[1] ? 1 : 0) + (c[1] < c[2] ? 1 : 0) + (c[2] < c[0] ? 1 : 0);
		return rises == 2 ? 1 : -1;
	};
	const auto key = [](Corners c) {
		std::sort(c.begin(), c.end());
		return c;
	};
	for (const Corners& t : all) {
		net[key(t)] += sign(t);
	}
	IndexTriangles once, kept;
	std::map<Corners, int> left = net;
	for (const Corners& t : all) {
		int& rest = left[key(t)];
		if (rest * sign(t) <= 0) {
			continue;
		}
		kept.push_back(t);
		if (rest == net[key(t)]) {
			once.push_back(t);
		}
		rest -= sign(t);
	}
	if (kept.empty()) {
		return all;
	}
	if (isClosed(once)) {
		return once;
	}
	return isClosed(all) && once.size() < kept.size() ? IndexTriangles{} : kept;
}

TEST(DuplicateFaces, randomFacesOnFewVerticesAgreeWithCounting) {
	int once = 0, overlapping = 0;
	for (unsigned seed = 0; seed < 500; ++seed) {
		SCOPED_TRACE("seed " + std::to_string(seed));
		std::mt19937 random(seed);
		Mesh mesh = seed % 2 == 0 ? box({0, 0, 0}, {1, 1, 1}) : doubledWall();
		const std::size_t faces = mesh.triangles.size();
		for (unsigned i = 0; i < seed % 17; ++i) {
			Corners t = mesh.triangles[random() % faces];
			std::rotate(t.begin(), t.begin() + random() % 3, t.end());
			if (seed % 3 == 0 && random() % 2 == 0) {
				std::swap(t[0], t[1]);
			}
			mesh.triangles.push_back(t);
		}
		mesh = permuted(mesh, random);
		const IndexTriangles expected = expectedFaces(mesh.triangles);
		if (expected.empty()) {
			Arrangement refused;
			refused.mesh = arrays(kUnit, mesh);
			Monitor monitor;
			ASSERT_EQ(removeDuplicateFaces(refused, monitor).code, StatusCode::SelfIntersecting);
			++overlapping;
			continue;
		}
		const Arrangement arrangement = cleaned(kUnit, mesh);
		ASSERT_EQ(facesOf(arrangement, kSecond), expected);
		const std::vector<std::uint32_t> given = givenFaces(arrangement, kSecond);
		for (std::size_t i = 0; i < given.size(); ++i) {
			ASSERT_EQ(facesOf(arrangement, kSecond)[i], mesh.triangles[given[i]]);
		}
		const DuplicateFaces& counts = arrangement.duplicates;
		ASSERT_EQ(mesh.triangles.size() - given.size(),
		          2 * counts.cancelledPairs[kSecond] + counts.takenOnce[kSecond]);
		once += counts.takenOnce[kSecond] > 0 ? 1 : 0;
	}
	EXPECT_GT(once, 50);
	EXPECT_GT(overlapping, 10);
}

TEST(DuplicateFaces, fewAmongManyFacesAreFoundWithAnyNumberOfThreads) {
	std::mt19937 random(1);
	const Mesh clean = permuted(sphere(100, {0, 0, 0}, 1), random);
	Mesh fan;  // all faces on one smallest vertex
	fan.points.resize(20001);
	for (std::uint32_t i = 1; i <= 20000; ++i) {
		fan.triangles.push_back({0, i, i % 20000 + 1});
	}
	for (const Mesh& mesh : {clean, fan}) {
		Mesh doubled = mesh;
		std::vector<std::uint32_t> expected;
		for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
			expected.push_back(i);
		}
		for (int i = 0; i < 20; ++i) {
			const std::size_t face = random() % mesh.triangles.size();
			Corners t = mesh.triangles[face];
			doubled.triangles.push_back(t);
			std::swap(t[0], t[2]);
			doubled.triangles.push_back(t);
		}
		for (const int threads : {1, 2, 8}) {
			const Arrangement arrangement = cleaned(doubled, clean, threads);
			EXPECT_EQ(givenFaces(arrangement, kFirst), expected);
			EXPECT_EQ(arrangement.duplicates.cancelledPairs, (Pair{20, 0}));
		}
	}
}

TEST(DuplicateFaces, theSearchIsCancelled) {
	Arrangement arrangement;
	arrangement.mesh = arrays(kUnit, kUnit);
	Monitor monitor([](double, const char*) { return false; });
	monitor.beginStage("test", 0, 1);
	EXPECT_EQ(removeDuplicateFaces(arrangement, monitor).code, StatusCode::Cancelled);
}

}  // namespace
}  // namespace index_boolean
