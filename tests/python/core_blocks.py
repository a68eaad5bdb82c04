# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What hosts in float have to deliver: the core's float run, or the double one rounded."""

import subprocess
from pathlib import Path

import numpy as np
import pymeshlab

from run_boolean import BLOCKS

PROGRAM = Path(__file__).resolve().parents[2] / "build/release/tests/core_blocks"


def core_in_float(operands, folder):
    """The four blocks of the core's float run, and how many zero-area faces it cleaned away in all.

    operands: two (V, F), all coordinates floats; folder: for the arrays in between.
    """
    assert PROGRAM.is_file(), f"{PROGRAM} is not built"
    for k, (vertices, faces) in enumerate(operands):
        assert np.array_equal(vertices, vertices.astype(np.float32))
        vertices.astype(np.float64).tofile(folder / f"points_{k}.f64")
        faces.astype(np.uint32).tofile(folder / f"triangles_{k}.u32")
    done = subprocess.run([PROGRAM, "float", folder], capture_output=True, text=True, check=True)
    cleaned = sum(int(line.split()[1]) for line in done.stdout.splitlines())
    blocks = {
        block: (
            np.fromfile(folder / f"{block}_points.f64").reshape(-1, 3),
            np.fromfile(folder / f"{block}_triangles.u32", np.uint32).reshape(-1, 3),
        )
        for block in BLOCKS
    }
    return blocks, cleaned


def expect_equal(blocks, others):
    """Both have the same arrays, element by element."""
    for block in BLOCKS:
        for array, other in zip(blocks[block], others[block]):
            assert np.array_equal(array, other), block


def expect_rounded(points, exact):
    """The points are floats, and those of a host in double, with nothing cleaned in either.

    Both are the exact point rounded once: half an ulp of float, and of double, away from it.
    """
    ulp = np.spacing(np.abs(points).astype(np.float32)).astype(np.float64)
    assert points.shape == exact.shape
    assert (np.abs(points - exact) <= (0.5 + 2**-20) * ulp).all()


def expect_saved_in_float(path, layer):
    """The file has the faces of a layer of pymeshlab's, and its points rounded."""
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(str(path))
    saved = meshes.current_mesh()
    expect_rounded(saved.vertex_matrix(), layer.vertex_matrix())
    assert np.array_equal(saved.face_matrix(), layer.face_matrix())


def expect_saved_edges(path, layer):
    """The file, OBJ since PLY files drop edges, has those of a layer of pymeshlab's."""
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(str(path))
    assert layer.edge_number() > 0
    assert np.array_equal(meshes.current_mesh().edge_matrix(), layer.edge_matrix())
