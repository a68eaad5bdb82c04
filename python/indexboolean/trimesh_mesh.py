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
        of_vertices[_COLOUR] = Column(_vertex_colours(mesh), missing=255)
    elif kind == "face" and has_any:
        of_faces[_COLOUR] = Column(_face_colours(mesh), missing=255)
    elif uv is not None:
        of_vertices[_UV] = Column(np.asarray(uv), missing=0)
    return checked_record(mesh.vertices, mesh.faces, of_vertices=of_vertices, of_faces=of_faces)


def _vertex_colours(mesh):
    """n x 4 bytes; of a texture those of its image, or its material's only colour."""
    if mesh.visual.kind != "texture":
        return mesh.visual.vertex_colors
    material = mesh.visual.material
    if _image_of(material) is None:
        return np.tile(_colour_of(material), (len(mesh.vertices), 1))
    return mesh.visual.to_color().vertex_colors


def _face_colours(mesh):
    """m x 4 bytes; of a texture the mean of its corners'."""
    if mesh.visual.kind != "texture":
        return mesh.visual.face_colors
    return np.rint(_vertex_colours(mesh)[mesh.faces].mean(axis=1)).astype(np.uint8)


def _image_of(material):
    return getattr(material, "image", None) or getattr(material, "baseColorTexture", None)


def _colour_of(material):
    """Four bytes, also of a material that has no colour: those that trimesh draws it with."""
    return sys.modules["trimesh"].visual.color.to_rgba(material.main_color)


def _texture_coordinates(meshes):
    """(the texture coordinates of each, or None; the one material): as trimesh joins visuals."""
    textured = [mesh.visual for mesh in meshes if _kind_of(mesh) == "texture"]
    materials = {hash(visual.material): visual.material for visual in textured}
    joined, material = [visual.uv for visual in textured], next(iter(materials.values()))
    if len(materials) > 1:
        first, *others = _of_one_kind(textured)
        together = first.concatenate(others)
        ends = np.cumsum([len(uv) for uv in joined])[:-1]
        joined, material = np.split(together.uv, ends), together.material
    joined = iter(joined)
    uvs = [next(joined) if _kind_of(mesh) == "texture" else None for mesh in meshes]
    return uvs, material


def _of_one_kind(visuals):
    """The visuals, all with a PBRMaterial if any has one: trimesh joins no two kinds."""
    trimesh = sys.modules["trimesh"]
    of_pbr = trimesh.visual.material.PBRMaterial
    if not any(isinstance(visual.material, of_pbr) for visual in visuals):
        return visuals
    alike = []
    for visual in visuals:
        material = visual.material
        if not isinstance(material, of_pbr):
            # Not to_pbr(), which multiplies the image by a colour that is drawn without one only.
            image = _image_of(material) or _image_of_colour(_colour_of(material))
            material = of_pbr(
                baseColorTexture=image, roughnessFactor=material.to_pbr().roughnessFactor
            )
        alike.append(trimesh.visual.TextureVisuals(uv=visual.uv, material=material))
    return alike


def _image_of_colour(colour):
    from PIL import Image  # which trimesh packs images with

    return Image.fromarray(np.asarray(colour, dtype=np.uint8).reshape(1, 1, 4))


def _values_of(columns):
    return {name: column.values for name, column in columns.items()}
