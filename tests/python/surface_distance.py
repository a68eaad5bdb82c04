# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How far one surface is from another, by samples: a measure that shares nothing with the library
under test.

in: meshes (V, F); out: farthest(mesh, other), of samples of either surface from the other one.
Source: libigl's distances. To needles these are thousands of times too large, so that the largest
are measured again, in long doubles. Guarantee: no sample is farther, but for rounding.
"""

import igl
import numpy as np

_MEASURED_AGAIN = 100  # samples of a surface, those farthest
_LEAST = np.longdouble(1e-300)


def farthest(mesh, other, per_face=12):
    """The greatest distance of samples of either surface from the other one."""
    return max(_farthest_of(mesh, other, per_face), _farthest_of(other, mesh, per_face))


def _farthest_of(mesh, other, per_face):
    samples = _samples_of(mesh, per_face)
    triangles = np.asarray(other[0])[other[1]]
    squares, _, _ = igl.point_mesh_squared_distance(
        samples, np.asarray(other[0]), np.asarray(other[1], dtype=np.int64))
    rough, found = np.sqrt(squares), 0.0
    for tried, number in enumerate(np.argsort(-rough)):
        if rough[number] <= found or tried == _MEASURED_AGAIN:
            return max(found, float(rough[number]))
        found = max(found, _distance_to_triangles(samples[number], triangles))
    return found


def _samples_of(mesh, per_face):
    """Corners, middles of sides, and points of each face."""
    rng = np.random.default_rng(1)
    corners = mesh[0][mesh[1]]
    weights = rng.dirichlet((1, 1, 1), size=(len(corners), per_face))
    inside = np.einsum("fkc,fcd->fkd", weights, corners).reshape(-1, 3)
    middles = (corners + np.roll(corners, -1, axis=1)).reshape(-1, 3) / 2
    return np.concatenate([corners.reshape(-1, 3), middles, inside])


def _distance_to_triangles(point, triangles):
    """The least of the distances, in long doubles."""
    a, b, c = (triangles[:, k].astype(np.longdouble) for k in range(3))
    point = point.astype(np.longdouble)
    sides = ((a, b), (b, c), (c, a))
    normal = np.cross(b - a, c - a)
    square = (normal * normal).sum(-1)
    is_above = square > 0
    for p, q in sides:
        is_above &= (np.cross(q - p, point - p) * normal).sum(-1) >= 0
    near = np.min([_distance_to_segments(point, *side) for side in sides], axis=0)
    height = np.abs(((point - a) * normal).sum(-1)[is_above]) / np.sqrt(square[is_above])
    return float(min(near.min(), height.min(initial=np.inf)))


def _distance_to_segments(point, a, b):
    along = b - a
    share = ((point - a) * along).sum(-1) / np.maximum((along * along).sum(-1), _LEAST)
    return np.sqrt(((a + np.clip(share, 0, 1)[:, None] * along - point) ** 2).sum(-1))
