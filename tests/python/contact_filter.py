# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Which faces of two meshes certainly do not meet, by boxes and signs beyond rounding error.

Shares nothing with the library under test. One-sided: a face called uncut is uncut; a face that is
not called so may be.
"""

import numpy as np

from mesh_laws import as_mesh

_UNIT_ROUNDOFF = 2.0**-53


# A node with at most so many pairs tries them all.
_LEAF_PAIRS = 20_000


def overlapping_boxes(first_corners, second_corners):
    """The pairs of triangles (m x 3 x 3 corners) whose closed bounding boxes meet: k x 2.

    By halving space along the axis that parts the boxes best, while that leaves fewer pairs. A
    pair is kept by the half that holds the low corner of the boxes' overlap.
    """
    boxes = [
        np.concatenate([corners.min(axis=1), corners.max(axis=1)], axis=1)
        for corners in (first_corners, second_corners)
    ]
    everything = np.array([-np.inf] * 3), np.array([np.inf] * 3)
    nodes = [(np.arange(len(boxes[0])), np.arange(len(boxes[1])), *everything)]
    found = [np.empty((0, 2), dtype=np.int64)]
    while nodes:
        first, second, low, high = nodes.pop()
        a, b = boxes[0][first], boxes[1][second]
        if len(first) == 0 or len(second) == 0:
            continue
        halves = _halves(a, b, low, high) if len(a) * len(b) > _LEAF_PAIRS else None
        if halves is None:
            i, j = _pairs_in_leaf(a, b, low, high)
            found.append(np.stack([first[i], second[j]], axis=1))
        else:
            nodes += [(first[in_a], second[in_b], *ends) for in_a, in_b, *ends in halves]
    return np.concatenate(found)


def _halves(a, b, low, high):
    # The best cut at a median of box middles, or None if every cut leaves nearly as many pairs.
    best, fewest = None, 0.8 * len(a) * len(b)
    for axis in range(3):
        for boxes in (a, b):
            cut = float(np.median(boxes[:, axis] + boxes[:, axis + 3]) / 2)
            below, above = high.copy(), low.copy()
            below[axis], above[axis] = min(cut, high[axis]), max(cut, low[axis])
            masks = [(box[:, axis] <= cut, box[:, axis + 3] >= cut) for box in (a, b)]
            pairs = sum(int(in_a.sum()) * int(in_b.sum()) for in_a, in_b in zip(*masks))
            if pairs < fewest:
                fewest = pairs
                best = (
                    (masks[0][0], masks[1][0], low, below),
                    (masks[0][1], masks[1][1], above, high),
                )
    return best


def _pairs_in_leaf(a, b, low, high):
    found = []
    for part in np.array_split(np.arange(len(a)), 1 + len(a) * len(b) // 1_000_000):
        start = np.maximum(a[part, None, :3], b[None, :, :3])
        end = np.minimum(a[part, None, 3:], b[None, :, 3:])
        owned = np.all((start <= end) & (start >= low) & (start < high), axis=2)
        i, j = np.nonzero(owned)
        found.append((part[i], j))
    return [np.concatenate(column) for column in zip(*found)]


def certain_sides(planes, points):
    """The side of each point (k x 3) of the plane through three points (k x 3 x 3).

    -1 or 1, or 0 where rounding error leaves the sign open.
    """
    a, b, c = (planes[:, corner] - points for corner in range(3))
    determinant, magnitude = np.zeros(len(points)), np.zeros(len(points))
    for i in range(3):
        left, right = b[:, i - 2] * c[:, i - 1], b[:, i - 1] * c[:, i - 2]
        determinant += a[:, i] * (left - right)
        magnitude += np.abs(a[:, i]) * (np.abs(left) + np.abs(right))
    certain = np.abs(determinant) > 16 * _UNIT_ROUNDOFF * magnitude + 1e-300
    return np.where(certain, np.sign(determinant), 0).astype(np.int64)


def vertex_plane_sides(pairs, first_corners, second_corners):
    """For each pair, the sides of the first's corners of the second's plane, and vice versa."""
    first, second = first_corners[pairs[:, 0]], second_corners[pairs[:, 1]]
    of_first = np.stack([certain_sides(second, first[:, corner]) for corner in range(3)], axis=1)
    of_second = np.stack([certain_sides(first, second[:, corner]) for corner in range(3)], axis=1)
    return of_first, of_second


def edge_edge_sides(pairs, first_corners, second_corners):
    """For each pair, the orientation of each edge of the first and each of the second: k x 9."""
    first, second = first_corners[pairs[:, 0]], second_corners[pairs[:, 1]]
    sides = []
    for i in range(3):
        for j in range(3):
            plane = np.stack([first[:, i], first[:, i - 1], second[:, j]], axis=1)
            sides.append(certain_sides(plane, second[:, j - 1]))
    return np.stack(sides, axis=1)


def certainly_uncut(first_vertices, first_faces, second_vertices, second_faces):
    """Per mesh, which faces certainly do not meet the other mesh."""
    meshes = (as_mesh(first_vertices, first_faces), as_mesh(second_vertices, second_faces))
    corners = [vertices[faces] for vertices, faces in meshes]
    pairs = overlapping_boxes(*corners)
    apart = np.zeros(len(pairs), dtype=bool)
    for sides in vertex_plane_sides(pairs, *corners):
        apart |= np.all(sides > 0, axis=1) | np.all(sides < 0, axis=1)
    uncut = [np.ones(len(faces), dtype=bool) for _, faces in meshes]
    for side in (0, 1):
        uncut[side][pairs[~apart, side]] = False
    return uncut
