// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Closed triangle meshes with small integer coordinates, and whether one is a valid operand:
// integer arithmetic only, no code of the core.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace index_boolean::grid {

using IntPoint = std::array<std::int64_t, 3>;
using Corners = std::array<std::uint32_t, 3>;

struct GridMesh {
	std::vector<IntPoint> points;
	IndexTriangles triangles;

	const IntPoint& corner(std::size_t face, std::size_t i) const {
		return points[triangles[face][i]];
	}
};

inline IntPoint operator-(const IntPoint& a, const IntPoint& b) {
	return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline IntPoint operator+(const IntPoint& a, const IntPoint& b) {
	return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

inline std::int64_t dot(const IntPoint& a, const IntPoint& b) {
	return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline IntPoint cross(const IntPoint& a, const IntPoint& b) {
	return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline IntPoint normal(const IntPoint& a, const IntPoint& b, const IntPoint& c) {
	return cross(b - a, c - a);
}

inline int signOf(std::int64_t n) { return n < 0 ? -1 : n > 0 ? 1 : 0; }

// The side of the plane a b c on which p lies: 1 where the normal points.
inline int sideOf(const IntPoint& a, const IntPoint& b, const IntPoint& c, const IntPoint& p) {
	return signOf(dot(normal(a, b, c), p - a));
}

// Six times the signed volume.
inline std::int64_t sixVolume(const GridMesh& m) {
	std::int64_t sum = 0;
	for (const Corners& t : m.triangles) {
		sum += dot(m.points[t[0]], cross(m.points[t[1]], m.points[t[2]]));
	}
	return sum;
}

inline GridMesh turned(GridMesh m) {
	for (Corners& t : m.triangles) {
		std::swap(t[1], t[2]);
	}
	return m;
}

// Builds a mesh from corners given by their places, each place one vertex.
class GridMeshBuilder {
public:
	void add(const IntPoint& a, const IntPoint& b, const IntPoint& c) {
		mesh_.triangles.push_back({vertexAt(a), vertexAt(b), vertexAt(c)});
	}
	void add(const GridMesh& m) {
		for (std::size_t f = 0; f < m.triangles.size(); ++f) {
			add(m.corner(f, 0), m.corner(f, 1), m.corner(f, 2));
		}
	}
	// A convex quadrilateral, across the diagonal a c or b d.
	void addQuad(const IntPoint& a, const IntPoint& b, const IntPoint& c, const IntPoint& d,
	             bool acrossAC) {
		if (acrossAC) {
			add(a, b, c);
			add(a, c, d);
		} else {
			add(a, b, d);
			add(b, c, d);
		}
	}
	const GridMesh& mesh() const { return mesh_; }

private:
	std::uint32_t vertexAt(const IntPoint& p) {
		const auto next = static_cast<std::uint32_t>(mesh_.points.size());
		const auto [place, isNew] = ids_.emplace(p, next);
		if (isNew) {
			mesh_.points.push_back(p);
		}
		return place->second;
	}

	GridMesh mesh_;
	std::map<IntPoint, std::uint32_t> ids_;
};

// Both surfaces as one; equal places stay two vertices.
inline GridMesh concatenated(GridMesh a, const GridMesh& b) {
	const auto offset = static_cast<std::uint32_t>(a.points.size());
	a.points.insert(a.points.end(), b.points.begin(), b.points.end());
	for (const Corners& t : b.triangles) {
		a.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
	}
	return a;
}

// The same surface without vertices that no face uses.
inline GridMesh withoutLooseVertices(const GridMesh& m) {
	GridMeshBuilder builder;
	builder.add(m);
	return builder.mesh();
}

// Whether the closed segment p q and the closed triangle a b c of one plane meet, projected along
// an axis on which the triangle has area.
inline bool meetInPlane(const IntPoint& p, const IntPoint& q, const std::array<IntPoint, 3>& t,
                        const IntPoint& n) {
	// Signs of 2D orientations are those of 3D ones with a point off the plane.
	const auto side = [&n](const IntPoint& a, const IntPoint& b, const IntPoint& c) {
		return signOf(dot(n, normal(a, b, c)));
	};
	for (const IntPoint& end : {p, q}) {
		if (side(t[0], t[1], end) >= 0 && side(t[1], t[2], end) >= 0 &&
		    side(t[2], t[0], end) >= 0) {
			return true;
		}
	}
	for (std::size_t i = 0; i < 3; ++i) {
		const IntPoint &a = t[i], &b = t[(i + 1) % 3];
		// Ends inside the triangle are done with; what is left to find crosses an edge.
		if (side(p, q, a) * side(p, q, b) <= 0 && side(a, b, p) * side(a, b, q) < 0) {
			return true;
		}
	}
	return false;
}

// Whether a closed segment and a closed triangle (with area) have a point in common.
inline bool meet(const IntPoint& p, const IntPoint& q, const std::array<IntPoint, 3>& t) {
	const IntPoint n = normal(t[0], t[1], t[2]);
	const std::int64_t heightP = dot(n, p - t[0]), heightQ = dot(n, q - t[0]);
	if (heightP == 0 && heightQ == 0) {
		return meetInPlane(p, q, t, n);
	}
	if (signOf(heightP) * signOf(heightQ) > 0) {
		return false;
	}
	const int a = sideOf(p, q, t[0], t[1]), b = sideOf(p, q, t[1], t[2]),
	          c = sideOf(p, q, t[2], t[0]);
	return (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
}

inline bool boxesMeet(const std::array<IntPoint, 3>& s, const std::array<IntPoint, 3>& t) {
	for (std::size_t k = 0; k < 3; ++k) {
		const auto [lowS, highS] = std::minmax({s[0][k], s[1][k], s[2][k]});
		const auto [lowT, highT] = std::minmax({t[0][k], t[1][k], t[2][k]});
		if (highS < lowT || highT < lowS) {
			return false;
		}
	}
	return true;
}

// Two triangles with these corners in common (the first `common` of each, in the same order):
// whether they meet in nothing else.
inline bool meetInCommonSimplexOnly(const std::array<IntPoint, 3>& s,
                                    const std::array<IntPoint, 3>& t, std::size_t common) {
	if (common == 3) {
		return false;
	}
	if (common == 2) {
		const IntPoint n = normal(s[0], s[1], s[2]);
		return dot(n, t[2] - s[0]) != 0 || dot(n, normal(s[0], s[1], t[2])) < 0;
	}
	if (common == 1) {
		// Both are cones from the corner: another common point leads to one on an opposite edge.
		return !meet(s[1], s[2], t) && !meet(t[1], t[2], s);
	}
	for (std::size_t i = 0; i < 3; ++i) {
		if (meet(s[i], s[(i + 1) % 3], t) || meet(t[i], t[(i + 1) % 3], s)) {
			return false;
		}
	}
	return true;
}

// Whether two faces meet in a common simplex or not at all.
inline bool meetRightly(const GridMesh& m, std::size_t f, std::size_t g) {
	std::array<IntPoint, 3> s{m.corner(f, 0), m.corner(f, 1), m.corner(f, 2)};
	std::array<IntPoint, 3> t{m.corner(g, 0), m.corner(g, 1), m.corner(g, 2)};
	if (!boxesMeet(s, t)) {
		return true;
	}
	std::size_t common = 0;
	for (std::size_t i = 0; i < 3; ++i) {
		const auto twin = std::find(t.begin() + static_cast<std::ptrdiff_t>(common), t.end(), s[i]);
		if (twin != t.end()) {
			std::swap(t[common], *twin);
			std::swap(s[common], s[i]);
			++common;
		}
	}
	return meetInCommonSimplexOnly(s, t, common);
}

// A face's sides run each way equally often.
inline bool isClosed(const GridMesh& m) {
	std::map<std::pair<std::uint32_t, std::uint32_t>, int> balance;
	for (const Corners& t : m.triangles) {
		for (std::size_t i = 0; i < 3; ++i) {
			const std::uint32_t u = t[i], v = t[(i + 1) % 3];
			balance[{std::min(u, v), std::max(u, v)}] += u < v ? 1 : -1;
		}
	}
	return std::all_of(balance.begin(), balance.end(), [](const auto& e) { return e.second == 0; });
}

// Whether each place is one vertex, every face has area, and any two faces meet in a common corner,
// a common edge, or not at all. O(n^2).
inline bool isEmbedded(const GridMesh& m) {
	if (std::set<IntPoint>(m.points.begin(), m.points.end()).size() != m.points.size()) {
		return false;
	}
	for (std::size_t f = 0; f < m.triangles.size(); ++f) {
		if (normal(m.corner(f, 0), m.corner(f, 1), m.corner(f, 2)) == IntPoint{}) {
			return false;
		}
		for (std::size_t g = 0; g < f; ++g) {
			if (!meetRightly(m, f, g)) {
				return false;
			}
		}
	}
	return true;
}

// "points (0 0 1) (2 0 1) ... faces 0 1 2, 0 2 3, ..."
inline std::string text(const GridMesh& m) {
	std::string s = "points";
	for (const IntPoint& p : m.points) {
		s += " (" + std::to_string(p[0]) + ' ' + std::to_string(p[1]) + ' ' + std::to_string(p[2]) +
		     ')';
	}
	s += " faces";
	for (const Corners& t : m.triangles) {
		s += (&t == m.triangles.data() ? " " : ", ") + std::to_string(t[0]) + ' ' +
		     std::to_string(t[1]) + ' ' + std::to_string(t[2]);
	}
	return s;
}

}  // namespace index_boolean::grid
