# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A result is an operand of the next step, again and again: it is taken, and each step's volume is
that of libigl on the same operands, or the closed form.

Seeds are fixed; chain_kinds.make_chain(kind, seed) makes a chain again. EXCEPTIONS has the chains
that end too early, with the step that is refused; one that goes on is to be taken out. As a
program, this prints the tables of today: `python tests/python/test_chains.py [SEEDS]`.
"""

import sys

import numpy as np
import pytest

import chain_kinds
import judges
import mesh_laws
import oracles
from run_boolean import BLOCKS, run_boolean

TOLERANCE = 1e-9  # relative to the volumes of both operands
STEPS = {"carve": 25, "grow": 25, "turned": 12, "grid_z_5": 5, "grid_any_5": 5}
SEEDS = range(1, 6)
LONG_STEPS = {"carve": 200, "grow": 200, "turned": 60}
LONG_SEEDS = range(1, 11)
GRIDS = ("grid_z_5", "grid_z_8", "grid_any_5", "grid_any_8")
GRID_SEEDS = range(1, 101)

# (kind, seed): the step that is refused. To become empty.
EXCEPTIONS = {}
# kind: how many of the seeds of the long tests are refused. To become empty, too.
LONG_EXCEPTIONS = {
    "grid_z_5": 10,
    "grid_z_8": 40,
    "grid_any_5": 20,
    "grid_any_8": 62,
}


class Refused(Exception):
    """A step's operands are refused: its number, and the filter's words."""


def taken(mesh, step, number):
    """The result of a step, of which nothing else is asked."""
    wanted = {block: block == step.operation for block in BLOCKS}
    try:
        return run_boolean(*mesh, *step.operand, **wanted)[step.operation]
    except Exception as refusal:
        raise Refused(number, " ".join(str(refusal).split())) from None


def check_volume(operands, step, made, by_libigl):
    """Against the closed form, or libigl's volume."""
    scale = sum(mesh_laws.volume(*operand) for operand in operands)
    found = mesh_laws.volume(*made)
    if step.volume is not None:
        assert abs(found - step.volume) <= TOLERANCE * scale, f"{found}, not {step.volume}"
    if by_libigl:
        expected = mesh_laws.volume(
            *oracles.libigl_block(step.operation, *operands[0], *operands[1])
        )
        assert abs(found - expected) <= TOLERANCE * scale, f"{found}, libigl's is {expected}"


def run_chain(kind, seed, steps, stride=1):
    """Runs a chain, and asks libigl about each stride-th step. The step that is refused, or 0."""
    chain = chain_kinds.make_chain(kind, seed, steps)
    mesh = chain.start
    for number, step in enumerate(chain.steps, 1):
        try:
            made = taken(mesh, step, number)
        except Refused as refusal:
            print(f"{kind}, seed {seed}: step {number} is refused: {refusal.args[1]}")
            return number
        assert mesh_laws.unmatched_edges(*made) == 0, f"step {number} is not closed"
        check_volume((mesh, step.operand), step, made, number % stride == 0)
        mesh = made
    return 0


SHORT = [(kind, seed) for kind in STEPS for seed in SEEDS]


@pytest.mark.parametrize(("kind", "seed"), SHORT)
def test_eachStepIsTakenAndHasItsVolume(kind, seed):
    refused = run_chain(kind, seed, STEPS[kind])
    expected = EXCEPTIONS.get((kind, seed), 0)
    assert refused == expected, (
        f"step {refused} is refused, and not {expected}; 0: none. One that goes further is to be "
        "entered in EXCEPTIONS as it is now, or taken out"
    )


def test_exceptionsAreOfChainsThatAreRun():
    assert set(EXCEPTIONS) <= set(SHORT) and all(EXCEPTIONS.values())
    assert set(LONG_EXCEPTIONS) <= {*LONG_STEPS, *GRIDS} and all(LONG_EXCEPTIONS.values())


def refused_seeds(kind, seeds, steps, stride):
    """How many chains of a kind come to no end; each is named."""
    return sum(run_chain(kind, seed, steps, stride) > 0 for seed in seeds)


@pytest.mark.long
@pytest.mark.parametrize("kind", LONG_STEPS)
def test_longChainsAreFinished(kind):
    found = refused_seeds(kind, LONG_SEEDS, LONG_STEPS[kind], stride=20)
    assert found == LONG_EXCEPTIONS.get(kind, 0)


@pytest.mark.long
@pytest.mark.parametrize("kind", GRIDS)
def test_gridsOfAllSeedsAreFinished(kind):
    found = refused_seeds(kind, GRID_SEEDS, None, stride=1000)
    assert found == LONG_EXCEPTIONS.get(kind, 0)


@pytest.mark.parametrize("kind", chain_kinds.KINDS)
def test_chainsAreTheSameEachTimeAndOfSoundOperands(kind):
    chain, again = (chain_kinds.make_chain(kind, 3, 3) for _ in range(2))
    pairs = [(chain.start, again.start)]
    pairs += [(a.operand, b.operand) for a, b in zip(chain.steps, again.steps)]
    assert len(pairs) == 4
    for mesh, other in pairs:
        assert all(np.array_equal(array, same) for array, same in zip(mesh, other))
        assert mesh_laws.unmatched_edges(*mesh) == 0 and mesh_laws.volume(*mesh) > 0
        assert len(mesh[1]) > 50_000 or not judges.judge(*mesh).wrong


@pytest.mark.parametrize("kind", ["terrain", "lattice", "grid_z_8", "grid_any_8"])
def test_closedFormsAreLibiglsVolumes(kind):
    chain = chain_kinds.make_chain(kind, 1, 3)
    mesh = chain.start
    for step in chain.steps:
        mesh = oracles.libigl_block(step.operation, *mesh, *step.operand)
        assert mesh_laws.volume(*mesh) == pytest.approx(step.volume, rel=1e-12)


def test_finiteChainsHaveTheStepsThatTheyAreSaidToHave():
    for name, kind in chain_kinds.KINDS.items():
        if not kind.endless:
            steps = list(chain_kinds.make_chain(name, 1, kind.steps + 1).steps)
            assert len(steps) == kind.steps, name


def main():
    """The tables of exceptions; the long ones of as many seeds as are asked for."""
    for kind, seed in SHORT:
        refused = run_chain(kind, seed, STEPS[kind], 1000)
        if refused:
            print(f'    ("{kind}", {seed}): {refused},', flush=True)
    if len(sys.argv) > 1:
        for kind in (*LONG_STEPS, *GRIDS):
            seeds = range(1, int(sys.argv[1]) + 1)
            found = refused_seeds(kind, seeds, LONG_STEPS.get(kind), 10**6)
            print(f'    "{kind}": {found},', flush=True)


if __name__ == "__main__":
    main()
