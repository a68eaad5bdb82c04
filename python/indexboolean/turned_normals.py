# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""in: the vertices' normals of several meshes; out: those of a mesh that a filter has made of them.

A vertex that was one before has its own normal, turned over where its faces have been. A new one
has the mean of the corners of the face that it lies in, the first mesh's on the curve, of length 1.

They are no columns for the filter: vertices in one place that differ in their normals alone become
one.
"""

import numpy as np


def turned_normals(normals, sources, made):
    """n x 3 doubles, for each vertex of a new mesh.

    normals: those of all given vertices. sources: (their places, all given triangles, with numbers
    of those vertices). made: (the new mesh's places, its triangles, the given triangle that each
    comes from, the given vertex that each vertex is, or -1). A vertex without a face has its own
    normal, or zeros. Complexity: n log n.
    """
    places, triangles, source, vertex = made
    given_places, given_triangles = sources
    corners = given_triangles[source]
    turned = np.sum(_normals(places, triangles) * _normals(given_places, corners), axis=1) < 0

    face = np.full(len(places), -1)  # that a vertex is of: of its own mesh, else of the first
    order = np.argsort(-source, kind="stable")  # what is written last stays
    face[triangles[order].ravel()] = np.repeat(order, 3)
    for at in triangles.T:
        own = np.flatnonzero(np.any(corners == vertex[at][:, None], axis=1))
        face[at[own]] = own

    result = np.zeros((len(places), 3))
    was_there = vertex >= 0
    result[was_there] = normals[vertex[was_there]]
    new = np.flatnonzero(~was_there & (face >= 0))
    around = corners[face[new]]
    weights = _weights(places[new], given_places[around])
    mean = np.einsum("ni,nij->nj", weights, normals[around])
    length = np.linalg.norm(mean, axis=1, keepdims=True)
    result[new] = np.divide(mean, length, out=mean, where=length > 0)
    result[(face >= 0) & turned[face]] *= -1
    return result


def _normals(places, triangles):
    a, b, c = (places[triangles[:, corner]] for corner in range(3))
    return np.cross(b - a, c - a)


def _weights(points, corners):
    """Of points in triangles, n x 3 x 3: how much each corner counts."""
    a, b, c = (corners[:, corner] for corner in range(3))
    normal = np.cross(b - a, c - a)
    sides = ((b, c), (c, a), (a, b))
    parts = [np.sum(np.cross(q - points, r - points) * normal, axis=1) for q, r in sides]
    parts = np.stack(parts, axis=1).clip(min=0)
    total = parts.sum(axis=1, keepdims=True)
    return np.divide(parts, total, out=np.full_like(parts, 1 / 3), where=total > 0)
