# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""in: the columns of several meshes; out: those of a mesh that a filter has made of them.

A face has the values of the face that it comes from, whatever their type. A vertex that was one
before has its own; a new one has what the filter gives it, as docs/attributes.md says: the mean of
the corners of the face that it lies in. For that, layers have custom attributes with the numbers of
a row as doubles; with 0 for NaN and a flag beside it, since the filter parts vertices in one place
whose attributes differ, as a NaN does from itself.

Guarantee: what was not cut keeps its values bit by bit.
"""

import numpy as np

from .mesh_record import Column

_MIXABLE = "biufc"  # numpy's letters for the types that have a mean
FACE_CLASS = "face_class"


class CarriedColumns:
    """The columns of the records, one mesh's values after those of the one before.

    Memory: about that of all columns. Complexity: linear, and n log n if faces are classed.
    """

    def __init__(self, records):
        self.normals = _name_of_normals(records)
        vertex_counts = [len(record.vertices) for record in records]
        face_counts = [len(record.faces) for record in records]
        self._first_vertex = np.cumsum([0, *vertex_counts])
        self._first_face = np.cumsum([0, *face_counts])
        self._of_vertices = _joined(
            [_without(record.of_vertices, {record.normals} - {self.normals}) for record in records],
            vertex_counts,
        )
        self._of_faces = _joined([record.of_faces for record in records], face_counts)
        self._with_nan = {
            number for number, column in self._mixed_columns()
            if column.values.dtype.kind in "fc" and np.isnan(column.values).any()
        }

    def __bool__(self):
        return bool(self._of_vertices or self._of_faces)

    def given_normals(self):
        """The normals of all records' vertices, one record's after those of the one before."""
        return _doubles(self._of_vertices[self.normals].values)

    def add_normals(self, record, normals):
        """Gives a record the column of the normals, from n x 3 doubles."""
        kind = self._of_vertices[self.normals].values.dtype
        record.normals = self.normals
        record.of_vertices[self.normals] = Column(normals.astype(kind))

    def add_to(self, layer, operand):
        """Gives a pymeshlab.Mesh, which is that operand, the attributes of its vertices."""
        rows = slice(*self._first_vertex[operand:operand + 2])
        for number, column in self._mixed_columns():
            doubles = self._encoded(number, column.values[rows])
            for part, attribute in _parts(number, doubles.shape[1]):
                if len(part) == 3:
                    layer.add_vertex_custom_point_attribute(doubles[:, part], attribute)
                else:
                    layer.add_vertex_custom_scalar_attribute(doubles[:, part[0]], attribute)

    def add_classes_to(self, layer, operand, face):
        """Gives it a number for each face: two have the same if all columns have one value there.

        face: which of the operand's faces each of its triangles is.
        """
        classes = np.zeros(self._first_face[-1], dtype=np.int64)
        for column in self._of_faces.values():
            rows = column.values.reshape(len(column.values), -1)
            for values in rows.T:
                numbers = np.unique(values, return_inverse=True)[1].ravel()
                classes = np.unique(classes * (len(numbers) + 1) + numbers, return_inverse=True)[1]
        classes = classes[self._first_face[operand] + face]
        layer.add_face_custom_scalar_attribute(classes.astype(np.float64), FACE_CLASS)

    def of_faces(self, operand, face):
        """{name: Column} of faces that come from these faces of these operands."""
        rows = self._first_face[operand] + face
        return {name: Column(column.values[rows]) for name, column in self._of_faces.items()}

    def of_vertices(self, layer, operand, vertex):
        """{name: Column} of a new layer's vertices, without normals; vertex -1: a new one."""
        was_there = np.flatnonzero(vertex >= 0)
        rows = self._first_vertex[operand[was_there]] + vertex[was_there]
        columns = {}
        mixed = dict(self._mixed_columns())
        for number, (name, column) in enumerate(self._of_vertices.items()):
            if name == self.normals:
                continue
            own = column.values[rows]
            if number in mixed:
                width = self._encoded(number, column.values[:0]).shape[1]
                doubles = self._decoded(number, _read(layer, number, width))
                values = _from_doubles(doubles, own)
                # Where the filter took them as they were, a large integer must not be rounded.
                is_own = _same_rows(doubles[was_there], _doubles(own))
                values[was_there[is_own]] = own[is_own]
            else:
                values = np.full((len(vertex), *own.shape[1:]), column.missing, own.dtype)
                values[was_there] = own
            columns[name] = Column(values)
        return columns

    def _encoded(self, number, values):
        """Rows of doubles that equal themselves."""
        doubles = _doubles(values)
        if number not in self._with_nan:
            return doubles
        is_nan = np.isnan(doubles)
        return np.concatenate([np.where(is_nan, 0, doubles), is_nan], axis=1)

    def _decoded(self, number, encoded):
        if number not in self._with_nan:
            return encoded
        doubles, is_nan = np.split(encoded, 2, axis=1)
        return np.where(is_nan > 0, np.nan, doubles)

    def _mixed_columns(self):
        """(number, column) of those that the filter mixes."""
        return [
            (number, column) for number, (name, column) in enumerate(self._of_vertices.items())
            if column.values.dtype.kind in _MIXABLE and name != self.normals
        ]


def _name_of_normals(records):
    """The column of normals that all records have; None: there is none, and those of some are lost.
    """
    names = {record.normals for record in records}
    return names.pop() if len(names) == 1 else None


def _without(columns, names):
    return {name: column for name, column in columns.items() if name not in names}


def _parts(number, width):
    """(the numbers of a row, the attribute's name): three at a time, what is left one by one."""
    ends = width - width % 3
    parts = [range(i, i + 3) for i in range(0, ends, 3)] + [[i] for i in range(ends, width)]
    return [(list(part), f"column {number} {part[0]}") for part in parts]


def _read(layer, number, width):
    """What add_to has written, of a layer that a filter made."""
    doubles = np.empty((layer.vertex_number(), width))
    for part, attribute in _parts(number, width):
        if len(part) == 3:
            doubles[:, part] = layer.vertex_custom_point_attribute_matrix(attribute)
        else:
            doubles[:, part[0]] = layer.vertex_custom_scalar_attribute_array(attribute)
    return doubles


def _joined(columns_of_all, counts):
    """{name: Column}: of one that meshes have in different shapes, those of the first's."""
    joined = {}
    for name in dict.fromkeys(name for columns in columns_of_all for name in columns):
        first = next(columns[name] for columns in columns_of_all if name in columns)
        shape = first.values.shape[1:]
        having = [
            columns[name].values if name in columns and columns[name].values.shape[1:] == shape
            else None for columns in columns_of_all
        ]
        dtype = _common_type([values.dtype for values in having if values is not None])
        missing = _missing_of(dtype) if first.missing is None else first.missing
        values = np.concatenate([
            np.full((count, *shape), missing, dtype) if own is None else own.astype(dtype)
            for own, count in zip(having, counts)
        ])
        joined[name] = Column(values, missing)
    return joined


def _common_type(types):
    try:
        return np.result_type(*types)
    except TypeError:
        return np.dtype(object)


def _missing_of(dtype):
    return np.nan if dtype.kind in "fc" else np.zeros((), dtype)[()]


def _doubles(values):
    """Rows of doubles; a complex number is two."""
    rows = values.reshape(len(values), int(np.prod(values.shape[1:])))
    if rows.dtype.kind == "c":
        rows = rows.astype(np.complex128).view(np.float64)
    return rows.astype(np.float64)


def _from_doubles(doubles, like):
    """Values of the type and the shape of `like`; integers are rounded, False unless all is 1."""
    kind = like.dtype.kind
    shape = (len(doubles), *like.shape[1:])
    if kind == "b":
        return (doubles == 1).reshape(shape)
    if kind == "c":
        return np.ascontiguousarray(doubles).view(np.complex128).reshape(shape).astype(like.dtype)
    if kind in "iu":
        limits = np.iinfo(like.dtype)
        rounded = np.rint(doubles)
        # The nearest double to the largest number of 64 bits lies beyond it.
        is_most = rounded >= limits.max
        values = np.where(is_most, 0, rounded).clip(min=limits.min).astype(like.dtype)
        values[is_most] = limits.max
        return values.reshape(shape)
    return doubles.reshape(shape).astype(like.dtype)


def _same_rows(a, b):
    return np.all((a == b) | (np.isnan(a) & np.isnan(b)), axis=1)
