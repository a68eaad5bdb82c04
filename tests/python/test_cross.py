# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What tools/cross makes for macOS: all that its loader will look for is in pymeshlab's wheel."""

import os
import re
import shutil
import subprocess
import zipfile
from pathlib import Path

import pytest

pytestmark = pytest.mark.long

ROOT = Path(__file__).resolve().parents[2]
ARCHITECTURES = ("arm64", "x86_64")
PLUGIN = "indexboolean/libfilter_indexboolean.so"
COUNTS = r"macOS (\w+): (\d+) symbols imported, (\d+) resolved, (\d+) unresolved"
LARGEST = 1_500_000  # bytes, of a wheel


@pytest.fixture(scope="module")
def said():
    """What `tools/cross macos` says."""
    done = subprocess.run(
        [ROOT / "tools/cross", "macos"], capture_output=True, text=True, timeout=7200
    )
    assert done.returncode == 0, done.stdout[-3000:] + done.stderr[-3000:]
    return done.stdout


def link_or_copy(source, target):
    try:
        os.link(source, target)
    except OSError:  # another file system
        shutil.copy2(source, target)


@pytest.fixture
def site(said, tmp_path):
    """A function that copies the folder with both packages for a processor."""

    def copy(architecture):
        folder = tmp_path / architecture
        made = ROOT / "build/cross" / f"macos-{architecture}" / "site"
        shutil.copytree(made, folder, copy_function=link_or_copy)
        return folder

    return copy


def check(architecture, folder):
    """(exit status, unresolved symbols, all that is said) of the check of a folder."""
    done = subprocess.run(
        [ROOT / "build/cross/venv/bin/python", ROOT / "tools/macos_check.py", architecture, folder],
        capture_output=True, text=True, timeout=120,
    )
    assert not done.stderr
    return done.returncode, int(re.search(COUNTS, done.stdout)[4]), done.stdout


def replace(path, content):
    """In a copy that shares its files with what it was copied from."""
    path.unlink()
    path.write_bytes(content)


def test_everySymbolIsExportedByALibraryThatTheHostLoads(said):
    counts = {row[0]: [int(n) for n in row[1:]] for row in re.findall(COUNTS, said)}
    assert set(counts) == set(ARCHITECTURES)
    for imported, resolved, unresolved in counts.values():
        assert imported == resolved > 200
        assert unresolved == 0


@pytest.mark.parametrize("architecture", ARCHITECTURES)
def test_libraryIsForTheProcessorSignedAndAsksForTheHostsLibraries(said, site, architecture):
    status, _, text = check(architecture, site(architecture))
    assert status == 0
    assert f"{architecture}, macOS 11.0 or newer" in text
    assert int(re.search(r"signed ad hoc \((\d+) pages\)", text)[1]) > 100
    rows = dict(re.findall(r"^([@/]\S+) +(\d+) +\2$", text, re.MULTILINE))
    assert int(rows["@rpath/libmeshlab-common.dylib"]) > 10
    assert int(rows["@rpath/QtCore.framework/Versions/5/QtCore"]) > 10
    assert {name for name in rows if name.startswith("/")} == {
        "/usr/lib/libc++.1.dylib", "/usr/lib/libSystem.B.dylib",
    }


@pytest.mark.parametrize("architecture", ARCHITECTURES)
def test_wheelHoldsThePackageAndNamesNoFolderOfTheBuild(said, architecture):
    (path,) = (ROOT / "out/wheels").glob(f"indexboolean-*-py3-none-macosx_11_0_{architecture}.whl")
    assert path.stat().st_size < LARGEST
    with zipfile.ZipFile(path) as archive:
        libraries = [name for name in archive.namelist() if name.endswith((".so", ".dylib"))]
        assert libraries == [PLUGIN]
        assert "indexboolean/plugin.py" in archive.namelist()
        content = archive.read(PLUGIN)
        (tags,) = [name for name in archive.namelist() if name.endswith("/WHEEL")]
        assert f"Tag: py3-none-macosx_11_0_{architecture}\n" in archive.read(tags).decode()
    for folder in (ROOT, Path.home(), "/build/"):
        assert os.fsencode(str(folder)) not in content, folder


def test_aLibraryOfTheOtherProcessorIsRefused(site):
    folder = site("arm64")
    other = ROOT / "build/cross/macos-x86_64/site" / PLUGIN
    replace(folder / PLUGIN, other.read_bytes())
    status, _, text = check("arm64", folder)
    assert status == 1
    assert "is for x86_64, not for arm64" in text


@pytest.mark.parametrize("architecture", ARCHITECTURES)
def test_aChangeAfterSigningIsFound(site, architecture):
    folder = site(architecture)
    content = bytearray((folder / PLUGIN).read_bytes())
    content[len(content) // 2] ^= 1
    replace(folder / PLUGIN, content)
    status, _, text = check(architecture, folder)
    assert status == 1
    assert "has been changed after it was signed" in text


@pytest.mark.parametrize("architecture", ARCHITECTURES)
def test_aLibraryThatIsNotTheHostsIsFound(site, architecture):
    folder = site(architecture)
    (folder / "pymeshlab/Frameworks/libmeshlab-common.dylib").unlink()
    status, unresolved, text = check(architecture, folder)
    assert status == 1
    assert "asks for @rpath/libmeshlab-common.dylib, which pymeshlab does not load" in text
    assert unresolved > 10


def test_aHostWithoutASymbolIsFound(site):
    folder = site("arm64")
    libraries = folder / "pymeshlab/Frameworks"
    replace(libraries / "libmeshlab-common.dylib", (libraries / "libomp.dylib").read_bytes())
    status, unresolved, text = check("arm64", folder)
    assert status == 1
    assert unresolved > 10
    assert "which @rpath/libmeshlab-common.dylib is not known to export" in text
