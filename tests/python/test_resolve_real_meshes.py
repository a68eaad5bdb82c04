# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Layers of two overlapping copies of other people's meshes: what they enclose, beside libigl.

The folder is named by INDEXBOOLEAN_MESHES: unset, these tests skip.
"""

import os

import numpy as np
import pymeshlab
import pytest

import mesh_laws
import oracles
import placements
from plain_solids import box, joined
from run_boolean import run_boolean

pytestmark = pytest.mark.skipif(
    not os.environ.get(placements.MESHES_VARIABLE),
    reason=f"{placements.MESHES_VARIABLE} is not set: no folder of other people's meshes",
)

# All that are closed.
SMALL = ("72214.stl", "88566.stl", "fandisk.obj")
LARGE = (
    "1063852.stl", "58011.stl", "73416.stl", "908460.stl", "armadillo.obj", "bunny100k.obj",
    "cheburashka.obj", "falconstatue.obj", "fertility.obj", "plane.obj", "rocker-arm.obj",
    "skull.obj", "spot.obj",
)
SHIFT = np.array((0.1, 0.07, 0.05))  # in sizes of the mesh


def load(name):
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(str(placements.meshes_folder() / name))
    mesh = meshes.current_mesh()
    return mesh_laws.welded(mesh.vertex_matrix(), mesh.face_matrix())


def two_copies(mesh):
    """(The layer, a box beyond it.)"""
    vertices, faces = mesh
    size = np.ptp(vertices, axis=0)
    layer = joined(mesh, (vertices + size * SHIFT, faces))
    high = layer[0].max(axis=0)
    return layer, box(high + size, high + 2 * size)


def test_noClosedMeshIsLeftOut():
    folder = placements.meshes_folder()
    names = {path.name for path in folder.iterdir() if path.suffix in (".obj", ".stl")}
    closed = {name for name in names if mesh_laws.unmatched_edges(*load(name)) == 0}
    assert closed == {*SMALL, *LARGE} & names


@pytest.mark.parametrize(
    "name", [*SMALL, *(pytest.param(name, marks=pytest.mark.long) for name in LARGE)]
)
def test_twoOverlappingCopiesHaveTheVolumeOfLibiglsUnion(name):
    mesh = load(name)
    layer, far = two_copies(mesh)
    union = mesh_laws.volume(*oracles.libigl_block("union", *layer, *far))
    union -= mesh_laws.volume(*far)
    for rule, volume in (("nonzero", union), ("odd", 2 * union - mesh_laws.volume(*layer))):
        result = run_boolean(*layer, *far, winding_rule=rule)["result"]
        assert result["self_intersecting_faces_first"] > 0
        assert result["first_minus_second_volume"] == pytest.approx(volume, rel=1e-9)
