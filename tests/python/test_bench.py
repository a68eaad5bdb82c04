# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The benchmark program measures what it says, and says so in JSON."""

import json
import math
import os
import re
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

import mesh_laws
import sample_catalogue

ROOT = Path(__file__).resolve().parents[2]
BENCH = Path(os.environ.get("INDEXBOOLEAN_BENCH", ROOT / "build/release/bench/index_boolean_bench"))
CATALOGUE = json.loads((sample_catalogue.FOLDER / "catalogue.json").read_text(encoding="utf-8"))
PAIRS = CATALOGUE["pairs"]
SPHERE_CAP = 5 * math.pi / 24  # one of the two caps that unit spheres 1 apart have in common
FOUR_BLOCKS = ["union", "intersection", "first_minus_second", "second_minus_first"]


def run_bench(*arguments):
    assert BENCH.exists(), f"{BENCH} is not built (or set INDEXBOOLEAN_BENCH)"
    return subprocess.run([BENCH, *map(str, arguments)], capture_output=True, text=True, timeout=60)


def measured(*arguments):
    done = run_bench(*arguments)
    assert done.returncode == 0, done.stdout + done.stderr
    return json.loads(done.stdout)


def volumes(part):
    return {name: block["volume"] for name, block in part["blocks"].items()}


def test_sphereVolumesAreThoseOfCapsAndBalls():
    report = measured("--spheres", 20000, "--runs", 2, "--threads", 1)
    assert report["status"] == "ok" and report["threads"] == 1
    assert [operand["faces"] for operand in report["operands"]] == [20480, 20480]
    ball = 4 * math.pi / 3
    expected = [2 * ball - 2 * SPHERE_CAP, 2 * SPHERE_CAP, ball - 2 * SPHERE_CAP]
    found = volumes(report["four_blocks"])
    assert list(found) == FOUR_BLOCKS
    assert list(found.values()) == pytest.approx([*expected, expected[2]], rel=1e-3)
    assert volumes(report["one_operation"]) == {"union": found["union"]}
    assert report["four_blocks"]["volume_law_residual"] < 1e-12
    assert report["four_blocks"]["loops"] == {"open": 0, "hard_closed": 1, "soft_closed": 0}
    assert all(block["closed"] for block in report["four_blocks"]["blocks"].values())
    assert report["four_blocks"]["peak_memory_bytes"] > report["memory_before_bytes"] > 0


def test_stagesAddUpToTheTotal():
    one = measured("--spheres", 80000, "--runs", 1)["one_operation"]
    assert one["seconds_each_run"] == [one["seconds"]]
    assert all(seconds >= 0 for seconds in one["seconds_per_stage"].values())
    assert list(one["seconds_per_stage"])[-3:] == ["block union", "audit", "free"]
    assert 0.9 * one["seconds"] < sum(one["seconds_per_stage"].values()) <= one["seconds"]
    audit = one["seconds_per_stage"]["audit"]
    assert one["seconds_without_audit"] == pytest.approx(one["seconds"] - audit)


def test_sampleMeshesHaveTheCataloguedVolumes():
    pair = next(pair for pair in PAIRS if pair["contact"] == "generic")
    files = [sample_catalogue.FOLDER / pair[side] for side in ("first", "second")]
    report = measured(*files, "--operation", "intersection", "--runs", 1, "--warmups", 0)
    expected = pair["blocks"]["intersection"]["volume"]
    assert volumes(report["one_operation"])["intersection"] == pytest.approx(expected, rel=1e-9)


def test_savedArraysAreTheOperandsAsPlaced(tmp_path):
    doubled = "2,0,0,5,0,2,0,6,0,0,2,7"
    measured("--spheres", 500, "--transform-first", doubled, "--runs", 1, "--save-arrays", tmp_path)
    points = np.fromfile(tmp_path / "points_0.f64", np.float64).reshape(-1, 3)
    triangles = np.fromfile(tmp_path / "triangles_0.u32", np.uint32).reshape(-1, 3)
    assert np.linalg.norm(points - [5, 6, 7], axis=1) == pytest.approx(2)
    assert mesh_laws.unmatched_edges(points, triangles.astype(np.int64)) == 0


def test_standardPlacementFillsTheUnitBox(tmp_path):
    file = sample_catalogue.FOLDER / PAIRS[0]["first"]
    measured(file, file, "--place", "standard", "--runs", 1, "--save-arrays", tmp_path)
    first, second = (
        np.fromfile(tmp_path / f"points_{number}.f64").reshape(-1, 3) for number in range(2)
    )
    assert np.ptp(first, axis=0).max() == pytest.approx(1)
    assert first.min(axis=0) == pytest.approx(-first.max(axis=0))
    # Turning keeps distances; the shift is that of a mesh with itself.
    centre = second.mean(axis=0) - [0.05, 0.04, 0.03]
    assert np.linalg.norm(centre) == pytest.approx(np.linalg.norm(first.mean(axis=0)))


def test_refusalIsAStatusAndExitsWithOne(tmp_path):
    triangle = tmp_path / "open.off"
    triangle.write_text("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
    done = run_bench(triangle, sample_catalogue.FOLDER / PAIRS[0]["first"])
    report = json.loads(done.stdout)
    assert done.returncode == 1
    assert report["status"] == "not closed" and report["operand"] == 0
    assert "3 edges" in report["message"]


def test_badCommandLinesExitWithTwoAndBadFilesWithOne(tmp_path):
    for arguments in ([], ["a.ply"], ["--spheres", "0"], ["--spheres", "9", "--threads", "-1"]):
        assert run_bench(*arguments).returncode == 2
    done = run_bench(tmp_path / "none.ply", tmp_path / "none.ply")
    assert done.returncode == 1 and "none.ply" in done.stderr and not done.stdout


def test_comparisonWritesItsTable(tmp_path):
    command = [
        sys.executable, ROOT / "bench/compare.py", "--bench", BENCH, "--out", tmp_path,
        "--spheres", "500", "--cases", "sphere ∪", "--runs", "1", "--peers", "Manifold",
        "--seconds", "0.05",
    ]
    subprocess.run(command, check=True, capture_output=True, timeout=120)
    row, _ = json.loads((tmp_path / "compare.json").read_text())["rows"]
    manifold, core = row["peers"]["Manifold"], row["core"]["one_operation"]
    assert manifold["volume"] == pytest.approx(core["blocks"]["union"]["volume"], rel=1e-9)
    assert manifold["closed"]
    for runs in (manifold["seconds_each_run"], core["seconds_each_run"]):
        assert len(runs) > 1 and sum(runs[:-1]) < 0.05 <= sum(runs)
    defaults = row["defaults"]["one_operation"]
    assert defaults["blocks"] == core["blocks"]
    table = (tmp_path / "compare.md").read_text()
    assert "| all defaults " in table and "| Manifold " in table
    ratios = re.search(r"\(([\d.]+)×, ([\d.]+)×\) *\|$", table, re.MULTILINE)
    measured = [manifold["seconds"] / run["seconds_without_audit"] for run in (defaults, core)]
    assert [float(ratio) for ratio in ratios.groups()] == pytest.approx(measured, abs=0.06)


def test_comparisonOnABusyMachine(tmp_path):
    command = [
        sys.executable, ROOT / "bench/compare.py", "--bench", BENCH, "--out", tmp_path,
        "--cases", "box − box (2", "--runs", "1", "--peers", "none", "--busy", "3",
    ]
    with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as run:
        most = 0
        while run.poll() is None:
            most = max(most, sum("while True" in words for words in children_of(run.pid)))
            time.sleep(0.005)
    assert run.returncode == 0
    assert most == 3
    assert "3 busy processes" in (tmp_path / "compare.md").read_text()


def children_of(process):
    """The command lines of a process's children."""
    lines = []
    for folder in Path("/proc").glob("[0-9]*"):
        try:
            parent = int((folder / "stat").read_text().rsplit(")", 1)[1].split()[1])
            lines += [(folder / "cmdline").read_text()] if parent == process else []
        except (FileNotFoundError, ProcessLookupError):
            pass  # it has ended
    return lines


def test_smallPairsAreAllRightBesideAPeer():
    command = [
        sys.executable, ROOT / "bench/small_pairs.py", "--bench", BENCH, "--pairs", "12",
        "--peers", "Manifold",
    ]
    done = subprocess.run(command, check=True, capture_output=True, text=True, timeout=60)
    rows = [[cell.strip() for cell in line.strip("|").split("|")]
            for line in done.stdout.splitlines()]
    assert [row[0] for row in rows[2:]] == ["core", "core, with its audit", "Manifold"]
    assert rows[-1][3:] == ["0", "0"], "no wrong volume, each with a result"


def test_countsAreAskedOfAProgramThatCounts():
    command = [
        sys.executable, ROOT / "bench/count_signs.py", "--counting", BENCH, "--timing", BENCH,
        "--spheres", "500", "--cases", "box − box (2",
    ]
    done = subprocess.run(command, capture_output=True, text=True, timeout=60)
    assert done.returncode != 0 and "does not count" in done.stderr


def split_case(tmp_path, peers):
    command = [
        sys.executable, ROOT / "bench/compare.py", "--bench", BENCH, "--out", tmp_path,
        "--terrain", "20000", "--cases", "terrain", "--runs", "1", "--peers", peers,
    ]
    subprocess.run(command, check=True, capture_output=True, timeout=120)
    (row,) = json.loads((tmp_path / "compare.json").read_text())["rows"]
    return row, (tmp_path / "compare.md").read_text()


def test_comparisonSplitsATerrainByASheet(tmp_path):
    row, table = split_case(tmp_path, "none")
    split = row["core"]["split"]
    assert [operand["faces"] for operand in row["core"]["operands"]] == [20000, 2048]
    assert split["sub_blocks"] > 1 and split["sub_blocks_closed"]
    assert split["sub_blocks_volume"] > 0 and split["loops"]["open"] > 0
    assert list(split["seconds_per_stage"])[-4:] == [
        "sub-surface meshes", "sub-block meshes", "audit", "free",
    ]
    assert "terrain cut by sheet (20k, 2k)" in table


def test_trueformsCellsAreTheSubBlocks(tmp_path):
    pytest.importorskip("trueform", reason="bench/requirements.txt is not installed")
    row, table = split_case(tmp_path, "trueform")
    split, cells = row["core"]["split"], row["peers"]["trueform_cells"]
    assert cells["cells"] == split["sub_blocks"] and cells["closed"]
    assert cells["volume"] == pytest.approx(split["sub_blocks_volume"], rel=1e-9)
    assert len(row["peers"]["trueform_arrangement"]["seconds_each_run"]) == 1
    assert "trueform, arrangement and cells" in table and "*" not in table.splitlines()[-3]


def test_mergedWallsAreComparedWithManifolds():
    command = [sys.executable, ROOT / "bench/merged.py", "--cases", "30 cubes", "--runs", "1"]
    done = subprocess.run(command, check=True, capture_output=True, text=True, timeout=120)
    rows = [[cell.strip() for cell in line.strip("|").split("|")]
            for line in done.stdout.splitlines()[2:]]
    assert [row[1] for row in rows] == ["before", "here", "Manifold"]
    before, here, manifold = (int(row[2]) for row in rows)
    # A ball of 6 * 31 planes: with Euler's formula the rest follows.
    assert here == manifold == 2 * (2 * (6 * 31 - 2)) - 4 < before
    assert [row[4] for row in rows] == ["0", "0", "0"]
    assert float(rows[1][5]) <= 1
