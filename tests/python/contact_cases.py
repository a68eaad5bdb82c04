# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pairs of solids that touch, share walls, coincide, or nearly do: one line a case.

out: CASE_NAMES, load_case(name). Where a closed form tells the volume that both operands share, the
volumes of all blocks follow from it. Guarantee: each operand, as the oracles are given it, is
closed and right side out, and meets itself at most in common vertices and edges.
"""

import dataclasses
import functools
import math
from fractions import Fraction
from typing import Optional

import numpy as np

import placements
from conftest import box, joined, sphere
from mesh_laws import area, exact_volume, reversed_faces, volume, welded
from shapes import make_samples


@dataclasses.dataclass(frozen=True)
class Case:
    """Two operands, and what is known of their blocks."""

    name: str
    first: tuple
    second: tuple
    # The volume of the intersection; None: only the oracles tell.
    shared: Optional[float] = None
    # Every vertex of every block is a double: the volumes are exactly the expected ones.
    exact: bool = False
    # Of volumes, absolute; None: relative to V(A) + V(B).
    tolerance: Optional[float] = None
    # The operands as the oracles are given them, if not as the filter.
    solids: Optional[tuple] = None
    # libigl's figures, {block: (volume, area, faces)}, if asking it each time takes too long.
    libigl: Optional[dict] = None
    # manifold3d merges what is nearly the same; it is asked where nothing is.
    manifold3d: bool = True
    # Blocks no thicker than the spacing of their coordinates have no area to compare.
    compare_areas: bool = True


# --- shapes ---------------------------------------------------------------------------------------


def shifted(mesh, *shift):
    """The mesh moved; coordinates are rounded."""
    return mesh[0] + np.array(shift, dtype=np.float64), mesh[1]


def scaled(mesh, factor):
    """The mesh scaled; coordinates are rounded."""
    return mesh[0] * factor, mesh[1]


def rotated(mesh, axis, angle):
    """The mesh turned about an axis through the origin; coordinates are rounded."""
    rows = [(*row, 0.0) for row in placements.rotation(axis, angle)]
    return placements.affine(mesh[0], rows), mesh[1]


def mirrored(mesh, *order):
    """The mesh with two axes exchanged."""
    return mesh[0][:, order], reversed_faces(mesh[1])


def inside_out(mesh):
    """The mesh with all faces turned over."""
    return mesh[0], reversed_faces(mesh[1])


def with_seams(mesh, parts):
    """The mesh with vertices of its own for each part; parts numbers the faces."""
    vertices, faces = mesh
    keys = np.repeat(np.asarray(parts), 3) * len(vertices) + faces.ravel()
    kept, corners = np.unique(keys, return_inverse=True)
    return vertices[kept % len(vertices)], corners.reshape(-1, 3)


def soup(mesh):
    """The mesh with three vertices of its own for each face, as STL files have them."""
    return with_seams(mesh, np.arange(len(mesh[1])))


def with_negative_zeros(mesh, stride=1):
    """The mesh with -0.0 for 0.0 in every stride-th vertex."""
    vertices = mesh[0].copy()
    chosen = vertices[::stride]
    chosen[chosen == 0] = -0.0
    return vertices, mesh[1]


def with_faces(mesh, *faces):
    """The mesh with more faces."""
    return mesh[0], np.vstack([mesh[1], faces])


def prism(profile, half_length):
    """A prism along x; its profile of (y, z) runs counter-clockwise around (0, 0)."""
    sides = len(profile)
    ends = [np.insert(np.array(profile, float), 0, x, axis=1) for x in (-half_length, half_length)]
    k = np.arange(sides)
    after, low, high = (k + 1) % sides, np.full(sides, 2 * sides), np.full(sides, 2 * sides + 1)
    faces = [
        make_samples.quads(k, after, sides + after, sides + k),
        np.stack([low, after, k], axis=1),
        np.stack([high, sides + k, sides + after], axis=1),
    ]
    middles = [(-half_length, 0, 0), (half_length, 0, 0)]
    return np.concatenate([*ends, middles]), np.concatenate(faces)


def tetrahedron(*corners):
    """Four corners in any order."""
    faces = np.array([(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)])
    mesh = np.array(corners, dtype=np.float64), faces
    return mesh if volume(*mesh) > 0 else inside_out(mesh)


def boxes_of_one_colour(size, colour):
    """A checkerboard of size^3 unit boxes: those of colour 0 or 1, each with its own vertices."""
    places = [place for place in np.ndindex(size, size, size) if sum(place) % 2 == colour]
    return joined(*[box(place, np.add(place, 1)) for place in places])


def cube_with_split_edge(flat_face):
    """CUBE with a vertex in the middle of an edge. With flat_face, the face on one side keeps the
    whole edge, and a face without area lies between it and the two on the other side."""
    vertices = np.vstack([CUBE[0], (0, 1, 2)])
    one_side = [(0, 1, 3), (1, 8, 3)] if flat_face else [(0, 1, 8), (0, 8, 3)]
    return vertices, np.vstack([CUBE[1][1:11], one_side, [(1, 7, 8), (8, 7, 3)]])


# --- closed forms ---------------------------------------------------------------------------------


def shared_by_crossing_prisms(profile):
    """The volume of a long prism along x and its mirror image along y.

    At each height, the section is a square as wide as the profile, which is symmetric about y = 0.
    """
    half_widths = sorted({(z, abs(y)) for y, z in profile})
    slabs = zip(half_widths, half_widths[1:])
    return sum(Fraction(4, 3) * (b - a) * (u * u + u * v + v * v) for (a, u), (b, v) in slabs)


def shared_by_turned_squares(side, angle):
    """The area of a square and of itself turned about its centre by up to a quarter turn."""
    return 2 * side**2 / (1 + math.sin(angle) + math.cos(angle))


def volume_left_behind(mesh, moved):
    """V(A - B) if B is A after a motion that is small beside A's features.

    The integral over A of how far the surface went inwards. The error is of the order of the
    motion squared.
    """
    points = mesh[0].astype(np.longdouble)
    a, b, c = (points[mesh[1][:, corner]] for corner in range(3))
    u, v = b - a, c - a
    normals = np.stack([u[:, i - 2] * v[:, i - 1] - u[:, i - 1] * v[:, i - 2] for i in range(3)], 1)
    motion = (moved[0].astype(np.longdouble) - points)[mesh[1]]
    inwards = -np.einsum("fci,fi->fc", motion, normals) / 2
    return float(sum(_mean_of_positive_part(*heights) for heights in np.sort(inwards)))


def _mean_of_positive_part(low, middle, high):
    # Of the linear function over a triangle that has these values at its corners.
    if low >= 0:
        return (low + middle + high) / 3
    if high <= 0:
        return 0.0
    if middle <= 0:
        return high / 3 * (high / (high - middle)) * (high / (high - low))
    return (low + middle + high) / 3 - low / 3 * (low / (low - middle)) * (low / (low - high))


def rounding_tolerance(mesh, size):
    """What rounding may do to a volume: the area times 4 ulp of the size."""
    return area(*mesh) * 4 * float(np.spacing(size))


def nearly_itself(name, mesh, moved):
    """A case of a mesh and itself after a small motion."""
    shared = volume(*mesh) - volume_left_behind(mesh, moved)
    motion = np.abs(moved[0] - mesh[0]).max()
    tolerance = rounding_tolerance(mesh, np.ptp(mesh[0])) + area(*mesh) * motion**2
    return Case(name, mesh, moved, shared, tolerance=tolerance, manifold3d=False)


# --- operands -------------------------------------------------------------------------------------

CUBE = box((0, 0, 0), (2, 2, 2))
FLIPPED = np.array((0, 2, 0)) + CUBE[0] * (1, -1, 1), reversed_faces(CUBE[1])
CENTRED = box((-1, -1, -1), (1, 1, 1))
IN_CORNER = box((1, 1, 1), (3, 3, 3))
AT_QUARTER = box((2, 1, 1), (4, 3, 3))
# Coplanar lids; the square (+-5, +-5) is turned by the angle of a 3-4-5 triangle.
TEN, TEN_TURNED = scaled(CENTRED, 5), prism(((7, -1), (1, 7), (-7, 1), (-1, -7)), 5)

PLATE = box((-4, -4, -2), (4, 4, 0))
BALL = sphere()
SEAMED_BALL = with_seams(BALL, BALL[0][BALL[1], 0].mean(axis=1) > 0)
LOW_TETRAHEDRON = tetrahedron((-1, 0, 0), (1, 0, 0), (0, -1, -1), (0, 1, -1))
HIGH_TETRAHEDRON = tetrahedron((0, -1, 0), (0, 1, 0), (-1, 0, 1), (1, 0, 1))
ON_FACES = tetrahedron((4, 1, 2), (-4, 2, 1), (-1, 4, -2), (2, -3, -4))
ON_CORNERS = tetrahedron((0, 0, 0), (2, 2, 0), (2, 0, 2), (0, 2, 2))
OCTAHEDRON = make_samples.octahedral_sphere(1)
LOBES = welded(*joined(
    tetrahedron((0.5, 0.25, 0), (1.5, 0.25, 1), (0.5, 1.25, 1), (-0.5, -0.75, 1)),
    tetrahedron((0.5, 0.25, 0), (1.5, 0.25, -1), (0.5, 1.25, -1), (-0.5, -0.75, -1)),
))
RIDGE_DOWN = shifted(prism(((0, -1), (1, 1), (-1, 1)), 2), 0.5, 0.25, 1)
RIDGE_UP = shifted(prism(((0, 1), (-1, -0.5), (1, -0.5)), 2), 0.5, 0.25, -1)
WEDGE = shifted(prism(((-1.5, -0.5), (0.5, -0.5), (0.5, 1.5)), 1), 1, 3.5, 2.5)
TOWER = box((0, 0, 0), (2, 2, 4))
DIAGONAL_COLUMNS = joined(box((0, 0, 1), (1, 1, 3)), box((1, 1, 1), (2, 2, 3)))

# Octagonal cylinders: one has a rib on top, the other a flat side. Sections of 24 and 28.
RIBS = ((3, 0), (2, 2), (0, 3), (-2, 2), (-3, 0), (-2, -2), (0, -3), (2, -2))
FLATS = ((3, -1), (3, 1), (1, 3), (-1, 3), (-3, 1), (-3, -1), (-1, -3), (1, -3))
RIBBED, FLAT = prism(RIBS, 5), prism(FLATS, 5)
HALF_RIBS = [(y / 2, z / 2) for y, z in RIBS]
DIAMOND = ((1, 0), (0, 0.5), (-1, 0), (0, -0.5))
TORUS = make_samples.torus(24, 12, 0.75, 0.25)
FAR = 2e6  # 1e6 times the size of a ball

# --- the table ------------------------------------------------------------------------------------

exact = functools.partial(Case, exact=True)

CUBES = (
    exact("generic", CUBE, box((1, 1.125, 1.25), (2.5, 2.625, 2.75)), 0.65625),
    exact("corner in corner", CUBE, IN_CORNER, 1),
    exact("sharing a face", CUBE, shifted(CUBE, 2, 0, 0), 0),
    exact("sharing a face, diagonals crossed", CUBE, shifted(FLIPPED, 2, 0, 0), 0),
    exact("sharing a quarter of a face", CUBE, AT_QUARTER, 0),
    exact("sharing half a face", CUBE, box((2, 1, 0), (4, 3, 2)), 0),
    exact("on the middle of a face", CUBE, box((2, 0.5, 0.5), (3, 1.5, 1.5)), 0),
    exact("on a face, along its edge", CUBE, box((2, 0, 0.5), (3, 1, 1.5)), 0),
    exact("on a face, in its corner", CUBE, box((2, 0, 0), (3, 1, 1)), 0),
    exact("sharing an edge", CUBE, box((2, 2, 0), (4, 4, 2)), 0),
    exact("sharing half an edge", CUBE, box((2, 2, 1), (4, 4, 3)), 0),
    exact("sharing the middle of an edge", CUBE, box((2, 2, 0.5), (3, 3, 1.5)), 0),
    exact("sharing a vertex", CUBE, box((2, 2, 2), (4, 4, 4)), 0),
    exact("coplanar bottoms", CUBE, box((1, 0.5, 0), (3, 1.5, 1)), 1),
    exact("coplanar lids", CUBE, box((1, 1, 0), (3, 3, 2)), 2),
    exact("coplanar lids and sides", CUBE, box((1, 0, 0), (3, 2, 2)), 4),
    Case("turned between coplanar lids", TEN, TEN_TURNED, 10 * Fraction(250, 3)),
    exact("a half", CUBE, box((0, 0, 0), (1, 2, 2)), 4),
    exact("inside, apart", CUBE, box((0.5, 0.25, 0.75), (1, 1.25, 1.5)), 0.375),
    exact("inside, on the middle of a face", CUBE, box((0, 0.5, 0.5), (1, 1.5, 1.5)), 1),
    exact("inside, along an edge", CUBE, box((0, 0, 0.5), (1, 1, 1.5)), 1),
    exact("inside, in a corner", CUBE, box((0, 0, 0), (1, 1, 1)), 1),
    exact("bar through", CUBE, box((-1, 0.5, 0.5), (3, 1.5, 1.5)), 2),
    exact("bar through, one side coplanar", CUBE, box((-1, 0, 0.5), (3, 1, 1.5)), 2),
    exact("bar through, two sides coplanar", CUBE, box((-1, 0, 0), (3, 1, 1)), 2),
    exact("bar through, parting the cube", CUBE, box((-1, 0, 0.5), (3, 2, 1.5)), 4),
    exact("bar through, ends coplanar", CUBE, box((0, 0.5, 0.5), (2, 1.5, 1.5)), 2),
    exact("identical", CUBE, CUBE, 8),
    exact("identical, diagonals crossed", CUBE, FLIPPED, 8),
    Case("corner in corner, times 1e30", scaled(CUBE, 1e30), scaled(IN_CORNER, 1e30), 1e90),
    Case("corner in corner, times 1e-30", scaled(CUBE, 1e-30), scaled(IN_CORNER, 1e-30), 1e-90),
    Case("face on face, times 1e30", scaled(CUBE, 1e30), scaled(AT_QUARTER, 1e30), 0),
    Case("face on face, times 1e-30", scaled(CUBE, 1e-30), scaled(AT_QUARTER, 1e-30), 0),
)

TOUCHING = (
    Case("ball on a face", PLATE, shifted(BALL, 0.5, 0.25, 1), 0),
    Case("ball on a diagonal", PLATE, shifted(BALL, 0.5, 0.5, 1), 0),
    Case("ball on an edge", PLATE, shifted(BALL, 4, 0.25, 1), 0),
    Case("ball on a vertex", PLATE, shifted(BALL, 4, 4, 1), 0),
    Case("ball on ball", BALL, shifted(BALL, 2, 0, 0), 0),
    Case("ball between two faces", PLATE, shifted(BALL, 0.5, 0.25, -1), volume(*BALL)),
    Case("ball in its box", CENTRED, BALL, volume(*BALL)),
    exact("octahedron in its box", CENTRED, OCTAHEDRON, Fraction(4, 3)),
    exact("edge across edge", LOW_TETRAHEDRON, HIGH_TETRAHEDRON, 0),
    exact("tetrahedron, corners in faces", scaled(CENTRED, 4), ON_FACES, exact_volume(*ON_FACES)),
    exact("tetrahedron, corners in corners", CUBE, ON_CORNERS, Fraction(8, 3)),
    exact("two lobes, one inside", PLATE, LOBES, Fraction(1, 2)),
    exact("ridge on a face", PLATE, RIDGE_DOWN, 0),
    exact("ridge on a face, from inside", PLATE, RIDGE_UP, 6),
    exact("wedge on an edge", CUBE, WEDGE, 0),
    exact("diagonal columns between slabs", TOWER, DIAGONAL_COLUMNS, 4),
    exact("checkerboard", boxes_of_one_colour(10, 0), boxes_of_one_colour(10, 1), 0),
)

ROUND = (
    Case("cylinders, ribs across ribs", RIBBED, mirrored(RIBBED, 1, 0, 2),
         shared_by_crossing_prisms(RIBS)),
    Case("cylinders, flat across flat", FLAT, mirrored(FLAT, 1, 0, 2),
         shared_by_crossing_prisms(FLATS)),
    Case("cylinders, one behind the other", RIBBED, shifted(RIBBED, 3, 0, 0), 24 * 7),
    Case("cylinders side by side, on a rib", RIBBED, shifted(RIBBED, 3, 6, 0), 0),
    Case("cylinders side by side, on a wall", FLAT, shifted(FLAT, 3, 6, 0), 0),
    Case("cylinder inside, on a rib", RIBBED, shifted(prism(DIAMOND, 2), 0, 2, 0), 4),
    Case("cylinder through, on a rib", RIBBED, shifted(prism(DIAMOND, 7), 0, 2, 0), 10),
    Case("cylinder inside, walls coplanar", RIBBED, shifted(prism(HALF_RIBS, 2), 0, 1.5, 0), 24),
    Case("cylinder through, walls coplanar", RIBBED, shifted(prism(HALF_RIBS, 7), 0, 1.5, 0), 60),
    Case("tori of the same inner radius", TORUS, mirrored(TORUS, 2, 1, 0)),
    Case("balls far away", shifted(BALL, FAR, FAR, FAR),
         shifted(BALL, FAR + 0.5, FAR + 0.25, FAR + 0.125),
         tolerance=rounding_tolerance(BALL, FAR)),
)

NEARLY_THE_SAME = (
    Case("identical balls", BALL, BALL, volume(*BALL)),
    nearly_itself("ball, shifted by 1e-8", BALL, shifted(BALL, 1e-8, 0, 0)),
    nearly_itself("ball, turned by 1e-7", BALL, rotated(BALL, (1, 2, 3), 1e-7)),
    Case("ball, turned by 1e-15", BALL, rotated(BALL, (1, 2, 3), 1e-15), volume(*BALL),
         tolerance=rounding_tolerance(BALL, 2), manifold3d=False, compare_areas=False),
    nearly_itself("cube, turned by 1e-9", CENTRED, rotated(CENTRED, (1, 2, 3), 1e-9)),
    Case("cube, turned by 1e-9 between its lids", CENTRED, rotated(CENTRED, (0, 0, 1), 1e-9),
         2 * shared_by_turned_squares(2, 1e-9), manifold3d=False),
)

WITH_SPLIT_EDGE = cube_with_split_edge(flat_face=False)
ON_SPLIT_EDGE = box((-1, 1, 1), (1, 3, 3))
SIDES = np.arange(12) // 2
WITH_INNER_FACES = with_faces(CUBE, (0, 3, 5), (0, 5, 3))
TWICE_THE_CUBE = with_faces(CUBE, *CUBE[1])
LEFT_OF_ZERO = box((-2, 0, -1), (0, 2, 1))

INPUTS = (
    exact("soups", soup(CUBE), soup(IN_CORNER), 1),
    exact("soups, face on face", soup(CUBE), soup(AT_QUARTER), 0),
    exact("identical, one a soup", CUBE, soup(CUBE), 8),
    exact("seams along edges", with_seams(CUBE, SIDES), with_seams(AT_QUARTER, SIDES), 0),
    Case("seam around a ball", SEAMED_BALL, shifted(SEAMED_BALL, 2, 0, 0), 0),
    exact("first inside out", inside_out(CUBE), IN_CORNER, 1, solids=(CUBE, IN_CORNER)),
    exact("second inside out", CUBE, inside_out(AT_QUARTER), 0, solids=(CUBE, AT_QUARTER)),
    exact("both inside out", inside_out(CUBE), inside_out(CUBE), 8, solids=(CUBE, CUBE)),
    exact("negative zeros in one", CUBE, with_negative_zeros(LEFT_OF_ZERO), 0),
    exact("negative zeros in both", with_negative_zeros(CUBE, 2), with_negative_zeros(CUBE, 3), 8),
    exact("negative zeros in soups", with_negative_zeros(soup(CUBE), 2),
          with_negative_zeros(soup(LEFT_OF_ZERO), 3), 0),
    exact("face without area", cube_with_split_edge(flat_face=True), ON_SPLIT_EDGE, 1,
          solids=(WITH_SPLIT_EDGE, ON_SPLIT_EDGE)),
    exact("faces with two equal corners", with_faces(CUBE, (3, 3, 7), (5, 5, 5)), IN_CORNER, 1,
          solids=(CUBE, IN_CORNER)),
    exact("two faces that cancel", WITH_INNER_FACES, IN_CORNER, 1, solids=(CUBE, IN_CORNER)),
    exact("two faces that cancel, not met", WITH_INNER_FACES, shifted(CUBE, 2, 0, 0), 0,
          solids=(CUBE, shifted(CUBE, 2, 0, 0))),
    exact("each face twice", TWICE_THE_CUBE, IN_CORNER, 1, solids=(CUBE, IN_CORNER)),
    exact("each face twice, not met", TWICE_THE_CUBE, shifted(CUBE, 9, 0, 0), 0,
          solids=(CUBE, shifted(CUBE, 9, 0, 0))),
    exact("vertices that no face uses", (np.vstack([CUBE[0], (1, 1, 1.5), (9, 9, 9)]), CUBE[1]),
          IN_CORNER, 1, solids=(CUBE, IN_CORNER)),
)

# The fandisk's figures by libigl 2.6.3, which takes half a minute a block.
FANDISK_BY_LIBIGL = {
    "union": (22.30206745282037, 64.2919773995311, 48228),
    "intersection": (18.18468231285855, 57.04624107030824, 46840),
    "first_minus_second": (2.0586925699809107, 43.22511726934784, 23408),
    "second_minus_first": (2.0586925699809107, 48.91408245668731, 24390),
}
FANDISK = "fandisk, shifted along x"

_CASES = {case.name: case for case in CUBES + TOUCHING + ROUND + NEARLY_THE_SAME + INPUTS}
CASE_NAMES = (*_CASES, FANDISK)


def load_case(name):
    """The case of this name."""
    if name == FANDISK:
        mesh = placements.read_mesh(placements.meshes_folder() / "fandisk.obj")
        return Case(name, mesh, shifted(mesh, 0.25, 0, 0), libigl=FANDISK_BY_LIBIGL)
    return _CASES[name]
