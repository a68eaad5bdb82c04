# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m indexboolean batch on this machine: results, resumption, lost processes, limits."""

import json
import os
import shutil
import signal
import subprocess
import sys

import pymeshlab
import pytest

import sample_catalogue
from batch_support import (
    PAIR, SAMPLES, endless_mesh, is_running, press_ctrl_c, records, results, run, start,
    statuses, table_of_copies, wait_until, write_table,
)
from conftest import box, sphere
from placements import read_mesh

FOUR_BLOCKS = ["union", "intersection", "first_minus_second", "second_minus_first"]
COLUMNS = ("first", "second", "name", "first_transform", "second_transform", "blocks")


def saved(path, mesh):
    meshes = pymeshlab.MeshSet()
    meshes.add_mesh(pymeshlab.Mesh(*mesh))
    meshes.save_current_mesh(str(path))
    return path


def test_everyJobHasTheFilesOfTheCommandBooleanAndARow(tmp_path):
    pairs = [(SAMPLES / f"{a}.ply", SAMPLES / f"{b}.ply", name)
             for name, (a, b, _) in sample_catalogue.PAIRS.items()]
    done = run(write_table(tmp_path / "jobs.csv", pairs), tmp_path / "out")
    assert done.returncode == 0, done.stderr
    rows = results(tmp_path / "out")
    assert list(rows) == list(sample_catalogue.PAIRS)
    catalogue = json.loads((SAMPLES / "catalogue.json").read_text())["pairs"]
    for entry in catalogue:
        row = rows[entry["name"]]
        assert row["status"] == "done" and row["closed"] == "yes" and float(row["seconds"]) > 0
        for block in FOUR_BLOCKS:
            found, expected = float(row[f"{block}_volume"]), entry["blocks"][block]["volume"]
            assert found == pytest.approx(expected, abs=1e-11)
            _, faces = read_mesh(tmp_path / "out" / entry["name"] / f"{block}.ply")
            assert len(faces) == int(row[f"{block}_faces"])
    assert "lies within" in rows["nested"]["message"] and not rows["general"]["message"]
    single = [sys.executable, "-m", "indexboolean", "boolean", *PAIR, "-o", tmp_path / "single"]
    subprocess.run(single, check=True, capture_output=True, timeout=60)
    for block in FOUR_BLOCKS:
        same = tmp_path / "out/crossing_cylinders" / f"{block}.ply"
        assert same.read_bytes() == (tmp_path / "single" / f"{block}.ply").read_bytes()
    assert not (tmp_path / "out" / ".unfinished").exists()


def test_transformsNamesBlocksAndRelativePaths(tmp_path):
    saved(tmp_path / "cube.ply", box((0, 0, 0), (2, 2, 2)))
    shift = "1 0 0 1  0 1 0 1  0 0 1 1"
    mirror = "[-1, 0, 0, 4; 0, 1, 0, 1; 0, 0, 1, 1; 0, 0, 0, 1]"
    rows = [
        ("cube.ply", "cube.ply", "", "", shift, ""),
        ("cube.ply", "cube.ply", "mirrored", shift, mirror, "union;symmetric_difference"),
        ("cube.ply", "cube.ply", "", "", "", "union intersection"),
    ]
    table = write_table(tmp_path / "jobs.csv", rows, COLUMNS)
    done = run(table, tmp_path / "out", "--only", "intersection", "--format", "off", cwd="/")
    assert done.returncode == 0, done.stderr
    rows = results(tmp_path / "out")
    assert list(rows) == ["0001", "mirrored", "0003"]
    assert rows["0001"]["intersection_volume"] == "1.0" and not rows["0001"]["union_volume"]
    assert rows["mirrored"]["union_volume"] == "12.0"
    assert rows["mirrored"]["symmetric_difference_volume"] == "8.0"
    assert "mirrored by its matrix" in rows["mirrored"]["message"]
    assert rows["0003"]["union_volume"] == rows["0003"]["intersection_volume"] == "8.0"
    assert (tmp_path / "out/0001/intersection.off").is_file()


def test_rowsMayBeDistances(tmp_path):
    saved(tmp_path / "a.ply", box((0, 0, 0), (1, 1, 1)))
    saved(tmp_path / "b.ply", box((3, 0, 0), (4, 1, 1)))
    rows = [
        ("a.ply", "b.ply", "far", "distance", "", ""),
        ("a.ply", "b.ply", "moved", "distance", "1 0 0 1  0 1 0 0  0 0 1 0", ""),
        ("a.ply", "b.ply", "apart", "", "", "union"),
    ]
    columns = ("first", "second", "name", "job", "first_transform", "blocks")
    done = run(write_table(tmp_path / "jobs.csv", rows, columns), tmp_path / "out")
    assert done.returncode == 0, done.stderr
    found = results(tmp_path / "out")
    assert [found[name]["hausdorff"] for name in ("far", "moved", "apart")] == ["3.0", "2.0", ""]
    assert found["far"]["min_first"] == "2.0" and found["far"]["beyond_second"] == "0"
    assert not found["far"]["union_volume"] and found["apart"]["union_volume"] == "2.0"
    names = {path.name for path in (tmp_path / "out/far").iterdir()}
    assert names == {"first.ply", "second.ply", "result.json", "job.json"}
    again = run(tmp_path / "jobs.csv", tmp_path / "out")
    assert "3 of 3 jobs are finished already" in again.stderr
    for job, blocks, sentence in (("dance", "", "no job"), ("distance", "union", "no blocks")):
        write_table(tmp_path / "wrong.csv", [("a.ply", "b.ply", "x", job, "", blocks)], columns)
        refused = run(tmp_path / "wrong.csv", tmp_path / "out")
        assert refused.returncode == 1 and sentence in refused.stderr


def test_secondRunDoesWhatHasChangedAndNothingElse(tmp_path):
    for name, path in zip(("a", "b"), PAIR):
        shutil.copy(path, tmp_path / f"{name}.ply")
    shutil.copy(PAIR[1], tmp_path / "c.ply")
    rows = [("a.ply", f"{second}.ply", name, "", "", "union")
            for name, second in zip(("same", "file", "row", "damaged"), "bcbb")]
    table, folder = write_table(tmp_path / "jobs.csv", rows, COLUMNS), tmp_path / "out"
    assert run(table, folder).returncode == 0
    before, first_results = records(folder), results(folder)
    again = run(table, folder)
    assert again.returncode == 0 and "4 of 4 jobs are finished already" in again.stderr
    assert records(folder) == before and results(folder) == first_results
    os.utime(tmp_path / "c.ply")
    rows[2] = (*rows[2][:5], "intersection")
    write_table(table, rows, COLUMNS)
    with open(folder / "damaged" / "union.ply", "r+b") as file:
        file.truncate(100)
    third = run(table, folder)
    assert third.returncode == 0 and "1 of 4 jobs are finished already" in third.stderr
    after = records(folder)
    assert {name for name in after if after[name] != before[name]} == {"file", "row", "damaged"}
    assert not (folder / "row" / "union.ply").exists()  # of the row as it was
    assert (folder / "damaged" / "union.ply").stat().st_size > 100


def test_jobsThatFailAreRowsAndTheOthersGoOn(tmp_path):
    vertices, faces = box((0, 0, 0), (1, 1, 1))
    saved(tmp_path / "open.ply", (vertices, faces[1:]))
    (tmp_path / "garbage.ply").write_text("hello")
    rows = [("open.ply", PAIR[0], "open"), ("absent.ply", PAIR[0], "absent"),
            (PAIR[0], "garbage.ply", "garbage"), (*PAIR, "good")]
    table, folder = write_table(tmp_path / "jobs.csv", rows), tmp_path / "out"
    done = run(table, folder)
    assert done.returncode == 3
    assert statuses(folder) == {
        "open": "refused", "absent": "failed", "garbage": "refused", "good": "done",
    }
    assert "not closed" in results(folder)["open"]["message"]
    assert "absent.ply is not a file" in done.stderr and "Traceback" not in done.stderr
    saved(tmp_path / "absent.ply", box((-9, -9, -9), (9, 9, 9)))
    again = run(table, folder)
    assert again.returncode == 3 and "3 of 4 jobs are finished already" in again.stderr
    assert statuses(folder)["absent"] == "done"


def test_jobsAfterRefusedOnesAreDone(tmp_path):
    vertices, faces = box((0, 0, 0), (1, 1, 1))
    saved(tmp_path / "open.ply", (vertices, faces[1:]))
    pairs = [("open.ply", PAIR[0]), PAIR] * 8
    rows = [(*pair, f"{number}") for number, pair in enumerate(pairs)]
    table, folder = write_table(tmp_path / "jobs.csv", rows), tmp_path / "out"
    run(table, folder, "--workers", "1")
    assert list(statuses(folder).values()) == ["refused", "done"] * 8


def test_killedProcessIsTheLossOfItsOwnJobAlone(tmp_path):
    rows = [(tmp_path / "endless.ply", PAIR[0], "killed"), *((*PAIR, str(n)) for n in range(3))]
    table, folder = write_table(tmp_path / "jobs.csv", rows), tmp_path / "out"
    with endless_mesh(tmp_path / "endless.ply") as wait_for_reader:
        batch = start(table, folder, "--workers", "1")
        os.kill(wait_for_reader(), signal.SIGKILL)
        _, errors = batch.communicate(timeout=60)
    assert batch.returncode == 3
    assert statuses(folder) == {"killed": "crashed", "0": "done", "1": "done", "2": "done"}
    assert "SIGKILL" in errors and "--memory" in results(folder)["killed"]["message"]
    os.remove(tmp_path / "endless.ply")
    shutil.copy(PAIR[1], tmp_path / "endless.ply")
    assert run(table, folder).returncode == 0


def test_jobThatHangsIsGivenUp(tmp_path):
    rows = [(tmp_path / "endless.ply", PAIR[0], "hangs"), (*PAIR, "good")]
    table, folder = write_table(tmp_path / "jobs.csv", rows), tmp_path / "out"
    with endless_mesh(tmp_path / "endless.ply") as wait_for_reader:
        batch = start(table, folder, "--workers", "1", "--timeout", "2")
        reader = wait_for_reader()
        batch.communicate(timeout=60)
    assert batch.returncode == 3 and not is_running(reader)
    assert statuses(folder) == {"hangs": "timed_out", "good": "done"}
    assert "2 seconds" in results(folder)["hangs"]["message"]
    assert 2 <= float(results(folder)["hangs"]["seconds"]) < 20


def test_memoryOfEachProcessIsCapped(tmp_path):
    large = [saved(tmp_path / f"{n}.ply", sphere((0.4 * n, 0.1, 0), 1, 8)) for n in range(2)]
    table = write_table(tmp_path / "jobs.csv", [(*large, "large"), (*PAIR, "small")])
    capped = run(table, tmp_path / "out", "--memory", "600M", "--workers", "1")
    assert capped.returncode == 3, capped.stderr
    assert statuses(tmp_path / "out") == {"large": "out_of_memory", "small": "done"}
    assert "memory" in results(tmp_path / "out")["large"]["message"]
    free = run(table, tmp_path / "out", "--workers", "1")
    assert free.returncode == 0, free.stderr


def test_interruptEndsAtOnceAndTheNextRunGoesOn(tmp_path):
    rows = [(*PAIR, "before"), (tmp_path / "endless.ply", PAIR[0], "hangs"), (*PAIR, "after")]
    table, folder = write_table(tmp_path / "jobs.csv", rows), tmp_path / "out"
    with endless_mesh(tmp_path / "endless.ply") as wait_for_reader:
        batch = start(table, folder, "--workers", "1")
        reader = wait_for_reader()
        press_ctrl_c(batch)
        _, errors = batch.communicate(timeout=10)
    assert batch.returncode == 130
    assert "interrupted" in errors and "crashed" not in errors and "Traceback" not in errors
    assert not is_running(reader)
    assert statuses(folder) == {"before": "done"}
    kept = records(folder)
    os.remove(tmp_path / "endless.ply")
    shutil.copy(PAIR[1], tmp_path / "endless.ply")
    assert run(table, folder).returncode == 0
    assert set(statuses(folder).values()) == {"done"}
    assert records(folder)["before"] == kept["before"]


def test_batchThatIsKilledLeavesNoProcessAndLosesNoFinishedJob(tmp_path):
    rows = [(*PAIR, "before"), (tmp_path / "endless.ply", PAIR[0], "hangs")]
    table, folder = write_table(tmp_path / "jobs.csv", rows), tmp_path / "out"
    with endless_mesh(tmp_path / "endless.ply") as wait_for_reader:
        batch = start(table, folder, "--workers", "1")
        reader = wait_for_reader()
        batch.kill()
        batch.communicate(timeout=10)
        wait_until(lambda: not is_running(reader), 10)
    os.remove(tmp_path / "endless.ply")
    again = run(table, folder)
    assert again.returncode == 3 and "1 of 2 jobs are finished already" in again.stderr
    assert statuses(folder) == {"before": "done", "hangs": "failed"}


def test_absentHostIsToldOnce(tmp_path):
    (tmp_path / "pymeshlab.py").write_text("raise ImportError('libGL.so.1: no such file')\n")
    done = run(
        table_of_copies(tmp_path / "jobs.csv", 3), tmp_path / "out",
        env={**os.environ, "PYTHONPATH": str(tmp_path)},
    )
    assert done.returncode == 1
    assert done.stderr.count("cannot be imported: libGL.so.1") == 1
    assert "Traceback" not in done.stderr


def test_terminalSeesABar(tmp_path):
    done = run(
        table_of_copies(tmp_path / "jobs.csv", 3), tmp_path / "out",
        env={**os.environ, "FORCE_COLOR": "1", "TERM": "xterm"},
    )
    assert done.returncode == 0 and "3/3" in done.stderr and "LOG:" not in done.stderr
    assert "done" in done.stdout and "results.csv" in done.stdout


@pytest.mark.parametrize(
    "content, sentences",
    [
        ("", ["must name the columns first, second"]),
        ("first,second\n", ["no rows"]),
        ("first,second,transfrom\na,b,c\n", ["must name", "transfrom"]),
        ("first,second,name\na,b,x\na,b,x\n", ["line 3: line 2 has the name 'x', too"]),
        ("first,second,name\na,b,../x\na,,y\n", ["line 2: '../x'", "line 3: second is empty"]),
        ("first,second,blocks\na,b,union minus\n", ["line 2: no block 'minus'"]),
        ("first,second,first_transform\na,b,1 2 3\n", ["line 2: first_transform has 3 numbers"]),
        ("first,second,first_transform\na,b," + " nan" * 12 + "\n", ["not finite"]),
        ("first,second,first_transform\na,b," + " 1" * 16 + "\n", ["must be 0 0 0 1"]),
        ("first,second\na,b,c\n", ["line 2: it has more or fewer cells"]),
    ],
)
def test_wrongTablesAreRefusedBeforeAnyJob(tmp_path, content, sentences):
    (tmp_path / "jobs.csv").write_text(content)
    done = run(tmp_path / "jobs.csv", tmp_path / "out")
    assert done.returncode == 1
    for sentence in sentences:
        assert sentence in done.stderr
    assert not (tmp_path / "out").exists() and "Traceback" not in done.stderr


def test_absentTableAndFolderThatCannotBeMadeEndWithOne(tmp_path):
    assert run(tmp_path / "none.csv", tmp_path / "out").returncode == 1
    (tmp_path / "file").write_text("")
    table = table_of_copies(tmp_path / "jobs.csv", 1)
    assert run(table, tmp_path / "file" / "out").returncode == 1


@pytest.mark.parametrize(
    "options",
    [["--workers", "0"], ["--timeout", "-1"], ["--memory", "lots"], ["--only", "everything"]],
    ids=lambda options: options[0],
)
def test_wrongUsageEndsWithTwo(tmp_path, options):
    done = run(table_of_copies(tmp_path / "jobs.csv", 1), tmp_path / "out", *options)
    assert done.returncode == 2 and "usage:" in done.stderr
