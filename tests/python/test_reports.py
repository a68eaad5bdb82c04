# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Small inputs after reports about other Booleans, in tests/reports: what is delivered holds as
stored, in doubles and in floats, has libigl's volume, and is an operand again.

    three_boxes_turned_30deg                 an assembly, united one by one
    libigl1116_wavy_tiles_overlapping        two tiles of a roof, overlapping in a strip
    bambu9357_cylinder_cube_common_bottom    a vertex at x = 6e-16
"""

from pathlib import Path

import numpy as np
import pytest

import judges
import mesh_laws
import oracles
import plain_solids
from run_boolean import BLOCKS, run_boolean

FOLDER = Path(__file__).parent.parent / "reports"
CERTIFIED_AS = ("host", "float")
SHIFTS = ((1, 2, 3), (10, 0, 0), (0, 10, 0))
TILE = "libigl1116_wavy_tiles_overlapping"
PAIRS = {
    TILE: (263.282793, 0.71720747, 131.282793),
    "bambu9357_cylinder_cube_common_bottom": (11137.6067, 3137.60674, 3137.60674),
}


def load(name):
    """The layers of an input, each (V, F)."""
    arrays = np.load(FOLDER / f"{name}.npz")
    keys = sorted(key[1:] for key in arrays.files if key.startswith("V"))
    return [(arrays["V" + key], arrays["F" + key].astype(np.int32)) for key in keys]


def load_stl(name):
    """The mesh of a binary STL file; equal corners are one vertex."""
    row = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
    rows = np.fromfile(FOLDER / name, dtype=row, offset=84)
    places, number = np.unique(rows["corners"].reshape(-1, 3), axis=0, return_inverse=True)
    return places.astype(np.float64), number.reshape(-1, 3).astype(np.int32)


def test_eachReportIsATest():
    """Right values are in the tests: here, and in those that name the file."""
    tests = "".join(
        path.read_text(encoding="utf-8") for path in Path(__file__).parent.glob("*.py")
    )
    reports = [path for path in FOLDER.iterdir() if path.suffix in (".npz", ".STL")]
    assert len(reports) == 17
    for report in reports:
        name = report.name if report.suffix == ".STL" else report.stem
        assert f'"{name}"' in tests, name


def tolerance(operands, scalar, largest_move):
    """How far a volume may be off: an ulp over the area, and what repair says that it moved.

    A film between two walls may vanish wholly: it is the operands' area that counts."""
    if scalar == "host":
        return 1e-9 * sum(mesh_laws.volume(*operand) for operand in operands)
    ulp = np.spacing(np.float32(max(np.abs(operand[0]).max() for operand in operands)))
    area = sum(mesh_laws.area(*operand) for operand in operands)
    return area * (float(ulp) + largest_move)


def certified(first, second, blocks, scalar):
    """These blocks of two meshes, each of which holds and has libigl's volume."""
    wanted = {block: block in blocks for block in BLOCKS}
    made = run_boolean(*first, *second, certify_as=scalar, **wanted)
    for block in blocks:
        verdict = judges.judge(*made[block])
        assert not verdict.wrong, f"{block}: {verdict}"
        assert made["result"][f"{block}_self_intersections"] == 0
        expected = mesh_laws.volume(*oracles.libigl_block(block, *first, *second))
        largest_move = made["result"][f"{block}_largest_move"]
        allowed = tolerance((first, second), scalar, largest_move)
        assert abs(mesh_laws.volume(*made[block]) - expected) <= allowed, block
    return made


@pytest.mark.parametrize("scalar", CERTIFIED_AS)
def test_threeTurnedBoxesAreUnitedOneByOne(scalar):
    first, second, third = load("three_boxes_turned_30deg")
    two = certified(first, second, ("union",), scalar)["union"]
    three = certified(two, third, ("union",), scalar)["union"]
    assert mesh_laws.volume(*three) == pytest.approx(4, rel=1e-6 if scalar == "float" else 1e-12)


@pytest.mark.parametrize("scalar", CERTIFIED_AS)
@pytest.mark.parametrize("name", PAIRS)
def test_eachBlockHoldsAndIsAnOperandAgain(name, scalar):
    first, second = load(name)
    made = certified(first, second, BLOCKS, scalar)
    union, common, difference = PAIRS[name]
    for block, volume in zip(BLOCKS, (union, common, difference)):
        near = pytest.approx(volume, rel=1e-6 if scalar == "host" else 1e-4)
        assert mesh_laws.volume(*made[block]) == near
    for block in BLOCKS:
        for shift in SHIFTS:
            other = plain_solids.shifted(first, shift)
            certified(made[block], other, ("union", "first_minus_second"), scalar)


@pytest.mark.parametrize("scalar", CERTIFIED_AS)
def test_aRoofGrowsTileByTileAndIsCut(scalar):
    tile = load(TILE)[0]
    roof = tile
    for column, row in [(i, j) for i in range(3) for j in range(3)][1:]:
        other = plain_solids.shifted(tile, (10 * column, 10 * row, 0))
        roof = certified(roof, other, ("union",), scalar)["union"]
    block = plain_solids.box((2, -1, 0), (8, 40, 3))
    made = certified(roof, block, BLOCKS, scalar)
    assert mesh_laws.volume(*made["intersection"]) == pytest.approx(186, rel=1e-6)


def test_facesThatCleaningBringsTogetherAreSeen():
    """Without faces that had no area left in floats two others lay on one another, front to back,
    none of whose corners was rounded: that was certified."""
    first, second = load("own_output_twin_faces_by_collapse")
    certified(first, second, BLOCKS, "float")


def test_copiesWhereALayerTouchesItselfAreNoSeam():
    """No attribute has two values in one place, so that what is carried over opens nothing."""
    first, second = load("own_output_copies_are_no_seam")
    made = run_boolean(*first, *second)
    for block in BLOCKS:
        assert made["result"][f"{block}_open_edges"] == 0, block
        assert mesh_laws.unmatched_edges(*made[block]) == 0
