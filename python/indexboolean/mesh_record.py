# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A mesh as arrays with named columns: what the readers of each library's meshes make, and what
their writers take.

Guarantee: no library of meshes is imported, and the arrays of a user's mesh are not written to.
"""

import dataclasses
import sys

import numpy as np

_MOST = 2**31 - 1  # faces and vertices


def is_of(library, kind, mesh):
    """Whether a mesh is of a class of a library, which need not be imported, nor even there."""
    module = sys.modules.get(library)
    return module is not None and isinstance(mesh, getattr(module, kind, ()))


@dataclasses.dataclass
class Column:
    """A value for each vertex, or each face: rows of one shape and type.

    missing: the value where another mesh lacks the column; None: not a number, 0, False or "".
    """

    values: np.ndarray
    missing: object = None


@dataclasses.dataclass
class MeshRecord:
    """vertices: n x 3 doubles; faces: an m x 3 array of indices, or a list of polygons' indices.

    of_vertices and of_faces: {name: Column}. normals: which column of vertices holds directions
    that turn over with the faces; None: none does.
    """

    vertices: np.ndarray
    faces: object
    of_vertices: dict = dataclasses.field(default_factory=dict)
    of_faces: dict = dataclasses.field(default_factory=dict)
    normals: object = None

    @property
    def has_polygons(self):
        """Whether faces is a list of polygons."""
        return isinstance(self.faces, list)


class BadFaces(ValueError):
    """Faces that name no vertices; `faces` are their numbers."""

    def __init__(self, sentence, faces):
        super().__init__(sentence)
        self.faces = faces


def columns_of(items):
    """{name: Column} of pairs (name, values)."""
    return {name: Column(np.asarray(values)) for name, values in items}


def checked_record(vertices, faces, **columns):
    """A MeshRecord of any arrays: vertices are n x 3 numbers; faces are an array of m rows, or a
    sequence of sequences, of three indices or more; columns have a row for each. Raises ValueError,
    with numbers of faces where it is BadFaces.
    """
    vertices = np.ascontiguousarray(vertices, dtype=np.float64)
    if vertices.size == 0:
        vertices = vertices.reshape(-1, 3)
    if vertices.ndim != 2 or vertices.shape[1] != 3:
        raise ValueError(f"vertices are n x 3 numbers, not {vertices.shape}")
    triangles = _as_triangles(faces)
    if triangles is None:
        triangles = faces = _as_polygons(faces)
    else:
        faces = triangles
    _check_indices(len(vertices), faces)
    record = MeshRecord(vertices, faces, **columns)
    check_lengths("vertex", len(vertices), record.of_vertices)
    check_lengths("face", len(faces), record.of_faces)
    return record


def check_lengths(element, count, columns):
    """Raises ValueError for a column without a row for each of `count` vertices, or faces."""
    for name, column in columns.items():
        given = len(column.values) if column.values.ndim > 0 else 1
        if column.values.ndim == 0 or given != count:
            words = name if isinstance(name, str) else " ".join(map(str, name))
            values = "value" if given == 1 else "values"
            raise ValueError(
                f'its {element} data "{words}" have {given} {values}, not {count}, one for each '
                f"{element}"
            )


def polygons_of_padded(padded):
    """An m x 3 array, or a list of arrays, of indices that each face's count stands before."""
    padded = np.asarray(padded)
    if len(padded) % 4 == 0 and np.all(padded[::4] == 3):
        return padded.reshape(-1, 4)[:, 1:]
    polygons, begin = [], 0
    while begin < len(padded):
        end = begin + 1 + int(padded[begin])
        polygons.append(padded[begin + 1:end])
        begin = end
    return polygons


def _as_triangles(faces):
    """The faces as an m x 3 array of 32-bit indices; None: they are no triangles."""
    if isinstance(faces, (list, tuple)) and len({len(face) for face in faces}) > 1:
        return None
    faces = np.asarray(faces)
    if faces.size == 0:
        return np.empty((0, 3), dtype=np.int32)
    if faces.ndim != 2 or faces.shape[1] < 3:
        raise ValueError(f"faces are m rows of three indices or more, not {faces.shape}")
    if faces.shape[1] > 3:
        return None
    _check_integers(faces)
    if faces.max() > _MOST or faces.min() < -_MOST:
        raise _bad_faces(faces, None)
    return np.ascontiguousarray(faces, dtype=np.int32)


def _as_polygons(faces):
    polygons = [np.asarray(face) for face in faces]
    short = np.flatnonzero([len(polygon) < 3 for polygon in polygons])
    if len(short) > 0:
        raise BadFaces(f"face {short[0]} has fewer than three corners", short)
    for polygon in polygons:
        _check_integers(polygon)
    return polygons


def _check_integers(array):
    if not np.issubdtype(array.dtype, np.integer):
        raise ValueError(f"faces are indices, not {array.dtype}")


def _check_indices(count, faces):
    if isinstance(faces, list):
        is_bad = [polygon.min() < 0 or polygon.max() >= count for polygon in faces]
        if any(is_bad):
            raise _bad_faces(faces, count)
    elif len(faces) > 0 and (faces.min() < 0 or faces.max() >= count):
        raise _bad_faces(faces, count)
    if max(count, len(faces)) > _MOST:
        raise ValueError("the mesh is too large: there may be 2^31 - 1 vertices and faces")


def _bad_faces(faces, count):
    """What to raise where indices are out of range; count None: of any number of vertices."""
    limit = _MOST if count is None else count
    bad = np.array([f for f, face in enumerate(faces) if min(face) < 0 or max(face) >= limit])
    corner = next(corner for corner in faces[bad[0]] if corner < 0 or corner >= limit)
    vertices = "" if count is None else f", of which there are {count}"
    others = len(bad) - 1
    more = f", as do{'es' if others == 1 else ''} {others} more" if others else ""
    return BadFaces(f"face {bad[0]} names vertex {corner}{vertices}{more}", bad)
