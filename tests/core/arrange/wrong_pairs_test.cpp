// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The search for pairs of faces that meet wrongly against all pairs in rational arithmetic, on
// small surfaces of every kind.
#include "core/shapes.h"
#include "support/meeting_oracle.h"

#include <vcg_ext/arrange/near_faces.h>
#include <vcg_ext/arrange/open_stars.h>
#include <vcg_ext/arrange/pyramid_descent.h>
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
	std::vector<std::uint32_t> zeroAreaFaces;

	bool empty() const { return pairs.empty() && zeroAreaFaces.empty(); }
	friend bool operator==(const Found& a, const Found& b) {
		return a.pairs == b.pairs && a.zeroAreaFaces == b.zeroAreaFaces;
	}
	friend void PrintTo(const Found& found, std::ostream* out) {
		*out << found.pairs.size() << " pairs" << ::testing::PrintToString(found.pairs)
		     << ", zero-area faces " << ::testing::PrintToString(found.zeroAreaFaces);
	}
};

Found asFound(const WrongPairs& wrong) {
	Found found;
	for (const FacePair& pair : wrong.pairs) {
		found.pairs.push_back({pair.a.value, pair.b.value});
	}
	found.zeroAreaFaces = wrong.zeroAreaFaces;
	return found;
}

FacesView viewed(const Mesh& mesh) {
	return {mesh.points, mesh.triangles.data(), mesh.triangles.size()};
}

bool isClosedMesh(const Mesh& mesh) { return isClosed(mesh.triangles); }

Found search(const Mesh& mesh, int threads = 2,
             const std::vector<std::uint8_t>* isSuspect = nullptr) {
	Monitor monitor;
	WrongPairs wrong;
	const Status status = findWrongPairs(viewed(mesh), {threads, false, isSuspect}, monitor, wrong);
	EXPECT_TRUE(status.ok()) << describe(status);
	return asFound(wrong);
}

Found searchAmong(const Mesh& mesh, const std::vector<std::uint8_t>& isSuspect, int threads = 2) {
	Monitor monitor;
	WrongPairs wrong;
	const Status status =
	    findWrongPairsNearSuspects(viewed(mesh), {threads, false, &isSuspect}, monitor, wrong);
	EXPECT_TRUE(status.ok()) << describe(status);
	return asFound(wrong);
}

// Times a power of two that makes all coordinates integers: rational numbers are slow, but not
// where they are none.
oracle::ExactPolygon integerTriangle(const Mesh& mesh, const IndexTriangle& corners,
                                     const oracle::Rational& power) {
	oracle::ExactPolygon polygon = oracle::exactTriangle(mesh.points, corners);
	for (oracle::ExactVector& p : polygon) {
		for (oracle::Rational& x : p) {
			x *= power;
		}
	}
	return polygon;
}

oracle::Rational powerToIntegers(const Mesh& mesh) {
	int lowest = 0;
	for (const Point& p : mesh.points) {
		for (const double x : p) {
			lowest = x == 0 ? lowest : std::min(lowest, std::ilogb(x) - 52);
		}
	}
	return oracle::Rational(boost::multiprecision::cpp_int(1) << -lowest);
}

// All pairs, in rational arithmetic where the faces' boxes meet.
Found expected(const Mesh& mesh) {
	Found found;
	const std::size_t count = mesh.triangles.size();
	const oracle::Rational power = powerToIntegers(mesh);
	std::vector<oracle::ExactPolygon> exact;
	std::vector<BoundingBox> boxes(count, emptyBox());
	for (std::uint32_t face = 0; face < count; ++face) {
		exact.push_back(integerTriangle(mesh, mesh.triangles[face], power));
		for (const std::uint32_t v : mesh.triangles[face]) {
			boxes[face].add(mesh.points[v]);
		}
		if (oracle::isFlat(exact.back())) {
			found.zeroAreaFaces.push_back(face);
		}
	}
	const auto isZeroArea = [&found](std::uint32_t face) {
		return std::binary_search(found.zeroAreaFaces.begin(), found.zeroAreaFaces.end(), face);
	};
	for (std::uint32_t a = 0; a < count; ++a) {
		for (std::uint32_t b = a + 1; b < count; ++b) {
			if (!commonBox(boxes[a], boxes[b]).empty() && !isZeroArea(a) && !isZeroArea(b) &&
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
	std::copy_if(all.zeroAreaFaces.begin(), all.zeroAreaFaces.end(),
	             std::back_inserter(some.zeroAreaFaces),
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

// A few triangles between few places of a grid: contacts of every kind, zero-area faces too.
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
	for (unsigned seed = 0; seed < 200; ++seed) {
		SCOPED_TRACE("seed " + std::to_string(seed));
		std::mt19937 random(seed);
		const Mesh mesh = fuzzed(random);
		const Found all = expected(mesh);
		clean += all.empty() ? 1 : 0;
		wrong += all.pairs.empty() ? 0 : 1;
		flat += all.zeroAreaFaces.empty() ? 0 : 1;
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
		const Found some = onlyOf(all, isSuspect);
		ASSERT_EQ(searchAmong(mesh, isSuspect), some) << "share " << share;
		ASSERT_EQ(search(mesh, 2, &isSuspect), some) << "share " << share;
	}
	for (const int count : {clean, wrong, flat, closed}) {
		EXPECT_GT(count, 20);
	}
}

Mesh tangle(unsigned seed, int cuts) {
	std::mt19937 random(seed);
	std::normal_distribution<double> normal;
	Mesh mesh = joined(icosphere(cuts), placed(icosphere(cuts), random, 0.6));
	for (Point& p : mesh.points) {
		for (double& x : p) {
			x += 0.015 * normal(random);
		}
	}
	return mesh;
}

// Several levels of the pyramid and several slices, on any number of threads.
TEST(WrongPairs, aLargerTangleIsJudgedAsByRationalArithmetic) {
	const Mesh mesh = tangle(1, 3);
	const Found all = expected(mesh);
	EXPECT_GT(all.pairs.size(), 100U);
	for (const int threads : {1, 2, 5}) {
		EXPECT_EQ(search(mesh, threads), all);
	}
}

TEST(WrongPairs, theResultDependsOnNoThreads) {
	const Mesh mesh = tangle(2, 5);  // 40960 faces
	const Found one = search(mesh, 1);
	EXPECT_GT(one.pairs.size(), 1000U);
	for (const int threads : {2, 5, 12}) {
		EXPECT_EQ(search(mesh, threads), one);
	}
	std::vector<std::uint8_t> isSuspect(mesh.triangles.size());
	for (std::size_t face = 0; face < isSuspect.size(); face += 7) {
		isSuspect[face] = 1;
	}
	const Found some = onlyOf(one, isSuspect);
	for (const int threads : {1, 2, 5}) {
		EXPECT_EQ(searchAmong(mesh, isSuspect, threads), some);
	}
}

TEST(WrongPairs, numberingsOfVerticesFacesAndCornersDoNotMatter) {
	for (unsigned seed = 1000; seed < 1100; ++seed) {
		SCOPED_TRACE("seed " + std::to_string(seed));
		std::mt19937 random(seed);
		const Mesh mesh = fuzzed(random);
		std::vector<std::uint32_t> vertexOf(mesh.points.size()), faceOf(mesh.triangles.size());
		std::iota(vertexOf.begin(), vertexOf.end(), 0U);
		std::iota(faceOf.begin(), faceOf.end(), 0U);
		std::shuffle(vertexOf.begin(), vertexOf.end(), random);
		std::shuffle(faceOf.begin(), faceOf.end(), random);
		Mesh other;
		other.points.resize(mesh.points.size());
		for (std::size_t v = 0; v < vertexOf.size(); ++v) {
			other.points[vertexOf[v]] = mesh.points[v];
		}
		for (const std::uint32_t face : faceOf) {
			IndexTriangle t = mesh.triangles[face];
			std::rotate(t.begin(), t.begin() + random() % 3, t.end());
			other.triangles.push_back({vertexOf[t[0]], vertexOf[t[1]], vertexOf[t[2]]});
		}
		Found found = search(other);
		for (auto& pair : found.pairs) {
			const auto [low, high] = std::minmax(faceOf[pair[0]], faceOf[pair[1]]);
			pair = {low, high};
		}
		for (std::uint32_t& face : found.zeroAreaFaces) {
			face = faceOf[face];
		}
		std::sort(found.pairs.begin(), found.pairs.end());
		std::sort(found.zeroAreaFaces.begin(), found.zeroAreaFaces.end());
		ASSERT_EQ(found, search(mesh));
	}
}

TEST(WrongPairs, aCleanIcosphereHasNone) {
	const Mesh mesh = icosphere(5);  // 20480 faces
	for (const int threads : {1, 2, 5}) {
		EXPECT_TRUE(search(mesh, threads).empty());
	}
	EXPECT_TRUE(searchAmong(mesh, std::vector<std::uint8_t>(mesh.triangles.size(), 1)).empty());
}

TEST(WrongPairs, nothingIsFoundOfNothing) {
	EXPECT_TRUE(search({}).empty());
	EXPECT_TRUE(searchAmong(icosphere(1), std::vector<std::uint8_t>(80)).empty());
}

TEST(WrongPairs, faceTwiceAndFoldOverAnEdgeAndZeroAreaFaces) {
	Mesh mesh;
	mesh.points = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 0}, {2, 0, 0}, {0, 0, 1}, {0, -1, 0}};
	mesh.triangles = {{0, 1, 2}, {0, 2, 1}, {1, 0, 3}, {0, 4, 1}, {0, 0, 5}, {0, 1, 5}, {0, 6, 1}};
	const Pairs pairs{{0, 1}, {0, 2}, {1, 2}};
	EXPECT_EQ(search(mesh), (Found{pairs, {3, 4}}));
}

// A vertex that no face has, far away or no number, changes nothing.
TEST(WrongPairs, strayVerticesDoNotMatter) {
	Mesh mesh = tangle(3, 1);
	const Found all = search(mesh);
	ASSERT_FALSE(all.empty());
	mesh.points.push_back({1e300, std::nan(""), -1e300});
	std::swap(mesh.points.front(), mesh.points.back());
	for (auto& t : mesh.triangles) {
		for (std::uint32_t& v : t) {
			v = v == 0 ? static_cast<std::uint32_t>(mesh.points.size() - 1) : v;
		}
	}
	EXPECT_EQ(search(mesh), all);
}

// What floats make of the vertices.
struct Certified {
	SearchedSurface surface;
	WordsLeave left;

	explicit Certified(const Mesh& mesh) : surface{viewed(mesh), 1, nullptr, {}, 0, {}, {}} {
		Monitor monitor;
		const Status status = inOrder([&] { return placeInFrame(surface, monitor); },
		                              [&] { return findUnbalancedVertices(surface, monitor); },
		                              [&] { return certifyStars(surface, monitor, left); });
		EXPECT_TRUE(status.ok());
	}
};

// Thin bars side by side, by twos through each other; turned, their boxes all overlap.
Mesh bars(int side, bool areTurned) {
	constexpr double kCos = 0.6, kSin = 0.8;
	Mesh all;
	for (int i = 0; i < side * side; ++i) {
		const double x = 0.1 * (i / side) - (i / side % 2) * 0.07, y = 0.1 * (i % side);
		const Mesh bar = shapes::box({x, y, 0}, {x + 0.04, y + 0.05, 9 + 0.01 * i});
		all = all.points.empty() ? bar : shapes::joined(all, bar);
	}
	for (Point& p : all.points) {
		if (areTurned) {
			p = {kCos * p[0] - kSin * p[2], p[1], kSin * p[0] + kCos * p[2]};
			p = {p[0], kCos * p[1] - kSin * p[2], kSin * p[1] + kCos * p[2]};
		}
	}
	return all;
}

TEST(SearchFrame, hasAxesOfItsOwnWhereLongFacesLieAskew) {
	EXPECT_GT(Certified(bars(7, true)).surface.boxMargin, 0);
	EXPECT_EQ(Certified(bars(7, false)).surface.boxMargin, 0);
	EXPECT_EQ(Certified(icosphere(4)).surface.boxMargin, 0);
}

TEST(WrongPairs, turnedBarsAreJudgedAsByRationalArithmetic) {
	const Mesh mesh = bars(7, true);
	const Found all = search(mesh);
	EXPECT_FALSE(all.empty());
	EXPECT_EQ(all, expected(mesh));
}

// In a frame with axes of its own stars are certified too, as its map is linear.
TEST(WrongPairs, turnedBarsThatAreApartHaveNone) {
	Mesh mesh = bars(7, true);
	for (std::size_t i = 0; i < mesh.points.size(); ++i) {
		mesh.points[i][0] += 20 * static_cast<double>(i / 8 / 7 % 2);  // each other row
	}
	EXPECT_GT(Certified(mesh).surface.boxMargin, 0);
	EXPECT_TRUE(search(mesh).empty());
}

// Lists what it is asked about.
class Asked : public WrongPairTaker {
public:
	bool wants(FacePair) const override {
		++asked_;
		return true;
	}
	void take(FacePair) override { ++taken_; }

	std::size_t asked() const { return asked_; }
	std::size_t taken() const { return taken_; }

private:
	mutable std::size_t asked_ = 0;
	std::size_t taken_ = 0;
};

// Pairs that were judged while the open stars of a mesh were closed.
Asked closed(Certified& certified) {
	Monitor monitor;
	Asked asked;
	PairJudge judge(certified.surface.faces, monitor, asked);
	EXPECT_TRUE(closeStars(certified.left.openStars, monitor, judge, certified.surface).ok());
	return asked;
}

// All spokes lie along axes, so that each coordinate ties with the vertex's.
TEST(StarWords, tiesOfCoordinatesNeedNoCare) {
	Mesh octahedron;
	octahedron.points = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
	octahedron.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4},
	                        {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}};
	EXPECT_TRUE(Certified(octahedron).left.openStars.empty());
	EXPECT_TRUE(Certified(turned(octahedron)).left.openStars.empty());
	EXPECT_TRUE(Certified(icosphere(3)).left.openStars.empty());
}

// No axis sees all three walls at a corner of a box, but its diagonal does.
TEST(StarWords, weakVerticesAreCertifiedByDoubles) {
	const Mesh cube = box({0, 0, 0}, {1, 2, 3});
	Certified certified(cube);
	EXPECT_EQ(certified.left.openStars.size(), 8U);
	EXPECT_EQ(closed(certified).asked(), 0U);
	for (std::uint32_t v = 0; v < 8; ++v) {
		EXPECT_EQ(certified.surface.points[v].star, v);
	}
}

// Cones over closed lines that go round an axis once or twice, closed by one below.
Mesh coneOver(int rounds, std::size_t sides, double height) {
	Mesh mesh;
	mesh.points = {{0, 0, height}, {0, 0, -1}};
	for (std::size_t i = 0; i < sides; ++i) {
		const double angle = 2 * kPi * rounds * static_cast<double>(i) / static_cast<double>(sides);
		const double radius = 1 + 0.3 * std::sin(angle / rounds + 0.3);
		mesh.points.push_back({radius * std::cos(angle), radius * std::sin(angle),
		                       rounds == 1 ? 0 : 0.2 * std::cos(angle / rounds)});
	}
	const auto count = static_cast<std::uint32_t>(sides);
	for (std::uint32_t i = 0; i < count; ++i) {
		mesh.triangles.push_back({0, 2 + i, 2 + (i + 1) % count});
		mesh.triangles.push_back({1, 2 + (i + 1) % count, 2 + i});
	}
	return mesh;
}

TEST(StarWords, aStarThatWindsTwiceIsNotCertified) {
	for (const std::size_t sides : {7U, 12U, 101U}) {
		const Mesh once = coneOver(1, sides, 1), twice = coneOver(2, sides, 1);
		Certified good(once), bad(twice);
		EXPECT_EQ(good.surface.points[0].star, 0U);
		EXPECT_EQ(bad.surface.points[0].star, kNone);
		closed(bad);
		EXPECT_EQ(bad.surface.points[0].star, sides > 64 ? kNone : 0U);
		EXPECT_TRUE(search(once).empty());
		EXPECT_FALSE(search(twice).empty());
		EXPECT_EQ(search(twice), expected(twice));
	}
}

// Wedges that all turn one way, of which one comes up through the vertex: two of them overlap.
TEST(StarWords, anOpenStarIsNotCertified) {
	Mesh fan;
	fan.points = {{0, 0, 1}, {1, -1, 0}, {1, 1, 0.1}, {2, 0.5, 0}, {-1, 2, 0.2}};
	fan.triangles = {{0, 1, 2}, {0, 3, 4}};
	EXPECT_EQ(Certified(fan).surface.points[0].star, kNone);
	EXPECT_EQ(search(fan), expected(fan));
	EXPECT_EQ(search(fan).pairs.size(), 1U);
}

TEST(UnbalancedVertices, areTheEndsOfEdgesWithoutAsManyFacesEachWay) {
	Mesh mesh = icosphere(1);
	EXPECT_TRUE(Certified(mesh).surface.isUnbalanced.empty());
	std::set<std::uint32_t> ends(mesh.triangles[7].begin(), mesh.triangles[7].end());
	std::swap(mesh.triangles[7][0], mesh.triangles[7][1]);
	for (const Mesh& bad : {mesh, [&] {
		                        Mesh open = mesh;
		                        open.triangles.erase(open.triangles.begin() + 7);
		                        return open;
	                        }()}) {
		const Certified certified(bad);
		ASSERT_EQ(certified.surface.isUnbalanced.size(), bad.points.size());
		for (std::uint32_t v = 0; v < bad.points.size(); ++v) {
			EXPECT_EQ(certified.surface.isUnbalanced[v], ends.count(v));
		}
	}
}

TEST(NearFaces, areFewAndMissNone) {
	const Mesh mesh = icosphere(5);
	std::vector<std::uint8_t> isSuspect(mesh.triangles.size());
	for (std::size_t face = 0; face < 20; ++face) {
		isSuspect[face] = 1;
	}
	Monitor monitor;
	std::vector<std::uint32_t> near;
	ASSERT_TRUE(findNearFaces(viewed(mesh), isSuspect, 2, monitor, near).ok());
	EXPECT_LT(near.size(), mesh.triangles.size() / 20);
	std::set<std::uint32_t> corners;
	for (std::size_t face = 0; face < 20; ++face) {
		corners.insert(mesh.triangles[face].begin(), mesh.triangles[face].end());
	}
	for (std::uint32_t face = 0; face < mesh.triangles.size(); ++face) {
		const IndexTriangle& t = mesh.triangles[face];
		if (std::any_of(t.begin(), t.end(),
		                [&](std::uint32_t v) { return corners.count(v) > 0; })) {
			EXPECT_TRUE(std::binary_search(near.begin(), near.end(), face)) << face;
		}
	}
}

TEST(BoxPyramid, setsOfLanesAreThoseOfAnyProcessor) {
	std::mt19937 random(1);
	for (int i = 0; i < 1000; ++i) {
		std::array<std::uint32_t, 8> masks{};
		Lanes lanes = 0;
		for (unsigned lane = 0; lane < 8; ++lane) {
			masks[lane] = maskOf(random() % 2 == 0);
			lanes |= masks[lane] != 0 ? 1U << lane : 0U;
		}
		EXPECT_EQ(lanesOf(masks), lanes);
		EXPECT_EQ(lanesOfMasks(masks), lanes);
	}
}

// Long triangles through one small ball or disc: all pairs have boxes that meet, and many meet
// wrongly; in one plane each takes long to decide.
Mesh manyCrossing(bool inOnePlane) {
	std::mt19937 random(5);
	std::normal_distribution<double> normal;
	Mesh mesh;
	for (std::uint32_t i = 0; i < 4000; ++i) {
		for (int k = 0; k < 3; ++k) {
			const Point p{normal(random), normal(random), normal(random)};
			mesh.points.push_back({p[0], p[1], inOnePlane ? 2 * p[0] : p[2]});
		}
		mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
	}
	return mesh;
}

TEST(WrongPairs, cancelIsHeardInTime) {
	using Clock = std::chrono::steady_clock;
	for (const bool inOnePlane : {false, true}) {
		const Mesh mesh = manyCrossing(inOnePlane);
		for (const int threads : {1, 2}) {
			const Clock::time_point start = Clock::now();
			Clock::time_point previous = start, last = start;
			Monitor monitor([&](double, const char*) {
				previous = last;
				last = Clock::now();
				return last - start < std::chrono::milliseconds(150);
			});
			monitor.beginStage("test", 0, 1);
			WrongPairs wrong;
			const Status status = findWrongPairs(viewed(mesh), {threads, false}, monitor, wrong);
			const std::chrono::duration<double> gap = last - previous, late = Clock::now() - last;
			EXPECT_EQ(status.code, StatusCode::Cancelled);
			EXPECT_LT(gap.count(), 0.1);
			EXPECT_LT(late.count(), 0.1);
		}
	}
}

}  // namespace
}  // namespace index_boolean
