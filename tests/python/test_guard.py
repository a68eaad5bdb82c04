# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""bench/guard.py calls a build slower where its runs are, and only there."""

import json
import os
import stat
import subprocess
import sys
from pathlib import Path

import pytest

BENCH = Path(__file__).resolve().parents[2] / "bench"
sys.path.append(str(BENCH))

import guard  # noqa: E402


@pytest.mark.parametrize(
    ("ratios", "word"),
    [
        ([1.1] * 5, "SLOWER"),
        ([1.1, 1.1, 1.1, 0.5, 0.5], "SLOWER"),  # disturbed twice
        ([1.04] * 5, "ok"),  # within the tolerance
        ([0.5] * 5, "ok"),
        ([1.01, 1.01, 1.02, 9, 9], "ok"),  # disturbed twice
    ],
)
def test_theMedianRatioDecides(ratios, word):
    ratio, noise, said = guard.verdict([(2.0, 2.0 * r, 2.0) for r in ratios], 0.05)
    assert ratio == pytest.approx(sorted(ratios)[2])
    assert noise == 0
    assert said == word


@pytest.mark.parametrize(
    ("ratio", "again", "word"),
    [
        (1.2, [1, 1, 1.1, 1, 1], "SLOWER"),  # beyond tolerance and noise
        (1.2, [1, 1, 1.2, 1, 1], "unclear"),
        (1.2, [1, 1, 0.8, 1, 1], "unclear"),
        (1.2, [1, 1.2, *[1] * 10], "SLOWER"),  # of more rounds the extremes do not count
        (1.2, [1.2, 1.2, 1.2, *[1] * 9], "unclear"),
        (1.04, [1, 1, 1.2, 1, 1], "unclear"),  # it may be 1.2
        (0.8, [1, 1, 1.2, 1, 1], "ok"),
    ],
)
def test_whatABuildDiffersFromItselfWidensTheTolerance(ratio, again, word):
    rounds = [(1.0, ratio, a) for a in again]
    assert guard.verdict(rounds, 0.05)[2] == word


def test_moreRoundsOfTheSameScatterAreLessNoise():
    scatter = [0.9, 1.02, 1.1, 0.98, 1.0, 1.01]
    noises = [guard.noise([(1.0, 1.0, a) for a in scatter * n]) for n in (1, 3, 9)]
    assert noises[0] == pytest.approx(0.1)
    assert sorted(noises, reverse=True) == noises
    assert noises[2] < 0.03


# Answers as the benchmark does, and writes down what it was asked.
PROGRAM = """#!/bin/sh
echo "$@" >> {log}
case "$*" in
*{fails}*) echo "unknown: {fails}" >&2; exit 2 ;;
*--terrain*) echo '{{"split": {{"seconds_each_run": [9, {seconds}]}}}}' ;;
*--small-pairs*) echo '{{"small_pairs": {{"seconds": {seconds}}}}}' ;;
*) echo '{{"one_operation": {{"seconds_each_run": [9, {seconds}]}}}}' ;;
esac
"""


def program(path, seconds, fails="--none"):
    """Stands for a build of the benchmark that does not know one option."""
    path.write_text(PROGRAM.format(log=f"{path}.log", seconds=seconds, fails=fails))
    path.chmod(path.stat().st_mode | stat.S_IXUSR)
    return str(path)


def run_guard(before, after, *arguments, meshes=None):
    environment = {k: v for k, v in os.environ.items() if k != guard.MESHES_VARIABLE}
    if meshes:
        environment[guard.MESHES_VARIABLE] = str(meshes)
    return subprocess.run(
        [sys.executable, str(BENCH / "guard.py"), before, after, *arguments],
        capture_output=True, text=True, env=environment,
    )


def rows(done):
    """The words of each case that was run by both."""
    names = [case.name for case in guard.OWN_CASES] + guard.MESH_NAMES
    lines = done.stdout.splitlines()
    return {name: line.split()[-1] for name in names for line in lines if line.startswith(name)}


@pytest.mark.parametrize(
    ("before", "after", "status", "said"),
    [
        (0.1, 0.2, 1, "SLOWER"),
        (0.2, 0.1, 0, "0.500"),
    ],
)
def test_theExitStatusSaysWhetherACaseIsSlower(tmp_path, before, after, status, said):
    builds = program(tmp_path / "before", before), program(tmp_path / "after", after)
    done = run_guard(*builds, "--cases", "spheres")
    assert done.returncode == status
    assert said in done.stdout


@pytest.mark.parametrize("failing", ["before", "after"])
def test_aCaseThatOneBuildDoesNotRunFails(tmp_path, failing):
    builds = [
        program(tmp_path / name, 0.1, *(["--plate"] if name == failing else []))
        for name in ("before", "after")
    ]
    done = run_guard(*builds)
    assert done.returncode == 1
    assert f"not run by both: {tmp_path / failing}: unknown: --plate" in done.stdout
    assert list(rows(done).values()).count("ok") == len(guard.OWN_CASES) - 1


@pytest.mark.parametrize(
    ("tolerances", "slower"),
    [
        ([], {"spheres"}),
        (["0.2"], set()),
        (["spheres=0.2"], set()),
        (["0.01"], {"spheres", "two boxes"}),
        (["two boxes=0.01"], {"spheres", "two boxes"}),
        (["spheres=0.2", "0.01"], {"two boxes"}),
        (["0.2", "spheres=0.01"], {"spheres"}),
    ],
)
def test_eachCaseHasItsTolerance(tmp_path, monkeypatch, tolerances, slower):
    monkeypatch.delenv(guard.MESHES_VARIABLE, raising=False)
    options = [word for text in tolerances for word in ("--tolerance", text)]
    cases = guard.select_cases(guard.parse_arguments(["before", "after", *options]))
    rounds = [(1.0, 1.08, 1.0)] * 6
    words = {case.name: guard.verdict(rounds, case.tolerance)[2] for case in cases}
    assert {name for name in ("spheres", "two boxes") if words[name] == "SLOWER"} == slower


@pytest.mark.parametrize(
    ("option", "said"),
    [
        (["--tolerance", "sphere=0.1"], "no case is named sphere"),
        (["--tolerance", "spheres=much"], "--tolerance"),
        (["--cases", "cone"], "no case has 'cone'"),
    ],
)
def test_aMisnamedCaseIsAUsageError(tmp_path, option, said):
    builds = program(tmp_path / "before", 0.1), program(tmp_path / "after", 0.1)
    done = run_guard(*builds, *option)
    assert done.returncode == 2
    assert said in done.stderr


def test_withoutTheFolderOfMeshesTheirCasesAreSaidToBeSkipped(tmp_path):
    builds = program(tmp_path / "before", 0.1), program(tmp_path / "after", 0.1)
    done = run_guard(*builds)
    assert done.returncode == 0, done.stdout + done.stderr
    (line,) = [line for line in done.stdout.splitlines() if "skipped" in line]
    assert all(name in line for name in guard.MESH_NAMES)
    assert "skipped" not in run_guard(*builds, "--cases", "spheres").stdout


def mesh_folder(folder):
    """As good as the real one, for a program that reads no file."""
    transform = [[1.5, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]]
    pairs = [("88566.stl", "58011.stl"), ("908460.stl", "73416.stl"), ("c.stl", "d.stl")]
    entries = [
        {"a": a, "b": b, "transform_a": transform, "transform_b": transform} for a, b in pairs
    ]
    (folder / "ember_cases.json").write_text(json.dumps(entries))
    for name in ("armadillo.obj", "bunny100k.obj", *pairs[0], *pairs[1]):
        (folder / name).touch()
    return folder


def test_meshesAreGivenToBothBuildsAsPlaced(tmp_path):
    builds = program(tmp_path / "before", 0.1), program(tmp_path / "after", 0.1)
    done = run_guard(*builds, "--cases", ", ", meshes=mesh_folder(tmp_path))
    assert done.returncode == 0, done.stdout + done.stderr
    assert {name for name, word in rows(done).items() if word == "ok"} >= set(guard.MESH_NAMES)
    asked = {Path(f"{build}.log").read_text().replace("\n", " ") for build in builds}
    for text in asked:
        assert f"{tmp_path}/armadillo.obj {tmp_path}/bunny100k.obj --place standard" in text
        assert f"{tmp_path}/73416.stl --transform-first 1.5,0,0,0,0," in text


@pytest.mark.parametrize("missing", ["bunny100k.obj", "73416.stl", "ember_cases.json", ""])
def test_aFolderWithoutTheMeshesFails(tmp_path, missing):
    builds = program(tmp_path / "before", 0.1), program(tmp_path / "after", 0.1)
    folder = mesh_folder(tmp_path)
    if missing:
        (folder / missing).unlink()
    done = run_guard(*builds, meshes=folder if missing else folder / "absent")
    assert done.returncode == 1
    assert guard.MESHES_VARIABLE in done.stderr and missing in done.stderr


def test_argumentsAfterTheMarkAreGivenToBothBuildsEveryTime(tmp_path):
    builds = program(tmp_path / "before", 0.1), program(tmp_path / "after", 0.1)
    done = run_guard(*builds, "--cases", "spheres", "--pairs", "7", "--", "--threads", "1")
    assert done.returncode == 0, done.stdout + done.stderr
    asked = [Path(f"{build}.log").read_text().splitlines() for build in builds]
    assert [len(lines) for lines in asked] == [14, 7]
    assert set(asked[0]) == set(asked[1]) == {"--spheres 328000 --runs 3 --seconds 0.5 --threads 1"}


def test_aNoisyCaseIsRunLongerButNotForEver(tmp_path, monkeypatch):
    args = guard.parse_arguments(["before", "after", "--limit", "100"])
    case = guard.Case("any", [])
    clock = [0.0]
    monkeypatch.setattr(guard.time, "monotonic", lambda: clock[0])

    def seconds_that(scatter):
        def seconds(*_):
            clock[0] += 1
            return 1 + scatter * (clock[0] % 2)

        return seconds

    monkeypatch.setattr(guard, "seconds", seconds_that(0))
    assert len(guard.measure(("b", "a", "b"), case, args)) == args.pairs
    monkeypatch.setattr(guard, "seconds", seconds_that(1))
    assert len(guard.measure(("b", "a", "b"), case, args)) == 34
