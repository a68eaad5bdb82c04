# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Other people's meshes in their standard placements.

in: the folder that INDEXBOOLEAN_MESHES names; out: pairs of operands as arrays. Products are
written out, so that the coordinates do not depend on the linear algebra library.
"""

import json
import math
import os
from pathlib import Path

import numpy as np
import pymeshlab

MESHES_VARIABLE = "INDEXBOOLEAN_MESHES"
STATUE_PAIRS = {
    "armadillo-bunny": ("armadillo.obj", "bunny100k.obj", (0.0, 0.0, 0.0)),
    "fertility-itself": ("fertility.obj", "fertility.obj", (0.05, 0.04, 0.03)),
    "falcon-skull": ("falconstatue.obj", "skull.obj", (0.0, 0.0, 0.0)),
}
EMBER_PAIRS = {"ember-0": 0, "ember-1": 1, "ember-2": 2}
PAIR_NAMES = (*STATUE_PAIRS, *EMBER_PAIRS)


def meshes_folder():
    """The folder, or None if the variable is not set. A name that is no folder is an error."""
    name = os.environ.get(MESHES_VARIABLE)
    if not name:
        return None
    if not Path(name).is_dir():
        raise FileNotFoundError(f"{MESHES_VARIABLE} names {name}, which is no folder")
    return Path(name)


def read_mesh(path):
    """The arrays of a mesh file as the host reads it (STL: equal vertices unified)."""
    mesh_set = pymeshlab.MeshSet()
    mesh_set.load_new_mesh(str(path))
    mesh = mesh_set.current_mesh()
    vertices = np.ascontiguousarray(mesh.vertex_matrix())
    return vertices, np.ascontiguousarray(mesh.face_matrix(), dtype=np.int64)


def affine(vertices, matrix):
    """The vertices under a 3 x 4 matrix."""
    x, y, z = vertices.T
    return np.stack([row[0] * x + row[1] * y + row[2] * z + row[3] for row in matrix], axis=1)


def normalised(vertices):
    """Centred on the bounding box, divided by its longest side."""
    low, high = vertices.min(axis=0), vertices.max(axis=0)
    return (vertices - (low + high) / 2) / (high - low).max()


def rotation(axis, angle):
    """The 3 x 3 matrix of a turn by an angle about an axis of any length."""
    length = math.sqrt(sum(x * x for x in axis))
    x, y, z = (component / length for component in axis)
    c, s = math.cos(angle), math.sin(angle)
    t = 1 - c
    return (
        (t * x * x + c, t * x * y - s * z, t * x * z + s * y),
        (t * x * y + s * z, t * y * y + c, t * y * z - s * x),
        (t * x * z - s * y, t * y * z + s * x, t * z * z + c),
    )


def load_pair(name, folder):
    """The pair's operands as they are placed: VA, FA, VB, FB."""
    if name in STATUE_PAIRS:
        first, second, shift = STATUE_PAIRS[name]
        matrix = [(*row, move) for row, move in zip(rotation((1, 2, 3), 0.7), shift)]
        first_vertices, first_faces = read_mesh(folder / first)
        second_vertices, second_faces = read_mesh(folder / second)
        placed = affine(normalised(second_vertices), matrix)
        return normalised(first_vertices), first_faces, placed, second_faces
    case = json.loads((folder / "ember_cases.json").read_text())[EMBER_PAIRS[name]]
    operands = []
    for side in ("a", "b"):
        vertices, faces = read_mesh(folder / case[side])
        operands += [affine(vertices, case[f"transform_{side}"]), faces]
    return tuple(operands)
