# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pairs (vertices, faces) as meshes. They have no columns."""

import numpy as np

from .mesh_record import checked_record

HAS_POLYGONS = True


def is_mesh(mesh):
    """Whether it is a pair of arrays, or of what makes arrays."""
    return isinstance(mesh, (tuple, list)) and len(mesh) == 2


def read_all(pairs):
    """A MeshRecord of each (n x 3 numbers, m x k indices or polygons)."""
    return [checked_record(*pair) for pair in pairs]


def write(record, operands):
    """(n x 3 doubles, m x 3 indices of the first operand's type); a list of arrays for polygons."""
    if record.has_polygons:
        return record.vertices, record.faces
    faces = operands[0][1]
    kind = faces.dtype if hasattr(faces, "dtype") else np.dtype(int)
    fits = np.issubdtype(kind, np.integer) and len(record.vertices) <= np.iinfo(kind).max
    return record.vertices, record.faces.astype(kind if fits else np.int32)
