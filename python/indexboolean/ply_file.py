# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Binary PLY files with numbers on vertices and faces, which the host's own export leaves out.

Programs that read any property find them by name; pymeshlab passes over them.
"""

import numpy as np

_COLOURS = ("red", "green", "blue", "alpha")
_TYPES = {"u1": "uchar", "<i4": "int", "<f8": "double"}


def write_ply(path, vertices, faces, colours, attributes):
    """Writes n x 3 doubles, m x 3 indices, m x 4 bytes of colour and {name: m integers}."""
    columns = {name: np.asarray(values, dtype="<i4") for name, values in attributes.items()}
    write_ply_columns(path, vertices, faces, {}, {**colour_columns(colours), **columns})


def colour_columns(colours):
    """n x 4 bytes as the columns that programs take for colours."""
    colours = np.asarray(colours).astype("u1")
    return {name: colours[:, channel] for channel, name in enumerate(_COLOURS)}


def write_ply_columns(path, vertices, faces, of_vertices, of_faces):
    """Writes n x 3 doubles and m x 3 indices, and {name: numbers} of vertices and of faces.

    Columns are of bytes, 32-bit integers or doubles.
    """
    vertices, faces = np.reshape(vertices, (-1, 3)), np.reshape(faces, (-1, 3))
    of_vertices = {**dict(zip("xyz", vertices.astype("<f8").T)), **of_vertices}
    header = ["ply", "format binary_little_endian 1.0", f"element vertex {len(vertices)}"]
    header += _properties(of_vertices)
    header += [f"element face {len(faces)}", "property list uchar int vertex_indices"]
    header += [*_properties(of_faces), "end_header"]
    corners = [("count", "u1"), ("corners", "<i4", 3)]
    rows = _rows(len(faces), of_faces, corners)
    rows["count"] = 3
    rows["corners"] = faces
    with open(path, "wb") as file:
        file.write(("\n".join(header) + "\n").encode())
        file.write(_rows(len(vertices), of_vertices, []).tobytes())
        file.write(rows.tobytes())


def _type_of(column):
    """A column's type in a file, by that of its array."""
    kind = {"u": "u1", "i": "<i4"}.get(column.dtype.kind, "<f8")
    return "u1" if column.dtype.itemsize == 1 else kind


def _properties(columns):
    return [f"property {_TYPES[_type_of(column)]} {name}" for name, column in columns.items()]


def _rows(count, columns, before):
    """An array of `count` rows with the columns filled, behind those that the caller fills."""
    types = [(name, _type_of(column)) for name, column in columns.items()]
    rows = np.empty(count, dtype=np.dtype(before + types))
    for name, column in columns.items():
        rows[name] = column
    return rows
