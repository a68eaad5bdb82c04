// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// For tests of any number of operands, each of which may meet itself: layers whose cells are known,
// runs of the general path, and how a block meets itself, told from its coordinates alone.
#pragma once

#include "core/shapes.h"
#include "support/stored_faces.h"

#include <gtest/gtest.h>

#include <numeric>
#include <ostream>

namespace index_boolean::shapes {

using Windings = PerOperand<std::int32_t>;
using Corners = std::array<Point, 3>;
using PlanePoint = std::array<double, 2>;

// --- layers -------------------------------------------------------------------------------------

// Several meshes as one operand.
inline Mesh layer(const std::vector<Mesh>& parts) {
	Mesh m;
	for (const Mesh& part : parts) {
		m = joined(m, part);
	}
	return m;
}

// Each place is one vertex.
inline Mesh welded(const std::vector<Corners>& triangles) {
	Mesh m;
	std::map<Point, std::uint32_t> ids;
	for (const Corners& t : triangles) {
		IndexTriangle corners{};
		for (std::size_t i = 0; i < 3; ++i) {
			const auto next = static_cast<std::uint32_t>(m.points.size());
			const auto [place, isNew] = ids.emplace(t[i], next);
			if (isNew) {
				m.points.push_back(t[i]);
			}
			corners[i] = place->second;
		}
		m.triangles.push_back(corners);
	}
	return m;
}

inline std::vector<Corners> cornersOf(const Mesh& m) {
	std::vector<Corners> all;
	for (const IndexTriangle& t : m.triangles) {
		all.push_back({m.points[t[0]], m.points[t[1]], m.points[t[2]]});
	}
	return all;
}

inline Corners turned(const Corners& t) { return {t[0], t[2], t[1]}; }

inline void addQuad(std::vector<Corners>& to, const Point& a, const Point& b, const Point& c,
                    const Point& d) {
	to.push_back({a, b, c});
	to.push_back({a, c, d});
}

// Right side out, in whatever order the corners come.
inline Mesh tetrahedron(const Point& a, const Point& b, const Point& c, const Point& d) {
	Mesh m;
	m.points = {a, b, c, d};
	m.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
	return volumeOf(m.points, m.triangles) < 0 ? turned(m) : m;
}

// The image under a matrix, given by rows. \pre its determinant is positive
inline Mesh mapped(Mesh m, const std::array<Point, 3>& rows) {
	for (Point& p : m.points) {
		Point image{};
		for (std::size_t i = 0; i < 3; ++i) {
			image[i] = rows[i][0] * p[0] + rows[i][1] * p[1] + rows[i][2] * p[2];
		}
		p = image;
	}
	return m;
}

inline Mesh moved(Mesh m, const Point& by) {
	for (Point& p : m.points) {
		p = {p[0] + by[0], p[1] + by[1], p[2] + by[2]};
	}
	return m;
}

// The plate [0,6] x [0,6] x [0,1] without the hole [low,low+2] x [low,low+2].
inline Mesh frame(double low) {
	const double high = low + 2;
	const std::array<PlanePoint, 4> rim{{{0, 0}, {6, 0}, {6, 6}, {0, 6}}};
	const std::array<PlanePoint, 4> hole{{{low, low}, {high, low}, {high, high}, {low, high}}};
	const auto at = [](const PlanePoint& p, double z) { return Point{p[0], p[1], z}; };
	std::vector<Corners> faces;
	for (std::size_t i = 0; i < 4; ++i) {
		const PlanePoint &p = rim[i], &q = rim[(i + 1) % 4], &r = hole[(i + 1) % 4], &s = hole[i];
		addQuad(faces, at(p, 1), at(q, 1), at(r, 1), at(s, 1));
		addQuad(faces, at(s, 0), at(r, 0), at(q, 0), at(p, 0));
		addQuad(faces, at(p, 0), at(q, 0), at(q, 1), at(p, 1));
		addQuad(faces, at(r, 0), at(s, 0), at(s, 1), at(r, 1));
	}
	return welded(faces);
}

// The tube over the polygon (0,0) (2,2) (2,0) (0,2), which crosses itself in (1,1); its two lobes
// are turned against each other.
inline Mesh figureEightTube() {
	const std::array<PlanePoint, 4> polygon{{{0, 0}, {2, 2}, {2, 0}, {0, 2}}};
	const auto at = [&polygon](std::size_t i, double z) {
		return Point{polygon[i % 4][0], polygon[i % 4][1], z};
	};
	std::vector<Corners> faces;
	for (std::size_t i = 0; i < 4; ++i) {
		addQuad(faces, at(i, 0), at(i + 1, 0), at(i + 1, 3), at(i, 3));
	}
	addQuad(faces, at(0, 3), at(1, 3), at(2, 3), at(3, 3));
	for (const Corners& t :
	     {Corners{at(0, 0), at(1, 0), at(2, 0)}, Corners{at(0, 0), at(2, 0), at(3, 0)}}) {
		faces.push_back(turned(t));
	}
	return welded(faces);
}

// The box [0,2]^3 but for its top, which is three triangles at a vertex on, or near, the middle of
// the edge y = 0, z = 2: that edge of the side below has no such vertex.
inline Mesh boxWithHangingVertex(const Point& hanging) {
	const Mesh whole = box({0, 0, 0}, {2, 2, 2});
	std::vector<Corners> faces;
	for (const Corners& t : cornersOf(whole)) {
		if (t[0][2] + t[1][2] + t[2][2] < 6) {
			faces.push_back(t);
		}
	}
	faces.push_back({Point{0, 0, 2}, hanging, Point{0, 2, 2}});
	faces.push_back({hanging, Point{2, 2, 2}, Point{0, 2, 2}});
	faces.push_back({hanging, Point{2, 0, 2}, Point{2, 2, 2}});
	return welded(faces);
}

// The boxes [0,2]^3 and [2,4]x[1,3]x[1,3] as one skin, without the wall [1,2]x[1,2] in the plane
// x = 2 between them. Both walls around it have vertices on edges of the other box.
inline Mesh skinOfTwoBoxes() {
	std::vector<Corners> faces;
	for (const Mesh& part : {box({0, 0, 0}, {2, 2, 2}), box({2, 1, 1}, {4, 3, 3})}) {
		for (const Corners& t : cornersOf(part)) {
			if (!(t[0][0] == 2 && t[1][0] == 2 && t[2][0] == 2)) {
				faces.push_back(t);
			}
		}
	}
	const std::array<PlanePoint, 6> left{{{1, 1}, {1, 2}, {0, 2}, {0, 0}, {2, 0}, {2, 1}}};
	const std::array<PlanePoint, 6> right{{{2, 2}, {2, 1}, {3, 1}, {3, 3}, {1, 3}, {1, 2}}};
	const auto at = [](const PlanePoint& p) { return Point{2, p[0], p[1]}; };
	for (std::size_t i = 1; i + 1 < 6; ++i) {
		faces.push_back({at(left[0]), at(left[i]), at(left[i + 1])});
		faces.push_back({at(right[0]), at(right[i + 1]), at(right[i])});
	}
	return welded(faces);
}

// Two faces in the plane z = 0 lie on each other and have an edge in common.
inline Mesh fold() {
	const Point a{0, 0, 0}, b{4, 0, 0}, c{0, 4, 0}, d{1, 1, 0}, top{1, 1, 4};
	return welded({{a, c, b}, {a, b, d}, {c, a, top}, {b, c, top}, {a, d, top}, {d, b, top}});
}

// Closed and one-sided: four faces of an octahedron and the three squares through its middle. Each
// square has another diagonal: where two have the same, four faces meet.
inline Mesh tetrahemihexahedron() {
	const Point x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, left{-1, 0, 0}, front{0, -1, 0}, low{0, 0, -1};
	std::vector<Corners> faces{{x, y, z}, {x, front, low}, {left, y, low}, {left, front, z}};
	addQuad(faces, x, y, left, front);
	addQuad(faces, z, x, low, left);  // no two squares have a diagonal in common
	addQuad(faces, y, z, front, low);
	return welded(faces);
}

// Closed and one-sided: a square tube that runs back into itself, through its own wall.
inline Mesh kleinBottle() {
	using Path = std::array<PlanePoint, 6>;  // (x, z)
	const Path left{{{1, 6}, {1, 10}, {8, 10}, {8, 2}, {3, 2}, {3, 0}}};
	const Path right{{{3, 6}, {3, 8}, {6, 8}, {6, 4}, {1, 4}, {1, 0}}};
	const auto at = [](const PlanePoint& p, double y) { return Point{p[0], y, p[1]}; };
	std::vector<Corners> faces;
	for (std::size_t i = 0; i + 1 < left.size(); ++i) {
		const PlanePoint &p = left[i], &q = left[i + 1], &r = right[i], &s = right[i + 1];
		addQuad(faces, at(p, 1), at(q, 1), at(q, 3), at(p, 3));
		addQuad(faces, at(r, 1), at(s, 1), at(s, 3), at(r, 3));
		addQuad(faces, at(p, 1), at(q, 1), at(s, 1), at(r, 1));
		addQuad(faces, at(p, 3), at(q, 3), at(s, 3), at(r, 3));
	}
	const std::array<PlanePoint, 4> rim{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}};
	const std::array<PlanePoint, 4> hole{{{1, 1}, {3, 1}, {3, 3}, {1, 3}}};
	for (std::size_t i = 0; i < 4; ++i) {
		const PlanePoint &p = rim[i], &q = rim[(i + 1) % 4], &r = hole[(i + 1) % 4], &s = hole[i];
		addQuad(faces, {p[0], p[1], 0}, {q[0], q[1], 0}, {q[0], q[1], 6}, {p[0], p[1], 6});
		for (const double z : {0., 6.}) {
			addQuad(faces, {p[0], p[1], z}, {q[0], q[1], z}, {r[0], r[1], z}, {s[0], s[1], z});
		}
	}
	return welded(faces);
}

// --- runs ---------------------------------------------------------------------------------------

struct CellsRun {
	Status status;
	Arrangement arrangement;

	// The bounded cells: windings and volume, sorted.
	std::vector<std::pair<std::vector<std::int32_t>, double>> cells() const {
		std::vector<std::pair<std::vector<std::int32_t>, double>> all;
		for (std::size_t cell = 1; cell < arrangement.cells.windings.size(); ++cell) {
			const Windings& windings = arrangement.cells.windings[cell];
			all.emplace_back(std::vector<std::int32_t>(windings.begin(), windings.end()),
			                 arrangement.cells.volume[cell]);
		}
		std::sort(all.begin(), all.end());
		return all;
	}
	double volumeWhere(const CellPredicate& isInside) const {
		double sum = 0;
		for (std::size_t cell = 1; cell < arrangement.cells.windings.size(); ++cell) {
			sum += isInside(arrangement.cells.windings[cell]) ? arrangement.cells.volume[cell] : 0;
		}
		return sum;
	}
};

// What many small runs are made with: more threads would wait for each other most of the time.
inline Options onOneThread() {
	Options options;
	options.threads = 1;
	return options;
}

inline CellsRun runCells(const std::vector<Mesh>& operands,
                         const Options& options = onOneThread()) {
	CellsRun r;
	Monitor monitor;
	std::vector<SurfaceView> views;
	for (const Mesh& m : operands) {
		views.push_back(viewOf(m.points, m.triangles));
	}
	MeshArrays arrays;
	r.status = joinSurfaces(views, 1, monitor, arrays);
	if (r.status.ok()) {
		r.status = arrangeCells(std::move(arrays), options, monitor, r.arrangement);
	}
	EXPECT_TRUE(r.status.ok()) << statusName(r.status.code) << ": " << describe(r.status);
	return r;
}

inline Block blockOf(const CellsRun& r, const CellPredicate& isInside) {
	Monitor monitor;
	Block block;
	const Status status = extractBlock(r.arrangement, isInside, monitor, block);
	EXPECT_TRUE(status.ok()) << statusName(status.code) << ": " << describe(status);
	return block;
}

// As the arrangement has it: no cut is merged away, nothing is copied.
inline Options asCut() {
	Options options = onOneThread();
	options.mergeFragments = false;
	options.weldNonManifold = true;
	return options;
}

// --- predicates ---------------------------------------------------------------------------------

inline bool isIn(const Windings& w, std::uint32_t operand) { return w[OperandId{operand}] != 0; }
inline std::ptrdiff_t insideCount(const Windings& w) {
	return std::count_if(w.begin(), w.end(), [](std::int32_t n) { return n != 0; });
}
inline bool inAny(const Windings& w) { return insideCount(w) > 0; }
inline bool inAll(const Windings& w) {
	return insideCount(w) == static_cast<std::ptrdiff_t>(w.size());
}
inline bool inOne(const Windings& w) { return insideCount(w) == 1; }
inline bool inTwoOrMore(const Windings& w) { return insideCount(w) >= 2; }
inline bool inOddNumber(const Windings& w) { return insideCount(w) % 2 != 0; }
inline bool inFirst(const Windings& w) { return isIn(w, 0); }
// In the first and in none of the others.
inline bool inFirstAlone(const Windings& w) { return isIn(w, 0) && insideCount(w) == 1; }
// Of the first operand's winding number.
inline CellPredicate atLeast(std::int32_t least) {
	return [least](const Windings& w) { return w[kFirst] >= least; };
}
inline bool oddWinding(const Windings& w) { return w[kFirst] % 2 != 0; }

// --- what a block is, by its coordinates alone --------------------------------------------------

// The volume as stored, computed in integers and rounded once.
inline double exactVolumeOf(const Block& block) {
	using Integer = boost::multiprecision::cpp_int;
	Integer six = 0;
	for (const IndexTriangle& t : block.triangles) {
		std::array<std::array<Integer, 3>, 3> p;
		for (std::size_t i = 0; i < 3; ++i) {
			for (std::size_t k = 0; k < 3; ++k) {
				p[i][k] = scaledToInteger(block.points[t[i]][k]);
			}
		}
		for (std::size_t k = 0; k < 3; ++k) {
			const std::size_t x = (k + 1) % 3, y = (k + 2) % 3;
			six += p[0][k] * (p[1][x] * p[2][y] - p[1][y] * p[2][x]);
		}
	}
	constexpr int kScale = 3 * 1100, kKept = 128;  // bits
	const Integer kept = six / (Integer(1) << (kScale - kKept));
	return std::ldexp(kept.convert_to<double>(), -kKept) / 6;
}

// Twice the area of the projections to the three coordinate planes.
inline double doubleProjectionsOf(const Block& block) {
	double sum = 0;
	for (const IndexTriangle& t : block.triangles) {
		const Point &a = block.points[t[0]], &b = block.points[t[1]], &c = block.points[t[2]];
		for (std::size_t k = 0; k < 3; ++k) {
			const std::size_t x = (k + 1) % 3, y = (k + 2) % 3;
			sum += std::fabs((b[x] - a[x]) * (c[y] - a[y]) - (b[y] - a[y]) * (c[x] - a[x]));
		}
	}
	return sum;
}

// How a block meets itself once points in one place are one.
class SelfContact {
public:
	explicit SelfContact(const Block& block) {
		for (const IndexTriangle& t : block.triangles) {
			Corners corners{block.points[t[0]], block.points[t[1]], block.points[t[2]]};
			for (std::size_t i = 0; i < 3; ++i) {
				facesAtEdge_[edge(corners[i], corners[(i + 1) % 3])].push_back(faces_.size());
				facesAtVertex_[corners[i]].push_back(faces_.size());
			}
			faces_.push_back(corners);
		}
	}

	std::size_t edgesOfMoreThanTwo() const {
		return static_cast<std::size_t>(
		    std::count_if(facesAtEdge_.begin(), facesAtEdge_.end(),
		                  [](const auto& entry) { return entry.second.size() > 2; }));
	}
	double lengthOfMoreThanTwo() const {
		double sum = 0;
		for (const auto& [ends, faces] : facesAtEdge_) {
			const auto& [p, q] = ends;
			sum += faces.size() > 2 ? std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]) : 0;
		}
		return sum;
	}

	// Vertices with more than one umbrella, at no edge of more than two faces; sorted.
	std::vector<Point> pinches() const {
		std::vector<Point> all;
		for (const auto& [vertex, faces] : facesAtVertex_) {
			bool isAtEdge = false;
			std::map<std::size_t, std::size_t> umbrellaOf;  // face to face; itself: a root
			for (const std::size_t face : faces) {
				umbrellaOf.emplace(face, face);
			}
			for (const std::size_t face : faces) {
				for (const Point& other : faces_[face]) {
					if (other != vertex) {
						const auto& both = facesAtEdge_.at(edge(vertex, other));
						isAtEdge = isAtEdge || both.size() > 2;
						umbrellaOf[rootOf(umbrellaOf, both.front())] =
						    rootOf(umbrellaOf, both.back());
					}
				}
			}
			const auto umbrellas =
			    std::count_if(umbrellaOf.begin(), umbrellaOf.end(),
			                  [](const auto& entry) { return entry.first == entry.second; });
			if (umbrellas > 1 && !isAtEdge) {
				all.push_back(vertex);
			}
		}
		return all;
	}

	// Of the surface, joined by common vertices.
	std::size_t components() const {
		std::map<std::size_t, std::size_t> partOf;
		for (std::size_t face = 0; face < faces_.size(); ++face) {
			partOf.emplace(face, face);
		}
		for (const auto& [vertex, faces] : facesAtVertex_) {
			for (const std::size_t face : faces) {
				partOf[rootOf(partOf, face)] = rootOf(partOf, faces.front());
			}
		}
		return static_cast<std::size_t>(
		    std::count_if(partOf.begin(), partOf.end(),
		                  [](const auto& entry) { return entry.first == entry.second; }));
	}

private:
	using Edge = std::pair<Point, Point>;

	static Edge edge(const Point& a, const Point& b) { return {std::min(a, b), std::max(a, b)}; }
	static std::size_t rootOf(std::map<std::size_t, std::size_t>& parent, std::size_t face) {
		while (parent[face] != face) {
			face = parent[face] = parent[parent[face]];
		}
		return face;
	}

	std::vector<Corners> faces_;
	std::map<Edge, std::vector<std::size_t>> facesAtEdge_;
	std::map<Point, std::vector<std::size_t>> facesAtVertex_;
};

}  // namespace index_boolean::shapes
