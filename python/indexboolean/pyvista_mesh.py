# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""pyvista.PolyData: its polygons, point data, cell data and field data.

pyvista itself is what the caller has imported. Vertex and line cells bound nothing and are left
out, with their cell data.
"""

import sys

import numpy as np

from .mesh_record import checked_record, columns_of, is_of, polygons_of_padded

# What VTK draws by, of points and of cells.
_ACTIVE = ("active_scalars_name", "active_vectors_name", "active_texture_coordinates_name",
           "active_normals_name")
HAS_POLYGONS = True


def is_mesh(mesh):
    """Whether it is a pyvista.PolyData."""
    return is_of("pyvista", "PolyData", mesh)


def read_all(meshes):
    """A MeshRecord of each."""
    return [_read(mesh) for mesh in meshes]


def write(record, operands):
    """A PolyData with points in double precision. operands are the meshes that were read."""
    pyvista, first = sys.modules["pyvista"], operands[0]
    mesh = pyvista.PolyData(np.ascontiguousarray(record.vertices), faces=_padded(record))
    for data, columns in (
        (mesh.point_data, record.of_vertices), (mesh.cell_data, record.of_faces)
    ):
        for name, column in columns.items():
            if column.values.size > 0 or column.values.ndim == 1:  # pyvista takes no 0 x 3 array
                data.set_array(column.values, name)
    for name, values in first.field_data.items():
        mesh.field_data.set_array(values, name)
    normals = first.cell_data.active_normals_name
    if normals is not None and mesh.n_cells > 0:
        kind = first.cell_data[normals].dtype
        mesh.cell_data.set_array(np.asarray(mesh.face_normals).astype(kind), normals)
    for operand in reversed(operands):
        _activate(mesh.point_data, operand.point_data)
        _activate(mesh.cell_data, operand.cell_data)
    return mesh


def _activate(data, given):
    """Makes active what is so in the given data, as far as it is there."""
    for active in _ACTIVE:
        name = getattr(given, active, None)
        if name in data:
            setattr(data, active, name)


def _read(mesh):
    if mesh.n_strips > 0:
        raise ValueError(
            f"it has triangle strips, {mesh.n_strips} of them: mesh.triangulate() makes triangles "
            "of each"
        )
    before = mesh.n_verts + mesh.n_lines
    normals = mesh.point_data.active_normals_name
    of_faces = {
        name: np.asarray(values)[before:] for name, values in mesh.cell_data.items()
        if name != mesh.cell_data.active_normals_name  # which are those of the new faces
    }
    of_vertices = columns_of(mesh.point_data.items())
    texture = mesh.point_data.active_texture_coordinates_name
    if texture is not None:
        of_vertices[texture].missing = 0
    return checked_record(
        mesh.points, polygons_of_padded(mesh.faces), normals=normals, of_vertices=of_vertices,
        of_faces=columns_of(of_faces.items()),
    )


def _padded(record):
    """The faces, each with its count before its indices."""
    if record.has_polygons:
        return np.concatenate([np.r_[len(face), face] for face in record.faces] or [[]]).astype(int)
    padded = np.full((len(record.faces), 4), 3)
    padded[:, 1:] = record.faces
    return padded.ravel()
