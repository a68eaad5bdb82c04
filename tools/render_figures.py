# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""render_figures.py [NAME...]: the pictures of docs/paper_figures.md, docs/figure_NAME.png, and
those of the filters' pages, docs/split.png and docs/curves.png.

Each shows the two operands with their loops, then the sub-surfaces of each, then the sub-blocks,
pulled apart; that of the curves the operands, then their lines. Those of other people's meshes need
the folder that INDEXBOOLEAN_MESHES names.
"""

import os
import pathlib
import sys

os.environ.setdefault("VTK_DEFAULT_OPENGL_WINDOW", "vtkEGLRenderWindow")  # needs no display

import numpy as np  # noqa: E402
import pyvista as pv  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path.append(str(ROOT / "tests" / "python"))

import paper_figures  # noqa: E402
from open_shapes import bumpy_sheet  # noqa: E402
from sample_catalogue import sample  # noqa: E402

FIRST_COLOUR, SECOND_COLOUR = (0.30, 0.54, 0.78), (0.96, 0.64, 0.24)
LOOP_COLOURS = ("black", (0.9, 0.0, 0.1), (0.85, 0.0, 0.75))  # open, hard-closed, soft-closed
LOOK = dict(
    smooth_shading=True, split_sharp_edges=True, specular=0.15, specular_power=15, ambient=0.18
)
# name: direction to the camera, upwards, how far pieces are pulled apart, what fills the picture
VIEWS = {
    "blocks": ((1.0, 0.6, 0.55), (0, 0, 1), 0.45, 1.15),
    "open": ((0.55, -1.0, 0.75), (0, 0, 1), 0.12, 0.95),
    "falcon": ((-0.75, 0.3, 0.9), (0, 1, 0), 0.3, 1.0),
    "lion": ((0.95, 0.45, 0.3), (0, 0, 1), 0.3, 0.95),
    "cylinders": ((0.8, 0.9, 0.7), (0, 0, 1), 0.4, 1.1),
    "tori": ((1.0, 0.6, 0.65), (0, 0, 1), 0.4, 1.1),
    "split": ((0.55, -1.0, 0.45), (0, 0, 1), 0.35, 0.95),
    "curves": ((1.0, 0.35, 0.55), (0, 0, 1), 0, 1.5),
}
# The pages' own pairs; all others are the paper's.
PAIRS = {
    "split": lambda: (sample("statue"), bumpy_sheet((0.15, -0.1, 1), 1.2, 0.8, bump=0.015)),
    "curves": lambda: (sample("bumpy_sphere"), sample("ribbed_torus")),
}
ATTRIBUTIONS = {
    "falcon": "Falcon statue: colinfizgig, odedstein-meshes, CC BY-NC-SA 4.0",
    "lion": "Lion statue: tomburtonwood, odedstein-meshes, CC BY-SA 3.0",
}


def surface_of(vertices, faces):
    return pv.PolyData.from_regular_faces(vertices, faces)


def pieces_of(mesh_set, layers):
    """The layers' surfaces, each with the colour of its first face."""
    pieces = []
    for layer in layers:
        mesh = mesh_set.mesh(int(layer))
        if mesh.face_number():
            surface = surface_of(mesh.vertex_matrix(), mesh.face_matrix())
            pieces.append((surface, tuple(mesh.face_color_matrix()[0][:3])))
    return pieces


def pulled_apart(pieces, amount):
    """The pieces moved away from the middle of all, by their own middles."""
    boxes = np.array([piece.bounds for piece, _ in pieces]).reshape(-1, 3, 2)
    middles = np.array([piece.points.mean(axis=0) for piece, _ in pieces])
    middle = (boxes[:, :, 0].min(axis=0) + boxes[:, :, 1].max(axis=0)) / 2
    return [
        (piece.translate(amount * (own - middle)), colour)
        for (piece, colour), own in zip(pieces, middles)
    ]


def add_loops(plotter, mesh_set, result, width):
    mesh = mesh_set.mesh(int(result["curves_layer"]))
    if mesh.edge_number() == 0:
        return
    kinds = mesh.vertex_custom_scalar_attribute_array("loop_kind")
    edges = mesh.edge_matrix()
    for kind, colour in enumerate(LOOP_COLOURS):
        chosen = edges[kinds[edges[:, 0]] == kind]
        if len(chosen):
            lines = np.insert(chosen, 0, 2, axis=1).ravel()
            plotter.add_mesh(
                pv.PolyData(mesh.vertex_matrix(), lines=lines), color=colour, line_width=width,
                render_lines_as_tubes=True,
            )


def add_borders(plotter, piece):
    border = piece.extract_feature_edges(feature_edges=False, manifold_edges=False)
    if border.n_cells:
        plotter.add_mesh(border, color=(0.15, 0.15, 0.15), line_width=2)


def show(plotter, column, title, view, contents):
    plotter.subplot(0, column)
    plotter.set_background("white")
    plotter.add_text(title, position="upper_edge", font_size=11, color="black")
    contents()
    direction, up, _, zoom = view
    plotter.view_vector(direction, viewup=up)
    plotter.camera.zoom(zoom)


def draw_curves(name, path):
    """Before: the operands; after: the lines in which they meet, by kind."""
    pair, view = PAIRS[name](), VIEWS[name]
    mesh_set, _ = paper_figures.split(*pair)
    curves = mesh_set.generate_index_boolean_curves(first_mesh=0, second_mesh=1)
    plotter = pv.Plotter(shape=(1, 2), off_screen=True, border=False, window_size=(1000, 440))

    def operands():
        for mesh, colour in zip(pair, (FIRST_COLOUR, SECOND_COLOUR)):
            plotter.add_mesh(surface_of(*mesh), color=colour, **LOOK)

    def lines():
        for mesh in pair:  # unseen, so that both panels show the same part of space
            plotter.add_mesh(surface_of(*mesh), opacity=0)
        add_loops(plotter, mesh_set, curves, 4)

    loops = sum(curves[f"loops_{kind}"] for kind in ("open", "hard_closed", "soft_closed"))
    show(plotter, 0, "before: A and B", view, operands)
    show(plotter, 1, f"after: their {loops} loops", view, lines)
    plotter.enable_anti_aliasing("ssaa", all_renderers=True)
    plotter.screenshot(path)


def draw_pieces(name, path):
    pair = (PAIRS[name] if name in PAIRS else paper_figures.FIGURES[name][2])()
    view = VIEWS[name]
    mesh_set, result = paper_figures.split(*pair, separate_layers=True)
    curves = mesh_set.generate_index_boolean_curves(first_mesh=0, second_mesh=1)
    has_blocks = result["sub_blocks"] > 0
    plotter = pv.Plotter(
        shape=(1, 4 if has_blocks else 3), off_screen=True, border=False,
        window_size=(1480 if has_blocks else 1260, 400 if has_blocks else 440),
    )

    def operands():
        for mesh, colour in zip(pair, (FIRST_COLOUR, SECOND_COLOUR)):
            plotter.add_mesh(surface_of(*mesh), color=colour, **LOOK)
        add_loops(plotter, mesh_set, curves, 5)

    def pieces(kind):
        found = pulled_apart(pieces_of(mesh_set, result[f"{kind}_layers"]), view[2])
        for piece, colour in found:
            plotter.add_mesh(piece, color=colour, **LOOK)
            add_borders(plotter, piece)

    show(plotter, 0, "A, B and their loops", view, operands)
    kinds = ("sub_surfaces_first", "sub_surfaces_second", "sub_blocks")[: 3 if has_blocks else 2]
    for column, (kind, what) in enumerate(
        zip(kinds, ("sub-surfaces of A", "sub-surfaces of B", "sub-blocks")), start=1
    ):
        show(plotter, column, f"{result[kind]} {what}", view, lambda: pieces(kind))
    if name in ATTRIBUTIONS:
        plotter.subplot(0, 0)
        plotter.add_text(ATTRIBUTIONS[name], position="lower_left", font_size=8, color="black")
    plotter.enable_anti_aliasing("ssaa", all_renderers=True)
    plotter.screenshot(path)


def main(names):
    for name in names or VIEWS:
        file = f"{name}.png" if name in PAIRS else f"figure_{name}.png"
        draw = draw_curves if name == "curves" else draw_pieces
        draw(name, ROOT / "docs" / file)


if __name__ == "__main__":
    main(sys.argv[1:])
