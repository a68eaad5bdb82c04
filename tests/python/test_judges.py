# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The judges find what is put into a mesh by hand, and nothing in a mesh that holds."""

import numpy as np
import pytest

import judges
import mesh_laws
import sample_catalogue
from conftest import box, crossing_bars, joined, sphere
from contact_cases import boxes_of_one_colour, rotated, scaled, shifted, soup, with_faces

CUBE = box((0, 0, 0), (2, 2, 2))
TURNED = rotated(CUBE, (1, 2, 3), 0.7)
NEEDS_CGAL = pytest.mark.skipif(
    not judges.CGAL_PROGRAM.is_file(), reason="CGAL's judge is not built (Debian: libcgal-dev)"
)


def with_vertex_in_face(mesh, face, weights):
    """The mesh with a face cut in three at a point of it."""
    vertices, faces = mesh
    a, b, c = faces[face]
    point, new = np.array(weights) @ vertices[faces[face]], len(vertices)
    pieces = [(a, b, new), (b, c, new), (c, a, new)]
    return np.vstack([vertices, point]), np.vstack([np.delete(faces, face, 0), pieces])


def with_needle(mesh, height=1e-16):
    """The mesh with a point that lies beside the middle of an edge, beyond it if height < 0."""
    return with_vertex_in_face(mesh, 0, (0.5 - height / 2, 0.5 - height / 2, height))


def with_flap(mesh, face, weights):
    """The mesh, and two faces that lie one on the other, joined to an edge of a face."""
    vertices, faces = mesh
    a, b, _ = faces[face]
    point, new = np.array(weights) @ vertices[faces[face]], len(vertices)
    return np.vstack([vertices, point]), np.vstack([faces, [(a, b, new), (b, a, new)]])


def pinched(turn):
    """Two cubes that have an edge in common, or a corner."""
    return turn(joined(CUBE, shifted(CUBE, 2, 2, 0))), turn(joined(CUBE, shifted(CUBE, 2, 2, 2)))


GOOD = {
    "cube": CUBE,
    "turned cube": TURNED,
    "ball": sphere(),
    "large ball": scaled(sphere(), 1e30),
    "small ball": scaled(sphere(), 1e-30),
    "copies of vertices": soup(CUBE),
    "copies of vertices, turned": soup(TURNED),
    "cubes at an edge": pinched(lambda mesh: mesh)[0],
    "cubes at a corner": pinched(lambda mesh: mesh)[1],
    "checkerboard": boxes_of_one_colour(3, 0),
    "copies, negative zeros": (soup(CUBE)[0] * (1, -1, 1) * (1, -1, 1), soup(CUBE)[1]),
    "sheet of one face": (CUBE[0], CUBE[1][:1]),
    "vertex in a face": with_vertex_in_face(CUBE, 0, (0.5, 0.25, 0.25)),
    "nothing": (np.empty((0, 3)), np.empty((0, 3), dtype=np.int64)),
}
# name: (mesh, what some of its faces are)
BAD = {
    "bars that cross": (crossing_bars(), "crossing"),
    "cubes with half a wall in common": (joined(CUBE, shifted(CUBE, 2, 1, 0)), "crossing"),
    "cubes that touch in the middle of an edge": (
        joined(CUBE, shifted(scaled(CUBE, 0.5), 2, 2, 0.25)), "crossing"
    ),
    "a corner on a face": (
        (np.vstack([CUBE[0], (0.5, 0.75, 2), (0, 0, 3), (1, 0, 3)]),
         np.vstack([CUBE[1], (8, 9, 10)])), "crossing"
    ),
    "point beyond the edge": (with_vertex_in_face(CUBE, 0, (0.625, 0.5, -0.125)), "folded"),
    "flap on a face": (with_flap(CUBE, 0, (0.375, 0.375, 0.25)), "folded"),
    "each face twice": (with_faces(CUBE, *CUBE[1]), "folded"),
    "each face and its reverse": (with_faces(CUBE, *CUBE[1][:, ::-1]), "folded"),
    "a face twice, in copies": (joined(CUBE, (CUBE[0], CUBE[1][:1])), "folded"),
    "point on an edge": (with_vertex_in_face(CUBE, 0, (0.5, 0.5, 0)), "flat"),
    "two equal corners": (with_faces(CUBE, (3, 3, 7)), "collapsed"),
    "equal corners, in copies": (
        joined(CUBE, (CUBE[0][[3, 3, 7]], np.array([[0, 1, 2]]))), "collapsed"
    ),
}


@pytest.mark.parametrize("name", GOOD)
def test_aMeshThatHoldsIsFoundToHold(name):
    verdict = judges.judge(*GOOD[name])
    assert not verdict.wrong and verdict.needles == 0, verdict


@pytest.mark.parametrize("name", BAD)
def test_whatIsPutInByHandIsFound(name):
    mesh, kind = BAD[name]
    verdict = judges.judge(*mesh)
    assert getattr(verdict, kind), verdict


def test_theFacesThatFoldAreNamed():
    mesh = with_vertex_in_face(TURNED, 0, (0.625, 0.5, -0.125))
    points, faces = mesh
    points[:, 2] = 0.0  # all in one plane: only what overlaps beside its edges is found by folds
    flat = points, faces[-3:]
    assert judges.judge(*flat).folded == {0, 1, 2}
    beside = with_vertex_in_face((points[:-1], faces[:1]), 0, (0.25, 0.25, 0.5))
    assert not judges.judge(*beside).wrong


def test_aNeedleFailsWhereItTurnsOver():
    """Its height is far below the spacing of its coordinates."""
    ends = np.array([(0.1, 0.2, 0.3), (0.7, 0.9, 0.4)])
    tip, back = (0.5, 0.1, 0.9), (0.2, 0.8, 0.1)
    middles = ends.mean(axis=0) + np.array([(x, y, 0) for x in (-1, 0, 1) for y in (-1, 0, 1)]) * (
        np.spacing(0.4)
    )
    found = []
    for middle in middles:
        points = np.vstack([ends, middle, tip, back])
        verdict = judges.judge(points, [(0, 2, 3), (2, 1, 3), (0, 1, 2), (1, 0, 4)])
        assert verdict.needles == 1
        found.append(bool(verdict.wrong))
    assert any(found), "no rounding made the needle meet a neighbour"


def test_aNeedleAndAnAngleAreMeasured():
    mesh = with_needle(CUBE, 1e-12)
    assert judges.judge(*mesh).needles == 1
    angles = judges.smallest_angles(*mesh)
    assert np.sort(angles)[:2] == pytest.approx([0, 18.4349], abs=1e-3)
    assert judges.smallest_angles(*CUBE) == pytest.approx(np.full(12, 45.0))
    assert judges.smallest_angles(*scaled(CUBE, 1e-30)) == pytest.approx(np.full(12, 45.0))
    thirty = np.array([(0, 0, 0), (np.sqrt(3), 0, 0), (0, 1, 0)])
    assert judges.smallest_angles(thirty, [(0, 1, 2)]) == pytest.approx([30])


def test_asFloatIsTheMeshThatAReaderOfFloatsHas():
    mesh = with_needle(shifted(CUBE, 1, 1, 1), 1e-9)
    assert not judges.judge(*mesh).wrong
    assert judges.judge_as_float(*mesh).flat, "the point is on the edge as a float"
    tiny = joined(CUBE, shifted(scaled(CUBE, 1e-9), 5.1, 5.2, 5.3))
    assert not judges.judge(*tiny).wrong
    assert not judges.judge_as_float(*tiny).wrong, "its corners fall together, and it is gone"


@pytest.mark.parametrize("name", sample_catalogue.REASONS)
def test_samplesHold(name):
    verdict = judges.judge(*sample_catalogue.sample(name))
    assert not verdict.wrong and verdict.needles == 0, verdict


@NEEDS_CGAL
@pytest.mark.parametrize("options", [(), ("--soup",)], ids=["manifold", "soup"])
@pytest.mark.parametrize("name", GOOD)
def test_cgalFindsNothingEither(name, options):
    assert not judges.cgal_faces(*GOOD[name], *options)


@NEEDS_CGAL
@pytest.mark.parametrize("options", [(), ("--soup",)], ids=["manifold", "soup"])
@pytest.mark.parametrize("name", BAD)
def test_cgalFindsTheSameFaces(name, options):
    mesh, kind = BAD[name]
    verdict = judges.judge(*mesh)
    found = judges.cgal_faces(*mesh, *options)
    assert found
    # Whether what lies beside a flat face is at fault, too, each library says in its own way.
    if verdict.flat:
        assert verdict.flat <= found
    else:
        assert found == verdict.wrong


@NEEDS_CGAL
def test_cgalNumbersTheFacesOfAManifoldAsGiven():
    bars = crossing_bars()
    found = judges.cgal_faces(*bars)
    assert found == judges.cgal_faces(*bars, "--soup") == judges.judge(*bars).wrong
    assert mesh_laws.unmatched_edges(*bars) == 0
