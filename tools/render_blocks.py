# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""render_blocks.py A B DIR PICTURE: two operands and the blocks in DIR, side by side.

Each face of a block has the colour of the operand that it comes from.
"""

import os
import pathlib
import sys

os.environ.setdefault("VTK_DEFAULT_OPENGL_WINDOW", "vtkEGLRenderWindow")  # needs no display

import numpy as np  # noqa: E402
import pyvista as pv  # noqa: E402

FIRST_COLOUR, SECOND_COLOUR = (0.30, 0.54, 0.78), (0.96, 0.64, 0.24)
BLOCKS = {
    "union": "union",
    "intersection": "intersection",
    "first_minus_second": "A minus B",
    "second_minus_first": "B minus A",
}
LOOK = dict(smooth_shading=True, split_sharp_edges=True, specular=0.2, specular_power=15)


def faces_on(surface, block):
    """Which faces of the block lie on the surface, by their centres."""
    centres = block.cell_centers().compute_implicit_distance(surface)
    return np.abs(centres["implicit_distance"]) < 1e-6 * block.length


def add_block(plotter, block, second):
    """The parts of the block in the colours of their operands, and the curve between them."""
    on_second = faces_on(second, block)
    for chosen, colour in ((~on_second, FIRST_COLOUR), (on_second, SECOND_COLOUR)):
        if chosen.any():
            part = block.extract_cells(chosen).extract_surface(algorithm="dataset_surface")
            plotter.add_mesh(part, color=colour, **LOOK)
            curve = part.extract_feature_edges(feature_edges=False, manifold_edges=False)
            if curve.n_cells:
                plotter.add_mesh(curve, color="black", line_width=2)


def camera_on(mesh):
    direction = np.array((1.0, 0.35, 0.55))
    distance = 1.5 * mesh.length
    target = np.array(mesh.center)
    return [target + distance * direction / np.linalg.norm(direction), target, (0, 0, 1)]


def main(first_path, second_path, folder, picture):
    first, second = pv.read(first_path), pv.read(second_path)
    camera = camera_on(first.merge(second))
    plotter = pv.Plotter(shape=(2, 3), off_screen=True, window_size=(1200, 840), border=False)

    def panel(row, column, title):
        plotter.subplot(row, column)
        plotter.set_background("white")
        plotter.add_text(title, position="upper_edge", font_size=13, color="black")
        plotter.camera_position = camera

    panel(0, 0, "A")
    plotter.add_mesh(first, color=FIRST_COLOUR, **LOOK)
    panel(1, 0, "B")
    plotter.add_mesh(second, color=SECOND_COLOUR, **LOOK)
    for place, (block, title) in zip(((0, 1), (0, 2), (1, 1), (1, 2)), BLOCKS.items()):
        panel(*place, title)
        mesh = pv.read(pathlib.Path(folder) / f"{block}.ply")
        if mesh.n_cells:
            add_block(plotter, mesh, second)
    plotter.enable_anti_aliasing("ssaa", all_renderers=True)
    plotter.screenshot(picture)


if __name__ == "__main__":
    main(*sys.argv[1:])
