# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Chains: one solid after another is united with, subtracted from or intersected with what the
steps before have made.

out: KINDS, make_chain(kind, seed, steps) -> Chain. Guarantee: operands depend on the kind, the seed
and a step's number alone, so that all systems are given the same; where a closed form tells the
volume after a step, the step has it.
"""

import itertools
import math
from dataclasses import dataclass
from pathlib import Path
from typing import Callable, Iterator, Optional

import numpy as np

import placements
from plain_solids import (
    box, cube, icosphere, make_samples, shifted, turned_about, turned_at_random,
)

UNION, INTERSECTION, DIFFERENCE = "union", "intersection", "first_minus_second"
SAMPLES = Path(__file__).resolve().parents[2] / "sample_meshes"
GRID = 6  # squares along each side
TURN = math.pi / 6
CARVED = 15  # squares along each side of the terrain, of which all but two are carved
LATTICE = (13, 13, 12)


@dataclass(frozen=True)
class Step:
    """What is done to the solid so far, and the volume that it has then, if that is known."""

    operation: str
    operand: tuple
    volume: Optional[float] = None


@dataclass(frozen=True)
class Chain:
    start: tuple
    steps: Iterator[Step]


@dataclass(frozen=True)
class Kind:
    about: str
    steps: int  # if nothing else is said
    make: Callable  # rng -> Chain
    endless: bool = False  # else it has no more steps
    storage: str = "arrays"


# --- random cubes ---------------------------------------------------------------------------------


def carved_cube(rng):
    """A cube, from which turned cubes anywhere in it are subtracted."""
    def steps():
        while True:
            place = rng.uniform(-0.5, 0.5, 3)
            yield Step(DIFFERENCE, shifted(turned_at_random(cube(0.35), rng), place))

    return Chain(cube(1.0), steps())


def grown_cube(rng):
    """A cube, with which turned cubes are united that stand off it and off each other."""
    def steps():
        places = [rng.uniform(-0.5, 0.5, 3)]
        while True:
            direction = rng.normal(size=3)
            start = places[rng.integers(len(places))]
            places.append(start + 0.3 * direction / math.sqrt(sum(direction**2)))
            yield Step(UNION, shifted(turned_at_random(cube(0.4), rng), places[-1]))

    return Chain(cube(1.0), steps())


def turned_cubes(rng):
    """A cube, and it turned about its middle, intersected: nearly a ball in the end."""
    def steps():
        while True:
            yield Step(INTERSECTION, turned_at_random(cube(1.0), rng))

    return Chain(cube(1.0), steps())


# --- boxes on a grid ------------------------------------------------------------------------------


def grid_boxes(parts, axis):
    """Turned boxes on a grid, united one by one, and a last one that is subtracted. The volume is
    the number of squares. `axis` gives the axis of the turn."""
    def make(rng):
        about = axis(rng)
        squares, first = random_box(rng, about)
        return Chain(first, steps(rng, about, squares))

    def steps(rng, about, squares):
        for part in range(1, parts + 1):
            more, operand = random_box(rng, about)
            squares = squares | more if part < parts else squares & ~more
            yield Step(UNION if part < parts else DIFFERENCE, operand, float(squares.sum()))

    return make


def random_box(rng, about):
    """A box of height 1 on whole squares: which they are, and the box, turned."""
    (x, right), (y, back) = (sorted(rng.choice(GRID + 1, 2, replace=False)) for _ in range(2))
    squares = np.zeros((GRID, GRID), dtype=bool)
    squares[x:right, y:back] = True
    return squares, turned_about(box((x, y, 0), (right, back, 1)), about, TURN)


def vertical(_):
    return 0.0, 0.0, 1.0


def any_axis(rng):
    return tuple(rng.normal(size=3))


def cube_lattice(_):
    """Unit cubes in rows, in layers, each beside the one before: walls, edges and corners meet."""
    places = [(x, y, z) for z, y, x in itertools.product(*map(range, LATTICE[::-1]))]
    steps = (
        Step(UNION, box(place, [c + 1 for c in place]), number + 2.0)
        for number, place in enumerate(places[1:])
    )
    return Chain(box((0, 0, 0), (1, 1, 1)), steps)


# --- surfaces that are cut all over ---------------------------------------------------------------


def carved_terrain(rng):
    """A terrain of nearly plane quads, in which a winding road is dug, box beside box: each wall
    and floor of a box lies in one plane with those of the box before."""
    heights = rng.uniform(0, 1, (2, 3 * CARVED + 3))
    knots = np.arange(heights.shape[1], dtype=np.float64)

    def integral(low, high, profile):
        inside = knots[(knots > low) & (knots < high)]
        at = np.concatenate([[low], inside, [high]])
        return float(np.trapezoid(np.interp(at, knots, profile), at))

    def steps(volume):
        for row, column in itertools.product(range(CARVED), range(CARVED)):
            column = column if row % 2 == 0 else CARVED - 1 - column
            (x, right), (y, back) = ((0.7 + 2.9 * k, 3.6 + 2.9 * k) for k in (column, row))
            volume -= (right - x) * (back - y) * 0.5
            volume -= integral(x, right, heights[0]) * (back - y)
            volume -= integral(y, back, heights[1]) * (right - x)
            yield Step(DIFFERENCE, box((x, y, -0.5), (right, back, 3)), volume)

    side = knots[-1]
    ground = sum(integral(0, side, profile) for profile in heights) * side
    solid = raised(heights[0][:, None] + heights[1][None, :], -1.0)
    return Chain(solid, itertools.islice(steps(ground + side**2), CARVED**2 - 2))


def raised(heights, bottom):
    """A solid above the unit squares of a grid, up to a height at each corner."""
    rows, columns = heights.shape
    x, y = np.meshgrid(np.arange(rows), np.arange(columns), indexing="ij")
    top = np.stack([x, y, heights], axis=2).reshape(-1, 3).astype(np.float64)
    low = top * (1, 1, 0) + (0, 0, bottom)
    number = np.arange(rows * columns).reshape(rows, columns)
    lid = make_samples.quads(number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:])
    rim = np.concatenate([number[:-1, 0], number[-1, :-1], number[:0:-1, -1], number[0, :0:-1]])
    after, below = np.roll(rim, -1), len(top)
    walls = make_samples.quads(rim, rim + below, after + below, after)
    return np.concatenate([top, low]), np.concatenate([lid, lid[:, ::-1] + below, walls])


def carved_dome(rng):
    """Half a ball, from which small turned cubes are subtracted all over its roof."""
    points, faces = make_samples.octahedral_sphere(24)
    faces = faces[points[faces, 2].min(axis=1) >= 0]
    (rim,) = np.nonzero((points[:, 2] == 0))
    rim = rim[np.argsort(np.arctan2(points[rim, 1], points[rim, 0]))]
    middle = np.full(len(rim), len(points))
    floor = np.stack([np.roll(rim, -1), rim, middle], axis=1)
    used, faces = np.unique(np.concatenate([faces, floor]), return_inverse=True)
    dome = np.vstack([points, (0, 0, 0)])[used], faces.reshape(-1, 3)

    def steps(count=1000):
        for number in rng.permutation(count):
            height, angle = (number + 0.5) / count, number * math.pi * (3 - math.sqrt(5))
            radius = math.sqrt(1 - height * height)
            place = radius * math.cos(angle), radius * math.sin(angle), height
            yield Step(DIFFERENCE, shifted(turned_at_random(cube(0.06), rng), place))

    return Chain(dome, steps())


def bitten_scan(rng):
    """A scan, or the sample of a figure without other people's meshes; balls are subtracted."""
    folder = placements.meshes_folder()
    path = folder / "bunny100k.obj" if folder else SAMPLES / "statue.ply"
    points, faces = placements.read_mesh(path)
    points = placements.normalised(points)
    radius, (ball, ball_faces) = 0.08, icosphere(3)

    def steps():
        while True:
            place = points[rng.integers(len(points))]
            yield Step(DIFFERENCE, shifted((radius * ball, ball_faces), place))

    return Chain((points, faces), steps())


KINDS = {
    "carve": Kind("a cube, from which turned cubes are subtracted", 100, carved_cube, True),
    "grow": Kind("a cube, with which turned cubes are united", 100, grown_cube, True),
    "turned": Kind("a cube, and it turned, intersected", 60, turned_cubes, True),
    "grid_z_5": Kind("5 boxes on a grid, about z", 5, grid_boxes(5, vertical)),
    "grid_z_8": Kind("8 boxes on a grid, about z", 8, grid_boxes(8, vertical)),
    "grid_any_5": Kind("5 boxes on a grid, about any axis", 5, grid_boxes(5, any_axis)),
    "grid_any_8": Kind("8 boxes on a grid, about any axis", 8, grid_boxes(8, any_axis)),
    "terrain": Kind("a terrain, dug along coplanar seams", CARVED**2 - 2, carved_terrain),
    "lattice": Kind("cubes that share walls, united", math.prod(LATTICE) - 1, cube_lattice),
    "dome": Kind("a dome, from which small cubes are subtracted", 1000, carved_dome),
    "scan_ply": Kind("balls subtracted from a scan, by PLY files", 20, bitten_scan, True, "ply"),
    "scan_stl": Kind("balls subtracted from a scan, by STL files", 20, bitten_scan, True, "stl"),
}


def make_chain(name, seed, steps=None):
    """The chain of a kind and a seed, with so many steps, or as many as the kind has."""
    chain = KINDS[name].make(np.random.default_rng(seed))
    count = KINDS[name].steps if steps is None else steps
    return Chain(chain.start, itertools.islice(chain.steps, count))
