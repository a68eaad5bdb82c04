# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""render_expression.py: the pictures of docs/expression.md.

docs/expression.png: four layers, then what statements over them make, all from one run. Each face
has the colour of the layer that it comes from. docs/resolve.png: a layer that meets itself, cut
open to show the walls inside, and what resolving makes of it.
"""

import os
import sys

os.environ.setdefault("VTK_DEFAULT_OPENGL_WINDOW", "vtkEGLRenderWindow")  # needs no display

import numpy as np  # noqa: E402
import pymeshlab  # noqa: E402
import pyvista as pv  # noqa: E402

import render_figures  # noqa: E402
import indexboolean  # noqa: E402

sys.path.append(str(render_figures.ROOT / "tests" / "python"))

from plain_solids import box, joined, turned_about  # noqa: E402
from conftest import sphere  # noqa: E402

COLOURS = np.array([(0.30, 0.54, 0.78), (0.96, 0.64, 0.24), (0.45, 0.70, 0.35), (0.80, 0.38, 0.42)])
STATEMENTS = ("union(all)", "at_least(2, all)", "difference(0, all)", "union(1, 2) - 0")
VIEW = ((0.75, -1.0, 0.7), (0, 0, 1), 0, 1.15)
WALLS_VIEW = ((0.35, -1.0, 0.45), (0, 0, 1), 0, 1.3)


def layers():
    """A block, two balls and a bar that goes through all of them."""
    bar = turned_about(box((-2.2, -0.3, -0.3), (2.2, 0.3, 0.3)), (0.2, 1, 0.4), 0.5)
    return [
        box((-1, -1, -1), (1, 1, 1)),
        sphere((1.0, -0.9, 0.7), 0.8, 5),
        sphere((-0.3, -1.1, 1.0), 0.7, 5),
        bar,
    ]


def parts():
    """Bodies of one part that overlap, a cavity that nothing leads to, and a ball across both."""
    cavity = sphere((-0.9, 0, 0), 0.55, 5)
    bodies = [
        box((-1.7, -0.7, -0.7), (0.2, 0.7, 0.7)), (cavity[0], cavity[1][:, ::-1]),
        sphere((0.55, 0, 0), 0.8, 5), box((0.4, -0.3, -0.3), (2.0, 0.3, 0.3)),
    ]
    return joined(*bodies)


def draw_resolved():
    """Before and after, both without what lies in front of the plane y = 0."""
    mesh_set = pymeshlab.MeshSet()
    mesh_set.add_mesh(pymeshlab.Mesh(*parts()), "part")
    layers = [0]
    for outer_hull in (False, True):
        made = mesh_set.generate_index_boolean_resolve(mesh=0, outer_hull=outer_hull)
        layers.append(made["resolved_layer"])
    titles = ("before: one layer, cut open", "A resolved", "with outer_hull")
    plotter = pv.Plotter(shape=(1, 3), off_screen=True, border=False, window_size=(1500, 380))

    def opened(layer):
        mesh = mesh_set.mesh(int(layer))
        surface = render_figures.surface_of(mesh.vertex_matrix(), mesh.face_matrix())
        plotter.add_mesh(surface, opacity=0)
        back = surface.clip(normal=(0, 1, 0), origin=(0, 0, 0), invert=False)
        plotter.add_mesh(back, color=COLOURS[0], **render_figures.LOOK)
        walls = surface.slice(normal=(0, 1, 0), origin=(0, 0, 0))
        plotter.add_mesh(walls, color="black", line_width=4)

    for column, (layer, title) in enumerate(zip(layers, titles)):
        render_figures.show(plotter, column, title, WALLS_VIEW, lambda: opened(layer))
    plotter.enable_anti_aliasing("ssaa", all_renderers=True)
    plotter.screenshot(render_figures.ROOT / "docs" / "resolve.png")


def draw_statements():
    mesh_set = pymeshlab.MeshSet()
    operands = layers()
    for number, mesh in enumerate(operands):
        mesh_set.add_mesh(pymeshlab.Mesh(*mesh), f"layer {number}")
    result = mesh_set.generate_index_boolean_expression(expression="; ".join(STATEMENTS))
    plotter = pv.Plotter(
        shape=(1, 1 + len(STATEMENTS)), off_screen=True, border=False, window_size=(1500, 380)
    )

    def given():
        for mesh, colour in zip(operands, COLOURS):
            plotter.add_mesh(
                render_figures.surface_of(*mesh), color=colour, **render_figures.LOOK
            )

    def made(number):
        for operand in operands:  # unseen, so that all panels show the same part of space
            plotter.add_mesh(render_figures.surface_of(*operand), opacity=0)
        mesh = mesh_set.mesh(int(result[f"result_{number}_layer"]))
        surface = render_figures.surface_of(mesh.vertex_matrix(), mesh.face_matrix())
        source = mesh.face_custom_scalar_attribute_array("source_mesh").astype(int)
        surface.cell_data["colour"] = COLOURS[source]
        plotter.add_mesh(surface, scalars="colour", rgb=True, **render_figures.LOOK)

    render_figures.show(plotter, 0, "layers 0, 1, 2, 3", VIEW, given)
    for number, statement in enumerate(STATEMENTS):
        render_figures.show(plotter, number + 1, statement, VIEW, lambda: made(number))
    plotter.enable_anti_aliasing("ssaa", all_renderers=True)
    plotter.screenshot(render_figures.ROOT / "docs" / "expression.png")


if __name__ == "__main__":
    indexboolean.load_plugin()
    draw_statements()
    draw_resolved()
