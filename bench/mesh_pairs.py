# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pairs of other people's meshes, as arguments of index_boolean_bench that place them.

in: the folder that MESHES_VARIABLE names; out: for each pair its two files and the arguments.
"""

import json

MESHES_VARIABLE = "INDEXBOOLEAN_MESHES"


def standard_pair(folder, first, second):
    """In standard placement: centred, longest side 1, the second turned."""
    files = (folder / first, folder / second)
    return files, [*map(str, files), "--place", "standard"]


def ember_pairs(folder):
    """Those of the EMBER benchmark, in the order of their file."""
    def flat(matrix):
        return ",".join(repr(number) for row in matrix for number in row)

    pairs = []
    for entry in json.loads((folder / "ember_cases.json").read_text()):
        files = (folder / entry["a"], folder / entry["b"])
        transforms = [
            "--transform-first", flat(entry["transform_a"]),
            "--transform-second", flat(entry["transform_b"]),
        ]
        pairs.append((files, [*map(str, files), *transforms]))
    return pairs
