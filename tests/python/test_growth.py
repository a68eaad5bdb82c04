# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""bench/growth.py says what grows faster than it should; its layers are what they should be."""

import json
import stat
import subprocess
import sys
from pathlib import Path

import manifold3d
import numpy as np
import pytest

import mesh_laws
import oracles
from test_bench import measured, volumes

BENCH = Path(__file__).resolve().parents[2] / "bench"
sys.path.append(str(BENCH))

import growth  # noqa: E402
import peers  # noqa: E402

SMALL = {"--stack": 6, "--crossed-cones": 12, "--near-copies": 80, "--pencil": 3}


def parts_of(points, triangles):
    """The connected parts of a surface, as solids of Manifold."""
    labels = mesh_laws.component_labels(triangles, len(points))[triangles[:, 0]]
    return [
        oracles._to_manifold(points, triangles[labels == label]) for label in np.unique(labels)
    ]


@pytest.mark.parametrize("row", growth.ROWS, ids=lambda row: row.name)
def test_layersAreTheSolidsTheyAreSaidToBe(row, tmp_path):
    report = measured(
        row.option, SMALL[row.option], "--resolve", "--one-operation", "--runs", 1,
        "--save-arrays", tmp_path,
    )
    assert report["status"] == "ok"
    part = report["one_operation"]
    assert part["blocks"]["union"]["closed"]
    assert part["arrangement"]["segments_on_faces"] > 0
    assert part["arrangement"]["pieces"] > part["arrangement"]["faces_cut"] > 0
    solids = [
        solid for number in range(2) for solid in parts_of(*peers.load_operand(tmp_path, number))
    ]
    expected = manifold3d.Manifold.batch_boolean(solids, manifold3d.OpType.Add).volume()
    assert volumes(part)["union"] == pytest.approx(expected, rel=1e-9)


def program(path, seconds):
    """Stands for the benchmark: an input of size n has 2 n segments, and takes what `seconds` says
    of n, and 10 n bytes."""
    path.write_text(
        f"#!{sys.executable}\n"
        "import json, sys\n"
        "n = int(sys.argv[2])\n"
        "part = {'arrangement': {'segments_on_faces': 2 * n, 'pieces': n},\n"
        f"        'seconds_each_run': [{seconds}, 1e9], 'peak_memory_bytes': 10 * n + 7}}\n"
        "print(json.dumps({'status': 'ok', 'operands': [{'faces': n}], 'one_operation': part,\n"
        "                  'memory_before_bytes': 7}))\n"
    )
    path.chmod(path.stat().st_mode | stat.S_IXUSR)
    return str(path)


@pytest.mark.parametrize(("seconds", "status"), [("n", 0), ("n ** 1.2", 0), ("n * n", 1)])
def test_theExitStatusSaysWhetherAnythingGrows(tmp_path, seconds, status):
    done = subprocess.run(
        [sys.executable, str(BENCH / "growth.py"), program(tmp_path / "bench", seconds),
         "--processes", "1"],
        capture_output=True, text=True,
    )
    assert done.returncode == status, done.stderr
    lines = done.stdout.splitlines()
    assert sum(line.startswith("| ") for line in lines) == 1 + sum(
        len(row.sizes) for row in growth.ROWS
    )
    said = [line for line in lines if "of a segment grow to 4.0 times" in line]
    assert len(said) == (len(growth.ROWS) if status else 0)


def test_aRefusalIsAnError(tmp_path):
    refusal = json.dumps({"status": "not closed"})
    path = tmp_path / "bench"
    path.write_text(f"#!{sys.executable}\nprint('{refusal}')\n")
    path.chmod(path.stat().st_mode | stat.S_IXUSR)
    done = subprocess.run(
        [sys.executable, str(BENCH / "growth.py"), str(path)], capture_output=True, text=True
    )
    assert done.returncode == 1 and "not closed" in done.stderr
