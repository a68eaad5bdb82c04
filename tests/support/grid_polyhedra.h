// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Random solids with integer coordinates 0 to a small span, and random pairs of them, so that every
// kind of contact and every degeneracy occurs: hulls, boxes, extruded and pointed polygons, voxels
// (edges with four faces and pinched vertices included), non-convex solids by random edits, several
// components, cavities. All integer arithmetic; each solid has been checked by isSolid.
#pragma once

#include "grid_mesh.h"
#include "volume_oracle.h"

#include <numeric>
#include <optional>
#include <random>

namespace index_boolean::grid {

// The same sequence with every standard library.
class Random {
public:
	explicit Random(std::uint32_t seed) : engine_(seed) {}

	// The decisions are those of the bytes, one or four each, until there are none left.
	Random(const std::uint8_t* bytes, std::size_t size)
	    : engine_(1), bytes_(bytes), end_(bytes + size) {}

	// 0 to n - 1. \pre n > 0
	std::int64_t below(std::int64_t n) {
		return static_cast<std::int64_t>(next(n <= 256 ? 1 : 4) % static_cast<std::uint32_t>(n));
	}
	std::size_t index(std::size_t n) {
		return static_cast<std::size_t>(below(static_cast<std::int64_t>(n)));
	}
	bool oneIn(int n) { return below(n) == 0; }

	IntPoint point(std::int64_t span) {
		return {below(span + 1), below(span + 1), below(span + 1)};
	}
	template <class T>
	void shuffle(std::vector<T>& items) {
		for (std::size_t i = items.size(); i > 1; --i) {
			std::swap(items[i - 1], items[index(i)]);
		}
	}

private:
	std::uint32_t next(std::ptrdiff_t width) {
		if (end_ - bytes_ < width) {
			return static_cast<std::uint32_t>(engine_());
		}
		std::uint32_t value = 0;
		for (; width > 0; --width) {
			value = value << 8 | *bytes_++;
		}
		return value;
	}

	std::mt19937 engine_;
	const std::uint8_t* bytes_ = nullptr;
	const std::uint8_t* end_ = nullptr;
};

// --- polygons: points of the plane z = 0, counter-clockwise seen from above -------------------

inline std::int64_t turnOf(const IntPoint& a, const IntPoint& b, const IntPoint& c) {
	return normal(a, b, c)[2];
}

inline bool segmentsMeet(const IntPoint& a, const IntPoint& b, const IntPoint& c,
                         const IntPoint& d) {
	for (std::size_t k = 0; k < 2; ++k) {
		if (std::max(a[k], b[k]) < std::min(c[k], d[k]) ||
		    std::max(c[k], d[k]) < std::min(a[k], b[k])) {
			return false;
		}
	}
	return signOf(turnOf(a, b, c)) * signOf(turnOf(a, b, d)) <= 0 &&
	       signOf(turnOf(c, d, a)) * signOf(turnOf(c, d, b)) <= 0;
}

inline bool isSimple(const std::vector<IntPoint>& polygon) {
	const std::size_t n = polygon.size();
	for (std::size_t i = 0; i < n; ++i) {
		const IntPoint &a = polygon[i], &b = polygon[(i + 1) % n], &c = polygon[(i + 2) % n];
		if (a == b || (turnOf(a, b, c) == 0 && dot(a - b, c - b) > 0)) {
			return false;
		}
		for (std::size_t j = i + 2; j < n && j + 1 < i + n; ++j) {
			if (segmentsMeet(a, b, polygon[j], polygon[(j + 1) % n])) {
				return false;
			}
		}
	}
	return true;
}

// A random simple polygon with at most `most` corners; some of them may be flat.
inline std::vector<IntPoint> randomPolygon(Random& random, std::int64_t span, std::size_t most) {
	std::vector<IntPoint> polygon;
	const auto flat = [&] { return IntPoint{random.below(span + 1), random.below(span + 1), 0}; };
	do {
		polygon = {flat(), flat(), flat()};
	} while (turnOf(polygon[0], polygon[1], polygon[2]) <= 0);
	for (int tries = 0; tries < 40 && polygon.size() < most; ++tries) {
		std::vector<IntPoint> longer = polygon;
		longer.insert(longer.begin() + random.below(static_cast<std::int64_t>(polygon.size())),
		              flat());
		if (isSimple(longer)) {
			polygon = longer;
		}
	}
	return polygon;
}

// Cuts ears off a simple polygon, from a random corner on. Empty if none is found.
inline std::vector<std::array<IntPoint, 3>> triangulated(std::vector<IntPoint> polygon,
                                                         Random& random) {
	std::vector<std::array<IntPoint, 3>> triangles;
	std::size_t at = random.index(polygon.size()), failed = 0;
	while (polygon.size() > 2) {
		const std::size_t n = polygon.size();
		if (failed++ == n) {
			return {};
		}
		at = (at + 1) % n;
		const IntPoint a = polygon[(at + n - 1) % n], b = polygon[at], c = polygon[(at + 1) % n];
		const bool covers = std::any_of(polygon.begin(), polygon.end(), [&](const IntPoint& p) {
			return p != a && p != b && p != c && turnOf(a, b, p) >= 0 && turnOf(b, c, p) >= 0 &&
			       turnOf(c, a, p) >= 0;
		});
		if (turnOf(a, b, c) > 0 && !covers) {
			triangles.push_back({a, b, c});
			polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(at));
			failed = 0;
		}
	}
	return triangles;
}

// --- solids ------------------------------------------------------------------------------------

// The corners of a convex polygon among points of one plane with normal n: in order, counter-
// clockwise, without flat ones.
inline std::vector<IntPoint> planarHull(const std::vector<IntPoint>& points, const IntPoint& n) {
	std::vector<IntPoint> hull{*std::min_element(points.begin(), points.end())};
	while (true) {
		IntPoint next = hull.back();
		for (const IntPoint& p : points) {
			const IntPoint &from = hull.back(), along = next - from;
			const std::int64_t turn = dot(n, cross(along, p - from));
			const bool farther = dot(p - from, p - from) > dot(along, along);
			if (next == from || turn < 0 || (turn == 0 && farther)) {
				next = p;
			}
		}
		if (next == hull.front()) {
			return hull;
		}
		hull.push_back(next);
	}
}

// The convex hull; without triangles if the points lie in one plane. O(n^4).
inline GridMesh convexHull(std::vector<IntPoint> points, Random& random) {
	std::sort(points.begin(), points.end());
	points.erase(std::unique(points.begin(), points.end()), points.end());
	GridMeshBuilder builder;
	std::set<std::vector<IntPoint>> done;
	const std::size_t count = points.size();
	for (std::size_t i = 0; i < count * count * count; ++i) {
		const IntPoint &a = points[i % count], &b = points[i / count % count],
		               &c = points[i / count / count];
		const IntPoint n = normal(a, b, c);
		const auto isInFront = [&](const IntPoint& p) { return dot(n, p - a) > 0; };
		if (n == IntPoint{} || std::any_of(points.begin(), points.end(), isInFront)) {
			continue;
		}
		std::vector<IntPoint> facet;
		for (const IntPoint& p : points) {
			if (dot(n, p - a) == 0) {
				facet.push_back(p);
			}
		}
		if (facet.size() == count || !done.insert(facet).second) {
			continue;
		}
		std::vector<IntPoint> corners = planarHull(facet, n);
		std::rotate(corners.begin(),
		            corners.begin() + random.below(static_cast<std::int64_t>(corners.size())),
		            corners.end());
		for (std::size_t k = 2; k < corners.size(); ++k) {
			builder.add(corners[0], corners[k - 1], corners[k]);
		}
	}
	return builder.mesh();
}

inline GridMesh rightSideOut(const GridMesh& m) { return sixVolume(m) < 0 ? turned(m) : m; }

// A polygon moved from z = bottom to z = top, with an offset.
inline GridMesh extruded(const std::vector<IntPoint>& polygon, std::int64_t bottom,
                         const IntPoint& offset, Random& random) {
	GridMeshBuilder builder;
	const IntPoint low{0, 0, bottom}, high = low + offset;
	for (const auto& t : triangulated(polygon, random)) {
		builder.add(t[2] + low, t[1] + low, t[0] + low);
	}
	for (const auto& t : triangulated(polygon, random)) {
		builder.add(t[0] + high, t[1] + high, t[2] + high);
	}
	for (std::size_t i = 0; i < polygon.size(); ++i) {
		const IntPoint &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
		builder.addQuad(p + low, q + low, q + high, p + high, random.oneIn(2));
	}
	return rightSideOut(builder.mesh());
}

// A polygon joined to one point off its plane, or to two on both sides of it.
inline GridMesh pointed(const std::vector<IntPoint>& polygon, std::int64_t level,
                        const std::vector<IntPoint>& tips, Random& random) {
	GridMeshBuilder builder;
	const IntPoint base{0, 0, level};
	if (tips.size() == 1) {
		for (const auto& t : triangulated(polygon, random)) {
			builder.add(t[2] + base, t[1] + base, t[0] + base);
		}
	}
	for (std::size_t i = 0; i < polygon.size(); ++i) {
		const IntPoint p = polygon[i] + base, q = polygon[(i + 1) % polygon.size()] + base;
		builder.add(p, q, tips[0]);
		if (tips.size() == 2) {
			builder.add(q, p, tips[1]);
		}
	}
	return rightSideOut(builder.mesh());
}

// Random cells of a grid of planes at random distances.
inline GridMesh voxels(Random& random, std::int64_t span) {
	std::array<std::vector<std::int64_t>, 3> cuts;
	for (auto& along : cuts) {
		std::vector<std::int64_t> all(static_cast<std::size_t>(span) + 1);
		std::iota(all.begin(), all.end(), 0);
		random.shuffle(all);
		all.resize(2 + random.index(std::min<std::size_t>(3, all.size() - 1)));
		std::sort(all.begin(), all.end());
		along = all;
	}
	const std::array<std::int64_t, 3> counts{static_cast<std::int64_t>(cuts[0].size()) - 1,
	                                         static_cast<std::int64_t>(cuts[1].size()) - 1,
	                                         static_cast<std::int64_t>(cuts[2].size()) - 1};
	std::set<IntPoint> filled;
	const int rarity = 2 + static_cast<int>(random.below(2));
	for (std::int64_t i = 0; i < counts[0] * counts[1] * counts[2]; ++i) {
		if (random.oneIn(rarity)) {
			filled.insert({i % counts[0], i / counts[0] % counts[1], i / counts[0] / counts[1]});
		}
	}
	GridMeshBuilder builder;
	for (const IntPoint& cell : filled) {
		for (std::size_t side = 0; side < 6; ++side) {
			const std::size_t k = side / 2, x = (k + 1) % 3, y = (k + 2) % 3;
			IntPoint beside = cell;
			beside[k] += side % 2 == 0 ? -1 : 1;
			if (filled.count(beside) != 0) {
				continue;
			}
			std::array<IntPoint, 4> square;
			for (std::size_t i = 0; i < 4; ++i) {
				IntPoint corner = cell;
				corner[k] += side % 2 == 0 ? 0 : 1;
				corner[x] += i == 1 || i == 2 ? 1 : 0;
				corner[y] += i >= 2 ? 1 : 0;
				for (std::size_t axis = 0; axis < 3; ++axis) {
					square[i][axis] = cuts[axis][static_cast<std::size_t>(corner[axis])];
				}
			}
			if (side % 2 == 0) {
				std::swap(square[1], square[3]);
			}
			builder.addQuad(square[0], square[1], square[2], square[3], random.oneIn(2));
		}
	}
	return builder.mesh();
}

// --- changes -----------------------------------------------------------------------------------

inline bool isWithin(const GridMesh& m, std::int64_t span) {
	return std::all_of(m.points.begin(), m.points.end(), [span](const IntPoint& p) {
		return std::all_of(p.begin(), p.end(),
		                   [span](std::int64_t c) { return 0 <= c && c <= span; });
	});
}

inline GridMesh moved(GridMesh m, const IntPoint& by) {
	for (IntPoint& p : m.points) {
		p = p + by;
	}
	return m;
}

// Axes exchanged and mirrored, sheared once in a while; as near to the origin as it goes.
inline GridMesh mapped(GridMesh m, Random& random) {
	std::vector<std::size_t> axes{0, 1, 2};
	random.shuffle(axes);
	const bool shear = random.oneIn(3);
	const std::array<int, 3> mirror{random.oneIn(2) ? -1 : 1, random.oneIn(2) ? -1 : 1,
	                                random.oneIn(2) ? -1 : 1};
	IntPoint low{};
	for (IntPoint& p : m.points) {
		const IntPoint q = p;
		for (std::size_t k = 0; k < 3; ++k) {
			p[k] = mirror[k] * q[axes[k]];
		}
		p[0] += shear ? p[1] : 0;
		for (std::size_t k = 0; k < 3; ++k) {
			low[k] = &p == m.points.data() ? p[k] : std::min(low[k], p[k]);
		}
	}
	return rightSideOut(moved(m, IntPoint{} - low));
}

// Each face that has the edge u v is cut in two at a new vertex.
inline GridMesh withSplitEdge(const GridMesh& m, std::uint32_t u, std::uint32_t v,
                              const IntPoint& at) {
	GridMesh split{m.points, {}};
	const auto middle = static_cast<std::uint32_t>(m.points.size());
	split.points.push_back(at);
	for (const Corners& t : m.triangles) {
		Corners first = t, second = t;
		bool has = false;
		for (std::size_t i = 0; i < 3; ++i) {
			const std::uint32_t a = t[i], b = t[(i + 1) % 3];
			if ((a == u && b == v) || (a == v && b == u)) {
				has = true;
				first[(i + 1) % 3] = middle;
				second[i] = middle;
			}
		}
		split.triangles.push_back(first);
		if (has) {
			split.triangles.push_back(second);
		}
	}
	return split;
}

// The other diagonal of the two faces at an edge; unchanged if they are not two.
inline GridMesh withFlippedEdge(const GridMesh& m, std::uint32_t u, std::uint32_t v) {
	GridMesh flipped{m.points, {}};
	std::vector<std::uint32_t> tips(2, u);
	std::size_t faces = 0;
	for (const Corners& t : m.triangles) {
		bool has = false;
		for (std::size_t i = 0; i < 3; ++i) {
			const std::uint32_t a = t[i], b = t[(i + 1) % 3];
			if ((a == u && b == v) || (a == v && b == u)) {
				has = true;
				tips[a == u ? 0 : 1] = t[(i + 2) % 3];
				++faces;
			}
		}
		if (!has) {
			flipped.triangles.push_back(t);
		}
	}
	if (faces != 2) {
		return m;
	}
	flipped.triangles.push_back({u, tips[1], tips[0]});
	flipped.triangles.push_back({v, tips[0], tips[1]});
	return flipped;
}

// One random change. The result may be no solid.
inline GridMesh changed(const GridMesh& m, Random& random, std::int64_t span) {
	const std::size_t face = random.index(m.triangles.size());
	const Corners t = m.triangles[face];
	IntPoint place;
	for (std::size_t k = 0; k < 3; ++k) {
		const auto [low, high] =
		    std::minmax({m.points[t[0]][k], m.points[t[1]][k], m.points[t[2]][k]});
		place[k] = std::clamp<std::int64_t>(low - 1 + random.below(high - low + 3), 0, span);
	}
	switch (random.below(4)) {
	case 0: {
		GridMesh edited = m;
		edited.points[t[0]] = place;
		return edited;
	}
	case 1: {
		GridMesh edited = m;
		const auto tip = static_cast<std::uint32_t>(m.points.size());
		edited.points.push_back(place);
		edited.triangles[face] = {t[0], t[1], tip};
		edited.triangles.push_back({t[1], t[2], tip});
		edited.triangles.push_back({t[2], t[0], tip});
		return edited;
	}
	case 2:
		return withSplitEdge(m, t[0], t[1], place);
	default:
		return withFlippedEdge(m, t[0], t[1]);
	}
}

// Up to `count` random changes that keep the mesh embedded. A change that is only to cut the
// surface otherwise keeps the volume too.
inline GridMesh edited(GridMesh m, Random& random, std::int64_t span, int count, bool keepSurface) {
	const GridMesh before = m;
	for (int tries = 0; tries < 8 * count && count > 0; ++tries) {
		const GridMesh next = changed(m, random, span);
		const std::int64_t volume = sixVolume(next);
		const bool kept = !keepSurface || (volume == sixVolume(before) &&
		                                   doubleProjections(next) == doubleProjections(before));
		if (volume > 0 && kept && isEmbedded(next)) {
			m = next;
			--count;
		}
	}
	return m;
}

inline bool isOnSurface(const GridMesh& m, const IntPoint& p) {
	for (std::size_t f = 0; f < m.triangles.size(); ++f) {
		if (meet(p, p, {m.corner(f, 0), m.corner(f, 1), m.corner(f, 2)})) {
			return true;
		}
	}
	return false;
}

inline bool isOnEdge(const GridMesh& m, const IntPoint& p) {
	for (std::size_t f = 0; f < m.triangles.size(); ++f) {
		for (std::size_t i = 0; i < 3; ++i) {
			const IntPoint &a = m.corner(f, i), &b = m.corner(f, (i + 1) % 3);
			if (normal(a, b, p) == IntPoint{} && dot(a - p, b - p) <= 0) {
				return true;
			}
		}
	}
	return false;
}

// --- random solids and pairs -------------------------------------------------------------------

class Generator {
public:
	Generator(Random random, std::int64_t span) : random_(random), span_(span) {}

	// A solid of any kind. Never fails: what is no solid is tried again.
	GridMesh solid() {
		while (true) {
			GridMesh m = attempt();
			if (random_.oneIn(3)) {
				const GridMesh other = mapped(m, random_);
				m = isWithin(other, span_) ? other : m;
			}
			if (random_.oneIn(3) && !m.triangles.empty()) {
				m = edited(m, random_, span_, 1 + static_cast<int>(random_.below(6)),
				           random_.oneIn(3));
			}
			m = withoutLooseVertices(m);
			if (m.triangles.size() <= kMostFaces && isSolid(m)) {
				return m;
			}
		}
	}

	// A solid that has much in common with another.
	GridMesh solidRelatedTo(const GridMesh& other) {
		for (int tries = 0; tries < 20; ++tries) {
			const GridMesh m = withoutLooseVertices(attemptRelatedTo(other));
			if (m.triangles.size() <= kMostFaces && isWithin(m, span_) && isSolid(m)) {
				return m;
			}
		}
		return other;
	}

	Random& random() { return random_; }

private:
	static constexpr std::size_t kMostFaces = 160;

	GridMesh attempt() {
		switch (random_.below(8)) {
		case 0:
		case 1:
			return hull(4 + random_.index(8));
		case 2:
			return box();
		case 3:
			return prism();
		case 4:
			return withTips();
		case 5:
			return voxels(random_, span_);
		default:
			return severalComponents();
		}
	}

	GridMesh attemptRelatedTo(const GridMesh& other) {
		switch (random_.below(6)) {
		case 0:
			return other;
		case 1:
			return edited(other, random_, span_, 6, true);
		case 2:
			return edited(other, random_, span_, 2, false);
		case 3:
			return moved(other, random_.point(2) - IntPoint{1, 1, 1});
		case 4:
			return mapped(other, random_);
		default:
			return hullTouching(other);
		}
	}

	GridMesh hull(std::size_t count) {
		std::vector<IntPoint> points(count);
		for (IntPoint& p : points) {
			p = random_.point(span_);
		}
		return convexHull(points, random_);
	}

	// Most of its corners lie on the other's surface, many of them in its vertices.
	GridMesh hullTouching(const GridMesh& other) {
		std::vector<IntPoint> points;
		for (int tries = 0; tries < 200 && points.size() < 4 + random_.index(4); ++tries) {
			const IntPoint p = random_.oneIn(3) ? other.points[random_.index(other.points.size())]
			                                    : random_.point(span_);
			if (isOnSurface(other, p)) {
				points.push_back(p);
			}
		}
		points.push_back(random_.oneIn(2) ? random_.point(span_) : other.points[0]);
		return convexHull(points, random_);
	}

	// Two different numbers from 0 to span, in order.
	std::array<std::int64_t, 2> interval() {
		const std::int64_t a = random_.below(span_ + 1), b = random_.below(span_);
		const std::int64_t other = b >= a ? b + 1 : b;
		return {std::min(a, other), std::max(a, other)};
	}

	GridMesh box() {
		const auto x = interval(), y = interval(), z = interval();
		const std::vector<IntPoint> base{
		    {x[0], y[0], 0}, {x[1], y[0], 0}, {x[1], y[1], 0}, {x[0], y[1], 0}};
		return extruded(base, z[0], {0, 0, z[1] - z[0]}, random_);
	}

	GridMesh prism() {
		const auto z = interval();
		const bool oblique = random_.oneIn(3);
		const std::int64_t most = oblique ? (span_ + 1) / 2 : span_;
		const IntPoint offset{oblique ? random_.below(span_ - most + 1) : 0,
		                      oblique ? random_.below(span_ - most + 1) : 0, z[1] - z[0]};
		return extruded(randomPolygon(random_, most, 3 + random_.index(7)), z[0], offset, random_);
	}

	GridMesh withTips() {
		const std::vector<IntPoint> polygon = randomPolygon(random_, span_, 3 + random_.index(7));
		const std::int64_t level = random_.below(span_ + 1);
		std::vector<IntPoint> tips;
		for (const auto& [low, high] : {std::array<std::int64_t, 2>{level + 1, span_},
		                                std::array<std::int64_t, 2>{0, level - 1}}) {
			if (low <= high && (tips.empty() || random_.oneIn(2))) {
				IntPoint tip = random_.point(span_);
				tip[2] = low + random_.below(high - low + 1);
				tips.push_back(tip);
			}
		}
		return pointed(polygon, level, tips, random_);
	}

	// A solid and a smaller one beside it, inside it, or touching it in vertices and edges.
	GridMesh severalComponents() {
		GridMesh all = random_.oneIn(2) ? box() : hull(8);
		for (int tries = 0; tries < 12 && !all.triangles.empty(); ++tries) {
			const std::int64_t size = 1 + random_.below(std::max<std::int64_t>(span_ / 2, 1));
			Generator smaller(Random(static_cast<std::uint32_t>(random_.below(1 << 30))), size);
			GridMesh part = smaller.random().oneIn(2) ? smaller.box() : smaller.hull(5);
			if (part.triangles.empty()) {
				continue;
			}
			IntPoint by = random_.point(span_ - size);
			if (random_.oneIn(3)) {
				by = all.points[random_.index(all.points.size())] -
				     part.points[random_.index(part.points.size())];
			}
			part = moved(part, by);
			for (const GridMesh& added : {part, turned(part)}) {
				GridMeshBuilder builder;
				builder.add(all);
				builder.add(added);
				if (isWithin(part, span_) && isSolid(builder.mesh())) {
					all = builder.mesh();
					break;
				}
			}
		}
		return all;
	}

	Random random_;
	std::int64_t span_;
};

struct SolidPair {
	GridMesh a, b;
};

inline SolidPair randomPair(Random random, std::int64_t span) {
	Generator generator(random, span);
	SolidPair pair;
	pair.a = generator.solid();
	pair.b = generator.random().oneIn(2) ? generator.solid() : generator.solidRelatedTo(pair.a);
	if (generator.random().oneIn(2)) {
		std::swap(pair.a, pair.b);
	}
	return pair;
}

constexpr std::array<std::int64_t, 6> kSpans{2, 3, 4, 5, 6, kMostCoordinate};

// The pair of one seed.
inline SolidPair randomPair(std::uint32_t seed) {
	return randomPair(Random(seed), kSpans[seed % kSpans.size()]);
}

}  // namespace index_boolean::grid
