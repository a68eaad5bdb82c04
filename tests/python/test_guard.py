# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""bench/guard.py calls a build slower where its runs are, and only there."""

import stat
import subprocess
import sys
from pathlib import Path

import pytest

BENCH = Path(__file__).resolve().parents[2] / "bench"
sys.path.append(str(BENCH))

import guard  # noqa: E402


@pytest.mark.parametrize(
    ("ratios", "slower"),
    [
        ([1.1] * 5, True),
        ([1.1, 1.1, 1.1, 1.1, 0.5], True),  # four of five agree
        ([1.1, 1.1, 1.1, 0.9, 0.9], False),  # three of five may be chance
        ([1.04] * 5, False),  # within the tolerance
        ([0.5] * 5, False),
        ([1.01, 1.01, 1.02, 9, 9], False),  # disturbed twice
    ],
)
def test_aRatioCountsIfNearlyAllPairsAgree(ratios, slower):
    ratio, is_slower = guard.verdict([(2.0, 2.0 * r) for r in ratios], 0.05)
    assert ratio == pytest.approx(sorted(ratios)[2])
    assert is_slower == slower


def program(path, seconds):
    """Stands for a build of the benchmark; one that refuses if it has no time."""
    answer = f'{{"one_operation": {{"seconds_each_run": [{seconds}]}}}}'
    path.write_text(f"#!/bin/sh\necho '{answer}'\n" if seconds else "#!/bin/sh\nexit 1\n")
    path.chmod(path.stat().st_mode | stat.S_IXUSR)
    return str(path)


@pytest.mark.parametrize(
    ("before", "after", "status", "said"),
    [
        (0.1, 0.2, 1, "SLOWER"),
        (0.2, 0.1, 0, "0.50"),
        (None, 0.1, 0, "not run by both"),
    ],
)
def test_theExitStatusSaysWhetherACaseIsSlower(tmp_path, before, after, status, said):
    done = subprocess.run(
        [
            sys.executable,
            str(BENCH / "guard.py"),
            program(tmp_path / "before", before),
            program(tmp_path / "after", after),
            "--cases",
            "spheres",
        ],
        capture_output=True,
        text=True,
    )
    assert done.returncode == status
    assert said in done.stdout
