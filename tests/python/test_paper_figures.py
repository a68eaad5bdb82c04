# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The paper's figures: what the page says is what a run gives, and what the paper states."""

import os

import pytest

import paper_figures
import placements

# What the paper states, as figures of a row.
STATED = {
    "blocks": {"loops_hard_closed": 6, "loops_open": 0, "loops_soft_closed": 0},
    "open": {
        "loops_open": 4, "boundary_cycles_first": 5, "boundary_cycles_second": 5,
        "sub_surfaces_first": 5, "sub_surfaces_second": 5,
    },
    "falcon": {
        "loops_hard_closed": 3, "loops_open": 0, "sub_surfaces_first": 4, "sub_surfaces_second": 4,
        "sub_blocks": 4,
    },
    "lion": {
        "loops_hard_closed": 3, "loops_open": 0, "sub_surfaces_first": 4, "sub_surfaces_second": 4,
    },
    "cylinders": {
        "loops_soft_closed": 4, "loops_open": 0, "loops_hard_closed": 0,
        "sub_surfaces_first": 4, "sub_surfaces_second": 4,
    },
    "tori": {"loops_open": 0, "loops_hard_closed": 0},
}


@pytest.mark.parametrize("name", paper_figures.FIGURES)
def test_runGivesWhatThePaperStatesAndThePageSays(name):
    figures = paper_figures.measure(name)
    if figures is None:
        assert not os.environ.get(placements.MESHES_VARIABLE)
        pytest.skip(f"{placements.MESHES_VARIABLE} is not set: no folder of other people's meshes")
    for key, number in STATED[name].items():
        assert figures[key] == number, key
    page = paper_figures.PAGE.read_text(encoding="utf-8")
    table = page.split(paper_figures.TABLE_START)[1].split(paper_figures.TABLE_END)[0]
    assert paper_figures.row(name, figures) in table.splitlines()


@pytest.mark.parametrize("name", paper_figures.FIGURES)
def test_everyFigureHasAPictureOnThePage(name):
    page = paper_figures.PAGE.read_text(encoding="utf-8")
    assert f"](figure_{name}.png)" in page
    assert (paper_figures.PAGE.parent / f"figure_{name}.png").is_file()
