# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Random polyhedra with small integer corners, so that vertices, edges and faces meet in every way.

Volumes are compared with libigl's, which decides exactly. Seeds are fixed and printed on failure.
"""

import numpy as np
import pytest
from scipy.spatial import ConvexHull

import mesh_laws
import oracles
from run_boolean import BLOCKS, run_boolean

SEEDS_PER_CASE = 25


def random_polyhedron(rng, size):
    """The convex hull of random grid points, its flat faces triangulated in any way."""
    while True:
        points = np.unique(rng.integers(0, size + 1, size=(int(rng.integers(4, 14)), 3)), axis=0)
        points = points.astype(np.float64)
        if len(points) < 4 or np.linalg.matrix_rank(points - points[0]) < 3:
            continue
        hull = ConvexHull(points)
        centre = points[hull.vertices].mean(axis=0)
        faces = hull.simplices.copy()
        corners = points[faces]
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        inward = np.einsum("ij,ij->i", normals, centre - corners[:, 0]) > 0
        faces[inward] = faces[inward][:, ::-1]
        used = np.unique(faces)
        number = np.zeros(len(points), dtype=np.int64)
        number[used] = np.arange(len(used))
        vertices, faces = points[used], number[faces]
        if mesh_laws.unmatched_edges(vertices, faces) == 0 and not len(
            mesh_laws.zero_area_faces(vertices, faces)
        ):
            return vertices, faces


def second_operand(case, first, rng, size):
    vertices, faces = first
    if case == "another":
        return random_polyhedron(rng, size)
    if case == "shifted by a step":
        return vertices + rng.integers(-1, 2, size=3), faces
    if case == "identical, corners rotated":
        return vertices.copy(), faces[:, [1, 2, 0]]
    if case == "larger by an ulp":
        return vertices * np.nextafter(1, 2), faces
    assert case == "another, moved by an ulp"
    moved, faces = random_polyhedron(rng, size)
    return np.nextafter(moved, np.inf), faces


CASES = (
    "another",
    "shifted by a step",
    "identical, corners rotated",
    "larger by an ulp",
    "another, moved by an ulp",
)


@pytest.mark.parametrize("seed", range(SEEDS_PER_CASE))
@pytest.mark.parametrize("case", CASES)
def test_contactsOfGridPolyhedraAreRight(case, seed):
    print("seed", seed)
    rng = np.random.default_rng([CASES.index(case), seed])
    size = 2 + seed % 5
    first = random_polyhedron(rng, size)
    second = second_operand(case, first, rng, size)
    blocks = run_boolean(*first, *second)
    volumes = {block: mesh_laws.volume(*blocks[block]) for block in BLOCKS}
    scale = mesh_laws.volume(*first) + mesh_laws.volume(*second)
    expected = mesh_laws.volume(*oracles.libigl_block("intersection", *first, *second))
    assert volumes["intersection"] == pytest.approx(expected, abs=1e-12 * scale)
    assert volumes["union"] + volumes["intersection"] == pytest.approx(scale, abs=1e-12 * scale)
    both = volumes["intersection"]
    only_first = volumes["first_minus_second"]
    assert only_first + both == pytest.approx(mesh_laws.volume(*first), abs=1e-12 * scale)
    for block in BLOCKS:
        assert mesh_laws.unmatched_edges(*blocks[block]) == 0, block
        assert len(mesh_laws.zero_area_faces(*blocks[block])) == 0, block
