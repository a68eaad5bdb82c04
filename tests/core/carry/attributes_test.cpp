// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where attributes come from: what is said of each vertex, face and corner is put to the test by
// coordinates alone; weights that are fractions with few bits are exactly those.
#include "core/any_operands.h"

#include <gtest/gtest.h>

#include <set>

namespace index_boolean {
namespace {

using namespace shapes;

const bool kNeverSame = false, kAlwaysSame = true;

// A run on two meshes and the sources of one block.
struct Sources {
	MeshArrays given;
	BooleanRun blocks;
	Block block;
	Seams seams;
	AttributeSources sources;
	Status status;

	Point meanOf(const AttributeMix& mix) const { return meanOf(mix.face, mix.weights); }
	Point meanOf(GivenFace face, const std::array<double, 3>& weights) const {
		const Triangle t = triangle(given, face);
		Point mean{};
		for (std::size_t j = 0; j < 3; ++j) {
			for (std::size_t k = 0; k < 3; ++k) {
				mean[k] += weights[j] * at(given.points, t[j])[k];
			}
		}
		return mean;
	}
	static Triangle triangle(const MeshArrays& arrays, GivenFace face) {
		return arrays.triangles[arrays.faceOffsets.begin(face.operand) + face.index];
	}
};

Sources sourcesOf(const Mesh& a, const Mesh& b, Operation operation, bool same = kNeverSame,
                  bool partCurve = false, Options options = {}) {
	Sources s;
	s.given = arrays(a, b);
	s.blocks = run(a, b, options);
	s.status = s.blocks.status;
	if (!s.status.ok()) {
		return s;
	}
	s.block = s.blocks.block(operation);
	const GivenTriangles given = [&s](GivenFace f) { return Sources::triangle(s.given, f); };
	Monitor monitor;
	s.status = operandSeams(
	    s.blocks.arrangement, given, [same](VertexId, VertexId) { return same; }, monitor, s.seams);
	EXPECT_TRUE(s.status.ok());
	s.status = attributeSources(s.blocks.arrangement, {given, s.seams, {true, partCurve}}, monitor,
	                            s.block, s.sources);
	return s;
}

void expectNear(const Point& a, const Point& b) {
	for (std::size_t k = 0; k < 3; ++k) {
		EXPECT_NEAR(a[k], b[k], 1e-11);
	}
}

void expectMean(const std::array<double, 3>& weights) {
	double sum = 0;
	for (const double w : weights) {
		EXPECT_GE(w, 0);
		sum += w;
	}
	EXPECT_NEAR(sum, 1, 0x1p-38);
}

// All that is said gives the coordinates back: exactly where nothing was cut.
void expectTrue(const Sources& s) {
	ASSERT_TRUE(s.status.ok()) << describe(s.status);
	ASSERT_EQ(s.sources.vertex.size(), s.block.points.size());
	ASSERT_EQ(s.sources.face.size(), s.block.triangles.size());
	for (std::size_t v = 0; v < s.block.points.size(); ++v) {
		if (s.sources.isMix(v)) {
			expectMean(s.sources.mixOfVertex(v).weights);
			expectNear(s.meanOf(s.sources.mixOfVertex(v)), s.block.points[v]);
		} else {
			EXPECT_EQ(s.given.points[s.sources.vertex[v]], s.block.points[v]);
		}
	}
	for (std::size_t f = 0; f < s.block.triangles.size(); ++f) {
		const Triangle given = Sources::triangle(s.given, s.sources.face[f]);
		for (std::size_t i = 0; i < 3; ++i) {
			const Point& place = s.block.points[s.block.triangles[f][i]];
			const std::uint32_t corner = s.sources.corner[f][i];
			if (corner < 3) {
				EXPECT_EQ(at(s.given.points, given[corner]), place);
			} else {
				expectMean(s.sources.mixes[corner - 3].weights);
				expectNear(s.meanOf(s.sources.mixes[corner - 3]), place);
			}
		}
	}
}

TEST(AttributeSources, giveTheCoordinatesOfEveryElementBack) {
	std::mt19937 random(11);
	const Mesh ball = placed(sphere(12, {0, 0, 0}, 1), random, 0.1);
	const Mesh ring = placed(torus(17, 9, 1, 0.35), random, 0.2);
	for (int k = 0; k < kOperationCount; ++k) {
		SCOPED_TRACE(k);
		expectTrue(sourcesOf(ball, ring, static_cast<Operation>(k)));
		expectTrue(sourcesOf(turned(ball), soup(ring), static_cast<Operation>(k)));
		expectTrue(sourcesOf(ball, ring, static_cast<Operation>(k), kNeverSame, true));
	}
}

// Touching and coplanar: vertices in faces and edges of the other operand.
TEST(AttributeSources, areTrueForContactsOfEveryKind) {
	std::mt19937 random(12);
	for (int pair = 0; pair < 200; ++pair) {
		const Mesh a = gridBox(random, 3), b = gridBox(random, 3);
		for (int k = 0; k < kOperationCount; ++k) {
			SCOPED_TRACE(pair * 10 + k);
			expectTrue(sourcesOf(a, b, static_cast<Operation>(k)));
		}
	}
}

TEST(AttributeSources, haveExactWeights) {
	const Sources s =
	    sourcesOf(box({0, 0, 0}, {4, 4, 4}), box({1, 2, 3}, {5, 6, 7}), Operation::Union);
	expectTrue(s);
	std::size_t onEdges = 0;
	for (const AttributeMix& mix : s.sources.mixes) {
		double sum = 0;
		for (const double w : mix.weights) {
			EXPECT_EQ(w * 4, std::floor(w * 4));
			sum += w;
		}
		EXPECT_EQ(sum, 1);
		onEdges += std::count(mix.weights.begin(), mix.weights.end(), 0.0) > 0 ? 1 : 0;
	}
	EXPECT_GT(onEdges, 0u);
}

// A face a thousand million times as long as wide: its corners' coordinates, rounded, would not do.
TEST(AttributeSources, areExactInNeedles) {
	Mesh needle;
	needle.points = {{0, 0, 0}, {1, 0, 0}, {1, 0x1p-30, 0}, {0.5, 0, 0.5}};
	needle.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
	const Sources s =
	    sourcesOf(needle, box({0.25, -1, -1}, {0.75, 1, 1}), Operation::FirstMinusSecond);
	ASSERT_TRUE(s.status.ok()) << describe(s.status);
	for (std::size_t v = 0; v < s.block.points.size(); ++v) {
		if (s.sources.isMix(v)) {
			const Point mean = s.meanOf(s.sources.mixOfVertex(v));
			EXPECT_NEAR(mean[1], s.block.points[v][1], 1e-12 * 0x1p-30);
		}
	}
}

TEST(AttributeSources, ofACommonVertexAreThoseOfTheFirst) {
	const Sources s =
	    sourcesOf(box({0, 0, 0}, {4, 4, 4}), box({1, 2, 3}, {5, 6, 7}), Operation::Union);
	const auto operandOf = [&](std::size_t v) {
		return s.sources.isMix(v) ? s.sources.mixOfVertex(v).face.operand
		                          : s.given.vertexOffsets.operandOf(s.sources.vertex[v]);
	};
	for (std::size_t f = 0; f < s.block.triangles.size(); ++f) {
		for (const std::uint32_t v : s.block.triangles[f]) {
			EXPECT_LE(operandOf(v).value, s.sources.face[f].operand.value);
		}
	}
}

// A box whose top and bottom are one polygon each, of n times n pairs of triangles.
Mesh plate(std::uint32_t n) {
	Mesh m;
	const auto number = [n](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
		return (k * (n + 1) + j) * (n + 1) + i;
	};
	for (std::uint32_t v = 0; v < 2 * (n + 1) * (n + 1); ++v) {
		m.points.push_back(
		    {1.0 * (v % (n + 1)), 1.0 * (v / (n + 1) % (n + 1)), 1.0 * (v / (n + 1) / (n + 1))});
	}
	const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
		m.triangles.push_back({a, b, c});
		m.triangles.push_back({a, c, d});
	};
	for (std::uint32_t i = 0; i < n; ++i) {
		for (std::uint32_t j = 0; j < n; ++j) {
			quad(number(i, j, 1), number(i + 1, j, 1), number(i + 1, j + 1, 1),
			     number(i, j + 1, 1));
			quad(number(i, j, 0), number(i, j + 1, 0), number(i + 1, j + 1, 0),
			     number(i + 1, j, 0));
		}
		quad(number(i, 0, 0), number(i + 1, 0, 0), number(i + 1, 0, 1), number(i, 0, 1));
		quad(number(i + 1, n, 0), number(i, n, 0), number(i, n, 1), number(i + 1, n, 1));
		quad(number(n, i, 0), number(n, i + 1, 0), number(n, i + 1, 1), number(n, i, 1));
		quad(number(0, i + 1, 0), number(0, i, 0), number(0, i, 1), number(0, i + 1, 1));
	}
	const auto isBorder = [&](const Point& a, const Point& b) {
		return (a[0] == b[0] && (a[0] == 0 || a[0] == n)) ||
		       (a[1] == b[1] && (a[1] == 0 || a[1] == n));
	};
	for (const auto& t : m.triangles) {
		std::uint8_t faux = 0;
		const auto& p = m.points;
		const bool isFlat = p[t[0]][2] == p[t[1]][2] && p[t[1]][2] == p[t[2]][2];
		for (std::size_t i = 0; i < 3; ++i) {
			if (isFlat && !isBorder(p[t[i]], p[t[(i + 1) % 3]])) {
				markFaux(faux, i);
			}
		}
		m.faux.push_back(faux);
	}
	return m;
}

// Whether a point of the plane of a triangle in z = 0 or z = 1 lies in it; exact on a grid.
bool liesIn(const MeshArrays& given, const Triangle& t, const Point& p) {
	int left = 0, right = 0;
	for (std::size_t i = 0; i < 3; ++i) {
		const Point &a = at(given.points, t[i]), &b = at(given.points, t[(i + 1) % 3]);
		const double side = (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
		left += side > 0 ? 1 : 0;
		right += side < 0 ? 1 : 0;
	}
	return (left == 0 || right == 0) && at(given.points, t[0])[2] == p[2];
}

// A face that was merged has corners outside of its source: they are looked for in its polygon.
TEST(AttributeSources, areThoseOfTheFirstFaceOfAPolygonThatAVertexLiesIn) {
	std::mt19937 random(14);
	const Mesh polygons = permuted(plate(12), random);
	std::size_t elsewhere = 0;
	for (const double shift : {0.0, 0.25, 0.5}) {
		const Sources s = sourcesOf(polygons, box({3 + shift, 2.5, -1}, {8, 9 + shift, 2}),
		                            Operation::FirstMinusSecond);
		expectTrue(s);
		for (std::size_t f = 0; f < s.block.triangles.size(); ++f) {
			for (std::size_t i = 0; i < 3; ++i) {
				if (s.sources.corner[f][i] < 3) {
					continue;
				}
				const GivenFace own = s.sources.face[f];
				const GivenFace found = s.sources.mixes[s.sources.corner[f][i] - 3].face;
				const Point& p = s.block.points[s.block.triangles[f][i]];
				const bool isOwn = own == found;
				elsewhere += isOwn ? 0 : 1;
				EXPECT_TRUE(isOwn || !liesIn(s.given, Sources::triangle(s.given, own), p));
				for (std::uint32_t g = 0; g < found.index && !isOwn; ++g) {
					const Triangle t = Sources::triangle(s.given, {kFirst, g});
					const bool isFlat =
					    at(s.given.points, t[0])[2] == at(s.given.points, t[1])[2] &&
					    at(s.given.points, t[1])[2] == at(s.given.points, t[2])[2];
					EXPECT_FALSE(isFlat && liesIn(s.given, t, p));
				}
			}
		}
	}
	EXPECT_GT(elsewhere, 100u);
}

// How many vertices lie in each place, at most.
std::size_t mostCopies(const Block& block) {
	std::map<Point, std::size_t> copies;
	std::size_t most = 0;
	for (const Point& p : block.points) {
		most = std::max(most, ++copies[p]);
	}
	return most;
}

TEST(Seams, stayApartAlsoAtNewVertices) {
	// Each wall of the box has four vertices of its own.
	const Mesh plain = box({0, 0, 0}, {4, 4, 4});
	Mesh walls;
	for (std::size_t f = 0; f < plain.triangles.size(); f += 2) {
		std::map<std::uint32_t, std::uint32_t> number;
		for (std::size_t i = f; i < f + 2; ++i) {
			std::array<std::uint32_t, 3> t{};
			for (std::size_t k = 0; k < 3; ++k) {
				const auto [it, isNew] = number.emplace(
				    plain.triangles[i][k], static_cast<std::uint32_t>(walls.points.size()));
				if (isNew) {
					walls.points.push_back(plain.points[plain.triangles[i][k]]);
				}
				t[k] = it->second;
			}
			walls.triangles.push_back(t);
		}
	}
	ASSERT_EQ(walls.points.size(), 24u);
	const Mesh other = box({1, 2, 3}, {5, 6, 7});
	const Sources apart = sourcesOf(walls, other, Operation::FirstMinusSecond);
	expectTrue(apart);
	EXPECT_EQ(mostCopies(apart.block), 3u);
	for (std::uint32_t v = 0; v < walls.points.size(); ++v) {
		EXPECT_EQ(apart.seams.sideOf({v}), VertexId{v});
	}
	EXPECT_EQ(apart.seams.sideOf({24}), VertexId::none()) << "of the other operand";
	std::map<Point, std::set<std::size_t>> wallsOf;  // of the first operand, at each place
	std::map<Point, std::set<std::uint32_t>> verticesAt;
	for (std::size_t f = 0; f < apart.block.triangles.size(); ++f) {
		for (const std::uint32_t v : apart.block.triangles[f]) {
			if (apart.sources.face[f].operand == kFirst) {
				wallsOf[apart.block.points[v]].insert(apart.sources.face[f].index / 2);
				verticesAt[apart.block.points[v]].insert(v);
			}
		}
	}
	bool anyNew = false;
	for (const auto& [place, wallsThere] : wallsOf) {
		EXPECT_EQ(verticesAt[place].size(), wallsThere.size());
		const bool isCorner =
		    std::find(plain.points.begin(), plain.points.end(), place) != plain.points.end();
		anyNew = anyNew || (!isCorner && wallsThere.size() == 2);
	}
	EXPECT_TRUE(anyNew);
	const Sources sewn = sourcesOf(walls, other, Operation::FirstMinusSecond, kAlwaysSame);
	expectTrue(sewn);
	EXPECT_EQ(mostCopies(sewn.block), 1u);
	EXPECT_FALSE(sewn.seams.any());
	EXPECT_TRUE(isClosed(sewn.block.triangles));
}

// Where two solids of one operand touch, they have their own vertices: that is no seam.
TEST(Seams, areNotWhereAnOperandTouchesItself) {
	const Mesh touching = joined(box({0, 0, 0}, {2, 2, 2}),
	                             joined(box({2, 2, 0}, {4, 4, 2}), box({4, 4, 2}, {6, 6, 4})));
	const Mesh away = box({-2, -2, -2}, {1, 1, 1});
	const Sources s = sourcesOf(touching, away, Operation::FirstMinusSecond);
	expectTrue(s);
	EXPECT_FALSE(s.seams.any());
	EXPECT_TRUE(isClosed(s.block.triangles));
	EXPECT_TRUE(isManifold(s.block.triangles));
	EXPECT_EQ(s.block.points.size(), s.blocks.block(Operation::FirstMinusSecond).points.size());
	Options options;
	options.weldNonManifold = true;
	const Sources welded =
	    sourcesOf(touching, away, Operation::FirstMinusSecond, kNeverSame, false, options);
	expectTrue(welded);
	EXPECT_EQ(mostCopies(welded.block), 1u);
}

TEST(DuplicatedCurve, givesEachOperandItsOwnVertices) {
	const Sources s = sourcesOf(box({0, 0, 0}, {4, 4, 4}), box({1, 2, 3}, {5, 6, 7}),
	                            Operation::Union, kNeverSame, true);
	expectTrue(s);
	std::array<std::set<std::uint32_t>, 2> used;
	for (std::size_t f = 0; f < s.block.triangles.size(); ++f) {
		used[s.sources.face[f].operand.value].insert(s.block.triangles[f].begin(),
		                                             s.block.triangles[f].end());
	}
	for (const std::uint32_t v : used[0]) {
		EXPECT_EQ(used[1].count(v), 0u);
	}
}

// Corners of a face merged across the diagonal of a quad are found in the other triangle.
TEST(AttributeSources, areFoundInTheWholePolygon) {
	Mesh quads = box({0, 0, 0}, {4, 4, 4});
	quads.faux = {4, 1, 4, 1, 4, 1, 4, 1, 4, 1, 4, 1};  // the diagonals of box()
	for (const Mesh& other : {box({1, 2, 3}, {5, 6, 7}), box({-1, -1, 2}, {5, 5, 5})}) {
		for (int k = 0; k < kOperationCount; ++k) {
			SCOPED_TRACE(k);
			expectTrue(sourcesOf(quads, other, static_cast<Operation>(k)));
		}
	}
}

TEST(FaceClasses, keepCoplanarFacesApart) {
	Options options;
	options.mergeCoplanar = true;
	const auto unionFaces = [&](std::uint32_t first, std::uint32_t second) {
		MeshArrays both = arrays(box({0, 0, 0}, {1, 1, 1}), box({1, 0, 0}, {2, 1, 1}));
		both.faceClass = {std::vector<std::uint32_t>(12, first),
		                  std::vector<std::uint32_t>(12, second)};
		Arrangement arrangement;
		Block block;
		Monitor monitor;
		EXPECT_TRUE(arrange(std::move(both), options, monitor, arrangement).ok());
		EXPECT_TRUE(extractBlock(arrangement, Operation::Union, monitor, block).ok());
		return block.triangles.size();
	};
	EXPECT_EQ(unionFaces(3, 3), 12u);
	EXPECT_EQ(unionFaces(3, 4), 20u);
}

// Two crossing bars in one layer, each with a value of its own everywhere. Where they meet, the
// block has one vertex: with the value of one of them.
TEST(AttributeSources, ofSheetsOfOneOperandDoNotDependOnTheNumbering) {
	const Mesh bars = layer({box({-3, -1, -1}, {3, 1, 1}), box({-1, -3, -0.5}, {1, 3, 0.5})});
	const auto valueAt = [](const Point& given) { return std::fabs(given[0]) == 3 ? 1. : 0.; };
	std::mt19937 random(5);
	std::map<Point, double> expected;
	for (int n = 0; n < 30; ++n) {
		const Mesh mesh = permuted(bars, random);
		const CellsRun r = runCells({mesh});
		Block block = blockOf(r, inAny);
		const GivenTriangles given = [&mesh](GivenFace f) {
			const IndexTriangle& t = mesh.triangles[f.index];
			return Triangle{VertexId{t[0]}, VertexId{t[1]}, VertexId{t[2]}};
		};
		Monitor monitor;
		AttributeSources sources;
		ASSERT_TRUE(attributeSources(r.arrangement, {given, Seams{}, {false, false}}, monitor,
		                             block, sources)
		                .ok());
		std::map<Point, double> values;
		for (std::size_t v = 0; v < block.points.size(); ++v) {
			const bool isMix = sources.isMix(v);
			const std::uint32_t vertex =
			    isMix ? given(sources.mixOfVertex(v).face)[0].value : sources.vertex[v];
			values[block.points[v]] = valueAt(mesh.points[vertex]);
		}
		expected = n == 0 ? values : expected;
		EXPECT_EQ(values, expected);
	}
	EXPECT_GE(expected.size(), 24U);
}

}  // namespace
}  // namespace index_boolean
