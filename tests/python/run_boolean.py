# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The filter as the tests call it: arrays in, blocks and result map out.

As a program, `run_boolean.py OPERANDS.npz` prints the digests of all that one run delivers, so
that runs in fresh processes, with other numbers of threads, can be compared byte for byte.
"""

import hashlib
import json
import sys

import numpy as np
import pymeshlab

import indexboolean

BLOCKS = ("union", "intersection", "first_minus_second", "second_minus_first")
# The same blocks once the operands are swapped.
SWAPPED_BLOCKS = ("union", "intersection", "second_minus_first", "first_minus_second")


def run_boolean(first_vertices, first_faces, second_vertices, second_faces, **parameters):
    """Runs the filter on two meshes.

    Returns {block: (V, F)} for each requested block, and under "result" the result map.
    Raises pymeshlab.PyMeshLabException when the filter refuses.
    """
    indexboolean.load_plugin()
    mesh_set = pymeshlab.MeshSet()
    mesh_set.add_mesh(pymeshlab.Mesh(first_vertices, first_faces), "first")
    mesh_set.add_mesh(pymeshlab.Mesh(second_vertices, second_faces), "second")
    result = mesh_set.generate_index_boolean(first_mesh=0, second_mesh=1, **parameters)
    blocks = {"result": result}
    for block in BLOCKS + ("symmetric_difference",):
        if f"{block}_layer" in result:
            mesh = mesh_set.mesh(int(result[f"{block}_layer"]))
            blocks[block] = (
                np.ascontiguousarray(mesh.vertex_matrix()),
                np.ascontiguousarray(mesh.face_matrix(), dtype=np.int64),
            )
    return blocks


def digests(blocks):
    """A digest of the bytes of each block's arrays, and the exact figures of the result map."""
    found = {}
    for block, arrays in blocks.items():
        if block != "result":
            found[block] = [hashlib.sha256(array.tobytes()).hexdigest() for array in arrays]
    for key, value in blocks["result"].items():
        if not key.startswith("seconds_"):
            found[f"result {key}"] = value.hex() if isinstance(value, float) else value
    return found


def main():
    operands = np.load(sys.argv[1])
    blocks = run_boolean(*(operands[name] for name in ("va", "fa", "vb", "fb")))
    print(json.dumps(digests(blocks), sort_keys=True))


if __name__ == "__main__":
    main()
