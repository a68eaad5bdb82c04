# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The recipes for machines that are not here: they are well-formed, and name what this tree has.

Nothing of them runs here: docs/hosts.md says so.
"""

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest
import yaml

ROOT = Path(__file__).resolve().parents[2]
WORKFLOWS = sorted((ROOT / ".github" / "workflows").glob("*.yml"))
TOOLS = Path(sys.prefix) / "bin"


def lint(path):
    words = [TOOLS / "actionlint", "-no-color", path]
    return subprocess.run(words, cwd=ROOT, capture_output=True, text=True, timeout=60)


@pytest.mark.parametrize("path", WORKFLOWS, ids=lambda path: path.name)
def test_actionlintFindsNothing(path):
    done = lint(path)
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.mark.parametrize("right, wrong", [
    ("needs: build", "needs: wheels"),
    ("${{ matrix.runner }}", "${{ matrix.system }}"),
    ("runner: windows-2022", "runner: windows-95"),
    ("actions/checkout@v5", "actions/checkout@v2"),
])
def test_actionlintFindsWhatIsWrong(right, wrong, tmp_path):
    text = (ROOT / ".github/workflows/wheels.yml").read_text()
    broken = tmp_path / "wheels.yml"
    broken.write_text(text.replace(right, wrong))
    assert broken.read_text() != text
    assert lint(broken).returncode == 1


@pytest.mark.parametrize("platform, built", [
    ("linux", ["cp311-manylinux_x86_64"]), ("macos", ["cp311-macosx_arm64"]),
    ("windows", ["cp311-win_amd64"]),
])
def test_cibuildwheelReadsItsTableAndBuildsOneWheel(platform, built):
    arch = {"linux": "x86_64", "macos": "arm64", "windows": "AMD64"}[platform]
    done = subprocess.run(
        [TOOLS / "cibuildwheel", "--print-build-identifiers", "--platform", platform, "--archs",
         arch], cwd=ROOT, capture_output=True, text=True, timeout=120,
        env={**os.environ, "PYTHONWARNINGS": "error"},
    )
    assert done.returncode == 0, done.stderr
    assert done.stdout.split() == built


def workflow():
    return yaml.safe_load((ROOT / ".github/workflows/wheels.yml").read_text())


def test_versionsAreThoseOfTheTree():
    environment = workflow()["env"]
    pinned = (ROOT / "tools/requirements.txt").read_text().splitlines()
    assert environment["PYMESHLAB"] in pinned
    assert environment["CIBUILDWHEEL"] in pinned
    hosts = (ROOT / "cmake/meshlab_headers.cmake").read_text()
    version = re.search(r"set\(host_pymeshlab (\S+)", hosts)
    assert environment["MESHLAB_TAG"] == f"MeshLab-{version[1]}"


def test_eachWheelThatIsBuiltIsTested():
    jobs = workflow()["jobs"]
    built, tested = (
        [row["name"] for row in jobs[job]["strategy"]["matrix"]["include"]]
        for job in ("build", "test")
    )
    assert built == tested and len(built) == 4


def test_theTestsThatAreNamedAreThere():
    steps = workflow()["jobs"]["test"]["steps"]
    named = re.findall(r"test_\w+\.py", steps[-1]["run"])
    assert len(named) > 15
    assert not [name for name in named if not (ROOT / "tests/python" / name).is_file()]
