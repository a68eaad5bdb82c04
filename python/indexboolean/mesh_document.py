# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""MeshRecords as the layers of a pymeshlab document, a filter's run on them, new layers as records.

Guarantee: coordinates go in and out as doubles, bit by bit.
"""

import functools

import numpy as np

from .carried_columns import CarriedColumns
from .host_lock import host_lock
from .host_words import in_words_of_python
from .mesh_record import Column, MeshRecord
from .option_values import taken
from .plugin import LENGTHS, load_plugin
from .turned_normals import turned_normals


class MeshRefusal(ValueError):
    """Meshes that an operation refuses.

    sentence: what is wrong, how often, where, and what helps. operand: which of the meshes, from 0
    on, or None. faces: the numbers of the faces of that mesh in question, an array.
    """

    def __init__(self, sentence, operand=None, faces=()):
        super().__init__(sentence)
        self.sentence = sentence
        self.operand = operand
        self.faces = np.asarray(faces, dtype=np.int64)


class _Triangulation:
    """Which face of a record each triangle of its layer is; face None: the same."""

    def __init__(self, face):
        self.face = face

    def faces_of(self, triangles):
        return triangles if self.face is None else self.face[triangles]


class _Sources:
    """Which operand's triangle and vertex those of a new layer are; a new vertex: -1 and -1.

    operands: what the numbers in the layer's attributes stand for.
    """

    def __init__(self, layer, operands):
        of_faces = layer.face_custom_scalar_attribute_array
        of_vertices = layer.vertex_custom_scalar_attribute_array
        operand = _integers([*operands, -1])
        self.mesh = operand[_integers(of_faces("source_mesh"))]
        self.triangle = _integers(of_faces("source_face"))
        self.mesh_of_vertex = operand[_integers(of_vertices("source_mesh"))]
        self.vertex = _integers(of_vertices("source_vertex"))


class MeshDocument:
    """A document whose first layers are the records, by their names.

    keeps_polygons: polygons are given as such, and come back as such; else as triangles. classes:
    faces have a number that two share if all columns have one value on both, as merging coplanar
    faces needs it. columns: False: columns are left out.
    """

    _refused = None  # the host writes to the log of the document that was refused last

    def __init__(self, records, names, keeps_polygons=True, classes=False, columns=True):
        with host_lock():
            self.meshes = _host().MeshSet()
        self._columns = CarriedColumns(records if columns else [])
        self._has_polygons = keeps_polygons and any(record.has_polygons for record in records)
        self._triangulations = []
        for number, (record, name) in enumerate(zip(records, names)):
            mesh, triangulation = self._layer_of(record, keeps_polygons)
            if columns:
                self._columns.add_to(mesh, number)
                if classes:
                    face = triangulation.faces_of(np.arange(mesh.face_number()))
                    self._columns.add_classes_to(mesh, number, face)
            with host_lock():
                self.meshes.add_mesh(mesh, name)
            self._triangulations.append(triangulation)

    @property
    def has_columns(self):
        """Whether the records have any."""
        return bool(self._columns)

    def run(self, filter_name, own, options):
        """The filter's result map; own are the caller's parameters, options those of its user.

        Raises MeshRefusal, MemoryError, TypeError for options that the filter does not have and
        for values of another type, and ValueError for values that an option does not have.
        """
        pymeshlab = _host()
        with host_lock():
            parameters = {**own, **_as_the_host_takes_them(filter_name, own, options)}
            try:
                return self.meshes.apply_filter(filter_name, **parameters)
            except pymeshlab.InvalidEnumException as error:
                raise ValueError(str(error).strip()) from None
            except pymeshlab.PyMeshLabException as error:
                MeshDocument._refused = self.meshes
                _, _, refusal = str(error).partition("Details: ")  # after the host's own opening
                raise self._refusal(refusal or str(error)) from None

    def _refusal(self, sentence):
        if "bad_alloc" in sentence or "not enough memory" in sentence:
            return MemoryError(sentence)
        operand, faces = None, ()
        for number, triangulation in enumerate(self._triangulations):
            mesh = self.meshes.mesh(number)
            if mesh.selected_face_number() > 0:
                triangles = np.flatnonzero(mesh.face_selection_array())
                operand, faces = number, np.unique(triangulation.faces_of(triangles))
        self.meshes.clear()  # it stays for its log only
        return MeshRefusal(in_words_of_python(sentence), operand, faces)

    def faces_of(self, number, triangles):
        """Which faces of a record these triangles of its layer are; -1 stays -1."""
        triangles = _integers(triangles)
        return np.where(triangles < 0, -1, self._triangulations[number].faces_of(triangles))

    def layer(self, number):
        """The pymeshlab.Mesh of that id."""
        return self.meshes.mesh(number)

    def record_of(self, number, operands=None, with_sources=False, numbers=()):
        """The new layer of that id, with its columns.

        operands: which record each number in the layer's attributes of sources stands for; None:
        its own. with_sources: columns source_mesh, source_face and source_vertex, too. numbers:
        attributes of faces that become columns of integers.
        """
        layer = self.meshes.mesh(number)
        record = MeshRecord(
            np.ascontiguousarray(layer.vertex_matrix()), np.ascontiguousarray(layer.face_matrix())
        )
        triangles, chosen = record.faces, slice(None)
        if self._has_polygons:
            record.faces = layer.polygonal_face_list()
            chosen = _triangle_of_each(record.faces, triangles)
        if self._columns or with_sources:
            own = range(len(self._triangulations))
            sources = _Sources(layer, own if operands is None else operands)
            self._add_columns(layer, record, sources, chosen, with_sources)
            if self._columns.normals is not None:
                self._add_normals(record, triangles, sources)
        for name in numbers:
            values = layer.face_custom_scalar_attribute_array(name)
            record.of_faces[name] = Column(_integers(values)[chosen])
        return record

    def _add_columns(self, layer, record, sources, chosen, with_sources):
        mesh, face = sources.mesh[chosen], sources.triangle[chosen]
        for number, triangulation in enumerate(self._triangulations):
            own = mesh == number
            face[own] = triangulation.faces_of(face[own])
        record.of_vertices = self._columns.of_vertices(
            layer, sources.mesh_of_vertex, sources.vertex
        )
        record.of_faces = self._columns.of_faces(mesh, face)
        if with_sources:
            record.of_vertices["source_mesh"] = Column(sources.mesh_of_vertex)
            record.of_vertices["source_vertex"] = Column(sources.vertex)
            record.of_faces["source_mesh"] = Column(mesh)
            record.of_faces["source_face"] = Column(face)

    def _add_normals(self, record, triangles, sources):
        given = [self.meshes.mesh(number) for number in range(len(self._triangulations))]
        first_vertex = np.cumsum([0, *(mesh.vertex_number() for mesh in given)])
        first_face = np.cumsum([0, *(mesh.face_number() for mesh in given)])
        corners = [mesh.face_matrix() + first for mesh, first in zip(given, first_vertex)]
        vertex = np.where(
            sources.vertex < 0, -1, first_vertex[sources.mesh_of_vertex] + sources.vertex
        )
        normals = turned_normals(
            self._columns.given_normals(),
            (np.concatenate([mesh.vertex_matrix() for mesh in given]), np.concatenate(corners)),
            (record.vertices, triangles, first_face[sources.mesh] + sources.triangle, vertex),
        )
        self._columns.add_normals(record, normals)

    def _layer_of(self, record, keeps_polygons):
        pymeshlab = _host()
        if not record.has_polygons:
            return pymeshlab.Mesh(record.vertices, record.faces), _Triangulation(None)
        polygons = [np.asarray(face, dtype=np.uint32) for face in record.faces]
        mesh = pymeshlab.Mesh(record.vertices, polygons)
        face = _integers(mesh.face_custom_scalar_attribute_array("poly_birth_faces"))
        if not keeps_polygons:
            mesh = pymeshlab.Mesh(record.vertices, mesh.face_matrix())
        return mesh, _Triangulation(face)


def _integers(numbers):
    return np.asarray(numbers).astype(np.int64)


def _triangle_of_each(polygons, triangles):
    """A triangle of each polygon: one with its first edge."""
    corners = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    edges = corners[:, 0].astype(np.int64) << 32 | corners[:, 1]
    order = np.argsort(edges, kind="stable")
    first = np.array([polygon[:2] for polygon in polygons], dtype=np.int64).reshape(-1, 2)
    wanted = first[:, 0] << 32 | first[:, 1]
    return order[np.searchsorted(edges, wanted, sorter=order)] % max(len(triangles), 1)


@functools.lru_cache(maxsize=None)
def _host():
    """pymeshlab, with the plugin loaded."""
    load_plugin()
    import pymeshlab

    return pymeshlab


@functools.lru_cache(maxsize=None)
def _parameters_of(filter_name):
    """{name: default} of a filter, which the host tells only of a document with a layer."""
    meshes = _host().MeshSet()
    meshes.add_mesh(_host().Mesh(np.zeros((1, 3))))
    return meshes.filter_parameter_values(filter_name)


def _as_the_host_takes_them(filter_name, own, options):
    """The options with values of the host's types."""
    known = {k: v for k, v in _parameters_of(filter_name).items() if k not in own}
    unknown = sorted(options.keys() - known.keys())
    if unknown:
        raise TypeError(f"there is no option {unknown[0]}; there are {', '.join(sorted(known))}")
    values = {name: taken(name, value, known[name]) for name, value in options.items()}
    return {
        name: _host().PureValue(value) if name in LENGTHS else value
        for name, value in values.items()
    }
