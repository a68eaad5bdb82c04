# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Open surfaces: sheets over a square, flat or with bumps, and parts of closed meshes."""

import numpy as np


def grid(columns, rows, place):
    """A sheet of 2 * columns * rows triangles: place(u, v) gives x, y, z for u, v from 0 to 1.

    Its front is where u, then v, run counter-clockwise.
    """
    u, v = np.meshgrid(np.arange(columns + 1), np.arange(rows + 1), indexing="ij")
    x, y, z = np.broadcast_arrays(*place(u.ravel() / columns, v.ravel() / rows))
    number = np.arange((columns + 1) * (rows + 1)).reshape(columns + 1, rows + 1)
    a, b, c, d = number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:]
    halves = [np.stack([p.ravel(), q.ravel(), r.ravel()], 1) for p, q, r in ((a, b, c), (a, c, d))]
    return np.stack([x, y, z], axis=1), np.stack(halves, axis=1).reshape(-1, 3)


def bumpy_sheet(normal, height, half_width, steps=60, bump=0.01):
    """A square sheet with bumps about the plane of the points p with normal * p = height."""
    normal = np.asarray(normal, dtype=np.float64)
    normal = normal / np.sqrt(normal @ normal)
    helper = np.eye(3)[np.argmin(np.abs(normal))]
    across = np.cross(helper, normal)
    across /= np.sqrt(across @ across)
    along = np.cross(normal, across)

    def place(u, v):
        s, t = (2 * u - 1) * half_width, (2 * v - 1) * half_width
        bumps = bump * np.sin(13 * s / half_width) * np.cos(11 * t / half_width + 0.7)
        points = np.outer(s, across) + np.outer(t, along) + np.outer(height + bumps, normal)
        return points.T

    return grid(steps, steps, place)


def flipped(vertices, faces):
    """The same surface seen from the other side."""
    return vertices, np.ascontiguousarray(faces[:, ::-1])


def square(low, high, height=0.0, steps=1):
    """A flat square in the plane z = height, front upwards."""
    width = high - low
    return grid(steps, steps, lambda u, v: (low + width * u, low + width * v, height + 0 * u))
