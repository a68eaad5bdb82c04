# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""bench/limits.py says which inputs exceed their limits, and the inputs are what they should be."""

import math
import stat
import subprocess
import sys
from pathlib import Path

import pytest

from test_bench import measured, volumes

BENCH = Path(__file__).resolve().parents[2] / "bench"
sys.path.append(str(BENCH))

import limits  # noqa: E402

SPHERES = limits.Measured(1.0, 100)


@pytest.mark.parametrize(
    ("hard", "exceeded"),
    [
        (limits.Measured(3.0, 200), []),
        (limits.Measured(3.1, 200), ["seconds > 3 times"]),
        (limits.Measured(3.0, 201), ["memory > 2 times"]),
        (limits.Measured(9.0, 900), ["seconds > 3 times", "memory > 2 times"]),
        (limits.Measured(2.0, 0, "more than 2 s"), ["more than 2 s"]),
        (limits.Measured(trouble="out of memory"), ["out of memory"]),
    ],
)
def test_anInputKeepsBothLimitsOrExceedsThem(hard, exceeded):
    assert limits.verdict(hard, SPHERES) == exceeded


def test_spheresThatFailKeepNoLimit():
    assert limits.verdict(limits.Measured(1.0, 100), limits.Measured(trouble="not closed"))


def test_theMedianIsThatOfTheFirstFailure():
    runs = [limits.Measured(s, m) for s, m in ((1, 30), (5, 20), (2, 10))]
    assert limits.median(runs) == limits.Measured(2, 20)
    failed = limits.Measured(trouble="out of memory")
    assert limits.median([runs[0], failed]) == failed


def program(path, hard):
    """Stands for the benchmark: spheres take a second and 100 bytes, or what `hard` says."""
    path.write_text(
        f"#!{sys.executable}\n"
        "import json, sys, time\n"
        "part = {'seconds_each_run': [9.0, 1.0], 'peak_memory_bytes': 100}\n"
        "if '--sizes' in sys.argv:\n"
        "    print(json.dumps({'operands': [{'faces': 30}, {'faces': 12}]})), sys.exit()\n"
        "if '--spheres' not in sys.argv:\n"
        f"    {hard}\n"
        "else:\n"
        "    assert sys.argv[sys.argv.index('--spheres') + 1] == '21'\n"
        "name = 'split' if '--split' in sys.argv else 'one_operation'\n"
        "print(json.dumps({'status': 'ok', name: part}))\n"
    )
    path.chmod(path.stat().st_mode | stat.S_IXUSR)
    return str(path)


@pytest.mark.parametrize(
    ("hard", "status", "said"),
    [
        ("pass", 0, "| 1.0 | 0 MB | 0 MB | 1.0 | kept |"),
        ("part['seconds_each_run'] = [4.0]", 1, "| 4.0 s | 1.0 s | 4.0 |"),
        ("part['peak_memory_bytes'] = 210", 1, "memory > 2 times"),
        ("time.sleep(60)", 1, "more than 2 s"),
        ("print(json.dumps({'status': 'out of memory'})), sys.exit(1)", 1, "out of memory"),
        ("sys.exit('index_boolean_bench: no')", 1, "index_boolean_bench: no"),
        ("sys.exit(3)", 1, "exit status 3"),
        ("bytearray(11 << 30)", 1, "MemoryError"),
    ],
)
@pytest.mark.parametrize("case", ["S3", "S8"])
def test_theExitStatusSaysWhetherALimitIsExceeded(tmp_path, case, hard, status, said):
    done = subprocess.run(
        [
            sys.executable, str(BENCH / "limits.py"), program(tmp_path / "bench", hard),
            "--cases", case, "--processes", "1", "--timeout", "2",
        ],
        capture_output=True, text=True,
    )
    lines = done.stdout.splitlines()
    assert done.returncode == status, done.stderr
    assert len(lines) == 5 and lines[-1].startswith(f"| {case} ") and "| 42 |" in lines[-1]
    assert said in lines[-1]


def test_anUnknownCaseIsAnError(tmp_path):
    done = subprocess.run(
        [sys.executable, str(BENCH / "limits.py"), "none", "--cases", "S99"],
        capture_output=True, text=True,
    )
    assert done.returncode == 1 and "S99" in done.stderr


def polygon_area(sides, radius):
    return sides / 2 * radius**2 * math.sin(2 * math.pi / sides)


# Per option: a small size, its faces, and the volume of the union (of all sub-blocks, if split).
SMALL = {
    "--tower": (4, 60, 10 + 1.5**3 - 0.75),
    "--wall": (3, 120, 9 + 0.5**3 / 2),
    "--stray-spheres": (2000, 4000, None),
    "--cones": (8, 32, 2 / 3 * polygon_area(8, 1)),
    "--polygon-plate": (6, 72 + 72 + 76, 0.1 + 1.9 * polygon_area(20, 0.35)),
    "--row": (4, 60, 4 + 0.5**3 / 2),
    "--pinwheel": (5, 32, 5 / 3 * math.sin(0.4 * math.tau / 5)),
}


@pytest.mark.parametrize("row", limits.ROWS, ids=lambda row: row.name)
def test_inputsAreTheSolidsTheyAreSaidToBe(row):
    size, faces, volume = SMALL[row.option]
    arguments = [row.option, size, *row.both, "--one-operation", "--runs", 1]
    report = measured(*arguments)
    assert report["status"] == "ok" and "four_blocks" not in report
    sizes = measured(row.option, size, "--sizes")["operands"]
    assert sizes == report["operands"] and sum(operand["faces"] for operand in sizes) == faces
    if "--split" in row.both:
        assert report["split"]["sub_blocks"] == 6, "the first cube in two, three more, the rest"
        found = report["split"]["sub_blocks_volume"]
    else:
        (found,) = volumes(report["one_operation"]).values()
        assert report["one_operation"]["blocks"]["union"]["closed"]
    if volume is None:
        spheres = measured("--spheres", size, "--one-operation", "--runs", 1)
        (volume,) = volumes(spheres["one_operation"]).values()
    assert found == pytest.approx(volume, abs=2e-6)
    part = report.get("one_operation") or report["split"]
    assert ("attributes" in part["seconds_per_stage"]) == ("--attributes" in row.both)
