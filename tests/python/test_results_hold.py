# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What is delivered holds as it is stored: no face of a block meets another wrongly or has no area.

In double, and in float: by the filter's own rounding where it has one, else as a file in float
would keep it. EXCEPTIONS has all that does not hold; what is in it and holds fails, too. As a
program, it prints what does not hold today: `python tests/python/test_results_hold.py`.
"""

import os

import numpy as np
import pymeshlab
import pytest

import contact_cases
import fold_pairs
import indexboolean
import judges
import placements
import sample_catalogue
from result_cases import named_sample_pair
from run_boolean import BLOCKS, run_boolean

SCALARS = ("double", "float")
LONG_PAIRS = {"sphere, turned by 1e-7", "EMBER 908460, 73416"}  # half a minute and more

# (case, scalar): the blocks that do not hold, and why. Empty, and to stay so.
EXCEPTIONS = {}


def cases():
    """{name: (function that gives both operands, whether it needs other people's meshes)}"""
    found = {}
    for name in sample_catalogue.PAIRS:
        found[f"samples/{name}"] = lambda n=name: named_sample_pair(n), False
    for name in contact_cases.CASE_NAMES:
        found[f"contacts/{name}"] = (
            lambda n=name: contact_operands(n), name == contact_cases.FANDISK
        )
    for name in fold_pairs.PAIR_NAMES:
        found[f"pairs/{name}"] = (
            lambda n=name: fold_pairs.load_pair(n), fold_pairs.needs_meshes(name)
        )
    return found


def contact_operands(name):
    """Both operands of a contact case."""
    case = contact_cases.load_case(name)
    return case.first, case.second


CASES = cases()


def marked(name):
    """The case as a parameter of a test."""
    marks = []
    if CASES[name][1]:
        marks.append(pytest.mark.skipif(
            not os.environ.get(placements.MESHES_VARIABLE),
            reason=f"{placements.MESHES_VARIABLE} is not set: no folder of other people's meshes",
        ))
    if name.split("/")[1] in LONG_PAIRS:
        marks.append(pytest.mark.long)
    return pytest.param(name, marks=marks)


def rounds_to_float():
    """Whether the filter can be told to deliver floats."""
    indexboolean.load_plugin()
    meshes = pymeshlab.MeshSet()
    meshes.create_cube()
    return "certify_as" in meshes.filter_parameter_values("generate_index_boolean")


def verdicts(name, scalar):
    """{block: verdict} of what the filter delivers in a scalar, and its result map."""
    first, second = CASES[name][0]()
    rounded = scalar == "float" and rounds_to_float()
    blocks = run_boolean(*first, *second, **({"certify_as": "float"} if rounded else {}))
    if rounded:
        for block in BLOCKS:
            assert np.array_equal(blocks[block][0], blocks[block][0].astype(np.float32)), block
    judged = judges.judge_as_float if scalar == "float" and not rounded else judges.judge
    return {block: judged(*blocks[block]) for block in BLOCKS}, blocks["result"]


@pytest.mark.parametrize("scalar", SCALARS)
@pytest.mark.parametrize("name", [marked(name) for name in CASES])
def test_eachBlockHoldsAsStored(name, scalar):
    found, result = verdicts(name, scalar)
    excepted, _ = EXCEPTIONS.get((name, scalar), ((), ""))
    said = "\n".join(f"{block}: {verdict}" for block, verdict in found.items())
    failing = {block for block, verdict in found.items() if verdict.wrong}
    assert not failing - set(excepted), said
    assert not set(excepted) - failing, f"to be taken from EXCEPTIONS, they hold:\n{said}"
    if scalar == "double" or rounds_to_float():
        for block in BLOCKS:
            certified = result.get(f"{block}_self_intersections", len(found[block].wrong))
            assert (certified == 0) == (block not in failing), f"{block}: {certified} reported"


def test_exceptionsAreOfCasesThatExist():
    for (name, scalar), (blocks, reason) in EXCEPTIONS.items():
        assert name in CASES and scalar in SCALARS and reason
        assert blocks and set(blocks) <= set(BLOCKS)


def main():
    """A line for each case and scalar of which a block does not hold."""
    for name in CASES:
        if CASES[name][1] and not placements.meshes_folder():
            continue
        for scalar in SCALARS:
            failing = {b: v for b, v in verdicts(name, scalar)[0].items() if v.wrong}
            if failing:
                print(f'("{name}", "{scalar}"): {", ".join(failing)}')
                for block, verdict in failing.items():
                    print(f"    # {block}: {verdict}", flush=True)


if __name__ == "__main__":
    main()
