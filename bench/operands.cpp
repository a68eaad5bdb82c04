// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "operands.h"

#include <vcg/complex/algorithms/clean.h>
#include <vcg/complex/complex.h>
#include <wrap/io_trimesh/import.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace index_boolean_bench {

namespace {

class FileVertex;
class FileFace;
struct FileTypes
    : vcg::UsedTypes<vcg::Use<FileVertex>::AsVertexType, vcg::Use<FileFace>::AsFaceType> {};
class FileVertex : public vcg::Vertex<FileTypes, vcg::vertex::Coord3d, vcg::vertex::Normal3d,
                                      vcg::vertex::BitFlags> {};
class FileFace
    : public vcg::Face<FileTypes, vcg::face::VertexRef, vcg::face::Normal3d, vcg::face::BitFlags> {
};
class FileMesh : public vcg::tri::TriMesh<std::vector<FileVertex>, std::vector<FileFace>> {};

constexpr double kFullTurn = 6.283185307179586;

using Importer = vcg::tri::io::Importer<FileMesh>;

// The corners of an icosahedron, and its faces counter-clockwise from outside.
constexpr double kGolden = 1.6180339887498949;
constexpr std::array<Point, 12> kIcosahedronPoints{{
    {-1, kGolden, 0},
    {1, kGolden, 0},
    {-1, -kGolden, 0},
    {1, -kGolden, 0},
    {0, -1, kGolden},
    {0, 1, kGolden},
    {0, -1, -kGolden},
    {0, 1, -kGolden},
    {kGolden, 0, -1},
    {kGolden, 0, 1},
    {-kGolden, 0, -1},
    {-kGolden, 0, 1},
}};
constexpr std::array<std::array<std::size_t, 3>, 20> kIcosahedronFaces{{
    {0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
    {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
    {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1},
}};

// A point of the subdivided icosahedron: corners and their weights, sorted, unused ones zero.
// Neighbouring faces name their common points alike, so that one map joins them.
using Weights = std::array<std::pair<std::size_t, std::size_t>, 3>;

Point onUnitSphere(const Weights& weights) {
	Point p{0, 0, 0};
	for (const auto& [corner, weight] : weights) {
		for (std::size_t i = 0; i < 3; ++i) {
			p[i] += static_cast<double>(weight) * kIcosahedronPoints[corner][i];
		}
	}
	const double length = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
	return {p[0] / length, p[1] / length, p[2] / length};
}

// Adds an axis-parallel box, its walls across x first.
void addBox(const Point& low, const Point& high, Surface& surface) {
	const Surface cube = makeCube(1);
	const auto first = static_cast<std::uint32_t>(surface.points.size());
	for (const Point& p : cube.points) {
		surface.points.push_back({p[0] < 0 ? low[0] : high[0], p[1] < 0 ? low[1] : high[1],
		                          p[2] < 0 ? low[2] : high[2]});
	}
	constexpr std::size_t kFaces = 12, kFirstAcrossX = 8;
	for (std::size_t i = 0; i < kFaces; ++i) {
		const auto& face = cube.triangles[(kFirstAcrossX + i) % kFaces];
		surface.triangles.push_back({first + face[0], first + face[1], first + face[2]});
	}
}

// Adds the top of a plate, vertices row by row along y, and marks its edges as faux but those
// around it.
void addPolygonTop(std::uint32_t n, double z, Surface& plate) {
	for (std::uint32_t i = 0; i <= n; ++i) {
		for (std::uint32_t j = 0; j <= n; ++j) {
			plate.points.push_back(
			    {static_cast<double>(i) / n - 0.5, static_cast<double>(j) / n - 0.5, z});
		}
	}
	const auto mask = [](bool first, bool second, bool third) {
		return static_cast<std::uint8_t>((first ? 1 : 0) | (second ? 2 : 0) | (third ? 4 : 0));
	};
	for (std::uint32_t i = 0; i < n; ++i) {
		for (std::uint32_t j = 0; j < n; ++j) {
			const std::uint32_t a = i * (n + 1) + j, b = a + n + 1;
			plate.triangles.push_back({a, b, b + 1});
			plate.faux.push_back(mask(j > 0, i + 1 < n, true));
			plate.triangles.push_back({a, b + 1, a + 1});
			plate.faux.push_back(mask(true, j + 1 < n, i > 0));
		}
	}
}

}  // namespace

Surface readSurface(const std::string& path) {
	FileMesh mesh;
	const int error = Importer::Open(mesh, path.c_str());
	if (error != 0 && Importer::ErrorCritical(error)) {
		throw std::runtime_error(path + ": " + Importer::ErrorMsg(error));
	}
	if (mesh.fn == 0) {
		throw std::runtime_error(path + ": has no face");
	}
	vcg::tri::Clean<FileMesh>::RemoveDuplicateVertex(mesh);
	vcg::tri::Allocator<FileMesh>::CompactEveryVector(mesh);

	Surface surface;
	for (const FileVertex& vertex : mesh.vert) {
		surface.points.push_back({vertex.cP()[0], vertex.cP()[1], vertex.cP()[2]});
	}
	const auto index = [&](const FileVertex* vertex) {
		return static_cast<std::uint32_t>(vcg::tri::Index(mesh, vertex));
	};
	for (const FileFace& face : mesh.face) {
		surface.triangles.push_back({index(face.cV(0)), index(face.cV(1)), index(face.cV(2))});
	}
	return surface;
}

Surface makeSphere(std::size_t faces) {
	const double perFace = static_cast<double>(faces) / 20;
	const auto frequency = static_cast<std::size_t>(std::max(1.0, std::round(std::sqrt(perFace))));
	Surface sphere;
	std::map<Weights, std::uint32_t> numbers;
	const auto vertexAt = [&](const auto& face, std::size_t i, std::size_t j) {
		Weights weights{{{face[0], frequency - i - j}, {face[1], i}, {face[2], j}}};
		for (auto& [corner, weight] : weights) {
			corner = weight == 0 ? 0 : corner;
		}
		std::sort(weights.begin(), weights.end());
		const auto [entry, isNew] =
		    numbers.try_emplace(weights, static_cast<std::uint32_t>(sphere.points.size()));
		if (isNew) {
			sphere.points.push_back(onUnitSphere(weights));
		}
		return entry->second;
	};
	for (const auto& face : kIcosahedronFaces) {
		for (std::size_t i = 0; i < frequency; ++i) {
			for (std::size_t j = 0; i + j < frequency; ++j) {
				const std::uint32_t a = vertexAt(face, i + 1, j), b = vertexAt(face, i, j + 1);
				sphere.triangles.push_back({vertexAt(face, i, j), a, b});
				if (i + j + 1 < frequency) {
					sphere.triangles.push_back({a, vertexAt(face, i + 1, j + 1), b});
				}
			}
		}
	}
	return sphere;
}

Surface makeTerrain(std::size_t faces, int octaves, double height) {
	const double perSide = std::sqrt(static_cast<double>(faces) / 2);
	const auto n = static_cast<std::uint32_t>(std::max(1.0, std::round(perSide)));
	const auto heightAt = [=](double x, double y) {
		double z = 0, scale = 1;
		for (int octave = 0; octave < octaves; ++octave, scale *= 2) {
			const double turn = 0.7 * octave, phase = 1.3 * octave;
			const double u = std::cos(turn) * x - std::sin(turn) * y;
			const double v = std::sin(turn) * x + std::cos(turn) * y;
			z += height / scale * std::sin(9 * scale * u + phase) * std::sin(7 * scale * v - phase);
		}
		return z;
	};
	Surface terrain;
	for (std::uint32_t i = 0; i <= n; ++i) {
		for (std::uint32_t j = 0; j <= n; ++j) {
			const double x = static_cast<double>(i) / n, y = static_cast<double>(j) / n;
			terrain.points.push_back({x, y, heightAt(x, y)});
		}
	}
	for (std::uint32_t i = 0; i < n; ++i) {
		for (std::uint32_t j = 0; j < n; ++j) {
			const std::uint32_t a = i * (n + 1) + j, b = a + n + 1;
			terrain.triangles.push_back({a, b, b + 1});
			terrain.triangles.push_back({a, b + 1, a + 1});
		}
	}
	return terrain;
}

Surface makeCube(double side) {
	Surface cube;
	const double h = side / 2;
	for (unsigned i = 0; i < 8; ++i) {
		cube.points.push_back(
		    {(i & 1U) != 0 ? h : -h, (i & 2U) != 0 ? h : -h, (i & 4U) != 0 ? h : -h});
	}
	cube.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
	                  {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
	return cube;
}

Surface makeGridBox(std::uint32_t n) {
	Surface box;
	std::map<Point, std::uint32_t> numbers;
	const auto vertexAt = [&](const Point& p) {
		const auto [entry, isNew] =
		    numbers.try_emplace(p, static_cast<std::uint32_t>(box.points.size()));
		if (isNew) {
			box.points.push_back(p);
		}
		return entry->second;
	};
	const auto onWall = [&](std::size_t axis, bool upper, std::uint32_t i, std::uint32_t j) {
		Point p{};
		p[axis] = upper ? 1 : -1;
		p[(axis + (upper ? 1 : 2)) % 3] = 2.0 * i / n - 1;
		p[(axis + (upper ? 2 : 1)) % 3] = 2.0 * j / n - 1;
		return vertexAt(p);
	};
	for (std::size_t wall = 0; wall < 6; ++wall) {
		const std::size_t axis = wall / 2;
		const bool upper = wall % 2 == 1;
		for (std::uint32_t i = 0; i < n; ++i) {
			for (std::uint32_t j = 0; j < n; ++j) {
				const std::uint32_t a = onWall(axis, upper, i, j);
				const std::uint32_t b = onWall(axis, upper, i + 1, j + 1);
				box.triangles.push_back({a, onWall(axis, upper, i + 1, j), b});
				box.triangles.push_back({a, b, onWall(axis, upper, i, j + 1)});
			}
		}
	}
	return box;
}

Surface makePrisms(std::uint32_t count, std::uint32_t sides) {
	const auto perRow = static_cast<std::uint32_t>(std::ceil(std::sqrt(count)));
	const double cell = 1.0 / perRow;
	Surface prisms;
	for (std::uint32_t prism = 0; prism < count; ++prism) {
		const double x = (prism % perRow + 0.5) * cell - 0.5;
		const double y = (prism / perRow + 0.5) * cell - 0.5;
		const auto bottom = static_cast<std::uint32_t>(prisms.points.size());
		const std::uint32_t top = bottom + sides;
		for (const double z : {-1.0, 1.0}) {
			for (std::uint32_t i = 0; i < sides; ++i) {
				const double angle = kFullTurn * i / sides + 0.1 * prism;
				prisms.points.push_back(
				    {x + 0.35 * cell * std::cos(angle), y + 0.35 * cell * std::sin(angle), z});
			}
		}
		for (std::uint32_t i = 0; i < sides; ++i) {
			const std::uint32_t next = (i + 1) % sides;
			prisms.triangles.push_back({bottom + i, bottom + next, top + next});
			prisms.triangles.push_back({bottom + i, top + next, top + i});
			if (i >= 2) {
				prisms.triangles.push_back({bottom, bottom + i, bottom + i - 1});
				prisms.triangles.push_back({top, top + i - 1, top + i});
			}
		}
	}
	return prisms;
}

Surface makeTower(std::uint32_t count) {
	Surface tower;
	for (std::uint32_t i = 0; i < count; ++i) {
		const double half = i % 2 == 0 ? 1 : 0.5;
		addBox({-half, -half, 1.0 * i}, {half, half, 1.0 * i + 1}, tower);
	}
	return tower;
}

Surface makeWall(std::uint32_t n) {
	constexpr double kPitch = 1.25;
	Surface wall;
	for (std::uint32_t i = 0; i < n; ++i) {
		for (std::uint32_t j = 0; j < n; ++j) {
			const double y = kPitch * i, z = kPitch * j;
			addBox({0, y, z}, {1, y + 1, z + 1}, wall);
		}
	}
	return wall;
}

Surface makeRow(std::uint32_t count) {
	Surface row;
	for (std::uint32_t i = 0; i < count; ++i) {
		addBox({2.0 * i, 0, 0}, {2.0 * i + 1, 1, 1}, row);
	}
	return row;
}

Surface makeCone(std::uint32_t sides) {
	Surface cone;
	cone.points = {{0, 0, 0}, {0, 0, 1}};
	for (std::uint32_t i = 0; i < sides; ++i) {
		const double angle = kFullTurn * i / sides;
		cone.points.push_back({std::cos(angle), std::sin(angle), 1});
		const std::uint32_t here = 2 + i, next = 2 + (i + 1) % sides;
		cone.triangles.push_back({0, next, here});
		cone.triangles.push_back({1, here, next});
	}
	return cone;
}

Surface makePolygonPlate(std::uint32_t n) {
	constexpr double kHalf = 0.05;
	Surface plate;
	addPolygonTop(n, kHalf, plate);
	std::vector<std::uint32_t> rim;  // of the top, counter-clockwise
	const std::uint32_t row = n + 1;
	for (std::uint32_t side = 0; side < 4; ++side) {
		for (std::uint32_t i = 0; i < n; ++i) {
			const std::array<std::uint32_t, 4> around{i * row, n * row + i, (n - i) * row + n,
			                                          n - i};
			rim.push_back(around[side]);
		}
	}
	const auto below = static_cast<std::uint32_t>(plate.points.size());  // the first corner
	const auto count = static_cast<std::uint32_t>(rim.size());
	for (const std::uint32_t corner : rim) {
		plate.points.push_back({plate.points[corner][0], plate.points[corner][1], -kHalf});
	}
	plate.points.push_back({0, 0, -kHalf});
	for (std::uint32_t i = 0; i < count; ++i) {
		const std::uint32_t next = (i + 1) % count;
		plate.triangles.push_back({rim[i], below + i, below + next});
		plate.triangles.push_back({rim[i], below + next, rim[next]});
		plate.triangles.push_back({below + count, below + next, below + i});
	}
	plate.faux.resize(plate.triangles.size());
	return plate;
}

Surface makePinwheel(std::uint32_t count) {
	constexpr double kWidth = 0.4;  // of a tetrahedron, of the angle from one to the next
	Surface pinwheel;
	pinwheel.points = {{0, 0, -1}, {0, 0, 1}};
	for (std::uint32_t i = 0; i < count; ++i) {
		const auto p = static_cast<std::uint32_t>(pinwheel.points.size()), q = p + 1;
		for (const double along : {0.0, kWidth}) {
			const double angle = kFullTurn * (i + along) / count;
			pinwheel.points.push_back({std::cos(angle), std::sin(angle), 0});
		}
		pinwheel.triangles.insert(pinwheel.triangles.end(),
		                          {{0, p, 1}, {0, 1, q}, {0, q, p}, {1, p, q}});
	}
	return pinwheel;
}

void transform(const Matrix& m, Surface& surface) {
	for (Point& p : surface.points) {
		p = {m[0] * p[0] + m[1] * p[1] + m[2] * p[2] + m[3],
		     m[4] * p[0] + m[5] * p[1] + m[6] * p[2] + m[7],
		     m[8] * p[0] + m[9] * p[1] + m[10] * p[2] + m[11]};
	}
}

void normalize(Surface& surface) {
	Point low = surface.points.front(), high = low;
	for (const Point& p : surface.points) {
		for (std::size_t i = 0; i < 3; ++i) {
			low[i] = std::min(low[i], p[i]);
			high[i] = std::max(high[i], p[i]);
		}
	}
	const double side = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
	for (Point& p : surface.points) {
		for (std::size_t i = 0; i < 3; ++i) {
			p[i] = (p[i] - (low[i] + high[i]) / 2) / side;
		}
	}
}

Matrix standardRotation(const Point& translation) {
	const double length = std::sqrt(14.0), cosine = std::cos(0.7), sine = std::sin(0.7);
	const Point n{1 / length, 2 / length, 3 / length};
	const std::array<Point, 3> cross{{{0, -n[2], n[1]}, {n[2], 0, -n[0]}, {-n[1], n[0], 0}}};
	Matrix matrix{};
	for (std::size_t row = 0; row < 3; ++row) {
		for (std::size_t column = 0; column < 3; ++column) {
			matrix[4 * row + column] = (row == column ? cosine : 0) + sine * cross[row][column] +
			                           (1 - cosine) * n[row] * n[column];
		}
		matrix[4 * row + 3] = translation[row];
	}
	return matrix;
}

}  // namespace index_boolean_bench
