# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Walls that lie within merge_tolerance of one plane become one polygon: chains do not grow, no
surface moves farther, and what layers carry is kept."""

import json
import subprocess
import sys

import numpy as np
import pymeshlab
import pytest

import judges
import mesh_laws
import placements
import sample_catalogue
from conftest import box, document, sphere
from merged_chains import allowed_volume, manifold_steps, merged_steps
from plain_solids import column, cube, joined, shifted, turned_about
from split_run import Split
from surface_distance import farthest

MOST_FACES = 1.2  # times Manifold's
KINDS = {"carve": 25, "grow": 25, "turned": 12}
LONG_KINDS = {"carve": 100, "grow": 100, "turned": 60}
SCALARS = ("host", "float")


def length(value):
    return pymeshlab.PureValue(value)


# --- chains ---------------------------------------------------------------------------------------


def check_chain(kind, seed, steps, scalar):
    """Each step holds, moves no farther than it may, and has not many more faces than Manifold's.
    """
    faces = manifold_steps(kind, seed, steps, scalar)
    for step, most in zip(merged_steps(kind, seed, steps, scalar), faces, strict=True):
        where = f"{kind}, seed {seed}, {scalar}, step {step.number}"
        assert step.values["self_intersections"] == 0, where
        assert step.values["closed"] and step.values["largest_move"] <= step.tolerance, where
        assert len(step.mesh[1]) <= MOST_FACES * most, where
        off = abs(step.values["volume"] - step.unmerged_volume)
        assert off <= allowed_volume(step), where
    assert not judges.judge(*step.mesh).wrong
    return step


@pytest.mark.parametrize("scalar", SCALARS)
@pytest.mark.parametrize("kind", KINDS)
def test_chainsHaveHardlyMoreFacesThanManifolds(kind, scalar):
    for seed in (1, 2):
        check_chain(kind, seed, KINDS[kind], scalar)


@pytest.mark.long
@pytest.mark.parametrize("scalar", SCALARS)
@pytest.mark.parametrize("kind", LONG_KINDS)
def test_longChainsHaveHardlyMoreFacesThanManifolds(kind, scalar):
    for seed in range(1, 11):
        check_chain(kind, seed, LONG_KINDS[kind], scalar)


# Each cube's planes cut six polygons more into the ball; with Euler's formula the rest follows.
@pytest.mark.parametrize("scalar", SCALARS)
def test_turnedCubesHaveThePolygonsOfTheirPlanes(scalar):
    for step in merged_steps("turned", 7, 12, scalar, with_unmerged=False):
        polygons = 6 * (step.number + 1)
        assert len(step.mesh[1]) == 2 * (2 * (polygons - 2)) - 4


# --- how far --------------------------------------------------------------------------------------


def union_with_a_box(mesh, tolerance):
    """(what is made without a tolerance, with it, the result map)"""
    low, high = mesh[0].min(axis=0), mesh[0].max(axis=0)
    half = box(low + 0.4321 * (high - low), high + 0.1234 * (high - low))
    made = []
    for value in (0, tolerance):
        layers = document(mesh, half)
        result = layers.generate_index_boolean(
            first_mesh=0, second_mesh=1, merge_tolerance=length(value))
        layer = layers.mesh(result["union_layer"])
        made.append((layer.vertex_matrix(), layer.face_matrix()))
    return *made, result


@pytest.mark.parametrize("name", sample_catalogue.REASONS)
@pytest.mark.parametrize("share", [1e-9, 1e-4, 1e-3])
def test_samplesMoveNoFartherThanTheTolerance(name, share):
    mesh = sample_catalogue.sample(name)
    tolerance = share * float(np.linalg.norm(np.ptp(mesh[0], axis=0)))
    before, after, result = union_with_a_box(mesh, tolerance)
    assert farthest(before, after) <= tolerance
    assert result["union_largest_move"] <= tolerance
    assert result["union_self_intersections"] == 0
    assert len(after[0]) == len(before[0]) - result["union_merged_vertices"]
    assert mesh_laws.rows_in(after[0], before[0]).all()


@pytest.mark.long
@pytest.mark.parametrize("share", [1e-6, 1e-4, 1e-3])
@pytest.mark.parametrize("name", ["fandisk", "spot", "fertility", "rocker-arm", "cheburashka"])
def test_scansMoveNoFartherThanTheTolerance(name, share):
    folder = placements.meshes_folder()
    if folder is None:
        pytest.skip(f"{placements.MESHES_VARIABLE} is not set")
    mesh = placements.read_mesh(folder / f"{name}.obj")
    tolerance = share * float(np.linalg.norm(np.ptp(mesh[0], axis=0)))
    before, after, result = union_with_a_box(mesh, tolerance)
    assert farthest(before, after) <= tolerance
    assert result["union_self_intersections"] == 0


# A polygon with n corners and h holes has n - 2 + 2 h triangles, whatever they are.
@pytest.mark.parametrize("count", [6, pytest.param(50, marks=pytest.mark.long)])
def test_aTurnedPlateWithHolesHasTheFacesOfItsPolygons(count):
    sides, turn = 32, ((1, 2, 3), 0.4)
    plate = turned_about(box((0, 0, 0), (count, count, 1)), *turn)
    holes = [
        column(sides, x + 0.5, y + 0.5, 0.3) for x in range(count) for y in range(count)
    ]
    layers = document(plate, turned_about(joined(*holes), *turn))
    result = layers.generate_index_boolean(
        first_mesh=0, second_mesh=1, union=False, intersection=False, second_minus_first=False,
        merge_tolerance=pymeshlab.PercentageValue(1e-10))
    corners = 4 + sides * count**2
    expected = 2 * (corners - 2 + 2 * count**2) + 2 * corners
    assert result["first_minus_second_faces"] == expected
    assert result["first_minus_second_self_intersections"] == 0


def test_aBallStaysBelowItsSagitta():
    ball, other = sphere(subdivisions=5), sphere((0.3, 0.2, 0.1), 1.0, 5)
    layers = document(ball, other)
    plain = layers.generate_index_boolean(first_mesh=0, second_mesh=1)
    merged = layers.generate_index_boolean(
        first_mesh=0, second_mesh=1, merge_tolerance=length(1e-9))
    for block in ("union", "intersection"):
        meshes = [layers.mesh(result[f"{block}_layer"]) for result in (plain, merged)]
        assert merged[f"{block}_merged_vertices"] < 200  # beside the curve, within a face
        assert meshes[0].face_number() - meshes[1].face_number() < 400


def test_withoutAToleranceNothingIsMerged():
    layers = document(cube(2), shifted(turned_about(cube(1), (1, 2, 3), 0.4), (1, 0.1, 0)))
    result = layers.generate_index_boolean(first_mesh=0, second_mesh=1)
    assert result["union_merged_vertices"] == 0 and "seconds_merge_walls" not in result


# --- what layers carry ----------------------------------------------------------------------------


def joined_boxes(first_colours, second_colours, tolerance=1e-9):
    """The union of two boxes with a wall in common, each with colours per face: (corners, colours).
    """
    layers = pymeshlab.MeshSet()
    for solid, colours in (
        (box((0, 0, 0), (1, 1, 1)), first_colours), (box((1, 0, 0), (2, 1, 1)), second_colours)
    ):
        table = np.tile(np.array(colours, float), (12, 1))
        layers.add_mesh(pymeshlab.Mesh(*solid, f_color_matrix=table))
    result = layers.generate_index_boolean(
        first_mesh=0, second_mesh=1, merge_tolerance=length(tolerance))
    union = layers.mesh(result["union_layer"])
    return union.vertex_matrix()[union.face_matrix()], union.face_color_matrix()


def test_facesOfOneColourBecomeOnePolygon():
    corners, _ = joined_boxes((1, 0, 0, 1), (1, 0, 0, 1))
    assert len(corners) == 12


def test_facesOfOtherColoursStayApart():
    corners, colours = joined_boxes((1, 0, 0, 1), (0, 1, 0, 1))
    assert len(corners) == 20
    assert np.array_equal(colours[:, 0] == 1, corners[:, :, 0].max(axis=1) <= 1)


def test_facesWithTextureCoordinatesOfTheirOwnStayApart():
    layers = pymeshlab.MeshSet()
    solid = box((0, 0, 0), (1, 1, 1))
    for k, (vertices, faces) in enumerate((solid, shifted(solid, (1, 0, 0)))):
        corners = vertices[faces].reshape(-1, 3)
        layers.add_mesh(pymeshlab.Mesh(vertices, faces, w_tex_coords_matrix=corners[:, :2] / 2))
    result = layers.generate_index_boolean(
        first_mesh=0, second_mesh=1, merge_tolerance=length(1e-9))
    union = layers.mesh(result["union_layer"])
    corners = union.vertex_matrix()[union.face_matrix()].reshape(-1, 3)
    assert np.allclose(union.wedge_tex_coord_matrix(), corners[:, :2] / 2, rtol=0, atol=1e-7)


# --- other filters --------------------------------------------------------------------------------


def cut_cube(noise=1e-13):
    """A cube whose walls are of many faces, each a hair off its plane."""
    layers = document(cube(2), shifted(turned_about(cube(1), (1, 2, 3), 0.4), (1, 0.1, 0)))
    layers.generate_index_boolean(
        first_mesh=0, second_mesh=1, intersection=False, second_minus_first=False,
        merge_fragments=False)
    layers.set_current_mesh(2)
    layers.meshing_surface_subdivision_midpoint(iterations=2, threshold=length(0))
    points = layers.current_mesh().vertex_matrix()
    rng = np.random.default_rng(5)
    return points + rng.uniform(-noise, noise, points.shape), layers.current_mesh().face_matrix()


def test_expressionAndResolveMergeWalls():
    noisy = cut_cube()
    layers = document(noisy, shifted(cube(1), (-1, -1, -1)))
    plain = layers.generate_index_boolean_expression(expression="0 | 1; 0 - 1")
    merged = layers.generate_index_boolean_expression(
        expression="0 | 1; 0 - 1", merge_tolerance=length(1e-11))
    for k in (0, 1):
        assert 4 * merged[f"result_{k}_faces"] < plain[f"result_{k}_faces"]
        assert merged[f"result_{k}_merged_vertices"] > 100
        assert merged[f"result_{k}_self_intersections"] == 0
        assert merged[f"result_{k}_volume"] == pytest.approx(plain[f"result_{k}_volume"], abs=1e-10)
    layers = document(noisy)
    result = layers.generate_index_boolean_resolve(mesh=0, merge_tolerance=length(1e-11))
    assert 5 * result["resolved_faces"] < len(noisy[1])
    assert result["resolved_largest_move"] <= 1e-11


def test_aSplitsWallsAreMergedOnceForBothSides():
    noisy, other = cut_cube(), shifted(cube(1.5), (-1, -1, -1))
    plain = Split(noisy, other)
    merged = Split(noisy, other, merge_tolerance=length(1e-11))
    assert merged.result["merged_vertices"] > 100
    assert 0 < merged.result["largest_merge"] <= 1e-11
    assert merged.counts() == plain.counts()
    assert 4 * len(merged.blocks.faces) < len(plain.blocks.faces)
    rows = np.concatenate([
        mesh_laws.triangle_rows(surface.vertices, faces) for surface in merged.surfaces
        for faces in (surface.faces, mesh_laws.reversed_faces(surface.faces))
    ])
    for number, volume in enumerate(merged.result["sub_blocks_volumes"]):
        block = merged.block(number)
        assert mesh_laws.unmatched_edges(*block) == 0
        assert mesh_laws.volume(*block) == pytest.approx(volume, abs=1e-10)
        assert mesh_laws.rows_in(mesh_laws.triangle_rows(*block), rows).all()
    assert set(merged.result["sub_blocks_self_intersections"]) == {0}


def test_clipsHaveMergedWalls():
    layers = document(cut_cube(), shifted(cube(1.5), (-1, -1, -1)))
    found = {}
    for tolerance in (0, 1e-11):
        result = layers.generate_index_boolean_split(
            first_mesh=0, second_mesh=1, sub_surfaces_first=False, sub_surfaces_second=False,
            sub_blocks=False, first_inside_second=True, first_outside_second=True,
            merge_tolerance=length(tolerance))
        for clip in ("first_inside_second", "first_outside_second"):
            found[clip, tolerance] = result[f"{clip}_faces"], result[f"{clip}_area"]
            assert result[f"{clip}_self_intersections"] == 0
    for clip in ("first_inside_second", "first_outside_second"):
        (plain, area), (merged, same) = found[clip, 0], found[clip, 1e-11]
        assert merged < plain and same == pytest.approx(area, abs=1e-9)


# --- command line ---------------------------------------------------------------------------------


def run(*arguments):
    return subprocess.run(
        [sys.executable, "-m", "indexboolean", *map(str, arguments)], capture_output=True,
        text=True, timeout=300,
    )


@pytest.fixture(scope="module")
def files(tmp_path_factory):
    folder = tmp_path_factory.mktemp("files")
    paths = []
    for name, mesh in (("noisy", cut_cube()), ("cube", shifted(cube(1.5), (-1, -1, -1)))):
        layers = document(mesh)
        paths.append(folder / f"{name}.ply")
        layers.save_current_mesh(str(paths[-1]))
    return paths


@pytest.mark.parametrize("command", ["boolean", "evaluate", "resolve", "split"])
def test_theCommandsHaveTheSwitch(files, tmp_path, command):
    operands = {
        "boolean": files, "split": files, "resolve": files[:1],
        "evaluate": ["a - b", f"a={files[0]}", f"b={files[1]}"],
    }[command]
    key = {
        "boolean": "union_merged_vertices", "split": "merged_vertices",
        "resolve": "resolved_merged_vertices", "evaluate": "result_0_merged_vertices",
    }[command]
    for text in ("1e-11", "1e-9%"):
        done = run(command, *operands, "-o", tmp_path, "--merge-tolerance", text)
        assert done.returncode == 0, done.stderr
        assert json.loads((tmp_path / "result.json").read_text())[key] > 50
        assert "where walls were merged" in done.stderr


def test_batchesHaveTheSwitch(files, tmp_path):
    table = tmp_path / "jobs.csv"
    table.write_text(f"first,second\n{files[0]},{files[1]}\n")
    done = run("batch", table, "-o", tmp_path, "--merge-tolerance", "1e-11", "--only", "union")
    assert done.returncode == 0, done.stderr
    (record,) = tmp_path.glob("*/result.json")
    assert json.loads(record.read_text())["union_merged_vertices"] > 50


@pytest.mark.parametrize("value", [-1, float("nan")])
def test_aToleranceThatIsNoLengthIsRefused(value):
    layers = document(cube(1), shifted(cube(1), (0.5, 0.5, 0.5)))
    with pytest.raises(pymeshlab.PyMeshLabException, match="merge_tolerance is"):
        layers.generate_index_boolean(
            first_mesh=0, second_mesh=1, merge_tolerance=length(value))
    assert layers.mesh_number() == 2
