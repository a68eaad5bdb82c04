# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Binary PLY files with numbers on the faces, which the host's own export leaves out.

Programs that read any property find them by name; pymeshlab passes over them.
"""

import numpy as np

_COLOURS = ("red", "green", "blue", "alpha")


def write_ply(path, vertices, faces, colours, attributes):
    """Writes n x 3 doubles, m x 3 indices, m x 4 bytes of colour and {name: m integers}."""
    names = list(attributes)
    row = np.dtype(
        [("count", "u1"), ("corners", "<i4", 3)]
        + [(colour, "u1") for colour in _COLOURS]
        + [(name, "<i4") for name in names]
    )
    rows = np.empty(len(faces), dtype=row)
    rows["count"] = 3
    rows["corners"] = faces
    for channel, colour in enumerate(_COLOURS):
        rows[colour] = colours[:, channel]
    for name in names:
        rows[name] = attributes[name]
    header = [
        "ply",
        "format binary_little_endian 1.0",
        f"element vertex {len(vertices)}",
        *(f"property double {axis}" for axis in "xyz"),
        f"element face {len(faces)}",
        "property list uchar int vertex_indices",
        *(f"property uchar {colour}" for colour in _COLOURS),
        *(f"property int {name}" for name in names),
        "end_header",
    ]
    with open(path, "wb") as file:
        file.write(("\n".join(header) + "\n").encode())
        file.write(np.ascontiguousarray(vertices, dtype="<f8").tobytes())
        file.write(rows.tobytes())
