# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Random small closed meshes in random, generic placements.

in: a seed; out: two operands. Guarantee: each operand is closed, oriented, free of self-
intersections; the same seed gives the same pair. Turns and shifts are random reals, so that contact
in a vertex, along an edge or over a face does not occur.
"""

import itertools
import math
import sys

import numpy as np

from mesh_laws import volume
from sample_catalogue import FOLDER

sys.path.append(str(FOLDER))

import make_samples  # noqa: E402  (the samples' own shapes)


def box(rng):
    """A box of random proportions: 12 faces."""
    corners = np.array(list(itertools.product((-1.0, 1.0), repeat=3)))
    faces = []
    for axis in range(3):
        u, v = 4 >> ((axis + 1) % 3), 4 >> ((axis + 2) % 3)
        high = 4 >> axis
        faces += [(high, high + u, high + u + v), (high, high + u + v, high + v)]
        faces += [(0, u + v, u), (0, v, u + v)]
    return corners * rng.uniform(0.3, 0.8, 3), np.array(faces)


def convex_polyhedron(rng):
    """The hull of a few random points, by trying all triples."""
    points = rng.normal(size=(rng.integers(5, 15), 3))
    points /= np.linalg.norm(points, axis=1)[:, None] * rng.uniform(1.0, 1.3, len(points))[:, None]
    triples = np.array(list(itertools.combinations(range(len(points)), 3)))
    a, b, c = (points[triples[:, corner]] for corner in range(3))
    normal = np.cross(b - a, c - a)
    heights = normal @ points.T - np.sum(normal * a, axis=1)[:, None]
    heights[np.arange(len(triples))[:, None], triples] = 0
    below, above = np.all(heights <= 0, axis=1), np.all(heights >= 0, axis=1)
    faces = np.concatenate([triples[below], triples[above][:, ::-1]])
    used, faces = np.unique(faces, return_inverse=True)
    return points[used], faces.reshape(-1, 3)


def ellipsoid(rng):
    """A sphere of random fineness, stretched."""
    points, faces = make_samples.octahedral_sphere(int(rng.integers(1, 7)))
    return points * rng.uniform(0.5, 1.0, 3), faces


def spiky_star(rng):
    """A star-shaped solid: a sphere with a random radius at each vertex."""
    points, faces = make_samples.octahedral_sphere(int(rng.integers(2, 6)))
    return points * rng.uniform(0.5, 1.0, len(points))[:, None], faces


def torus(rng):
    """A torus of random fineness with an uneven tube."""
    nu, nv = int(rng.integers(5, 17)), int(rng.integers(3, 10))
    radius = rng.uniform(0.15, 0.3) * rng.uniform(0.8, 1.2, (nu, nv))
    return make_samples.torus(nu, nv, 0.65, radius)


def prism(rng):
    """A prism, often long and thin."""
    return make_samples.cylinder(
        int(rng.integers(3, 13)), rng.uniform(0.1, 0.5), rng.uniform(0.2, 1.2)
    )


SIMPLE_SHAPES = (box, convex_polyhedron, ellipsoid, spiky_star, torus, prism)


def random_rotation(rng):
    """A rotation matrix, uniformly distributed."""
    matrix, triangular = np.linalg.qr(rng.normal(size=(3, 3)))
    matrix = matrix * np.sign(np.diag(triangular))
    return matrix * np.linalg.det(matrix)


def placed(mesh, rng, scale=1.0, shift=(0.0, 0.0, 0.0)):
    """The mesh turned at random, scaled and shifted."""
    vertices, faces = mesh
    return scale * (vertices @ random_rotation(rng).T) + np.array(shift), faces


def simple_shape(rng):
    """One component that reaches no further than 1.4 from its origin."""
    return SIMPLE_SHAPES[rng.integers(len(SIMPLE_SHAPES))](rng)


def several_components(rng):
    """Two or three shapes that do not touch."""
    places = ((-0.7, 0, 0), (0.7, 0, 0), (0, 1.2, 0))[: rng.integers(2, 4)]
    return make_samples.joined(*[placed(simple_shape(rng), rng, 0.45, place) for place in places])


def cavity(rng):
    """A ball with a cavity of a random shape, or a round one with a solid in it."""
    outer = make_samples.octahedral_sphere(int(rng.integers(4, 7)))
    if rng.random() < 0.5:
        points, faces = placed(simple_shape(rng), rng, 0.5)
        return make_samples.joined(outer, (points, faces[:, ::-1]))
    points, faces = make_samples.octahedral_sphere(5)
    inner = placed(simple_shape(rng), rng, 0.3)
    return make_samples.joined(outer, (0.75 * points, faces[:, ::-1]), inner)


def random_operand(rng):
    """Mostly one component, at times several or a cavity."""
    draw = rng.random()
    if draw < 0.7:
        return simple_shape(rng)
    return several_components(rng) if draw < 0.85 else cavity(rng)


def generic_pair(seed):
    """Two operands: VA, FA, VB, FB. Mostly crossing, at times nested or apart."""
    rng = np.random.default_rng(seed)
    first = placed(random_operand(rng), rng)
    direction = rng.normal(size=3)
    shift = rng.uniform(0, 1.3) * direction / math.sqrt(direction @ direction)
    second = placed(random_operand(rng), rng, rng.choice([0.15, 0.5, 0.8, 1.0, 1.2]), shift)
    assert volume(*first) > 0 and volume(*second) > 0
    return (*first, *second)


def shuffled(vertices, faces, rng):
    """The same mesh: vertices and faces permuted, corners rotated."""
    order = rng.permutation(len(vertices))
    number = np.empty(len(vertices), dtype=np.int64)
    number[order] = np.arange(len(vertices))
    faces = number[faces[rng.permutation(len(faces))]]
    start = rng.integers(3, size=len(faces))[:, None]
    return vertices[order], np.take_along_axis(faces, (start + np.arange(3)) % 3, axis=1)
