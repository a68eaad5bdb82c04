# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The lists by which two builds are compared: equal where results are, and only there."""

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import indexboolean
import result_cases
import result_hashes
from conftest import box, document
from result_cases import ALL_BLOCKS, BOOLEAN, CURVES, SPLIT

PROGRAM = Path(result_hashes.__file__)
sys.path.append(str(PROGRAM.parents[2] / "tools"))

import same_results  # noqa: E402

PAIR = box((0, 0, 0), (2, 2, 2)), box((1, 1, 1), (3, 3, 3))


def list_of(cases, **environment):
    """The program's list, from processes of its own."""
    done = subprocess.run(
        [sys.executable, str(PROGRAM), indexboolean.plugin_path(), "--cases", cases],
        capture_output=True, text=True, check=True, env={**os.environ, **environment},
    )
    return done.stdout.splitlines()


def hashes(pair, filter_name, **parameters):
    """{layer: hash} of one run in this process."""
    return dict(result_hashes.run_lines(lambda: document(*pair), filter_name, parameters))


def nudged(pair):
    """The pair with the first mesh moved by the last bit along x."""
    vertices = pair[0][0].copy()
    vertices[:, 0] = np.nextafter(vertices[:, 0], np.inf)
    return (vertices, pair[0][1]), pair[1]


@pytest.mark.parametrize("cases", ["contacts/a_half/", "refused/hole", "attributes/quads"])
def test_theSamePluginGivesTheSameList(cases):
    lines = list_of(cases)
    assert lines == list_of(cases, OMP_NUM_THREADS="1")
    names = [line.rsplit(" ", 1)[0] for line in lines]
    assert len(set(names)) == len(names) > 0
    assert all(len(line.split(" ")) == 5 and len(line.split(" ")[4]) == 64 for line in lines)
    expected = [name for name in result_cases.case_names() if cases in name]
    assert list(dict.fromkeys(line.split(" ")[0] for line in lines)) == expected


def test_allLayersAreInTheList():
    assert list(hashes(PAIR, BOOLEAN, **ALL_BLOCKS)) == [
        "result", "A_union_B", "A_intersection_B", "A_minus_B", "B_minus_A", "A_xor_B",
    ]
    assert list(hashes(PAIR, SPLIT)) == ["result", "A_cut_by_B", "B_cut_by_A", "A_blocks_B"]
    assert list(hashes(PAIR, CURVES)) == ["result", "A_curves_B"]


@pytest.mark.parametrize("filter_name", [BOOLEAN, SPLIT, CURVES])
def test_theLastBitOfACoordinateIsSeen(filter_name):
    shifted = (PAIR[0][0] + 1 / 3, PAIR[0][1]), PAIR[1]
    before = hashes(shifted, filter_name)
    assert hashes(shifted, filter_name) == before
    after = hashes(nudged(shifted), filter_name)
    assert list(after) == list(before)
    layers = [layer for layer in after if layer != "result"]
    assert len(layers) > 0 and all(after[layer] != before[layer] for layer in layers)


def test_anotherOptionIsSeen():
    pair = PAIR[0], box((1, 1, 0), (3, 3, 2))
    before = hashes(pair, BOOLEAN, **ALL_BLOCKS)
    merged = hashes(pair, BOOLEAN, **ALL_BLOCKS, merge_coplanar=True)
    assert merged["A_union_B"] != before["A_union_B"]
    # The faces are the same: only the attributes that say where they came from are not there.
    bare = hashes(pair, BOOLEAN, **ALL_BLOCKS, transfer_attributes=False)
    assert bare["A_union_B"] != before["A_union_B"]


def test_refusalsAreSeenByMessageAndSelection():
    closed, other = PAIR
    holes = [(closed[0], np.delete(closed[1], face, axis=0)) for face in (0, 0, 1)]
    one, again, moved = (hashes((hole, other), BOOLEAN) for hole in holes)
    assert list(one) == ["refusal", "selection"]
    assert one == again
    assert one["selection"] != moved["selection"]


def test_eachArrayIsHashedWithItsNameAndShape():
    array = np.arange(6.0)
    digests = {
        result_hashes.hash_of([("name", value)])
        for value in (array, array.reshape(2, 3), array.astype(int), -array, 1.0, 1, "1", None)
    }
    digests.add(result_hashes.hash_of([("other", array)]))
    assert len(digests) == 9
    assert result_hashes.hash_of([("n", 0.0)]) != result_hashes.hash_of([("n", -0.0)])


def test_aCaseThatEndsTheProcessIsALine():
    worker = result_hashes.Worker(indexboolean.plugin_path())
    lines = worker.lines_of("no such case")
    assert lines == ["no such case - - ended status_1"]
    assert worker.lines_of("contacts/identical/swapped")[0].startswith("contacts/identical/swapped")
    assert worker.close() == 0


def test_aPluginThatDoesNotLoadIsAnError(tmp_path):
    worker = result_hashes.Worker(str(tmp_path / "none.so"))
    with pytest.raises(RuntimeError, match="does not load .*none.so"):
        worker.lines_of("contacts/identical/swapped")


BEFORE = {"a f v union": "1", "a f v result": "2", "b f v union": "3"}


@pytest.mark.parametrize(
    ("after", "exceptions", "status", "said"),
    [
        (BEFORE, [], 0, "3 results are equal, 0 differ"),
        ({**BEFORE, "b f v union": "4"}, [], 1, "differs: b f v union\n2 results are equal"),
        ({**BEFORE, "b f v union": "4"}, ["b"], 0, "differs (excepted): b f v union"),
        ({**BEFORE, "b f v union": "4"}, ["a"], 1, "2 results are equal, 1 differ"),
        ({**BEFORE, "c f v union": "4"}, [], 1, "new: c f v union"),
        ({**BEFORE, "b - - ended": "status_1"}, [], 1, "not run to its end: b - - ended"),
        ({"a f v union": "1"}, ["a*"], 1, "gone (excepted): a f v result\ngone: b f v union"),
    ],
)
def test_theComparisonTellsWhatDiffers(capsys, after, exceptions, status, said):
    assert same_results.report(BEFORE, after, exceptions) == status
    assert said in capsys.readouterr().out
