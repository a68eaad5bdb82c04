# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""generate_index_boolean_split on lists of layers: closed forms, keys, attributes, refusals."""

import fractions
import hashlib
import itertools
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pymeshlab
import pytest

import indexboolean
import mesh_laws
from conftest import box, document, joined, sphere
from open_shapes import bumpy_sheet, flipped, square
from shapes import shuffled
from split_run import NUMBERS, Piece, Split
from test_filter import log_of, mirrored_document, selected_faces, set_matrix, state_of
from test_polygons import quad_box, sizes_of

REPORTS = Path(__file__).parent.parent / "reports"
CUBE = box((-1, -1, -1), (1, 1, 1))
SHEETS = [
    bumpy_sheet((0.1, 0.2, 1), 0.13, 1.7, steps=9, bump=0.05),
    bumpy_sheet((1, 0.1, 0.3), -0.2, 1.8, steps=8, bump=0.04),
    bumpy_sheet((0.2, 1, -0.1), 0.3, 1.9, steps=7, bump=0.03),
]


class ListSplit:
    """A run on a list of meshes: document, result map, and the layers of pieces."""

    def __init__(self, *meshes, **parameters):
        indexboolean.load_plugin()
        self.operands = meshes
        self.mesh_set = document(*meshes)
        self.result = self.mesh_set.generate_index_boolean_split(
            **{"layers": "all", **parameters}
        )
        self.surfaces = [self.piece(f"sub_surfaces_{k}") for k in range(len(meshes))]
        self.blocks = self.piece("sub_blocks", (*NUMBERS, "sub_block"))

    def piece(self, kind, names=NUMBERS):
        return Piece(self.mesh_set.mesh(self.result[f"{kind}_layer"]), names)

    def block(self, number):
        return self.blocks.part("sub_block", number)


def check_list(split, tolerance=1e-9):
    """What holds for every split of a list, with figures taken from the layers."""
    result, scale = split.result, sum(mesh_laws.area(*mesh) for mesh in split.operands)
    assert result["operands"] == len(split.operands)
    volumes = [mesh_laws.volume(*split.block(k)) for k in range(result["sub_blocks"])]
    assert np.allclose(volumes, result["sub_blocks_volumes"], rtol=0, atol=tolerance * scale)
    areas = [mesh_laws.area(*split.block(k)) for k in range(result["sub_blocks"])]
    assert np.allclose(areas, result["sub_blocks_areas"], rtol=0, atol=tolerance * scale)
    for k in range(result["sub_blocks"]):
        assert mesh_laws.unmatched_edges(*split.block(k)) == 0
        assert volumes[k] > 0
    for k, (piece, mesh) in enumerate(zip(split.surfaces, split.operands)):
        name = f"sub_surfaces_{k}"
        assert np.all(piece["source_mesh"] == k)
        assert np.array_equal(np.unique(piece["sub_surface"]), np.arange(result[name]))
        of_each = [
            mesh_laws.area(*piece.part("sub_surface", n)) for n in range(result[name])
        ]
        assert np.allclose(of_each, result[f"{name}_areas"], rtol=0, atol=tolerance * scale)
        assert sum(of_each) == pytest.approx(mesh_laws.area(*mesh), rel=tolerance)
        inside = result[f"sub_blocks_in_{k}"]
        if mesh_laws.unmatched_edges(*mesh) == 0:
            assert np.dot(inside, volumes) == pytest.approx(mesh_laws.volume(*mesh), rel=tolerance)
        else:
            assert not inside.any()


# --- five sheets in a block, against exact volumes ----------------------------------------------


def plane_through(triangle):
    """(n, c) with n * p = c, exactly."""
    a, b, c = [[fractions.Fraction(float(x)) for x in corner] for corner in triangle]
    u, v = [q - p for p, q in zip(a, b)], [q - p for p, q in zip(a, c)]
    normal = [u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3] for k in range(3)]
    return normal, sum(n * p for n, p in zip(normal, a))


def halves(solid, plane):
    """The two parts of a convex solid, a list of faces, each a list of exact corners; or None."""
    normal, level = plane

    def height(p):
        return sum(n * x for n, x in zip(normal, p)) - level

    parts = []
    for sign in (1, -1):
        faces, cap = [], {}
        for face in solid:
            part, ends = [], []
            for p, q in zip(face, face[1:] + face[:1]):
                hp, hq = sign * height(p), sign * height(q)
                assert hp != 0, "the planes are to miss all corners"
                if hp > 0:
                    part.append(p)
                if (hp > 0) != (hq > 0):
                    t = hp / (hp - hq)
                    part.append(tuple(x + t * (y - x) for x, y in zip(p, q)))
                    ends.append((hp > 0, part[-1]))
            if part:
                faces.append(part)
            if ends:
                leaving, entering = sorted(ends, key=lambda end: not end[0])
                cap[entering[1]] = leaving[1]  # the cap runs against the faces
        if cap:
            start = next(iter(cap))
            polygon = [start]
            while cap[polygon[-1]] != start:
                polygon.append(cap[polygon[-1]])
            faces.append(polygon)
        parts.append(faces or None)
    return [part for part in parts if part]


def exact_volume(solid):
    six = fractions.Fraction(0)
    for face in solid:
        for (ax, ay, az), (bx, by, bz) in zip(face[1:], face[2:]):
            ox, oy, oz = face[0]
            six += ox * (ay * bz - az * by) + oy * (az * bx - ax * bz) + oz * (ax * by - ay * bx)
    return six / 6


def box_faces(low, high):
    """The six faces of a box, seen from outside counter-clockwise."""
    low, high = [[fractions.Fraction(x) for x in corner] for corner in (low, high)]
    faces = []
    for axis, end in itertools.product(range(3), (0, 1)):
        face = []
        for u, v in ((0, 0), (1, 0), (1, 1), (0, 1)):
            corner = [None] * 3
            corner[axis] = (low, high)[end][axis]
            corner[(axis + 1) % 3] = (low, high)[u][(axis + 1) % 3]
            corner[(axis + 2) % 3] = (low, high)[v][(axis + 2) % 3]
            face.append(tuple(corner))
        faces.append(face if end else face[::-1])
    return faces


def wide_triangle(normal, point):
    """A triangle of integer corners in a plane, far beyond the block around its centre."""
    normal = np.array(normal)
    u = np.cross(normal, np.eye(3, dtype=int)[np.argmin(np.abs(normal))])
    v = np.cross(normal, u)
    long_u = u * int(np.ceil(np.sqrt(normal @ normal)))
    corners = point + np.array([-60 * long_u - 40 * v, 60 * long_u - 40 * v, 80 * v])
    return corners.astype(float), np.array([[0, 1, 2]])


@pytest.mark.parametrize("seed", range(20))
def test_fiveSheetsCutABlockIntoCellsOfExactVolumes(seed):
    rng = np.random.default_rng(seed)
    sheets = []
    while len(sheets) < 5:
        normal = rng.integers(-4, 5, 3)
        if np.any(normal):
            sheets.append(wide_triangle(normal, rng.integers(-3 << 20, 3 << 20, 3) / 2**20))
    cells = [box_faces((-5, -5, -5), (5, 5, 5))]
    for vertices, _ in sheets:
        cells = [part for cell in cells for part in halves(cell, plane_through(vertices))]
    split = ListSplit(box((-5, -5, -5), (5, 5, 5)), *sheets)
    check_list(split)
    inside = split.result["sub_blocks_in_0"] == 1
    found = np.sort(split.result["sub_blocks_volumes"][inside])
    expected = np.sort([float(exact_volume(cell)) for cell in cells])
    assert len(cells) > 6
    assert found == pytest.approx(expected, rel=1e-11)
    assert np.all(split.result["sub_blocks_self_intersections"] == 0)
    for k in range(1, 6):
        assert not split.result[f"sub_blocks_in_{k}"].any()


def test_twoFaultsInOneLayerCutABlockIntoFour():
    arrays = np.load(REPORTS / "gempy495_block_and_two_crossing_faults_in_one_layer.npz")
    pair = [(arrays["V" + k], arrays["F" + k].astype(np.int32)) for k in "AB"]
    expected = Split(*pair)
    split = ListSplit(*pair)
    check_list(split)
    assert split.result["sub_blocks"] == expected.result["sub_blocks"] == 4
    assert split.result["sub_blocks_volumes"].sum() == pytest.approx(8, rel=1e-12)
    horizon = square(-9, 9, 0.25)
    both = ListSplit(*pair, horizon)
    check_list(both)
    low, high = pair[0][0].min(axis=0)[2], pair[0][0].max(axis=0)[2]
    assert low < 0.25 < high
    assert both.result["sub_blocks"] > 4
    assert both.result["sub_blocks_volumes"].sum() == pytest.approx(8, rel=1e-12)


# --- the list against the pair ------------------------------------------------------------------


@pytest.mark.parametrize(
    "pair",
    [
        (CUBE, SHEETS[0]),
        (CUBE, box((-0.5, 0.25, 0.1), (1.5, 1.75, 2))),
        (joined(CUBE, box((0, 0, 0), (2, 2, 2))), SHEETS[0]),
        (SHEETS[0], SHEETS[1]),
    ],
    ids=("sheet", "box", "meets itself", "open"),
)
def test_aListOfTwoGivesWhatTheFirstAndTheSecondGive(pair):
    one, other = Split(*pair), ListSplit(*pair)
    for a, b in zip((*one.surfaces, one.blocks), (*other.surfaces, other.blocks)):
        assert np.array_equal(a.vertices, b.vertices) and np.array_equal(a.faces, b.faces)
        assert all(np.array_equal(a[name], b[name]) for name in a.numbers)
    labels = [[mesh.label() for mesh in split.mesh_set][2:] for split in (one, other)]
    assert labels[0] == labels[1] == ["A cut by B", "B cut by A", "A blocks B"]

    def renamed(key):
        for word, number in (("first", "0"), ("second", "1")):
            key = key.replace(f"_{word}", f"_{number}")
        return key

    for key, value in one.result.items():
        if not key.startswith("seconds_"):
            assert np.array_equal(value, other.result[renamed(key)]), key
    more = set(other.result) - {renamed(key) for key in one.result}
    assert more == {"operands", "operand_layers"}


def test_operandsInOtherOrderGiveTheSamePieces():
    meshes = [CUBE, *SHEETS, sphere((0.4, 0.3, 0.2), 0.9)]
    rng = np.random.default_rng(4)
    one = ListSplit(*meshes)
    check_list(one)
    for _ in range(3):
        order = rng.permutation(len(meshes))
        other = ListSplit(*(shuffled(*meshes[k], rng) for k in order))
        assert other.result["sub_blocks"] == one.result["sub_blocks"]
        for number in range(one.result["sub_blocks"]):
            expected = mesh_laws.triangle_set(*one.block(number))
            assert np.array_equal(mesh_laws.triangle_set(*other.block(number)), expected)
        for place, k in enumerate(order):
            found = other.result[f"sub_blocks_in_{place}"]
            assert np.array_equal(found, one.result[f"sub_blocks_in_{k}"])
            for number in range(one.result[f"sub_surfaces_{k}"]):
                expected = mesh_laws.triangle_set(*one.surfaces[k].part("sub_surface", number))
                part = other.surfaces[place].part("sub_surface", number)
                assert np.array_equal(mesh_laws.triangle_set(*part), expected)


def digest_of_run():
    """Of all bytes of the layers of a run with five operands."""
    split = ListSplit(sphere(subdivisions=3), *SHEETS, sphere((0.4, 0.3, 0.2), 0.9, 3))
    found = hashlib.sha256()
    for piece in (*split.surfaces, split.blocks):
        for array in (piece.vertices, piece.faces, *piece.numbers.values()):
            found.update(array.tobytes())
    return found.hexdigest()


def test_sameBytesForAnyNumberOfThreads():
    digests = [
        subprocess.run(
            [sys.executable, __file__], check=True, capture_output=True, text=True,
            env={**os.environ, "OMP_NUM_THREADS": str(threads)},
        ).stdout.split()[-1]
        for threads in (1, 2, 5)
    ]
    assert len(set(digests)) == 1


# --- which layers -------------------------------------------------------------------------------


class TestWhichLayers:
    def run(self, mesh_set, layers, **parameters):
        result = mesh_set.generate_index_boolean_split(layers=layers, **parameters)
        return result["operand_layers"].astype(int).tolist()

    def test_idsLabelsAndWords(self):
        for layers, ids in (
            ("all", [0, 1, 2]), ("visible", [0, 1, 2]), ("2, 0,1", [2, 0, 1]),
            ('"C",0,"B"', [2, 0, 1]), (" 1 ", [1]), ("0,2", [0, 2]),
        ):
            assert self.run(document(CUBE, *SHEETS[:2]), layers) == ids, layers

    def test_visibleLeavesOutHiddenLayersAndBothWordsResults(self):
        mesh_set = document(CUBE, *SHEETS)
        mesh_set.set_current_mesh(2)
        mesh_set.set_current_mesh_visibility(False)
        assert self.run(mesh_set, "visible") == [0, 1, 3]
        assert self.run(mesh_set, "visible") == [0, 1, 3]
        assert self.run(mesh_set, "all") == [0, 1, 2, 3]

    def test_withoutAListFirstAndSecondAreTaken(self):
        mesh_set = document(CUBE, *SHEETS)
        result = mesh_set.generate_index_boolean_split(first_mesh=0, second_mesh=3, layers=" ")
        assert "operands" not in result
        assert result["sub_surfaces_first"] == 2

    def test_oneLayerIsCutByItself(self):
        mesh_set = document(joined(box((0, 0, 0), (2, 2, 2)), box((1, 1, 1), (3, 3, 3))))
        result = mesh_set.generate_index_boolean_split(layers="0")
        assert np.sort(result["sub_blocks_volumes"]) == pytest.approx([1, 7, 7])
        assert [mesh.label() for mesh in mesh_set][1:] == ["A cut by itself", "A blocks"]

    @pytest.mark.parametrize(
        "layers, reason",
        [("0,7", "there is no layer with id 7"), ("0,0", "named twice"), ("0,", "id is expected"),
         ('0,"Z"', 'no layer with the label "Z"'), ("some", "id is expected")],
    )
    def test_aListThatNamesNoLayersIsRefused(self, layers, reason):
        mesh_set = document(CUBE, *SHEETS)
        before = state_of(mesh_set)
        with pytest.raises(pymeshlab.PyMeshLabException, match=reason):
            mesh_set.generate_index_boolean_split(layers=layers)
        assert state_of(mesh_set) == before

    def test_operandsAreHiddenIfAsked(self):
        mesh_set = document(CUBE, *SHEETS)
        mesh_set.generate_index_boolean_split(layers="0,2", hide_operands=True)
        assert [mesh.is_visible() for mesh in mesh_set][:4] == [False, True, False, True]


# --- switches, keys, labels ---------------------------------------------------------------------


class TestSwitches:
    def test_keysAndTypes(self):
        result = ListSplit(CUBE, *SHEETS[:2]).result
        expected = {"operands": int, "operand_layers": np.ndarray, "labelled_by_cells": bool,
                    "welded_vertices": int, "largest_weld": float, "merged_vertices": int,
                    "largest_merge": float,
                    "sub_blocks": int, "sub_blocks_layer": int, "sub_blocks_layers": np.ndarray,
                    "sub_blocks_areas": np.ndarray, "sub_blocks_volumes": np.ndarray,
                    "sub_blocks_self_intersections": np.ndarray, "sub_blocks_closed": bool,
                    "volume_law_residual": float, "zero_area_faces_removed": int,
                    "loops_open": int, "loops_hard_closed": int, "loops_soft_closed": int}
        for k in range(3):
            name = f"sub_surfaces_{k}"
            expected.update({name: int, f"{name}_layer": int, f"{name}_layers": np.ndarray})
            for what in ("areas", "public", "one_sided", "boundary_cycles", "separating",
                         "self_intersections"):
                expected[f"{name}_{what}"] = np.ndarray
            expected[f"sub_blocks_in_{k}"] = np.ndarray
            expected[f"self_intersecting_faces_{k}"] = int
        found = {k: type(v) for k, v in result.items() if not k.startswith("seconds_")}
        assert found == expected

    def test_layersComeInTheOrderOfTheList(self):
        mesh_set = document(CUBE, *SHEETS)
        result = mesh_set.generate_index_boolean_split(layers="2,0,1")
        labels = ["C cut by 2 others", "A cut by 2 others", "B cut by 2 others",
                  "blocks of C and 2 others"]
        assert [mesh.label() for mesh in mesh_set][4:] == labels
        assert [result[f"sub_surfaces_{k}_layer"] for k in range(3)] == [4, 5, 6]
        assert result["sub_blocks_layer"] == 7

    def test_subSurfacesAndSubBlocksAreSwitches(self):
        for surfaces, blocks in ((True, False), (False, True)):
            mesh_set = document(CUBE, *SHEETS)
            result = mesh_set.generate_index_boolean_split(
                layers="all", sub_surfaces=surfaces, sub_blocks=blocks
            )
            assert mesh_set.mesh_number() == 4 + 4 * surfaces + blocks
            assert ("sub_blocks_layer" in result) == blocks
            assert ("sub_surfaces_2_layer" in result) == surfaces
            assert result["sub_surfaces_0"] == 8 and result["sub_blocks"] == 8

    def test_theSwitchesOfThePairAreNotReadForAList(self):
        mesh_set = document(CUBE, *SHEETS)
        mesh_set.generate_index_boolean_split(
            layers="all", sub_surfaces_first=False, sub_surfaces_second=False
        )
        assert mesh_set.mesh_number() == 9
        with pytest.raises(pymeshlab.PyMeshLabException, match="sub_surfaces, sub_blocks, first_"):
            mesh_set.generate_index_boolean_split(
                layers="0,1,2", sub_surfaces=False, sub_blocks=False
            )

    def test_separateLayersHoldOnePieceEach(self):
        mesh_set = document(CUBE, *SHEETS[:2])
        result = mesh_set.generate_index_boolean_split(layers="all", separate_layers=True)
        count = sum(result[f"sub_surfaces_{k}"] for k in range(3)) + result["sub_blocks"]
        assert mesh_set.mesh_number() == 3 + count
        for number, layer in enumerate(result["sub_blocks_layers"]):
            volume = mesh_laws.volume(
                mesh_set.mesh(int(layer)).vertex_matrix(), mesh_set.mesh(int(layer)).face_matrix()
            )
            assert volume == pytest.approx(result["sub_blocks_volumes"][number])

    def test_theLogSaysWhichNumberEachLayerHas(self):
        log = log_of("document(FIRST, SECOND)", "generate_index_boolean_split", 'layers="1,0"')
        assert 'by their numbers in source_mesh: 0 is "B" (id 1), 1 is "A" (id 0).' in log

    def test_anyLayerOfTheListIsNamedWhereItIsRefused(self):
        crossing = joined(SHEETS[0], SHEETS[1])
        mesh_set = document(CUBE, SHEETS[2], crossing)
        with pytest.raises(pymeshlab.PyMeshLabException, match=r'Layer "C" \(id 2\) intersects'):
            mesh_set.generate_index_boolean_split(layers="all", self_intersections="refuse")
        assert selected_faces(mesh_set, 2) and not selected_faces(mesh_set, 0)

    def test_aLayerThatMeetsItselfIsCountedByItsNumber(self):
        split = ListSplit(CUBE, SHEETS[2], joined(SHEETS[0], SHEETS[1]))
        check_list(split)
        assert split.result["self_intersecting_faces_0"] == 0
        assert split.result["self_intersecting_faces_2"] > 0
        assert split.result["sub_blocks_in_0"].sum() == 8

    def test_theWindingRuleSaysWhatIsInside(self):
        twice = joined(box((0, 0, 0), (2, 2, 2)), box((1, 1, 1), (3, 3, 3)))
        for rule, inside in (("nonzero", [1, 1, 1]), ("positive", [1, 1, 1]), ("odd", [0, 1, 1])):
            result = ListSplit(twice, square(9, 10), square(9, 10, 1), winding_rule=rule).result
            order = np.argsort(result["sub_blocks_volumes"])
            assert result["sub_blocks_in_0"][order].tolist() == inside

    def test_certifyAndItsScalar(self):
        off = ListSplit(CUBE, *SHEETS, certify=False)
        assert np.all(off.result["sub_surfaces_1_self_intersections"] == -1)
        assert np.all(off.result["sub_blocks_self_intersections"] == -1)
        single = ListSplit(CUBE, *SHEETS, certify_as="float")
        assert np.all(single.result["sub_blocks_self_intersections"] == 0)
        stored = single.blocks.vertices
        assert np.array_equal(stored, stored.astype(np.float32).astype(float))


# --- matrices, flips ----------------------------------------------------------------------------


def test_matricesMirroredOnesTooAreApplied():
    mirror = np.diag((1.0, 1, -1, 1))
    mesh_set = document(CUBE, *SHEETS)
    for layer in range(4):
        set_matrix(mesh_set, layer, mirror)
    result = mesh_set.generate_index_boolean_split(layers="all")
    expected = ListSplit(CUBE, *SHEETS).result
    for key in ("sub_blocks_volumes", "sub_surfaces_2_areas"):
        assert np.sort(result[key]) == pytest.approx(np.sort(expected[key]), rel=1e-13)
    assert result["sub_blocks_in_0"].sum() == expected["sub_blocks_in_0"].sum() == 8
    boxes = mirrored_document()
    union = boxes.generate_index_boolean()["union_volume"]
    boxes.add_mesh(pymeshlab.Mesh(*square(20, 21)), "far")
    result = boxes.generate_index_boolean_split(layers=f"0,1,{boxes.current_mesh_id()}")
    assert result["sub_blocks_volumes"].sum() == pytest.approx(union, rel=1e-14)


def test_flippedSheetsGiveTheSameBlocks():
    one = ListSplit(CUBE, *SHEETS)
    other = ListSplit(CUBE, *(flipped(*sheet) for sheet in SHEETS))
    for number in range(one.result["sub_blocks"]):
        expected = mesh_laws.triangle_set(*one.block(number))
        assert np.array_equal(mesh_laws.triangle_set(*other.block(number)), expected)


# --- attributes ---------------------------------------------------------------------------------


def test_facesOfEachLayerKeepTheirColoursAndFaceNumbers():
    meshes = [CUBE, *SHEETS]
    mesh_set = pymeshlab.MeshSet()
    colours = np.random.default_rng(2).integers(0, 256, (4, 400, 3)) / 255
    for k, (vertices, faces) in enumerate(meshes):
        mesh_set.add_mesh(
            pymeshlab.Mesh(
                vertices, faces,
                f_color_matrix=np.column_stack([colours[k, : len(faces)], np.ones(len(faces))]),
            ),
            "ABCD"[k],
        )
    result = mesh_set.generate_index_boolean_split(layers="all")
    for kind in ("sub_surfaces_0", "sub_surfaces_3", "sub_blocks"):
        mesh = mesh_set.mesh(result[f"{kind}_layer"])
        source = [
            mesh.face_custom_scalar_attribute_array(name).astype(int)
            for name in ("source_mesh", "source_face")
        ]
        expected = colours[source[0], source[1]]
        assert np.abs(mesh.face_color_matrix()[:, :3] - expected).max() < 1 / 255
    assert set(source[0]) == {0, 1, 2, 3}


def test_quadsStayQuadsBesideOtherLayers():
    wall = np.array([(0.5, -2, -2), (0.5, 2, -2), (0.5, 2, 2), (0.5, -2, 2)]), [[0, 1, 2, 3]]
    far = quad_box((8, 8, 8), (9, 9, 9))
    mesh_set = document(quad_box((0, -1, -1), (1, 1, 1)), wall)
    two = mesh_set.generate_index_boolean_split()
    mesh_set.add_mesh(pymeshlab.Mesh(far[0], face_list_of_indices=far[1]), "far")
    three = mesh_set.generate_index_boolean_split(layers=f"0,1,{mesh_set.current_mesh_id()}")
    for pair, many in (("sub_surfaces_first", "sub_surfaces_0"),
                       ("sub_surfaces_second", "sub_surfaces_1")):
        sizes = [sizes_of(mesh_set.mesh(result[f"{kind}_layer"]))
                 for result, kind in ((two, pair), (three, many))]
        assert sizes[0] == sizes[1]
        assert max(sizes[0]) > 3
    assert sizes_of(mesh_set.mesh(three["sub_surfaces_2_layer"])) == {4: 6}


if __name__ == "__main__":
    print(digest_of_run())
