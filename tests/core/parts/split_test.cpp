// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sub-surfaces, sub-blocks and loops of any two surfaces: laws, counts, and what must not depend on
// how the input is numbered.
#include "core/shapes.h"

#include <vcg_ext/exact/zero_area.h>

#include <gtest/gtest.h>

#include <ctime>
#include <set>

namespace index_boolean {
namespace {

using namespace shapes;

struct SplitRun {
	Status status;
	Arrangement arrangement;
	Split split;
	std::array<SplitMesh, 2> surfaces;
	std::vector<SplitMesh> blocks;
	SplitAudit audit;
};

SplitRun splitOf(const Mesh& a, const Mesh& b, Options options = {}) {
	SplitRun r;
	Monitor monitor;
	r.status = arrangeSurfaces(arrays(a, b), options, monitor, r.arrangement);
	if (r.status.ok()) {
		r.status = split(r.arrangement, monitor, r.split);
	}
	for (std::size_t k = 0; k < 2 && r.status.ok(); ++k) {
		r.status = extractSubSurfaces(r.arrangement, r.split, makeId<OperandTag>(k), monitor,
		                              r.surfaces[k]);
	}
	for (std::uint32_t i = 0; i < r.split.blocks.all.size() && r.status.ok(); ++i) {
		r.blocks.emplace_back();
		r.status = extractSubBlock(r.arrangement, r.split, {i}, monitor, r.blocks.back());
	}
	if (r.status.ok()) {
		r.status = audit(r.arrangement, r.split, r.blocks, monitor, r.audit);
	}
	return r;
}

// An n by m grid of squares over [x0, x1] x [y0, y1], at height z(x, y).
template <class Height>
Mesh sheet(int n, int m, std::array<double, 4> xy, Height&& z) {
	Mesh s;
	for (int i = 0; i <= n; ++i) {
		for (int j = 0; j <= m; ++j) {
			const double x = xy[0] + (xy[1] - xy[0]) * i / n, y = xy[2] + (xy[3] - xy[2]) * j / m;
			s.points.push_back({x, y, z(x, y)});
		}
	}
	const auto id = [m](int i, int j) { return static_cast<std::uint32_t>(i * (m + 1) + j); };
	for (int i = 0; i < n; ++i) {
		for (int j = 0; j < m; ++j) {
			s.triangles.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
			s.triangles.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
		}
	}
	return s;
}

Mesh flatSheet(int n, std::array<double, 4> xy, double height) {
	return sheet(n, n, xy, [height](double, double) { return height; });
}

double areaOf(const Mesh& m) {
	double sum = 0;
	for (const auto& t : m.triangles) {
		std::array<Point, 2> e{};
		for (std::size_t k = 0; k < 3; ++k) {
			e[0][k] = m.points[t[1]][k] - m.points[t[0]][k];
			e[1][k] = m.points[t[2]][k] - m.points[t[0]][k];
		}
		sum += std::sqrt(std::pow(e[0][1] * e[1][2] - e[0][2] * e[1][1], 2) +
		                 std::pow(e[0][2] * e[1][0] - e[0][0] * e[1][2], 2) +
		                 std::pow(e[0][0] * e[1][1] - e[0][1] * e[1][0], 2)) /
		       2;
	}
	return sum;
}

// What holds for any two surfaces.
void expectLaws(const SplitRun& r, const Mesh& a, const Mesh& b) {
	ASSERT_TRUE(r.status.ok()) << describe(r.status);
	EXPECT_TRUE(r.audit.closed);
	EXPECT_LT(r.audit.volumeLawResidual, 1e-13);
	const SubSurfaces& surfaces = r.split.surfaces;
	const SubBlocks& blocks = r.split.blocks;
	const std::array<const Mesh*, 2> meshes{&a, &b};
	double scale = 0;
	for (const SubBlock& block : blocks.all) {
		scale += block.volume;
	}
	for (std::size_t k = 0; k < 2; ++k) {
		const auto operand = makeId<OperandTag>(k);
		double area = 0, volume = 0;
		for (const SubSurfaceId s : surfaces.ofOperand[operand]) {
			area += at(surfaces.all, s).area;
		}
		EXPECT_NEAR(area, areaOf(*meshes[k]), 1e-12 * areaOf(*meshes[k]));
		EXPECT_EQ(r.arrangement.closed[operand], isClosed(meshes[k]->triangles));
		for (const SubBlock& block : blocks.all) {
			volume += block.windings[operand] * block.volume;
		}
		const double expected = r.arrangement.closed[operand]
		                            ? std::fabs(volumeOf(meshes[k]->points, meshes[k]->triangles))
		                            : 0;
		EXPECT_NEAR(volume, expected, 1e-12 * scale);
	}
	// Each side of a sub-surface that parts space faces one block, or the outside.
	std::map<std::pair<std::uint32_t, bool>, std::int32_t> facing;
	for (std::size_t i = 0; i < blocks.all.size(); ++i) {
		ASSERT_TRUE(isClosed(r.blocks[i].triangles)) << "block " << i;
		for (const auto& beside : r.blocks[i].beside) {
			EXPECT_EQ(beside[1], static_cast<std::int32_t>(i));
			EXPECT_NE(beside[0], beside[1]);
		}
		EXPECT_NEAR(volumeOf(r.blocks[i].points, r.blocks[i].triangles), blocks.all[i].volume,
		            1e-12 * scale);
		EXPECT_GT(blocks.all[i].volume, 0);
		for (const SubSurfaceSide& side : blocks.all[i].sides) {
			EXPECT_TRUE(facing.emplace(std::pair(side.of.value, side.isBack), i).second);
		}
	}
	for (std::uint32_t s = 0; s < surfaces.all.size(); ++s) {
		for (const bool isBack : {false, true}) {
			const auto found = facing.find({s, isBack});
			const std::int32_t block = found == facing.end() ? kNoBlock : found->second;
			if (blocks.separates[s] != 0) {
				EXPECT_EQ(blocks.beside[s][isBack ? 1 : 0], block);
			} else {
				EXPECT_EQ(block, kNoBlock);
				EXPECT_EQ(blocks.beside[s][0], blocks.beside[s][1]);
			}
		}
	}
}

SplitRun lawful(const Mesh& a, const Mesh& b, Options options = {}) {
	SplitRun r = splitOf(a, b, options);
	expectLaws(r, a, b);
	return r;
}

std::vector<double> volumes(const SplitRun& r) {
	std::vector<double> all;
	for (const SubBlock& block : r.split.blocks.all) {
		all.push_back(block.volume);
	}
	std::sort(all.begin(), all.end());
	return all;
}

void expectVolumes(const SplitRun& r, const std::vector<double>& expected) {
	const std::vector<double> found = volumes(r);
	ASSERT_EQ(found.size(), expected.size());
	for (std::size_t i = 0; i < found.size(); ++i) {
		EXPECT_NEAR(found[i], expected[i], 1e-12 * expected.back());
	}
}

// The counts of open, hard-closed and soft-closed loops.
std::array<std::size_t, 3> loops(const SplitRun& r) {
	const LoopCounts& c = r.arrangement.loopCounts;
	return {c.open, c.hardClosed, c.softClosed};
}
using LoopNumbers = std::array<std::size_t, 3>;

std::size_t publicCount(const SplitRun& r, OperandId operand) {
	const auto& ids = r.split.surfaces.ofOperand[operand];
	return static_cast<std::size_t>(std::count_if(ids.begin(), ids.end(), [&](SubSurfaceId s) {
		return at(r.split.surfaces.all, s).isPublic();
	}));
}

std::size_t surfaceCount(const SplitRun& r, OperandId operand) {
	return r.split.surfaces.ofOperand[operand].size();
}

std::size_t separatingCount(const SplitRun& r) {
	const auto& separates = r.split.blocks.separates;
	return static_cast<std::size_t>(std::count(separates.begin(), separates.end(), 1));
}

const Mesh unitBox = box({0, 0, 0}, {1, 1, 1});

TEST(Split, sheetThroughBoxGivesTwoBlocks) {
	const SplitRun r = lawful(unitBox, flatSheet(3, {-1, 2, -1, 2}, 0.25));
	EXPECT_EQ(loops(r), (LoopNumbers{0, 1, 0}));
	EXPECT_EQ(surfaceCount(r, kFirst), 2u);
	EXPECT_EQ(surfaceCount(r, kSecond), 2u);
	EXPECT_EQ(publicCount(r, kSecond), 1u);
	expectVolumes(r, {0.25, 0.75});
	EXPECT_EQ(r.split.surfaces.atLoop[0].size(), 4u);
}

Status auditOf(const SplitRun& r, SplitAudit& out) {
	Monitor monitor;
	return audit(r.arrangement, r.split, r.blocks, monitor, out);
}

TEST(SplitAudit, aBoundaryThatIsOpenOrTurnedIsAnError) {
	const SplitRun right = lawful(unitBox, flatSheet(3, {-1, 2, -1, 2}, 0.25));
	SplitAudit found;
	SplitRun open = right;
	open.blocks[1].triangles.pop_back();
	EXPECT_EQ(auditOf(open, found).code, StatusCode::InternalError);
	EXPECT_FALSE(found.closed);
	SplitRun turned = right;
	std::swap(turned.blocks[0].triangles[4][0], turned.blocks[0].triangles[4][1]);
	EXPECT_EQ(auditOf(turned, found).code, StatusCode::InternalError);
	EXPECT_FALSE(found.closed);
}

TEST(SplitAudit, aVolumeThatIsNotTheBlocksIsAnError) {
	const SplitRun right = lawful(unitBox, flatSheet(3, {-1, 2, -1, 2}, 0.25));
	SplitAudit found;
	SplitRun swapped = right;
	std::swap(swapped.blocks[0], swapped.blocks[1]);
	EXPECT_EQ(auditOf(swapped, found).code, StatusCode::InternalError);
	EXPECT_TRUE(found.closed);
	SplitRun lost = right;
	lost.blocks.pop_back();
	lost.split.blocks.all.pop_back();
	EXPECT_EQ(auditOf(lost, found).code, StatusCode::InternalError);
	EXPECT_NEAR(found.volumeLawResidual, right.split.blocks.all.back().volume, 1e-15);
}

// The stretches between two calls, in time of the processor, so that a busy machine does no harm.
TEST(Split, theHostIsAskedOftenOnAMillionFaces) {
	const Mesh terrain = sheet(707, 707, {0, 1, 0, 1}, [](double x, double y) { return x * y; });
	const Mesh cut = sheet(60, 60, {-1, 2, -1, 2}, [](double x, double) { return 0.2 + 0.1 * x; });
	std::map<std::string, double> longest;
	std::string last;
	const auto seconds = [] { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; };
	double before = 0;
	Monitor monitor([&](double, const char* stage) {
		const double now = seconds();
		if (last == stage) {
			longest[stage] = std::max(longest[stage], now - before);
		}
		last = stage;
		before = now;
		return true;
	});
	Options options;
	options.threads = 1;
	SplitRun r;
	ASSERT_TRUE(arrangeSurfaces(arrays(terrain, cut), options, monitor, r.arrangement).ok());
	longest.clear();
	const double start = seconds();
	ASSERT_TRUE(split(r.arrangement, monitor, r.split).ok());
	ASSERT_TRUE(extractSubSurfaces(r.arrangement, r.split, kFirst, monitor, r.surfaces[0]).ok());
	for (const char* stage : {"sub_surfaces", "split_meshes"}) {
		EXPECT_EQ(longest.count(stage), 1u) << stage;
	}
	const double whole = seconds() - start;
	for (const auto& [stage, stretch] : longest) {
		EXPECT_LT(stretch, whole / 4) << stage << " of " << whole << " s";
	}
}

// The figures of the papers, in small.

TEST(SplitFigures, fourOpenLoopsCutTwoSheetsIntoFiveEach) {
	const auto wave = [](double x, double y) { return std::cos(4 * kPi * y) + 0.1 * x; };
	const Mesh a = flatSheet(7, {0, 1, 0, 1}, 0.02);
	const SplitRun r = lawful(a, sheet(5, 40, {0, 1, 0, 1}, wave));
	EXPECT_EQ(loops(r), (LoopNumbers{4, 0, 0}));
	for (const OperandId k : {kFirst, kSecond}) {
		EXPECT_EQ(surfaceCount(r, k), 5u);
		EXPECT_EQ(publicCount(r, k), 0u);
	}
	EXPECT_EQ(r.split.surfaces.cycles.size(), 10u);
	EXPECT_TRUE(r.blocks.empty());
	EXPECT_EQ(separatingCount(r), 0u);
}

// The boundary of unit cubes, given by their low corners; squares between two cubes are left out.
using Cubes = std::set<std::array<int, 3>>;

// A unit square: normal to `axis`, at the low corner of a cube.
struct Square {
	std::array<int, 3> corner;
	std::size_t axis;

	friend bool operator<(const Square& a, const Square& b) {
		return a.axis != b.axis ? a.axis < b.axis : a.corner < b.corner;
	}
};

// Squares as triangles with common corners, each of the given side length; facing towards larger
// coordinates, or turned.
Mesh meshOf(const std::vector<std::pair<Square, bool>>& squares, int side, std::mt19937& random) {
	Mesh m;
	std::map<Point, std::uint32_t> ids;
	for (const auto& [square, turned] : squares) {
		std::array<std::uint32_t, 4> c{};
		for (std::size_t i = 0; i < 4; ++i) {
			Point p{};
			for (std::size_t k = 0; k < 3; ++k) {
				p[k] = square.corner[k] * side;
			}
			p[(square.axis + 1) % 3] += i == 1 || i == 2 ? side : 0;
			p[(square.axis + 2) % 3] += i >= 2 ? side : 0;
			c[i] = ids.emplace(p, static_cast<std::uint32_t>(ids.size())).first->second;
			if (c[i] == m.points.size()) {
				m.points.push_back(p);
			}
		}
		if (turned) {
			std::swap(c[1], c[3]);
		}
		const std::size_t k = random() % 2;
		m.triangles.push_back({c[k], c[k + 1], c[k + 2]});
		m.triangles.push_back({c[k], c[k + 2], c[(k + 3) % 4]});
	}
	return m;
}

Mesh solid(const Cubes& cubes) {
	std::vector<std::pair<Square, bool>> squares;
	for (const auto& cube : cubes) {
		for (std::size_t axis = 0; axis < 3; ++axis) {
			auto next = cube, before = cube;
			++next[axis];
			--before[axis];
			if (cubes.count(next) == 0) {
				squares.push_back({{next, axis}, false});
			}
			if (cubes.count(before) == 0) {
				squares.push_back({{cube, axis}, true});
			}
		}
	}
	std::mt19937 random(1);
	return meshOf(squares, 1, random);
}

TEST(SplitFigures, sheetThroughThreeProngs) {
	Cubes comb;
	for (int x = 0; x < 5; ++x) {
		comb.insert({x, 0, 0});
		if (x % 2 == 0) {
			comb.insert({{x, 0, 1}});
			comb.insert({{x, 0, 2}});
		}
	}
	const SplitRun r = lawful(solid(comb), flatSheet(9, {-2, 8, -3, 4}, 1.3));
	EXPECT_EQ(loops(r), (LoopNumbers{0, 3, 0}));
	EXPECT_EQ(surfaceCount(r, kFirst), 4u);
	EXPECT_EQ(surfaceCount(r, kSecond), 4u);
	EXPECT_EQ(publicCount(r, kFirst), 1u);
	EXPECT_EQ(publicCount(r, kSecond), 1u);
	expectVolumes(r, {1.7, 1.7, 1.7, 5.9});
}

// A cylinder around the axis; the others are (axis + 1) % 3 and (axis + 2) % 3. Its n sides begin
// with an edge in the direction `first`.
Mesh cylinder(std::uint32_t n, std::size_t axis, std::size_t first, double radius, double length) {
	const std::size_t second = 3 - axis - first;
	Mesh m;
	for (const double end : {-length, length}) {
		for (std::uint32_t i = 0; i < n; ++i) {
			Point p{};
			p[axis] = end;
			p[first] = radius * std::cos(2 * kPi * i / n);
			p[second] = radius * std::sin(2 * kPi * i / n);
			m.points.push_back(p);
		}
		Point centre{};
		centre[axis] = end;
		m.points.push_back(centre);
	}
	const bool turned = (first + 1) % 3 != second;
	for (std::uint32_t i = 0; i < n; ++i) {
		const std::uint32_t j = (i + 1) % n, up = n + 1;
		for (auto t :
		     {std::array{i, j, up + j}, {i, up + j, up + i}, {j, i, n}, {up + i, up + j, up + n}}) {
			if (turned) {
				std::swap(t[1], t[2]);
			}
			m.triangles.push_back(t);
		}
	}
	if (axis != 2 && volumeOf(m.points, m.triangles) < 0) {
		m = shapes::turned(m);
	}
	return m;
}

TEST(SplitFigures, equalCylindersCrossInFourSoftClosedLoops) {
	const SplitRun r = lawful(cylinder(24, 0, 1, 1, 3), cylinder(24, 2, 1, 1, 3));
	EXPECT_EQ(loops(r), (LoopNumbers{0, 0, 4}));
	EXPECT_EQ(surfaceCount(r, kFirst), 4u);
	EXPECT_EQ(surfaceCount(r, kSecond), 4u);
	EXPECT_EQ(r.split.blocks.all.size(), 5u);
	for (const auto& around : r.split.surfaces.atLoop) {
		EXPECT_EQ(around.size(), 4u);
	}
}

TEST(SplitFigures, toriInEachOther) {
	Mesh other = torus(32, 16, 2, 0.5);
	for (Point& p : other.points) {
		p = {p[0] + 0.3, p[2], p[1]};
	}
	const SplitRun r = lawful(torus(32, 16, 2, 0.5), turned(other));
	EXPECT_EQ(r.arrangement.loopCounts.open, 0u);
	EXPECT_GE(r.split.blocks.all.size(), 4u);
}

TEST(Split, barThroughBothProngsHasThreePublicParts) {
	const Cubes u{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 0, 1}, {2, 0, 1}, {0, 0, 2}, {2, 0, 2}};
	const SplitRun r = lawful(solid(u), box({-1, 0.25, 1.25}, {4, 0.75, 1.75}));
	EXPECT_EQ(loops(r), (LoopNumbers{0, 4, 0}));
	EXPECT_EQ(surfaceCount(r, kSecond), 5u);
	EXPECT_EQ(publicCount(r, kSecond), 3u);
	EXPECT_EQ(surfaceCount(r, kFirst), 5u);
	expectVolumes(r, {0.25, 0.25, 0.25, 0.25, 0.25, 6.5});
}

// Placements that are not general.

TEST(Split, sheetThatEndsInsideTheSolidSeparatesNothing) {
	const SplitRun r = lawful(unitBox, flatSheet(3, {-1, 0.5, -1, 2}, 0.25));
	EXPECT_EQ(loops(r), (LoopNumbers{1, 0, 0}));
	EXPECT_EQ(surfaceCount(r, kFirst), 1u);
	expectVolumes(r, {1});
	EXPECT_EQ(separatingCount(r), 1u);
	EXPECT_EQ(r.split.blocks.all[0].dangling.size(), 1u);
	// The walls have a slit, which bounds nothing.
	EXPECT_EQ(publicCount(r, kFirst), 0u);
	const SubSurface& walls = at(r.split.surfaces.all, r.split.surfaces.ofOperand[kFirst][0]);
	EXPECT_EQ(walls.cycleCount, 1u);
	EXPECT_EQ(walls.closedCycles, 0u);
}

TEST(Split, sheetWhollyInsideDangles) {
	const SplitRun r = lawful(unitBox, flatSheet(3, {0.25, 0.75, 0.25, 0.75}, 0.25));
	EXPECT_EQ(loops(r), (LoopNumbers{0, 0, 0}));
	expectVolumes(r, {1});
	EXPECT_EQ(r.split.blocks.all[0].dangling.size(), 1u);
}

TEST(Split, sheetWhoseBorderLiesOnTheWalls) {
	const SplitRun r = lawful(unitBox, flatSheet(3, {0, 1, 0, 1}, 0.25));
	EXPECT_EQ(loops(r), (LoopNumbers{0, 1, 0}));
	EXPECT_EQ(surfaceCount(r, kFirst), 2u);
	EXPECT_EQ(surfaceCount(r, kSecond), 1u);
	expectVolumes(r, {0.25, 0.75});
}

TEST(Split, sheetOnAWallIsOneWithIt) {
	for (const double height : {0.0, 1.0}) {
		const SplitRun r = lawful(unitBox, flatSheet(4, {0.25, 0.75, 0.25, 0.75}, height));
		EXPECT_EQ(loops(r), (LoopNumbers{0, 1, 0}));
		EXPECT_EQ(surfaceCount(r, kFirst), 2u);
		EXPECT_EQ(surfaceCount(r, kSecond), 1u);
		EXPECT_EQ(r.split.surfaces.all.size(), 2u);
		expectVolumes(r, {1});
		EXPECT_EQ(separatingCount(r), 2u);
	}
	const SplitRun beyond = lawful(unitBox, flatSheet(6, {-1, 2, -1, 2}, 1));
	EXPECT_EQ(surfaceCount(beyond, kFirst), 2u);
	EXPECT_EQ(surfaceCount(beyond, kSecond), 2u);
	expectVolumes(beyond, {1});
}

TEST(Split, sheetTouchingAtAVertexAndAlongAnEdge) {
	const SplitRun vertex =
	    lawful(unitBox, sheet(2, 2, {0, 2, 0, 2}, [](double x, double y) { return 3 - x - y; }));
	expectVolumes(vertex, {1});
	const auto roof = [](double x, double) { return 1 + std::fabs(x - 0.5); };
	const SplitRun edge = lawful(unitBox, sheet(2, 1, {-0.5, 1.5, -1, 2}, roof));
	EXPECT_EQ(loops(edge), (LoopNumbers{1, 0, 0}));
	expectVolumes(edge, {1});
}

TEST(Split, sheetsMeetingAlongAnEdge) {
	const Mesh flat = flatSheet(2, {0, 1, 0, 1}, 0);
	const Mesh half = sheet(1, 2, {0, 1, 0, 1}, [](double x, double) { return 1 - x; });
	const SplitRun borders = lawful(flat, half);
	EXPECT_EQ(loops(borders), (LoopNumbers{1, 0, 0}));
	const Mesh upright = [] {
		Mesh m = flatSheet(2, {0, 1, 0, 1}, 0);
		for (Point& p : m.points) {
			p = {0.5, p[1], p[0]};
		}
		return m;
	}();
	const SplitRun inside = lawful(flat, upright);
	EXPECT_EQ(loops(inside), (LoopNumbers{1, 0, 0}));
	EXPECT_EQ(surfaceCount(inside, kFirst), 2u);
	EXPECT_TRUE(inside.blocks.empty());
}

TEST(Split, twoOpenBoxesMakeAClosedBlock) {
	Mesh lower = unitBox, upper = unitBox;
	lower.triangles.erase(lower.triangles.begin() + 2, lower.triangles.begin() + 4);
	upper.triangles.erase(upper.triangles.begin(), upper.triangles.begin() + 2);
	for (Point& p : upper.points) {
		p[2] += p[2] == 0 ? 1 : 2;
	}
	const SplitRun r = lawful(lower, upper);
	EXPECT_EQ(loops(r), (LoopNumbers{0, 1, 0}));
	expectVolumes(r, {3});
}

Mesh moebius(std::uint32_t n, double width) {
	Mesh m;
	for (std::uint32_t i = 0; i < n; ++i) {
		const double u = 2 * kPi * i / n;
		for (const double side : {-width, width}) {
			const double r = 1 + side * std::cos(u / 2);
			m.points.push_back({r * std::cos(u), r * std::sin(u), side * std::sin(u / 2)});
		}
	}
	for (std::uint32_t i = 0; i < n; ++i) {
		const std::uint32_t a = 2 * i, b = 2 * i + 1;
		const std::uint32_t c = i + 1 < n ? a + 2 : 1, d = i + 1 < n ? a + 3 : 0;
		m.triangles.push_back({a, c, d});
		m.triangles.push_back({a, d, b});
	}
	return m;
}

TEST(Split, moebiusStripHasOneSide) {
	const SplitRun r = lawful(box({-2, -2, -2}, {2, 2, 2}), moebius(31, 0.3));
	ASSERT_EQ(surfaceCount(r, kSecond), 1u);
	EXPECT_TRUE(at(r.split.surfaces.all, r.split.surfaces.ofOperand[kSecond][0]).oneSided);
	EXPECT_EQ(r.split.surfaces.cycles.size(), 1u);
	expectVolumes(r, {64});
	// A box that cuts it once leaves a strip with two sides.
	const SplitRun cut = lawful(box({0.5, -0.5, -2}, {2, 0.5, 2}), moebius(31, 0.3));
	EXPECT_EQ(surfaceCount(cut, kSecond), 2u);
	for (const SubSurface& surface : cut.split.surfaces.all) {
		EXPECT_FALSE(surface.oneSided);
	}
}

TEST(Split, shellsCavitiesAndGrains) {
	const Mesh shell = joined(box({0, 0, 0}, {8, 8, 8}), turned(box({1, 1, 1}, {7, 7, 7})));
	const SplitRun grain =
	    lawful(shell, joined(box({3, 3, 3}, {4, 4, 4}), box({9, 0, 0}, {10, 1, 1})));
	expectVolumes(grain, {1, 1, 215, 296});
	const SplitRun nested = lawful(joined(box({0, 0, 0}, {8, 8, 8}), box({2, 2, 2}, {6, 6, 6})),
	                               box({3, 3, 3}, {4, 4, 4}));
	expectVolumes(nested, {1, 63, 448});
	EXPECT_EQ(nested.split.blocks.all.back().windings, (PerOperand<std::int32_t>{2, 1}));
	const SplitRun cut = lawful(shell, flatSheet(5, {-1, 9, -1, 9}, 3.5));
	expectVolumes(cut, {36 * 2.5, 36 * 3.5, 64 * 3.5 - 36 * 2.5, 64 * 4.5 - 36 * 3.5});
}

TEST(Split, linkedRingsFaceOneOutside) {
	Mesh other = torus(24, 12, 2, 0.5);
	for (Point& p : other.points) {
		p = {p[0] + 2, p[2], p[1]};
	}
	const SplitRun r = lawful(torus(24, 12, 2, 0.5), other);
	EXPECT_EQ(r.split.blocks.all.size(), 2u);
}

TEST(Split, boxesOfOneOperandSharingAnEdge) {
	const Mesh pair = solid({{0, 0, 0}, {1, 1, 0}});
	const SplitRun r = lawful(pair, flatSheet(5, {-1, 3, -1, 3}, 0.25));
	expectVolumes(r, {0.25, 0.25, 0.75, 0.75});
	EXPECT_EQ(loops(r), (LoopNumbers{0, 0, 2}));
	const SplitRun apart = lawful(pair, box({5, 5, 5}, {6, 6, 6}));
	expectVolumes(apart, {1, 1, 1});
	EXPECT_EQ(surfaceCount(apart, kFirst), 2u);
}

TEST(Split, insideOutSolidIsASolid) {
	const SplitRun r = lawful(turned(unitBox), flatSheet(3, {-1, 2, -1, 2}, 0.25));
	expectVolumes(r, {0.25, 0.75});
	EXPECT_EQ(r.split.blocks.all[0].windings[kFirst], 1);
}

// Lines that meet edges, corners, and two faces in one place.
TEST(Split, linesThroughEdgesAndCorners) {
	Mesh grain;
	grain.points = {{-3, -1.5, -5}, {3, -1.5, -5}, {0, 3, -5}};
	grain.triangles = {{0, 1, 2}};
	Mesh a = box({-1, -1, 0}, {1, 1, 3}), b = box({-1.5, -2, 0}, {1.5, 2, 4});
	for (Mesh* mesh : {&a, &b}) {
		for (Point& p : mesh->points) {
			p[2] = p[2] == 0 ? (mesh == &a ? 1 + p[0] : 1 - p[0]) : p[2];
		}
	}
	expectVolumes(lawful(joined(grain, a), b), {2, 6, 30});
	expectVolumes(lawful(a, joined(b, grain)), {2, 6, 30});
	Mesh diamond;
	diamond.points = {{-9, 0, 0}, {9, 0, 0}, {0, -9, 0}, {0, 9, 0}, {0, 0, -9}, {0, 0, 9}};
	for (std::uint32_t i = 0; i < 8; ++i) {
		const std::uint32_t x = i & 1u, y = 2 + (i >> 1 & 1u), z = 4 + (i >> 2 & 1u);
		const bool turned = ((i & 1u) + (i >> 1 & 1u) + (i >> 2 & 1u)) % 2 == 0;
		diamond.triangles.push_back({x, turned ? z : y, turned ? y : z});
	}
	for (Point& p : grain.points) {
		p[2] = 0.5;
	}
	const SplitRun r = lawful(diamond, grain);
	expectVolumes(r, {972});
	EXPECT_EQ(r.split.blocks.all[0].dangling.size(), 1u);
}

TEST(Split, manyGrainsInAShell) {
	Mesh grains;
	constexpr int kSide = 10;
	for (int i = 0; i < kSide * kSide * kSide; ++i) {
		const double x = i % kSide, y = i / kSide % kSide, z = i / kSide / kSide;
		grains = joined(grains, box({x, y, z}, {x + 0.5, y + 0.5, z + 0.5}));
	}
	const SplitRun r = lawful(box({-1, -1, -1}, {kSide, kSide, kSide}), grains);
	ASSERT_EQ(r.blocks.size(), kSide * kSide * kSide + 1u);
	EXPECT_NEAR(volumes(r).back(), std::pow(kSide + 1, 3) - std::pow(kSide, 3) / 8, 1e-7);
}

TEST(Split, facesWithoutAreaAndFacesTwice) {
	Mesh cut = flatSheet(2, {-1, 2, -1, 2}, 0.25);
	// On the border, a face of three points on one line; inside, a face twice and turned.
	cut.points.push_back({-1, 0, 0.25});
	cut.triangles.push_back({0, 1, 9});
	cut.triangles.push_back(cut.triangles[3]);
	cut.triangles.push_back({cut.triangles[5][0], cut.triangles[5][2], cut.triangles[5][1]});
	const SplitRun r = splitOf(unitBox, cut);
	ASSERT_TRUE(r.status.ok()) << describe(r.status);
	expectVolumes(r, {0.25, 0.75});
	EXPECT_EQ(surfaceCount(r, kSecond), 2u);
	EXPECT_EQ(r.arrangement.duplicates.takenOnce[kSecond], 2u);
	double area = 0;
	for (const SubSurface& surface : r.split.surfaces.all) {
		area += surface.number[kSecond] >= 0 ? surface.area : 0;
	}
	EXPECT_NEAR(area, 9, 1e-12);
}

TEST(Split, anyScaleAndPlace) {
	for (const int exponent : {-1074, -1060, -600, 300, 1000}) {
		Mesh solid = unitBox, cut = flatSheet(1, {-1, 2, -1, 2}, 1);
		for (Mesh* mesh : {&solid, &cut}) {
			for (Point& p : mesh->points) {
				for (std::size_t k = 0; k < 3; ++k) {
					p[k] = std::ldexp(mesh == &solid ? 4 * p[k] : p[k] + (k < 2 ? 1 : 0) * p[k],
					                  exponent);
				}
			}
		}
		const SplitRun r = splitOf(solid, cut);
		ASSERT_TRUE(r.status.ok()) << describe(r.status);
		// Half-way round the box the sheet goes on beyond it, half-way it ends there.
		EXPECT_EQ(loops(r), (LoopNumbers{0, 0, 2})) << exponent;
		EXPECT_EQ(r.blocks.size(), 2u) << exponent;
	}
	std::mt19937 random(3);
	Mesh solid = placed(sphere(12, {0, 0, 0}, 1), random, 0);
	const auto wave = [](double x, double y) { return 0.2 * std::cos(5 * x) * std::sin(3 * y); };
	Mesh cut = sheet(15, 15, {-1.5, 1.5, -1.5, 1.5}, wave);
	for (const double offset : {0.0, 3e3, 3e4}) {
		for (Mesh* mesh : {&solid, &cut}) {
			for (Point& p : mesh->points) {
				p = {p[0] + offset, p[1] - 2 * offset, p[2] + 3 * offset};
			}
		}
		// In float these places have few different coordinates: many faces lose their area.
		Options options;
		options.outputScalar = OutputScalar::Float;
		const SplitRun r = splitOf(solid, cut, options);
		ASSERT_TRUE(r.status.ok()) << describe(r.status);
		EXPECT_EQ(r.blocks.size(), 2u);
		for (const SplitMesh& block : r.blocks) {
			EXPECT_TRUE(isClosed(block.triangles));
		}
		for (const SplitMesh* mesh : {&r.surfaces[0], &r.surfaces[1], &r.blocks[0], &r.blocks[1]}) {
			for (const auto& t : mesh->triangles) {
				EXPECT_FALSE(
				    hasZeroArea(mesh->points[t[0]], mesh->points[t[1]], mesh->points[t[2]]));
			}
		}
	}
}

// Triangles of few coordinates, that may intersect each other: refused or split, but never wrong in
// what is a matter of indices.
TEST(Split, soupsAreSplitOrRefused) {
	std::mt19937 random(13);
	std::uniform_int_distribution<int> coordinate(0, 5);
	std::size_t done = 0, refused = 0;
	for (int round = 0; round < 1500; ++round) {
		std::array<Mesh, 2> soups;
		for (Mesh& soup : soups) {
			for (int i = 0; i < 8; ++i) {
				soup.points.push_back({static_cast<double>(coordinate(random)),
				                       static_cast<double>(coordinate(random)),
				                       static_cast<double>(coordinate(random))});
			}
			for (int i = 0; i < 2 + round % 5; ++i) {
				soup.triangles.push_back({static_cast<std::uint32_t>(random() % 8),
				                          static_cast<std::uint32_t>(random() % 8),
				                          static_cast<std::uint32_t>(random() % 8)});
			}
		}
		const SplitRun r = splitOf(soups[0], soups[1]);
		if (r.status.ok()) {
			++done;
			for (const SplitMesh& block : r.blocks) {
				EXPECT_TRUE(isClosed(block.triangles));
			}
		} else {
			++refused;
			EXPECT_TRUE(r.status.code == StatusCode::SelfIntersecting ||
			            r.status.code == StatusCode::EmptyOperand)
			    << describe(r.status) << " in round " << round;
			EXPECT_TRUE(r.status.code == StatusCode::EmptyOperand || !r.status.faces.empty());
		}
	}
	EXPECT_GT(done, 300u);
	EXPECT_GT(refused, 50u);
}

// What must not depend on the input's numbering.

// The triangles of each piece in the order of ids, by coordinates.
std::vector<std::vector<std::array<Point, 3>>> geometryOf(const SplitRun& r, bool swapped) {
	std::vector<std::vector<std::array<Point, 3>>> all;
	const auto add = [&all](std::size_t piece, const SplitMesh& mesh, std::size_t face) {
		all.resize(std::max(all.size(), piece + 1));
		std::array<Point, 3> c{};
		for (std::size_t i = 0; i < 3; ++i) {
			c[i] = mesh.points[mesh.triangles[face][i]];
		}
		std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
		all[piece].push_back(c);
	};
	std::size_t first = 0;
	for (const OperandId k : {kFirst, kSecond}) {
		const OperandId operand = swapped ? otherOf(k) : k;
		const SplitMesh& mesh = r.surfaces[operand.value];
		for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
			const SubSurface& surface = at(r.split.surfaces.all, mesh.subSurface[f]);
			add(first + static_cast<std::size_t>(surface.number[operand]), mesh, f);
		}
		first += surfaceCount(r, operand);
	}
	for (std::size_t i = 0; i < r.blocks.size(); ++i) {
		for (std::size_t f = 0; f < r.blocks[i].triangles.size(); ++f) {
			add(first + i, r.blocks[i], f);
		}
	}
	for (auto& piece : all) {
		std::sort(piece.begin(), piece.end());
	}
	return all;
}

std::vector<Points> loopPoints(const SplitRun& r) {
	std::vector<Points> all;
	for (const Loop& loop : r.arrangement.loops) {
		all.emplace_back();
		for (const VertexId v : loop.points) {
			all.back().push_back(r.arrangement.coordinates(v));
		}
	}
	return all;
}

void expectInvariant(const Mesh& a, const Mesh& b, std::mt19937& random) {
	const SplitRun reference = lawful(a, b);
	const auto geometry = geometryOf(reference, false);
	const SplitRun other = lawful(permuted(a, random), permuted(b, random));
	EXPECT_EQ(geometryOf(other, false), geometry);
	EXPECT_EQ(other.split.blocks.beside, reference.split.blocks.beside);
	EXPECT_EQ(loopPoints(other), loopPoints(reference));
	const SplitRun swapped = lawful(b, a);
	EXPECT_EQ(geometryOf(swapped, true), geometry);
	EXPECT_EQ(loopPoints(swapped), loopPoints(reference));
	Options threads;
	threads.threads = 3;
	EXPECT_EQ(geometryOf(lawful(a, b, threads), false), geometry);
}

TEST(Split, idsAndGeometryDoNotDependOnNumbering) {
	std::mt19937 random(7);
	const auto wave = [](double x, double y) { return 0.1 * std::cos(5 * x) * std::sin(3 * y); };
	for (int round = 0; round < 4; ++round) {
		const Mesh a = placed(sphere(8, {0, 0, 0}, 1), random, 0.1);
		expectInvariant(a, placed(sheet(9, 9, {-1.5, 1.5, -1.5, 1.5}, wave), random, 0.2), random);
		expectInvariant(a, placed(torus(12, 8, 0.8, 0.3), random, 0.3), random);
	}
	expectInvariant(unitBox, flatSheet(4, {-1, 2, -1, 2}, 1), random);
	expectInvariant(unitBox, unitBox, random);
}

TEST(Split, flippedSheetGivesTheSameBlocks) {
	std::mt19937 random(5);
	const Mesh solid = placed(torus(16, 8, 1, 0.4), random, 0);
	const auto wave = [](double x, double y) { return 0.2 * std::cos(5 * x) * std::sin(3 * y); };
	const Mesh cut = sheet(9, 9, {-1.5, 1.5, -1.5, 1.5}, wave);
	Mesh patchwork = cut;  // no front at all
	for (std::size_t t = 0; t < patchwork.triangles.size(); t += 3) {
		std::swap(patchwork.triangles[t][1], patchwork.triangles[t][2]);
	}
	const SplitRun r = lawful(solid, cut);
	for (const Mesh& other : {turned(cut), patchwork}) {
		const SplitRun flipped = lawful(solid, other);
		ASSERT_EQ(flipped.blocks.size(), r.blocks.size());
		auto expected = geometryOf(r, false), found = geometryOf(flipped, false);
		const auto blocks = static_cast<std::ptrdiff_t>(r.blocks.size());
		EXPECT_TRUE(std::equal(expected.end() - blocks, expected.end(), found.end() - blocks));
	}
}

TEST(Split, facesKnowTheBlocksOnTheirOwnSides) {
	Mesh cut = flatSheet(5, {-1, 2, -1, 2}, 0.25);
	for (std::size_t t = 0; t < cut.triangles.size(); t += 3) {
		std::swap(cut.triangles[t][1], cut.triangles[t][2]);
	}
	const SplitRun r = lawful(unitBox, cut);
	ASSERT_EQ(r.blocks.size(), 2u);
	const int lower = r.split.blocks.all[0].volume < 0.5 ? 0 : 1;
	const SplitMesh& mesh = r.surfaces[1];
	std::size_t inside = 0;
	for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
		std::array<Point, 3> c{};
		for (std::size_t i = 0; i < 3; ++i) {
			c[i] = mesh.points[mesh.triangles[f][i]];
		}
		const bool isUp =
		    (c[1][0] - c[0][0]) * (c[2][1] - c[0][1]) > (c[1][1] - c[0][1]) * (c[2][0] - c[0][0]);
		const std::array<std::int32_t, 2> upAndDown{1 - lower, lower};
		if (mesh.beside[f][0] != kNoBlock) {
			++inside;
			EXPECT_EQ(mesh.beside[f][0], upAndDown[isUp ? 0 : 1]);
			EXPECT_EQ(mesh.beside[f][1], upAndDown[isUp ? 1 : 0]);
		}
	}
	EXPECT_GT(inside, 10u);
}

// Random squares on grids of two sizes: every kind of contact between open surfaces that are no
// manifolds. Blocks are counted by filling cells.

constexpr int kSpan = 6;

class Cells {
public:
	void addWall(const Square& square) { walls_.insert(square); }

	// The volumes of the parts that do not reach the outside, sorted.
	std::vector<double> boundedVolumes() const {
		std::set<std::array<int, 3>> seen;
		std::vector<double> all;
		for (int i = 0; i < (kSpan + 2) * (kSpan + 2) * (kSpan + 2); ++i) {
			const std::array<int, 3> cell{i % (kSpan + 2) - 1, i / (kSpan + 2) % (kSpan + 2) - 1,
			                              i / (kSpan + 2) / (kSpan + 2) - 1};
			if (seen.count(cell) == 0) {
				const auto [volume, bounded] = fill(cell, seen);
				if (bounded) {
					all.push_back(volume);
				}
			}
		}
		std::sort(all.begin(), all.end());
		return all;
	}

private:
	std::pair<double, bool> fill(std::array<int, 3> start,
	                             std::set<std::array<int, 3>>& seen) const {
		std::vector<std::array<int, 3>> reached{start};
		seen.insert(start);
		double volume = 0;
		bool bounded = true;
		while (!reached.empty()) {
			const std::array<int, 3> cell = reached.back();
			reached.pop_back();
			++volume;
			for (std::size_t k = 0; k < 6; ++k) {
				std::array<int, 3> next = cell;
				next[k / 2] += k % 2 == 0 ? 1 : -1;
				const bool isOutside = next[k / 2] < -1 || next[k / 2] > kSpan;
				bounded = bounded && !isOutside;
				const Square wall{k % 2 == 0 ? next : cell, k / 2};
				if (!isOutside && walls_.count(wall) == 0 && seen.insert(next).second) {
					reached.push_back(next);
				}
			}
		}
		return {volume, bounded};
	}

	std::set<Square> walls_;
};

Mesh randomSquares(int side, double share, std::mt19937& random, Cells& cells) {
	std::bernoulli_distribution present(share), flip(0.5);
	std::vector<std::pair<Square, bool>> squares;
	const int count = kSpan / side;
	for (std::size_t axis = 0; axis < 3; ++axis) {
		for (int i = 0; i < (count + 1) * (count + 1) * (count + 1); ++i) {
			const Square square{
			    {i % (count + 1), i / (count + 1) % (count + 1), i / (count + 1) / (count + 1)},
			    axis};
			const bool fits =
			    square.corner[(axis + 1) % 3] < count && square.corner[(axis + 2) % 3] < count;
			if (!fits || !present(random)) {
				continue;
			}
			squares.push_back({square, flip(random)});
			for (int j = 0; j < side * side; ++j) {
				Square unit{
				    {square.corner[0] * side, square.corner[1] * side, square.corner[2] * side},
				    axis};
				unit.corner[(axis + 1) % 3] += j % side;
				unit.corner[(axis + 2) % 3] += j / side;
				cells.addWall(unit);
			}
		}
	}
	return meshOf(squares, side, random);
}

TEST(Split, randomSquaresMakeTheCountedBlocks) {
	std::mt19937 random(11);
	std::size_t blocks = 0;
	for (int round = 0; round < 60; ++round) {
		Cells cells;
		const int side = round % 3 + 1;
		const Mesh a = randomSquares(1, 0.3 + 0.1 * (round % 5), random, cells);
		const Mesh b = randomSquares(side, 0.5, random, cells);
		const SplitRun r = lawful(a, b);
		expectVolumes(r, cells.boundedVolumes());
		blocks += r.blocks.size();
		if (HasFailure()) {
			FAIL() << "round " << round;
		}
	}
	EXPECT_GT(blocks, 100u);
}

TEST(Split, idsDoNotDependOnNumberingWhereCoordinatesTie) {
	std::mt19937 random(17);
	for (int round = 0; round < 3; ++round) {
		Cells cells;
		const Mesh a = randomSquares(1, 0.5, random, cells);
		expectInvariant(a, randomSquares(2, 0.7, random, cells), random);
	}
	// Two solids on both sides of the smallest face of all.
	Mesh upper, lower;
	upper.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {2, 0, 1}};
	upper.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
	lower = turned(upper);
	lower.points[3][2] = -1;
	expectInvariant(upper, lower, random);
	// A sheet whose faces are turned at random.
	Mesh patchwork = flatSheet(6, {-1, 2, -1, 2}, 0.25);
	for (auto& t : patchwork.triangles) {
		if (random() % 2 == 0) {
			std::swap(t[1], t[2]);
		}
	}
	expectInvariant(unitBox, patchwork, random);
}

}  // namespace
}  // namespace index_boolean
