# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Quads in, quads out: polygons of triangles with faux edges, through the filter."""

import collections

import numpy as np
import pymeshlab
import pytest

import indexboolean
import mesh_laws
from conftest import box

BLOCKS = ("union", "intersection", "first_minus_second", "second_minus_first")
RINGS, SECTORS = 16, 24


def quad_sphere():
    """A unit sphere of latitude and longitude: quads, and triangles at the poles."""
    latitude = np.pi * np.arange(1, RINGS) / RINGS
    longitude = 2 * np.pi * np.arange(SECTORS) / SECTORS
    ring = np.stack([np.cos(longitude), np.sin(longitude)])
    rows = [
        np.stack([*(np.sin(t) * ring), np.full(SECTORS, np.cos(t))], axis=1) for t in latitude
    ]
    vertices = np.concatenate([*rows, [(0, 0, 1), (0, 0, -1)]])
    north, south = len(vertices) - 2, len(vertices) - 1
    last = (RINGS - 2) * SECTORS
    faces = []
    for j in range(SECTORS):
        k = (j + 1) % SECTORS
        faces += [[north, j, k], [south, last + k, last + j]]
        for i in range(0, last, SECTORS):
            faces.append([i + j, i + SECTORS + j, i + SECTORS + k, i + k])
    return vertices, faces


def quad_box(low, high):
    vertices, triangles = box(low, high)
    quads = []
    for axis in range(3):
        for side in (low, high):
            corners = {v for v in range(8) if vertices[v][axis] == side[axis]}
            a, b = (t for t in triangles if corners.issuperset(t))
            while a[0] in b:
                a = np.roll(a, 1)
            apex = next(v for v in b if v not in a)
            quads.append([int(v) for v in (a[0], a[1], apex, a[2])])
    return vertices, quads


def document(*meshes):
    indexboolean.load_plugin()
    mesh_set = pymeshlab.MeshSet()
    for vertices, faces in meshes:
        mesh_set.add_mesh(pymeshlab.Mesh(vertex_matrix=vertices, face_list_of_indices=faces))
    return mesh_set


def polygons_of(mesh):
    """How many polygons have which corners."""
    points = mesh.vertex_matrix()
    return collections.Counter(
        frozenset(map(tuple, points[list(polygon)])) for polygon in mesh.polygonal_face_list()
    )


def sizes_of(mesh):
    return dict(collections.Counter(map(len, mesh.polygonal_face_list())))


def test_uncutQuadsOfASphereMinusABoxStayQuads():
    low = np.array((0.125, 0.1875, 0.3125))
    mesh_set = document(quad_sphere(), quad_box(low, (2, 2, 2)))
    given = polygons_of(mesh_set.mesh(0))
    assert len(given) == SECTORS * RINGS
    result = mesh_set.generate_index_boolean()
    # Beyond a wall of the box, nothing is cut; with all corners in the box, nothing is left.
    beyond = {p for p in given if np.any(np.max(list(p), axis=0) < low)}
    within = {p for p in given if np.all(np.min(list(p), axis=0) > low)}
    assert (len(beyond), len(within)) == (352, 12)
    for block, kept, gone, cut_walls in (
        ("first_minus_second", beyond, within, 3),
        ("union", beyond, within, 0),
        ("intersection", within, beyond, 3),
        ("second_minus_first", within, beyond, 0),
    ):
        mesh = mesh_set.mesh(result[f"{block}_layer"])
        got = polygons_of(mesh)
        assert kept <= set(got) and not gone & set(got)
        assert mesh_laws.unmatched_edges(mesh.vertex_matrix(), mesh.face_matrix()) == 0
        # What the sphere cuts off each wall at the box's corner is one polygon.
        assert sum(tuple(low) in polygon for polygon in got) == cut_walls


@pytest.mark.parametrize("separate", (False, True))
def test_piecesOfASplitKeepTheirQuads(separate):
    """Uncut quads stay; a cut wall of the box is a polygon on each side of the cut."""
    wall = np.array([(0.5, -2, -2), (0.5, 2, -2), (0.5, 2, 2), (0.5, -2, 2)]), [[0, 1, 2, 3]]
    mesh_set = document(quad_box((0, -1, -1), (1, 1, 1)), wall)
    result = mesh_set.generate_index_boolean_split(separate_layers=separate)
    surfaces = [mesh_set.mesh(int(k)) for k in result["sub_surfaces_first_layers"]]
    blocks = [mesh_set.mesh(int(k)) for k in result["sub_blocks_layers"]]
    halves = {4: 1, 5: 4}  # an uncut wall, and half of each of four with a point on its diagonal
    both = [{4: 2, 5: 8}]
    assert [sizes_of(mesh) for mesh in surfaces] == ([halves] * 2 if separate else both)
    closed = {**halves, 8: 1}  # and the part of the sheet that closes it
    both = [{4: 2, 5: 8, 8: 2}]
    assert [sizes_of(mesh) for mesh in blocks] == ([closed] * 2 if separate else both)
    for mesh in blocks:
        assert mesh_laws.unmatched_edges(mesh.vertex_matrix(), mesh.face_matrix()) == 0


def test_aSphereOfQuadsCutByASheetKeepsUncutOnes():
    sheet = np.array([(-2, -2, 0.3), (2, -2, 0.3), (2, 2, 0.3), (-2, 2, 0.3)]), [[0, 1, 2, 3]]
    mesh_set = document(quad_sphere(), sheet)
    given = polygons_of(mesh_set.mesh(0))
    heights = {polygon: [z for _, _, z in polygon] for polygon in given}
    uncut = {polygon for polygon, z in heights.items() if min(z) > 0.3 or max(z) < 0.3}
    assert len(uncut) == len(given) - SECTORS
    result = mesh_set.generate_index_boolean_split()
    for kind in ("sub_surfaces_first", "sub_blocks"):
        got = polygons_of(mesh_set.mesh(result[f"{kind}_layer"]))
        assert uncut <= set(got)


def test_aBoxOfQuadsCutByAnotherHasNoNeedlessPoint():
    mesh_set = document(quad_box((0, 0, 0), (4, 4, 4)), quad_box((2, 2, 2), (5, 5, 5)))
    result = mesh_set.generate_index_boolean()
    blocks = [mesh_set.mesh(result[f"{block}_layer"]) for block in BLOCKS]
    corner = {4: 6, 6: 3}
    assert [sizes_of(mesh) for mesh in blocks] == [{4: 6, 6: 6}, {4: 6}, corner, corner]
    # Corners of the solid, no others: as few triangles as with coplanar faces merged.
    assert [mesh.face_number() for mesh in blocks] == [36, 12, 24, 24]


@pytest.mark.parametrize("name", ("result.obj", "result.off"))
def test_savedFilesHaveTheQuads(tmp_path, name):
    mesh_set = document(quad_box((0, 0, 0), (4, 4, 4)), quad_box((-1, -1, 2), (5, 5, 5)))
    result = mesh_set.generate_index_boolean()
    mesh_set.set_current_mesh(result["first_minus_second_layer"])
    mesh_set.save_current_mesh(str(tmp_path / name))
    again = pymeshlab.MeshSet()
    again.load_new_mesh(str(tmp_path / name))
    assert sizes_of(again.current_mesh()) == {4: 6}


def test_trianglesStayTriangles():
    operands = box((0, 0, 0), (4, 4, 4)), box((2, 2, 2), (5, 5, 5))
    mesh_set = document(*[(vertices, faces.tolist()) for vertices, faces in operands])
    result = mesh_set.generate_index_boolean()
    for block in BLOCKS:
        mesh = mesh_set.mesh(result[f"{block}_layer"])
        assert sizes_of(mesh) == {3: mesh.face_number()}
        assert mesh_laws.unmatched_edges(mesh.vertex_matrix(), mesh.face_matrix()) == 0
