# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The wheel: one for every Python 3, complete with pymeshlab alone, nothing of the build inside."""

import importlib.metadata
import os
import re
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
LARGEST = 1_600_000  # bytes; docs/hosts.md states the size


@pytest.fixture(scope="module")
def wheel(tmp_path_factory):
    """The wheel that `pip wheel .` makes of this checkout."""
    folder = tmp_path_factory.mktemp("wheel")
    pip("wheel", "--no-deps", "--wheel-dir", folder, ROOT)
    (path,) = folder.iterdir()
    return path


def pip(*arguments, python=sys.executable):
    words = (python, "-m", "pip", "-q", "--disable-pip-version-check", *arguments)
    subprocess.run([str(word) for word in words], check=True, timeout=600)


def plugin_in(wheel, tmp_path):
    with zipfile.ZipFile(wheel) as archive:
        return Path(archive.extract("indexboolean/libfilter_indexboolean.so", tmp_path))


def test_nameSaysAnyPython3OnThisPlatform(wheel):
    assert re.fullmatch(r"indexboolean-[\d.]+-py3-none-\w+_x86_64\.whl", wheel.name)


def test_holdsThePackageAndNoLibraryOfTheHost(wheel):
    with zipfile.ZipFile(wheel) as archive:
        names = archive.namelist()
    assert [name for name in names if ".so" in name] == ["indexboolean/libfilter_indexboolean.so"]
    assert not [name for name in names if "__pycache__" in name]
    assert wheel.stat().st_size < LARGEST


def test_pluginLooksForLibrariesNowhereButInTheHost(wheel, tmp_path):
    dynamic = subprocess.run(
        ["readelf", "-d", plugin_in(wheel, tmp_path)], capture_output=True, text=True, check=True
    ).stdout
    assert "RPATH" not in dynamic and "RUNPATH" not in dynamic
    needed = set(re.findall(r"NEEDED.*\[(.+)\]", dynamic))
    assert "libmeshlab-common.so" in needed
    system = {"libstdc++.so.6", "libm.so.6", "libgcc_s.so.1", "libc.so.6"}
    # The loader, ld-linux, gives each thread its own variables.
    known = ("libmeshlab", "libQt5", "ld-linux")
    assert all(name in system or name.startswith(known) for name in needed)


def symbol_versions(path):
    """{family: the newest version of it, as numbers} of the symbols that a library takes."""
    words = ["readelf", "--version-info", "--wide", path]
    text = subprocess.run(words, capture_output=True, text=True, check=True).stdout
    text = text.split("Version needs section", 1)[-1]
    newest = {}
    for family, version in re.findall(r"Name: ([A-Z]+)_([\d.]+)", text):
        numbers = tuple(map(int, version.split(".")))
        newest[family] = max(newest.get(family, ()), numbers)
    return newest


def test_pluginRunsWhereverPymeshlabDoes(wheel, tmp_path):
    """It takes no symbol that is newer than those that pymeshlab itself takes, or its tag says."""
    host = importlib.metadata.distribution("pymeshlab")
    libraries = [host.locate_file(file) for file in host.files if ".so" in file.name]
    host_takes = {}
    for library in libraries:
        for family, numbers in symbol_versions(library).items():
            host_takes[family] = max(host_takes.get(family, ()), numbers)
    takes = symbol_versions(plugin_in(wheel, tmp_path))
    assert {"GLIBC", "GLIBCXX", "CXXABI"} <= takes.keys() and len(libraries) > 20
    newer = {family: of for family, of in takes.items() if of > host_takes.get(family, (0,))}
    assert not newer
    tag = re.search(r"manylinux_(\d+)_(\d+)_", host.read_text("WHEEL"))
    assert takes["GLIBC"] <= (int(tag[1]), int(tag[2]))


def test_pluginNamesNoFolderOfTheBuild(wheel, tmp_path):
    content = plugin_in(wheel, tmp_path).read_bytes()
    for folder in (ROOT, Path.home(), "/tmp/", "/build/"):
        assert os.fsencode(str(folder)) not in content, folder


def test_freshEnvironmentNeedsPymeshlabAndTheWheelOnly(wheel, tmp_path):
    version = importlib.metadata.version("pymeshlab")
    subprocess.run([sys.executable, "-m", "venv", tmp_path / "venv"], check=True)
    python = tmp_path / "venv/bin/python"
    pip("install", f"pymeshlab=={version}", wheel, python=python)
    code = (ROOT / "docs/hosts.md").read_text().split("```python\n")[1].split("```")[0]
    environment = {k: v for k, v in os.environ.items() if not k.startswith("PYTHON")}
    done = subprocess.run(
        [python, "-c", code], cwd=tmp_path, env=environment, capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr
    assert 4 < float(done.stdout.split()[-1]) < 7.24
