# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""trimesh.Trimesh: its attributes of vertices and faces, its colours or texture coordinates.

trimesh itself is what the caller has imported.
"""

import sys

import numpy as np

from .mesh_record import Column, checked_record, columns_of, is_of

_COLOUR, _UV = ("visual", "colour"), ("visual", "uv")  # no user's attribute has such a name
HAS_POLYGONS = False


def is_mesh(mesh):
    """Whether it is a trimesh.Trimesh."""
    return is_of("trimesh", "Trimesh", mesh)


def read_all(meshes):
    """A MeshRecord of each. All have the visual of one kind, that of the first that has any."""
    kind = next(filter(None, map(_kind_of, meshes)), None)
    uvs = _texture_coordinates(meshes)[0] if kind == "texture" else [None] * len(meshes)
    return [_read(mesh, kind, uv) for mesh, uv in zip(meshes, uvs)]


def write(record, operands):
    """A Trimesh, as it is: no vertex is merged. operands are the meshes that were read."""
    trimesh = sys.modules["trimesh"]
    colours = [columns.pop(_COLOUR, None) for columns in (record.of_vertices, record.of_faces)]
    uv = record.of_vertices.pop(_UV, None)
    mesh = trimesh.Trimesh(
        record.vertices, record.faces, process=False, validate=False,
        vertex_attributes=_values_of(record.of_vertices),
        face_attributes=_values_of(record.of_faces),
    )
    if uv is not None:
        material = _texture_coordinates(operands)[1]
        mesh.visual = trimesh.visual.TextureVisuals(uv=uv.values, material=material)
    for name, colour in zip(("vertex_colors", "face_colors"), colours):
        if colour is not None and len(mesh.faces) > 0:  # trimesh cannot copy colours of nothing
            setattr(mesh.visual, name, colour.values)
    if len({operand.units for operand in operands}) == 1:
        mesh.units = operands[0].units
    return mesh


def _kind_of(mesh):
    """"vertex", "face", "texture" or None: what its visual has."""
    kind = mesh.visual.kind
    return None if kind == "texture" and mesh.visual.uv is None else kind


def _read(mesh, kind, uv):
    of_vertices = columns_of(mesh.vertex_attributes.items())
    of_faces = columns_of(mesh.face_attributes.items())
    has_any = _kind_of(mesh) is not None
    if kind == "vertex" and has_any:
        of_vertices[_COLOUR] = Column(_colours(mesh).vertex_colors, missing=255)
    elif kind == "face" and has_any:
        of_faces[_COLOUR] = Column(_colours(mesh).face_colors, missing=255)
    elif uv is not None:
        of_vertices[_UV] = Column(np.asarray(uv), missing=0)
    return checked_record(mesh.vertices, mesh.faces, of_vertices=of_vertices, of_faces=of_faces)


def _colours(mesh):
    return mesh.visual.to_color() if mesh.visual.kind == "texture" else mesh.visual


def _texture_coordinates(meshes):
    """(the texture coordinates of each, or None; the one material): as trimesh joins visuals."""
    textured = [mesh for mesh in meshes if _kind_of(mesh) == "texture"]
    materials = {hash(mesh.visual.material): mesh.visual.material for mesh in textured}
    if len(materials) == 1:
        uvs = [mesh.visual.uv if _kind_of(mesh) == "texture" else None for mesh in meshes]
        return uvs, next(iter(materials.values()))
    first, *others = (mesh.visual for mesh in textured)
    together = first.concatenate(others)
    ends = np.cumsum([len(mesh.vertices) for mesh in textured])[:-1]
    of_textured = iter(np.split(together.uv, ends))
    uvs = [next(of_textured) if _kind_of(mesh) == "texture" else None for mesh in meshes]
    return uvs, together.material


def _values_of(columns):
    return {name: column.values for name, column in columns.items()}
