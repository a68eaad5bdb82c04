# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The checks themselves: each finds the defect it is made for, and only that."""

from fractions import Fraction

import numpy as np
import pytest

import contact_filter
import mesh_laws
import oracles
from conftest import box, joined, sphere

UNIT_BOX = box((0, 0, 0), (1, 1, 1))


def test_boxIsClosedWeldedOrNot():
    vertices, faces = UNIT_BOX
    assert mesh_laws.unmatched_edges(vertices, faces) == 0
    assert mesh_laws.unmatched_edges(vertices[faces.ravel()], np.arange(36).reshape(-1, 3)) == 0


def test_missingAndTurnedFacesLeaveEdgesUnmatched():
    vertices, faces = UNIT_BOX
    assert mesh_laws.unmatched_edges(vertices, faces[1:]) == 3
    turned = np.concatenate([faces[:-1], mesh_laws.reversed_faces(faces[-1:])])
    assert mesh_laws.unmatched_edges(vertices, turned) == 6


def test_edgeOfFourFacesIsClosedButNoManifold():
    vertices, faces = joined(UNIT_BOX, box((1, 1, 0), (2, 2, 1)))
    assert mesh_laws.unmatched_edges(vertices, faces) == 0
    points, faces = mesh_laws.welded(vertices, faces)
    assert len(points) == 14
    assert not mesh_laws.is_edge_manifold(faces)


def test_vertexOfTwoUmbrellasIsNoManifold():
    assert mesh_laws.is_manifold(sphere()[1])
    vertices, faces = joined(UNIT_BOX, box((1, 1, 1), (2, 2, 2)))
    assert mesh_laws.is_manifold(faces)
    _, faces = mesh_laws.welded(vertices, faces)
    assert mesh_laws.is_edge_manifold(faces)
    assert not mesh_laws.is_manifold(faces)
    assert not mesh_laws.is_manifold(faces[1:])


def test_coincidingFacesAreFoundEitherWayRound():
    vertices, faces = UNIT_BOX
    assert mesh_laws.coinciding_faces(*joined(UNIT_BOX, box((1, 1, 0), (2, 2, 1)))) == 0
    assert mesh_laws.coinciding_faces(*joined(UNIT_BOX, box((1, 0, 0), (2, 1, 1)))) == 4
    assert mesh_laws.coinciding_faces(vertices, np.concatenate([faces, faces[:3, [1, 2, 0]]])) == 6


def test_edgeBetweenCopiesIsFound():
    vertices, faces = UNIT_BOX
    assert mesh_laws.coincident_ends(*joined(UNIT_BOX, UNIT_BOX)) == 0
    copied = np.concatenate([vertices, vertices[:1]])
    assert mesh_laws.coincident_ends(copied, np.concatenate([faces, [(0, 8, 1), (8, 0, 3)]])) == 2


def test_exactVolumeSeesTheLastBit():
    vertices, faces = box((0, 0, 0), (1, 1, 1 + 2.0**-52))
    assert mesh_laws.exact_volume(vertices, faces) == 1 + Fraction(1, 2**52)
    faces = [(0, 1, 2), (0, 3, 1), (0, 2, 3), (1, 3, 2)]
    assert mesh_laws.exact_volume(np.eye(4, 3), faces) == Fraction(1, 6)


def test_zeroAreaIsDecidedExactly():
    last_bit = np.nextafter(0.3, 1)
    vertices = np.array(
        [
            [0, 0, 0],
            [0.1, 0.1, 0.1],
            [0.3, 0.3, 0.3],
            [0.3, 0.3, last_bit],
            [1e-200, 0, 0],
            [0, 1e-200, 0],
            [2e-200, 0, 0],
            [1e200, 0, 0],
            [0, 1e200, 0],
        ]
    )
    faces = [(0, 1, 2), (0, 1, 3), (0, 4, 5), (0, 4, 6), (0, 7, 8), (1, 1, 2)]
    assert mesh_laws.zero_area_faces(vertices, faces).tolist() == [0, 3, 5]


def test_volumeAndAreaAreThoseOfTheBoxFarFromTheOrigin():
    vertices, faces = box((1000, 2000, 3000), (1001, 2002, 3004))
    assert mesh_laws.volume(vertices, faces) == 8
    assert mesh_laws.area(vertices, faces) == 28
    assert mesh_laws.volume(vertices, mesh_laws.reversed_faces(faces)) == -8


def test_componentsAndGenusAreCounted():
    vertices, faces = joined(UNIT_BOX, sphere((5, 0, 0)), sphere((9, 0, 0), subdivisions=1))
    assert mesh_laws.component_count(faces, len(vertices)) == 3
    assert mesh_laws.euler_number(faces) == 6
    assert mesh_laws.genus(faces, len(vertices)) == 0


def test_triangleSetForgetsNumberingOnly():
    vertices, faces = sphere(subdivisions=2)
    order = np.random.default_rng(1).permutation(len(vertices))
    renumbered = np.argsort(order)[np.roll(faces[::-1], 1, axis=1)]
    expected = mesh_laws.triangle_set(vertices, faces)
    assert np.array_equal(mesh_laws.triangle_set(vertices[order], renumbered), expected)
    turned = mesh_laws.triangle_set(vertices, mesh_laws.reversed_faces(faces))
    assert not np.array_equal(turned, expected)
    moved = vertices.copy()
    moved[0, 0] = np.nextafter(moved[0, 0], 2)
    assert not np.array_equal(mesh_laws.triangle_set(moved, faces), expected)


def test_windingNumbersCountShells():
    vertices, faces = joined(UNIT_BOX, box((0.25, 0.25, 0.25), (0.75, 0.75, 0.75)))
    points = [(0.51, 0.43, 0.52), (0.12, 0.43, 0.52), (1.12, 0.43, 0.52), (0.51, 0.43, -3)]
    numbers, decided = mesh_laws.winding_numbers(points, vertices, faces)
    assert decided.all()
    assert numbers.tolist() == [2, 1, 0, 0]
    # The ray through the middle meets the diagonal of a wall.
    assert not mesh_laws.winding_numbers([(0.5, 0.5, 0.4)], vertices, faces)[1][0]


@pytest.mark.parametrize("seed", range(6))
def test_boxPairsAreThoseOfAllPairs(seed):
    rng = np.random.default_rng(seed)
    corners = []
    for count in rng.integers(100, 600, 2):
        size = rng.choice([0.01, 0.1, 1.0], (count, 1, 1))
        corners.append(rng.random((count, 1, 3)) + size * rng.random((count, 3, 3)))
    if seed % 2:
        corners = [np.round(8 * part) / 8 for part in corners]
    (low_a, high_a), (low_b, high_b) = ((part.min(axis=1), part.max(axis=1)) for part in corners)
    meet = np.all((low_a[:, None] <= high_b) & (low_b <= high_a[:, None]), axis=2)
    pairs = contact_filter.overlapping_boxes(*corners)
    assert sorted(map(tuple, pairs.tolist())) == list(map(tuple, np.argwhere(meet).tolist()))


def test_oracleSeesAnOperandThatMeetsItself():
    assert oracles.is_embedded(*UNIT_BOX)
    assert not oracles.is_embedded(*joined(UNIT_BOX, box((0.5, 0.5, 0.5), (2, 2, 2))))


def test_oraclesAgreeOnBoxes():
    operands = (*UNIT_BOX, *box((0.5, 0.25, 0.125), (2, 2, 2)))
    expected = {
        "union": 1 + 1.5 * 1.75 * 1.875 - 0.5 * 0.75 * 0.875,
        "intersection": 0.5 * 0.75 * 0.875,
        "first_minus_second": 1 - 0.5 * 0.75 * 0.875,
        "second_minus_first": 1.5 * 1.75 * 1.875 - 0.5 * 0.75 * 0.875,
    }
    for blocks in (oracles.manifold_blocks(*operands), oracles.libigl_blocks(*operands)):
        assert oracles.volumes(blocks) == pytest.approx(expected, rel=1e-14)
