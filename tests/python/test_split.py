# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""generate_index_boolean_split: layers, numbers, laws, degenerate placements, refusals."""

import numpy as np
import pymeshlab
import pytest

import mesh_laws
from conftest import box, document, joined, sphere
from open_shapes import bumpy_sheet, flipped, grid, square
from shapes import shuffled
from split_run import OPERANDS, Split, check_laws
from test_filter import (
    ids_of, log_of, mirrored_document, selected_faces, set_matrix, state_of, translation,
)

CUBE = box((-1, -1, -1), (1, 1, 1))
SHEET = bumpy_sheet((0.1, 0.2, 1), 0.13, 1.7, steps=9, bump=0.05)
BLOCKS = ("sub_surfaces_first", "sub_surfaces_second", "sub_blocks")


def refused(mesh_set, **parameters):
    """Runs the filter, which must refuse and leave the document as it was. The message."""
    before = state_of(mesh_set)
    with pytest.raises(pymeshlab.PyMeshLabException) as refusal:
        mesh_set.generate_index_boolean_split(**{"first_mesh": 0, "second_mesh": 1, **parameters})
    assert state_of(mesh_set) == before
    return str(refusal.value)


class TestLayers:
    def test_threeLayersComeInOrderWithLabelsOfTheInputs(self):
        split = Split(CUBE, SHEET)
        assert ids_of(split.mesh_set) == [0, 1, 2, 3, 4]
        assert [split.result[f"{kind}_layer"] for kind in BLOCKS] == [2, 3, 4]
        assert [mesh.label() for mesh in split.mesh_set][2:] == [
            "A cut by B", "B cut by A", "A blocks B",
        ]
        assert split.mesh_set.current_mesh_id() == 2

    @pytest.mark.parametrize("kind", BLOCKS)
    def test_onlyWhatIsAskedForGetsALayer(self, kind):
        mesh_set = document(CUBE, SHEET)
        result = mesh_set.generate_index_boolean_split(**{name: name == kind for name in BLOCKS})
        assert mesh_set.mesh_number() == 3
        assert {key for key in result if key.endswith("_layer")} == {f"{kind}_layer"}
        assert [result[name] for name in BLOCKS] == [2, 2, 2]

    def test_coloursTellThePiecesApart(self):
        split = Split(CUBE, SHEET)
        for kind, number in zip(BLOCKS, ("sub_surface", "sub_surface", "sub_block")):
            mesh = split.mesh_set.mesh(split.result[f"{kind}_layer"])
            numbers = mesh.face_custom_scalar_attribute_array(number)
            colours = [np.unique(mesh.face_color_matrix()[numbers == k], axis=0) for k in (0, 1)]
            assert [len(colour) for colour in colours] == [1, 1]
            assert np.abs(colours[0] - colours[1]).max() > 0.2

    def test_separateLayersHoldOnePieceEach(self):
        together = Split(CUBE, SHEET)
        mesh_set = document(CUBE, SHEET)
        result = mesh_set.generate_index_boolean_split(separate_layers=True)
        assert [mesh.label() for mesh in mesh_set][2:] == [
            "A cut by B 0", "A cut by B 1", "B cut by A 0", "B cut by A 1",
            "A blocks B 0", "A blocks B 1",
        ]
        for kind, piece, name in zip(
            BLOCKS,
            (*together.surfaces, together.blocks),
            ("sub_surface", "sub_surface", "sub_block"),
        ):
            for number, layer in enumerate(result[f"{kind}_layers"]):
                mesh = mesh_set.mesh(int(layer))
                found = mesh.vertex_matrix(), mesh.face_matrix()
                assert np.all(mesh.face_custom_scalar_attribute_array(name) == number)
                expected = mesh_laws.triangle_set(*piece.part(name, number))
                assert np.array_equal(mesh_laws.triangle_set(*found), expected)
                assert len(np.unique(found[1])) == len(found[0]), "unreferenced vertices"

    def test_moreThanMaxLayersFallsBackToNumbers(self):
        mesh_set = document(CUBE, SHEET)
        mesh_set.generate_index_boolean_split(separate_layers=True, max_layers=6)
        assert mesh_set.mesh_number() == 8
        mesh_set = document(CUBE, SHEET)
        result = mesh_set.generate_index_boolean_split(separate_layers=True, max_layers=5)
        assert mesh_set.mesh_number() == 5
        assert result["sub_blocks_layers"].tolist() == [4]

    def test_theLogSaysThatThereAreTooManyPieces(self):
        parameters = "separate_layers=True, max_layers=5"
        log = log_of("document(FIRST, SECOND)", "generate_index_boolean_split", parameters)
        assert "There are 7 pieces, more than max_layers (5)" in log
        log = log_of("document(FIRST, SECOND)", "generate_index_boolean_split", "")
        assert "more than max_layers" not in log
        assert '"A cut by B": 2 sub-surfaces (2 private, 0 public; 2 separating), area 24' in log
        assert '"A blocks B": 3 sub-blocks, volume 10.7188' in log

    def test_noBlockIsAnEmptyLayer(self):
        for separate in (False, True):
            mesh_set = document(square(0, 1), square(2, 3, 0.5))
            result = mesh_set.generate_index_boolean_split(separate_layers=separate)
            assert result["sub_blocks"] == 0
            mesh = mesh_set.mesh(result["sub_blocks_layer"])
            assert (mesh.label(), mesh.face_number()) == ("A blocks B", 0)

    def test_inputLayersAreNotChanged(self):
        mesh_set = document(CUBE, SHEET)
        before = state_of(mesh_set)
        mesh_set.generate_index_boolean_split()
        after = state_of(mesh_set)
        assert after[0] == before[0] and after[1] == before[1]


class TestNumbers:
    def test_sourceFacesAreTheLayersOwn(self):
        split = Split(CUBE, SHEET)
        for piece in (*split.surfaces, split.blocks):
            for face, mesh, source in zip(piece.faces, piece["source_mesh"], piece["source_face"]):
                corners = split.operands[mesh][0][split.operands[mesh][1][source]]
                normal = np.cross(corners[1] - corners[0], corners[2] - corners[0])
                heights = (piece.vertices[face] - corners[0]) @ normal
                assert np.abs(heights).max() < 1e-12
                low, high = corners.min(axis=0) - 1e-12, corners.max(axis=0) + 1e-12
                assert np.all((piece.vertices[face] >= low) & (piece.vertices[face] <= high))

    def test_aSolidsFacesHaveItsBlocksBehindThem(self):
        split = Split(CUBE, SHEET)
        first = split.surfaces[0]
        assert np.all(first["block_front"] == -1)
        assert np.array_equal(np.unique(first["block_back"]), [0, 1])
        second = split.surfaces[1]
        inner = second["block_front"] >= 0
        assert set(zip(second["block_front"][inner], second["block_back"][inner])) in (
            {(0, 1)}, {(1, 0)},
        )
        assert np.all(second["block_back"][~inner] == -1)

    @pytest.mark.parametrize("seed", range(5))
    def test_renumberedOperandsGiveTheSameNumbers(self, seed):
        rng = np.random.default_rng(seed)
        split = Split(CUBE, SHEET)
        other = Split(shuffled(*CUBE, rng), shuffled(*SHEET, rng))
        for one, two in zip((*split.surfaces, split.blocks), (*other.surfaces, other.blocks)):
            for name in one.numbers:
                if name == "source_face":
                    continue
                for number in np.unique(one[name]):
                    expected = mesh_laws.triangle_set(*one.part(name, number))
                    assert np.array_equal(mesh_laws.triangle_set(*two.part(name, number)), expected)

    def test_swappedOperandsGiveTheSamePieces(self):
        split, other = Split(CUBE, SHEET), Split(SHEET, CUBE)
        assert other.counts() == tuple(split.counts()[k] for k in (1, 0, 2))
        for number in range(2):
            expected = mesh_laws.triangle_set(*split.block(number))
            assert np.array_equal(mesh_laws.triangle_set(*other.block(number)), expected)


class TestResultMap:
    def test_keysAndTypes(self):
        result = Split(CUBE, SHEET).result
        expected = {kind: int for kind in BLOCKS}
        for kind in BLOCKS:
            expected.update({f"{kind}_layer": int, f"{kind}_layers": np.ndarray})
            expected[f"{kind}_areas"] = np.ndarray
            expected[f"{kind}_self_intersections"] = np.ndarray
        for name in OPERANDS:
            for what in ("public", "one_sided", "boundary_cycles", "separating"):
                expected[f"sub_surfaces_{name}_{what}"] = np.ndarray
            expected[f"sub_blocks_in_{name}"] = np.ndarray
        expected["sub_blocks_volumes"] = np.ndarray
        expected["sub_blocks_closed"] = bool
        expected["volume_law_residual"] = float
        expected["labelled_by_cells"] = bool
        expected |= {"welded_vertices": int, "largest_weld": float, "merged_vertices": int,
                     "largest_merge": float}
        for key in ("zero_area_faces_removed", "loops_open", "loops_hard_closed",
                    "loops_soft_closed", "self_intersecting_faces_first",
                    "self_intersecting_faces_second"):
            expected[key] = int
        found = {k: type(v) for k, v in result.items() if not k.startswith("seconds_")}
        assert found == expected
        stages = {
            "operands", "octree_pairs", "curve_points", "cut_lines", "loops", "sub_surfaces",
            "sub_blocks", "split_meshes", "audit",
        }
        assert {f"seconds_{s}" for s in stages | {"core", "total"}} <= set(result)

    def test_subBlocksAreAuditedAndTheClaimHolds(self):
        split = Split(CUBE, SHEET)
        assert split.result["sub_blocks_closed"] is True
        assert split.result["volume_law_residual"] < 1e-15
        for number in range(split.result["sub_blocks"]):
            assert mesh_laws.unmatched_edges(*split.block(number)) == 0

    def test_privateAndPublicAreToldApart(self):
        result = Split(CUBE, SHEET).result
        assert result["sub_surfaces_first_public"].tolist() == [0, 0]
        assert result["sub_surfaces_first_boundary_cycles"].tolist() == [1, 1]
        outer = int(np.argmax(result["sub_surfaces_second_areas"]))
        assert result["sub_surfaces_second_public"][outer] == 1
        assert result["sub_surfaces_second_boundary_cycles"][outer] == 2
        assert result["sub_surfaces_second_separating"][outer] == 0
        assert result["sub_surfaces_second_separating"][1 - outer] == 1


class TestLaws:
    @pytest.mark.parametrize(
        "first, second, counts",
        [
            (CUBE, SHEET, (2, 2, 2)),
            (CUBE, box((-0.5, 0.25, 0.1), (1.5, 1.75, 2)), (2, 2, 3)),
            (CUBE, sphere((0.3, 0.2, 0.1), 0.4), (1, 1, 2)),
            (CUBE, sphere((5, 0, 0)), (1, 1, 2)),
            (joined(CUBE, sphere((4, 0, 0))), SHEET, (3, 2, 3)),
            (SHEET, bumpy_sheet((1, 0.1, 0.2), 0.1, 1.5, 7, 0.03), (1, 2, 0)),
        ],
        ids=("sheet", "box", "nested", "apart", "components", "sheets"),
    )
    def test_countsAndLaws(self, first, second, counts):
        split = Split(first, second)
        check_laws(split)
        assert split.counts() == counts

    def test_theFlippedSheetGivesTheSameBlocks(self):
        split, other = Split(CUBE, SHEET), Split(CUBE, flipped(*SHEET))
        for number in range(2):
            expected = mesh_laws.triangle_set(*split.block(number))
            assert np.array_equal(mesh_laws.triangle_set(*other.block(number)), expected)

    def test_threeProngsMakeThreePublicSubSurfaces(self):
        # A bar through both prongs of a U: between and beyond them it has parts with two loops.
        prongs = joined(box((-2, -0.5, -2), (-1, 0.5, 1)), box((1, -0.5, -2), (2, 0.5, 1)))
        split = Split(box((-3, -0.2, -0.3), (3, 0.25, 0.35)), prongs)
        check_laws(split)
        assert split.counts() == (5, 6, 7)
        assert split.result["sub_surfaces_first_public"].sum() == 3

    def test_aMoebiusStripHasOneSide(self):
        turns = np.linspace(0, 1, 41)[:-1]
        angle = 2 * np.pi * turns
        across = np.stack(
            [np.cos(angle / 2) * np.cos(angle), np.cos(angle / 2) * np.sin(angle),
             np.sin(angle / 2)], axis=1,
        )
        middle = np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1) * 2
        vertices = np.concatenate([middle - 0.3 * across, middle + 0.3 * across])
        faces = []
        for i in range(40):
            a, b = i, i + 40
            c, d = ((i + 1), (i + 41)) if i < 39 else (40, 0)
            faces += [(a, c, d), (a, d, b)]
        split = Split((vertices, np.array(faces)), box((-0.1, -4, -1), (0.15, -1.5, 1)))
        check_laws(split)
        assert split.counts() == (2, 1, 1)
        whole = Split((vertices, np.array(faces)), box((8, 8, 8), (9, 9, 9)))
        assert whole.result["sub_surfaces_first_one_sided"].tolist() == [1]


class TestDegeneratePlacements:
    """A unit of volume is that of the box (0, 0, 0) to (2, 2, 2): 8."""

    BOX = box((0, 0, 0), (2, 2, 2))

    def volumes(self, sheet, expected, counts=None):
        for surface in (sheet, flipped(*sheet)):
            split = Split(self.BOX, surface)
            check_laws(split)
            assert split.volumes() == pytest.approx(expected, rel=1e-14)
            if counts is not None:
                assert split.counts() == counts

    def test_aSheetWhoseBorderLiesOnTheSurface(self):
        self.volumes(square(0, 2, 0.5), [2, 6], (2, 1, 2))

    def test_aSheetThatEndsInsideSeparatesNothing(self):
        self.volumes(square(0.5, 1.5, 0.5), [8], (1, 1, 1))
        self.volumes(square(0.5, 3, 0.5), [8], (1, 2, 1))

    def test_aSheetCoplanarWithAWall(self):
        self.volumes(square(0, 2, 2), [8])
        self.volumes(square(-1, 3, 2), [8])
        self.volumes(square(0.5, 1.5, 2), [8])
        self.volumes(square(1, 3, 2), [8])

    def test_aSheetThatTouchesAtAVertex(self):
        self.volumes(square(2, 3, 2), [8], (1, 1, 1))
        tip = np.array([(1.0, 1, 2), (0, 0, 3), (2, 0, 3)]), np.array([(0, 1, 2)])
        self.volumes(tip, [8], (1, 1, 1))

    def test_aSheetThroughTheDiagonal(self):
        self.volumes(grid(2, 2, lambda u, v: (2 * u, 2 * v, 2 * u)), [4, 4], (2, 1, 2))

    def test_sheetsThatMeetAlongAnEdge(self):
        wing = np.array([(0.0, 0, 0), (0, 2, 0), (2, 0, 1), (2, 2, 1)]), [(0, 2, 3), (0, 3, 1)]
        other = np.array([(0.0, 0, 0), (0, 2, 0), (-2, 0, 1), (-2, 2, 1)]), [(0, 1, 3), (0, 3, 2)]
        split = Split((wing[0], np.array(wing[1])), (other[0], np.array(other[1])))
        check_laws(split)
        assert split.counts() == (1, 1, 0)

    def test_anOpenBoxClosedByItsLid(self):
        vertices, faces = self.BOX
        lid = np.all(vertices[faces][:, :, 2] == 2, axis=1)
        split = Split((vertices, faces[~lid]), (vertices, faces[lid]))
        check_laws(split)
        assert split.volumes() == pytest.approx([8])


class TestTransforms:
    def test_theMatrixIsAppliedAsIfTheVerticesHadBeenMoved(self):
        shift = translation(0.0625, 0.03125, -0.25)
        mesh_set = document(CUBE, SHEET)
        set_matrix(mesh_set, 1, shift)
        result = mesh_set.generate_index_boolean_split()
        moved = Split(CUBE, (SHEET[0] + shift[:3, 3], SHEET[1]))
        found = mesh_set.mesh(result["sub_blocks_layer"])
        assert np.array_equal(found.vertex_matrix(), moved.blocks.vertices)
        assert np.array_equal(found.face_matrix(), moved.blocks.faces)

    def test_aMirroredSolidGivesBlocksRightSideOut(self):
        mesh_set = mirrored_document()
        result = mesh_set.generate_index_boolean_split()
        assert result["sub_blocks_volumes"].sum() == pytest.approx(
            document_union_volume(), rel=1e-14
        )
        assert np.all(result["sub_blocks_volumes"] > 0)

    def test_aMirroredSheetGivesTheSameVolumes(self):
        mirror = np.diag((1.0, 1, -1, 1))
        mesh_set = document(CUBE, SHEET)
        for layer in (0, 1):
            set_matrix(mesh_set, layer, mirror)
        result = mesh_set.generate_index_boolean_split()
        expected = Split(CUBE, SHEET).volumes()
        assert np.sort(result["sub_blocks_volumes"]) == pytest.approx(expected, rel=1e-14)


def document_union_volume():
    """Of the two boxes of mirrored_document."""
    return mirrored_document().generate_index_boolean()["union_volume"]


class TestRefusals:
    def test_sameLayerTwice(self):
        message = refused(document(CUBE, SHEET), second_mesh=0)
        assert 'Layer "A" (id 0) is given as both first_mesh and second_mesh' in message

    def test_noSuchLayer(self):
        assert "There is no layer with id 7" in refused(document(CUBE, SHEET), second_mesh=7)

    def test_nothingAskedFor(self):
        message = refused(document(CUBE, SHEET), **{kind: False for kind in BLOCKS})
        assert "sub_surfaces_first, sub_surfaces_second, sub_blocks" in message

    @pytest.mark.parametrize("number", (0, 1001))
    def test_maxLayersOutOfRange(self, number):
        message = refused(document(CUBE, SHEET), max_layers=number)
        assert f"max_layers is {number}. Choose a number from 1 to 1000." in message

    def test_aSelfIntersectionIsFoundAndSelectedIfAsked(self):
        mesh_set = document(joined(SHEET, bumpy_sheet((1, 0, 0.1), 0.2, 1, 5)), CUBE)
        with pytest.raises(pymeshlab.PyMeshLabException, match="intersects itself"):
            mesh_set.generate_index_boolean_split(self_intersections="refuse")
        assert selected_faces(mesh_set, 0)

    def test_theBooleanNamesThisFilterForAnOpenOperand(self):
        with pytest.raises(pymeshlab.PyMeshLabException) as refusal:
            document(CUBE, SHEET).generate_index_boolean()
        assert "generate_index_boolean_split" in str(refusal.value)
        assert 'Layer "B" (id 1) is not closed' in str(refusal.value)

    def test_twoCappedSidesComeFromASolidAndASheet(self):
        split = Split(CUBE, SHEET)
        assert split.volumes().sum() == pytest.approx(8, rel=1e-14)
