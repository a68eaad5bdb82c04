# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the filters say of results as stored: keys, log, selection, and what is written to files."""

import json
import subprocess
import sys

import numpy as np
import pymeshlab
import pytest

import contact_cases
import judges
from conftest import box, document
from run_boolean import BLOCKS, run_boolean
from split_run import Split
from test_filter import log_of

FIRST = box((0, 0, 0), (2, 2, 2))
SECOND = box((1, 1.125, 1.25), (2.5, 2.625, 2.75))
SHEET = box((0.1, -1, 0.3), (1.7, 3, 1.1))  # its coordinates are no floats
# Corners on whole numbers that, as floats, can be nothing else: faces that meet others wrongly are
# left where one or three of the solids are.
FAR_OFF = 2.0**23
CORNERS = (
    [(10, 3, 10), (3, 1, 8), (3, 5, 3), (1, 5, 7)],
    [(7, 11, 8), (0, 0, 5), (4, 2, 12), (9, 1, 10)],
    [(5, 1, 6), (10, 3, 4), (5, 9, 9), (1, 0, 6)],
)
KEYS = ("repair_rounds", "moved_vertices", "largest_move", "volume_change", "vanished_components")


def tetrahedron(corners):
    """The tetrahedron, right side out, far from the origin."""
    vertices = np.array(corners, dtype=np.float64)
    faces = np.array([(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)])
    if np.linalg.det(vertices[1:] - vertices[0]) < 0:
        faces = faces[:, ::-1]
    return vertices + FAR_OFF, faces


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
        meshes = document(*map(tetrahedron, CORNERS))
        meshes.set_current_mesh(0)
        meshes.set_selection_all()
        asked = {"expression": "xor(all)", "certify_as": "float"}
        result = meshes.generate_index_boolean_expression(**asked)
        mesh = meshes.mesh(int(result["result_0_layer"]))
        wrong = judges.judge(mesh.vertex_matrix(), mesh.face_matrix()).wrong
        assert result["result_0_self_intersections"] == len(wrong)
        assert set(np.flatnonzero(mesh.face_selection_array()).tolist()) == set(wrong)
        made = '__import__("test_certify")'
        log = log_of(
            f"document(*map({made}.tetrahedron, {made}.CORNERS))",
            "generate_index_boolean_expression",
            ", ".join(f"{name}={value!r}" for name, value in asked.items()),
        )
        told = "others wrongly, as stored in single precision. They are selected" in log
        assert told == bool(wrong)

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
