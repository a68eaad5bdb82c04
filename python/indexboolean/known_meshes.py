# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of any library that is known, and of several at once, as MeshRecords, and back.

Guarantee: a library is never imported: a mesh of its can only be there if the caller has done so.
"""

import numpy as np

from . import array_mesh, meshio_mesh, pyvista_mesh, trimesh_mesh
from .mesh_document import MeshRefusal

_LIBRARIES = (trimesh_mesh, pyvista_mesh, meshio_mesh, array_mesh)
_KNOWN = "trimesh.Trimesh, pyvista.PolyData, meshio.Mesh and pairs (vertices, faces)"
_REMEDIES = {
    "trimesh.scene.scene.Scene": "scene.to_mesh() makes one mesh of it",
    "pyvista.core.pointset.UnstructuredGrid": "grid.extract_surface() makes a PolyData of it",
    "pyvista.core.pointset.StructuredGrid": "grid.extract_surface() makes a PolyData of it",
    "pyvista.core.composite.MultiBlock": "pass its blocks one by one",
}


class KnownMeshes:
    """The meshes of a call: `records`, and what makes meshes of the first one's type.

    meshes is {name: mesh}; the names are for sentences. Raises TypeError for what is no mesh, and
    MeshRefusal, with the mesh's number, for one that cannot be read.
    """

    def __init__(self, meshes):
        self.names = list(meshes)
        self._meshes = list(meshes.values())
        if not self._meshes:
            raise TypeError("there is no mesh")
        self._kinds = [_library_of(name, mesh) for name, mesh in meshes.items()]
        self.records = [None] * len(self._meshes)
        for library in dict.fromkeys(self._kinds):
            self._read(library)

    def mesh_of(self, record, like=0):
        """A mesh of the type of the one with that number."""
        library = self._kinds[like]
        operands = [mesh for mesh, kind in zip(self._meshes, self._kinds) if kind is library]
        first = self._meshes[like]
        return library.write(record, [first, *(mesh for mesh in operands if mesh is not first)])

    def is_pair(self, number):
        """Whether that mesh is a pair of arrays, which cannot have columns."""
        return self._kinds[number] is array_mesh

    def can_have_polygons(self, numbers):
        """Whether meshes of the types of all these can."""
        return all(self._kinds[number].HAS_POLYGONS for number in numbers)

    def _read(self, library):
        own = [number for number, kind in enumerate(self._kinds) if kind is library]
        try:
            records = library.read_all([self._meshes[number] for number in own])
        except ValueError:
            for number in own:
                self._read_alone(library, number)
            raise
        for number, record in zip(own, records):
            if len(record.vertices) == 0:  # of which the host makes no layer
                raise MeshRefusal(
                    f'Mesh "{self.names[number]}" is empty: it has no faces and no vertices. '
                    "Choose a mesh with faces.", number
                )
            self.records[number] = record

    def _read_alone(self, library, number):
        """Says which one cannot be read, if it is this one."""
        try:
            library.read_all([self._meshes[number]])
        except ValueError as error:
            sentence = f'Mesh "{self.names[number]}" cannot be used: {error}.'
            raise MeshRefusal(sentence, number, getattr(error, "faces", ())) from error


def kind_of(value):
    """The name of its class, with that of the module."""
    return f"{type(value).__module__}.{type(value).__qualname__}".removeprefix("builtins.")


def _library_of(name, mesh):
    if isinstance(mesh, (tuple, list)) and any(map(_is_a_mesh, mesh)):
        raise TypeError(
            f'mesh "{name}" is a {kind_of(mesh)} of meshes; they are passed one by one, as in '
            'split(a, b), or by names, as in evaluate("a | b", {"a": a, "b": b})'
        )
    for library in _LIBRARIES:
        if library.is_mesh(mesh):
            return library
    kind = kind_of(mesh)
    remedy = _REMEDIES.get(kind)
    more = f"; {remedy}" if remedy else ""
    raise TypeError(f'mesh "{name}" is of type {kind}; known are {_KNOWN}{more}')


def _is_a_mesh(item):
    """Whether an item of a list is one; points and faces, and lists of them, are none."""
    if array_mesh.is_mesh(item):
        vertices = item[0]
        if isinstance(vertices, (tuple, list)):
            return len(vertices) > 0 and np.ndim(vertices[0]) == 1
        return np.ndim(vertices) == 2
    return any(library.is_mesh(item) for library in _LIBRARIES)
