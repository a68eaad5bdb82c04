// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Closed operands as people should not make them: solids in one layer that overlap, vertices that
// were pulled through the surface, so that faces fold, lie in each other or have no area, parts
// that are there twice or in both directions, vertices that hang on edges, walls that enclose
// nothing. Their winding numbers at random points, by rays through the input in integers, must be
// those of a cell, and tell on which side of each block a point lies. 100 inputs, or as many as
// INDEXBOOLEAN_FUZZ_PAIRS says; input n is made from the seed n.
#include "core/any_operands.h"
#include "support/asked_inputs.h"
#include "support/grid_polyhedra.h"
#include "support/grid_properties.h"

#include <gtest/gtest.h>

#include <optional>
#include <set>

namespace index_boolean {
namespace {

using grid::GridMesh;
using grid::IntPoint;
using shapes::CellsRun;
using shapes::Mesh;
using shapes::Windings;

// Coordinates of all inputs are multiples of it: an edge can be halved twice.
constexpr std::int64_t kUnit = 4;
// Points to look at have coordinates in parts of it: they are hardly ever level with a face's edge.
constexpr std::int64_t kParts = 1009;

// --- operands -----------------------------------------------------------------------------------

// Moves a vertex anywhere: what is closed stays closed.
void pullVertex(GridMesh& m, std::int64_t span, grid::Random& random) {
	const IntPoint p = random.point(span);
	m.points[random.index(m.points.size())] = {kUnit * p[0], kUnit * p[1], kUnit * p[2]};
}

// Adds a copy of all faces, some of them moved, or all of them turned.
void addCopy(GridMesh& m, std::int64_t span, grid::Random& random) {
	GridMesh copy = random.oneIn(2) ? grid::turned(m) : m;
	for (std::int64_t moved = random.below(3); moved > 0; --moved) {
		pullVertex(copy, span, random);
	}
	m = grid::concatenated(m, copy);
}

// Adds a triangle in both directions, on corners that are there, one of them perhaps anywhere.
void addWall(GridMesh& m, std::int64_t span, grid::Random& random) {
	grid::Corners wall{};
	for (std::uint32_t& corner : wall) {
		corner = static_cast<std::uint32_t>(random.index(m.points.size()));
	}
	if (random.oneIn(2)) {
		const IntPoint p = random.point(span);
		wall[0] = static_cast<std::uint32_t>(m.points.size());
		m.points.push_back({kUnit * p[0], kUnit * p[1], kUnit * p[2]});
	}
	m.triangles.push_back(wall);
	m.triangles.push_back({wall[0], wall[2], wall[1]});
}

// Halves a face at the middle of an edge; the face beyond the edge stays whole.
void hangVertex(GridMesh& m, grid::Random& random) {
	const std::size_t face = random.index(m.triangles.size()), i = random.index(3);
	const auto [a, b, c] = std::array<std::uint32_t, 3>{
	    m.triangles[face][i], m.triangles[face][(i + 1) % 3], m.triangles[face][(i + 2) % 3]};
	const IntPoint sum = grid::operator+(m.points[a], m.points[b]);
	if (sum[0] % 2 != 0 || sum[1] % 2 != 0 || sum[2] % 2 != 0) {
		return;
	}
	const auto middle = static_cast<std::uint32_t>(m.points.size());
	m.points.push_back({sum[0] / 2, sum[1] / 2, sum[2] / 2});
	m.triangles[face] = {a, middle, c};
	m.triangles.push_back({middle, b, c});
}

GridMesh scaled(GridMesh m) {
	for (IntPoint& p : m.points) {
		p = {kUnit * p[0], kUnit * p[1], kUnit * p[2]};
	}
	return m;
}

GridMesh randomOperand(grid::Generator& generator, std::int64_t span) {
	grid::Random& random = generator.random();
	GridMesh m;
	for (std::int64_t parts = 1 + random.below(2); parts > 0; --parts) {
		m = grid::concatenated(m, scaled(generator.solid()));
	}
	for (std::int64_t edits = random.below(4); edits > 0 && m.triangles.size() < 120; --edits) {
		switch (random.below(4)) {
		case 0:
			addCopy(m, span, random);
			break;
		case 1:
			addWall(m, span, random);
			break;
		default:
			pullVertex(m, span, random);
			break;
		}
	}
	for (std::int64_t hanging = random.below(4); hanging > 0; --hanging) {
		hangVertex(m, random);  // what hangs must not be moved any more
	}
	if (random.oneIn(6)) {
		m = grid::concatenated(m, random.oneIn(2) ? grid::turned(m) : m);
	}
	return m;
}

// Else nothing may be left of it once faces without area are gone.
bool isSpatial(const GridMesh& m) {
	for (std::size_t f = 0; f < m.triangles.size(); ++f) {
		for (std::size_t g = 0; g < f; ++g) {
			for (std::size_t i = 0; i < 3; ++i) {
				if (grid::sideOf(m.corner(f, 0), m.corner(f, 1), m.corner(f, 2), m.corner(g, i)) !=
				    0) {
					return true;
				}
			}
		}
	}
	return false;
}

struct Input {
	std::vector<GridMesh> operands;
	std::int64_t span;

	explicit Input(std::uint32_t seed) {
		constexpr std::array<std::int64_t, 4> kSpans{2, 3, 4, 6};
		span = kSpans[seed % kSpans.size()];
		grid::Generator generator(grid::Random(seed), span);
		operands.resize(1 + generator.random().index(3));
		for (GridMesh& m : operands) {
			do {
				m = randomOperand(generator, span);
			} while (!isSpatial(m));
		}
	}

	std::vector<Mesh> meshes() const {
		std::vector<Mesh> all;
		for (const GridMesh& m : operands) {
			all.push_back(grid::meshOf(m));
		}
		return all;
	}
	std::string text() const {
		std::string s;
		for (const GridMesh& m : operands) {
			s += "\nlayer: " + grid::text(m);
		}
		return s;
	}
};

// --- rays through the input ---------------------------------------------------------------------

// How a ray upwards from p passes a triangle: 1 or -1 if it leaves or enters, 0 if it misses it; no
// value where p is level with an edge, or lies in the plane.
std::optional<int> passing(const std::array<IntPoint, 3>& t, const IntPoint& p) {
	std::array<int, 3> turns{};
	for (std::size_t i = 0; i < 3; ++i) {
		turns[i] = grid::signOf(grid::turnOf(t[i], t[(i + 1) % 3], p));
		if (turns[i] == 0) {
			return std::nullopt;
		}
	}
	if (turns[0] != turns[1] || turns[1] != turns[2]) {
		return 0;
	}
	const int side = grid::sideOf(t[0], t[1], t[2], p);
	if (side == 0) {
		return std::nullopt;
	}
	return side == -turns[0] ? turns[0] : 0;
}

// \param p in parts of a unit
std::optional<int> windingAt(const GridMesh& m, const IntPoint& p) {
	int sum = 0;
	for (std::size_t f = 0; f < m.triangles.size(); ++f) {
		std::array<IntPoint, 3> t{};
		for (std::size_t i = 0; i < 3; ++i) {
			const IntPoint& corner = m.corner(f, i);
			t[i] = {kParts * corner[0], kParts * corner[1], kParts * corner[2]};
		}
		if (grid::normal(t[0], t[1], t[2])[2] == 0) {
			continue;  // seen from its side
		}
		const std::optional<int> passed = passing(t, p);
		if (!passed) {
			return passed;
		}
		sum += *passed;
	}
	return sum;
}

struct Sample {
	Point place;
	std::vector<std::int32_t> windings;
};

std::vector<Sample> samplesOf(const Input& input, grid::Random& random) {
	constexpr int kSamples = 24;
	std::vector<Sample> all;
	for (int n = 0; n < kSamples; ++n) {
		const IntPoint p = random.point(input.span * kUnit * kParts);
		Sample sample;
		for (std::size_t k = 0; k < 3; ++k) {
			sample.place[k] = static_cast<double>(p[k]) / static_cast<double>(kParts);
		}
		for (const GridMesh& m : input.operands) {
			if (const std::optional<int> winding = windingAt(m, p)) {
				sample.windings.push_back(*winding);
			}
		}
		if (sample.windings.size() == input.operands.size()) {
			all.push_back(sample);
		}
	}
	return all;
}

// --- what a block encloses ----------------------------------------------------------------------

Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Point cross(const Point& a, const Point& b) {
	return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// The winding number of a block's surface around a point off it: solid angles (Van Oosterom and
// Strackee 1983) over that of the sphere.
double windingAround(const Block& block, const Point& p) {
	double sum = 0;
	for (const IndexTriangle& t : block.triangles) {
		const Point a = minus(block.points[t[0]], p), b = minus(block.points[t[1]], p),
		            c = minus(block.points[t[2]], p);
		const double la = std::sqrt(dot(a, a)), lb = std::sqrt(dot(b, b)),
		             lc = std::sqrt(dot(c, c));
		sum += 2 * std::atan2(dot(a, cross(b, c)),
		                      la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
	}
	return sum / (4 * 3.14159265358979323846);
}

std::vector<std::int32_t> vectorOf(const Windings& w) { return {w.begin(), w.end()}; }

// \param isInside of winding numbers
template <class IsInside>
void expectToEnclose(const Block& block, const std::vector<Sample>& samples, IsInside&& isInside) {
	EXPECT_EQ(brokenPromise(block), "");
	for (const Sample& sample : samples) {
		EXPECT_NEAR(windingAround(block, sample.place), isInside(sample.windings) ? 1 : 0, 1e-6)
		    << "at " << testing::PrintToString(sample.place) << ", where windings are "
		    << testing::PrintToString(sample.windings);
	}
}

// An operand that is inside out wherever it is anything has been turned.
std::vector<Sample> asTurned(std::vector<Sample> samples, const Arrangement& arrangement) {
	for (Sample& sample : samples) {
		for (std::size_t k = 0; k < sample.windings.size(); ++k) {
			if (arrangement.insideOut[makeId<OperandTag>(k)]) {
				EXPECT_LE(sample.windings[k], 0);
				sample.windings[k] *= -1;
			}
		}
	}
	return samples;
}

// A run, or none if it is refused since an operand has no face that encloses anything: what cancels
// once faces without area are gone.
std::optional<CellsRun> runOf(const Input& input, const std::vector<Sample>& samples,
                              const Options& options) {
	CellsRun r;
	Monitor monitor;
	const std::vector<Mesh> meshes = input.meshes();
	std::vector<SurfaceView> views;
	for (const Mesh& m : meshes) {
		views.push_back(viewOf(m.points, m.triangles));
	}
	MeshArrays arrays;
	EXPECT_TRUE(joinSurfaces(views, 1, monitor, arrays).ok());
	r.status = arrangeCells(std::move(arrays), options, monitor, r.arrangement);
	if (r.status.code == StatusCode::EmptyOperand) {
		for (const Sample& sample : samples) {
			EXPECT_EQ(sample.windings[static_cast<std::size_t>(r.status.operand)], 0);
		}
		return std::nullopt;
	}
	EXPECT_TRUE(r.status.ok()) << statusName(r.status.code) << ": " << describe(r.status);
	return r;
}

// \param check of an input's run and samples
template <class Check>
void forEachRun(const Options& options, Check&& check) {
	for (std::uint32_t seed = 0; seed < askedInputs(100) && !testing::Test::HasFailure(); ++seed) {
		const Input input(seed);
		SCOPED_TRACE("seed " + std::to_string(seed) + input.text());
		grid::Random random(seed);
		const std::vector<Sample> samples = samplesOf(input, random);
		const std::optional<CellsRun> r = runOf(input, samples, options);
		if (r && r->status.ok()) {
			check(*r, samples);
		}
	}
}

TEST(RandomChains, cellsHaveTheWindingsOfRaysThroughTheInput) {
	forEachRun(shapes::asCut(), [](const CellsRun& r, const std::vector<Sample>& samples) {
		for (const bool isClosed : r.arrangement.closed) {
			EXPECT_TRUE(isClosed);
		}
		const std::vector<std::int32_t> nowhere(r.arrangement.closed.size(), 0);
		const std::vector<Sample> expected = asTurned(samples, r.arrangement);
		std::set<std::vector<std::int32_t>> seen;
		for (const Sample& sample : expected) {
			if (sample.windings != nowhere && seen.insert(sample.windings).second) {
				const auto is = [&sample](const std::vector<std::int32_t>& w) {
					return w == sample.windings;
				};
				const Block block =
				    shapes::blockOf(r, [&is](const Windings& w) { return is(vectorOf(w)); });
				expectToEnclose(block, expected, is);
			}
		}
	});
}

TEST(RandomChains, finishedBlocksEncloseWhatTheirWindingsSay) {
	forEachRun(shapes::onOneThread(), [](const CellsRun& r, const std::vector<Sample>& samples) {
		for (const CellPredicate& isInside :
		     {CellPredicate(shapes::inAny), CellPredicate(shapes::inOddNumber),
		      CellPredicate(shapes::oddWinding)}) {
			const Block block = shapes::blockOf(r, isInside);
			EXPECT_TRUE(shapes::isManifold(block.triangles));
			expectToEnclose(block, samples, [&](const std::vector<std::int32_t>& w) {
				Windings windings(w.size());
				std::copy(w.begin(), w.end(), windings.begin());
				return isInside(windings);
			});
		}
	});
}

}  // namespace
}  // namespace index_boolean
