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


# Each wing may include itself and those before it.
WINGS = {
    "vcg_ext": ("base", "exact", "mesh", "arrange", "carry", "parts", "solids", ""),
    "filter_indexboolean": ("runs", "texts", "layers", "attributes", "filters", "hosts"),
}


def wing_of(path):
    """The wing of a file given by its place below the folder of the wings; '': the top."""
    return path.split("/")[0] if "/" in path else ""


@pytest.mark.parametrize("folder", WINGS)
def test_filesIncludeNothingBehindTheirWing(folder):
    order = WINGS[folder]
    included = 0
    for path in (ROOT / folder).rglob("*.*"):
        if path.suffix not in (".cpp", ".h"):
            continue
        own = order.index(wing_of(path.relative_to(ROOT / folder).as_posix()))
        for name in re.findall(r'^#include "([^"]+)"', path.read_text(), re.M):
            wing = wing_of(name.removeprefix("vcg_ext/")) if folder == "vcg_ext" else wing_of(name)
            included += 1
            if folder == "vcg_ext" or "/" in name:
                assert order.index(wing) <= own, f"{path}: {name}"
    assert included > 50


def test_theFilterKnowsThePublicHeadersOnly():
    """index_boolean.h; and, to read and write layers, the templates on vcglib's meshes."""
    public = {"vcg_ext/index_boolean.h", "vcg_ext/mesh/mesh_arrays_vcg.h"}
    for path in sources(".cpp", ".h"):
        if path.is_relative_to(ROOT / "filter_indexboolean"):
            names = re.findall(r'^#include [<"](vcg_ext/[^>"]+)', path.read_text(), re.M)
            assert set(names) <= public, path


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
