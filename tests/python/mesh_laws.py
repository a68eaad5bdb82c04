# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Laws of triangle meshes, checked with numpy alone and without the library under test.

A mesh is a pair (V, F): n x 3 doubles and m x 3 vertex indices, faces counter-clockwise seen from
outside. Guarantee: closedness and zero area are decided exactly; volumes and areas are summed in
extended precision about a point of the mesh.
"""

from fractions import Fraction

import numpy as np

_UNIT_ROUNDOFF = 2.0**-53
_SMALLEST_NORMAL = np.finfo(np.float64).tiny


def as_mesh(vertices, faces):
    """Contiguous copies: n x 3 doubles without a negative zero, m x 3 int64."""
    vertices = np.ascontiguousarray(vertices, dtype=np.float64).reshape(-1, 3) + 0.0
    return vertices, np.ascontiguousarray(faces, dtype=np.int64).reshape(-1, 3)


def welded(vertices, faces):
    """The mesh with exactly equal coordinates identified; vertices in lexicographic order."""
    vertices, faces = as_mesh(vertices, faces)
    if len(vertices) == 0:
        return vertices, faces
    order = np.lexsort((vertices[:, 2], vertices[:, 1], vertices[:, 0]))
    ordered = vertices[order]
    first = np.ones(len(ordered), dtype=bool)
    first[1:] = np.any(ordered[1:] != ordered[:-1], axis=1)
    index = np.empty(len(ordered), dtype=np.int64)
    index[order] = np.cumsum(first) - 1
    return ordered[first], index[faces]


def unmatched_edges(vertices, faces):
    """How many directed edges lack their opposite, counted after exact welding. 0: closed."""
    points, faces = welded(vertices, faces)
    start, end = faces.ravel(), np.roll(faces, -1, axis=1).ravel()
    low, high = np.minimum(start, end), np.maximum(start, end)
    _, edge = np.unique(low * max(len(points), 1) + high, return_inverse=True)
    excess = np.bincount(edge[start < end], minlength=edge.max(initial=-1) + 1)
    excess = excess - np.bincount(edge[start > end], minlength=len(excess))
    return int(np.abs(excess).sum())


def _corner_differences(vertices, faces):
    vertices, faces = as_mesh(vertices, faces)
    a, b, c = (vertices[faces[:, corner]] for corner in range(3))
    return b - a, c - a


def _exactly_zero_area(corners):
    a, b, c = ([Fraction(x) for x in corner] for corner in corners)
    u = [b[i] - a[i] for i in range(3)]
    v = [c[i] - a[i] for i in range(3)]
    return all(u[i - 2] * v[i - 1] == u[i - 1] * v[i - 2] for i in range(3))


def zero_area_faces(vertices, faces):
    """The indices of the faces whose exact cross product is zero.

    A component that exceeds its rounding error (three roundings a product, one for the
    difference, and underflow) proves an area; the others are computed in fractions.
    """
    vertices, faces = as_mesh(vertices, faces)
    u, v = _corner_differences(vertices, faces)
    certain = np.zeros(len(faces), dtype=bool)
    with np.errstate(over="ignore", invalid="ignore", under="ignore"):
        for i in range(3):
            left, right = u[:, i - 2] * v[:, i - 1], u[:, i - 1] * v[:, i - 2]
            bound = 8 * _UNIT_ROUNDOFF * (np.abs(left) + np.abs(right)) + 4 * _SMALLEST_NORMAL
            certain |= np.abs(left - right) > bound
    doubtful = np.flatnonzero(~certain)
    zero = [_exactly_zero_area(vertices[faces[face]].tolist()) for face in doubtful]
    return doubtful[np.array(zero, dtype=bool)]


def volume(vertices, faces):
    """The signed volume, summed in extended precision about the middle of the bounding box."""
    vertices, faces = as_mesh(vertices, faces)
    if len(faces) == 0:
        return 0.0
    used = vertices[faces.ravel()]
    origin = (used.min(axis=0) + used.max(axis=0)) / 2
    points = vertices.astype(np.longdouble) - origin
    a, b, c = (points[faces[:, corner]] for corner in range(3))
    return float(np.sum(a * _cross(b, c)) / 6)


def exact_volume(vertices, faces):
    """The signed volume as a fraction. Slow: for meshes of a few thousand faces."""
    vertices, faces = as_mesh(vertices, faces)
    points = [[Fraction(x) for x in point] for point in vertices.tolist()]
    six_volumes = Fraction(0)
    for face in faces.tolist():
        a, b, c = (points[corner] for corner in face)
        six_volumes += sum(a[i] * (b[i - 2] * c[i - 1] - b[i - 1] * c[i - 2]) for i in range(3))
    return six_volumes / 6


def area(vertices, faces):
    """The surface area, summed in extended precision."""
    vertices, faces = as_mesh(vertices, faces)
    points = vertices.astype(np.longdouble)
    a, b, c = (points[faces[:, corner]] for corner in range(3))
    normal = _cross(b - a, c - a)
    return float(np.sum(np.sqrt(np.sum(normal * normal, axis=1))) / 2)


def _cross(u, v):
    # numpy.cross is slow for extended precision.
    return np.stack([u[:, i - 2] * v[:, i - 1] - u[:, i - 1] * v[:, i - 2] for i in range(3)], 1)


def component_labels(faces, vertex_count):
    """Per vertex, the smallest vertex that faces connect it to."""
    faces = np.asarray(faces, dtype=np.int64).reshape(-1, 3)
    label = np.arange(vertex_count)
    while True:
        smallest = label[faces].min(axis=1)
        lowered = label.copy()
        for corner in range(3):
            np.minimum.at(lowered, label[faces[:, corner]], smallest)
        lowered = np.minimum(lowered, lowered[label])
        while np.any(lowered != lowered[lowered]):
            lowered = lowered[lowered]
        if np.array_equal(lowered, label):
            return label
        label = lowered


def component_count(faces, vertex_count):
    """The number of vertex-connected components that have a face."""
    faces = np.asarray(faces, dtype=np.int64).reshape(-1, 3)
    return len(np.unique(component_labels(faces, vertex_count)[faces[:, :1]]))


def euler_number(faces):
    """Vertices - edges + faces, of the vertices and edges that faces use, by index."""
    faces = np.asarray(faces, dtype=np.int64).reshape(-1, 3)
    start, end = faces.ravel(), np.roll(faces, -1, axis=1).ravel()
    edges = np.unique(np.stack([np.minimum(start, end), np.maximum(start, end)]), axis=1)
    return len(np.unique(faces)) - edges.shape[1] + len(faces)


def genus(faces, vertex_count):
    """The summed genus of the components of a closed manifold mesh."""
    return component_count(faces, vertex_count) - euler_number(faces) // 2


def is_edge_manifold(faces):
    """True if each directed edge occurs once and so does its opposite, by index."""
    faces = np.asarray(faces, dtype=np.int64).reshape(-1, 3)
    start, end = faces.ravel(), np.roll(faces, -1, axis=1).ravel()
    width = int(faces.max(initial=0)) + 1
    forward, backward = start * width + end, end * width + start
    return len(np.unique(forward)) == len(forward) and np.array_equal(
        np.sort(forward), np.sort(backward)
    )


def is_manifold(faces):
    """True if, by index, each edge has two faces that run against each other, and the faces at each
    vertex are one umbrella."""
    faces = np.asarray(faces, dtype=np.int64).reshape(-1, 3)
    if not is_edge_manifold(faces):
        return False
    # From each corner, the way across the edge that leaves it leads to one corner of that vertex.
    start, end = faces.ravel(), np.roll(faces, -1, axis=1).ravel()
    width = int(faces.max(initial=0)) + 1
    corner = np.arange(len(start))
    leaving, arriving = np.argsort(start * width + end), np.argsort(end * width + start)
    opposite = np.empty(len(start), dtype=np.int64)
    opposite[leaving] = arriving
    following = 3 * (opposite // 3) + (opposite + 1) % 3
    umbrellas = component_count(np.stack([corner, following, following], axis=1), len(start))
    return umbrellas == len(np.unique(faces))


def coinciding_faces(vertices, faces):
    """How many faces have the corners, by coordinates, of another face, either way round."""
    _, faces = welded(vertices, faces)
    _, count = np.unique(np.sort(faces, axis=1), axis=0, return_counts=True)
    return int(count[count > 1].sum())


def coincident_ends(vertices, faces):
    """How many directed edges join two vertices of equal coordinates."""
    _, faces = welded(vertices, faces)
    return int(np.count_nonzero(faces == np.roll(faces, -1, axis=1)))


def triangle_rows(vertices, faces):
    """m x 9: each face's corners by coordinates, the lexicographically smallest corner first.

    The rows keep the order of the faces; equal faces have equal rows whatever their numbering.
    """
    points, faces = welded(vertices, faces)
    first = faces.argmin(axis=1)
    rows = np.arange(len(faces))
    turned = np.stack([faces[rows, (first + corner) % 3] for corner in range(3)], axis=1)
    return points[turned].reshape(-1, 9)


def triangle_set(vertices, faces):
    """The sorted rows of triangle_rows: equal arrays mean the same geometry."""
    rows = triangle_rows(vertices, faces)
    return rows[np.lexsort(rows.T[::-1])]


def reversed_faces(faces):
    """The faces seen from the other side."""
    return np.asarray(faces)[:, [0, 2, 1]]


def rows_in(rows, others):
    """Per row, whether an equal row occurs in the others. Values are compared as numbers."""

    def keys(array):
        array = np.ascontiguousarray(array, dtype=np.float64) + 0.0
        return array.view(np.dtype((np.void, array.dtype.itemsize * array.shape[1]))).ravel()

    return np.isin(keys(rows), keys(others))


def winding_numbers(points, vertices, faces):
    """The winding number of a closed mesh about each point, by one ray along +z for each.

    Returns (numbers, decided): a point is undecided if a sign that counts is within rounding
    error, as for a ray that meets an edge. Complexity: points x faces.
    """
    vertices, faces = as_mesh(vertices, faces)
    numbers = np.zeros(len(points), dtype=np.int64)
    decided = np.ones(len(points), dtype=bool)
    for index, point in enumerate(np.asarray(points, dtype=np.float64)):
        corners = (vertices - point)[faces]
        near = (corners[:, :, :2].min(axis=1) <= 0) & (corners[:, :, :2].max(axis=1) >= 0)
        numbers[index], decided[index] = _crossings_above(corners[near.all(axis=1)])
    return numbers, decided


def _crossings_above(corners):
    # Signed crossings of the ray (0, 0, t), t > 0, with triangles whose shadows may hold it.
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    sides, doubt = [], np.zeros(len(corners), dtype=bool)
    for p, q in ((a, b), (b, c), (c, a)):
        left, right = p[:, 0] * q[:, 1], p[:, 1] * q[:, 0]
        sides.append(left - right)
        doubt |= np.abs(left - right) <= 8 * _UNIT_ROUNDOFF * (np.abs(left) + np.abs(right))
    sides = np.stack(sides)
    hit = np.all(sides > 0, axis=0) | np.all(sides < 0, axis=0)
    normal = _cross(b - a, c - a)
    height = np.sum(a * normal, axis=1) * np.sign(normal[:, 2])
    scale = np.sum(np.abs(a) * np.abs(normal), axis=1)
    doubt |= hit & (np.abs(height) <= 1e-13 * scale)
    sign = np.where(normal[:, 2] > 0, 1, -1)
    return int(np.sum(sign[hit & (height > 0)])), not doubt.any()
