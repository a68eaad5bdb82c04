// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Small closed meshes for the tests, and checks that share no code with the core.
#pragma once

#include <vcg_ext/index_boolean.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace index_boolean::shapes {

struct Mesh {
	Points points;
	IndexTriangles triangles;
	std::vector<std::uint8_t> faux = {};  // as in MeshArrays
};

inline constexpr double kPi = 3.14159265358979323846;

inline Mesh box(Point low, Point high) {
	Mesh m;
	for (int i = 0; i < 8; ++i) {
		m.points.push_back({(i & 1) != 0 ? high[0] : low[0], (i & 2) != 0 ? high[1] : low[1],
		                    (i & 4) != 0 ? high[2] : low[2]});
	}
	m.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
	               {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
	return m;
}

// A box with integer corners: the low one's coordinates are below n, each side is at most n.
inline Mesh gridBox(std::mt19937& random, std::uint32_t n) {
	const auto step = [&] { return static_cast<double>(random() % n); };
	const Point low{step(), step(), step()};
	return box(low, {low[0] + 1 + step(), low[1] + 1 + step(), low[2] + 1 + step()});
}

// Latitude-longitude sphere with n rings and 2n sectors: 4n(n-1) faces.
inline Mesh sphere(std::uint32_t n, Point centre, double radius) {
	Mesh m;
	const std::uint32_t sectors = 2 * n;
	m.points.push_back({centre[0], centre[1], centre[2] + radius});
	for (std::uint32_t i = 1; i < n; ++i) {
		for (std::uint32_t j = 0; j < sectors; ++j) {
			const double t = kPi * i / n, p = 2 * kPi * j / sectors;
			m.points.push_back({centre[0] + radius * std::sin(t) * std::cos(p),
			                    centre[1] + radius * std::sin(t) * std::sin(p),
			                    centre[2] + radius * std::cos(t)});
		}
	}
	m.points.push_back({centre[0], centre[1], centre[2] - radius});
	const auto last = static_cast<std::uint32_t>(m.points.size() - 1);
	const auto id = [=](std::uint32_t i, std::uint32_t j) {
		return i == 0 ? 0 : i == n ? last : 1 + (i - 1) * sectors + j % sectors;
	};
	for (std::uint32_t i = 0; i < n; ++i) {
		for (std::uint32_t j = 0; j < sectors; ++j) {
			if (i > 0) {
				m.triangles.push_back({id(i, j), id(i + 1, j), id(i, j + 1)});
			}
			if (i + 1 < n) {
				m.triangles.push_back({id(i, j + 1), id(i + 1, j), id(i + 1, j + 1)});
			}
		}
	}
	return m;
}

// A torus around the z axis: 2*n*k faces.
inline Mesh torus(std::uint32_t n, std::uint32_t k, double major, double minor) {
	Mesh m;
	for (std::uint32_t i = 0; i < n; ++i) {
		for (std::uint32_t j = 0; j < k; ++j) {
			const double u = 2 * kPi * i / n, v = 2 * kPi * j / k;
			const double r = major + minor * std::cos(v);
			m.points.push_back({r * std::cos(u), r * std::sin(u), minor * std::sin(v)});
		}
	}
	for (std::uint32_t i = 0; i < n; ++i) {
		for (std::uint32_t j = 0; j < k; ++j) {
			const std::uint32_t a = i * k + j, b = (i + 1) % n * k + j;
			const std::uint32_t c = (i + 1) % n * k + (j + 1) % k, d = i * k + (j + 1) % k;
			m.triangles.push_back({a, b, c});
			m.triangles.push_back({a, c, d});
		}
	}
	return m;
}

// Rotated by a random rotation and moved by a random offset of the given size.
inline Mesh placed(Mesh m, std::mt19937& random, double offset) {
	std::normal_distribution<double> normal;
	std::array<double, 4> q{};
	for (double& c : q) {
		c = normal(random);
	}
	const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
	for (double& c : q) {
		c /= length;
	}
	std::uniform_real_distribution<double> uniform(-offset, offset);
	const Point move{uniform(random), uniform(random), uniform(random)};
	const double w = q[0], x = q[1], y = q[2], z = q[3];
	for (Point& p : m.points) {
		const Point r{(1 - 2 * (y * y + z * z)) * p[0] + 2 * (x * y - w * z) * p[1] +
		                  2 * (x * z + w * y) * p[2],
		              2 * (x * y + w * z) * p[0] + (1 - 2 * (x * x + z * z)) * p[1] +
		                  2 * (y * z - w * x) * p[2],
		              2 * (x * z - w * y) * p[0] + 2 * (y * z + w * x) * p[1] +
		                  (1 - 2 * (x * x + y * y)) * p[2]};
		p = {r[0] + move[0], r[1] + move[1], r[2] + move[2]};
	}
	return m;
}

// A needle with integer corners that is thinner than an ulp of its coordinates; its volume is 1/2.
inline Mesh needleThinnerThanAnUlp() {
	Mesh m;
	m.points = {{43673603679617., 80328280800392., -147746742945285.},
	            {84225035830001., 154913992859559., -284931255263928.},
	            {77707883588400., 142927081059868., -262883887154836.},
	            {46021191708474., 84646168368568., -155688576359935.}};
	m.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
	return m;
}

inline Mesh joined(const Mesh& a, const Mesh& b) {
	Mesh m = a;
	const auto offset = static_cast<std::uint32_t>(a.points.size());
	m.points.insert(m.points.end(), b.points.begin(), b.points.end());
	for (const auto& t : b.triangles) {
		m.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
	}
	if (!a.faux.empty() || !b.faux.empty()) {
		m.faux.resize(a.triangles.size());
		m.faux.insert(m.faux.end(), b.faux.begin(), b.faux.end());
		m.faux.resize(m.triangles.size());
	}
	return m;
}

inline Mesh turned(Mesh m) {
	for (auto& t : m.triangles) {
		std::swap(t[1], t[2]);
	}
	for (std::uint8_t& mask : m.faux) {
		mask = static_cast<std::uint8_t>((mask & 2) | (mask & 1) << 2 | mask >> 2);
	}
	return m;
}

// Every corner its own vertex, as in an STL file.
inline Mesh soup(const Mesh& m) {
	Mesh s;
	s.faux = m.faux;
	for (const auto& t : m.triangles) {
		const auto first = static_cast<std::uint32_t>(s.points.size());
		for (const std::uint32_t v : t) {
			s.points.push_back(m.points[v]);
		}
		s.triangles.push_back({first, first + 1, first + 2});
	}
	return s;
}

// Vertices and faces in random order, corners rotated.
inline Mesh permuted(const Mesh& m, std::mt19937& random) {
	std::vector<std::uint32_t> order(m.points.size());
	for (std::uint32_t i = 0; i < order.size(); ++i) {
		order[i] = i;
	}
	std::shuffle(order.begin(), order.end(), random);
	Mesh p;
	p.points.resize(m.points.size());
	for (std::uint32_t i = 0; i < order.size(); ++i) {
		p.points[order[i]] = m.points[i];
	}
	std::vector<std::uint32_t> faces(m.triangles.size());
	for (std::uint32_t i = 0; i < faces.size(); ++i) {
		faces[i] = i;
	}
	std::shuffle(faces.begin(), faces.end(), random);
	for (const std::uint32_t face : faces) {
		const auto& t = m.triangles[face];
		const std::size_t k = random() % 3;
		p.triangles.push_back({order[t[k]], order[t[(k + 1) % 3]], order[t[(k + 2) % 3]]});
		if (!m.faux.empty()) {
			const unsigned twice = m.faux[face] * 9U;  // the mask twice, end to end
			p.faux.push_back(static_cast<std::uint8_t>(twice >> k & 7U));
		}
	}
	return p;
}

inline MeshArrays arrays(const Mesh& a, const Mesh& b) {
	MeshArrays m;
	OperandId operand = kFirst;
	for (const Mesh* mesh : {&a, &b}) {
		const auto offset = static_cast<std::uint32_t>(m.points.size());
		m.points.insert(m.points.end(), mesh->points.begin(), mesh->points.end());
		for (const auto& t : mesh->triangles) {
			m.triangles.push_back(
			    {VertexId{t[0] + offset}, VertexId{t[1] + offset}, VertexId{t[2] + offset}});
		}
		if (!a.faux.empty() || !b.faux.empty()) {
			m.faux.insert(m.faux.end(), mesh->faux.begin(), mesh->faux.end());
			m.faux.resize(m.triangles.size());
		}
		m.vertexOffsets.setEnd(operand, m.points.size());
		m.faceOffsets.setEnd(operand, m.triangles.size());
		operand = otherOf(operand);
	}
	return m;
}

// Six times the signed volume, summed in long double about the first point.
inline double volumeOf(const Points& points, const IndexTriangles& triangles) {
	long double sum = 0;
	if (points.empty()) {
		return 0;
	}
	const Point& o = points[0];
	for (const auto& t : triangles) {
		std::array<std::array<long double, 3>, 3> d;
		for (std::size_t i = 0; i < 3; ++i) {
			for (std::size_t k = 0; k < 3; ++k) {
				d[i][k] = static_cast<long double>(points[t[i]][k]) - o[k];
			}
		}
		sum += d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) +
		       d[0][1] * (d[1][2] * d[2][0] - d[1][0] * d[2][2]) +
		       d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0]);
	}
	return static_cast<double>(sum / 6);
}

// Each directed edge occurs as often as its reverse, by index.
inline bool isClosed(const IndexTriangles& triangles) {
	std::map<std::pair<std::uint32_t, std::uint32_t>, int> balance;
	for (const auto& t : triangles) {
		for (std::size_t i = 0; i < 3; ++i) {
			const std::uint32_t u = t[i], v = t[(i + 1) % 3];
			balance[{std::min(u, v), std::max(u, v)}] += u < v ? 1 : -1;
		}
	}
	return std::all_of(balance.begin(), balance.end(), [](const auto& e) { return e.second == 0; });
}

// Whether each edge has one face each way, and the faces at each vertex form one umbrella.
inline bool isManifold(const IndexTriangles& triangles) {
	std::map<std::array<std::uint32_t, 2>, std::uint32_t> apexOf;  // per directed edge
	std::map<std::uint32_t, std::size_t> faceCount;
	for (const auto& t : triangles) {
		for (std::size_t i = 0; i < 3; ++i) {
			++faceCount[t[i]];
			if (!apexOf.emplace(std::array{t[i], t[(i + 1) % 3]}, t[(i + 2) % 3]).second) {
				return false;
			}
		}
	}
	for (const auto& [edge, apex] : apexOf) {
		std::size_t steps = 0;
		std::uint32_t neighbour = edge[1];
		do {
			const auto next = apexOf.find({edge[0], neighbour});
			if (next == apexOf.end()) {
				return false;
			}
			neighbour = next->second;
			++steps;
		} while (neighbour != edge[1] && steps <= faceCount[edge[0]]);
		if (steps != faceCount[edge[0]]) {
			return false;
		}
	}
	return true;
}

// Every triangle by coordinates, smallest corner first, sorted: equal for equal geometry.
inline std::vector<std::array<Point, 3>> geometry(const Block& block) {
	std::vector<std::array<Point, 3>> all;
	for (const auto& t : block.triangles) {
		std::array<Point, 3> c{block.points[t[0]], block.points[t[1]], block.points[t[2]]};
		std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
		all.push_back(c);
	}
	std::sort(all.begin(), all.end());
	return all;
}

// A whole run: the arrangement and all five blocks.
struct BooleanRun {
	Status status;
	Arrangement arrangement;
	std::vector<Block> blocks;
	Audit audit;

	const Block& block(Operation operation) const {
		return blocks[static_cast<std::size_t>(operation)];
	}
	double volume(Operation operation) const {
		return volumeOf(block(operation).points, block(operation).triangles);
	}
};

inline BooleanRun run(const Mesh& a, const Mesh& b, Options options = {}) {
	BooleanRun r;
	Monitor monitor;
	r.status = arrange(arrays(a, b), options, monitor, r.arrangement);
	for (int k = 0; k < kOperationCount && r.status.ok(); ++k) {
		r.blocks.emplace_back();
		r.status = extractBlock(r.arrangement, static_cast<Operation>(k), monitor, r.blocks.back());
	}
	if (r.status.ok()) {
		r.status = audit(r.arrangement, r.blocks, monitor, r.audit);
	}
	return r;
}

}  // namespace index_boolean::shapes
