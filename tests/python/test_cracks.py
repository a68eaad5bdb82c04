# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Layers whose faces do not quite meet: told the distance that closes them, and right with it."""

import json
import re
import subprocess
import sys

import numpy as np
import pymeshlab
import pytest

import judges
import mesh_laws
import oracles
import sample_catalogue
from conftest import box, document, sphere
from refusal_cases import CUBE, SECOND, cracked, run
from run_boolean import BLOCKS
from test_reports import load, load_stl

SAMPLES = [
    name for name in sample_catalogue.REASONS
    if mesh_laws.unmatched_edges(*sample_catalogue.sample(name)) == 0
]


def cracked_by_ulps(mesh, seed):
    """Each face by itself, each coordinate of its corners moved to a neighbour, or not."""
    soup = mesh[0][mesh[1]].reshape(-1, 3)
    towards = np.random.default_rng(seed).choice([-np.inf, 0, np.inf], soup.shape)
    moved = np.where(towards == 0, soup, np.nextafter(soup, towards))
    return moved, np.arange(len(soup)).reshape(-1, 3)


def distance_named(mesh_set):
    with pytest.raises(pymeshlab.PyMeshLabException) as refusal:
        run(mesh_set)
    return float(re.search(r"weld_distance = ([\d.e+-]*\d) the layer", str(refusal.value))[1])


def beside(mesh):
    """A box that cuts the mesh's box in the middle, at no place of it."""
    low, high = mesh[0].min(axis=0), mesh[0].max(axis=0)
    return box(low + 0.4321 * (high - low), high + 0.1234 * (high - low))


def expect_right(made, result, first, second, allowed):
    """Each block is closed, certified by a judge of its own, and has libigl's volume."""
    for block, expected in oracles.libigl_blocks(*first, *second).items():
        mesh = made.mesh(result[f"{block}_layer"])
        arrays = mesh.vertex_matrix(), mesh.face_matrix()
        assert abs(mesh_laws.volume(*arrays) - mesh_laws.volume(*expected)) <= allowed, block
        assert result[f"{block}_closed"] and result[f"{block}_open_edges"] == 0
        assert result[f"{block}_self_intersections"] == 0
        assert not judges.judge(*arrays).wrong


@pytest.mark.parametrize("most", [0, 1e-7], ids=["ulps", "1e-7"])
@pytest.mark.parametrize("name", SAMPLES)
def test_aCrackedSampleIsRightWithTheDistanceThatIsNamed(name, most):
    mesh = sample_catalogue.sample(name)
    seed = len(name)
    soup = cracked(mesh, most, seed) if most else cracked_by_ulps(mesh, seed)
    other = beside(mesh)
    made = document(soup, other)
    distance = distance_named(made)
    assert 0 < distance <= (1e-6 if most else 1e-13)
    result = run(made, weld_distance=pymeshlab.PureValue(distance))
    assert result["welded_vertices"] > len(soup[0]) / 3
    assert 0 < result["largest_weld"] <= 2 * distance
    allowed = (mesh_laws.area(*mesh) + mesh_laws.area(*other)) * 2 * distance + 1e-12
    expect_right(made, result, mesh, other, allowed)


def test_theCadPartIsRightWithTheDistanceThatIsNamed():
    part = load_stl("idler_riser.STL")
    made = document(part, beside(part))
    distance = distance_named(made)
    result = run(made, weld_distance=pymeshlab.PureValue(distance))
    assert result["union_closed"] and result["welded_vertices"] > 0
    whole = mesh_laws.volume(*part)
    solid = result["first_minus_second_volume"] + result["intersection_volume"]
    assert solid == pytest.approx(whole, rel=1e-6)


def test_aPercentageIsOfTheDiagonalOfAllLayers():
    soup = cracked(CUBE, 1e-4, 5)
    made = document(soup, SECOND)
    diagonal = np.linalg.norm(np.ptp(np.concatenate([soup[0], SECOND[0]]), axis=0))
    for share, distance in ((0.1, 0.1 / 100 * diagonal), (0.01, 0.01 / 100 * diagonal)):
        by_share = document(soup, SECOND)
        run(by_share, weld_distance=pymeshlab.PercentageValue(share))
        run(made, weld_distance=pymeshlab.PureValue(distance))
        expected, found = (m.mesh(m.mesh_number() - 4) for m in (made, by_share))
        assert np.array_equal(expected.vertex_matrix(), found.vertex_matrix())


@pytest.mark.parametrize(
    "filter_name",
    ["generate_index_boolean", "generate_index_boolean_split", "generate_index_boolean_curves"],
)
def test_eachFilterWeldsAndSaysSo(filter_name):
    made = document(cracked(CUBE, 1e-9, 6), SECOND)
    result = run(made, filter_name, weld_distance=pymeshlab.PureValue(1e-8))
    assert result["welded_vertices"] > 20 and 0 < result["largest_weld"] < 1e-8
    assert (result["loops_hard_closed"], result["loops_open"]) == (1, 0)
    untouched = document(CUBE, SECOND)
    result = run(untouched, filter_name, weld_distance=pymeshlab.PureValue(1e-8))
    assert (result["welded_vertices"], result["largest_weld"]) == (0, 0.0)
    result = run(untouched, filter_name)
    assert (result["welded_vertices"], result["largest_weld"]) == (0, 0.0)


def test_whatIsNotNearStaysBitByBit():
    first = sphere((0.1, 0.2, 0.3), 1.5)
    welded, plain = document(first, SECOND), document(first, SECOND)
    run(welded, weld_distance=pymeshlab.PureValue(1e-3))
    run(plain)
    for layer in range(2, 6):
        a, b = welded.mesh(layer), plain.mesh(layer)
        assert np.array_equal(a.vertex_matrix(), b.vertex_matrix())
        assert np.array_equal(a.face_matrix(), b.face_matrix())


class TestOpenByIndex:
    """<block>_open_edges: 0, but where vertices in one place have to stay apart."""

    def test_computedNormalsAreNoSeam(self):
        made = document(*load("cgal7998_unwelded_caps"))
        result = run(made)
        expected = {"union": 0.702024044, "intersection": 0.282993969,
                    "first_minus_second": 0.209515037}
        for block, volume in expected.items():
            assert result[f"{block}_volume"] == pytest.approx(volume, abs=1e-9)
        for block in BLOCKS:
            faces = made.mesh(result[f"{block}_layer"]).face_matrix()
            assert result[f"{block}_open_edges"] == open_edges(faces) == 0

    @pytest.mark.parametrize("colours, parameters, is_open", [
        (2, {}, True), (1, {}, False), (2, {"transfer_attributes": False}, False),
    ])
    def test_twoColoursInOnePlaceAreASeam(self, colours, parameters, is_open):
        """With one vertex one of the two would be lost; else it is sewn."""
        (vertices, faces), other = load("cgal7998_unwelded_caps")
        caps = np.unique(vertices, axis=0, return_index=True)[1]
        paint = np.ones((len(vertices), 4))
        if colours == 2:
            paint[caps, :3] = (1, 0, 0)
        made = document((vertices, faces), other)
        made.add_mesh(pymeshlab.Mesh(vertices, faces, v_color_matrix=paint), "painted")
        result = run(made, first_mesh=2, **parameters)
        for block in BLOCKS:
            found = open_edges(made.mesh(result[f"{block}_layer"]).face_matrix())
            assert result[f"{block}_open_edges"] == found
            assert result[f"{block}_closed"]
        assert (result["union_open_edges"] > 0) == is_open

    @pytest.mark.parametrize("parameters, is_open", [
        ({}, False), ({"duplicate_curve_vertices": True}, True),
        ({"transfer_attributes": False}, False),
    ])
    def test_theCurveIsOpenIfItsVerticesAreDuplicated(self, parameters, is_open):
        made = document(CUBE, SECOND)
        result = run(made, **parameters)
        for block in BLOCKS:
            faces = made.mesh(result[f"{block}_layer"]).face_matrix()
            assert result[f"{block}_open_edges"] == open_edges(faces)
            assert (open_edges(faces) > 0) == is_open
            assert result[f"{block}_closed"]


def open_edges(faces):
    """Edges by index that are not there as often one way as the other."""
    directed = {}
    for face in np.asarray(faces).tolist():
        for a, b in zip(face, face[1:] + face[:1]):
            key = (min(a, b), max(a, b))
            directed[key] = directed.get(key, 0) + (1 if a < b else -1)
    return sum(count != 0 for count in directed.values())


def test_ourOwnLayerOfBlocksCountsAsClosed():
    """Its walls between blocks are doubled, in opposite directions."""
    made = document(CUBE, SECOND)
    blocks = run(made, "generate_index_boolean_split")["sub_blocks_layer"]
    far = made.mesh_number()
    made.add_mesh(pymeshlab.Mesh(*box((0.1, 0.2, 0.3), (0.4, 0.5, 0.7))), "far")
    result = run(made, "generate_index_boolean_split", first_mesh=blocks, second_mesh=far)
    assert result["sub_blocks"] > 3
    assert result["sub_blocks_in_first"].all()


def concave_prism(folder, suffix):
    """A file with an L-shaped prism; a fan from the first corner of its lid leaves the lid."""
    outline = [(3, 0), (3, 1), (1, 1), (1, 3), (0, 3), (0, 0)]
    n = len(outline)
    points = [(x, y, z) for z in (0, 2) for x, y in outline]
    polygons = [list(range(n))[::-1], [n + i for i in range(n)]]
    polygons += [[i, (i + 1) % n, n + (i + 1) % n, n + i] for i in range(n)]
    lines = [" ".join(map(str, p)) for p in points]
    if suffix == "off":
        rows = [f"{len(p)} " + " ".join(map(str, p)) for p in polygons]
        text = "\n".join(["OFF", f"{len(points)} {len(polygons)} 0", *lines, *rows]) + "\n"
    elif suffix == "obj":
        text = "".join(f"v {line}\n" for line in lines)
        text += "".join("f " + " ".join(str(i + 1) for i in p) + "\n" for p in polygons)
    else:
        header = ["ply", "format ascii 1.0", f"element vertex {len(points)}"]
        header += [f"property double {axis}" for axis in "xyz"]
        header += [f"element face {len(polygons)}", "property list uchar int vertex_indices"]
        rows = [f"{len(p)} " + " ".join(map(str, p)) for p in polygons]
        text = "\n".join([*header, "end_header", *lines, *rows]) + "\n"
    path = folder / f"prism.{suffix}"
    path.write_text(text)
    return path


def united_with_a_far_box(tmp_path, suffix):
    """The command line's union of the prism and a box."""
    far = document(box((9, 9, 9), (10, 10, 10)))
    far.save_current_mesh(str(tmp_path / "far.ply"))
    prism = concave_prism(tmp_path, suffix)
    words = ["boolean", prism, tmp_path / "far.ply", "-o", tmp_path / "out", "--only", "union"]
    return subprocess.run(
        [sys.executable, "-m", "indexboolean", *map(str, words)], capture_output=True, text=True,
        timeout=120,
    )


def test_polygonsThatTheReaderOfOffFilesTearsAreRefused(tmp_path):
    """As the hosts' page says: it joins polygons of more than four corners to wrong vertices."""
    done = united_with_a_far_box(tmp_path, "off")
    assert done.returncode == 1 and "is not closed" in done.stderr


@pytest.mark.parametrize("suffix, is_folded", [("ply", True), ("obj", False)])
def test_concavePolygonsThatWereReadAsFansAreNamed(tmp_path, suffix, is_folded):
    done = united_with_a_far_box(tmp_path, suffix)
    assert done.returncode == 0, done.stderr
    result = json.loads((tmp_path / "out" / "result.json").read_text())
    assert result["union_volume"] == pytest.approx(11)
    assert ("has 1 polygon with triangles that lie on each other" in done.stderr) == is_folded
    assert (result["self_intersecting_faces_first"] > 0) == is_folded
