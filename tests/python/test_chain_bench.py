# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""bench/chains.py and bench/results_hold.py run, and their tables say what happened."""

import json
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import judges
from core_blocks import PROGRAM
from indexboolean.plugin import plugin_path
from plain_solids import cube, icosphere

BENCH = Path(__file__).resolve().parents[2] / "bench"
sys.path.append(str(BENCH))

import chain_worker  # noqa: E402
import chains  # noqa: E402
import results_hold  # noqa: E402


def run_program(name, *arguments):
    """What a program of bench/ prints."""
    command = [sys.executable, BENCH / name, "--plugin", plugin_path(), *arguments]
    done = subprocess.run(command, capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stderr
    return done.stdout


def cells(text, first):
    """The cells of the table's row that begins so."""
    (line,) = (line for line in text.splitlines() if line.startswith(f"| {first} "))
    return [cell.strip() for cell in line.strip("|").split("|")]


def test_chainsRunBesideOtherSystems(tmp_path):
    text = run_program(
        "chains.py", "--kinds", "grid_z_5,carve", "--systems", "here,Manifold,libigl", "--steps",
        "2", "--check", "--folds", "--json", tmp_path / "rows", "--page", tmp_path / "page",
    )
    assert (tmp_path / "page").read_text().strip() == text.strip()
    rows = json.loads((tmp_path / "rows").read_text())
    assert [row["system"] for row in rows] == 2 * ["here", "Manifold", "libigl"]
    for row in rows:
        assert row["stopped"] is None and [step["step"] for step in row["steps"]] == [1, 2]
        assert row["off"] < 1e-12 and row["wrong"] >= 0
        for step in row["steps"]:
            assert step["libigl"] == pytest.approx(step["volume"], rel=1e-12)
            if row["kind"] == "grid_z_5":
                assert step["expected"] == pytest.approx(step["volume"], rel=1e-12)


def test_sumsAreOfTheChainsThatAllFinish():
    class Arguments:
        kinds, systems = ["carve", "grow"], ["here", "Manifold"]

    rows = [
        {"kind": kind, "seed": seed, "system": system, "stopped": stopped, "off": off,
         "steps": [{"seconds": seconds}, {"seconds": 0.5}]}
        for kind, seed, system, stopped, off, seconds in [
            ("carve", 1, "here", None, 0, 1.5), ("carve", 1, "Manifold", None, 1e-9, 2.5),
            ("carve", 2, "here", "refused", 0, 9), ("carve", 2, "Manifold", None, 0, 9),
            ("grow", 1, "here", None, 0, 1.5), ("grow", 1, "Manifold", None, 0.1, 4.5),
        ]
    ]
    text = chains.sums_part(Arguments, rows)
    assert cells(text, "carve") == ["carve", "1", "2 s", "3 s (1.5×)"]
    assert cells(text, "grow") == ["grow", "1", "2 s", "5 s* (2.5×)"]
    assert cells(text, "in sum") == ["in sum", "2", "4 s", "8 s* (2×)"]
    assert cells(text, "those without *, in sum")[1:] == cells(text, "carve")[1:]


def test_aChainThatIsCutOrRefusedIsAnEntry(tmp_path):
    arguments = "--kinds", "grid_any_5", "--systems", "Manifold", "--json", tmp_path / "rows"
    text = run_program("chains.py", *arguments, "--limit", "0.000001")
    assert cells(text, "Manifold")[1] == "0 of 1" and "more than 1e-06 s" in text
    broken = "--systems", "float host", "--core-blocks", "/bin/false"
    text = run_program("chains.py", "--kinds", "carve", *broken)
    row = cells(text, "float host")
    assert row[1:3] == ["0 of 1", "0"] and "exit status 1" in row


@pytest.mark.parametrize("storage", ["float", "ply", "stl"])
def test_resultsGoThroughWhatTheyAreStoredIn(storage):
    points, faces = icosphere(1)
    mesh = points / 3, faces
    read = chain_worker.STORAGES[storage](mesh)
    assert len(read[1]) == len(faces) and len(read[0]) == len(points)
    is_float = np.array_equal(read[0], read[0].astype(np.float32))
    assert is_float == (storage != "ply")
    if storage == "ply":
        assert np.array_equal(read[0][read[1]], mesh[0][mesh[1]])


def test_stepsAreAsManyAsTheChainHas():
    class Arguments:
        steps = 10

    assert chains.steps_of(Arguments, "carve") == 10
    assert chains.steps_of(Arguments, "grid_z_5") == 5
    assert chains.seeds_from("1,4-6") == [1, 4, 5, 6]


def test_resultsAreJudgedBesideOtherSystems(tmp_path):
    systems = ["here", "Manifold"] + (["float host"] if PROGRAM.is_file() else [])
    text = run_program(
        "results_hold.py", "--pairs", "box, tetra", "--systems", ",".join(systems), "--json",
        tmp_path / "answers",
    )
    (answers,) = json.loads((tmp_path / "answers").read_text()).values()
    assert list(answers["here"]["blocks"]) == list(chain_worker.BLOCKS)
    assert list(answers["Manifold"]["blocks"]) == ["union"]
    assert cells(text, "box, tetrahedron on it")[1].count("/") == 4
    for answer in answers.values():
        assert all(len(block) == 5 for block in answer["blocks"].values())
        assert answer["blocks"]["union"][4] > 0


def test_anglesAreCountedOnceEach(tmp_path):
    page, plot = tmp_path / "page.md", tmp_path / "plot.svg"
    page.write_text("before\n<!-- thin -->\n<!-- /thin -->\nafter\n")
    text = run_program(
        "results_hold.py", "--angles", "torus, torus moved; box, tetrahedron on it", "--systems",
        "here,Manifold", "--thin", page, "--plot", plot,
    )
    for line in text.splitlines():
        if line.startswith(("| here", "| Manifold")):
            row = [cell.strip() for cell in line.strip("|").split("|")]
            assert int(row[1]) == sum(int(count) for count in row[3:] if count)
    assert cells(page.read_text(), "torus, torus moved") == cells(text, "torus, torus moved")
    assert page.read_text().startswith("before\n") and page.read_text().endswith("after\n")
    assert plot.read_text().count("</svg>") == 1
    figures = results_hold.angles_of(*cube(1.0))
    assert figures["faces"] == 12 and figures["angles"][-1] == sum(figures["drawn"]) == 12
    assert len(figures["angles"]) == len(results_hold.ANGLES) - 1 and figures["needles"] == 0
    assert judges.judge(*cube(1.0)).meeting == 0
