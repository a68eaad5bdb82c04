# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""render_merged_walls.py: docs/merged_walls.png, a cube with 60 turned ones intersected in turn,
without a merge_tolerance and with one, with the edges of all triangles; prints their faces.
"""

import pathlib
import sys

import pyvista as pv

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path.append(str(ROOT / "tests" / "python"))

import chain_kinds  # noqa: E402
from merged_chains import as_stored, one_block, tolerance_of  # noqa: E402
from render_figures import FIRST_COLOUR, show, surface_of  # noqa: E402

SEED = 4


def last_result(share):
    """The mesh after all steps, with a share of the tolerance of the chains' tests."""
    chain = chain_kinds.make_chain("turned", SEED)
    mesh = chain.start
    for step in chain.steps:
        operands = mesh, as_stored(step.operand, "host")
        tolerance = share * tolerance_of(operands, "host")
        mesh, _ = one_block(operands, step.operation, "host", tolerance)
    return mesh


def main():
    plotter = pv.Plotter(shape=(1, 2), off_screen=True, border=False, window_size=(1000, 520))
    for column, (share, title) in enumerate(((0, "without"), (1, "with merged walls"))):
        mesh = last_result(share)
        print(f"{title}: {len(mesh[1])} faces")

        def draw(surface=surface_of(*mesh)):
            plotter.add_mesh(surface, color=FIRST_COLOUR, show_edges=True, line_width=1)

        faces = f"{title}: {len(mesh[1])} faces"
        show(plotter, column, faces, ((1.0, 0.6, 0.55), (0, 0, 1), 0, 1.0), draw)
    plotter.enable_anti_aliasing("ssaa", all_renderers=True)
    plotter.screenshot(ROOT / "docs" / "merged_walls.png")


if __name__ == "__main__":
    main()
