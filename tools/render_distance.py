# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""render_distance.py: the picture of docs/distance.md, docs/distance.png: two sample meshes, then
each in the colours of its distances from the other, as the command `distance --plot` draws them.
"""

import pathlib
import sys

import pyvista as pv

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path.append(str(ROOT / "tests" / "python"))

from indexboolean import SignedDistance  # noqa: E402
from indexboolean.distance_plot import colour_limit, draw_mesh  # noqa: E402
from render_figures import FIRST_COLOUR, LOOK, SECOND_COLOUR, show, surface_of  # noqa: E402
from sample_catalogue import sample  # noqa: E402


def main():
    first, second = sample("bumpy_sphere"), sample("ribbed_torus")
    meshes = {}
    for side, mesh, other in (("first", first, second), ("second", second, first)):
        distance, _, _ = SignedDistance(other)(mesh[0])
        meshes[side] = (*mesh, distance)
    plotter = pv.Plotter(shape=(1, 3), off_screen=True, border=False, window_size=(1500, 480))

    def given():
        for mesh, colour in ((first, FIRST_COLOUR), (second, SECOND_COLOUR)):
            plotter.add_mesh(surface_of(*mesh), color=colour, **LOOK)

    show(plotter, 0, "before: A and B", ((1.0, 0.6, 0.55), (0, 0, 1), 0, 1.0), given)
    for column, (side, title) in enumerate((("first", "A, by its distance from B"),
                                            ("second", "B, by its distance from A"))):
        draw_mesh(plotter, column + 1, title, (*meshes[side], "vertex"), colour_limit(meshes))
    plotter.enable_anti_aliasing("ssaa", all_renderers=True)
    plotter.screenshot(ROOT / "docs" / "distance.png")


if __name__ == "__main__":
    main()
