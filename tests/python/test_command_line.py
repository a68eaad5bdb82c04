# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m indexboolean: files, exit statuses and messages."""

import json
import os
import pathlib
import signal
import subprocess
import sys

import numpy
import pymeshlab
import pytest

from conftest import box, crossing_bars
from open_shapes import bumpy_sheet

SAMPLES = pathlib.Path(__file__).parents[2] / "sample_meshes"
FIRST, SECOND = SAMPLES / "bumpy_sphere.ply", SAMPLES / "ribbed_torus.ply"
FOUR_BLOCKS = ["union", "intersection", "first_minus_second", "second_minus_first"]


def command(*arguments):
    return [sys.executable, "-m", "indexboolean", *map(str, arguments)]


def run(*arguments):
    return subprocess.run(command(*arguments), capture_output=True, text=True, timeout=120)


def load(path):
    """(vertices, faces)"""
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(str(path))
    mesh = meshes.current_mesh()
    return mesh.vertex_matrix(), mesh.face_matrix()


def volume(vertices, faces):
    return numpy.linalg.det(vertices[faces]).sum() / 6


def files_of(folder):
    return sorted(path.name for path in folder.iterdir())


def as_format(folder, source, extension):
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(str(source))
    path = folder / f"{source.stem}.{extension}"
    meshes.save_current_mesh(str(path))
    return path


def test_fourBlocksAndTheResultAreWritten(tmp_path):
    done = run("boolean", FIRST, SECOND, "-o", tmp_path / "a" / "b")
    assert done.returncode == 0, done.stderr
    assert "LOG:" not in done.stderr
    assert files_of(tmp_path / "a" / "b") == sorted(
        [f"{block}.ply" for block in FOUR_BLOCKS] + ["result.json"]
    )
    result = json.loads((tmp_path / "a" / "b" / "result.json").read_text())
    for block in FOUR_BLOCKS:
        vertices, faces = load(tmp_path / "a" / "b" / result["files"][block])
        assert len(faces) == result[f"{block}_faces"]
        assert volume(vertices, faces) == pytest.approx(result[f"{block}_volume"], rel=1e-12)
        assert result[f"{block}_closed"] is True
        assert block in done.stdout
        assert str(len(faces)) in done.stdout


def test_plyIsBinaryInTheHostsScalar(tmp_path):
    assert run("boolean", FIRST, SECOND, "-o", tmp_path).returncode == 0
    header = (tmp_path / "union.ply").read_bytes().split(b"end_header")[0]
    assert b"binary_little_endian" in header
    assert b"property double x" in header


def test_onlyTheBlocksAskedForAreWritten(tmp_path):
    only = "symmetric_difference,union"
    assert run("boolean", FIRST, SECOND, "-o", tmp_path, "--only", only).returncode == 0
    assert files_of(tmp_path) == ["result.json", "symmetric_difference.ply", "union.ply"]
    result = json.loads((tmp_path / "result.json").read_text())
    assert "intersection_volume" not in result


@pytest.mark.parametrize("extension", ["obj", "off", "stl"])
def test_otherFormatsAreReadAndWritten(tmp_path, extension):
    first, second = (as_format(tmp_path, mesh, extension) for mesh in (FIRST, SECOND))
    out = tmp_path / "out"
    done = run("boolean", first, second, "-o", out, "--format", extension)
    assert done.returncode == 0, done.stderr
    result = json.loads((out / "result.json").read_text())
    written = volume(*load(out / f"union.{extension}"))
    assert written == pytest.approx(result["union_volume"], rel=1e-5)


@pytest.mark.parametrize("extension", ["ply", "obj", "off", "stl"])
def test_emptyBlockIsAFileToo(tmp_path, extension):
    outer, inner = SAMPLES / "nested_outer.ply", SAMPLES / "nested_inner.ply"
    done = run("boolean", outer, inner, "-o", tmp_path, "--format", extension)
    assert done.returncode == 0, done.stderr
    assert (tmp_path / f"second_minus_first.{extension}").is_file()
    result = json.loads((tmp_path / "result.json").read_text())
    assert result["second_minus_first_faces"] == 0
    assert "is empty" in done.stderr


def test_openOperandIsRefusedByName(tmp_path):
    vertices, faces = load(FIRST)
    opened = pymeshlab.MeshSet()
    opened.add_mesh(pymeshlab.Mesh(vertices, faces[1:]))
    opened.save_current_mesh(str(tmp_path / "opened.ply"))
    done = run("boolean", tmp_path / "opened.ply", SECOND, "-o", tmp_path / "out")
    assert done.returncode == 1
    assert "opened.ply" in done.stderr
    assert "not closed" in done.stderr
    assert not (tmp_path / "out" / "result.json").exists()


def test_switchesReachTheFilter(tmp_path):
    files = []
    for name, mesh in (("bars", crossing_bars()), ("far", box((10, 10, 10), (11, 11, 11)))):
        meshes = pymeshlab.MeshSet()
        meshes.add_mesh(pymeshlab.Mesh(*mesh))
        files.append(tmp_path / f"{name}.ply")
        meshes.save_current_mesh(str(files[-1]))
    switches = "--no-merge-fragments", "--merge-coplanar", "--weld-non-manifold"
    done = run("boolean", *files, "-o", tmp_path / "out", *switches)
    assert done.returncode == 0, done.stderr
    record = json.loads((tmp_path / "out/result.json").read_text())
    assert record["union_volume"] == pytest.approx(9.0625)  # the bars are resolved
    switches += ("--self-intersections", "refuse")
    done = run("boolean", *files, "-o", tmp_path / "out", *switches)
    assert done.returncode == 1
    assert "bars.ply" in done.stderr
    assert "intersects itself" in done.stderr


@pytest.mark.parametrize(
    "name, content, sentence",
    [
        ("absent.ply", None, "is not a file"),
        ("garbage.ply", "hello", "cannot be read"),
        ("unknown.xyzq", "hello", "cannot be read"),
    ],
)
def test_unreadableInputIsNamed(tmp_path, name, content, sentence):
    path = tmp_path / name
    if content is not None:
        path.write_text(content)
    done = run("boolean", path, SECOND, "-o", tmp_path / "out")
    assert done.returncode == 1
    assert f"{path} {sentence}" in done.stderr
    assert "Traceback" not in done.stderr
    assert not (tmp_path / "out").exists()


def test_folderThatCannotBeMadeIsNamed(tmp_path):
    (tmp_path / "file").write_text("")
    done = run("boolean", FIRST, SECOND, "-o", tmp_path / "file" / "out")
    assert done.returncode == 1
    assert str(tmp_path / "file") in done.stderr
    assert "Traceback" not in done.stderr


@pytest.mark.parametrize(
    "arguments",
    [
        [],
        ["boolean", FIRST],
        ["boolean", FIRST, SECOND],
        ["boolean", FIRST, SECOND, "-o", "out", "--only", "union,everything"],
        ["boolean", FIRST, SECOND, "-o", "out", "--format", "docx"],
    ],
)
def test_wrongUsageEndsWithStatusTwo(arguments):
    done = run(*arguments)
    assert done.returncode == 2
    assert "usage:" in done.stderr


def test_interruptEndsWithStatus130(tmp_path):
    pipe = tmp_path / "endless.ply"
    os.mkfifo(pipe)
    process = subprocess.Popen(
        command("boolean", pipe, SECOND, "-o", tmp_path / "out"), stderr=subprocess.PIPE, text=True
    )
    with open(pipe, "w"):  # opens once the host reads from it, and gives it nothing
        process.send_signal(signal.SIGINT)
        _, errors = process.communicate(timeout=60)
    assert process.returncode == 130
    assert "interrupted" in errors
    assert "Traceback" not in errors


def test_terminalSeesTheStagesAndNoNoise(tmp_path):
    done = subprocess.run(
        command("boolean", FIRST, SECOND, "-o", tmp_path), capture_output=True, text=True,
        env={**os.environ, "FORCE_COLOR": "1", "TERM": "xterm"},  # taken for a terminal
        timeout=120,
    )
    assert done.returncode == 0
    assert "reading bumpy_sphere.ply" in done.stderr
    assert "writing union.ply" in done.stderr
    assert "100%" in done.stderr
    for noise in ("LOG:", "Applying filter", "first_mesh"):
        assert noise not in done.stdout + done.stderr


def test_threadCountFollowsTheEnvironment(tmp_path):
    written = []
    for threads in ("1", "2"):
        folder = tmp_path / threads
        subprocess.run(
            command("boolean", FIRST, SECOND, "-o", folder), check=True, timeout=120,
            env={**os.environ, "OMP_NUM_THREADS": threads}, stdout=subprocess.DEVNULL,
        )
        written.append([(folder / f"{block}.ply").read_bytes() for block in FOUR_BLOCKS])
    assert written[0] == written[1]


def ply_properties(path):
    header = path.read_bytes().split(b"end_header")[0].decode()
    return [line.split()[-1] for line in header.splitlines() if line.startswith("property")]


def ply_faces(path):
    """The faces of a file that the command split wrote, with their numbers."""
    header, body = path.read_bytes().split(b"end_header\n", 1)
    counts = [int(line.split()[2]) for line in header.decode().splitlines() if "element" in line]
    numbers = [(name, "<i4") for name in ply_properties(path)[8:]]
    row = numpy.dtype(
        [("count", "u1"), ("corners", "<i4", 3), ("colour", "u1", 4), *numbers]
    )
    vertices = numpy.frombuffer(body, "<f8", 3 * counts[0]).reshape(-1, 3)
    return vertices, numpy.frombuffer(body, row, counts[1], 24 * counts[0])


def sheet_file(folder):
    meshes = pymeshlab.MeshSet()
    meshes.add_mesh(pymeshlab.Mesh(*bumpy_sheet((0.1, 0.2, 1), 0.05, 3, 20)))
    meshes.save_current_mesh(str(folder / "sheet.ply"))
    return folder / "sheet.ply"


def test_splitWritesPiecesWithNumbersAndTheResult(tmp_path):
    done = run("split", FIRST, sheet_file(tmp_path), "-o", tmp_path / "out")
    assert done.returncode == 0, done.stderr
    kinds = "sub_surfaces_first", "sub_surfaces_second", "sub_blocks"
    assert files_of(tmp_path / "out") == sorted([*(f"{kind}.ply" for kind in kinds), "result.json"])
    result = json.loads((tmp_path / "out" / "result.json").read_text())
    assert [result[kind] for kind in kinds] == [2, 2, 2]
    vertices, faces = ply_faces(tmp_path / "out" / "sub_blocks.ply")
    for number, expected in enumerate(result["sub_blocks_volumes"]):
        block = faces["corners"][faces["sub_block"] == number]
        assert volume(vertices, block) == pytest.approx(expected, rel=1e-12)
    assert len(numpy.unique(faces["colour"], axis=0)) == 2
    assert set(numpy.unique(faces["block_front"])) == {-1, 0, 1}
    # Any reader of PLY files reads them.
    assert len(load(tmp_path / "out" / "sub_blocks.ply")[1]) == len(faces)
    assert "sub_blocks" in done.stdout and "2 sub-blocks" in done.stderr


def test_splitWritesAFileForEachPiece(tmp_path):
    sheet = sheet_file(tmp_path)
    only = "--separate", "--only", "sub_blocks,sub_surfaces_second"
    done = run("split", FIRST, sheet, "-o", tmp_path / "out", *only)
    assert done.returncode == 0, done.stderr
    assert files_of(tmp_path / "out") == [
        "result.json", "sub_blocks_0.ply", "sub_blocks_1.ply",
        "sub_surfaces_second_0.ply", "sub_surfaces_second_1.ply",
    ]
    result = json.loads((tmp_path / "out" / "result.json").read_text())
    assert result["files"]["sub_blocks"] == ["sub_blocks_0.ply", "sub_blocks_1.ply"]
    done = run("split", FIRST, sheet, "-o", tmp_path / "few", *only, "--max-files", 3)
    assert done.returncode == 0
    assert "more than max_layers (3)" in done.stderr
    assert files_of(tmp_path / "few") == [
        "result.json", "sub_blocks.ply", "sub_surfaces_second.ply",
    ]


def test_curvesWritesEdgesAndTheLoops(tmp_path):
    done = run("curves", SAMPLES / "cylinder_along_x.ply", SAMPLES / "cylinder_along_y.ply",
               "-o", tmp_path)
    assert done.returncode == 0, done.stderr
    assert files_of(tmp_path) == ["curves.obj", "result.json"]
    lines = (tmp_path / "curves.obj").read_text().splitlines()
    vertices = sum(line.startswith("v ") for line in lines)
    assert sum(line.startswith("l ") for line in lines) == vertices - 4
    loops = json.loads((tmp_path / "result.json").read_text())["loops"]
    assert [loop["kind"] for loop in loops] == ["soft_closed"] * 4
    assert all(len(loop["sub_surfaces_first"]) == 2 for loop in loops)
    assert all(len(loop["sub_surfaces_second"]) == 2 for loop in loops)


def test_curvesOfMeshesThatDoNotMeetAreAnEmptyFile(tmp_path):
    done = run("curves", SAMPLES / "nested_outer.ply", SAMPLES / "nested_inner.ply", "-o", tmp_path)
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "curves.obj").is_file()
    assert json.loads((tmp_path / "result.json").read_text())["loops"] == []


@pytest.mark.parametrize("command_name", ["split", "curves"])
def test_otherCommandsHaveTheSameExitStatuses(command_name, tmp_path):
    assert run(command_name, tmp_path / "absent.ply", FIRST, "-o", tmp_path / "out").returncode == 1
    assert run(command_name, FIRST, SECOND).returncode == 2
    shown = run(command_name, "--help")
    assert shown.returncode == 0 and "Exit status: 0 done, 1 refused" in " ".join(
        shown.stdout.split()
    )


def test_splitRefusesUnknownPieces():
    done = run("split", FIRST, SECOND, "-o", "out", "--only", "pieces")
    assert done.returncode == 2 and "no kind of pieces 'pieces'" in done.stderr


def block_and_sheets(folder):
    """Files of a box and of two sheets through it."""
    meshes = pymeshlab.MeshSet()
    paths = []
    for name, mesh in (
        ("block", box((-1, -1, -1), (1, 1, 1))),
        ("level", bumpy_sheet((0.1, 0.2, 1), 0.05, 3, 20)),
        ("upright", bumpy_sheet((1, 0.2, 0.1), 0.15, 3, 20)),
    ):
        meshes.add_mesh(pymeshlab.Mesh(*mesh), name)
        paths.append(folder / f"{name}.ply")
        meshes.save_current_mesh(str(paths[-1]))
    return paths


def test_splitTakesAnyNumberOfFiles(tmp_path):
    block, level, upright = block_and_sheets(tmp_path)
    written = []
    for number, arguments in enumerate((
        ("--layers", block, level, upright),
        (block, level, "--layers", upright),
        (block, level, "--layers", block, level, upright),  # each is taken once
    )):
        folder = tmp_path / str(number)
        done = run("split", "-o", folder, *arguments)
        assert done.returncode == 0, done.stderr
        kinds = [*(f"sub_surfaces_{k}" for k in range(3)), "sub_blocks"]
        assert files_of(folder) == sorted([*(f"{kind}.ply" for kind in kinds), "result.json"])
        result = json.loads((folder / "result.json").read_text())
        expected = {"0": str(block), "1": str(level), "2": str(upright)}
        assert result["operand_files"] == expected
        assert result["files"] == {kind: f"{kind}.ply" for kind in kinds}
        assert (result["operands"], result["sub_blocks"]) == (3, 4)
        assert sum(result["sub_blocks_volumes"]) == pytest.approx(8, rel=1e-12)
        assert "sub_surfaces_2" in done.stdout
        written.append([(folder / f"{kind}.ply").read_bytes() for kind in kinds])
        faces = ply_faces(folder / "sub_surfaces_2.ply")[1]
        assert set(faces["source_mesh"]) == {2}
    assert written[0] == written[1] == written[2]
    done = run("split", "-o", tmp_path / "few", "--layers", block, level, upright,
               "--only", "sub_blocks", "--separate")
    assert done.returncode == 0, done.stderr
    assert files_of(tmp_path / "few") == [
        "result.json", *(f"sub_blocks_{k}.ply" for k in range(4))
    ]


def test_splitOfOneFileCutsItByItself(tmp_path):
    meshes = pymeshlab.MeshSet()
    meshes.add_mesh(pymeshlab.Mesh(*crossing_bars()))
    meshes.save_current_mesh(str(tmp_path / "bars.ply"))
    done = run("split", "-o", tmp_path / "out", "--layers", tmp_path / "bars.ply")
    assert done.returncode == 0, done.stderr
    assert files_of(tmp_path / "out") == ["result.json", "sub_blocks.ply", "sub_surfaces_0.ply"]


def test_splitClips(tmp_path):
    block, level, upright = block_and_sheets(tmp_path)
    done = run("split", level, block, "-o", tmp_path / "all",
               "--clip", "first-inside,first-outside")
    assert done.returncode == 0, done.stderr
    clips = ["first_inside_second", "first_outside_second"]
    kinds = ["sub_blocks", "sub_surfaces_first", "sub_surfaces_second"]
    assert files_of(tmp_path / "all") == sorted(
        [*(f"{name}.ply" for name in (*clips, *kinds)), "result.json"]
    )
    result = json.loads((tmp_path / "all" / "result.json").read_text())
    areas = sorted(result[f"{clip}_area"] for clip in clips)
    assert areas == pytest.approx(sorted(result["sub_surfaces_first_areas"]), rel=1e-12)
    for clip in clips:
        vertices, faces = ply_faces(tmp_path / "all" / f"{clip}.ply")
        assert len(faces) == result[f"{clip}_faces"]
        assert set(faces["source_mesh"]) == {0}
        assert clip in done.stdout
    inside = ply_faces(tmp_path / "all" / "first_inside_second.ply")[0]
    assert abs(inside).max() <= 1
    done = run("split", block, level, "-o", tmp_path / "one", "--clip", "second-inside",
               "--only", "none")
    assert done.returncode == 0, done.stderr
    assert files_of(tmp_path / "one") == ["result.json", "second_inside_first.ply"]
    again = ply_faces(tmp_path / "one" / "second_inside_first.ply")[0]
    assert numpy.array_equal(numpy.unique(again, axis=0), numpy.unique(inside, axis=0))
    done = run("split", level, block, "-o", tmp_path / "list", "--layers", upright, "--clip",
               "first-inside", "--only", "none")
    assert done.returncode == 0, done.stderr
    third = json.loads((tmp_path / "list" / "result.json").read_text())
    area = result["first_inside_second_area"]
    assert third["first_inside_second_area"] == pytest.approx(area, rel=1e-12)


def test_anOpenFileThatIsToClipIsRefused(tmp_path):
    block, level, _ = block_and_sheets(tmp_path)
    done = run("split", block, level, "-o", tmp_path / "out", "--clip", "first-inside")
    assert done.returncode == 1
    assert 'Layer "level.ply" (id 1) is not closed' in done.stderr
    assert "meshing_close_holes" in done.stderr


@pytest.mark.parametrize(
    "arguments, sentence",
    [
        ((FIRST,), "two mesh files are needed, or --layers"),
        ((), "two mesh files are needed, or --layers"),
        ((FIRST, SECOND, "--clip", "inside"), "no clip 'inside'; there are first-inside"),
        (("--layers", FIRST, "--clip", "first-inside"), "--clip needs two mesh files"),
        ((FIRST, SECOND, "--only", "none"), "--only none needs --clip"),
        (("--only", "sub_surfaces_first", "--layers", FIRST, SECOND), "does not go with --layers"),
    ],
)
def test_splitRefusesWhatMakesNoSplit(arguments, sentence):
    done = run("split", "-o", "out", *arguments)
    assert done.returncode == 2
    assert sentence in done.stderr
