# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pairs of clean operands whose results are hard to store: cuts that run nearly straight through
nearly coplanar faces, and surfaces that are nearly the same.

out: PAIR_NAMES, needs_meshes(name), load_pair(name). Some are other people's meshes, which are read
from the folder of INDEXBOOLEAN_MESHES.
"""

import math

import numpy as np

import placements
from plain_solids import box, icosphere, joined, make_samples, shifted, turned_about

# name: files, the shift of the second
STANDARD_PLACEMENTS = {
    "falconstatue, skull": ("falconstatue.obj", "skull.obj", (0.0, 0.0, 0.0)),
    "armadillo, bunny": ("armadillo.obj", "bunny100k.obj", (0.0, 0.0, 0.0)),
    "rocker-arm, itself": ("rocker-arm.obj", "rocker-arm.obj", (0.05, 0.04, 0.03)),
    "fandisk, itself": ("fandisk.obj", "fandisk.obj", (0.05, 0.04, 0.03)),
}
EMBER_PAIRS = {
    "EMBER 88566, 58011": "ember-0",
    "EMBER 908460, 73416": "ember-1",
    "EMBER 1063852, 72214": "ember-2",
}
ABOUT_X = (1, 0, 0)


def torus_pair(angle, shift):
    """A torus, and itself turned about x and shifted."""
    torus = make_samples.torus(48, 24, 1.0, 0.4)
    return torus, shifted(turned_about(torus, ABOUT_X, angle), shift)


def plate_pair(side):
    """A plate of 12 faces, and side x side cylinders through it as one operand."""
    cylinder = make_samples.cylinder(32, 0.3, 1.0)
    places = [(x + 0.5, y + 0.5, 0) for x in range(side) for y in range(side)]
    return (
        box((0, 0, -0.5), (side, side, 0.5)),
        joined(*[shifted(cylinder, place) for place in places]),
    )


def standing_pair():
    """A box, and a tetrahedron that stands on its lid on a corner."""
    corners = np.array([(1, 1, 5), (3, 1, 5), (2, 3, 5), (2, 1, 2)], dtype=np.float64)
    faces = np.array([(0, 1, 2), (0, 3, 1), (1, 3, 2), (2, 3, 0)])
    return box((0, 0, 0), (4, 4, 2)), (corners, faces)


def standard_pair(first, second, shift):
    """Two files in their standard placement."""
    folder = placements.meshes_folder()
    (va, fa), (vb, fb) = (placements.read_mesh(folder / name) for name in (first, second))
    matrix = [(*row, move) for row, move in zip(placements.rotation((1, 2, 3), 0.7), shift)]
    placed = placements.affine(placements.normalised(vb), matrix)
    return (placements.normalised(va), fa), (placed, fb)


def ember_pair(name):
    """A pair of the EMBER benchmark."""
    va, fa, vb, fb = placements.load_pair(EMBER_PAIRS[name], placements.meshes_folder())
    return (va, fa), (vb, fb)


OWN_PAIRS = {
    "torus, torus moved": lambda: torus_pair(0.7, (0.5, 0.1, 0.05)),
    "torus, torus of the same inner radius": lambda: torus_pair(math.pi / 2, (0, 0, 0)),
    "plate, 100 cylinders": lambda: plate_pair(10),
    "box, tetrahedron on it": standing_pair,
    "sphere, shifted by 1e-15": lambda: (icosphere(4), shifted(icosphere(4), (1e-15, 0, 0))),
    "sphere, shifted by 1e-8": lambda: (icosphere(5), shifted(icosphere(5), (1e-8, 0, 0))),
    "sphere, turned by 1e-7": lambda: (icosphere(5), turned_about(icosphere(5), ABOUT_X, 1e-7)),
}
PAIR_NAMES = (*OWN_PAIRS, *STANDARD_PLACEMENTS, *EMBER_PAIRS)


def needs_meshes(name):
    """Whether the pair is of other people's meshes."""
    return name not in OWN_PAIRS


def load_pair(name):
    """Both operands of a pair: (V, F) each."""
    if name in OWN_PAIRS:
        return OWN_PAIRS[name]()
    if name in STANDARD_PLACEMENTS:
        return standard_pair(*STANDARD_PLACEMENTS[name])
    return ember_pair(name)
