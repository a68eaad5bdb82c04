# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Judges of a surface as it is stored, which share nothing with the library under test.

in: a mesh (V, F), judged with equal coordinates identified, so that copies of a vertex at one
place are no fault; out: which faces meet others in more than common corners and edges, and which
have no area; how many are needles. Source: libigl's exact search, which passes over what begins at
a common edge; that is decided here, in whole numbers. CGAL's search, a program of tests/judges, is
a second opinion. Guarantee: but for needles and angles, measured in doubles, nothing is rounded.
"""

import os
import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path

import igl.copyleft.cgal
import numpy as np

from contact_filter import certain_sides
from mesh_laws import as_mesh, welded, zero_area_faces

CGAL_PROGRAM = Path(os.environ.get(
    "INDEXBOOLEAN_CGAL_JUDGE",
    Path(__file__).resolve().parents[2] / "build/release/tests/cgal_self_intersections",
))
NEEDLE = 1e-9  # of height to longest edge
_DOUBT = 1e-12  # of a cosine; far beyond its rounding error
_PLENTY = 2**31 - 1  # of pairs that libigl may list


@dataclass(frozen=True)
class Verdict:
    """What is wrong with a mesh; faces are numbered as the judge was given them."""

    crossing: frozenset  # meet others away from common edges
    folded: frozenset  # lie on others from a common edge on, or on the same three corners
    flat: frozenset  # have three different corners on a line
    collapsed: frozenset  # have two corners in one place: none, to most readers of files
    needles: int  # how many; flat and collapsed faces, too

    @property
    def wrong(self):
        """The faces concerned: none, and the surface holds as it is stored."""
        return self.crossing | self.folded | self.flat | self.collapsed

    @property
    def meeting(self):
        """How many are wrong but for those that have collapsed, which most readers leave out."""
        return len(self.wrong - self.collapsed)

    def __str__(self):
        return (
            f"{len(self.wrong)} wrong faces ({len(self.crossing)} cross, {len(self.folded)} fold, "
            f"{len(self.flat)} are flat, {len(self.collapsed)} have equal corners), "
            f"{self.needles} needles"
        )


# --- the exact judge ------------------------------------------------------------------------------


def judge(vertices, faces):
    """The verdict on a mesh, with its coordinates as they are given."""
    points, faces = welded(vertices, faces)
    corners = np.sort(faces, axis=1)
    # A flat face whose corners differ is in the way of others; one that has collapsed is not.
    differ = (corners[:, 1:] != corners[:, :-1]).all(axis=1)
    (solid,), (collapsed,) = np.nonzero(differ), np.nonzero(~differ)
    flat = np.setdiff1d(zero_area_faces(points, faces), collapsed)
    kept = np.setdiff1d(solid, flat)
    return Verdict(
        frozenset(solid[_crossing(points, faces[solid])].tolist()),
        frozenset(kept[_folded(points, faces[kept])].tolist()),
        frozenset(flat.tolist()),
        frozenset(collapsed.tolist()),
        needles(points, faces),
    )


def judge_as_float(vertices, faces):
    """The verdict on the mesh that is left once each coordinate is rounded to a float.

    A face with two corners in one place is then none: no reader of a file keeps it.
    """
    with np.errstate(over="ignore", under="ignore"):
        points = np.asarray(vertices, dtype=np.float32)
    return judge(*without_collapsed_faces(points, faces))


def without_collapsed_faces(vertices, faces):
    """The mesh, welded, without the faces of which two corners are in one place."""
    points, faces = welded(vertices, faces)
    a, b, c = faces.T
    return points, faces[(a != b) & (b != c) & (c != a)]


def _crossing(points, faces):
    # Which faces libigl lists in a pair.
    if len(faces) == 0:
        return np.empty(0, dtype=np.int64)
    found = igl.copyleft.cgal.remesh_self_intersections(
        points, np.ascontiguousarray(faces), detect_only=True, cutoff=_PLENTY
    )[2]
    return np.unique(found)


def _folded(points, faces):
    # Which faces lie on another from a common edge on. No face is flat.
    ends = np.sort(np.stack([faces, np.roll(faces, -1, axis=1)], axis=2).reshape(-1, 2), axis=1)
    opposite = np.roll(faces, -2, axis=1).ravel()
    order = np.lexsort(ends.T)
    ends, opposite, owner = ends[order], opposite[order], order // 3
    found = np.zeros(len(faces), dtype=bool)
    for step in range(1, len(ends)):
        (at,) = np.nonzero((ends[step:] == ends[:-step]).all(axis=1))
        if len(at) == 0:
            break
        hinge = points[np.stack([*ends[at].T, opposite[at], opposite[at + step]], axis=1)]
        folds = _closed_hinges(hinge)
        found[owner[at[folds]]] = found[owner[at[folds] + step]] = True
    return np.flatnonzero(found)


def _closed_hinges(hinges):
    # Of hinges (k x 4 x 3: the ends of an edge, a corner to either side), those with both sides in
    # one plane and on one side of the edge.
    flat = certain_sides(hinges[:, :3], hinges[:, 3]) == 0
    scaled = hinges / np.maximum(np.abs(hinges).max(axis=(1, 2), keepdims=True), 1e-300)
    edge, first, second = (scaled[:, k] - scaled[:, 0] for k in (1, 2, 3))
    normals = np.cross(edge, first), np.cross(edge, second)
    cosine = np.sum(normals[0] * normals[1], axis=1)
    # A normal's rounding error is measured by the coordinates, not by its length.
    doubt = _DOUBT * sum(np.linalg.norm(normal, axis=1) for normal in normals) + _DOUBT**2
    (doubtful,) = np.nonzero(flat & (cosine >= -doubt))
    closed = [_exactly_closed(hinges[k].tolist()) for k in doubtful]
    return doubtful[np.array(closed, dtype=bool)]


def _exactly_closed(hinge):
    # By whole numbers: doubles are multiples of a power of two.
    ratios = [[x.as_integer_ratio() for x in point] for point in hinge]
    unit = max(below for point in ratios for _, below in point)
    start, *others = [[above * (unit // below) for above, below in point] for point in ratios]
    edge, first, second = ([x - y for x, y in zip(point, start)] for point in others)
    m, n = _cross(edge, first), _cross(edge, second)
    return _dot(m, second) == 0 and _dot(m, n) > 0


def _cross(u, v):
    return [u[i - 2] * v[i - 1] - u[i - 1] * v[i - 2] for i in range(3)]


def _dot(u, v):
    return sum(x * y for x, y in zip(u, v))


# --- shapes of faces ------------------------------------------------------------------------------


def _sides(vertices, faces):
    # The squared lengths of the sides of each face, ascending, and twice its area.
    vertices, faces = as_mesh(vertices, faces)
    a, b, c = (vertices[faces[:, corner]] for corner in range(3))
    sides = np.stack([np.sum(side**2, axis=1) for side in (b - a, c - b, a - c)], axis=1)
    return np.sort(sides, axis=1), np.linalg.norm(np.cross(b - a, c - a), axis=1)


def needles(vertices, faces, limit=NEEDLE):
    """How many faces are lower than `limit` times their longest edge; flat ones are counted."""
    sides, double_area = _sides(vertices, faces)
    return int(np.count_nonzero(double_area <= limit * sides[:, 2]))


def smallest_angles(vertices, faces):
    """The smallest angle of each face in degrees; that of a flat face is 0."""
    sides, double_area = _sides(vertices, faces)
    # Opposite to the shortest side: the scalar product of the two others, at their common corner.
    return np.degrees(np.arctan2(2 * double_area, sides[:, 1] + sides[:, 2] - sides[:, 0]))


# --- CGAL's judge ---------------------------------------------------------------------------------


def cgal_faces(vertices, faces, *options):
    """The faces that CGAL finds wrong; FileNotFoundError if its program is not built."""
    points, faces = welded(vertices, faces)
    with tempfile.NamedTemporaryFile(suffix=".mesh") as file:
        file.write(np.array([len(points), len(faces)], dtype=np.int64).tobytes())
        file.write(points.tobytes())
        file.write(faces.tobytes())
        file.flush()
        done = subprocess.run(
            [CGAL_PROGRAM, file.name, *options], capture_output=True, text=True, check=True
        )
    return frozenset(map(int, done.stdout.split()))
