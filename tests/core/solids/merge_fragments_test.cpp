// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cuts that part nothing leave no trace, and coplanar neighbours become one face where asked for.
#include "core/near_coplanar.h"
#include "core/shapes.h"

#include <vcg_ext/arrange/places.h>
#include <vcg_ext/solids/merge_fragments.h>

#include <gtest/gtest.h>

#include <functional>

namespace index_boolean {
namespace {

using namespace shapes;

constexpr std::size_t kUnion = 0, kIntersection = 1, kFirstOnly = 2, kSecondOnly = 3;

Options withCoplanar() {
	Options options;
	options.mergeCoplanar = true;
	return options;
}

Options withoutMerging() {
	Options options;
	options.mergeFragments = false;
	return options;
}

std::array<std::size_t, 4> faceCounts(const BooleanRun& r) {
	return {r.blocks[kUnion].triangles.size(), r.blocks[kIntersection].triangles.size(),
	        r.blocks[kFirstOnly].triangles.size(), r.blocks[kSecondOnly].triangles.size()};
}

std::vector<std::array<Point, 3>> geometryOf(const Mesh& m) {
	Block block;
	block.points = m.points;
	block.triangles = m.triangles;
	return geometry(block);
}

TEST(MergeFragments, aWallTouchedByASmallerOneIsWholeAgain) {
	const Mesh large = box({0, 0, 0}, {4, 4, 4});
	// On top of it, under its bottom from inside, and through its middle touching no edge.
	for (const Mesh& small : {box({1, 1, 4}, {2, 3, 5}), box({1, 1, 0}, {2, 3, 1}),
	                          box({0.5, 1.25, 4}, {3.5, 1.5, 6}), box({0, 1, 1}, {1, 2, 2})}) {
		for (const bool swap : {false, true}) {
			const BooleanRun r = swap ? run(small, large) : run(large, small);
			ASSERT_TRUE(r.status.ok());
			const bool inside = r.volume(Operation::Intersection) > 0;
			const Block& untouched =
			    inside ? r.blocks[kUnion] : r.blocks[swap ? kSecondOnly : kFirstOnly];
			EXPECT_EQ(geometry(untouched), geometryOf(large));
			const Block& other =
			    inside ? r.blocks[kIntersection] : r.blocks[swap ? kFirstOnly : kSecondOnly];
			EXPECT_EQ(geometry(other), geometryOf(small));
		}
	}
}

TEST(MergeFragments, cutsStayWhereNotAskedFor) {
	const BooleanRun r =
	    run(box({0, 0, 0}, {4, 4, 4}), box({1, 1, 4}, {2, 3, 5}), withoutMerging());
	ASSERT_TRUE(r.status.ok());
	EXPECT_GT(r.blocks[kFirstOnly].triangles.size(), 12u);
}

// It is a vertex of both where both are kept: else the face would have a point in common with the
// other solid that is no vertex of it, and the block would meet itself.
TEST(MergeFragments, aVertexThatTouchesAFaceFromOutsideIsOneOfBoth) {
	Mesh tetrahedron;
	tetrahedron.points = {{2, 1.5, 4}, {1, 1, 6}, {3, 1, 6}, {2, 3, 6}};
	tetrahedron.triangles = {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}};
	const Mesh large = box({0, 0, 0}, {4, 4, 4});
	const BooleanRun r = run(large, tetrahedron);
	ASSERT_TRUE(r.status.ok()) << describe(r.status);
	EXPECT_EQ(geometry(r.blocks[kFirstOnly]), geometryOf(large));
	EXPECT_EQ(geometry(r.blocks[kSecondOnly]), geometryOf(tetrahedron));
	const Block& both = r.blocks[kUnion];
	EXPECT_EQ(both.triangles.size(), 12u + 4u + 2u);
	EXPECT_EQ(std::count(both.points.begin(), both.points.end(), tetrahedron.points[0]), 2);
	EXPECT_EQ(r.audit.blocks[kUnion].components, 2u);
}

// A corner of an input face of which a piece is left is left too.
TEST(MergeFragments, inputVerticesStay) {
	std::size_t corners = 0;
	for (std::uint32_t seed = 0; seed < 40; ++seed) {
		SCOPED_TRACE("seed " + std::to_string(seed));
		std::mt19937 random(seed);
		const BooleanRun solid = run(gridBox(random, 4), gridBox(random, 4), withoutMerging());
		ASSERT_TRUE(solid.status.ok());
		// It has many vertices inside walls and inside straight edges.
		const Mesh m{solid.blocks[kUnion].points, solid.blocks[kUnion].triangles};
		const Mesh c = gridBox(random, 4);
		const BooleanRun plain = run(m, c, withoutMerging()), merged = run(m, c);
		ASSERT_TRUE(plain.status.ok() && merged.status.ok());
		for (std::size_t k = 0; k < 5; ++k) {
			const Block& block = plain.blocks[k];
			Points kept = merged.blocks[k].points;
			std::sort(kept.begin(), kept.end());
			for (std::size_t f = 0; f < block.triangles.size(); ++f) {
				const Triangle& parent =
				    at(plain.arrangement.mesh.triangles, block.faceSource[f].face);
				for (const std::uint32_t v : block.triangles[f]) {
					if (std::find(parent.begin(), parent.end(), block.vertexSource[v]) !=
					    parent.end()) {
						EXPECT_TRUE(std::binary_search(kept.begin(), kept.end(), block.points[v]));
						++corners;
					}
				}
			}
		}
	}
	EXPECT_GT(corners, 10000u);
}

TEST(MergeFragments, solidsThatTouchAreFitForTheNextRun) {
	// An edge of the second lies inside an edge of the first; the third cuts both at an end of it.
	const BooleanRun both = run(box({0, 0, 0}, {4, 4, 4}), box({4, 1, 4}, {6, 2, 6}));
	ASSERT_TRUE(both.status.ok());
	const Mesh solids{both.blocks[kUnion].points, both.blocks[kUnion].triangles};
	for (const Options& options : {Options{}, withCoplanar()}) {
		const BooleanRun r = run(solids, box({3, 0.5, 3}, {5, 1.5, 5}), options);
		ASSERT_TRUE(r.status.ok()) << describe(r.status);
		EXPECT_DOUBLE_EQ(r.volume(Operation::FirstMinusSecond), 66.5);
	}
}

// Boxes on a grid, united and cut off one after another: the volume is counted.
TEST(MergeFragments, longChainsOfRunsOnAGridAreNeverRefused) {
	constexpr std::size_t kSize = 6;
	std::size_t runs = 0;
	for (std::uint32_t seed = 0; seed < 40; ++seed) {
		std::mt19937 random(seed);
		std::array<bool, kSize * kSize * kSize> cells{};
		Mesh solid;
		for (int step = 0; step < 10; ++step) {
			std::array<std::size_t, 3> low, high;
			for (std::size_t i = 0; i < 3; ++i) {
				low[i] = random() % (kSize - 1);
				high[i] = std::min(kSize, low[i] + 1 + random() % 3);
			}
			const bool adds = step == 0 || random() % 2 == 0;
			for (std::size_t c = 0; c < cells.size(); ++c) {
				const std::array<std::size_t, 3> at{c % kSize, c / kSize % kSize,
				                                    c / kSize / kSize};
				if (std::equal(at.begin(), at.end(), low.begin(), std::greater_equal<>()) &&
				    std::equal(at.begin(), at.end(), high.begin(), std::less<>())) {
					cells[c] = adds;
				}
			}
			const auto point = [](const std::array<std::size_t, 3>& p) {
				return Point{static_cast<double>(p[0]), static_cast<double>(p[1]),
				             static_cast<double>(p[2])};
			};
			const Mesh next = box(point(low), point(high));
			const auto count = static_cast<double>(std::count(cells.begin(), cells.end(), true));
			if (step == 0) {
				solid = next;
				continue;
			}
			const BooleanRun r = run(solid, next, seed % 2 == 0 ? Options{} : withCoplanar());
			ASSERT_TRUE(r.status.ok())
			    << "seed " << seed << ", step " << step << ": " << describe(r.status);
			const Block& block = r.blocks[adds ? kUnion : kFirstOnly];
			EXPECT_NEAR(volumeOf(block.points, block.triangles), count, 1e-9);
			solid = {block.points, block.triangles};
			++runs;
			if (count == 0) {
				break;
			}
		}
	}
	EXPECT_GT(runs, 300u);
}

// A prism over a pentagon whose wall edge at (1, 1) is one vertex at its bottom, two at its top.
Mesh prismWithASplitEdge() {
	Mesh m;
	const std::array<std::array<double, 2>, 5> base{{{1, 1}, {2, -1}, {4, -1}, {4, 3}, {2, 3}}};
	for (const double z : {-1.0, 1.0}) {
		for (const auto& [x, y] : base) {
			m.points.push_back({x, y, z});
		}
	}
	m.points.push_back({1, 1 + 0x1p-52, 1});
	m.triangles = {{0, 2, 1},  {0, 3, 2}, {0, 4, 3}, {5, 6, 7},  {5, 7, 8},  {5, 8, 9},
	               {5, 9, 10}, {0, 1, 6}, {0, 6, 5}, {1, 2, 7},  {1, 7, 6},  {2, 3, 8},
	               {2, 8, 7},  {3, 4, 9}, {3, 9, 8}, {4, 0, 10}, {4, 10, 9}, {0, 5, 10}};
	return m;
}

// Faces around one vertex, in a wall of the first operand; its other corners are points of the
// curve, ccw, and two of them have the same coordinates once rounded.
struct StarInAWall {
	Arrangement arrangement;
	VertexId centre;
	std::vector<VertexId> around;

	StarInAWall() {
		Mesh wall;
		wall.points = {{-40, -40, 0}, {40, -40, 0}, {0, 60, 0}, {0, 0, -30}};
		wall.triangles = {{0, 1, 2}, {1, 0, 3}, {2, 1, 3}, {0, 2, 3}};
		Mesh cavity;  // stands on the wall
		cavity.points = {{2, 1, 0}, {2.5, 0.5, 0}, {2.5, 1.5, 0}, {2.25, 1, 0.5}};
		cavity.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
		Monitor monitor;
		const Status status = arrange(arrays(wall, joined(prismWithASplitEdge(), turned(cavity))),
		                              {}, monitor, arrangement);
		EXPECT_TRUE(status.ok()) << describe(status);
		centre = {4 + 11};
		listAround();
	}

	// In front of the wall's own outline, counter-clockwise from the upper one of the two.
	void listAround() {
		for (const Point& p :
		     {Point{1, 1, 0}, Point{2, -1, 0}, Point{4, -1, 0}, Point{4, 3, 0}, Point{2, 3, 0}}) {
			for (std::uint32_t i = 0; i < arrangement.curve.pointCount(); ++i) {
				if (arrangement.curve.rounded[i] == p) {
					around.push_back(arrangement.vertexOf({i}));
				}
			}
		}
		ASSERT_EQ(around.size(), 6u);
		if (comparePlaces(arrangement, around[0], around[1]) < 0) {
			std::swap(around[0], around[1]);
		}
	}

	// The faces without the centre, by what their corners are. \param order of the vertices
	std::vector<std::array<std::uint32_t, 3>> merged(const std::vector<VertexId>& order) const {
		Block block;
		for (const VertexId v : order) {
			block.points.push_back(outputCoordinates(arrangement, v));
			block.vertexSource.push_back(v);
			block.suspect.push_back(v == centre ? 1 : 0);
		}
		const auto number = [&](VertexId v) {
			return static_cast<std::uint32_t>(std::find(order.begin(), order.end(), v) -
			                                  order.begin());
		};
		for (std::size_t i = 0; i < around.size(); ++i) {
			block.triangles.push_back(
			    {number(centre), number(around[i]), number(around[(i + 1) % around.size()])});
			block.faceSource.push_back({FaceId{0}, false});
		}
		Monitor monitor;
		EXPECT_TRUE(mergeFragments(arrangement, monitor, block).ok());
		std::vector<std::array<std::uint32_t, 3>> faces;
		for (const auto& t : block.triangles) {
			std::array<std::uint32_t, 3> corners{block.vertexSource[t[0]].value,
			                                     block.vertexSource[t[1]].value,
			                                     block.vertexSource[t[2]].value};
			std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()),
			            corners.end());
			faces.push_back(corners);
		}
		std::sort(faces.begin(), faces.end());
		return faces;
	}
};

TEST(MergeFragments, theNumberingDoesNotTellNeighboursInOneRoundedPlaceApart) {
	const StarInAWall star;
	ASSERT_EQ(star.arrangement.coordinates(star.around[0]),
	          star.arrangement.coordinates(star.around[1]));
	ASSERT_NE(comparePlaces(star.arrangement, star.around[0], star.around[1]), 0);
	std::vector<VertexId> order = star.around;
	order.push_back(star.centre);
	const auto faces = star.merged(order);
	EXPECT_EQ(faces.size(), 4u);
	std::mt19937 random(3);
	for (int i = 0; i < 50; ++i) {
		std::shuffle(order.begin(), order.end(), random);
		EXPECT_EQ(star.merged(order), faces);
	}
}

TEST(MergeCoplanar, cubesThatOverlapAtACornerHaveTheFewestFaces) {
	const Mesh a = box({0, 0, 0}, {2, 2, 2}), b = box({1, 1, 1}, {3, 3, 3});
	const std::array<std::size_t, 4> fewest{36, 12, 24, 24};
	EXPECT_EQ(faceCounts(run(a, b, withCoplanar())), fewest);
	EXPECT_EQ(faceCounts(run(b, a, withCoplanar())), fewest);
}

TEST(MergeCoplanar, aRowOfCubesBecomesOneBox) {
	Mesh row = box({0, 0, 0}, {1, 1, 1});
	for (int i = 2; i < 8; i += 2) {
		row = joined(row, box({1.0 * i, 0, 0}, {i + 1.0, 1, 1}));
	}
	Mesh between = box({1, 0, 0}, {2, 1, 1});
	for (int i = 3; i < 7; i += 2) {
		between = joined(between, box({1.0 * i, 0, 0}, {i + 1.0, 1, 1}));
	}
	const BooleanRun r = run(row, between, withCoplanar());
	ASSERT_TRUE(r.status.ok());
	EXPECT_EQ(geometry(r.blocks[kUnion]).size(), 12u);
	EXPECT_DOUBLE_EQ(r.volume(Operation::Union), 7);
	EXPECT_EQ(r.audit.blocks[kUnion].components, 1u);
}

// The area of the faces of one class in the plane z = 1.
double areaOfTop(const Block& block, const std::vector<std::uint32_t>& classes,
                 std::uint32_t wanted) {
	double area = 0;
	for (std::size_t f = 0; f < block.triangles.size(); ++f) {
		const IndexTriangle& t = block.triangles[f];
		const Point &p = block.points[t[0]], &q = block.points[t[1]], &r = block.points[t[2]];
		const bool isTop = p[2] == 1 && q[2] == 1 && r[2] == 1;
		if (isTop && classes[block.faceSource[f].face.value] == wanted) {
			area += ((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])) / 2;
		}
	}
	return area;
}

// In one plane, a border between two classes may bend: a quarter, and an L around it.
TEST(MergeCoplanar, aBentBorderOfClassesStays) {
	for (std::uint32_t seed = 0; seed < 20; ++seed) {
		SCOPED_TRACE("seed " + std::to_string(seed));
		std::mt19937 random(seed);
		Mesh cube = squaredCube(4, random);
		const Mesh far = box({99, 9, 9}, {100, 10, 10});
		const std::vector<std::uint32_t> columns = classesByHalf(cube, 0, 0, 1);
		std::vector<std::uint32_t> classes = classesByHalf(cube, 1, 0, 1);
		for (std::size_t f = 0; f < classes.size(); ++f) {
			classes[f] = classes[f] == 1 && columns[f] == 1 ? 7 : 5;
		}
		for (Point& p : cube.points) {
			p[0] += seed;  // vertices go in another order elsewhere
		}
		MeshArrays input = arrays(cube, far);
		input.faceClass = {classes, std::vector<std::uint32_t>(12, 9)};
		Monitor monitor;
		Arrangement arrangement;
		ASSERT_TRUE(arrange(std::move(input), withCoplanar(), monitor, arrangement).ok());
		Block block;
		ASSERT_TRUE(extractBlock(arrangement, Operation::FirstMinusSecond, monitor, block).ok());
		EXPECT_EQ(areaOfTop(block, classes, 7), 0.25);
		EXPECT_EQ(areaOfTop(block, classes, 5), 0.75);
		EXPECT_LT(block.points.size(), cube.points.size() / 2);
	}
}

TEST(MergeCoplanar, aRoundSurfaceStaysAsItIs) {
	std::mt19937 random(5);
	const Mesh a = placed(sphere(12, {0, 0, 0}, 1), random, 0);
	const Mesh b = placed(sphere(12, {0, 0, 0}, 1), random, 0.3);
	EXPECT_EQ(faceCounts(run(a, b)), faceCounts(run(a, b, withCoplanar())));
}

// Integer prisms over staircases, many coplanar neighbours and collinear vertices: volumes and
// closedness stay, whatever is merged.
TEST(MergeCoplanar, volumesStayWithEveryOption) {
	for (std::uint32_t seed = 0; seed < 40; ++seed) {
		SCOPED_TRACE("seed " + std::to_string(seed));
		std::mt19937 random(seed);
		const Mesh a = gridBox(random, 5), b = gridBox(random, 5), c = gridBox(random, 5);
		const BooleanRun first = run(a, b, withoutMerging());
		ASSERT_TRUE(first.status.ok());
		for (const Block& block : {first.blocks[kUnion], first.blocks[kFirstOnly]}) {
			if (block.triangles.empty()) {
				continue;
			}
			const Mesh m{block.points, block.triangles};
			const BooleanRun plain = run(m, c, withoutMerging());
			const BooleanRun merged = run(m, c);
			const BooleanRun flat = run(m, c, withCoplanar());
			const BooleanRun swapped = run(c, m, withCoplanar());
			ASSERT_TRUE(plain.status.ok()) << describe(plain.status);
			ASSERT_TRUE(merged.status.ok() && flat.status.ok() && swapped.status.ok());
			for (std::size_t k = 0; k < 5; ++k) {
				const double volume = volumeOf(plain.blocks[k].points, plain.blocks[k].triangles);
				for (const BooleanRun* r : {&merged, &flat}) {
					const Block& got = r->blocks[k];
					EXPECT_NEAR(volumeOf(got.points, got.triangles), volume, 1e-9);
					EXPECT_TRUE(isManifold(got.triangles)) << operationName(got.operation);
				}
				EXPECT_LE(merged.blocks[k].triangles.size(), plain.blocks[k].triangles.size());
				EXPECT_LE(flat.blocks[k].triangles.size(), merged.blocks[k].triangles.size());
			}
			EXPECT_EQ(geometry(flat.blocks[kUnion]), geometry(swapped.blocks[kUnion]));
			EXPECT_EQ(geometry(flat.blocks[kFirstOnly]), geometry(swapped.blocks[kSecondOnly]));
		}
	}
}

}  // namespace
}  // namespace index_boolean
