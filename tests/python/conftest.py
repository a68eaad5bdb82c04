# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of the filter share: the plugin, loaded once, and simple closed meshes."""

import numpy as np
import pymeshlab
import pytest

import indexboolean
from plain_solids import box, halved, joined


@pytest.fixture(scope="session", autouse=True)
def plugin():
    """The plugin is loaded once for all tests."""
    indexboolean.load_plugin()


@pytest.fixture(scope="session")
def bystander():
    """A document that outlives all tests."""
    meshes = pymeshlab.MeshSet()
    meshes.create_cube()
    return meshes


@pytest.fixture(autouse=True)
def _log_of_a_living_document(bystander):
    """After a refusal pymeshlab writes to the log of the document that was refused, until a call of
    another one has succeeded: docs/hosts.md. Tests drop theirs."""
    yield
    bystander.get_geometric_measures()


def sphere(centre=(0.0, 0.0, 0.0), radius=1.0, subdivisions=3):
    """A sphere of 8 * 4^subdivisions triangles, from an octahedron."""
    vertices = np.array([(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)])
    faces = np.array([(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4)])
    faces = np.concatenate([faces, np.where(faces == 4, 5, faces)[:, ::-1]])
    vertices = vertices.astype(np.float64)
    for _ in range(subdivisions):
        vertices, faces = halved(vertices, faces)
        vertices /= np.linalg.norm(vertices, axis=1)[:, None]
    return vertices * radius + np.asarray(centre), faces


def crossing_bars():
    """Two components that cross; no vertex of one lies in the other."""
    return joined(box((-2, -0.5, -0.25), (2, 0.5, 0.75)), box((-0.5, -2, -0.5), (0.75, 2, 0.5)))


def document(*meshes):
    """A MeshSet with a layer for each mesh, labelled A, B, C, ..."""
    mesh_set = pymeshlab.MeshSet()
    for label, (vertices, faces) in zip("ABCDEFGH", meshes):
        mesh_set.add_mesh(pymeshlab.Mesh(vertices, faces), label)
    return mesh_set
