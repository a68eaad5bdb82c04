# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Booleans that nobody here wrote, behind one interface: (V, F) x (V, F) -> (V, F).

Sources: manifold3d (Manifold), libigl (exact, by CGAL's kernel). Operands must be closed; they are
welded exactly first, since both libraries read connectivity from the indices.
"""

import igl.copyleft.cgal
import manifold3d
import numpy as np

from mesh_laws import as_mesh, volume, welded

_MANIFOLD_OPERATIONS = {
    "union": lambda first, second: first + second,
    "intersection": lambda first, second: first ^ second,
    "first_minus_second": lambda first, second: first - second,
    "second_minus_first": lambda first, second: second - first,
}
_LIBIGL_OPERATIONS = {
    "union": ("union", False),
    "intersection": ("intersect", False),
    "first_minus_second": ("minus", False),
    "second_minus_first": ("minus", True),
}


def _to_manifold(vertices, faces):
    vertices, faces = welded(vertices, faces)
    solid = manifold3d.Manifold(manifold3d.Mesh64(vertices, faces.astype(np.uint64)))
    if solid.status() != manifold3d.Error.NoError:
        raise ValueError(f"manifold3d refuses the operand: {solid.status()}")
    return solid


def _from_manifold(solid):
    mesh = solid.to_mesh64()
    return as_mesh(np.asarray(mesh.vert_properties)[:, :3], np.asarray(mesh.tri_verts))


def manifold_blocks(first_vertices, first_faces, second_vertices, second_faces):
    """The four blocks by manifold3d: {block: (V, F)}."""
    first = _to_manifold(first_vertices, first_faces)
    second = _to_manifold(second_vertices, second_faces)
    return {
        block: _from_manifold(operation(first, second))
        for block, operation in _MANIFOLD_OPERATIONS.items()
    }


def libigl_block(block, first_vertices, first_faces, second_vertices, second_faces):
    """One block by libigl: (V, F)."""
    first = welded(first_vertices, first_faces)
    second = welded(second_vertices, second_faces)
    operation, swap = _LIBIGL_OPERATIONS[block]
    operands = second + first if swap else first + second
    vertices, faces, _ = igl.copyleft.cgal.mesh_boolean(*operands, operation)
    return as_mesh(vertices, faces)


def libigl_blocks(first_vertices, first_faces, second_vertices, second_faces):
    """The four blocks by libigl: {block: (V, F)}."""
    operands = (first_vertices, first_faces, second_vertices, second_faces)
    return {block: libigl_block(block, *operands) for block in _LIBIGL_OPERATIONS}


def is_embedded(vertices, faces):
    """True if libigl finds nothing to resolve in a closed mesh: no self-intersection."""
    nothing = (np.empty((0, 3)), np.empty((0, 3), dtype=np.int64))
    mesh = welded(vertices, faces)
    resolved, kept, _ = igl.copyleft.cgal.mesh_boolean(*mesh, *nothing, "union")
    return len(resolved) == len(mesh[0]) and len(kept) == len(mesh[1])


def volumes(blocks):
    """The volume of each block."""
    return {block: volume(*mesh) for block, mesh in blocks.items()}
