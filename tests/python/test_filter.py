# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The filter as pymeshlab users meet it: layers, labels, results, refusals, selection."""

import os
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pymeshlab
import pytest

import mesh_laws
import oracles
import shapes
from conftest import box, crossing_bars, document, joined, sphere
from plain_solids import one_sided

BLOCKS = ("union", "intersection", "first_minus_second", "second_minus_first")
ALL_BLOCKS = (*BLOCKS, "symmetric_difference")
LABELS = ("A union B", "A intersection B", "A minus B", "B minus A", "A xor B")
STAGES = (
    "near_vertices",
    "operands",
    "self_intersections",
    "coincident_faces",
    "octree_pairs",
    "triangle_contact",
    "curve_points",
    "cut_lines",
    "retriangulate",
    "repair_places",
    "loops",
    "labels",
    "overlap_owners",
    "rounding_loop",
    "blocks",
    "manifold_copies",
    "merge_fragments",
    "delaunay_pieces",
    "clean",
    "certificates",
    "kept_cuts",
    "polygons",
    "audit",
    "attributes",
)

# Boxes of volume 8 and 3.375 that share a box of volume 0.65625, in general position.
FIRST = box((0, 0, 0), (2, 2, 2))
SECOND = box((1, 1.125, 1.25), (2.5, 2.625, 2.75))
VOLUMES = {
    "union": 10.71875,
    "intersection": 0.65625,
    "first_minus_second": 7.34375,
    "second_minus_first": 2.71875,
    "symmetric_difference": 10.0625,
}
FAR_AWAY = box((10, 10, 10), (11, 11, 11))
WITHIN_FIRST = box((0.25, 0.375, 0.5), (0.75, 0.875, 1))


def only(*blocks):
    """Parameters that request these blocks and no others."""
    return {block: block in blocks for block in ALL_BLOCKS}


def ids_of(mesh_set):
    return [mesh.id() for mesh in mesh_set]


def arrays_of(mesh):
    return np.array(mesh.vertex_matrix()), np.array(mesh.face_matrix())


def select(mesh_set, layer, condition):
    current = mesh_set.current_mesh_id()
    mesh_set.set_current_mesh(layer)
    mesh_set.compute_selection_by_condition_per_face(condselect=condition)
    mesh_set.set_current_mesh(current)


def selected_faces(mesh_set, layer):
    return np.flatnonzero(mesh_set.mesh(layer).face_selection_array()).tolist()


def state_of(mesh_set, but_selection_of=()):
    """All that a refused run must leave as it was."""
    state = {"current": mesh_set.current_mesh_id(), "ids": ids_of(mesh_set)}
    for mesh in mesh_set:
        selection = None
        if mesh.id() not in but_selection_of:
            selection = (
                mesh.face_selection_array().tobytes(),
                mesh.vertex_selection_array().tobytes(),
            )
        state[mesh.id()] = (
            mesh.label(),
            mesh.is_visible(),
            mesh.vertex_matrix().tobytes(),
            mesh.face_matrix().tobytes(),
            mesh.transform_matrix().tobytes(),
            mesh.vertex_normal_matrix().tobytes(),
            selection,
        )
    return state


def refused(mesh_set, named=(), **parameters):
    """Runs the filter, which must refuse and leave the document as it was but for the selection of
    the named layers. Returns the message."""
    before = state_of(mesh_set, but_selection_of=named)
    parameters = {"first_mesh": 0, "second_mesh": 1, **parameters}
    with pytest.raises(pymeshlab.PyMeshLabException) as refusal:
        mesh_set.generate_index_boolean(**parameters)
    assert state_of(mesh_set, but_selection_of=named) == before
    message = str(refusal.value)
    for layer in named:
        assert f'"{mesh_set.mesh(layer).label()}" (id {layer})' in message
    return message


def without_faces(mesh, *faces):
    return mesh[0], np.delete(mesh[1], faces, axis=0)


def turned_faces(mesh, *faces):
    turned = mesh[1].copy()
    turned[list(faces)] = turned[list(faces)][:, ::-1]
    return mesh[0], turned


def translation(x, y, z):
    matrix = np.eye(4)
    matrix[:3, 3] = (x, y, z)
    return matrix


# Exact, and leaves FIRST and SECOND in general position.
SHIFT = translation(0.0625, 0.03125, -0.015625)


def set_matrix(mesh_set, layer, matrix):
    current = mesh_set.current_mesh_id()
    mesh_set.set_current_mesh(layer)
    mesh_set.set_matrix(transformmatrix=matrix, freeze=False)
    mesh_set.set_current_mesh(current)


def log_of(make_document, filter_name="generate_index_boolean", parameters=""):
    """What a verbose run of the filter prints, on what the expression `make_document` makes.

    In a process of its own: once a filter has refused, pymeshlab prints nothing any more.
    """
    program = f"""
import indexboolean
from test_filter import *
indexboolean.load_plugin()
mesh_set = {make_document}
mesh_set.set_verbosity(True)
mesh_set.{filter_name}({parameters})
"""
    run = subprocess.run(
        [sys.executable, "-c", program],
        cwd=Path(__file__).parent,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, sys.path))},
        capture_output=True,
        text=True,
        check=True,
    )
    return run.stdout + run.stderr


def mirrored_document():
    """B mirrored by its matrix, in general position with A."""
    mesh_set = document(FIRST, SECOND)
    set_matrix(mesh_set, 1, np.diag((-1.0, 1, 1, 1)))
    set_matrix(mesh_set, 0, translation(-2.0625, 0, 0))
    return mesh_set


class TestLayers:
    def test_newLayersComeInOrderWithLabelsOfTheInputs(self):
        mesh_set = document(FIRST, SECOND)
        result = mesh_set.generate_index_boolean(symmetric_difference=True)
        assert [result[f"{block}_layer"] for block in ALL_BLOCKS] == [2, 3, 4, 5, 6]
        assert ids_of(mesh_set) == list(range(7))
        assert [mesh_set.mesh(layer).label() for layer in range(2, 7)] == list(LABELS)

    def test_theFirstNewLayerBecomesCurrent(self):
        mesh_set = document(FIRST, SECOND)
        mesh_set.generate_index_boolean()
        assert mesh_set.current_mesh_id() == 2

    def test_fourBlocksAreTheDefault(self):
        result = document(FIRST, SECOND).generate_index_boolean()
        assert [block for block in ALL_BLOCKS if f"{block}_layer" in result] == list(BLOCKS)

    def test_theFirstTwoLayersAreTheDefaultOperands(self):
        mesh_set = document(FIRST, SECOND, FAR_AWAY)
        mesh_set.generate_index_boolean(**only("first_minus_second"))
        assert mesh_set.current_mesh().label() == "A minus B"

    @pytest.mark.parametrize("block", ALL_BLOCKS)
    def test_aBlockAloneIsTheSameAsAmongOthers(self, block):
        together, alone = document(FIRST, SECOND), document(FIRST, SECOND)
        everything = together.generate_index_boolean(symmetric_difference=True)
        result = alone.generate_index_boolean(**only(block))
        assert alone.mesh_number() == 3
        assert {key for key in result if key.endswith("_layer")} == {f"{block}_layer"}
        expected = arrays_of(together.mesh(everything[f"{block}_layer"]))
        found = arrays_of(alone.mesh(result[f"{block}_layer"]))
        assert np.array_equal(expected[0], found[0]) and np.array_equal(expected[1], found[1])

    def test_blocksHaveTheirVolumesAndAreClosed(self):
        mesh_set = document(FIRST, SECOND)
        result = mesh_set.generate_index_boolean(symmetric_difference=True)
        for block, volume in VOLUMES.items():
            vertices, faces = arrays_of(mesh_set.mesh(result[f"{block}_layer"]))
            assert mesh_laws.unmatched_edges(vertices, faces) == 0
            assert mesh_laws.volume(vertices, faces) == pytest.approx(volume, rel=1e-14)
            assert result[f"{block}_volume"] == pytest.approx(volume, rel=1e-14)
            assert result[f"{block}_faces"] == len(faces)
            assert result[f"{block}_closed"] is True
            assert result[f"{block}_area"] == pytest.approx(mesh_laws.area(vertices, faces))
        components = [result[f"{block}_components"] for block in BLOCKS]
        assert components == [1, 1, 1, 1]

    def test_inputLayersAreNotChanged(self):
        mesh_set = document(FIRST, SECOND)
        select(mesh_set, 0, "fi < 3")
        set_matrix(mesh_set, 1, SHIFT)
        before = state_of(mesh_set)
        mesh_set.generate_index_boolean()
        after = state_of(mesh_set)
        assert after[0] == before[0] and after[1] == before[1]

    def test_newLayersAreVisibleUnselectedAndHaveTheIdentityMatrix(self):
        mesh_set = document(FIRST, SECOND)
        set_matrix(mesh_set, 1, SHIFT)
        mesh_set.generate_index_boolean()
        for layer in range(2, 6):
            mesh = mesh_set.mesh(layer)
            assert mesh.is_visible()
            assert np.array_equal(mesh.transform_matrix(), np.eye(4))
            assert mesh.selected_face_number() == mesh.selected_vertex_number() == 0

    def test_newLayersHaveUnitNormalsAndABox(self):
        mesh_set = document(sphere(), sphere((0.5, 0.3, 0.2)))
        result = mesh_set.generate_index_boolean(transfer_attributes=False)
        for block in BLOCKS:
            mesh = mesh_set.mesh(result[f"{block}_layer"])
            vertices, faces = arrays_of(mesh)
            a, b, c = (vertices[faces[:, corner]] for corner in range(3))
            cross = np.cross(b - a, c - a)
            length = np.linalg.norm(cross, axis=1)
            large = length > 1e-6
            expected = cross[large] / length[large][:, None]
            assert np.allclose(mesh.face_normal_matrix()[large], expected, atol=1e-9)
            lengths = np.linalg.norm(mesh.vertex_normal_matrix(), axis=1)
            assert np.allclose(lengths, 1, atol=1e-12)
            assert np.array_equal(mesh.bounding_box().min(), vertices.min(axis=0))
            assert np.array_equal(mesh.bounding_box().max(), vertices.max(axis=0))
        union = mesh_set.mesh(result["union_layer"])
        centre = np.array((0.25, 0.15, 0.1))
        outward = union.vertex_normal_matrix() * (union.vertex_matrix() - centre)
        assert np.all(outward.sum(axis=1) > 0)

    def test_anEmptyBlockIsAnEmptyLayer(self):
        mesh_set = document(FIRST, FAR_AWAY)
        result = mesh_set.generate_index_boolean()
        layer = mesh_set.mesh(result["intersection_layer"])
        assert (layer.label(), layer.vertex_number(), layer.face_number()) == (LABELS[1], 0, 0)
        assert result["intersection_faces"] == result["intersection_components"] == 0
        assert result["intersection_volume"] == result["intersection_area"] == 0
        assert result["intersection_closed"] is True
        assert result["union_components"] == 2
        assert mesh_set.mesh_number() == 6

    def test_aSolidWithinAnotherLeavesACavity(self):
        mesh_set = document(FIRST, WITHIN_FIRST)
        result = mesh_set.generate_index_boolean()
        assert result["second_minus_first_faces"] == 0
        assert result["first_minus_second_volume"] == pytest.approx(8 - 0.125, rel=1e-15)
        assert result["first_minus_second_components"] == 2
        assert result["union_faces"] == result["intersection_faces"] == 12

    def test_aResultIsAnInputOfTheNextRun(self):
        mesh_set = document(FIRST, SECOND, sphere((2, 2, 2.1), 0.7))
        first = mesh_set.generate_index_boolean(**only("union"))
        result = mesh_set.generate_index_boolean(
            first_mesh=first["union_layer"], second_mesh=2, **only("first_minus_second")
        )
        assert mesh_set.current_mesh().label() == "A union B minus C"
        assert 0 < result["first_minus_second_volume"] < VOLUMES["union"]

    def test_twoRunsGiveTheSameBytes(self):
        runs = []
        for _ in range(2):
            mesh_set = document(sphere(), sphere((0.5, 0.3, 0.2), subdivisions=4))
            mesh_set.generate_index_boolean(symmetric_difference=True)
            runs.append([a.tobytes() for mesh in mesh_set for a in arrays_of(mesh)])
        assert runs[0] == runs[1]


class TestResultMap:
    def test_keysAndTypesAreThoseOfTheContract(self):
        result = document(FIRST, SECOND).generate_index_boolean(symmetric_difference=True)
        expected = {
            "volume_law_residual": float,
            "self_intersecting_faces_first": int,
            "self_intersecting_faces_second": int,
            "labelled_by_cells": bool,
            "welded_vertices": int,
            "largest_weld": float,
            "loops_open": int,
            "loops_hard_closed": int,
            "loops_soft_closed": int,
            "zero_area_faces_removed": int,
        }
        for block in ALL_BLOCKS:
            types = {
                "layer": int,
                "volume": float,
                "area": float,
                "faces": int,
                "components": int,
                "closed": bool,
                "open_edges": int,
                "merged_vertices": int,
                "self_intersections": int,
                "repair_rounds": int,
                "moved_vertices": int,
                "largest_move": float,
                "volume_change": float,
                "vanished_components": int,
            }
            expected.update({f"{block}_{name}": kind for name, kind in types.items()})
        for name in ("read_layers", "write_layers", "core", "total", *STAGES):
            expected[f"seconds_{name}"] = float
        assert {key: type(value) for key, value in result.items()} == expected

    def test_onlyRequestedBlocksHaveKeys(self):
        result = document(FIRST, SECOND).generate_index_boolean(**only("union"))
        for block in ALL_BLOCKS[1:]:
            assert not [key for key in result if key.startswith(block)]

    def test_secondsOfTheStagesAddUpToTheCore(self):
        pair = sphere(subdivisions=5), sphere((0.5, 0.3, 0.2), subdivisions=5)
        result = document(*pair).generate_index_boolean()
        stages = sum(result[f"seconds_{stage}"] for stage in STAGES)
        assert 0.5 * result["seconds_core"] < stages <= result["seconds_core"]
        parts = sum(result[f"seconds_{part}"] for part in ("read_layers", "core", "write_layers"))
        assert 0.5 * result["seconds_total"] < parts <= result["seconds_total"]

    def test_lawsHoldAndLoopsAreCounted(self):
        result = document(FIRST, SECOND).generate_index_boolean()
        assert 0 <= result["volume_law_residual"] < 1e-15
        loops = [result[f"loops_{kind}"] for kind in ("open", "hard_closed", "soft_closed")]
        assert loops == [0, 1, 0]


class TestCoordinates:
    def test_theMatrixIsAppliedAsIfTheVerticesHadBeenMoved(self):
        by_matrix, moved = (
            document(FIRST, SECOND),
            document(FIRST, (SECOND[0] + SHIFT[:3, 3], SECOND[1])),
        )
        set_matrix(by_matrix, 1, SHIFT)
        by_matrix.generate_index_boolean()
        moved.generate_index_boolean()
        for layer in range(2, 6):
            expected, found = arrays_of(moved.mesh(layer)), arrays_of(by_matrix.mesh(layer))
            assert np.array_equal(expected[0], found[0]) and np.array_equal(expected[1], found[1])

    def test_uncutVerticesAreTheHostsOwnProductBitByBit(self):
        vertices, faces = sphere(subdivisions=4)
        matrix = translation(0.3, 0.1, 0.2)
        matrix[:3, :3] = np.array([(0.36, 0.48, -0.8), (-0.8, 0.6, 0), (0.48, 0.64, 0.6)]) * 1.1
        mesh_set = document(sphere(subdivisions=4), (vertices, faces))
        set_matrix(mesh_set, 1, matrix)
        x, y, z = vertices.T
        product = np.stack([r[0] * x + r[1] * y + r[2] * z + r[3] for r in matrix[:3]], axis=1)
        result = mesh_set.generate_index_boolean(**only("union", "intersection"))
        found = set()
        for block in ("union", "intersection"):
            layer = mesh_set.mesh(result[f"{block}_layer"])
            found |= set(map(tuple, layer.vertex_matrix().tolist()))
        missing = [p for p in map(tuple, product.tolist()) if p not in found]
        assert not missing

    def test_aMirroredLayerIsTurned(self):
        result = mirrored_document().generate_index_boolean()
        assert result["second_minus_first_volume"] + result["intersection_volume"] == pytest.approx(
            3.375, rel=1e-15
        )
        assert result["intersection_volume"] > 0

    def test_anInsideOutLayerIsTurned(self):
        mesh_set = document((FIRST[0], FIRST[1][:, ::-1]), SECOND)
        result = mesh_set.generate_index_boolean(symmetric_difference=True)
        for block, volume in VOLUMES.items():
            assert result[f"{block}_volume"] == pytest.approx(volume, rel=1e-14)

    def test_swappedOperandsGiveTheSameSolids(self):
        result = document(FIRST, SECOND).generate_index_boolean(first_mesh=1, second_mesh=0)
        assert result["union_volume"] == pytest.approx(VOLUMES["union"], rel=1e-14)
        assert result["first_minus_second_volume"] == pytest.approx(2.71875, rel=1e-14)

    def test_equalCornersOfASoupAreOneVertex(self):
        vertices, faces = FIRST
        soup = vertices[faces].reshape(-1, 3), np.arange(36).reshape(12, 3)
        mesh_set = document(soup, SECOND)
        result = mesh_set.generate_index_boolean()
        assert result["union_volume"] == pytest.approx(VOLUMES["union"], rel=1e-14)
        union = mesh_set.mesh(result["union_layer"])
        assert len(np.unique(union.vertex_matrix(), axis=0)) == union.vertex_number()


class TestLog:
    def test_aTurnedLayerIsNamed(self):
        log = log_of("document((FIRST[0], FIRST[1][:, ::-1]), SECOND)")
        assert 'Layer "A" (id 0) is inside out' in log and 'Layer "B"' not in log

    def test_aMirroredLayerIsNamed(self):
        log = log_of("mirrored_document()")
        assert re.search(r'Layer "B" \(id 1\) is .*mirrored', log) and 'Layer "A"' not in log

    def test_duplicateFacesAreCounted(self):
        log = log_of("document(joined(FIRST, FIRST), SECOND)")
        assert 'Layer "A" (id 0) has faces on the same three vertices: 12 duplicate faces' in log
        log = log_of("document(SECOND, joined(FIRST, box((2, 0, 0), (4, 2, 2))))")
        assert re.search(r'Layer "B" \(id 1\) .*: 2 opposite pairs cancelled\.', log)

    def test_layersRightSideOutAreNotMentioned(self):
        log = log_of("document(FIRST, SECOND)")
        assert "inside out" not in log and "is empty" not in log
        assert "same three vertices" not in log

    def test_anEmptyBlockOfDisjointLayersSaysSo(self):
        log = log_of("document(FIRST, FAR_AWAY)")
        assert '"A intersection B" is empty: the layers are disjoint.' in log

    def test_anEmptyBlockOfAContainedLayerSaysSo(self):
        log = log_of("document(FIRST, WITHIN_FIRST)")
        assert '"B minus A" is empty: "B" (id 1) lies within "A" (id 0).' in log

    def test_eachBlockIsMeasuredAndTheRunTimed(self):
        log = log_of("document(FIRST, SECOND)")
        assert re.search(r'"A minus B": \d+ faces, 1 component, volume 7.34375, area ', log)
        assert log.count(" volume ") == 4
        assert re.search(r"Index Boolean took [\d.e-]+ s, [\d.e-]+ s of it", log)

    def test_percentsNeverFall(self):
        log = log_of("document(sphere(subdivisions=5), sphere((0.5, 0.3, 0.2), subdivisions=5))")
        percents = [int(percent) for percent in re.findall(r"\[ *(\d+)% \]", log)]
        assert len(percents) > 5
        assert percents == sorted(percents)
        assert percents[0] >= 0 and percents[-1] <= 100


class TestRefusedParameters:
    @pytest.mark.parametrize("parameter", ["first_mesh", "second_mesh"])
    @pytest.mark.parametrize("bad_id", [99, 2, -1])
    def test_anUnknownLayer(self, parameter, bad_id):
        mesh_set = document(FIRST, SECOND)
        select(mesh_set, 0, "fi < 3")
        message = refused(mesh_set, **{parameter: bad_id})
        assert f"no layer with id {bad_id}" in message and parameter in message

    def test_theSameLayerTwice(self):
        mesh_set = document(FIRST, SECOND)
        select(mesh_set, 1, "fi < 3")
        before = state_of(mesh_set)
        message = refused(mesh_set, first_mesh=1, second_mesh=1)
        assert '"B" (id 1)' in message
        assert state_of(mesh_set) == before

    def test_nothingRequested(self):
        message = refused(document(FIRST, SECOND), **only())
        for block in ALL_BLOCKS:
            assert block in message

    @pytest.mark.parametrize(
        ("parameter", "value", "accepted"),
        [
            ("octree_max_depth", 0, "from 1 to 20"),
            ("octree_max_depth", 21, "from 1 to 20"),
            ("octree_max_depth", -1, "from 1 to 20"),
            ("octree_leaf_size", -1, "from 0 to 1000"),
            ("octree_leaf_size", 1001, "from 0 to 1000"),
        ],
    )
    def test_anOctreeParameterOutOfRange(self, parameter, value, accepted):
        message = refused(document(FIRST, SECOND), **{parameter: value})
        assert f"{parameter} is {value}" in message and accepted in message

    @pytest.mark.parametrize(
        "parameters",
        [
            {"octree_max_depth": 1},
            {"octree_max_depth": 20},
            {"octree_leaf_size": 1},
            {"octree_leaf_size": 1000},
        ],
    )
    def test_theLimitsOfTheOctreeAreAcceptedAndChangeNothing(self, parameters):
        pair = sphere(), sphere((0.5, 0.3, 0.2))
        usual, unusual = document(*pair), document(*pair)
        usual.generate_index_boolean()
        unusual.generate_index_boolean(**parameters)
        for layer in range(2, 6):
            expected, found = arrays_of(usual.mesh(layer)), arrays_of(unusual.mesh(layer))
            assert np.array_equal(expected[0], found[0]) and np.array_equal(expected[1], found[1])


class TestRefusedLayers:
    """Each layer is refused as the first operand and as the second."""

    @pytest.fixture(params=[0, 1], ids=["asFirst", "asSecond"])
    def place(self, request):
        """place(mesh) makes a document with the mesh as the operand under test, and selects faces
        0 and 1 of both layers."""

        def make(mesh):
            meshes = [SECOND, SECOND]
            meshes[request.param] = mesh
            mesh_set = document(*meshes)
            for layer in (0, 1):
                select(mesh_set, layer, "fi < 2")
            return mesh_set

        make.layer = request.param
        return make

    def test_aPointCloud(self, place):
        message = refused(place((FIRST[0], np.empty((0, 3), dtype=int))), named=[place.layer])
        assert "has no face" in message

    def test_anEmptyLayer(self):
        mesh_set = document(FIRST, FAR_AWAY)
        mesh_set.generate_index_boolean(**only("intersection"))
        for parameters in ({"first_mesh": 2}, {"second_mesh": 2}):
            assert "has no face" in refused(mesh_set, named=[2], **parameters)

    @pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf])
    def test_notFinite(self, place, value):
        vertices, faces = FIRST[0].copy(), FIRST[1]
        vertices[3, 1] = value
        mesh_set = place((vertices, faces))
        message = refused(mesh_set, named=[place.layer])
        at_vertex = np.flatnonzero((faces == 3).any(axis=1)).tolist()
        assert selected_faces(mesh_set, place.layer) == at_vertex
        assert re.search(rf"\b{len(at_vertex)}\b", message) and "finite" in message

    def test_aMatrixThatOverflows(self, place):
        mesh_set = place(FIRST)
        set_matrix(mesh_set, place.layer, np.diag((1e308, 1e308, 1e308, 1.0)))
        message = refused(mesh_set, named=[place.layer])
        assert "finite" in message

    def test_notClosed(self, place):
        mesh = without_faces(FIRST, 5)
        mesh_set = place(mesh)
        message = refused(mesh_set, named=[place.layer])
        edges = {frozenset(edge) for edge in ((a, b) for a in FIRST[1][5] for b in FIRST[1][5])}
        at_hole = [
            face
            for face, (a, b, c) in enumerate(mesh[1])
            if any(len(e) == 2 and e in edges for e in map(frozenset, ((a, b), (b, c), (c, a))))
        ]
        assert selected_faces(mesh_set, place.layer) == at_hole
        assert "not closed" in message and re.search(r"\b3\b", message)
        assert "generate_index_boolean_split" in message

    def test_notOriented(self, place):
        mesh_set = place(one_sided())
        message = refused(mesh_set, named=[place.layer])
        assert selected_faces(mesh_set, place.layer)
        assert "orient" in message and "winding_rule = odd" in message

    def test_facesThatAreTurnedAgainstTheirNeighboursAreNoneOfIt(self, place):
        result = place(turned_faces(FIRST, 5)).generate_index_boolean(first_mesh=0, second_mesh=1)
        assert result["union_volume"] == pytest.approx(VOLUMES["union"], rel=1e-14)

    def test_oneFace(self, place):
        mesh_set = place((FIRST[0][:3], np.array([(0, 1, 2)])))
        message = refused(mesh_set, named=[place.layer])
        assert "not closed: 3 edges" in message
        assert selected_faces(mesh_set, place.layer) == [0]

    def test_noVolume(self, place):
        faces = np.array([(0, 1, 2), (2, 1, 0)])
        message = refused(place((FIRST[0][:3], faces)), named=[place.layer])
        assert "has no face that encloses anything: 1 pair of opposite faces cancels" in message
        assert "double-sided" in message

    def test_previousSelectionIsClearedInTheNamedLayerAndKeptInTheOther(self, place):
        mesh_set = place(without_faces(sphere(), 100))
        refused(mesh_set, named=[place.layer])
        assert not set(selected_faces(mesh_set, place.layer)) & {0, 1}
        assert mesh_set.mesh(place.layer).selected_face_number() == 3
        assert selected_faces(mesh_set, 1 - place.layer) == [0, 1]


class TestSwitches:
    """The parameters that change how blocks are delivered, and which layers are accepted."""

    @pytest.mark.parametrize(
        "switch",
        [
            {"merge_fragments": False},
            {"merge_coplanar": True},
            {"weld_non_manifold": True},
            {"self_intersections": "refuse"},
            {"self_intersections": "trust"},
        ],
        ids=lambda switch: next(iter(switch)),
    )
    def test_noSwitchChangesTheSolids(self, switch):
        mesh_set = document(FIRST, SECOND)
        result = mesh_set.generate_index_boolean(symmetric_difference=True, **switch)
        for block, volume in VOLUMES.items():
            arrays = arrays_of(mesh_set.mesh(result[f"{block}_layer"]))
            assert mesh_laws.unmatched_edges(*arrays) == 0
            assert mesh_laws.volume(*arrays) == pytest.approx(volume, rel=1e-14)

    @pytest.mark.parametrize("place", [0, 1])
    def test_componentsThatCrossFarAwayAreFoundIfAsked(self, place):
        meshes = [FAR_AWAY, FAR_AWAY]
        meshes[place] = crossing_bars()
        mesh_set = document(*meshes)
        select(mesh_set, place, "fi < 2")
        message = refused(mesh_set, named=[place], self_intersections="refuse")
        selected = selected_faces(mesh_set, place)
        assert f"intersects itself: {len(selected)} faces are concerned, the first near" in message
        assert min(selected) < 12 <= max(selected)
        assert document(*meshes).generate_index_boolean()["union_closed"]

    @pytest.mark.parametrize("seed", range(6))
    def test_theFacesFoundAreThoseThatLibiglFinds(self, seed):
        rng = np.random.default_rng(seed)
        vertices, faces = shapes.torus(rng) if seed % 2 else sphere()
        edge = np.linalg.norm(vertices[faces[:, 0]] - vertices[faces[:, 1]], axis=1).mean()
        vertices = vertices + rng.normal(scale=(0.3 + 0.03 * seed) * edge, size=vertices.shape)
        expected = oracles.faces_that_cross(vertices, faces)
        assert expected
        mesh_set = document((vertices, faces), FAR_AWAY)
        refused(mesh_set, named=[0], self_intersections="refuse")
        assert selected_faces(mesh_set, 0) == expected

    def test_componentsThatShareACornerOrAnEdgeArePassed(self):
        touching = joined(FIRST, box((2, 2, 0), (4, 4, 2)), box((4, 4, 2), (5, 5, 3)))
        result = document(touching, FAR_AWAY).generate_index_boolean(self_intersections="refuse")
        assert result["union_volume"] == pytest.approx(18)


class TestContact:
    """Surfaces that touch without crossing."""

    @pytest.mark.parametrize(
        ("second", "shared"),
        [
            (box((2, 0, 0), (3, 2, 2)), 0),
            (box((1, 0.5, 0.5), (2, 1.5, 1.5)), 1),
            (box((2, 2, 2), (3, 3, 3)), 0),
            (FIRST, 8),
        ],
        ids=["faceToFace", "coplanarInside", "cornerToCorner", "identical"],
    )
    def test_touchingBoxes(self, second, shared):
        mesh_set = document(FIRST, second)
        result = mesh_set.generate_index_boolean()
        assert result["intersection_volume"] == pytest.approx(shared)
        assert result["first_minus_second_volume"] == pytest.approx(8 - shared)
