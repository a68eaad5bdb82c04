# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the command line writes is what was certified; what it refuses is told in its own words."""

import json
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pymeshlab
import pytest

import judges
import mesh_laws
from conftest import crossing_bars, document, sphere
from plain_solids import one_sided
from refusal_cases import CUBE, cracked, flat, without_faces
from run_boolean import BLOCKS, run_boolean

FIRST = sphere((0.1, 0.2, 0.3), 1.1)
SECOND = sphere((0.7, 0.5, 1 / 3), 0.9)


def saved(mesh, path):
    document(mesh).save_current_mesh(str(path))
    return path


def command(*words):
    return subprocess.run(
        [sys.executable, "-m", "indexboolean", *map(str, words)], capture_output=True, text=True,
        timeout=120,
    )


def rows_of_text(path):
    """The vertices of an OBJ or OFF file as Python reads numbers."""
    lines = path.read_text().splitlines()
    if path.suffix == ".obj":
        rows = [line.split()[1:4] for line in lines if line.startswith("v ")]
    else:
        rows = [line.split()[:3] for line in lines[2:2 + int(lines[1].split()[0])]]
    return np.array(rows, dtype=np.float64)


@pytest.mark.parametrize("suffix", ["ply", "obj", "off", "stl"])
def test_whatIsReadBackHasTheBitsThatAreCertified(tmp_path, suffix):
    files = [saved(mesh, tmp_path / f"{i}.ply") for i, mesh in enumerate((FIRST, SECOND))]
    done = command("boolean", *files, "-o", tmp_path / "out", "--format", suffix)
    assert done.returncode == 0, done.stderr
    result = json.loads((tmp_path / "out" / "result.json").read_text())
    made = run_boolean(*FIRST, *SECOND, certify_as="float" if suffix == "stl" else "host")
    for block in BLOCKS:
        path = tmp_path / "out" / f"{block}.{suffix}"
        meshes = pymeshlab.MeshSet()
        meshes.load_new_mesh(str(path))
        mesh = meshes.current_mesh()
        read = np.array(mesh.vertex_matrix()), np.array(mesh.face_matrix())
        expected, found = (
            mesh_laws.triangle_rows(vertices, faces) for vertices, faces in (made[block], read)
        )
        assert np.array_equal(np.sort(expected, axis=0), np.sort(found, axis=0)), block
        assert result[f"{block}_self_intersections"] == 0
        assert not judges.judge(*read).wrong
        if suffix in ("obj", "off"):
            assert rows_of_text(path).tobytes() == made[block][0].tobytes()


def test_linesOfIntersectionKeepEveryBitToo(tmp_path):
    files = [saved(mesh, tmp_path / f"{i}.ply") for i, mesh in enumerate((FIRST, SECOND))]
    assert command("curves", *files, "-o", tmp_path / "out").returncode == 0
    mesh_set = document(FIRST, SECOND)
    curves = mesh_set.generate_index_boolean_curves()["curves_layer"]
    expected = np.array(mesh_set.mesh(curves).vertex_matrix())
    assert rows_of_text(tmp_path / "out" / "curves.obj").tobytes() == expected.tobytes()


# What becomes of doubles that MeshLab's own writers save: docs/hosts.md has the same table.
WRITERS = {
    "ply": "every bit", "stl": "single precision", "3ds": "single precision",
    "obj": "16 decimals", "off": "16 digits", "wrl": "6 digits", "x3d": "6 digits",
    "dae": "6 digits", "xyz": "6 decimals", "ctm": "a grid",
}


def words_of_the_page():
    """{suffix: what the hosts' page says that MeshLab's writer keeps}."""
    page = (Path(__file__).resolve().parents[2] / "docs" / "hosts.md").read_text(encoding="utf-8")
    table = page.split("\n## Files that MeshLab reads and writes\n")[1].split("\n## ")[0]
    rows = re.findall(r"^\| ([A-Z0-9, ]+) \| (.+) \|$", table, re.M)
    return {name.lower(): words for names, words in rows for name in names.split(", ")}


def kept_by(path, places):
    """How much of the places is left when the file is read."""
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(str(path))
    read = np.unique(meshes.current_mesh().vertex_matrix(), axis=0)
    return "every bit" if np.array_equal(read, np.unique(places, axis=0)) else (
        "single precision" if np.array_equal(
            read, np.unique(places.astype(np.float32), axis=0)) else "less"
    )


@pytest.mark.parametrize("suffix", WRITERS)
def test_hostsWritersKeepWhatThePageSays(tmp_path, suffix):
    path = saved(FIRST, tmp_path / f"saved.{suffix}")
    kept = kept_by(path, FIRST[0])
    expected, words = WRITERS[suffix], words_of_the_page()[suffix]
    assert ("every bit" in words, "single" in words) == (
        expected == "every bit", expected == "single precision")
    assert kept == (expected if expected in ("every bit", "single precision") else "less")


@pytest.mark.parametrize("words, mesh, sentence", [
    (["boolean"], without_faces(CUBE, 3),
     r"MeshLab's \"Close Holes\" \(pymeshlab: meshing_close_holes\) .* the command split cuts"),
    (["boolean"], one_sided(), "With --winding-rule odd it does not matter"),
    (["boolean", "--self-intersections", "refuse"], crossing_bars(),
     "With --self-intersections resolve the layer is taken for"),
    (["split", "--self-intersections", "refuse"], crossing_bars(),
     "With --self-intersections resolve the layer is cut by itself"),
    (["boolean", "--format", "stl"], (CUBE[0] * 1e60, CUBE[1]),
     "With another --format than stl results are kept in double precision"),
    (["distance"], flat([(-1, -1, 1), (3, -1, 1), (3, 3, 1), (-1, 3, 1)]),
     "With --self-intersections trust distances are measured"),
    (["evaluate", "a - b"], cracked(CUBE, 1e-9, 1),
     r"with --weld-distance [\d.e+-]*\d the layer is closed"),
    (["curves", "--weld-distance", "0.3"], FIRST, "Choose a smaller --weld-distance"),
], ids=["open", "oneSided", "crossing", "crossingInSplit", "beyondFloat", "noInside", "cracked",
        "tooWide"])
def test_refusalsHaveTheWordsOfTheCommandLine(tmp_path, words, mesh, sentence):
    files = saved(mesh, tmp_path / "a.ply"), saved(SECOND, tmp_path / "b.ply")
    name, *options = words
    if name == "evaluate":
        files = options.pop(), *(f"{path.stem}={path}" for path in files)
    done = command(name, *files, "-o", tmp_path / "out", *options)
    assert done.returncode == 1, done.stderr
    assert re.search(sentence, done.stderr), done.stderr
    assert not re.search("selected|generate_index|winding_rule|self_inter|weld_dist", done.stderr)


def test_theLengthThatIsNamedIsAnOptionAndHelps(tmp_path):
    files = saved(cracked(CUBE, 1e-9, 1), tmp_path / "a.ply"), saved(SECOND, tmp_path / "b.ply")
    done = command("boolean", *files, "-o", tmp_path / "out")
    assert done.returncode == 1
    option = re.search(r"with (--weld-distance [\d.e+-]*\d) the layer is closed", done.stderr)[1]
    done = command("boolean", *files, "-o", tmp_path / "out", *option.split())
    assert done.returncode == 0, done.stderr
    result = json.loads((tmp_path / "out" / "result.json").read_text())
    assert result["welded_vertices"] > 20 and result["union_closed"]
    volume = mesh_laws.volume(*CUBE)
    solid = result["first_minus_second_volume"] + result["intersection_volume"]
    assert solid == pytest.approx(volume, rel=1e-6)


def test_aPercentageIsOfTheDiagonalOfBothMeshes(tmp_path):
    files = saved(cracked(CUBE, 1e-4, 1), tmp_path / "a.ply"), saved(SECOND, tmp_path / "b.ply")
    places = np.concatenate([CUBE[0], SECOND[0]])
    diagonal = np.linalg.norm(places.max(axis=0) - places.min(axis=0))
    share = 100 * 4e-4 / diagonal
    for text, status in ((f"{share}%", 0), (f"{share / 100}%", 1)):
        done = command("boolean", *files, "-o", tmp_path / "out", "--weld-distance", text)
        assert done.returncode == status, done.stderr


@pytest.mark.parametrize("text", ["-1", "nan", "inf", "1mm", "%"])
def test_whatIsNoLengthIsAWrongUsage(tmp_path, text):
    done = command("boolean", "a.ply", "b.ply", "-o", tmp_path, f"--weld-distance={text}")
    assert done.returncode == 2 and "--weld-distance" in done.stderr


def test_aBatchWeldsToo(tmp_path):
    saved(cracked(CUBE, 1e-9, 1), tmp_path / "a.ply")
    saved(SECOND, tmp_path / "b.ply")
    table = tmp_path / "JOBS.csv"
    table.write_text("first,second\na.ply,b.ply\n")
    for options, status in (((), 3), (("--weld-distance", "1e-8"), 0)):
        done = command("batch", table, "-o", tmp_path / "out", "--workers", "1", *options)
        assert done.returncode == status, done.stderr
    message = (tmp_path / "out" / "results.csv").read_text()
    assert "vertices were moved to the place of a neighbour" in message
