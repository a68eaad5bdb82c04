# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The tree passes what .pre-commit-config.yaml has each commit checked by, at the same versions."""

import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
TOOLS = Path(sys.prefix) / "bin"


def sources(*suffixes):
    folders = ("bench", "filter_indexboolean", "tests", "vcg_ext")
    return [
        path for folder in folders for path in sorted((ROOT / folder).rglob("*"))
        if path.suffix in suffixes
    ]


def test_cppIsFormatted():
    files = sources(".cpp", ".h")
    assert len(files) > 100
    done = subprocess.run(
        [TOOLS / "clang-format", "--dry-run", "-Werror", "--style=file", *files], cwd=ROOT,
        capture_output=True, text=True, timeout=120,
    )
    assert done.returncode == 0, done.stderr[-3000:]


def test_pythonPassesRuff():
    done = subprocess.run(
        [TOOLS / "ruff", "check", "--no-cache", "bench", "python", "sample_meshes", "tests",
         "tools"], cwd=ROOT, capture_output=True, text=True, timeout=120,
    )
    assert done.returncode == 0, done.stdout[-3000:]


@pytest.mark.parametrize("tool", ["clang-format", "ruff"])
def test_hooksHaveTheVersionsOfTheEnvironment(tool):
    pinned = re.search(rf"^{tool}==\S+$", (ROOT / "tools/requirements.txt").read_text(), re.M)[0]
    assert f"[{pinned}]" in (ROOT / ".pre-commit-config.yaml").read_text()
