# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The paper's figures with meshes of our own: the pairs, what they are cut into, what it states.

As a program it runs the split filter on each pair and writes the table of docs/paper_figures.md.
Figures are numbered as in the article of 2023.
"""

from pathlib import Path

import numpy as np
import pymeshlab

import indexboolean
import placements
from open_shapes import bumpy_sheet, grid
from sample_catalogue import sample

PAGE = Path(__file__).resolve().parents[2] / "docs" / "paper_figures.md"
TABLE_START = "<!-- table: written by tests/python/paper_figures.py -->\n"
TABLE_END = "<!-- /table -->\n"
# The sheets' planes: where they cut the statues in three places.
FALCON_PLANE = (2.06, -0.23, -0.37), -0.11
LION_PLANE = (-0.491, -0.87, -0.052), -0.052


def open_pair():
    """Two hilly sheets over one square that cross in four lines from border to border."""

    def hills(u, v):
        return 0.16 * np.sin(4.2 * u + 0.6) * np.cos(3.1 * v - 0.4)

    def waves(u, v):
        crossing = 0.5 + 4 * u + 0.22 * np.sin(6.0 * v + 0.5)
        return hills(u, v) + 0.11 * np.sin(np.pi * crossing)

    first = grid(40, 40, lambda u, v: (u, v, hills(u, v)))
    second = grid(46, 34, lambda u, v: (u, v, waves(u, v)))
    return first, second


def blocks_pair():
    """A cube and a cross of three bars: six hard-closed loops."""
    return cube(1.1), cross()


def cube(half_width):
    """A cube about the origin."""
    vertices, faces = boundary_of_cells([(0, 0, 0)])
    return (2 * vertices - 1) * half_width, faces


def cross():
    """Seven unit cubes: one in the middle and one on each of its sides."""
    arms = [tuple(sign * x for x in axis) for axis in np.eye(3, dtype=int).tolist()
            for sign in (1, -1)]
    vertices, faces = boundary_of_cells([(0, 0, 0), *arms])
    return vertices - 0.5, faces


def boundary_of_cells(cells):
    """The boundary of unit cubes given by their low corners: vertices, faces turned outwards."""
    numbers, faces = {}, []
    for cell in cells:
        for axis in range(3):
            for side in (0, 1):
                beyond = list(cell)
                beyond[axis] += 2 * side - 1
                if tuple(beyond) in cells:
                    continue
                corners = []
                for s, t in ((0, 0), (1, 0), (1, 1), (0, 1)):
                    corner = list(cell)
                    corner[axis] += side
                    corner[axis - 2] += s
                    corner[axis - 1] += t
                    corners.append(numbers.setdefault(tuple(corner), len(numbers)))
                a, b, c, d = corners if side else corners[::-1]
                faces += [(a, b, c), (a, c, d)]
    return np.array(list(numbers), dtype=np.float64), np.array(faces)


def statue_pair(file, plane):
    """A statue of other people's, and a bumpy sheet across it. None without their folder."""
    folder = placements.meshes_folder()
    if folder is None:
        return None
    vertices, faces = placements.read_mesh(folder / file)
    sheet = bumpy_sheet(*plane, half_width=0.58, bump=0.006)
    return (placements.normalised(vertices), faces), sheet


# name: (figure, what the pair is, the pair, what the paper states)
FIGURES = {
    "blocks": (
        "4, 5", "a cube and a cross", blocks_pair,
        "six hard-closed loops",
    ),
    "open": (
        "8", "two open sheets", open_pair,
        "four open loops; five boundary cycles and five sub-surfaces each",
    ),
    "falcon": (
        "9, 10", "falconstatue, closed, and a sheet",
        lambda: statue_pair("falconstatue.obj", FALCON_PLANE),
        "three closed loops; four sub-surfaces each; four sub-blocks",
    ),
    "lion": (
        "9, 10", "lionstatue, open at its base, and a sheet",
        lambda: statue_pair("lionstatue.obj", LION_PLANE),
        "three closed loops; four sub-surfaces each",
    ),
    "cylinders": (
        "11", "two equal cylinders",
        lambda: (sample("cylinder_along_x"), sample("cylinder_along_y")),
        "four soft-closed loops; four sub-surfaces each",
    ),
    "tori": (
        "12", "two equal tori",
        lambda: (sample("torus_about_z"), sample("torus_about_x")),
        "soft-closed loops only",
    ),
}
COLUMNS = (
    ("open", "loops_open"),
    ("hard-closed", "loops_hard_closed"),
    ("soft-closed", "loops_soft_closed"),
    ("boundary cycles of A", "boundary_cycles_first"),
    ("of B", "boundary_cycles_second"),
    ("sub-surfaces of A", "sub_surfaces_first"),
    ("of B", "sub_surfaces_second"),
    ("sub-blocks", "sub_blocks"),
)


def split(first, second, **parameters):
    """Runs the split filter on two meshes: (document, result map)."""
    indexboolean.load_plugin()
    mesh_set = pymeshlab.MeshSet()
    for label, (vertices, faces) in (("A", first), ("B", second)):
        mesh_set.add_mesh(pymeshlab.Mesh(vertices, faces), label)
    return mesh_set, mesh_set.generate_index_boolean_split(
        first_mesh=0, second_mesh=1, **parameters
    )


def measure(name):
    """The figures of one row of the table, by key; None where the meshes are not here."""
    pair = FIGURES[name][2]()
    if pair is None:
        return None
    _, result = split(*pair)
    result["boundary_cycles_first"] = int(result["sub_surfaces_first_boundary_cycles"].sum())
    result["boundary_cycles_second"] = int(result["sub_surfaces_second_boundary_cycles"].sum())
    return {key: result[key] for _, key in COLUMNS}


def row(name, figures):
    figure, what, _, stated = FIGURES[name]
    cells = [figure, what, *(str(figures[key]) for _, key in COLUMNS), stated]
    return "| " + " | ".join(cells) + " |"


def table(rows):
    heads = ["figure", "A and B", *(head for head, _ in COLUMNS), "the paper states"]
    return "\n".join(["| " + " | ".join(heads) + " |", "|---" * len(heads) + "|", *rows]) + "\n"


def main():
    measured = {name: measure(name) for name in FIGURES}
    if None in measured.values():
        raise SystemExit(f"{placements.MESHES_VARIABLE} must name the folder of the statues")
    before, rest = PAGE.read_text(encoding="utf-8").split(TABLE_START)
    after = rest.split(TABLE_END)[1]
    rows = [row(name, figures) for name, figures in measured.items()]
    text = before + TABLE_START + table(rows) + TABLE_END + after
    PAGE.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
