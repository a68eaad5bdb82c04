# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Solids and their motions for tests and benchmarks alike: nothing is loaded but numpy.

A mesh is a pair (V, F), faces counter-clockwise seen from outside. Guarantee: the same coordinates
on every machine, since products are written out.
"""

import itertools
import math
import sys
from pathlib import Path

import numpy as np

sys.path.append(str(Path(__file__).resolve().parents[2] / "sample_meshes"))

import make_samples  # noqa: E402  (the samples' own shapes)

joined = make_samples.joined
GOLDEN = (1 + math.sqrt(5)) / 2


def shifted(mesh, shift):
    """The mesh moved; coordinates are rounded."""
    return mesh[0] + np.array(shift, dtype=np.float64), mesh[1]


def turned_about(mesh, axis, angle):
    """The mesh turned about an axis of any length through the origin; coordinates are rounded."""
    half, size = angle / 2, math.sqrt(sum(x * x for x in axis))
    quaternion = math.cos(half), *(math.sin(half) * x / size for x in axis)
    return make_samples.turned(mesh[0], quaternion), mesh[1]


def turned_at_random(mesh, rng):
    """The mesh under a turn that is uniformly distributed."""
    return make_samples.turned(mesh[0], rng.normal(size=4)), mesh[1]


def one_sided():
    """A closed surface with one side: four faces of an octahedron and the squares between them."""
    corners = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
    squares = [(0, 2, 1, 3), (2, 4, 3, 5), (4, 0, 5, 1)]
    triangles = [(0, 2, 4), (0, 3, 5), (1, 2, 5), (1, 3, 4)]
    faces = triangles + [t for a, b, c, d in squares for t in ((a, b, c), (a, c, d))]
    return np.array(corners, dtype=np.float64), np.array(faces)


def box(low, high):
    """A box of 12 faces."""
    corners = np.array(list(itertools.product(*zip(low, high))), dtype=np.float64)
    sides = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return corners, make_samples.quads(*np.array(sides).T)


def cube(side):
    """A cube about the origin."""
    return box([-side / 2] * 3, [side / 2] * 3)


def icosphere(subdivisions):
    """The unit sphere with 20 * 4^subdivisions faces, from an icosahedron."""
    rectangle = [(0, y, z * GOLDEN) for y in (-1, 1) for z in (-1, 1)]
    corners = [np.roll(corner, turn) for turn in range(3) for corner in rectangle]
    points = np.array(corners) / math.hypot(1, GOLDEN)
    faces = _nearest_triangles(points)
    for _ in range(subdivisions):
        points, faces = halved(points, faces)
        points = points / make_samples.length(points)[:, None]
    return points, faces


def _nearest_triangles(points):
    # Of points on a sphere, the triangles of those nearest to each other, seen from outside.
    apart = np.linalg.norm(points[:, None] - points, axis=2)
    near = apart < 1.01 * apart[apart > 0].min()
    triples = [
        triple for triple in itertools.combinations(range(len(points)), 3)
        if all(near[pair] for pair in itertools.combinations(triple, 2))
    ]
    outwards = [np.linalg.det(points[list(triple)]) > 0 for triple in triples]
    return np.array([t if out else t[::-1] for t, out in zip(triples, outwards)])


def halved(points, faces):
    """Each triangle in four, at the middles of its sides."""
    ends = np.sort(np.stack([faces, np.roll(faces, -1, axis=1)], axis=2).reshape(-1, 2), axis=1)
    edges, number = np.unique(ends, axis=0, return_inverse=True)
    a, b, c = faces.T
    ab, bc, ca = number.reshape(-1, 3).T + len(points)
    pieces = [np.stack(f, axis=1) for f in ((a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca))]
    return np.concatenate([points, points[edges].mean(axis=1)]), np.concatenate(pieces)


def column(sides, x, y, radius):
    """A prism from z = -1 to z = 2 about a line along z."""
    angles = 2 * np.pi * np.arange(sides) / sides
    ring = np.stack([x + radius * np.cos(angles), y + radius * np.sin(angles)], axis=1)
    points = [np.column_stack([ring, np.full(sides, z)]) for z in (-1.0, 2.0)]
    points = np.vstack([*points, [(x, y, -1), (x, y, 2)]])
    i = np.arange(sides)
    j, low, high = (i + 1) % sides, 0 * i + 2 * sides, 0 * i + 2 * sides + 1
    quads = np.vstack([np.stack([i, j, j + sides], 1), np.stack([i, j + sides, i + sides], 1)])
    lids = np.vstack([np.stack([j, i, low], 1), np.stack([i + sides, j + sides, high], 1)])
    return points, np.vstack([quads, lids])
