# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Exact Booleans, splits and intersection curves of triangle meshes for pymeshlab.

    import indexboolean, pymeshlab

    indexboolean.load_plugin()
    ms = pymeshlab.MeshSet()
    ms.load_new_mesh("a.ply")
    ms.load_new_mesh("b.ply")
    result = ms.generate_index_boolean(first_mesh=0, second_mesh=1)

    distance, gradient, face = indexboolean.SignedDistance((vertices, faces))(points)

Meshes of trimesh, pyvista or meshio, and pairs (vertices, faces), without layers:

    union = indexboolean.boolean(a, b)

Command line: python -m indexboolean boolean|split|curves|distance a.ply b.ply -o DIR
              python -m indexboolean batch jobs.csv -o DIR
"""

from .mesh_calls import SplitPieces, boolean, distance, evaluate, resolve, split
from .mesh_document import MeshRefusal
from .plugin import HostError, load_plugin, plugin_path
from .signed_distance import SignedDistance
from .trimesh_engine import register_trimesh_engine

__all__ = [
    "HostError", "MeshRefusal", "SignedDistance", "SplitPieces", "boolean", "distance", "evaluate",
    "load_plugin", "plugin_path", "register_trimesh_engine", "resolve", "split",
]
