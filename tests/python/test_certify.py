# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the filters say of results as stored: keys, log, selection, and what is written to files."""

import json
import subprocess
import sys

import numpy as np
import pymeshlab
import pytest

import chain_kinds
import contact_cases
import judges
from conftest import box, document
from run_boolean import BLOCKS, run_boolean
from split_run import Split
from test_filter import log_of

FIRST = box((0, 0, 0), (2, 2, 2))
SECOND = box((1, 1.125, 1.25), (2.5, 2.625, 2.75))
SHEET = box((0.1, -1, 0.3), (1.7, 3, 1.1))  # its coordinates are no floats
KEYS = ("repair_rounds", "moved_vertices", "largest_move", "volume_change", "vanished_components")


def grid_with_its_last_box():
    """Turned boxes in a grid, united, and the box that is subtracted last: its walls are nearly
    coplanar with so many others that faces of the difference meet others wrongly."""
    chain = chain_kinds.make_chain("grid_any_8", 6)
    mesh, steps = chain.start, list(chain.steps)
    for step in steps[:-1]:
        wanted = {block: block == step.operation for block in BLOCKS}
        mesh = run_boolean(*mesh, *step.operand, **wanted)[step.operation]
    return document(mesh, steps[-1].operand)


class TestBlocks:
    def test_whatHoldsIsCertified(self):
        result = run_boolean(*FIRST, *SHEET)["result"]
        for block in BLOCKS:
            assert result[f"{block}_self_intersections"] == 0
            assert [result[f"{block}_{key}"] for key in KEYS] == [0] * len(KEYS)
        log = log_of("document(FIRST, SECOND)")
        assert "Certified: as stored in double precision, the faces of each of the 4 new" in log

    def test_withoutCertifyNothingIsKnown(self):
        result = run_boolean(*FIRST, *SHEET, certify=False)["result"]
        for block in BLOCKS:
            assert result[f"{block}_self_intersections"] == -1
            assert not [key for key in KEYS if f"{block}_{key}" in result]
        assert "ertified" not in log_of("document(FIRST, SECOND)", parameters="certify=False")

    def test_asFloatAllCoordinatesAreFloats(self):
        blocks = run_boolean(*FIRST, *SHEET, certify_as="float")
        for block in BLOCKS:
            vertices, faces = blocks[block]
            assert np.array_equal(vertices, vertices.astype(np.float32))
            assert blocks["result"][f"{block}_self_intersections"] == 0
            assert not judges.judge(vertices, faces).wrong
        given = set(map(tuple, run_boolean(*FIRST, *SHEET)["union"][0]))
        assert given - set(map(tuple, blocks["union"][0])), "as doubles they are others"
        log = log_of("document(FIRST, SECOND)", parameters='certify_as="float"')
        assert "as stored in single precision" in log

    def test_whatFloatsCannotHoldIsRefused(self):
        far = box((1e39, 0, 0), (2e39, 1e39, 1e39))
        with pytest.raises(pymeshlab.PyMeshLabException, match='"first" \\(id 0\\)'):
            run_boolean(*far, *SECOND, certify_as="float")
        assert run_boolean(*far, *SECOND)["result"]["union_self_intersections"] == 0

    def test_facesThatDoNotHoldAreSelectedAndNoOthers(self):
        meshes = grid_with_its_last_box()
        meshes.set_current_mesh(0)
        meshes.set_selection_all()
        result = meshes.generate_index_boolean()
        mesh = meshes.mesh(int(result["first_minus_second_layer"]))
        wrong = judges.judge(mesh.vertex_matrix(), mesh.face_matrix()).wrong
        assert result["first_minus_second_self_intersections"] == len(wrong) > 0
        assert set(np.flatnonzero(mesh.face_selection_array()).tolist()) == set(wrong)
        log = log_of('__import__("test_certify").grid_with_its_last_box()')
        assert "others wrongly, as stored in double precision. They are selected" in log

    def test_repairSaysWhatItMoved(self):
        case = contact_cases.load_case("tori of the same inner radius")
        result = run_boolean(*case.first, *case.second)["result"]
        assert all(result[f"{block}_self_intersections"] == 0 for block in BLOCKS)
        assert result["union_moved_vertices"] > 0 and result["union_repair_rounds"] > 0
        assert 0 < result["union_largest_move"] < 1e-14
        assert abs(result["union_volume_change"]) < 1e-14


class TestPieces:
    def test_eachPieceHasItsOwnCertificate(self):
        result = Split(FIRST, SHEET).result
        for kind in ("sub_surfaces_first", "sub_surfaces_second", "sub_blocks"):
            assert result[f"{kind}_self_intersections"].tolist() == [0] * result[kind]

    def test_withoutCertifyNothingIsKnown(self):
        result = Split(FIRST, SHEET, certify=False).result
        assert result["sub_blocks_self_intersections"].tolist() == [-1] * result["sub_blocks"]


class TestCommandLine:
    @staticmethod
    def run(folder, *options):
        """result.json of the command boolean on FIRST and SHEET."""
        files = []
        for name, mesh in (("first", FIRST), ("second", SHEET)):
            files.append(folder / f"{name}.ply")
            meshes = document(mesh, mesh)
            meshes.set_current_mesh(0)
            meshes.save_current_mesh(str(files[-1]))
        command = [sys.executable, "-m", "indexboolean", "boolean", *files, "-o", folder, *options]
        subprocess.run(command, check=True, capture_output=True, timeout=60)
        return json.loads((folder / "result.json").read_text())

    def test_noCertify(self, tmp_path):
        assert '"union_self_intersections": -1' in json.dumps(self.run(tmp_path, "--no-certify"))

    def test_stlIsCertifiedAsWhatIsReadBack(self, tmp_path):
        record = json.dumps(self.run(tmp_path, "--format", "stl"))
        expected = run_boolean(*FIRST, *SHEET, certify_as="float")
        assert '"union_self_intersections": 0' in record
        for block in BLOCKS:
            meshes = pymeshlab.MeshSet()
            meshes.load_new_mesh(str(tmp_path / f"{block}.stl"))
            read = set(map(tuple, meshes.current_mesh().vertex_matrix()))
            assert read == set(map(tuple, expected[block][0]))
