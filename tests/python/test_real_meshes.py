# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the filter promises, shown on other people's meshes in their standard placements.

The folder is named by INDEXBOOLEAN_MESHES: unset, these tests skip; set to no folder, they fail.
"""

import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import contact_filter
import mesh_laws
import oracles
import placements
import run_boolean as filter_run
from run_boolean import BLOCKS, SWAPPED_BLOCKS

pytestmark = pytest.mark.skipif(
    not os.environ.get(placements.MESHES_VARIABLE),
    reason=f"{placements.MESHES_VARIABLE} is not set: no folder of other people's meshes",
)

# Volumes that libigl and manifold3d gave for the placements, to the digits written.
KNOWN_VOLUMES = {
    "armadillo-bunny": (0.2428, 0.02604, 0.04262),
    "falcon-skull": (0.2346, 0.05088, 0.02495),
}
# Sides on which an uncut face can be: the blocks that keep it, per operand; True: turned over.
KEEPERS = (
    {"outside": (("union", False), ("first_minus_second", False)),
     "inside": (("intersection", False), ("second_minus_first", True))},
    {"outside": (("union", False), ("second_minus_first", False)),
     "inside": (("intersection", False), ("first_minus_second", True))},
)


class Run:
    """A pair of operands, its blocks, and figures that several tests need."""

    def __init__(self, name):
        self.name = name
        self.operands = placements.load_pair(name, placements.meshes_folder())
        self.blocks = filter_run.run_boolean(*self.operands)
        self.first_volume = mesh_laws.volume(*self.operands[:2])
        self.second_volume = mesh_laws.volume(*self.operands[2:])
        self.scale = self.first_volume + self.second_volume
        self.volumes = oracles.volumes({block: self.blocks[block] for block in BLOCKS})
        self.uncut = contact_filter.certainly_uncut(*self.operands)


@pytest.fixture(scope="module", params=placements.PAIR_NAMES)
def run(request):
    return Run(request.param)


def test_placementIsTheKnownOne(run):
    found = [run.volumes[block] for block in BLOCKS]
    for volume, known in zip(found, KNOWN_VOLUMES.get(run.name, ())):
        assert float(f"{volume:.4g}") == known


@pytest.mark.parametrize("block", BLOCKS)
def test_blockIsClosedWithoutZeroArea(run, block):
    vertices, faces = run.blocks[block]
    assert len(faces) > 0
    assert mesh_laws.unmatched_edges(vertices, faces) == 0
    assert len(mesh_laws.zero_area_faces(vertices, faces)) == 0
    assert len(np.unique(faces)) == len(vertices), "unreferenced vertices"


def test_volumeLawsHold(run):
    volumes = run.volumes
    union_law = volumes["union"] + volumes["intersection"] - run.scale
    first_law = volumes["first_minus_second"] + volumes["intersection"] - run.first_volume
    second_law = volumes["second_minus_first"] + volumes["intersection"] - run.second_volume
    for law in (union_law, first_law, second_law):
        assert abs(law) <= 1e-12 * run.scale
    assert run.blocks["result"]["volume_law_residual"] <= 1e-12


def test_resultMapAgreesWithTheLayers(run):
    result = run.blocks["result"]
    for block in BLOCKS:
        vertices, faces = run.blocks[block]
        assert abs(result[f"{block}_volume"] - run.volumes[block]) <= 1e-12 * run.scale
        assert result[f"{block}_area"] == pytest.approx(mesh_laws.area(vertices, faces), rel=1e-12)
        assert result[f"{block}_faces"] == len(faces)
        assert result[f"{block}_components"] == mesh_laws.component_count(faces, len(vertices))
        assert result[f"{block}_closed"]


def test_blocksEqualThoseOfManifold(run):
    expected = oracles.manifold_blocks(*run.operands)
    for block in BLOCKS:
        difference = run.volumes[block] - mesh_laws.volume(*expected[block])
        assert abs(difference) <= 1e-9 * run.scale, block
        area = mesh_laws.area(*expected[block])
        assert mesh_laws.area(*run.blocks[block]) == pytest.approx(area, rel=1e-9), block


def test_intersectionEqualsThatOfLibigl(run):
    # With the volume laws, the other three blocks follow; libigl takes seconds for each.
    expected = oracles.libigl_block("intersection", *run.operands)
    difference = run.volumes["intersection"] - mesh_laws.volume(*expected)
    assert abs(difference) <= 1e-9 * run.scale
    area = mesh_laws.area(*expected)
    assert mesh_laws.area(*run.blocks["intersection"]) == pytest.approx(area, rel=1e-9)


@pytest.mark.parametrize("operand", (0, 1))
def test_uncutFacesStayBitIdentical(run, operand):
    vertices, faces = run.operands[2 * operand : 2 * operand + 2]
    uncut = faces[run.uncut[operand]]
    assert len(uncut) > 0.7 * len(faces), "the check would say little"
    rows = mesh_laws.triangle_rows(vertices, uncut)
    turned_rows = mesh_laws.triangle_rows(vertices, mesh_laws.reversed_faces(uncut))
    kept = np.zeros(len(uncut), dtype=bool)
    points_kept = np.zeros(len(uncut), dtype=bool)
    for keepers in KEEPERS[operand].values():
        found, found_points = [], []
        for block, turned in keepers:
            points, triangles = run.blocks[block]
            block_rows = mesh_laws.triangle_rows(points, triangles)
            found.append(mesh_laws.rows_in(turned_rows if turned else rows, block_rows))
            found_points.append(mesh_laws.rows_in(vertices, points)[uncut].all(axis=1))
        assert np.array_equal(*found), f"{keepers} keep different uncut faces"
        assert not np.any(kept & found[0]), "a face is kept inside and outside"
        kept |= found[0]
        points_kept |= found_points[0] & found_points[1]
    # Cleaning may split an uncut face beside a sliver; it never moves a vertex.
    assert np.all(points_kept), f"{np.sum(~points_kept)} uncut faces have a vertex that moved"
    assert np.sum(~kept) <= run.blocks["result"]["zero_area_faces_removed"]


def test_sameBytesForAnyNumberOfThreadsAndAgain(run, tmp_path):
    va, fa, vb, fb = run.operands
    np.savez(tmp_path / "operands.npz", va=va, fa=fa, vb=vb, fb=fb)
    expected = filter_run.digests(run.blocks)
    for threads in (1, 2, 8, 2):
        output = subprocess.run(
            [sys.executable, filter_run.__file__, str(tmp_path / "operands.npz")],
            env={**os.environ, "OMP_NUM_THREADS": str(threads)},
            check=True,
            capture_output=True,
            text=True,
        ).stdout
        found = json.loads(output.splitlines()[-1])
        different = [key for key in expected if found.get(key) != expected[key]]
        assert not different, f"{threads} threads: {different}"


def same_geometry(run, other, names=BLOCKS):
    """The blocks whose sets of triangles differ, with the number of triangles of each alone."""
    different = {}
    for block, name in zip(BLOCKS, names):
        rows = mesh_laws.triangle_set(*run.blocks[block])
        others = mesh_laws.triangle_set(*other[name])
        if not np.array_equal(rows, others):
            alone = (mesh_laws.rows_in(rows, others), mesh_laws.rows_in(others, rows))
            different[block] = tuple(int(np.sum(~common)) for common in alone)
    return different


def test_swappedOperandsGiveTheSameGeometry(run):
    other = filter_run.run_boolean(*run.operands[2:], *run.operands[:2])
    assert same_geometry(run, other, SWAPPED_BLOCKS) == {}


@pytest.mark.parametrize("change", ("vertices", "faces", "corners"))
def test_renumberedOperandsGiveTheSameGeometry(run, change):
    rng = np.random.default_rng(20260101)
    meshes = []
    for vertices, faces in (run.operands[:2], run.operands[2:]):
        if change == "vertices":
            order = rng.permutation(len(vertices))
            vertices, faces = vertices[order], np.argsort(order)[faces]
        elif change == "faces":
            faces = faces[rng.permutation(len(faces))]
        else:
            start = rng.integers(3, size=len(faces))[:, None]
            faces = np.take_along_axis(faces, (start + np.arange(3)) % 3, axis=1)
        meshes += [vertices, faces]
    assert same_geometry(run, filter_run.run_boolean(*meshes)) == {}


def test_unweldedOperandsGiveTheSameGeometry(run):
    meshes = []
    for vertices, faces in (run.operands[:2], run.operands[2:]):
        meshes += [vertices[faces.ravel()], np.arange(faces.size).reshape(-1, 3)]
    assert same_geometry(run, filter_run.run_boolean(*meshes)) == {}


def test_namedFolderExists():
    assert Path(os.environ[placements.MESHES_VARIABLE]).is_dir()
