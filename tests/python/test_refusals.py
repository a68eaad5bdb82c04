# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a refusal says to do is done, and leads to the right solid: refusal_cases.py and
refusals_of_filters.py have the cases.

    python tests/python/test_refusals.py    writes the table of docs/refusals.md anew
"""

import re
import sys
from pathlib import Path

import pymeshlab
import pytest

from refusal_cases import CURVES, SPLIT, run
from refusals_of_filters import ALL as CASES
from refusals_of_filters import CLIP, table

PAGE = Path(__file__).resolve().parents[2] / "docs" / "refusals.md"
MARKS = ("<!-- remedies -->\n", "<!-- /remedies -->\n")


def refused(case):
    """(the document, what the refusal says)."""
    mesh_set = case.make()
    before = [mesh.id() for mesh in mesh_set]
    with pytest.raises(pymeshlab.PyMeshLabException) as refusal:
        run(mesh_set, case.filter, **case.parameters)
    assert [mesh.id() for mesh in mesh_set] == before
    return mesh_set, str(refusal.value)


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.name)
def test_theRemedyNamedLeadsToTheRightResult(case):
    mesh_set, message = refused(case)
    assert re.search(case.sentence, message), message
    assert case.is_right(case.perform(mesh_set, message), mesh_set)


def test_eachRemedyIsTriedOnTwoLayersAtLeast():
    tried = {}
    for case in CASES:
        tried.setdefault((case.refusal, case.sentence), set()).add(case.layer)
    alone = {key for key, layers in tried.items() if len(layers) < 2}
    refusals = {refusal for refusal, _ in tried}
    by_refusal = {
        refusal: {c.layer for c in CASES if c.refusal == refusal} for refusal in refusals
    }
    assert all(len(layers) >= 2 for layers in by_refusal.values())
    # What a double-sided sheet is told has a second half; a text is told its own mistake.
    assert {refusal for refusal, _ in alone} <= {"is double-sided", "a text does not read"}


def test_aCrackIsNeverSentToCloseHolesNorASheetOfSplitToWordsOfSolids():
    for case in CASES:
        if case.refusal == "is not closed, by cracks":
            assert "meshing_close_holes" not in refused(case)[1]
        if case.filter in (SPLIT, CURVES) and case.parameters != CLIP:
            message = refused(case)[1]
            assert not re.search("meshing_close_holes|union|solid|winding_rule", message), message


def page_with_table(page):
    before, rest = page.split(MARKS[0])
    return before + MARKS[0] + table() + MARKS[1] + rest.split(MARKS[1])[1]


def test_theTableOfThePageIsThatOfTheCases():
    page = PAGE.read_text(encoding="utf-8")
    assert page == page_with_table(page), "run python tests/python/test_refusals.py"


if __name__ == "__main__":
    PAGE.write_text(page_with_table(PAGE.read_text(encoding="utf-8")), encoding="utf-8")
    sys.exit()
