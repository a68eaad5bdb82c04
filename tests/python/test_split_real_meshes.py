# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Other people's statues cut by bumpy sheets: laws, the same pieces for any order and threads.

The folder is named by INDEXBOOLEAN_MESHES: unset, these tests skip; set to no folder, they fail.
"""

import hashlib
import os
import subprocess
import sys

import numpy as np
import pytest

import mesh_laws
import paper_figures
import placements
from open_shapes import bumpy_sheet, flipped
from shapes import shuffled
from split_run import Split, check_laws

pytestmark = pytest.mark.skipif(
    not os.environ.get(placements.MESHES_VARIABLE),
    reason=f"{placements.MESHES_VARIABLE} is not set: no folder of other people's meshes",
)

PAIRS = {
    "falcon": lambda: paper_figures.FIGURES["falcon"][2](),
    "lion": lambda: paper_figures.FIGURES["lion"][2](),
    "mountain": lambda: terrain_pair(),
}


def terrain_pair():
    """An open terrain and a sheet through it: neither is closed."""
    vertices, faces = placements.read_mesh(placements.meshes_folder() / "mountain.obj")
    vertices = placements.normalised(vertices)
    flat = int(np.argmin(vertices.max(axis=0) - vertices.min(axis=0)))
    normal = np.full(3, 0.02)
    normal[flat] = 1
    return (vertices, faces), bumpy_sheet(normal, 0.0, 0.7)


@pytest.fixture(scope="module", params=PAIRS)
def split(request):
    return Split(*PAIRS[request.param]())


def test_lawsHold(split):
    check_laws(split)
    assert split.result["volume_law_residual"] < 1e-12


def test_theFlippedSheetGivesTheSameBlocks(split):
    first, second = split.operands
    other = Split(first, flipped(*second))
    assert other.counts() == split.counts()
    for number in range(split.counts()[2]):
        expected = mesh_laws.triangle_set(*split.block(number))
        assert np.array_equal(mesh_laws.triangle_set(*other.block(number)), expected)


def test_renumberedOperandsGiveTheSamePieces(split):
    rng = np.random.default_rng(20260101)
    other = Split(*(shuffled(*mesh, rng) for mesh in split.operands))
    assert other.counts() == split.counts()
    for one, two in zip((*split.surfaces, split.blocks), (*other.surfaces, other.blocks)):
        for name in set(one.numbers) - {"source_face"}:
            for number in np.unique(one[name]):
                expected = mesh_laws.triangle_set(*one.part(name, number))
                assert np.array_equal(mesh_laws.triangle_set(*two.part(name, number)), expected)


def digest(split):
    """Of the bytes of all layers."""
    found = hashlib.sha256()
    for piece in (*split.surfaces, split.blocks):
        for array in (piece.vertices, piece.faces, *piece.numbers.values()):
            found.update(array.tobytes())
    return found.hexdigest()


def test_sameBytesForAnyNumberOfThreads(split, tmp_path):
    (va, fa), (vb, fb) = split.operands
    np.savez(tmp_path / "operands.npz", va=va, fa=fa, vb=vb, fb=fb)
    for threads in (1, 2, 8):
        output = subprocess.run(
            [sys.executable, __file__, str(tmp_path / "operands.npz")], check=True,
            env={**os.environ, "OMP_NUM_THREADS": str(threads)}, capture_output=True, text=True,
        ).stdout
        assert output.split()[-1] == digest(split), f"{threads} threads"


if __name__ == "__main__":
    operands = np.load(sys.argv[1])
    print(digest(Split(*((operands[f"v{k}"], operands[f"f{k}"]) for k in "ab"))))
