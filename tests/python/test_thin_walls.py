# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Walls thinner than the steps of the scalar that they are stored in: each block holds, in doubles
and in floats, and encloses what it should up to what rounding and repair may change.

Judged by judges.py; volumes by the closed forms and by what the result says of its moves. The long
tests take pairs of scans and CAD parts that are nearly the same.
"""

import numpy as np
import pytest

import judges
import mesh_laws
import placements
from plain_solids import box, icosphere, joined, shifted, turned_about
from run_boolean import BLOCKS, run_boolean

SCALARS = ("host", "float")
STEP = {"host": 2.0**-52, "float": 2.0**-23}  # of numbers between 1 and 2
ABOUT = (1, 2, 3)
LONG_MESHES = ("spot", "rocker-arm", "fandisk", "cheburashka", "fertility")


def held(first, second, scalar):
    """The blocks, once each has been judged and found to be certified."""
    blocks = run_boolean(*first, *second, certify_as=scalar)
    result = blocks["result"]
    for block in BLOCKS:
        verdict = judges.judge(*blocks[block]) if len(blocks[block][1]) else None
        assert result[f"{block}_self_intersections"] == 0, block
        assert verdict is None or not verdict.wrong, f"{block}: {verdict}"
        assert result[f"{block}_closed"]
    return blocks


def tolerance(blocks, operands, scalar):
    """How far a volume may be off: everything moves by a step and by the largest move."""
    size = max(np.abs(vertices).max() for vertices, _ in operands)
    area = sum(mesh_laws.area(*operand) for operand in operands)
    moves = max(blocks["result"][f"{block}_largest_move"] for block in BLOCKS)
    return area * (2 * STEP[scalar] * size + 2 * moves)


def check_volumes(blocks, operands, scalar):
    """The laws between the volumes, as delivered."""
    a, b = (mesh_laws.volume(*operand) for operand in operands)
    either, both, only_a, only_b = (mesh_laws.volume(*blocks[block]) for block in BLOCKS)
    most = tolerance(blocks, operands, scalar)
    assert either + both == pytest.approx(a + b, rel=0, abs=2 * most)
    assert only_a + both == pytest.approx(a, rel=0, abs=2 * most)
    assert only_b + both == pytest.approx(b, rel=0, abs=2 * most)


@pytest.mark.parametrize("scalar", SCALARS)
@pytest.mark.parametrize("exponent", range(1, 19))
def test_spheresNearerAndNearer(exponent, scalar):
    ball = icosphere(2)
    operands = ball, shifted(ball, (10.0**-exponent, 0.5 * 10.0**-exponent, 0))
    check_volumes(held(*operands, scalar), operands, scalar)


@pytest.mark.parametrize("scalar", SCALARS)
@pytest.mark.parametrize("exponent", range(1, 17, 3))
def test_spheresTurnedLessAndLess(exponent, scalar):
    ball = icosphere(2)
    operands = ball, turned_about(ball, ABOUT, 10.0**-exponent)
    check_volumes(held(*operands, scalar), operands, scalar)


@pytest.mark.parametrize("scalar", SCALARS)
def test_aStackOfFiftySheetsOfOneStep(scalar):
    step = STEP[scalar]
    sheets = joined(*[
        box((0, 0, 1 + 2 * i * step), (1, 1, 1 + (2 * i + 1) * step)) for i in range(50)
    ])
    wedge = turned_about(box((0.25, 0.25, -0.5), (0.75, 0.75, 0.5)), ABOUT, 0.3)
    operands = sheets, shifted(wedge, (0.1, 0.2, 1))
    check_volumes(held(*operands, scalar), operands, scalar)


@pytest.mark.parametrize("scalar", SCALARS)
def test_theTipOfAConeInAWall(scalar):
    turn = np.linspace(0, 2 * np.pi, 12, endpoint=False)
    rim = np.column_stack([np.cos(turn), np.sin(turn), np.full(12, 3.0)])
    vertices = np.vstack([rim, [(0, 0, 3)], [(1 / 3, 1 / 7, 1 + STEP[scalar])]])
    around = np.arange(12)
    faces = np.vstack([
        np.column_stack([around, (around + 1) % 12, np.full(12, 12)])[:, [0, 1, 2]],
        np.column_stack([(around + 1) % 12, around, np.full(12, 13)]),
    ])
    cone = vertices, faces
    assert mesh_laws.volume(*cone) > 0
    for tilt in (0, 1e-9, 0.3):
        wall = shifted(turned_about(box((-4, -4, -1), (4, 4, 0)), (1, 0, 0), tilt), (0, 0, 1))
        check_volumes(held(wall, cone, scalar), (wall, cone), scalar)


def test_smallThingsFarFromTheOriginInFloats():
    """Floats at 1e6 are 1/16 apart; the parts are 1e-4 thick."""
    plate = box((0, 0, 0), (4, 4, 1e-4))
    ball = icosphere(2)
    far = (1e6, 1e6, 1e6)
    operands = shifted(plate, far), shifted((ball[0] * 0.5, ball[1]), np.add(far, (2, 2, 0)))
    held(*operands, "float")


@pytest.mark.long
@pytest.mark.parametrize("scalar", SCALARS)
@pytest.mark.parametrize("exponent", (3, 6, 9, 12, 16))
@pytest.mark.parametrize("move", ("shifted", "turned"))
@pytest.mark.parametrize("name", LONG_MESHES)
def test_realMeshesThatAreNearlyTheSame(name, move, exponent, scalar):
    vertices, faces = placements.read_mesh(placements.meshes_folder() / f"{name}.obj")
    mesh = placements.normalised(vertices), faces
    small = 10.0**-exponent
    other = (
        shifted(mesh, (small, 0.7 * small, 0.3 * small))
        if move == "shifted"
        else turned_about(mesh, ABOUT, small)
    )
    check_volumes(held(mesh, other, scalar), (mesh, other), scalar)
