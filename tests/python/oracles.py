# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Booleans that nobody here wrote, behind one interface: (V, F) x (V, F) -> (V, F).

Sources: manifold3d (Manifold), libigl (exact, by CGAL's kernel). Operands must be closed; they are
welded exactly first, since both libraries read connectivity from the indices.
"""

import igl.copyleft.cgal
import manifold3d
import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

from mesh_laws import as_mesh, volume, welded

_MANIFOLD_OPERATIONS = {
    "union": lambda first, second: first + second,
    "intersection": lambda first, second: first ^ second,
    "first_minus_second": lambda first, second: first - second,
    "second_minus_first": lambda first, second: second - first,
}
_RAY = np.array([0.31, 0.47, 0.83])
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


def faces_that_cross(vertices, faces):
    """The faces that meet others in more than common corners and edges, as libigl finds them.

    It leaves out faces that lie on one another from a common edge on, and flat ones.
    """
    result = igl.copyleft.cgal.remesh_self_intersections(
        np.ascontiguousarray(vertices), np.ascontiguousarray(faces), detect_only=True
    )
    return np.unique(result[2]).tolist()


def volumes(blocks):
    """The volume of each block."""
    return {block: volume(*mesh) for block, mesh in blocks.items()}


def libigl_cells(first_vertices, first_faces, second_vertices, second_faces):
    """How two surfaces, open or closed, cut each other and space, mostly by libigl.

    Returns (patches of the first, patches of the second, the volumes of the bounded cells). libigl
    resolves the intersections, and finds the patches and the cells around each connected part; it
    keeps the sides of an open patch apart and cannot place parts of open surfaces in each other's
    cells, so that this is done here. No two faces may coincide.
    """
    meshes = welded(first_vertices, first_faces), welded(second_vertices, second_faces)
    vertices = np.concatenate([mesh[0] for mesh in meshes])
    faces = np.concatenate([meshes[0][1], meshes[1][1] + len(meshes[0][0])])
    vertices, faces, _, parents, stitched = igl.copyleft.cgal.remesh_self_intersections(
        vertices, faces, cutoff=len(faces) ** 2
    )
    faces = stitched[faces]
    _, patch = igl.extract_manifold_patches(faces)
    of_first = parents < len(meshes[0][1])
    beside, pairs = _cells_of_parts(vertices, faces)
    pairs = np.concatenate([pairs, beside[_border_faces(faces)]])
    count = beside.max() + 1
    _, cell = connected_components(
        coo_matrix((np.ones(len(pairs)), pairs.T), shape=(count, count)), directed=False
    )
    corners = vertices[faces] - vertices.mean(axis=0)
    below = np.linalg.det(corners) / 6
    volumes = np.zeros(count)
    np.add.at(volumes, cell[beside[:, 1]], below)
    np.add.at(volumes, cell[beside[:, 0]], -below)
    bounded = np.setdiff1d(np.unique(cell[beside]), cell[0])
    return len(np.unique(patch[of_first])), len(np.unique(patch[~of_first])), volumes[bounded]


def _cells_of_parts(vertices, faces):
    """The cells in front of each face and behind it, and pairs of cells that are one.

    Cell 0 is the unbounded one. Each part that edges connect has cells of its own.
    """
    part = _edge_connected(faces)
    beside = np.empty((len(faces), 2), dtype=np.int64)
    outer, count = [], 1
    for number in range(part.max() + 1):
        chosen = part == number
        cells, found = igl.copyleft.cgal.extract_cells(
            *igl.remove_unreferenced(vertices, faces[chosen])[:2]
        )
        beside[chosen] = found + count
        outer.append(count)
        count += cells
    pairs = []
    for number, cell in enumerate(outer):
        others = part != number
        corners = vertices[np.unique(faces[~others])]
        start = corners[np.argmax(corners @ _RAY)]  # the ray leaves the part for good
        hit, in_front = _first_hit(start, vertices[faces[others]])
        pairs.append((cell, 0 if hit is None else beside[others][hit][0 if in_front else 1]))
    return beside, np.array(pairs)


def _first_hit(start, corners):
    """The triangle that the ray from a point meets first, and whether in front; (None, False)."""
    a, b, c = (corners[:, k] - start for k in range(3))
    sides = np.stack([np.cross(p, q) @ _RAY for p, q in ((a, b), (b, c), (c, a))])
    normal = np.cross(b - a, c - a)
    slope = normal @ _RAY
    with np.errstate(divide="ignore", invalid="ignore"):
        distance = np.sum(normal * a, axis=1) / slope
    met = (np.all(sides > 0, axis=0) | np.all(sides < 0, axis=0)) & (distance > 0)
    if not met.any():
        return None, False
    nearest = np.flatnonzero(met)[np.argmin(distance[met])]
    return nearest, slope[nearest] < 0


def _edges(faces):
    """Per face its three edges, numbered, and per edge how many faces it has."""
    ends = np.sort(np.stack([faces, np.roll(faces, -1, axis=1)], axis=2).reshape(-1, 2), axis=1)
    _, edge, count = np.unique(ends, axis=0, return_inverse=True, return_counts=True)
    return edge.reshape(-1, 3), count


def _border_faces(faces):
    """The faces at edges that have one face only."""
    edge, count = _edges(faces)
    return np.flatnonzero(count[edge].min(axis=1) == 1)


def _edge_connected(faces):
    """Per face, the number of the part that edges connect it to."""
    edge, count = _edges(faces)
    size = len(faces) + len(count)
    rows = np.repeat(np.arange(len(faces)), 3)
    joints = coo_matrix((np.ones(len(rows)), (rows, len(faces) + edge.ravel())), (size, size))
    _, part = connected_components(joints, directed=False)
    return np.unique(part[: len(faces)], return_inverse=True)[1]
