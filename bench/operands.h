// SPDX-FileCopyrightText: 2026 The Index Boolean authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the benchmark intersects: surfaces from files (read by vcglib) or made here, and placed.
// in: a path or a size; out: plain arrays. Guarantee: the same arrays on every run and machine, so
// that every peer can be given exactly what the core was given.
#pragma once

#include <vcg_ext/base/mesh_types.h>

#include <string>
#include <vector>

namespace index_boolean_bench {

using index_boolean::Point;

struct Surface {
	std::vector<Point> points;
	std::vector<std::array<std::uint32_t, 3>> triangles;
	std::vector<std::uint8_t> faux;  // as in MeshArrays; empty if no edge lies inside a polygon
};

// The upper three rows of an affine matrix, row by row.
using Matrix = std::array<double, 12>;

// Reads any format of vcglib's importer (PLY, STL, OBJ, OFF, VMI). Vertices at exactly one place
// are merged, since STL files have three for each face.
// Throws std::runtime_error with a sentence if the file cannot be read or has no face.
Surface readSurface(const std::string& path);

// A unit sphere: an icosahedron with each face cut into f * f, f chosen so that 20 * f * f is
// nearest to `faces` (328000 gives 327680). Faces of nearly one size, so no place is special.
Surface makeSphere(std::size_t faces);

// An axis-parallel cube around the origin, 12 triangles.
Surface makeCube(double side);

// A height field over the unit square with about this many faces: hills of several sizes.
// \param octaves how many sizes of hills, each half as large as the one before
// \param height  of the largest hills
Surface makeTerrain(std::size_t faces, int octaves, double height);

// A cube of side 2 around the origin, each wall cut into n * n squares of two triangles.
Surface makeGridBox(std::uint32_t n);

// Upright prisms with regular bases of `sides` sides, each 4 * sides - 4 triangles, beside each
// other in a square grid over the unit square around the origin; each is turned a little further
// than the one before. From z = -1 to 1.
Surface makePrisms(std::uint32_t count, std::uint32_t sides);

// Boxes of height 1 on each other from z = 0 up, 12 triangles each, of widths 2 and 1 in turn: all
// corners of the small ones lie in walls of the large ones.
Surface makeTower(std::uint32_t count);

// n * n unit cubes with gaps, 12 triangles each, from x = 0 to 1: beside each other along y, above
// each other along z.
Surface makeWall(std::uint32_t n);

// Unit cubes in a row along x, a unit apart, 12 triangles each; the first two of each lie across
// the row.
Surface makeRow(std::uint32_t count);

// A cone on its tip, which is the origin, up to a disk of radius 1 at z = 1: 2 * sides triangles.
Surface makeCone(std::uint32_t sides);

// A plate over the unit square around the origin, from z = -0.05 to 0.05. Its top is one polygon,
// of n * n squares of two triangles; 12 * n triangles more.
Surface makePolygonPlate(std::uint32_t n);

// Tetrahedra round the z axis that all have its edge from z = -1 to 1 and nothing else in common, 4
// triangles each.
Surface makePinwheel(std::uint32_t count);

void transform(const Matrix& matrix, Surface& surface);

// The standard placement: the centre of the bounding box to the origin, its longest side to 1.
void normalize(Surface& surface);

// The standard rotation, by 0.7 rad about (1, 2, 3), followed by a translation.
Matrix standardRotation(const Point& translation = {0, 0, 0});

}  // namespace index_boolean_bench
