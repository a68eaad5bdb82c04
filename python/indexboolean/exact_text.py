# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Coordinates in OBJ and OFF files with as many digits as bring back every bit.

MeshLab writes six to nine digits. All else in its files is left as it is: normals, colours, texture
coordinates and what they refer to.
"""

import os


def write_exact_coordinates(path, vertices):
    """Replaces the coordinates in the OBJ or OFF file at path by those of the vertices, n x 3.

    Raises ValueError, and changes nothing, if the file has another number of vertices.
    """
    rows = iter(vertices.tolist())
    new = path.with_name(path.name + ".exact")
    is_vertex = _IS_VERTEX[path.suffix]
    written = 0
    with open(path, encoding="utf-8") as old, open(new, "w", encoding="utf-8") as file:
        for number, line in enumerate(old):
            if is_vertex(line, number, len(vertices)) and written < len(vertices):
                head, words = _split(line)
                line = " ".join([*head, *map(repr, next(rows)), *words[3:]]) + "\n"
                written += 1
            file.write(line)
    if written != len(vertices):
        new.unlink()
        raise ValueError(f"{path} has {written} vertices, not {len(vertices)}")
    os.replace(new, path)


def _split(line):
    """The keyword of a line of an OBJ file, if it has one, and its numbers."""
    words = line.split()
    return (words[:1], words[1:]) if words[0] == "v" else ([], words)


def _is_vertex_in_obj(line, number, count):
    return line.startswith("v ")


def _is_vertex_in_off(line, number, count):
    return 2 <= number < 2 + count  # after the format's name and the counts, one a line


_IS_VERTEX = {".obj": _is_vertex_in_obj, ".off": _is_vertex_in_off}
