# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Clips of generate_index_boolean_split: a surface, open or closed, inside or outside a solid.

Real meshes are in the folder named by INDEXBOOLEAN_MESHES: unset, those tests skip.
"""

import os

import igl
import numpy as np
import pymeshlab
import pytest

import mesh_laws
import placements
from conftest import box, document, joined, sphere
from open_shapes import bumpy_sheet, flipped, square
from split_run import NUMBERS, Piece, Split
from test_filter import log_of, selected_faces, set_matrix, state_of
from test_polygons import quad_box, sizes_of
from textured_pair import textured_document

CUBE = box((0, 0, 0), (2, 2, 2))
SHEET = bumpy_sheet((0.1, 0.2, 1), 1.1, 2.6, steps=12, bump=0.08)
CLIPS = (
    "first_inside_second", "first_outside_second", "second_inside_first", "second_outside_first",
)
OFF = {"sub_surfaces_first": False, "sub_surfaces_second": False, "sub_blocks": False}
needs_meshes = pytest.mark.skipif(
    not os.environ.get(placements.MESHES_VARIABLE),
    reason=f"{placements.MESHES_VARIABLE} is not set: no folder of other people's meshes",
)


class ClipRun:
    """A run on two meshes with clips alone: the document, the result map, the clips' layers."""

    def __init__(self, first, second, clips=CLIPS[:2], **parameters):
        self.mesh_set = document(first, second)
        parameters = {**OFF, **{clip: True for clip in clips}, **parameters}
        self.result = self.mesh_set.generate_index_boolean_split(**parameters)
        self.clips = {
            clip: Piece(self.mesh_set.mesh(self.result[f"{clip}_layer"])) for clip in clips
        }

    def areas(self):
        for clip, piece in self.clips.items():
            area = mesh_laws.area(piece.vertices, piece.faces)
            assert self.result[f"{clip}_area"] == pytest.approx(area, rel=1e-13, abs=1e-300)
            assert self.result[f"{clip}_faces"] == len(piece.faces)
            assert self.result[f"{clip}_self_intersections"] == 0
        return [self.result[f"{clip}_area"] for clip in self.clips]


def check_against_split(first, second, both_closed=False):
    """Each clip is the sub-surfaces of the split that lie there, by their ids, areas and faces."""
    clips = CLIPS if both_closed else CLIPS[:2]
    run = ClipRun(first, second, clips)
    split = Split(first, second)
    for clip, piece in run.clips.items():
        operand, other = (0, 1) if clip.startswith("first") else (1, 0)
        whole = split.surfaces[operand]
        inside = split.result[f"sub_blocks_in_{('first', 'second')[other]}"] == 1
        inside = np.append(inside, False)  # -1 is the outside
        is_in = inside[whole["block_front"]] | inside[whole["block_back"]]
        chosen = is_in == ("inside" in clip)
        ids = np.unique(whole["sub_surface"][chosen])
        assert np.array_equal(np.unique(piece["sub_surface"]), ids), clip
        assert not np.isin(whole["sub_surface"][~chosen], ids).any()
        areas = split.result[f"sub_surfaces_{('first', 'second')[operand]}_areas"]
        scale = mesh_laws.area(*split.operands[operand])
        assert abs(run.result[f"{clip}_area"] - areas[ids].sum()) <= 1e-12 * scale
        for name in NUMBERS:
            assert np.array_equal(piece[name], whole[name][chosen]), name
        expected = mesh_laws.triangle_set(whole.vertices, whole.faces[chosen])
        assert np.array_equal(mesh_laws.triangle_set(piece.vertices, piece.faces), expected)
        assert np.all(piece["source_mesh"] == operand)
    return run


# --- closed forms -------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "surface, inside, outside",
    [
        (square(-1, 3, 0.5), 4, 12),
        (square(1, 3, 0.5), 1, 3),
        (square(0.5, 1.5, 1.5), 1, 0),
        (square(5, 6, 1), 0, 1),
        (square(-1, 3, 2.0), 4, 12),  # on a wall: counts as inside
        (square(-1, 3, 0.0, steps=3), 4, 12),
        (square(0, 2, 2.0), 4, 0),
        (square(2, 3, 2.0), 0, 1),
        (box((1, 1, 1), (3, 3, 3)), 3, 21),
        (box((0, 0, 0), (4, 4, 4)), 12, 84),
        (CUBE, 24, 0),
    ],
)
def test_areasInsideAndOutsideABox(surface, inside, outside):
    for turned in (surface, flipped(*surface)):
        for solid in (CUBE, flipped(*CUBE)):
            assert ClipRun(turned, solid).areas() == pytest.approx([inside, outside], abs=1e-13)


def test_aSheetThroughASphereHasTheAreaOfItsSection():
    vertices, faces = sphere((0, 0, 0), 1, 4)
    height = 0.3
    sides = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    edges = np.unique(np.sort(sides, axis=1), axis=0)
    ends = vertices[edges]
    above = ends[:, :, 2] > height
    ends = ends[above[:, 0] != above[:, 1]]
    t = (height - ends[:, 0, 2]) / (ends[:, 1, 2] - ends[:, 0, 2])
    rim = (ends[:, 0] + t[:, None] * (ends[:, 1] - ends[:, 0]))[:, :2]
    rim = rim[np.argsort(np.arctan2(rim[:, 1], rim[:, 0]))]  # it is convex, around the origin
    x, y = rim.T
    section = (x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2
    assert 0.98 * np.pi * (1 - height**2) < section < np.pi * (1 - height**2)
    inside, outside = ClipRun(square(-2, 2, height, steps=5), (vertices, faces)).areas()
    assert inside == pytest.approx(section, rel=1e-13)
    assert outside == pytest.approx(16 - section, rel=1e-13)


def test_windingNumbersOfTheClippedFacesSayTheSame():
    solid = sphere((0.1, 0.2, 1.0), 1.1, 3)
    run = check_against_split(SHEET, solid)
    for clip, piece in run.clips.items():
        centres = piece.vertices[piece.faces].mean(axis=1)
        winding = igl.winding_number(solid[0], np.asarray(solid[1], dtype=np.int64), centres)
        expected = 1 if "inside" in clip else 0
        assert np.abs(winding - expected).max() < 1e-6
        assert len(centres) > 20


# --- switches, keys, layers ---------------------------------------------------------------------


class TestSwitches:
    @pytest.mark.parametrize("clip", CLIPS)
    def test_eachIsALayerOfItsOwn(self, clip):
        other = box((1, 1, 1), (3, 3, 3))
        run = ClipRun(CUBE, other, (clip,))
        labels = ("A inside B", "A outside B", "B inside A", "B outside A")
        assert [mesh.label() for mesh in run.mesh_set][2:] == [labels[CLIPS.index(clip)]]
        assert run.areas() == pytest.approx([3 if "inside" in clip else 21])
        keys = {key: type(value) for key, value in run.result.items() if key.startswith(clip)}
        assert keys == {
            f"{clip}_layer": int, f"{clip}_area": float, f"{clip}_faces": int,
            f"{clip}_self_intersections": int, f"{clip}_repair_rounds": int,
            f"{clip}_moved_vertices": int, f"{clip}_largest_move": float,
            f"{clip}_volume_change": float, f"{clip}_vanished_components": int,
        }
        assert not [key for key in run.result if "side" in key and not key.startswith(clip)
                    and key.endswith("_layer")]

    def test_theyComeBehindThePieces(self):
        mesh_set = document(CUBE, box((1, 1, 1), (3, 3, 3)))
        result = mesh_set.generate_index_boolean_split(**{clip: True for clip in CLIPS})
        assert [mesh.label() for mesh in mesh_set][2:] == [
            "A cut by B", "B cut by A", "A blocks B", "A inside B", "A outside B", "B inside A",
            "B outside A",
        ]
        assert [result[f"{clip}_layer"] for clip in CLIPS] == [5, 6, 7, 8]
        assert mesh_set.current_mesh_id() == 2

    def test_uncertifiedOnesHaveOneKeyThatSaysSo(self):
        run = ClipRun(SHEET, CUBE, certify=False)
        keys = [key for key in run.result if key.startswith("first_inside_second")]
        assert sorted(key[len("first_inside_second_"):] for key in keys) == [
            "area", "faces", "layer", "self_intersections",
        ]
        assert run.result["first_inside_second_self_intersections"] == -1
        trusted = ClipRun(SHEET, CUBE, self_intersections="trust")
        assert trusted.result["first_inside_second_self_intersections"] == -1

    def test_inSinglePrecision(self):
        run = ClipRun(SHEET, sphere((0.1, 0.2, 1.0), 1.1, 3), certify_as="float")
        for clip, piece in run.clips.items():
            assert np.array_equal(piece.vertices, piece.vertices.astype(np.float32).astype(float))
            assert run.result[f"{clip}_self_intersections"] == 0

    def test_noneIsMadeUnlessAskedFor(self):
        result = document(CUBE, SHEET).generate_index_boolean_split()
        assert not [key for key in result if "inside" in key or "outside" in key]

    def test_theLogTellsWhatTheyAre(self):
        parameters = "first_inside_second=True, first_outside_second=True"
        log = log_of("document(FIRST, SECOND)", "generate_index_boolean_split", parameters)
        assert '"A inside B": ' in log and "component, area " in log
        apart = "document(FIRST, (SECOND[0] + 50, SECOND[1]))"
        log = log_of(apart, "generate_index_boolean_split", parameters)
        assert '"A inside B" is empty: nothing of "A" (id 0) lies inside "B" (id 1).' in log

    def test_anEmptyClipIsAnEmptyLayer(self):
        run = ClipRun(square(5, 6, 1), CUBE)
        assert run.result["first_inside_second_faces"] == 0
        assert run.mesh_set.mesh(run.result["first_inside_second_layer"]).face_number() == 0

    def test_inputLayersAreNotChanged(self):
        mesh_set = document(SHEET, CUBE)
        before = state_of(mesh_set)
        mesh_set.generate_index_boolean_split(first_inside_second=True)
        assert state_of(mesh_set)[0] == before[0] and state_of(mesh_set)[1] == before[1]


# --- open and closed, refusals ------------------------------------------------------------------


class TestWhatClips:
    OPEN = CUBE[0], CUBE[1][:-1]

    def test_theClippedOneMayBeOpen(self):
        # The triangle that is missing has a quarter of its area of 2 in the box.
        areas = ClipRun(self.OPEN, box((1, 1, 1), (3, 3, 3))).areas()
        assert areas == pytest.approx([2.5, 19.5])

    @pytest.mark.parametrize("clip", CLIPS)
    def test_whatClipsMustBeClosed(self, clip):
        is_first = clip.startswith("first")
        mesh_set = document(SHEET, self.OPEN) if is_first else document(self.OPEN, SHEET)
        before = state_of(mesh_set)
        with pytest.raises(pymeshlab.PyMeshLabException) as refusal:
            mesh_set.generate_index_boolean_split(**OFF, **{clip: True})
        name = 'Layer "B" (id 1)' if is_first else 'Layer "A" (id 0)'
        assert f"{name} is not closed: 3 edges" in str(refusal.value)
        assert "Close Holes" in str(refusal.value) and "clip" in str(refusal.value)
        assert "Union" not in str(refusal.value)
        assert len(selected_faces(mesh_set, 1 if is_first else 0)) == 3
        other = 0 if is_first else 1  # the layer that is not named stays as it is
        assert state_of(mesh_set)[other] == before[other]
        assert mesh_set.mesh_number() == 2

    def test_itsWindingRuleSaysWhatIsInside(self):
        solid = joined(CUBE, box((1, 1, 1), (3, 3, 3)))
        sheet = square(-1, 4, 1.5)
        for rule, inside in (("nonzero", 7), ("positive", 7), ("odd", 6)):
            assert ClipRun(sheet, solid, winding_rule=rule).areas()[0] == pytest.approx(inside)
        partly = joined(CUBE, flipped(*box((1, 1, 1), (3, 3, 3))))
        for rule, inside in (("nonzero", 6), ("positive", 3), ("odd", 6)):
            assert ClipRun(sheet, partly, winding_rule=rule).areas()[0] == pytest.approx(inside)

    def test_twoClosedOnesClipEachOther(self):
        run = check_against_split(sphere((1, 1, 2), 0.9, 3), CUBE, both_closed=True)
        union = run.mesh_set.generate_index_boolean(first_mesh=0, second_mesh=1)["union_area"]
        outsides = [run.result[f"{clip}_area"] for clip in (CLIPS[1], CLIPS[3])]
        assert sum(outsides) == pytest.approx(union, rel=1e-13)


# --- among other layers -------------------------------------------------------------------------


class TestInAList:
    def test_firstAndSecondMeshAreTakenFromTheList(self):
        third = bumpy_sheet((1, 0.2, 0.1), 0.9, 2.5, steps=6, bump=0.05)
        two = ClipRun(SHEET, CUBE, CLIPS[:2])
        mesh_set = document(third, CUBE, SHEET)
        result = mesh_set.generate_index_boolean_split(
            layers="all", first_mesh=2, second_mesh=1, first_inside_second=True,
            first_outside_second=True, sub_blocks=False, sub_surfaces=False,
        )
        assert [mesh.label() for mesh in mesh_set][3:] == ["C inside B", "C outside B"]
        areas = [result[f"{clip}_area"] for clip in CLIPS[:2]]
        assert areas == pytest.approx(two.areas(), rel=1e-13)
        numbers = Piece(mesh_set.mesh(result["first_inside_second_layer"]))
        assert set(numbers["source_mesh"]) == {2}
        assert len(set(numbers["sub_surface"])) == 2  # the third layer cuts it, too

    def test_layersThatAreNotInTheListAreRefused(self):
        mesh_set = document(SHEET, CUBE, sphere())
        with pytest.raises(pymeshlab.PyMeshLabException) as refusal:
            mesh_set.generate_index_boolean_split(
                layers="1,2", first_mesh=0, second_mesh=1, first_inside_second=True
            )
        assert "first_inside_second is of first_mesh and second_mesh" in str(refusal.value)
        assert '"A" (id 0) is not one of those' in str(refusal.value)


# --- matrices and attributes --------------------------------------------------------------------


@pytest.mark.parametrize("mirrored", [(0,), (1,), (0, 1)])
def test_mirroredMatrices(mirrored):
    mirror = np.diag((1.0, 1, -1, 1))
    mesh_set = document(SHEET, CUBE)
    meshes = []
    for layer, (vertices, faces) in enumerate((SHEET, CUBE)):
        if layer in mirrored:
            set_matrix(mesh_set, layer, mirror)
            meshes.append((vertices * (1, 1, -1), faces[:, ::-1].copy()))
        else:
            meshes.append((vertices, faces))
    result = mesh_set.generate_index_boolean_split(
        **OFF, first_inside_second=True, first_outside_second=True
    )
    assert [result[f"{clip}_area"] for clip in CLIPS[:2]] == pytest.approx(
        ClipRun(*meshes).areas(), rel=1e-13, abs=1e-14
    )


def test_coloursAndQualitiesAreTheClippedLayersOwn():
    mesh_set = pymeshlab.MeshSet()
    vertices, faces = SHEET
    quality = vertices @ (1.0, 2.0, 3.0)
    grey = np.linspace(0, 1, len(faces))
    mesh_set.add_mesh(
        pymeshlab.Mesh(
            vertices, faces, v_scalar_array=quality,
            f_color_matrix=np.column_stack([grey, grey, grey, np.ones(len(faces))]),
        ), "A",
    )
    mesh_set.add_mesh(pymeshlab.Mesh(*CUBE), "B")
    result = mesh_set.generate_index_boolean_split(**OFF, first_inside_second=True)
    mesh = mesh_set.mesh(result["first_inside_second_layer"])
    assert np.abs(mesh.vertex_scalar_array() - mesh.vertex_matrix() @ (1, 2, 3)).max() < 1e-12
    source = mesh.face_custom_scalar_attribute_array("source_face").astype(int)
    assert np.abs(mesh.face_color_matrix()[:, 0] - grey[source]).max() < 1 / 255


def test_texturesAreCarried(tmp_path):
    mesh_set = textured_document(tmp_path)
    result = mesh_set.generate_index_boolean_split(**OFF, first_outside_second=True)
    mesh = mesh_set.mesh(result["first_outside_second_layer"])
    assert mesh.has_wedge_tex_coord()
    assert list(mesh.textures())[0].endswith("checks.png")
    given = mesh_set.mesh(0)
    source = mesh.face_custom_scalar_attribute_array("source_face").astype(int)
    uncut = np.array([
        np.isin(a, b).all() for a, b in zip(
            mesh.vertex_matrix()[mesh.face_matrix()].reshape(-1, 9),
            given.vertex_matrix()[given.face_matrix()][source].reshape(-1, 9),
        )
    ])
    assert uncut.sum() > 100
    found = mesh.wedge_tex_coord_matrix().reshape(-1, 6)[uncut]
    expected = given.wedge_tex_coord_matrix().reshape(-1, 6)[source[uncut]]
    assert np.abs(np.sort(found, axis=1) - np.sort(expected, axis=1)).max() < 1e-6


def test_quadsStayQuads():
    mesh_set = document(quad_box((0, -1, -1), (1, 1, 1)), box((0.5, -3, -3), (3, 3, 3)))
    result = mesh_set.generate_index_boolean_split(
        **OFF, first_inside_second=True, first_outside_second=True
    )
    for clip in CLIPS[:2]:
        sizes = sizes_of(mesh_set.mesh(result[f"{clip}_layer"]))
        assert sum(sizes.values()) == 5 and sizes[4] >= 1 and 3 not in sizes


# --- other people's meshes ----------------------------------------------------------------------

OPEN_MESHES = ("falconstatue_boundary", "lionstatue", "mountain", "plane_holes")


@needs_meshes
@pytest.mark.parametrize("name", OPEN_MESHES)
def test_openScansTrimmedByABoxAndASphere(name):
    vertices, faces = placements.read_mesh(placements.meshes_folder() / f"{name}.obj")
    vertices = placements.normalised(vertices)
    low, high = np.array((-0.31, -0.23, -0.27)), np.array((0.29, 0.33, 0.21))
    for solid in (box(low, high), sphere((0.05, 0.04, 0.03), 0.35, 4)):
        run = check_against_split((vertices, faces), solid)
        inside, outside = run.areas()
        assert inside > 0 and outside > 0
        piece = run.clips["first_inside_second"]
        if solid[0].shape[0] == 8:
            slack = 1e-15
            assert np.all(piece.vertices >= low - slack) and np.all(piece.vertices <= high + slack)


@needs_meshes
def test_aScanTrimmedByAnotherOne():
    falcon = placements.read_mesh(placements.meshes_folder() / "falconstatue_boundary.obj")
    bunny = placements.read_mesh(placements.meshes_folder() / "bunny100k.obj")
    pair = [(placements.normalised(vertices), faces) for vertices, faces in (falcon, bunny)]
    run = check_against_split(*pair)
    assert min(run.areas()) > 0
