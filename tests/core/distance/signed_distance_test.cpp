// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Signed distances against closed forms, against all faces one after another in long double, and
// against signs that are counted in integers or on a grid of cells. All seeds are fixed.
#include "core/shapes.h"

#include <vcg_ext/exact/zero_area.h>
#include <vcg_ext/index_boolean.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <gtest/gtest.h>

namespace index_boolean {
namespace {

using namespace shapes;

using Integer = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<
    2048, 2048, boost::multiprecision::signed_magnitude, boost::multiprecision::unchecked>>;
using ExactVector = std::array<Integer, 3>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

MeshArrays arraysOf(const Mesh& m) {
	MeshArrays out;
	Monitor monitor;
	EXPECT_TRUE(joinSurfaces({viewOf(m.points, m.triangles)}, 1, monitor, out).ok());
	return out;
}

Options optionsOf(SelfIntersections selfIntersections, WindingRule rule = WindingRule::Nonzero) {
	Options options;
	options.selfIntersections = selfIntersections;
	options.windingRule = rule;
	return options;
}

constexpr SelfIntersections kResolve = SelfIntersections::Resolve,
                            kTrust = SelfIntersections::Trust;

Status make(const Mesh& m, const Options& options, SignedDistance& out, bool isSigned = true) {
	Monitor monitor;
	Reference reference;
	return inOrder(
	    [&] { return prepareReference(arraysOf(m), options, isSigned, monitor, reference); },
	    [&] { return out.build(std::move(reference), options.threads, monitor); });
}

SignedDistance made(const Mesh& m, const Options& options = optionsOf(kResolve)) {
	SignedDistance distance;
	const Status status = make(m, options, distance);
	EXPECT_TRUE(status.ok()) << statusName(status.code);
	return distance;
}

std::vector<DistanceSample> sampled(const SignedDistance& distance,
                                    const std::vector<Point>& points,
                                    const DistanceOptions& options = {}, int threads = 0) {
	std::vector<DistanceSample> samples(points.size());
	Monitor monitor;
	EXPECT_TRUE(
	    distance.sample({points.data(), points.size(), samples.data()}, options, threads, monitor)
	        .ok());
	return samples;
}

Point randomIn(std::mt19937& random, double low, double high) {
	std::uniform_real_distribution<double> uniform(low, high);
	const double x = uniform(random), y = uniform(random), z = uniform(random);
	return {x, y, z};
}

// --- oracles -------------------------------------------------------------------------------------

using Long = std::array<long double, 3>;

Long longOf(const Point& p) { return {p[0], p[1], p[2]}; }
Long operator-(const Long& a, const Long& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
long double dotOf(const Long& a, const Long& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Long crossOf(const Long& a, const Long& b) {
	return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

long double toSegment(const Long& p, const Long& a, const Long& b) {
	const Long ab = b - a, ap = p - a;
	const long double t = std::clamp(dotOf(ap, ab) / dotOf(ab, ab), 0.0L, 1.0L);
	const Long r{ap[0] - t * ab[0], ap[1] - t * ab[1], ap[2] - t * ab[2]};
	return std::sqrt(dotOf(r, r));
}

long double toTriangle(const Long& p, const Long& a, const Long& b, const Long& c) {
	const Long n = crossOf(b - a, c - a);
	long double least = std::min({toSegment(p, a, b), toSegment(p, b, c), toSegment(p, c, a)});
	if (dotOf(n, crossOf(b - a, p - a)) >= 0 && dotOf(n, crossOf(c - b, p - b)) >= 0 &&
	    dotOf(n, crossOf(a - c, p - c)) >= 0) {
		least = std::min(least, std::fabs(dotOf(n, p - a)) / std::sqrt(dotOf(n, n)));
	}
	return least;
}

double bruteForce(const Mesh& m, const Point& p) {
	long double least = std::numeric_limits<long double>::infinity();
	for (const auto& t : m.triangles) {
		least = std::min(least, toTriangle(longOf(p), longOf(m.points[t[0]]),
		                                   longOf(m.points[t[1]]), longOf(m.points[t[2]])));
	}
	return static_cast<double>(least);
}

// Coordinates times 2^300, which are integers here.
ExactVector exact(const Point& p) {
	ExactVector v;
	for (std::size_t k = 0; k < 3; ++k) {
		int exponent = 0;
		const double mantissa = std::ldexp(std::frexp(p[k], &exponent), 53);
		v[k] = static_cast<long long>(mantissa);
		EXPECT_GE(exponent, -247);
		v[k] <<= std::max(exponent + 247, 0);
	}
	return v;
}
ExactVector operator-(const ExactVector& a, const ExactVector& b) {
	return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
int volumeSign(const ExactVector& a, const ExactVector& b, const ExactVector& c) {
	const Integer v = a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
	                  a[2] * (b[0] * c[1] - b[1] * c[0]);
	return v.sign();
}

// How often a surface winds around a point off it, by a ray of integers; directions that
// pass an edge are not taken.
int exactWinding(const Mesh& m, const Point& point) {
	static const std::array<ExactVector, 3> directions{
	    {{1009, 2741, 7919}, {-5003, 613, 101}, {13, -8111, 3001}}};
	const ExactVector p = exact(point);
	for (const ExactVector& direction : directions) {
		int winding = 0;
		bool isGood = true;
		for (const auto& t : m.triangles) {
			const ExactVector a = exact(m.points[t[0]]) - p, b = exact(m.points[t[1]]) - p,
			                  c = exact(m.points[t[2]]) - p;
			const int x = volumeSign(a, b, direction), y = volumeSign(b, c, direction),
			          z = volumeSign(c, a, direction);
			if ((x > 0 || y > 0 || z > 0) && (x < 0 || y < 0 || z < 0)) {
				continue;
			}
			isGood = isGood && x != 0 && y != 0 && z != 0;
			winding += volumeSign(a, b, c) == x ? x : 0;
		}
		if (isGood) {
			return winding;
		}
	}
	ADD_FAILURE() << "no direction";
	return 0;
}

// The distance from the box [low, high], negative inside.
double toBox(const Point& p, const Point& low, const Point& high) {
	double squared = 0, inner = -kInfinity;
	for (std::size_t k = 0; k < 3; ++k) {
		const double out = std::max(low[k] - p[k], p[k] - high[k]);
		squared += out > 0 ? out * out : 0;
		inner = std::max(inner, out);
	}
	return inner > 0 ? std::sqrt(squared) : inner;
}

// What must hold of any sample.
void expectConsistent(const SignedDistance& distance, const Point& p, const DistanceSample& s) {
	const double bound = distance.errorBound(s.distance);
	const auto length =
	    static_cast<double>(std::sqrt(dotOf(longOf(s.gradient), longOf(s.gradient))));
	EXPECT_NEAR(length, 1, 1e-14);
	const Long between = longOf(p) - longOf(s.closest);
	EXPECT_NEAR(std::sqrt(static_cast<double>(dotOf(between, between))), std::fabs(s.distance),
	            8 * bound);
	EXPECT_EQ(s.sign, s.distance > 0 ? 1 : s.distance < 0 ? -1 : 0);
	if (std::fabs(s.distance) > 1e-6) {
		const double along = static_cast<double>(dotOf(longOf(s.gradient), between));
		EXPECT_NEAR(along, s.distance, 1e-9);
	}
}

// --- closed forms --------------------------------------------------------------------------------

TEST(SignedDistance, ofABox) {
	const Point low{-1, -2, 0.5}, high{3, 1, 2};
	const SignedDistance distance = made(box(low, high));
	EXPECT_TRUE(distance.reference().isClosed);
	EXPECT_FALSE(distance.reference().isResolved);
	std::mt19937 random(1);
	std::vector<Point> points;
	for (int i = 0; i < 20'000; ++i) {
		points.push_back(randomIn(random, -4, 5));
	}
	const auto samples = sampled(distance, points);
	for (std::size_t i = 0; i < points.size(); ++i) {
		const double truth = toBox(points[i], low, high);
		ASSERT_NEAR(samples[i].distance, truth, distance.errorBound(truth));
		expectConsistent(distance, points[i], samples[i]);
	}
}

TEST(SignedDistance, outsideATetrahedronNearEachEdgeAndVertex) {
	Mesh m;
	m.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.1, 0.05}};  // sharp and flat at once
	m.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
	const SignedDistance distance = made(m);
	std::mt19937 random(2);
	std::vector<Point> points;
	for (const Point& corner : m.points) {
		for (const Point& other : m.points) {
			for (int i = 0; i < 200; ++i) {
				const double size = std::ldexp(1.0, -static_cast<int>(random() % 50));
				const Point offset = randomIn(random, -size, size);
				const double t = corner == other ? 0 : randomIn(random, 0, 1)[0];
				Point p;
				for (std::size_t k = 0; k < 3; ++k) {
					p[k] = corner[k] * (1 - t) + other[k] * t + offset[k];
				}
				points.push_back(p);
			}
		}
	}
	int inside = 0;
	const auto samples = sampled(distance, points);
	for (std::size_t i = 0; i < points.size(); ++i) {
		const DistanceSample& s = samples[i];
		ASSERT_NEAR(std::fabs(s.distance), bruteForce(m, points[i]),
		            distance.errorBound(s.distance));
		if (s.sign != 0) {
			ASSERT_EQ(s.sign < 0, exactWinding(m, points[i]) != 0);
		}
		inside += s.sign < 0 ? 1 : 0;
	}
	EXPECT_GT(inside, 100);
}

TEST(SignedDistance, betweenTheSidesOfAThinWall) {
	const double thickness = 0x1p-40;
	const Point low{0, 0, 0}, high{1, 1, thickness};
	const SignedDistance distance = made(box(low, high));
	for (int step = -8; step <= 16; ++step) {
		for (const double x : {0.0, 0.25, 0.3, 1.0}) {
			const Point p{x, 0.5, thickness * step / 8};
			const DistanceSample s = distance.at(p, {});
			const double truth = toBox(p, low, high);
			ASSERT_EQ(s.sign, truth > 0 ? 1 : truth < 0 ? -1 : 0) << step << " " << x;
			ASSERT_NEAR(s.distance, truth, 1e-16);
		}
	}
}

TEST(SignedDistance, ofATorusIsNearlyThatOfTheSmoothOne) {
	const std::uint32_t n = 200;
	const SignedDistance distance = made(torus(n, n, 2, 1));
	const double chord = 3 * (1 - std::cos(kPi / n)) * 2;
	std::mt19937 random(3);
	for (int i = 0; i < 2000; ++i) {
		const Point p = randomIn(random, -4, 4);
		const double around = std::hypot(p[0], p[1]) - 2;
		const double truth = std::hypot(around, p[2]) - 1;
		ASSERT_NEAR(distance.at(p, {}).distance, truth, chord);
	}
}

// --- against all faces ---------------------------------------------------------------------------

// Needles, caps and faces of all sizes.
Mesh anyFaces(std::mt19937& random, std::size_t count) {
	Mesh m;
	while (m.triangles.size() < count) {
		const Point a = randomIn(random, -1, 1);
		const double size = std::ldexp(1.0, -static_cast<int>(random() % 20));
		const double thin = std::ldexp(1.0, -static_cast<int>(random() % 40));
		const Point along = randomIn(random, -size, size), across = randomIn(random, -size, size);
		const double t = random() % 2 == 0 ? 1 : 0.4;
		Point b, c;
		for (std::size_t k = 0; k < 3; ++k) {
			b[k] = a[k] + along[k];
			c[k] = a[k] + along[k] * t + across[k] * thin;
		}
		if (hasZeroArea(a, b, c)) {
			continue;  // it would not count
		}
		const auto first = static_cast<std::uint32_t>(m.points.size());
		m.points.insert(m.points.end(), {a, b, c});
		m.triangles.push_back({first, first + 1, first + 2});
	}
	return m;
}

TEST(SignedDistance, isThatOfTheNearestOfAnyFaces) {
	for (unsigned seed = 0; seed < 20; ++seed) {
		std::mt19937 random(seed);
		const Mesh m = anyFaces(random, 300);
		SignedDistance distance;
		ASSERT_TRUE(make(m, optionsOf(kTrust), distance, false).ok());
		std::vector<Point> points;
		for (int i = 0; i < 200; ++i) {
			points.push_back(randomIn(random, -1.5, 1.5));
			Point near = m.points[random() % m.points.size()];
			const Point offset = randomIn(random, -1e-3, 1e-3);
			for (std::size_t k = 0; k < 3; ++k) {
				near[k] += offset[k];
			}
			points.push_back(near);
		}
		const auto samples = sampled(distance, points);
		for (std::size_t i = 0; i < points.size(); ++i) {
			const double truth = bruteForce(m, points[i]);
			// The oracle's own planes are wrong by 2^-63 times how thin a face is.
			ASSERT_NEAR(samples[i].distance, truth, distance.errorBound(truth) + 1e-13)
			    << seed << " " << i;
			const auto& t = m.triangles[samples[i].face];
			ASSERT_NEAR(
			    static_cast<double>(toTriangle(longOf(points[i]), longOf(m.points[t[0]]),
			                                   longOf(m.points[t[1]]), longOf(m.points[t[2]]))),
			    truth, distance.errorBound(truth) + 1e-13);
		}
	}
}

// --- signs ---------------------------------------------------------------------------------------

TEST(SignedDistance, signsWithinATrillionthOfTheSurfaceAreExact) {
	std::mt19937 random(4);
	const Mesh m = placed(sphere(8, {0, 0, 0}, 1), random, 3);
	const SignedDistance distance = made(m);
	std::vector<Point> points;
	for (int i = 0; i < 3000; ++i) {
		const auto& t = m.triangles[random() % m.triangles.size()];
		Point w = randomIn(random, 0, 1);
		const double sum = w[0] + w[1] + w[2];
		if (i % 3 == 1) {
			w = {w[0], sum - w[0], 0};  // on an edge
		}
		const Point offset = randomIn(random, -1e-12, 1e-12);
		Point p;
		for (std::size_t k = 0; k < 3; ++k) {
			p[k] =
			    (w[0] * m.points[t[0]][k] + w[1] * m.points[t[1]][k] + w[2] * m.points[t[2]][k]) /
			        sum +
			    (i % 3 == 2 ? 0 : offset[k]);
		}
		points.push_back(p);
	}
	const auto samples = sampled(distance, points);
	int inside = 0, on = 0;
	for (std::size_t i = 0; i < points.size(); ++i) {
		if (samples[i].sign == 0) {
			++on;
			bool lies = false;
			for (const auto& t : m.triangles) {
				const ExactVector p = exact(points[i]);
				lies = lies || volumeSign(exact(m.points[t[0]]) - p, exact(m.points[t[1]]) - p,
				                          exact(m.points[t[2]]) - p) == 0;
			}
			ASSERT_TRUE(lies);
			continue;
		}
		ASSERT_NE(samples[i].distance, 0);
		ASSERT_EQ(samples[i].sign < 0, exactWinding(m, points[i]) != 0) << i;
		inside += samples[i].sign < 0 ? 1 : 0;
	}
	EXPECT_GT(inside, 1000);
	EXPECT_LT(on, 500);
}

constexpr int kSpan = 6;

// The winding number of each unit cell of [-1, kSpan + 1)^3.
struct Cells {
	std::array<int, (kSpan + 2) * (kSpan + 2) * (kSpan + 2)> winding{};

	int& at(int x, int y, int z) {
		return winding[static_cast<std::size_t>(((x + 1) * (kSpan + 2) + y + 1) * (kSpan + 2) + z +
		                                        1)];
	}
};

bool ruleSays(WindingRule rule, int w) {
	switch (rule) {
	case WindingRule::Nonzero:
		return w != 0;
	case WindingRule::Positive:
		return w > 0;
	case WindingRule::Odd:
		return w % 2 != 0;
	}
	return false;
}

// Boxes on a grid that overlap, touch, lie in each other and coincide, some inside out: their cells
// say what is inside, on it and how far away its boundary is.
TEST(SignedDistance, ofBoxesThatMeetIsThatOfTheCellsTheRuleSays) {
	std::array<int, 3> seen{};
	for (unsigned seed = 0; seed < 60; ++seed) {
		std::mt19937 random(seed);
		Mesh m;
		Cells cells;
		const int count = 2 + static_cast<int>(random() % 3);
		for (int i = 0; i < count; ++i) {
			const Mesh one = gridBox(random, 3);
			const bool isTurned = i > 0 && random() % 4 == 0;
			m = joined(m, isTurned ? turned(one) : one);
			const Point low = one.points[0], high = one.points[7];
			for (int x = 0; x < kSpan; ++x) {
				for (int y = 0; y < kSpan; ++y) {
					for (int z = 0; z < kSpan; ++z) {
						const bool in = toBox({x + 0.5, y + 0.5, z + 0.5}, low, high) < 0;
						cells.at(x, y, z) += in ? (isTurned ? -1 : 1) : 0;
					}
				}
			}
		}
		const WindingRule rule = static_cast<WindingRule>(seed % 3);
		const bool anyPositive =
		    std::any_of(cells.winding.begin(), cells.winding.end(), [](int w) { return w > 0; });
		SignedDistance distance;
		const Status status = make(m, optionsOf(kResolve, rule), distance);
		const bool isEmpty = std::none_of(cells.winding.begin(), cells.winding.end(),
		                                  [rule](int w) { return ruleSays(rule, w); });
		if (isEmpty || !anyPositive) {
			continue;
		}
		ASSERT_TRUE(status.ok()) << seed << " " << statusName(status.code);
		std::vector<Point> points;
		for (int i = 0; i < 400; ++i) {
			const Point p = randomIn(random, -0.5, kSpan + 0.5);
			const double step = i % 2 == 0 ? 1 : 4;
			points.push_back({std::round(p[0] * step) / step, std::round(p[1] * step) / step,
			                  std::round(p[2] * step) / step});
		}
		const auto samples = sampled(distance, points);
		for (std::size_t i = 0; i < points.size(); ++i) {
			const Point& p = points[i];
			int inside = 0;
			for (int corner = 0; corner < 8; ++corner) {
				const auto cell = [&](std::size_t k) {
					const double floor = std::floor(p[k]);
					return static_cast<int>(floor) - (floor == p[k] && (corner >> k & 1) != 0);
				};
				const auto w = [&](int x, int y, int z) {
					const bool isIn = std::min({x, y, z}) >= -1 && std::max({x, y, z}) <= kSpan;
					return isIn ? cells.at(x, y, z) : 0;
				};
				inside += ruleSays(rule, w(cell(0), cell(1), cell(2))) ? 1 : 0;
			}
			const int sign = inside == 8 ? -1 : inside == 0 ? 1 : 0;
			ASSERT_EQ(samples[i].sign, sign) << seed << " " << i;
			++seen[static_cast<std::size_t>(sign + 1)];
			double truth = kInfinity;  // from a cell of the other kind
			for (int x = -1; x <= kSpan; ++x) {
				for (int y = -1; y <= kSpan; ++y) {
					for (int z = -1; z <= kSpan; ++z) {
						if (ruleSays(rule, cells.at(x, y, z)) != (sign < 0)) {
							const Point low{1.0 * x, 1.0 * y, 1.0 * z};
							truth = std::min(
							    truth,
							    std::max(0.0, toBox(p, low, {low[0] + 1, low[1] + 1, low[2] + 1})));
						}
					}
				}
			}
			if (sign != 0) {
				ASSERT_NEAR(std::fabs(samples[i].distance), truth, distance.errorBound(truth))
				    << seed << " " << i;
			}
		}
	}
	EXPECT_GT(*std::min_element(seen.begin(), seen.end()), 300);
}

TEST(SignedDistance, trustedFacesAreTakenAsGiven) {
	const Mesh m = joined(box({0, 0, 0}, {2, 2, 2}), box({1, 1, 1}, {3, 3, 3}));
	const SignedDistance trusted = made(m, optionsOf(kTrust)), resolved = made(m);
	EXPECT_FALSE(trusted.reference().isResolved);
	EXPECT_TRUE(resolved.reference().isResolved);
	EXPECT_GT(resolved.reference().selfIntersecting, 0U);
	const Point p{1.25, 1.5, 1.5};  // near an inner wall
	EXPECT_EQ(trusted.at(p, {}).distance, -0.25);
	EXPECT_NEAR(resolved.at(p, {}).distance, -std::hypot(0.25, 0.5), 1e-15);  // x = 1, y = 2
	SignedDistance none;
	EXPECT_EQ(make(m, optionsOf(SelfIntersections::Refuse), none).code,
	          StatusCode::SelfIntersecting);
}

// Boxes of which the first is the largest, so that none of these layers is turned as a whole.
TEST(SignedDistance, trustedSignsAreThoseOfTheRule) {
	for (unsigned seed = 0; seed < 30; ++seed) {
		std::mt19937 random(seed);
		std::vector<std::pair<Mesh, int>> boxes{{box({-1, -1, -1}, {8, 8, 8}), 1}};
		while (boxes.size() < 5) {
			boxes.emplace_back(gridBox(random, 3), random() % 2 == 0 ? 1 : -2);
		}
		Mesh m;
		for (const auto& [one, winding] : boxes) {
			for (int i = 0; i < std::abs(winding); ++i) {
				m = joined(m, winding < 0 ? turned(one) : one);
			}
		}
		const WindingRule rule = static_cast<WindingRule>(seed % 3);
		const SignedDistance distance = made(m, optionsOf(kTrust, rule));
		std::vector<Point> points;
		for (int i = 0; i < 300; ++i) {
			points.push_back(randomIn(random, -2, 9));
		}
		const auto samples = sampled(distance, points);
		for (std::size_t i = 0; i < points.size(); ++i) {
			int winding = 0;
			for (const auto& [one, times] : boxes) {
				winding += toBox(points[i], one.points[0], one.points[7]) < 0 ? times : 0;
			}
			ASSERT_EQ(samples[i].sign, ruleSays(rule, winding) ? -1 : 1) << seed << " " << i;
		}
	}
}

TEST(SignedDistance, insideOutOrNotIsTheSame) {
	const Mesh m = sphere(10, {0, 0, 0}, 1);
	for (const SelfIntersections search : {kResolve, kTrust}) {
		const SignedDistance a = made(m, optionsOf(search)), b = made(turned(m), optionsOf(search));
		EXPECT_TRUE(b.reference().wasInsideOut);
		std::mt19937 random(5);
		for (int i = 0; i < 500; ++i) {
			const Point p = randomIn(random, -1.5, 1.5);
			ASSERT_EQ(a.at(p, {}).distance, b.at(p, {}).distance);
			ASSERT_EQ(a.at(p, {}).gradient, b.at(p, {}).gradient);
		}
		const Point onIt = m.points[5];
		EXPECT_EQ(a.at(onIt, {}).distance, 0);
		EXPECT_EQ(a.at(onIt, {}).gradient, b.at(onIt, {}).gradient);
		EXPECT_GT(dotOf(longOf(a.at(onIt, {}).gradient), longOf(onIt)), 0.9);
	}
}

// --- open surfaces -------------------------------------------------------------------------------

TEST(SignedDistance, ofAnOpenSurfaceHasTheSideOfTheNearestFeature) {
	Mesh m = box({0, 0, 0}, {1, 1, 1});
	m.triangles.resize(10);  // without the side x = 1
	const SignedDistance distance = made(m);
	EXPECT_FALSE(distance.reference().isClosed);
	EXPECT_LT(distance.at({0.1, 0.5, 0.5}, {}).distance, 0);
	EXPECT_GT(distance.at({-0.1, 0.5, 0.5}, {}).distance, 0);
	EXPECT_GT(distance.at({-0.1, -0.1, -0.1}, {}).distance, 0);  // beside a vertex
	EXPECT_GT(distance.at({0.5, -0.1, -0.2}, {}).distance, 0);   // beside an edge
	EXPECT_EQ(distance.at({0.5, 0, 0.5}, {}).distance, 0);
	EXPECT_EQ(distance.at({0.5, 0, 0.5}, {}).gradient, (Point{0, -1, 0}));
}

// The pseudonormal is a second witness on an embedded closed surface.
TEST(SignedDistance, pseudonormalsAgreeWithWindingsOnEmbeddedSurfaces) {
	std::mt19937 random(6);
	Mesh m = torus(14, 9, 2, 1);
	for (Point& p : m.points) {  // saddles and spikes
		const Point offset = randomIn(random, -0.15, 0.15);
		for (std::size_t k = 0; k < 3; ++k) {
			p[k] += offset[k];
		}
	}
	Monitor monitor;
	Reference reference;
	ASSERT_TRUE(prepareReference(arraysOf(m), optionsOf(kResolve), true, monitor, reference).ok());
	ASSERT_EQ(reference.selfIntersecting, 0U);
	Reference asOpen = reference;
	asOpen.isClosed = false;
	SignedDistance byWinding, bySide;
	ASSERT_TRUE(byWinding.build(reference, 1, monitor).ok());
	ASSERT_TRUE(bySide.build(asOpen, 1, monitor).ok());
	for (int i = 0; i < 20'000; ++i) {
		const Point p = randomIn(random, -3.5, 3.5);
		ASSERT_EQ(byWinding.at(p, {}).sign, bySide.at(p, {}).sign) << i;
	}
}

// --- what must not matter ------------------------------------------------------------------------

void expectSame(const DistanceSample& a, const DistanceSample& b) {
	ASSERT_EQ(a.distance, b.distance);
	ASSERT_EQ(a.sign, b.sign);
	ASSERT_EQ(a.closest, b.closest);
	ASSERT_EQ(a.gradient, b.gradient);
}

TEST(SignedDistance, doesNotDependOnNumberingThreadsOrTheOtherPoints) {
	std::mt19937 random(7);
	const Mesh m = placed(torus(30, 20, 2, 1), random, 1), other = permuted(m, random);
	const SignedDistance a = made(m), b = made(soup(other));
	std::vector<Point> points;
	for (int i = 0; i < 3000; ++i) {
		points.push_back(randomIn(random, -4, 4));
	}
	points.insert(points.end(), m.points.begin(), m.points.end());
	const auto one = sampled(a, points, {}, 1), two = sampled(a, points, {}, 2),
	           three = sampled(b, points);
	for (std::size_t i = 0; i < points.size(); ++i) {
		expectSame(one[i], two[i]);
		expectSame(one[i], three[i]);
		expectSame(one[i], a.at(points[i], {}));
	}
}

// --- limits --------------------------------------------------------------------------------------

TEST(SignedDistance, beyondTheMaximumOnlyTheSignIsKnown) {
	const SignedDistance distance = made(box({0, 0, 0}, {4, 4, 4}));
	DistanceOptions options;
	options.maximum = 1;
	std::mt19937 random(8);
	std::vector<Point> points;
	for (int i = 0; i < 5000; ++i) {
		points.push_back(randomIn(random, -3, 7));
	}
	const auto samples = sampled(distance, points, options);
	for (std::size_t i = 0; i < points.size(); ++i) {
		const double truth = toBox(points[i], {0, 0, 0}, {4, 4, 4});
		ASSERT_EQ(samples[i].sign, truth < 0 ? -1 : 1);
		if (std::fabs(truth) > 1 + 1e-9) {
			ASSERT_TRUE(std::isnan(samples[i].distance));
			ASSERT_EQ(samples[i].face, kNone);
		} else if (std::fabs(truth) < 1 - 1e-9) {
			ASSERT_NEAR(samples[i].distance, truth, 1e-12);
		}
	}
}

TEST(SignedDistance, negatedIsPositiveInside) {
	const SignedDistance distance = made(box({0, 0, 0}, {2, 2, 2}));
	DistanceOptions options;
	options.negate = true;
	EXPECT_EQ(distance.at({1, 1, 0.5}, options).distance, 0.5);
	EXPECT_EQ(distance.at({1, 1, 0.5}, options).gradient, (Point{0, 0, 1}));
	EXPECT_EQ(distance.at({1, 1, 0.5}, {}).gradient, (Point{0, 0, -1}));
	EXPECT_FALSE(std::signbit(distance.at({1, 1, 0}, options).distance));
}

TEST(SignedDistance, ofWhatIsNoPointIsNoNumber) {
	const SignedDistance distance = made(box({0, 0, 0}, {1, 1, 1}));
	const double nan = std::numeric_limits<double>::quiet_NaN();
	std::vector<Point> points(100, {0.5, 0.5, 0.5});
	points[3] = {nan, 0, 0};
	points[5] = {0, kInfinity, 0};
	points[7] = {-kInfinity, nan, kInfinity};
	const auto samples = sampled(distance, points);
	for (std::size_t i = 0; i < points.size(); ++i) {
		const bool isNone = i == 3 || i == 5 || i == 7;
		ASSERT_EQ(std::isnan(samples[i].distance), isNone);
		ASSERT_EQ(samples[i].sign, isNone ? 0 : -1);
		ASSERT_EQ(samples[i].face == kNone, isNone);
		ASSERT_TRUE(isNone || samples[i].distance == -0.5);
	}
}

TEST(SignedDistance, holdsAtEveryMagnitude) {
	for (const int exponent : {-1000, -600, -300, 300, 600, 1000}) {
		const double unit = std::ldexp(1.0, exponent);
		const SignedDistance distance = made(box({0, 0, 0}, {2 * unit, 2 * unit, 2 * unit}));
		EXPECT_EQ(distance.at({unit, unit, unit / 2}, {}).distance, -unit / 2) << exponent;
		EXPECT_EQ(distance.at({unit, unit, 3 * unit}, {}).distance, unit) << exponent;
		EXPECT_EQ(distance.at({unit, unit, 2 * unit}, {}).sign, 0) << exponent;
	}
	const SignedDistance distance = made(box({0, 0, 0}, {1, 1, 1}));
	const double far = 1e300;
	EXPECT_NEAR(distance.at({far, 0.5, 0.5}, {}).distance / far, 1, 1e-15);
	EXPECT_EQ(distance.at({far, 0.5, 0.5}, {}).closest[0], 1);
	EXPECT_EQ(distance.at({far, far, far}, {}).closest, (Point{1, 1, 1}));
	EXPECT_EQ(distance.at({0.5, 0.5, -0x1p-1060}, {}).sign, 1);
	EXPECT_GT(distance.at({0.5, 0.5, -0x1p-1060}, {}).distance, 0);
	EXPECT_LT(distance.at({0.5, 0.5, 0x1p-1060}, {}).distance, 0);
}

TEST(SignedDistance, strayVerticesAndFlatFacesDoNotCount) {
	Mesh m = sphere(20, {0, 0, 0}, 1);
	m.points.push_back({1e9, 1e9, 1e9});
	m.triangles.push_back({3, 3, 7});
	const SignedDistance distance = made(m), plain = made(sphere(20, {0, 0, 0}, 1));
	std::mt19937 random(9);
	for (int i = 0; i < 500; ++i) {
		const Point p = randomIn(random, -2, 2);
		ASSERT_EQ(distance.at(p, {}).distance, plain.at(p, {}).distance);
	}
}

TEST(SignedDistance, faultyReferencesAreRefused) {
	SignedDistance none;
	EXPECT_EQ(make({}, optionsOf(kResolve), none).code, StatusCode::EmptyOperand);
	Mesh nan = box({0, 0, 0}, {1, 1, 1});
	nan.points[2][1] = std::numeric_limits<double>::quiet_NaN();
	EXPECT_EQ(make(nan, optionsOf(kResolve), none).code, StatusCode::NotFinite);
	Mesh twoSided;
	twoSided.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
	twoSided.triangles = {{0, 1, 2}, {0, 2, 1}};
	const StatusCode code = make(twoSided, optionsOf(kResolve), none).code;
	EXPECT_TRUE(code == StatusCode::NoVolume || code == StatusCode::EmptyOperand);
	Mesh missing = box({0, 0, 0}, {1, 1, 1});
	missing.triangles[4][1] = 99;
	EXPECT_EQ(make(missing, optionsOf(kTrust), none).code, StatusCode::IndexOutOfRange);
}

TEST(SignedDistance, aRunThatIsCancelledStops) {
	const SignedDistance distance = made(sphere(40, {0, 0, 0}, 1));
	std::vector<Point> points(200'000, {0, 0, 0});  // as far from all faces
	std::vector<DistanceSample> samples(points.size());
	int calls = 0;
	Monitor monitor([&calls](double, const char*) { return ++calls < 3; });
	monitor.beginStage("sampling", 0, 1);
	EXPECT_EQ(distance.sample({points.data(), points.size(), samples.data()}, {}, 0, monitor).code,
	          StatusCode::Cancelled);
	Reference reference;
	Monitor never([](double, const char*) { return false; });
	never.beginStage("preparing", 0, 1);
	EXPECT_EQ(prepareReference(arraysOf(sphere(40, {0, 0, 0}, 1)), optionsOf(kResolve), true, never,
	                           reference)
	              .code,
	          StatusCode::Cancelled);
}

}  // namespace
}  // namespace index_boolean
