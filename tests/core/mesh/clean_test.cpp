// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cleaning after rounding. The oracle shares nothing with the code under test: coordinates are
// small integers, areas, volumes and higher moments exact 64-bit integers, and the vertices to be
// merged are found by brute force.
#include <vcg_ext/mesh/clean.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <set>

using namespace index_boolean;

namespace {

using Vector = std::array<std::int64_t, 3>;
using Edge = std::pair<std::uint32_t, std::uint32_t>;

struct Mesh {
	Points points;
	IndexTriangles triangles;
};

Vector integerPoint(const Point& p) {
	Vector v{};
	for (std::size_t i = 0; i < 3; ++i) {
		v[i] = static_cast<std::int64_t>(p[i]);
		EXPECT_EQ(static_cast<double>(v[i]), p[i]);
	}
	return v;
}

Vector crossProduct(const Vector& a, const Vector& b) {
	return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

std::array<Vector, 3> cornersOf(const Mesh& mesh, const IndexTriangle& t) {
	return {integerPoint(mesh.points[t[0]]), integerPoint(mesh.points[t[1]]),
	        integerPoint(mesh.points[t[2]])};
}

Vector areaVector(const Mesh& mesh, const IndexTriangle& t) {
	const auto c = cornersOf(mesh, t);
	return crossProduct(minus(c[1], c[0]), minus(c[2], c[0]));
}

bool isZero(const Vector& v) { return v == Vector{0, 0, 0}; }

// The moments of degree 0, 1 and 2 of the enclosed solid, times 6, 24 and 120: the same for two
// closed surfaces that bound the same solid, and hardly ever for others.
std::vector<std::int64_t> moments(const Mesh& mesh) {
	std::vector<std::int64_t> sums(10, 0);
	for (const IndexTriangle& t : mesh.triangles) {
		const auto c = cornersOf(mesh, t);
		const Vector n = crossProduct(c[1], c[2]);
		const std::int64_t volume = c[0][0] * n[0] + c[0][1] * n[1] + c[0][2] * n[2];
		sums[0] += volume;
		std::size_t k = 4;
		for (std::size_t i = 0; i < 3; ++i) {
			const std::int64_t sumI = c[0][i] + c[1][i] + c[2][i];
			sums[1 + i] += volume * sumI;
			for (std::size_t j = i; j < 3; ++j) {
				const std::int64_t sumJ = c[0][j] + c[1][j] + c[2][j];
				const std::int64_t products =
				    c[0][i] * c[0][j] + c[1][i] * c[1][j] + c[2][i] * c[2][j];
				sums[k++] += volume * (sumI * sumJ + products);
			}
		}
	}
	return sums;
}

// How many directed edges have no opposite. Vertices are told apart by key(index).
template <class Key>
std::size_t unmatchedEdges(const Mesh& mesh, const Key& key) {
	std::map<decltype(std::pair(key(0U), key(0U))), int> balance;
	for (const IndexTriangle& t : mesh.triangles) {
		for (std::size_t i = 0; i < 3; ++i) {
			const auto from = key(t[i]), to = key(t[(i + 1) % 3]);
			if (from < to) {
				++balance[{from, to}];
			} else if (to < from) {
				--balance[{to, from}];
			}
		}
	}
	return static_cast<std::size_t>(std::count_if(
	    balance.begin(), balance.end(), [](const auto& entry) { return entry.second != 0; }));
}

std::size_t unmatchedByIndex(const Mesh& mesh) {
	return unmatchedEdges(mesh, [](std::uint32_t v) { return v; });
}

std::size_t unmatchedByPlace(const Mesh& mesh) {
	return unmatchedEdges(mesh, [&mesh](std::uint32_t v) { return mesh.points[v]; });
}

std::size_t edgesBetweenEqualPlaces(const Mesh& mesh) {
	std::size_t count = 0;
	for (const IndexTriangle& t : mesh.triangles) {
		for (std::size_t i = 0; i < 3; ++i) {
			count += mesh.points[t[i]] == mesh.points[t[(i + 1) % 3]] ? 1 : 0;
		}
	}
	return count;
}

std::vector<std::uint32_t> zeroAreaFaces(const Mesh& mesh) {
	Monitor monitor;
	std::vector<std::uint32_t> faces;
	const FaceRange all{0, mesh.triangles.size()};
	EXPECT_TRUE(findZeroAreaFaces(mesh.points, mesh.triangles, all, 1, monitor, faces).ok());
	return faces;
}

CleanResult cleaned(Mesh& mesh, int threads = 1) {
	Monitor monitor;
	CleanResult result;
	const std::vector<std::uint32_t> zero = zeroAreaFaces(mesh);
	EXPECT_TRUE(cleanSurface(mesh.points, zero, threads, monitor, mesh.triangles, result).ok());
	EXPECT_EQ(mesh.triangles.size(), result.faces.count);
	return result;
}

// The triangles by coordinates, each from its smallest corner, sorted.
std::vector<std::array<Point, 3>> geometryOf(const Mesh& mesh) {
	std::vector<std::array<Point, 3>> faces;
	for (const IndexTriangle& t : mesh.triangles) {
		std::array<Point, 3> face{mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]};
		std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
		faces.push_back(face);
	}
	std::sort(faces.begin(), faces.end());
	return faces;
}

std::set<std::uint32_t> referencedVertices(const Mesh& mesh) {
	std::set<std::uint32_t> vertices;
	for (const IndexTriangle& t : mesh.triangles) {
		vertices.insert(t.begin(), t.end());
	}
	return vertices;
}

// Vertices, faces and corners numbered in another order.
Mesh permuted(const Mesh& mesh, std::mt19937_64& random) {
	std::vector<std::uint32_t> place(mesh.points.size());
	std::iota(place.begin(), place.end(), 0U);
	std::shuffle(place.begin(), place.end(), random);
	Mesh other{mesh.points, mesh.triangles};
	for (std::size_t v = 0; v < place.size(); ++v) {
		other.points[place[v]] = mesh.points[v];
	}
	for (IndexTriangle& t : other.triangles) {
		for (std::uint32_t& corner : t) {
			corner = place[corner];
		}
		std::rotate(t.begin(), t.begin() + static_cast<std::ptrdiff_t>(random() % 3), t.end());
	}
	std::shuffle(other.triangles.begin(), other.triangles.end(), random);
	return other;
}

// How many vertices cleaning must merge, found by trying everything until nothing changes.
class BruteForceMerge {
public:
	explicit BruteForceMerge(const Mesh& mesh) : mesh_(mesh), class_(mesh.points.size()) {
		std::iota(class_.begin(), class_.end(), 0U);
		for (const IndexTriangle& t : mesh.triangles) {
			for (std::size_t i = 0; i < 3; ++i) {
				uniteAtOnePlace(t[i], t[(i + 1) % 3]);
			}
		}
		takeCollinearFaces();
		for (bool changed = true; changed;) {
			changed = uniteClusters() || uniteInClusters();
		}
	}

	std::size_t count() const {
		return class_.size() - std::set<std::uint32_t>(class_.begin(), class_.end()).size();
	}

private:
	bool uniteAtOnePlace(std::uint32_t u, std::uint32_t v) {
		if (mesh_.points[u] != mesh_.points[v] || class_[u] == class_[v]) {
			return false;
		}
		std::replace(class_.begin(), class_.end(), std::uint32_t{class_[u]},
		             std::uint32_t{class_[v]});
		return true;
	}

	IndexTriangle classes(const IndexTriangle& t) const {
		return {class_[t[0]], class_[t[1]], class_[t[2]]};
	}

	// Zero-area faces with three corners, opposite ones cancelled.
	void takeCollinearFaces() {
		std::map<IndexTriangle, IndexTriangles> bySense;
		for (const IndexTriangle& t : mesh_.triangles) {
			IndexTriangle c = classes(t);
			std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
			const IndexTriangle opposite{c[0], c[2], c[1]};
			const bool hasEqualCorners = c[0] == c[1] || c[1] == c[2] || c[2] == c[0];
			if (hasEqualCorners || !isZero(areaVector(mesh_, t))) {
				continue;
			}
			if (!bySense[opposite].empty()) {
				bySense[opposite].pop_back();
			} else {
				bySense[c].push_back(t);
			}
		}
		for (const auto& entry : bySense) {
			faces_.insert(faces_.end(), entry.second.begin(), entry.second.end());
		}
		cluster_.resize(faces_.size());
		std::iota(cluster_.begin(), cluster_.end(), std::size_t{0});
	}

	bool shareEdge(const IndexTriangle& s, const IndexTriangle& t) const {
		const IndexTriangle a = classes(s), b = classes(t);
		return std::count_if(a.begin(), a.end(), [&b](std::uint32_t v) {
			       return std::find(b.begin(), b.end(), v) != b.end();
		       }) >= 2;
	}

	bool uniteClusters() {
		bool changed = false;
		for (std::size_t i = 0; i < faces_.size(); ++i) {
			for (std::size_t j = 0; j < i; ++j) {
				if (cluster_[i] == cluster_[j] || !shareEdge(faces_[i], faces_[j])) {
					continue;
				}
				std::replace(cluster_.begin(), cluster_.end(), std::size_t{cluster_[i]},
				             std::size_t{cluster_[j]});
				changed = true;
			}
		}
		return changed;
	}

	bool uniteInClusters() {
		bool changed = false;
		for (std::size_t i = 0; i < faces_.size(); ++i) {
			for (std::size_t j = 0; j < faces_.size(); ++j) {
				for (std::size_t k = 0; cluster_[i] == cluster_[j] && k < 9; ++k) {
					changed |= uniteAtOnePlace(faces_[i][k / 3], faces_[j][k % 3]);
				}
			}
		}
		return changed;
	}

	const Mesh& mesh_;
	std::vector<std::uint32_t> class_;
	IndexTriangles faces_;
	std::vector<std::size_t> cluster_;
};

// The pieces of each face cover it: their area vectors sum to its own.
void expectPiecesCoverTheirFaces(const Mesh& before, const Mesh& after, const CleanResult& result) {
	std::vector<std::uint32_t> origin(before.triangles.size());
	std::iota(origin.begin(), origin.end(), 0U);
	result.faces.apply(origin);
	ASSERT_EQ(origin.size(), after.triangles.size());
	std::vector<Vector> sum(before.triangles.size(), Vector{0, 0, 0});
	for (std::size_t i = 0; i < origin.size(); ++i) {
		const Vector piece = areaVector(after, after.triangles[i]);
		for (std::size_t k = 0; k < 3; ++k) {
			sum[origin[i]][k] += piece[k];
		}
	}
	for (std::size_t i = 0; i < sum.size(); ++i) {
		EXPECT_EQ(sum[i], areaVector(before, before.triangles[i])) << "face " << i;
	}
}

void expectOnlyReferencedVerticesAfterRemoval(const Mesh& before, Mesh after,
                                              const CleanResult& result) {
	const std::set<std::uint32_t> now = referencedVertices(after);
	std::vector<std::uint32_t> lost;
	for (const std::uint32_t vertex : referencedVertices(before)) {
		if (now.count(vertex) == 0) {
			lost.push_back(vertex);
		}
	}
	EXPECT_EQ(result.unreferenced, lost);
	const auto geometry = geometryOf(after);
	Points parallel = after.points;
	Monitor monitor;
	Relocation relocated;
	ASSERT_TRUE(
	    removeVertices(result.unreferenced, 1, monitor, after.points, after.triangles, relocated)
	        .ok());
	relocated.apply(parallel);
	EXPECT_EQ(parallel, after.points);
	EXPECT_EQ(after.points.size(), before.points.size() - lost.size());
	EXPECT_EQ(geometryOf(after), geometry);
}

// How many faces meet their opposite on the same corners.
std::size_t oppositeFaces(const Mesh& mesh) {
	std::set<IndexTriangle> faces;
	for (IndexTriangle t : mesh.triangles) {
		std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
		faces.insert(t);
	}
	return static_cast<std::size_t>(std::count_if(faces.begin(), faces.end(), [&](const auto& t) {
		return faces.count({t[0], t[2], t[1]}) != 0;
	}));
}

// The result is the same by coordinates when vertices, faces and corners are numbered otherwise.
void expectTheSameWhenPermuted(const Mesh& before, const Mesh& after, const CleanResult& result) {
	std::mt19937_64 random(before.triangles.size());
	for (int run = 0; run < 4; ++run) {
		Mesh other = permuted(before, random);
		const CleanResult otherResult = cleaned(other);
		EXPECT_EQ(geometryOf(other), geometryOf(after));
		EXPECT_EQ(otherResult.verticesMerged, result.verticesMerged);
		EXPECT_EQ(otherResult.facesSplit, result.facesSplit);
		EXPECT_EQ(otherResult.oppositeFacesRemoved, result.oppositeFacesRemoved);
	}
}

// Everything that cleaning promises, for a closed mesh with small integer coordinates.
CleanResult expectCleanable(const Mesh& before) {
	EXPECT_EQ(unmatchedByIndex(before), 0U);
	Mesh after = before;
	const CleanResult result = cleaned(after);
	EXPECT_EQ(after.points, before.points);
	EXPECT_EQ(unmatchedByIndex(after), 0U);
	EXPECT_EQ(unmatchedByPlace(after), 0U);
	EXPECT_EQ(edgesBetweenEqualPlaces(after), 0U);
	for (const IndexTriangle& t : after.triangles) {
		EXPECT_FALSE(isZero(areaVector(after, t)));
	}
	EXPECT_EQ(moments(after), moments(before));
	EXPECT_EQ(result.verticesMerged, BruteForceMerge(before).count());
	EXPECT_EQ(static_cast<std::ptrdiff_t>(result.zeroAreaFacesRemoved),
	          std::count_if(before.triangles.begin(), before.triangles.end(),
	                        [&](const auto& t) { return isZero(areaVector(before, t)); }));
	if (oppositeFaces(before) == 0) {
		EXPECT_EQ(oppositeFaces(after), 0U);
	}
	if (result.oppositeFacesRemoved == 0) {
		expectPiecesCoverTheirFaces(before, after, result);
	}
	expectOnlyReferencedVerticesAfterRemoval(before, after, result);
	expectTheSameWhenPermuted(before, after, result);
	return result;
}

// A torus of rows x columns quads, without coordinates.
Mesh torus(std::uint32_t rows, std::uint32_t columns) {
	Mesh mesh;
	mesh.points.resize(std::size_t{rows} * columns, Point{});
	const auto vertex = [&](std::uint32_t i, std::uint32_t j) {
		return i % rows * columns + j % columns;
	};
	for (std::uint32_t i = 0; i < rows; ++i) {
		for (std::uint32_t j = 0; j < columns; ++j) {
			const std::uint32_t a = vertex(i, j), b = vertex(i, j + 1);
			const std::uint32_t c = vertex(i + 1, j + 1), d = vertex(i + 1, j);
			mesh.triangles.push_back({a, b, c});
			mesh.triangles.push_back({a, c, d});
		}
	}
	return mesh;
}

Mesh tetrahedron(const std::array<Point, 4>& p) {
	return {{p.begin(), p.end()}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
}

// A sphere of 8 * 4^level faces (a subdivided octahedron), its coordinates multiplied by size and
// rounded to multiples of step.
Mesh roundedSphere(int level, double size, double step) {
	Mesh mesh{
	    {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
	    {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
	for (int i = 0; i < level; ++i) {
		std::map<Edge, std::uint32_t> midpoints;
		const auto midpoint = [&](std::uint32_t a, std::uint32_t b) {
			const auto next = static_cast<std::uint32_t>(mesh.points.size());
			const auto [entry, isNew] = midpoints.try_emplace(std::minmax(a, b), next);
			if (isNew) {
				Point m{};
				for (std::size_t k = 0; k < 3; ++k) {
					m[k] = mesh.points[a][k] + mesh.points[b][k];
				}
				const double length = std::hypot(m[0], m[1], m[2]);
				mesh.points.push_back({m[0] / length, m[1] / length, m[2] / length});
			}
			return entry->second;
		};
		IndexTriangles finer;
		for (const IndexTriangle& t : mesh.triangles) {
			const std::uint32_t a = midpoint(t[0], t[1]), b = midpoint(t[1], t[2]);
			const std::uint32_t c = midpoint(t[2], t[0]);
			finer.insert(finer.end(), {{t[0], a, c}, {a, t[1], b}, {c, b, t[2]}, {a, b, c}});
		}
		mesh.triangles = finer;
	}
	for (Point& p : mesh.points) {
		for (double& x : p) {
			x = std::round(x * size / step) * step;
		}
	}
	return mesh;
}

// Makes one vertex of two, in places: the surface stays closed and stops being a manifold.
void glueVertices(Mesh& mesh, std::size_t pairs, std::mt19937_64& random) {
	for (std::size_t i = 0; i < pairs; ++i) {
		const auto keep = static_cast<std::uint32_t>(random() % mesh.points.size());
		const auto lose = static_cast<std::uint32_t>(random() % mesh.points.size());
		for (IndexTriangle& t : mesh.triangles) {
			std::replace(t.begin(), t.end(), lose, keep);
		}
	}
	mesh.triangles.erase(std::remove_if(mesh.triangles.begin(), mesh.triangles.end(),
	                                    [](const IndexTriangle& t) {
		                                    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
	                                    }),
	                     mesh.triangles.end());
}

// A torus or sphere with random coordinates 0 .. range in each axis.
Mesh randomMesh(std::mt19937_64& random) {
	const auto rows = static_cast<std::uint32_t>(3 + random() % 4);
	const auto columns = static_cast<std::uint32_t>(3 + random() % 4);
	Mesh mesh = random() % 2 == 0 ? torus(rows, columns) : roundedSphere(1, 1, 1);
	const std::array<std::uint64_t, 3> range{1 + random() % 5, 1 + random() % 3, 1 + random() % 3};
	for (Point& p : mesh.points) {
		for (std::size_t k = 0; k < 3; ++k) {
			p[k] = static_cast<double>(random() % (range[k] + 1));
		}
	}
	glueVertices(mesh, random() % 4, random);
	return mesh;
}

// A tetrahedron 0 1 2 3 whose face 0 1 3 has become the faces 0 m 3 and m 1 3 and a cap 0 1 m.
Mesh tetrahedronWithCap() {
	Mesh mesh = tetrahedron({Point{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}});
	mesh.points.push_back({1, 0, 0});
	mesh.triangles[1] = {0, 4, 3};
	mesh.triangles.push_back({4, 1, 3});
	mesh.triangles.push_back({0, 1, 4});
	return mesh;
}

// A tetrahedron 0 1 2 3 with n vertices in a row on the edge 0 1, joined to 3 on one side. On the
// other side n caps: a strip if nested, else a fan around vertex 0.
Mesh tetrahedronWithCaps(std::uint32_t n, bool nested) {
	const double length = n + 1;
	Mesh mesh = tetrahedron({Point{0, 0, 0}, {length, 0, 0}, {0, 4, 0}, {0, 0, 4}});
	mesh.triangles.erase(mesh.triangles.begin() + 1);
	std::vector<std::uint32_t> row{0};
	for (std::uint32_t i = 0; i < n; ++i) {
		row.push_back(4 + i);
		mesh.points.push_back({1.0 + i, 0, 0});
	}
	row.push_back(1);
	for (std::size_t i = 0; i + 1 < row.size(); ++i) {
		mesh.triangles.push_back({row[i], row[i + 1], 3});
	}
	for (std::size_t low = 0, high = row.size() - 1; high - low > 1;) {
		if (nested && (high - low) % 2 == 0) {
			mesh.triangles.push_back({row[low], row[high], row[low + 1]});
			++low;
		} else {
			mesh.triangles.push_back({row[low], row[high], row[high - 1]});
			--high;
		}
	}
	return mesh;
}

TEST(ZeroArea, isDecidedExactlyAtAnyScale) {
	const double tiny = std::numeric_limits<double>::denorm_min();
	const double huge = std::numeric_limits<double>::max();
	const double afterOne = std::nextafter(1.0, 2.0);
	EXPECT_TRUE(hasZeroArea({0, 0, 0}, {tiny, tiny, 0}, {2 * tiny, 2 * tiny, 0}));
	EXPECT_FALSE(hasZeroArea({0, 0, 0}, {tiny, tiny, 0}, {2 * tiny, 3 * tiny, 0}));
	EXPECT_TRUE(hasZeroArea({-huge, 0, -huge}, {huge, 0, huge}, {1, 0, 1}));
	EXPECT_FALSE(hasZeroArea({-huge, 0, -huge}, {huge, 0, huge}, {1, 0, afterOne}));
	EXPECT_FALSE(hasZeroArea({-huge, -huge, 0}, {huge, huge, 0}, {tiny, 0, 0}));
	EXPECT_TRUE(hasZeroArea({0.1, 0.1, 0.1}, {0.3, 0.3, 0.3}, {0.7, 0.7, 0.7}));
	EXPECT_FALSE(hasZeroArea({0, 0, 0}, {1, 1, 1}, {afterOne, afterOne, 1}));
	EXPECT_TRUE(hasZeroArea({0.0, 1, 2}, {-0.0, 1, 2}, {5, 6, 7}));
}

TEST(ZeroArea, agreesWithIntegersOnRandomTriangles) {
	const std::uint64_t seed = 20260101;
	std::printf("seed %llu\n", static_cast<unsigned long long>(seed));
	std::mt19937_64 random(seed);
	for (int i = 0; i < 20000; ++i) {
		Mesh mesh{Points(3), {{0, 1, 2}}};
		for (Point& p : mesh.points) {
			for (double& x : p) {
				x = static_cast<double>(random() % 4);
			}
		}
		const bool expected = isZero(areaVector(mesh, mesh.triangles[0]));
		for (const int exponent : {0, -1074, 1000, -537, 511}) {
			std::array<Point, 3> p{mesh.points[0], mesh.points[1], mesh.points[2]};
			for (Point& corner : p) {
				for (double& x : corner) {
					x = std::ldexp(x, exponent);
				}
			}
			ASSERT_EQ(hasZeroArea(p[0], p[1], p[2]), expected) << i << " 2^" << exponent;
		}
	}
}

// Points on a line whose differences are no doubles: their rounded cross product is not zero.
TEST(ZeroArea, isSeenWhereRoundedDifferencesHideIt) {
	const std::uint64_t seed = 20260106;
	std::printf("seed %llu\n", static_cast<unsigned long long>(seed));
	std::mt19937_64 random(seed);
	for (int i = 0; i < 20000; ++i) {
		std::array<double, 3> along{};
		for (double& t : along) {
			t = static_cast<double>(random() % (1U << 20)) - (1 << 19) + 0.5;
			t = std::ldexp(t, static_cast<int>(random() % 70));
		}
		for (const int exponent : {0, -600, -630, 400}) {
			std::array<Point, 3> p{};
			for (std::size_t k = 0; k < 3; ++k) {
				const double t = std::ldexp(along[k], exponent);
				p[k] = {t, 3 * t, 7 * t};
			}
			ASSERT_TRUE(hasZeroArea(p[0], p[1], p[2])) << i << " 2^" << exponent;
			p[0][2] = std::nextafter(p[0][2], 1e300);
			const bool stillOnALine = p[1] == p[2];
			ASSERT_EQ(hasZeroArea(p[0], p[1], p[2]), stillOnALine) << i << " 2^" << exponent;
		}
	}
}

TEST(ZeroArea, isFoundAlikeInRangesListsAndOperands) {
	Mesh mesh = torus(400, 300);
	std::mt19937_64 random(7);
	for (Point& p : mesh.points) {
		p = {static_cast<double>(random() % 3), static_cast<double>(random() % 3), 0};
	}
	const std::size_t n = mesh.triangles.size();
	std::vector<std::uint32_t> expected;
	for (std::size_t i = 0; i < n; ++i) {
		if (isZero(areaVector(mesh, mesh.triangles[i]))) {
			expected.push_back(static_cast<std::uint32_t>(i));
		}
	}
	Monitor monitor;
	std::vector<std::uint32_t> all(n), found{1, 2, 3}, upper;
	std::iota(all.begin(), all.end(), 0U);
	for (const int threads : {1, 2, 8}) {
		ASSERT_TRUE(
		    findZeroAreaFaces(mesh.points, mesh.triangles, {0, n}, threads, monitor, found).ok());
		EXPECT_EQ(found, expected);
		ASSERT_TRUE(
		    findZeroAreaFacesAmong(all, mesh.points, mesh.triangles, threads, monitor, found).ok());
		EXPECT_EQ(found, expected);
	}
	ASSERT_TRUE(findZeroAreaFaces(mesh.points, mesh.triangles, {n / 2, n}, 0, monitor, upper).ok());
	expected.erase(expected.begin(), std::lower_bound(expected.begin(), expected.end(), n / 2));
	EXPECT_EQ(upper, expected);
}

TEST(Clean, leavesASurfaceWithoutZeroAreaAlone) {
	const Mesh before = roundedSphere(2, 1000, 1);
	Mesh after = before;
	const CleanResult result = cleaned(after);
	EXPECT_EQ(after.triangles, before.triangles);
	EXPECT_TRUE(result.faces.moves.empty());
	EXPECT_TRUE(result.unreferenced.empty());
	EXPECT_EQ(result.zeroAreaFacesRemoved, 0U);
}

TEST(Clean, splitsTheFaceBesideACollinearCap) {
	Mesh mesh = tetrahedronWithCap();
	const CleanResult result = expectCleanable(mesh);
	EXPECT_EQ(result.facesSplit, 1U);
	EXPECT_EQ(result.verticesMerged, 0U);
	EXPECT_EQ(result.zeroAreaFacesRemoved, 1U);
	cleaned(mesh);
	EXPECT_EQ(mesh.triangles.size(), 6U);
}

TEST(Clean, splitsAFaceWithCapsOnAllThreeEdges) {
	Mesh mesh = tetrahedron({Point{0, 0, 0}, {6, 0, 0}, {0, 6, 0}, {0, 0, 6}});
	const IndexTriangle base = mesh.triangles[0];
	mesh.triangles.erase(mesh.triangles.begin() + 1, mesh.triangles.end());
	for (std::size_t i = 0; i < 3; ++i) {
		const std::uint32_t u = base[i], v = base[(i + 1) % 3];
		const auto w = static_cast<std::uint32_t>(mesh.points.size());
		for (int k = 1; k <= 2; ++k) {
			Point p{};
			for (std::size_t axis = 0; axis < 3; ++axis) {
				p[axis] = (mesh.points[u][axis] * (3 - k) + mesh.points[v][axis] * k) / 3;
			}
			mesh.points.push_back(p);
		}
		mesh.triangles.insert(mesh.triangles.end(), {{v, u, w}, {v, w, w + 1}});
		mesh.triangles.insert(mesh.triangles.end(), {{w, u, 3}, {w + 1, w, 3}, {v, w + 1, 3}});
	}
	const CleanResult result = expectCleanable(mesh);
	EXPECT_EQ(result.facesSplit, 1U);
	EXPECT_EQ(result.zeroAreaFacesRemoved, 6U);
	cleaned(mesh);
	EXPECT_EQ(mesh.triangles.size(), 9U + 7U);
}

TEST(Clean, removesANeedleWithCoincidentEnds) {
	Mesh mesh = tetrahedronWithCap();
	mesh.points[4] = mesh.points[0];
	const CleanResult result = expectCleanable(mesh);
	EXPECT_EQ(result.verticesMerged, 1U);
	EXPECT_EQ(result.facesSplit, 0U);
	EXPECT_EQ(result.unreferenced, std::vector<std::uint32_t>{4});
	cleaned(mesh);
	EXPECT_EQ(geometryOf(mesh),
	          geometryOf(tetrahedron({Point{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}})));
}

// A tube around a ring of three vertices that have become one point: two solids are left that
// touch there.
TEST(Clean, closesASliverTubeThatCollapsesToAPoint) {
	Mesh mesh;
	for (const double z : {-4.0, 0.0, 4.0}) {
		const double width = std::fabs(z);
		mesh.points.insert(mesh.points.end(), {{0, 0, z}, {width, 0, z}, {0, width, z}});
	}
	mesh.triangles = {{0, 2, 1}, {6, 7, 8}};
	for (const std::uint32_t level : {0U, 3U}) {
		for (std::uint32_t i = 0; i < 3; ++i) {
			const std::uint32_t a = level + i, b = level + (i + 1) % 3;
			mesh.triangles.insert(mesh.triangles.end(), {{a, b, b + 3}, {a, b + 3, a + 3}});
		}
	}
	const CleanResult result = expectCleanable(mesh);
	EXPECT_EQ(result.verticesMerged, 2U);
	EXPECT_EQ(result.zeroAreaFacesRemoved, 6U);
	cleaned(mesh);
	EXPECT_EQ(mesh.triangles.size(), 8U);
}

TEST(Clean, removesAThinSolidThatRoundingHasFlattenedToNothing) {
	Mesh line = tetrahedron({Point{0, 0, 0}, {1, 1, 1}, {3, 3, 3}, {2, 2, 2}});
	expectCleanable(line);
	EXPECT_EQ(cleaned(line).facesSplit, 0U);
	EXPECT_TRUE(line.triangles.empty());
	Mesh flat = tetrahedron({Point{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 0}});
	const CleanResult result = expectCleanable(flat);
	EXPECT_EQ(result.oppositeFacesRemoved, 2U);
	EXPECT_EQ(result.unreferenced.size(), 4U);
	cleaned(flat);
	EXPECT_TRUE(flat.triangles.empty());
}

// The face 0 1 2 becomes the opposite of two others when it is split at 3.
TEST(Clean, cancelsPiecesThatFallOnOppositeFaces) {
	Mesh mesh{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {2, 0, 0}},
	          {{0, 1, 2}, {3, 0, 2}, {1, 3, 2}, {1, 0, 3}}};
	const CleanResult result = expectCleanable(mesh);
	EXPECT_EQ(result.facesSplit, 1U);
	EXPECT_EQ(result.oppositeFacesRemoved, 4U);
	cleaned(mesh);
	EXPECT_TRUE(mesh.triangles.empty());
}

// The zero-area faces 0 1 4 and 0 4 5 lie between a face on each side whose vertices on the line
// the other side lacks.
TEST(Clean, splitsOnBothSidesOfACluster) {
	Mesh mesh = tetrahedron({Point{0, 0, 0}, {6, 0, 0}, {0, 6, 0}, {0, 0, 6}});
	mesh.points.insert(mesh.points.end(), {{4, 0, 0}, {2, 0, 0}});
	mesh.triangles = {{2, 0, 3}, {1, 2, 3}, {0, 4, 3}, {4, 1, 3},
	                  {5, 0, 2}, {1, 5, 2}, {4, 0, 5}, {1, 4, 5}};
	const CleanResult result = expectCleanable(mesh);
	EXPECT_EQ(result.facesSplit, 2U);
	EXPECT_EQ(result.zeroAreaFacesRemoved, 2U);
	cleaned(mesh);
	EXPECT_EQ(mesh.triangles.size(), 8U);
}

TEST(Clean, makesOneVertexOfTwoAtOnePlaceInACluster) {
	Mesh mesh = tetrahedron({Point{0, 0, 0}, {6, 0, 0}, {0, 6, 0}, {0, 0, 6}});
	mesh.points.insert(mesh.points.end(), {{3, 0, 0}, {3, 0, 0}});
	mesh.triangles = {{2, 0, 3}, {1, 2, 3}, {0, 4, 3}, {4, 1, 3},
	                  {5, 0, 2}, {1, 5, 2}, {0, 1, 4}, {1, 0, 5}};
	const CleanResult result = expectCleanable(mesh);
	EXPECT_EQ(result.verticesMerged, 1U);
	EXPECT_EQ(result.facesSplit, 0U);
	cleaned(mesh);
	EXPECT_EQ(mesh.triangles.size(), 6U);
}

TEST(Clean, handlesSmallStripsAndFansOfCaps) {
	for (const std::uint32_t n : {1U, 2U, 3U, 8U, 25U}) {
		for (const bool nested : {false, true}) {
			const CleanResult result = expectCleanable(tetrahedronWithCaps(n, nested));
			EXPECT_EQ(result.facesSplit, 1U);
			EXPECT_EQ(result.zeroAreaFacesRemoved, n);
		}
	}
}

// 4e10 steps if a cluster cost the square of its size.
TEST(Clean, handlesACapPerVertexOfAnEdgeWithManyThousands) {
	constexpr std::uint32_t n = 200000;
	for (const bool nested : {false, true}) {
		Mesh mesh = tetrahedronWithCaps(n, nested);
		const CleanResult result = cleaned(mesh);
		EXPECT_EQ(result.facesSplit, 1U);
		EXPECT_EQ(result.verticesMerged, 0U);
		EXPECT_EQ(mesh.triangles.size(), 2 * (n + 1) + 2);
		EXPECT_EQ(unmatchedByIndex(mesh), 0U);
		EXPECT_TRUE(zeroAreaFaces(mesh).empty());
	}
}

TEST(Clean, handlesAVertexWhoseThousandsOfFacesAllCollapse) {
	constexpr std::uint32_t n = 100000;
	Mesh mesh;
	mesh.points.assign(n + 2, Point{0, 0, 0});
	mesh.points[n] = {0, 0, 5};
	mesh.points[n + 1] = {0, 0, -5};
	for (std::uint32_t i = 0; i < n; ++i) {
		const std::uint32_t next = (i + 1) % n;
		mesh.points[i] = {static_cast<double>(i / 2 % 2), 0, static_cast<double>(i % 3)};
		mesh.triangles.push_back({i, next, n});
		mesh.triangles.push_back({next, i, n + 1});
	}
	Mesh after = mesh;
	const CleanResult result = cleaned(after);
	EXPECT_GT(result.zeroAreaFacesRemoved, 0U);
	EXPECT_EQ(unmatchedByIndex(after), 0U);
	EXPECT_TRUE(zeroAreaFaces(after).empty());
	EXPECT_EQ(moments(after), moments(mesh));
}

// Two solids that touch where rounding has put their corners: no edge joins them.
TEST(Clean, keepsVerticesApartThatNoEdgeJoins) {
	Mesh mesh = tetrahedronWithCap();
	mesh.points[4] = mesh.points[0];
	const std::size_t faces = mesh.triangles.size(), points = mesh.points.size();
	const auto shift = static_cast<std::uint32_t>(points);
	for (std::size_t v = 0; v < points; ++v) {
		const Point p = mesh.points[v];
		mesh.points.push_back({p[0] == 0 ? 0 : -p[0], p[1] == 0 ? 0 : -p[1], -p[2]});
	}
	for (std::size_t f = 0; f < faces; ++f) {
		const IndexTriangle t = mesh.triangles[f];
		mesh.triangles.push_back({t[0] + shift, t[2] + shift, t[1] + shift});
	}
	const CleanResult result = expectCleanable(mesh);
	EXPECT_EQ(result.verticesMerged, 2U);
	cleaned(mesh);
	EXPECT_EQ(mesh.triangles.size(), 8U);
	EXPECT_EQ(referencedVertices(mesh).size(), 8U);
}

TEST(Clean, keepsSheetsApartThatDifferByOneUlp) {
	Mesh mesh = tetrahedronWithCap();
	const double one = 1, next = std::nextafter(1.0, 2.0);
	mesh.points = {{1, one, 1}, {5, one, 1}, {1, 5, 1}, {1, one, 5}, {1, next, 1}};
	Mesh after = mesh;
	const CleanResult result = cleaned(after);
	EXPECT_EQ(result.zeroAreaFacesRemoved, 0U);
	EXPECT_EQ(after.triangles, mesh.triangles);
}

TEST(Clean, takesNegativeZeroForZero) {
	Mesh mesh = tetrahedronWithCap();
	mesh.points[4] = {-0.0, 0.0, -0.0};
	EXPECT_EQ(cleaned(mesh).verticesMerged, 1U);
	EXPECT_EQ(unmatchedByIndex(mesh), 0U);
	EXPECT_EQ(mesh.triangles.size(), 4U);
}

TEST(Clean, keepsEqualFacesAndCancelsOppositeOnes) {
	Mesh twice = tetrahedronWithCap();
	const IndexTriangles once = twice.triangles;
	twice.triangles.insert(twice.triangles.end(), once.begin(), once.end());
	Mesh both = twice;
	expectCleanable(twice);
	EXPECT_EQ(cleaned(twice).facesSplit, 2U);
	EXPECT_EQ(twice.triangles.size(), 12U);
	for (IndexTriangle t : once) {
		std::swap(t[0], t[1]);
		both.triangles.push_back(t);
	}
	expectCleanable(both);
	cleaned(both);
	EXPECT_EQ(both.triangles.size(), 6U);
}

// A line of the first cluster holds two vertices at one place; with them one, two clusters on
// another line share an edge, and must have one vertex per place together.
TEST(Clean, followsWhatUnitingVerticesBringsTogether) {
	const std::uint64_t seed = 20260102;
	std::printf("seed %llu\n", static_cast<unsigned long long>(seed));
	std::mt19937_64 random(seed);
	std::size_t merged = 0;
	for (int run = 0; run < 300; ++run) {
		Mesh mesh = torus(6, 6);
		// Three lines through the origin, few places on each: clusters meet at the origin.
		for (Point& p : mesh.points) {
			p = {0, 0, 0};
			p[random() % 3] = static_cast<double>(random() % 4);
		}
		SCOPED_TRACE(run);
		merged += expectCleanable(mesh).verticesMerged;
	}
	EXPECT_GT(merged, 0U);
}

TEST(Clean, keepsItsPromiseOnRandomClosedMeshes) {
	const std::uint64_t seed = 20260103;
	std::printf("seed %llu\n", static_cast<unsigned long long>(seed));
	std::mt19937_64 random(seed);
	CleanResult total;
	for (int run = 0; run < 3000; ++run) {
		SCOPED_TRACE(run);
		const CleanResult result = expectCleanable(randomMesh(random));
		total.verticesMerged += result.verticesMerged;
		total.facesSplit += result.facesSplit;
		total.oppositeFacesRemoved += result.oppositeFacesRemoved;
		ASSERT_FALSE(HasFailure());
	}
	EXPECT_GT(total.verticesMerged, 1000U);
	EXPECT_GT(total.facesSplit, 1000U);
	EXPECT_GT(total.oppositeFacesRemoved, 1000U);
}

TEST(Clean, keepsItsPromiseOnCoarselyRoundedSpheres) {
	for (const double step : {3.0, 7.0, 13.0, 29.0, 60.0, 100.0}) {
		SCOPED_TRACE(step);
		const CleanResult result = expectCleanable(roundedSphere(4, 100, step));
		EXPECT_EQ(result.zeroAreaFacesRemoved > 0, step > 7);
	}
}

TEST(Clean, doesNotDependOnThreads) {
	Mesh first = roundedSphere(7, 1000, 30);
	const Mesh before = first;
	const CleanResult expected = cleaned(first, 1);
	EXPECT_GT(expected.zeroAreaFacesRemoved, 0U);
	EXPECT_EQ(unmatchedByIndex(first), 0U);
	EXPECT_EQ(moments(first)[0], moments(before)[0]);
	EXPECT_TRUE(zeroAreaFaces(first).empty());
	for (const int threads : {2, 8}) {
		Mesh mesh = before;
		const CleanResult result = cleaned(mesh, threads);
		EXPECT_EQ(mesh.triangles, first.triangles);
		EXPECT_EQ(result.unreferenced, expected.unreferenced);
		Mesh serial = mesh;
		Monitor monitor;
		Relocation a, b;
		ASSERT_TRUE(
		    removeVertices(result.unreferenced, threads, monitor, mesh.points, mesh.triangles, a)
		        .ok());
		ASSERT_TRUE(
		    removeVertices(result.unreferenced, 1, monitor, serial.points, serial.triangles, b)
		        .ok());
		EXPECT_EQ(mesh.points, serial.points);
		EXPECT_EQ(mesh.triangles, serial.triangles);
	}
}

TEST(Clean, doesNotDependOnScale) {
	std::mt19937_64 random(20260105);
	for (int run = 0; run < 200; ++run) {
		const Mesh unit = randomMesh(random);
		Mesh expected = unit;
		cleaned(expected);
		for (const int exponent : {-1074, -500, 600, 1020}) {
			Mesh mesh = unit;
			for (Point& p : mesh.points) {
				for (double& x : p) {
					x = std::ldexp(x, exponent);
				}
			}
			cleaned(mesh);
			ASSERT_EQ(mesh.triangles, expected.triangles) << "run " << run << " 2^" << exponent;
		}
	}
}

TEST(Clean, findsVerticesUnreferencedThatOnlyOppositeFacesHeld) {
	// A pyramid whose base 0 1 2 3 is folded along 0 2, which has no length: the sides fall on each
	// other. The apex 4 is a corner of no zero-area face; the rest of the surface may hold it.
	Mesh mesh{{{0, 0, 0}, {4, 0, 0}, {0, 0, 0}, {0, 4, 0}, {0, 0, 4}},
	          {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {0, 2, 1}, {0, 3, 2}}};
	EXPECT_EQ(expectCleanable(mesh).unreferenced, (std::vector<std::uint32_t>{0, 1, 2, 3, 4}));
	mesh.points.insert(mesh.points.end(), {{9, 9, 9}, {8, 9, 9}});
	mesh.triangles.insert(mesh.triangles.begin() + 1, {{4, 5, 6}, {5, 4, 6}});
	EXPECT_EQ(expectCleanable(mesh).unreferenced, (std::vector<std::uint32_t>{0, 1, 2, 3}));
}

TEST(Clean, splitsAnOpenSurfaceWithoutChangingItsBorder) {
	Mesh mesh = tetrahedronWithCap();
	mesh.triangles.erase(mesh.triangles.begin() + 2);
	const std::size_t border = unmatchedByIndex(mesh);
	cleaned(mesh);
	EXPECT_EQ(border, 3U);
	EXPECT_EQ(unmatchedByIndex(mesh), border);
	EXPECT_TRUE(zeroAreaFaces(mesh).empty());
}

TEST(Clean, changesNothingWhenCancelled) {
	const Mesh before = tetrahedronWithCap();
	Mesh mesh = before;
	Monitor monitor([](double, const char*) { return false; });
	monitor.beginStage("clean", 0, 1);
	CleanResult result;
	EXPECT_EQ(cleanSurface(mesh.points, {5}, 1, monitor, mesh.triangles, result).code,
	          StatusCode::Cancelled);
	Relocation relocated;
	EXPECT_EQ(removeVertices({0}, 1, monitor, mesh.points, mesh.triangles, relocated).code,
	          StatusCode::Cancelled);
	EXPECT_EQ(mesh.triangles, before.triangles);
	EXPECT_EQ(mesh.points, before.points);
}

TEST(Clean, canBeCancelledInsideAClusterOfManyThousands) {
	Mesh mesh = tetrahedronWithCaps(200000, false);
	const std::vector<std::uint32_t> zero = zeroAreaFaces(mesh);
	int calls = 0;
	Monitor monitor([&calls](double, const char*) { return ++calls == 1; });
	monitor.beginStage("clean", 0, 1);
	const IndexTriangles before = mesh.triangles;
	CleanResult result;
	EXPECT_EQ(cleanSurface(mesh.points, zero, 1, monitor, mesh.triangles, result).code,
	          StatusCode::Cancelled);
	EXPECT_EQ(calls, 2);
	EXPECT_EQ(mesh.triangles, before);
}

}  // namespace
