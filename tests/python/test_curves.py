# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""generate_index_boolean_curves, and the parameter curves of generate_index_boolean."""

import numpy as np
import pymeshlab
import pytest

from conftest import box, document, joined, sphere
from open_shapes import bumpy_sheet, square
from paper_figures import blocks_pair, open_pair
from sample_catalogue import sample
from shapes import shuffled
from test_filter import FAR_AWAY, FIRST, SECOND, log_of, set_matrix, state_of, translation

CYLINDERS = sample("cylinder_along_x"), sample("cylinder_along_y")
OPEN, HARD, SOFT = 0, 1, 2


class Curves:
    """The layer of polylines: arrays by vertex, and the result map."""

    def __init__(self, mesh_set, result):
        mesh = mesh_set.mesh(result["curves_layer"])
        self.result = result
        self.label = mesh.label()
        self.vertices = np.array(mesh.vertex_matrix())
        self.edges = np.array(mesh.edge_matrix()).reshape(-1, 2)
        self.face_number = mesh.face_number()
        for name in ("loop", "loop_kind", "source_face_first", "source_face_second"):
            values = mesh.vertex_custom_scalar_attribute_array(name)
            setattr(self, name, values.astype(np.int64))

    def lengths(self):
        """Of each loop, by its edges."""
        ends = self.vertices[self.edges]
        length = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
        return np.bincount(self.loop[self.edges[:, 0]], length, self.loop.max() + 1)


def curves(first, second, **parameters):
    mesh_set = document(first, second)
    return Curves(mesh_set, mesh_set.generate_index_boolean_curves(**parameters))


def check(found, operands):
    """All that holds for every layer of curves."""
    result = found.result
    count = len(result["loop_kinds"])
    assert np.array_equal(np.unique(found.loop), np.arange(count))
    assert np.array_equal(found.loop_kind, result["loop_kinds"][found.loop])
    assert np.bincount(result["loop_kinds"].astype(int), minlength=3).tolist() == [
        result[f"loops_{kind}"] for kind in ("open", "hard_closed", "soft_closed")
    ]
    assert np.all(found.loop[found.edges[:, 0]] == found.loop[found.edges[:, 1]])
    assert np.allclose(found.lengths(), result["loop_lengths"], rtol=1e-14)
    for loop in range(count):
        degree = np.bincount(found.edges.ravel(), minlength=len(found.vertices))
        ends = np.count_nonzero(degree[found.loop == loop] == 1)
        assert np.all(np.isin(degree[found.loop == loop], (1, 2)))
        assert ends == 0 if found.loop_kind[found.loop == loop][0] == HARD else ends in (0, 2)
    for (vertices, faces), source in zip(
        operands, (found.source_face_first, found.source_face_second)
    ):
        corners = vertices[faces[source]]
        normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        height = np.sum((found.vertices - corners[:, 0]) * normal, axis=1)
        assert np.abs(height).max() < 1e-12
        low, high = corners.min(axis=1) - 1e-12, corners.max(axis=1) + 1e-12
        assert np.all((found.vertices >= low) & (found.vertices <= high))


@pytest.mark.parametrize(
    "pair, kinds",
    [
        ((FIRST, SECOND), (0, 1, 0)),
        (blocks_pair(), (0, 6, 0)),
        (CYLINDERS, (0, 0, 4)),
        (open_pair(), (4, 0, 0)),
        ((sphere(), bumpy_sheet((0.2, 0.1, 1), 0.1, 2, 7)), (0, 1, 0)),
        ((box((0, 0, 0), (2, 2, 2)), square(1, 3, 1.0)), (1, 0, 0)),
        ((joined(FIRST, box((0, 0, 3), (2, 2, 4))), box((1, 1.5, 1), (2.5, 2.6, 3.7))), (0, 2, 0)),
    ],
    ids=("boxes", "six", "cylinders", "sheets", "sphere", "ends inside", "components"),
)
def test_loopsAreCountedAndDrawn(pair, kinds):
    found = curves(*pair)
    check(found, pair)
    names = ("loops_open", "loops_hard_closed", "loops_soft_closed")
    assert tuple(found.result[name] for name in names) == kinds
    assert (found.label, found.face_number) == ("A curves B", 0)


def test_theLengthIsTheRightOne():
    found = curves(box((0, 0, 0), (2, 2, 2)), square(-1, 3, 0.5, steps=3))
    assert found.result["loop_lengths"] == pytest.approx([8], rel=1e-15)


def test_junctionsAreRepeated():
    found = curves(*CYLINDERS)
    assert len(found.vertices) == len(found.edges) + 4
    assert len(np.unique(found.vertices, axis=0)) == len(found.vertices) - 6


def test_eachLoopHasSubSurfacesOnBothSides():
    result = curves(*CYLINDERS).result
    for name in ("first", "second"):
        loops = result[f"loops_at_sub_surfaces_{name}_loop"].astype(int)
        pieces = result[f"loops_at_sub_surfaces_{name}_sub_surface"].astype(int)
        assert np.bincount(loops).tolist() == [2, 2, 2, 2]
        assert np.bincount(pieces).tolist() == [2, 2, 2, 2]
    result = curves(box((0, 0, 0), (2, 2, 2)), square(1, 3, 1.0)).result
    assert result["loops_at_sub_surfaces_first_sub_surface"].tolist() == [0]
    assert len(result["loops_at_sub_surfaces_second_sub_surface"]) == 2


def test_numbersDoNotDependOnTheOrderOfVerticesAndFaces():
    rng = np.random.default_rng(5)
    first, second = blocks_pair()
    expected = curves(first, second)
    found = curves(shuffled(*first, rng), shuffled(*second, rng))
    assert np.array_equal(found.vertices, expected.vertices)
    assert np.array_equal(found.edges, expected.edges)
    assert np.array_equal(found.loop, expected.loop)
    swapped = curves(second, first)
    assert np.array_equal(swapped.vertices, expected.vertices)


def test_theMatrixIsApplied():
    shift = translation(0.0625, 0.03125, -0.015625)
    mesh_set = document(FIRST, SECOND)
    set_matrix(mesh_set, 1, shift)
    found = Curves(mesh_set, mesh_set.generate_index_boolean_curves())
    moved = curves(FIRST, (SECOND[0] + shift[:3, 3], SECOND[1]))
    assert np.array_equal(found.vertices, moved.vertices)
    assert np.array_equal(mesh_set.current_mesh().transform_matrix(), np.eye(4))


def test_layersThatDoNotMeetGiveAnEmptyLayer():
    found = curves(FIRST, FAR_AWAY)
    assert len(found.vertices) == len(found.edges) == len(found.result["loop_lengths"]) == 0
    log = log_of("document(FIRST, FAR_AWAY)", "generate_index_boolean_curves")
    assert '"A curves B" is empty: the layers do not meet in a line.' in log


def test_theLogTellsTheKindsAndTheLength():
    log = log_of("document(FIRST, SECOND)", "generate_index_boolean_curves")
    assert '"A curves B": 1 loop (0 open, 1 hard-closed, 0 soft-closed), length 5' in log


def test_theBooleanAddsTheSameLayerLast():
    mesh_set = document(FIRST, SECOND)
    result = mesh_set.generate_index_boolean(curves=True)
    assert [mesh.label() for mesh in mesh_set][2:] == [
        "A union B", "A intersection B", "A minus B", "B minus A", "A curves B",
    ]
    assert result["curves_layer"] == 6 and mesh_set.current_mesh_id() == 2
    found, expected = Curves(mesh_set, result), curves(FIRST, SECOND)
    for name in ("vertices", "edges", "loop", "loop_kind", "source_face_first"):
        assert np.array_equal(getattr(found, name), getattr(expected, name))
    assert result["loop_lengths"] == pytest.approx(expected.result["loop_lengths"])


def test_theBooleanAddsNoCurvesUnlessAsked():
    result = document(FIRST, SECOND).generate_index_boolean()
    assert "curves_layer" not in result and "loop_lengths" not in result


def test_aRefusalChangesNothing():
    mesh_set = document(FIRST, SECOND)
    before = state_of(mesh_set)
    with pytest.raises(pymeshlab.PyMeshLabException, match="Choose two layers"):
        mesh_set.generate_index_boolean_curves(first_mesh=1, second_mesh=1)
    assert state_of(mesh_set) == before
