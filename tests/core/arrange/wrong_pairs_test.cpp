// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The search for pairs of faces that meet wrongly against all pairs in rational arithmetic, on
// small surfaces of every kind.
#include "core/shapes.h"
#include "support/meeting_oracle.h"

#include <vcg_ext/arrange/open_stars.h>
#include <vcg_ext/arrange/unbalanced_vertices.h>
#include <vcg_ext/arrange/wrong_pairs.h>

#include <gtest/gtest.h>

#include <chrono>
#include <numeric>
#include <set>

namespace index_boolean {
namespace {

using namespace shapes;

using Pairs = std::vector<std::array<std::uint32_t, 2>>;

// What a search finds, or should find.
struct Found {
	Pairs pairs;
	std::vector<std::uint32_t> flatFaces;

	bool empty() const { return pairs.empty() && flatFaces.empty(); }
	friend bool operator==(const Found& a, const Found& b) {
		return a.pairs == b.pairs && a.flatFaces == b.flatFaces;
	}
	friend void PrintTo(const Found& found, std::ostream* out) {
		*out << found.pairs.size() << " pairs" << ::testing::PrintToString(found.pairs)
		     << ", flat faces " << ::testing::PrintToString(found.flatFaces);
	}
};

Found asFound(const WrongPairs& wrong) {
	Found found;
	for (const FacePair& pair : wrong.pairs) {
		found.pairs.push_back({pair.a.value, pair.b.value});
	}
	found.flatFaces = wrong.flatFaces;
	return found;
}

FacesView viewed(const Mesh& mesh) {
	return {mesh.points, mesh.triangles.data(), mesh.triangles.size()};
}

bool isClosedMesh(const Mesh& mesh) { return isClosed(mesh.triangles); }

Found search(const Mesh& mesh, int threads = 2) {
	Monitor monitor;
	WrongPairs wrong;
	const Status status = findWrongPairs(viewed(mesh), {threads, false}, monitor, wrong);
	EXPECT_TRUE(status.ok()) << describe(status);
	return asFound(wrong);
}

Found searchAmong(const Mesh& mesh, const std::vector<std::uint8_t>& isSuspect, int threads = 2) {
	Monitor monitor;
	WrongPairs wrong;
	const Status status =
	    findWrongPairsAmong(viewed(mesh), isSuspect, {threads, false}, monitor, wrong);
	EXPECT_TRUE(status.ok()) << describe(status);
	return asFound(wrong);
}

// All pairs, in rational arithmetic where the faces' boxes meet.
Found expected(const Mesh& mesh) {
	Found found;
	const std::size_t count = mesh.triangles.size();
	std::vector<oracle::ExactPolygon> exact;
	std::vector<BoundingBox> boxes(count, emptyBox());
	for (std::uint32_t face = 0; face < count; ++face) {
		exact.push_back(oracle::exactTriangle(mesh.points, mesh.triangles[face]));
		for (const std::uint32_t v : mesh.triangles[face]) {
			boxes[face].add(mesh.points[v]);
		}
		if (oracle::isFlat(exact.back())) {
			found.flatFaces.push_back(face);
		}
	}
	const auto isFlat = [&found](std::uint32_t face) {
		return std::binary_search(found.flatFaces.begin(), found.flatFaces.end(), face);
	};
	for (std::uint32_t a = 0; a < count; ++a) {
		for (std::uint32_t b = a + 1; b < count; ++b) {
			if (!commonBox(boxes[a], boxes[b]).empty() && !isFlat(a) && !isFlat(b) &&
			    oracle::meetWrongly(exact[a], exact[b])) {
				found.pairs.push_back({a, b});
			}
		}
	}
	return found;
}

Found onlyOf(const Found& all, const std::vector<std::uint8_t>& isSuspect) {
	Found some;
	std::copy_if(all.pairs.begin(), all.pairs.end(), std::back_inserter(some.pairs),
	             [&](const auto& pair) { return isSuspect[pair[0]] || isSuspect[pair[1]]; });
	std::copy_if(all.flatFaces.begin(), all.flatFaces.end(), std::back_inserter(some.flatFaces),
	             [&](std::uint32_t face) { return isSuspect[face] != 0; });
	return some;
}

Mesh welded(const Mesh& mesh) {
	std::map<Point, std::uint32_t> indices;
	Mesh result;
	for (const auto& t : mesh.triangles) {
		IndexTriangle corners{};
		for (std::size_t i = 0; i < 3; ++i) {
			const auto [entry, isNew] = indices.try_emplace(
			    mesh.points[t[i]], static_cast<std::uint32_t>(result.points.size()));
			if (isNew) {
				result.points.push_back(mesh.points[t[i]]);
			}
			corners[i] = entry->second;
		}
		result.triangles.push_back(corners);
	}
	return result;
}

// An icosahedron of radius 1, each face cut in four `cuts` times, on the sphere.
Mesh icosphere(int cuts) {
	const double t = (1 + std::sqrt(5.0)) / 2;
	Mesh mesh;
	mesh.points = {{-1, t, 0},  {1, t, 0},  {-1, -t, 0}, {1, -t, 0}, {0, -1, t},  {0, 1, t},
	               {0, -1, -t}, {0, 1, -t}, {t, 0, -1},  {t, 0, 1},  {-t, 0, -1}, {-t, 0, 1}};
	mesh.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
	                  {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
	                  {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
	                  {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
	for (; cuts > 0; --cuts) {
		Mesh finer;
		for (const auto& f : mesh.triangles) {
			const auto first = static_cast<std::uint32_t>(finer.points.size());
			for (std::size_t i = 0; i < 3; ++i) {
				finer.points.push_back(mesh.points[f[i]]);
			}
			for (std::size_t i = 0; i < 3; ++i) {  // in one order, so that both faces agree
				const Point& p = std::min(mesh.points[f[i]], mesh.points[f[(i + 1) % 3]]);
				const Point& q = std::max(mesh.points[f[i]], mesh.points[f[(i + 1) % 3]]);
				finer.points.push_back({p[0] + q[0], p[1] + q[1], p[2] + q[2]});
			}
			for (const auto& piece : {IndexTriangle{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}}) {
				finer.triangles.push_back({first + piece[0], first + piece[1], first + piece[2]});
			}
		}
		for (Point& p : finer.points) {
			const double length = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
			p = {p[0] / length, p[1] / length, p[2] / length};
		}
		mesh = welded(finer);
	}
	return mesh;
}

template <class T>
T anyOf(std::mt19937& random, std::initializer_list<T> values) {
	return values.begin()[random() % values.size()];
}

// A few triangles between few places of a grid: contacts of every kind, flat faces too.
Mesh gridTriangles(std::mt19937& random) {
	const std::size_t height = 1 + random() % 4, count = 2 + random() % 40;
	Mesh mesh;
	for (int i = 0; i < 24; ++i) {
		mesh.points.push_back(
		    {double(random() % 4), double(random() % 4), double(random() % height)});
	}
	for (std::size_t i = 0; i < count; ++i) {
		mesh.triangles.push_back({std::uint32_t(random() % 24), std::uint32_t(random() % 24),
		                          std::uint32_t(random() % 24)});
	}
	return mesh;
}

Mesh fuzzedBase(std::mt19937& random) {
	switch (random() % 5) {
	case 0:
		return gridTriangles(random);
	case 1:
		return torus(std::uint32_t(6 + random() % 8), std::uint32_t(4 + random() % 5), 1, 0.4);
	case 2:
		return joined(icosphere(1), box({-0.5, 0.25, 0}, {2, 0.5, 0.75}));
	case 3:
		return joined(icosphere(1), placed(icosphere(1), random, 1.5));
	default:
		return icosphere(random() % 8 == 0 ? 2 : 1);
	}
}

// Makes a surface open, unoriented, not manifold, or gives it equal or collapsed faces.
void spoilFaces(Mesh& mesh, std::mt19937& random) {
	const auto vertexCount = static_cast<std::uint32_t>(mesh.points.size());
	const auto anyFace = [&]() -> IndexTriangle& {
		return mesh.triangles[random() % mesh.triangles.size()];
	};
	for (unsigned n = random() % 4; n > 0; --n) {
		switch (random() % 6) {
		case 0:
			anyFace() = mesh.triangles.back();  // once less, and another twice
			break;
		case 1:
			std::swap(anyFace()[1], mesh.triangles.front()[1]);
			break;
		case 2:
			std::swap(mesh.triangles.front()[1], mesh.triangles.front()[2]);
			break;
		case 3: {
			const IndexTriangle t = anyFace();
			mesh.triangles.push_back({t[0], t[1], std::uint32_t(random() % vertexCount)});
			break;
		}
		case 4: {
			const IndexTriangle t = anyFace();
			mesh.triangles.push_back({t[0], t[1], t[1]});
			break;
		}
		default:
			mesh.triangles.erase(mesh.triangles.begin() +
			                     static_cast<std::ptrdiff_t>(random() % mesh.triangles.size()));
		}
	}
}

void spoilPlaces(Mesh& mesh, std::mt19937& random) {
	std::normal_distribution<double> normal;
	const double noise = anyOf(random, {0.0, 0.0, 0.0, 1e-9, 1e-3, 0.05, 0.3});
	const double grid = anyOf(random, {0.0, 0.0, 0.0, 0.5, 0.25, 1 / 32.0, 1e-6});
	const double offset = anyOf(random, {0.0, 0.0, 1e3, 1e7, 1e12});
	const double flatten = anyOf(random, {1.0, 1.0, 1.0, 1.0, 1e-3, 1e-9, 0.0});
	const double stretch = anyOf(random, {1.0, 1.0, 1e6});
	const double scale = anyOf(random, {1.0, 1.0, 1e-20, 1e20});
	for (Point& p : mesh.points) {
		for (double& x : p) {
			x += noise * normal(random);
			x = grid > 0 ? std::round(x / grid) * grid : x;
		}
		p[2] *= flatten;
		p[0] *= stretch;
		for (double& x : p) {
			x = (x + offset) * scale + 0.0;
		}
	}
	for (unsigned n = random() % 4 == 0 ? 2 : 0; n > 0; --n) {
		Point& p = mesh.points[random() % mesh.points.size()];
		p = {-1.01 * p[0], p[1], 0.3 * p[2]};
	}
}

Mesh fuzzed(std::mt19937& random) {
	Mesh mesh = fuzzedBase(random);
	spoilPlaces(mesh, random);
	if (random() % 2 == 0) {
		spoilFaces(mesh, random);
	}
	mesh = welded(mesh);
	return random() % 2 == 0 ? permuted(mesh, random) : mesh;
}

TEST(WrongPairs, fuzzedSurfacesAreJudgedAsByRationalArithmetic) {
	int clean = 0, wrong = 0, flat = 0, closed = 0;
	for (unsigned seed = 0; seed < 250; ++seed) {
		SCOPED_TRACE("seed " + std::to_string(seed));
		std::mt19937 random(seed);
		const Mesh mesh = fuzzed(random);
		const Found all = expected(mesh);
		clean += all.empty() ? 1 : 0;
		wrong += all.pairs.empty() ? 0 : 1;
		flat += all.flatFaces.empty() ? 0 : 1;
		closed += isClosedMesh(mesh) ? 1 : 0;
		for (const int threads : {1, 2, 5}) {
			ASSERT_EQ(search(mesh, threads), all);
		}
		if (isClosedMesh(mesh)) {
			Monitor monitor;
			WrongPairs found;
			ASSERT_TRUE(findWrongPairs(viewed(mesh), {1, true}, monitor, found).ok());
			ASSERT_EQ(asFound(found), all);
		}
		std::vector<std::uint8_t> isSuspect(mesh.triangles.size());
		const unsigned share = anyOf(random, {1U, 3U, 20U, 1000U});
		for (std::uint8_t& suspect : isSuspect) {
			suspect = random() % share == 0 ? 1 : 0;
		}
		ASSERT_EQ(searchAmong(mesh, isSuspect), onlyOf(all, isSuspect)) << "share " << share;
	}
	for (const int count : {clean, wrong, flat, closed}) {
		EXPECT_GT(count, 25);
	}
}

}  // namespace
}  // namespace index_boolean
