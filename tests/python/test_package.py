# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The package finds its plugin, loads it once, and says in a sentence why it cannot."""

import importlib.metadata
import os
import pathlib
import subprocess
import sys

import indexboolean
import pymeshlab
import pytest


def two_cubes():
    meshes = pymeshlab.MeshSet()
    meshes.create_cube(size=2)
    meshes.create_cube(size=2)
    meshes.compute_matrix_from_rotation(rotaxis="Z axis", angle=30)
    meshes.compute_matrix_from_translation(
        traslmethod="XYZ translation", axisx=0.7, axisy=0.4, axisz=0.3
    )
    return meshes


def test_pluginPathIsTheSharedLibrary():
    path = pathlib.Path(indexboolean.plugin_path())
    assert path.name == "libfilter_indexboolean.so"
    assert path.is_file()


def test_loadedFilterIsAMethodOfAMeshSetThatExistedBefore():
    meshes = two_cubes()
    indexboolean.load_plugin()
    result = meshes.generate_index_boolean(first_mesh=0, second_mesh=1)
    assert result["union_closed"]
    assert meshes.mesh_number() == 6


def test_loadingTwiceDoesNothing():
    indexboolean.load_plugin()
    filters = pymeshlab.filter_list()
    indexboolean.load_plugin()
    assert pymeshlab.filter_list() == filters


def test_pluginLoadedByHandGetsItsMethod():
    code = (
        "import pymeshlab, indexboolean\n"
        "pymeshlab.load_plugin(indexboolean.plugin_path())\n"
        "assert not hasattr(pymeshlab.MeshSet, 'generate_index_boolean')\n"
        "indexboolean.load_plugin()\n"
        "assert hasattr(pymeshlab.MeshSet, 'generate_index_boolean')\n"
    )
    subprocess.run([sys.executable, "-c", code], check=True, timeout=60)


def test_absentHostIsNamedWithWhatToInstall(monkeypatch):
    def not_found(name):
        raise importlib.metadata.PackageNotFoundError(name)

    monkeypatch.setattr(importlib.metadata, "version", not_found)
    with pytest.raises(indexboolean.HostError, match="not installed.*pip install.*2025.7"):
        indexboolean.load_plugin()


def test_otherHostVersionIsNamedWithTheOneNeeded(monkeypatch):
    monkeypatch.setattr(importlib.metadata, "version", lambda name: "2023.12")
    with pytest.raises(indexboolean.HostError, match="2023.12 is installed.*2025.7"):
        indexboolean.load_plugin()


def test_hostInAnotherFolderIsNamedOnMacOS(monkeypatch, tmp_path):
    """There the plugin's load commands lead to the host's libraries from where it lies itself."""
    loaded = []
    monkeypatch.setattr(sys, "platform", "darwin")
    monkeypatch.setattr(pymeshlab, "filter_list", lambda: [])
    monkeypatch.setattr(pymeshlab, "load_plugin", loaded.append)
    beside = pathlib.Path(indexboolean.plugin_path()).parents[1] / "pymeshlab/__init__.py"
    monkeypatch.setattr(pymeshlab, "__file__", str(beside))
    indexboolean.load_plugin()
    assert loaded == [indexboolean.plugin_path()]
    monkeypatch.setattr(pymeshlab, "__file__", str(tmp_path / "pymeshlab/__init__.py"))
    with pytest.raises(indexboolean.HostError, match=f"pymeshlab in {tmp_path}; .* one environ"):
        indexboolean.load_plugin()
    assert len(loaded) == 1


def test_hostWithoutItsLibrariesIsNamed(monkeypatch, tmp_path):
    (tmp_path / "pymeshlab.py").write_text("raise ImportError('libGL.so.1: no such file')\n")
    code = "import indexboolean; indexboolean.load_plugin()"
    environment = {**os.environ, "PYTHONPATH": str(tmp_path)}
    run = subprocess.run(
        [sys.executable, "-c", code], env=environment, capture_output=True, text=True, timeout=60
    )
    assert run.returncode != 0
    assert "cannot be imported: libGL.so.1: no such file" in run.stderr
    assert "libgl1" in run.stderr


def test_pluginNamesNoFolderOfTheBuildMachine():
    content = pathlib.Path(indexboolean.plugin_path()).read_bytes()
    assert str(pathlib.Path(__file__).parents[2]).encode() not in content
