// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Surfaces clipped by solids: closed forms, unit squares that are counted one by one, solids that
// meet themselves, and what is refused.
#include "core/split_operands.h"
#include "support/voxel_oracle.h"

#include <gtest/gtest.h>

#include <set>

namespace index_boolean {
namespace {

using namespace shapes;

const Clip kInside{kFirst, kSecond, true}, kOutside{kFirst, kSecond, false};

// The surface inside the solid, then outside.
OperandsSplit clip(const Mesh& surface, const Mesh& solid, const Options& options = onOneThread()) {
	return splitAll({surface, solid}, options, {kInside, kOutside});
}

// What holds for any clip: each sub-surface is in one of the two, as it is in the split.
void expectParted(const OperandsSplit& r) {
	ASSERT_TRUE(r.status.ok()) << describe(r.status);
	std::vector<SubSurfaceId> ids;
	Triangles3 both;
	for (const SplitMesh& mesh : r.clips) {
		const std::set<SubSurfaceId> found(mesh.subSurface.begin(), mesh.subSurface.end());
		ids.insert(ids.end(), found.begin(), found.end());
		const Triangles3 triangles = placesOf(mesh);
		both.insert(both.end(), triangles.begin(), triangles.end());
		EXPECT_EQ(mesh.beside.size(), mesh.triangles.size());
		EXPECT_EQ(mesh.faceSource.size(), mesh.triangles.size());
	}
	std::sort(ids.begin(), ids.end());
	std::sort(both.begin(), both.end());
	EXPECT_EQ(ids, r.split.surfaces.ofOperand[kFirst]);
	EXPECT_EQ(both, placesOf(r.surfaces[0]));
}

void expectAreas(const OperandsSplit& r, double inside, double outside) {
	expectParted(r);
	EXPECT_NEAR(areaOf(placesOf(r.clips[0])), inside, 1e-13 * (inside + outside));
	EXPECT_NEAR(areaOf(placesOf(r.clips[1])), outside, 1e-13 * (inside + outside));
	EXPECT_EQ(r.clips[0].certificate.count(), 0);
	EXPECT_EQ(r.clips[1].certificate.count(), 0);
}

const Mesh kCube = box({0, 0, 0}, {2, 2, 2});

TEST(Clip, aSheetThroughABox) {
	expectAreas(clip(level(-1, 3, 0.5), kCube), 4, 12);
	expectAreas(clip(level(1, 3, 0.5), kCube), 1, 3);
	expectAreas(clip(level(0.5, 1.5, 0.5), kCube), 1, 0);
	expectAreas(clip(level(3, 4, 0.5), kCube), 0, 1);
	expectAreas(clip(level(0, 4, 2.5), kCube), 0, 16);
	expectAreas(clip(rectangle({-1, -1, -1}, {3, 3, -1}, {3, 3, 3}, {-1, -1, 3}), kCube),
	            4 * std::sqrt(2.), 12 * std::sqrt(2.));
}

TEST(Clip, whatLiesOnTheSolidsFacesIsInside) {
	expectAreas(clip(level(-1, 3, 2), kCube), 4, 12);
	expectAreas(clip(level(-1, 3, 0), kCube), 4, 12);
	expectAreas(clip(level(0, 2, 2), kCube), 4, 0);
	expectAreas(clip(level(0.5, 1.5, 2), kCube), 1, 0);
	expectAreas(clip(level(2, 3, 2), kCube), 0, 1);  // a corner is on it, but no face
	expectAreas(clip(turned(level(-1, 3, 2)), kCube), 4, 12);
	expectAreas(clip(kCube, kCube), 24, 0);
	// Three of its walls lie on those of the solid, and the others do not.
	expectAreas(clip(box({0, 0, 0}, {4, 4, 4}), kCube), 12, 84);
}

TEST(Clip, aSolidIsClippedAsASurface) {
	expectAreas(clip(box({1, 1, 1}, {3, 3, 3}), kCube), 3, 21);
	const OperandsSplit r = clip(box({0.5, 0.5, 0.5}, {1, 1, 1}), kCube);
	expectAreas(r, 1.5, 0);
	EXPECT_TRUE(isClosed(r.clips[0].triangles));
}

TEST(Clip, theSurfaceKeepsTheWayItIsTurned) {
	for (const bool isTurned : {false, true}) {
		const Mesh sheet = isTurned ? turned(level(-1, 3, 0.5)) : level(-1, 3, 0.5);
		for (const Mesh& solid : {kCube, box({0, 0, 0}, {2, 2, 0.5})}) {
			const OperandsSplit r = clip(sheet, solid);
			expectAreas(r, 4, 12);
			for (const IndexTriangle& t : r.clips[0].triangles) {
				const Points& p = r.clips[0].points;
				const double up = (p[t[1]][0] - p[t[0]][0]) * (p[t[2]][1] - p[t[0]][1]) -
				                  (p[t[1]][1] - p[t[0]][1]) * (p[t[2]][0] - p[t[0]][0]);
				EXPECT_EQ(up < 0, isTurned);
			}
		}
	}
}

TEST(Clip, bothWaysAndAmongOthers) {
	const Mesh a = box({0, 0, 0}, {2, 2, 2}), b = box({1, 1, 1}, {3, 3, 3});
	const std::vector<Clip> all{
	    kInside, kOutside, {kSecond, kFirst, true}, {kSecond, kFirst, false}};
	for (const bool isThird : {false, true}) {
		std::vector<Mesh> operands{a, b};
		if (isThird) {
			operands.push_back(level(-1, 4, 1.5));
		}
		const OperandsSplit r = splitAll(operands, onOneThread(), all);
		ASSERT_TRUE(r.status.ok()) << describe(r.status);
		for (const std::size_t i : {0U, 1U, 2U, 3U}) {
			EXPECT_NEAR(areaOf(placesOf(r.clips[i])), i % 2 == 0 ? 3 : 21, 1e-13) << i;
		}
	}
}

// --- solids that are no embedded surfaces -------------------------------------------------------

Options byRule(WindingRule rule) {
	Options options = onOneThread();
	options.windingRule = rule;
	return options;
}

TEST(Clip, theSolidIsWhatItsRuleSays) {
	const Mesh sheet = level(-1, 4, 1.5);
	const Mesh solid = layer({kCube, box({1, 1, 1}, {3, 3, 3})});  // 4, 4 and 1 in common
	expectAreas(clip(sheet, solid), 7, 18);
	expectAreas(clip(sheet, solid, byRule(WindingRule::Positive)), 7, 18);
	expectAreas(clip(sheet, solid, byRule(WindingRule::Odd)), 6, 19);
	const Mesh partlyInsideOut = layer({kCube, turned(box({1, 1, 1}, {3, 3, 3}))});
	expectAreas(clip(sheet, partlyInsideOut), 6, 19);
	expectAreas(clip(sheet, partlyInsideOut, byRule(WindingRule::Positive)), 3, 22);
	expectAreas(clip(sheet, turned(kCube)), 4, 21);
}

TEST(Clip, aSurfaceThatMeetsItselfIsClippedInPieces) {
	const Mesh crossing =
	    layer({level(-1, 3, 0.5), rectangle({1, -1, -1}, {1, 3, -1}, {1, 3, 3}, {1, -1, 3})});
	const OperandsSplit r = clip(crossing, kCube);
	expectAreas(r, 8, 24);
	EXPECT_EQ(
	    std::set<SubSurfaceId>(r.clips[0].subSurface.begin(), r.clips[0].subSurface.end()).size(),
	    4u);
}

TEST(Clip, aSolidMayBeClosedOnlyOnceItIsCut) {
	const Mesh hanging = boxWithHangingVertex({1, 0, 2});
	expectAreas(clip(level(-1, 3, 0.5), hanging), 4, 12);
	const OperandsSplit r = clip(level(0, 5, 1.5), skinOfTwoBoxes());
	expectAreas(r, 4 + 4, 25 - 8);
}

TEST(Clip, aSolidWhoseFacesAreTurnedAnyhow) {
	Mesh patchwork = kCube;
	std::swap(patchwork.triangles[3][1], patchwork.triangles[3][2]);
	expectAreas(clip(level(-1, 3, 0.5), patchwork), 4, 12);
	// The two of its four cells that lie above z = 0 have sections with legs of 7/8.
	expectAreas(clip(level(-1, 3, 0.125), tetrahemihexahedron(), byRule(WindingRule::Odd)),
	            0.875 * 0.875, 16 - 0.875 * 0.875);
}

// Of parts that are turned differently the winding numbers are as given.
TEST(Clip, aPartOfTheSolidMayBeInsideOut) {
	const Mesh sheet = level(-1, 9, 0.5);
	const Mesh both = layer({turned(kCube), box({4, 4, 0}, {5, 5, 1})});
	expectAreas(clip(sheet, both), 5, 95);
	expectAreas(clip(sheet, both, byRule(WindingRule::Odd)), 5, 95);
	expectAreas(clip(sheet, both, byRule(WindingRule::Positive)), 1, 99);
	expectAreas(clip(sheet, turned(both), byRule(WindingRule::Positive)), 4, 96);
}

// Both faces of a fin are walls, but nothing is inside it.
TEST(Clip, aDoubleFinOfTheSolidIsNoPartOfIt) {
	const Mesh fin = rectangle({2, 0, 0.5}, {3, 0, 0.5}, {3, 2, 0.5}, {2, 2, 0.5});
	expectAreas(clip(level(-1, 3, 0.5), layer({kCube, fin, turned(fin)})), 4, 12);
}

// --- unit squares, counted ----------------------------------------------------------------------

constexpr int kSpan = 6;

bool isIn(WindingRule rule, int winding) {
	return rule == WindingRule::Odd        ? winding % 2 != 0
	       : rule == WindingRule::Positive ? winding > 0
	                                       : winding != 0;
}

bool isNowherePositive(const voxels::BoxLayer& boxes) {
	for (int i = 0; i < kSpan * kSpan * kSpan; ++i) {
		if (voxels::countAround(boxes, {i % kSpan, i / kSpan % kSpan, i / kSpan / kSpan}) > 0) {
			return false;
		}
	}
	return true;
}

TEST(Clip, unitSquaresAreInsideIfACubeBesideThemIs) {
	std::mt19937 random(41);
	const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
	std::size_t inside = 0, outside = 0, soups = 0;
	for (int round = 0; round < 300; ++round) {
		voxels::BoxLayer boxes;
		std::vector<Mesh> parts;
		for (int i = 0; i < 1 + round % 4; ++i) {
			voxels::SignedBox b{{}, {}, below(3) == 0 ? -1 : 1};
			Point low{}, high{};
			for (std::size_t k = 0; k < 3; ++k) {
				b.low[k] = below(kSpan);
				b.high[k] = b.low[k] + 1 + below(kSpan - b.low[k]);
				low[k] = b.low[k];
				high[k] = b.high[k];
			}
			boxes.push_back(b);
			parts.push_back(b.sign < 0 ? turned(box(low, high)) : box(low, high));
		}
		if (isNowherePositive(boxes)) {
			for (voxels::SignedBox& b : boxes) {
				b.sign = -b.sign;  // it is turned as a whole
			}
		}
		const auto rule = static_cast<WindingRule>(round % 3);
		std::vector<Corners> squares;
		double expected = 0, total = 0;
		for (int i = 0; i < 40; ++i) {
			voxels::Place cube{below(kSpan + 1), below(kSpan + 1), below(kSpan + 1)};
			const auto axis = static_cast<std::size_t>(below(3));
			voxels::Place before = cube;
			--before[axis];
			Point a{}, b{}, c{}, d{};
			for (std::size_t k = 0; k < 3; ++k) {
				a[k] = b[k] = c[k] = d[k] = cube[k];
			}
			b[(axis + 1) % 3] += 1;
			c[(axis + 1) % 3] += 1;
			c[(axis + 2) % 3] += 1;
			d[(axis + 2) % 3] += 1;
			const Corners half{a, b, c};
			if (std::find(squares.begin(), squares.end(), half) != squares.end()) {
				continue;
			}
			addQuad(squares, a, b, c, d);
			total += 1;
			expected += isIn(rule, voxels::countAround(boxes, cube)) ||
			                    isIn(rule, voxels::countAround(boxes, before))
			                ? 1
			                : 0;
		}
		const OperandsSplit r = clip(welded(squares), layer(parts), byRule(rule));
		if (r.status.code == StatusCode::NoVolume) {
			continue;
		}
		expectAreas(r, expected, total - expected);
		inside += expected > 0 ? 1 : 0;
		outside += expected < total ? 1 : 0;
		soups += r.arrangement.isSoup ? 1 : 0;
		if (HasFailure()) {
			FAIL() << "round " << round;
		}
	}
	EXPECT_GT(inside, 200u);
	EXPECT_GT(outside, 200u);
	EXPECT_GT(soups, 50u);
	EXPECT_LT(soups, 290u);
}

// --- numbering, rounding ------------------------------------------------------------------------

TEST(Clip, noFaceDependsOnNumberingOrderOrThreads) {
	std::mt19937 random(3);
	for (int round = 0; round < 6; ++round) {
		const Mesh surface = placed(torus(12, 8, 1, 0.4), random, 0.2);
		const Mesh solid = placed(sphere(6, {0, 0, 0}, 1), random, 0.2);
		const OperandsSplit expected = clip(surface, solid);
		expectParted(expected);
		Options threads;
		threads.threads = 3;
		const OperandsSplit swapped =
		    splitAll({permuted(solid, random), permuted(surface, random)}, threads,
		             {{kSecond, kFirst, true}, {kSecond, kFirst, false}});
		for (const std::size_t i : {0U, 1U}) {
			EXPECT_EQ(placesOf(swapped.clips[i]), placesOf(expected.clips[i]));
			EXPECT_EQ(expected.clips[i].certificate.count(), 0);
		}
	}
}

// Clips hold as they are stored in single precision, and have the area of the exact one.
TEST(Clip, inSinglePrecision) {
	std::mt19937 random(8);
	Options options = onOneThread();
	options.outputScalar = OutputScalar::Float;
	options.selfIntersections = SelfIntersections::Resolve;
	for (int round = 0; round < 6; ++round) {
		Mesh surface = placed(torus(20, 12, 1, 0.4), random, 0.2);
		Mesh solid = placed(sphere(10, {0, 0, 0}, 1), random, 0.2);
		const OperandsSplit r = clip(surface, solid, options);
		ASSERT_TRUE(r.status.ok()) << describe(r.status);
		double sum = 0;
		for (const SplitMesh& mesh : r.clips) {
			EXPECT_EQ(mesh.certificate.count(), 0);
			for (const Point& p : mesh.points) {
				for (const double c : p) {
					EXPECT_EQ(c, static_cast<double>(static_cast<float>(c)));
				}
			}
			sum += areaOf(placesOf(mesh));
		}
		EXPECT_NEAR(sum, areaOf(placesOf(r.surfaces[0])), 1e-5);
	}
}

// --- refusals -----------------------------------------------------------------------------------

Mesh withoutFirstFaces(Mesh m, std::ptrdiff_t count) {
	m.triangles.erase(m.triangles.begin(), m.triangles.begin() + count);
	return m;
}

TEST(Clip, anOpenSolidIsRefusedWithTheFacesAtItsBorder) {
	const Mesh open = withoutFirstFaces(kCube, 1);
	for (const std::uint32_t k : {0U, 1U}) {
		for (const bool isThird : {false, true}) {
			std::vector<Mesh> operands{level(-1, 3, 0.5), level(-1, 3, 0.5)};
			operands[k] = open;
			if (isThird) {
				operands.push_back(box({5, 5, 5}, {6, 6, 6}));
			}
			const OperandsSplit r =
			    splitAll(operands, onOneThread(), {{OperandId{1 - k}, OperandId{k}, true}});
			EXPECT_EQ(r.status.code, StatusCode::NotClosed);
			EXPECT_EQ(r.status.operand, static_cast<int>(k));
			EXPECT_EQ(r.status.count, 3u);
			EXPECT_EQ(r.status.faces.size(), 3u);
			EXPECT_TRUE(splitAll(operands).status.ok()) << "it is open for a clip only";
		}
	}
	EXPECT_TRUE(clip(open, kCube).status.ok()) << "the clipped surface may be open";
}

TEST(Clip, aSolidWithNothingInsideIsRefused) {
	const Mesh sheet = level(-1, 3, 0.5);
	const Mesh insideOut =
	    layer({turned(kCube), box({5, 5, 5}, {6, 6, 6}), turned(box({5, 5, 5}, {6, 6, 6}))});
	const OperandsSplit doubled =
	    clip(level(-1, 3, 0.5), layer({kCube, turned(kCube), box({9, 9, 9}, {9.5, 9.5, 9.5}),
	                                   turned(box({9, 9, 9}, {9.5, 9.5, 9.5}))}));
	EXPECT_TRUE(doubled.status.code == StatusCode::NoVolume ||
	            doubled.status.code == StatusCode::EmptyOperand)
	    << describe(doubled.status);
	EXPECT_EQ(doubled.status.operand, 1);
	expectAreas(clip(sheet, insideOut), 4, 12);
}

TEST(Clip, aOneSidedSolidIsRefusedUnlessByTheOddRule) {
	const Mesh sheet = level(-1, 3, 0.125);
	const OperandsSplit r = clip(sheet, tetrahemihexahedron());
	EXPECT_EQ(r.status.code, StatusCode::NotOriented);
	EXPECT_EQ(r.status.operand, 1);
	EXPECT_TRUE(clip(sheet, tetrahemihexahedron(), byRule(WindingRule::Odd)).status.ok());
}

}  // namespace
}  // namespace index_boolean
