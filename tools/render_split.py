# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""render_split.py: docs/split_faults.png, a block cut by five faults at once, pulled apart; and
docs/clip.png, an open scan, what of it lies inside a box, and what outside.
"""

import pymeshlab
import pyvista as pv
from render_figures import (
    FIRST_COLOUR, LOOK, ROOT, SECOND_COLOUR, add_borders, pieces_of, pulled_apart, show, surface_of,
)

import indexboolean
from conftest import box
from open_shapes import bumpy_sheet
from sample_catalogue import sample

BLOCK = box((-1.5, -1, -0.6), (1.5, 1, 0.6))
FAULTS = [
    bumpy_sheet(normal, height, 2.2, steps=40, bump=0.03)
    for normal, height in (
        ((0.1, 0.05, 1), 0.18), ((0.05, -0.1, 1), -0.25), ((1, 0.2, 0.35), -0.55),
        ((1, -0.3, -0.3), 0.6), ((0.25, 1, 0.2), 0.1),
    )
]
FAULTS_VIEW = ((0.75, -1.0, 0.7), (0, 0, 1), 0.3, 1.15)
CLIP_VIEW = ((0.55, -1.0, 0.35), (0, 0, 1), 0, 1.0)


def document(*meshes):
    indexboolean.load_plugin()
    mesh_set = pymeshlab.MeshSet()
    for vertices, faces in meshes:
        mesh_set.add_mesh(pymeshlab.Mesh(vertices, faces))
    return mesh_set


def plotter_of(panels):
    return pv.Plotter(
        shape=(1, panels), off_screen=True, border=False, window_size=(500 * panels, 440)
    )


def save(plotter, name):
    plotter.enable_anti_aliasing("ssaa", all_renderers=True)
    plotter.screenshot(ROOT / "docs" / name)


def draw_faults():
    mesh_set = document(BLOCK, *FAULTS)
    result = mesh_set.generate_index_boolean_split(
        layers="all", sub_surfaces=False, separate_layers=True, max_layers=1000
    )
    plotter = plotter_of(2)

    def operands():
        plotter.add_mesh(surface_of(*BLOCK), color=FIRST_COLOUR, **LOOK)
        for fault in FAULTS:
            plotter.add_mesh(surface_of(*fault), color=SECOND_COLOUR, opacity=0.35, **LOOK)

    def blocks():
        for piece, colour in pulled_apart(
            pieces_of(mesh_set, result["sub_blocks_layers"]), FAULTS_VIEW[2]
        ):
            plotter.add_mesh(piece, color=colour, **LOOK)

    show(plotter, 0, "before: a block and five faults", FAULTS_VIEW, operands)
    show(plotter, 1, f"after: {result['sub_blocks']} sub-blocks", FAULTS_VIEW, blocks)
    save(plotter, "split_faults.png")


def open_scan():
    """The statue as a scanner leaves it: nothing below its base has been seen."""
    vertices, faces = sample("statue")
    low, high = vertices[:, 2].min(), vertices[:, 2].max()
    return vertices, faces[vertices[faces][:, :, 2].max(axis=1) > low + 0.08 * (high - low)]


def draw_clip():
    scan = open_scan()
    low, high = scan[0].min(axis=0), scan[0].max(axis=0)
    size = high - low
    trim = box(low + size * (-0.1, 0.15, 0.35), high + size * (0.1, -0.15, -0.12))
    mesh_set = document(scan, trim)
    result = mesh_set.generate_index_boolean_split(
        sub_surfaces_first=False, sub_surfaces_second=False, sub_blocks=False,
        first_inside_second=True, first_outside_second=True,
    )
    plotter = plotter_of(3)

    def operands():
        plotter.add_mesh(surface_of(*scan), color=FIRST_COLOUR, **LOOK)
        plotter.add_mesh(surface_of(*trim), color=SECOND_COLOUR, opacity=0.45, **LOOK)

    def clip(name):
        for mesh in (scan, trim):  # unseen, so that all panels show the same part of space
            plotter.add_mesh(surface_of(*mesh), opacity=0)
        layer = mesh_set.mesh(result[f"{name}_layer"])
        piece = surface_of(layer.vertex_matrix(), layer.face_matrix())
        plotter.add_mesh(piece, color=FIRST_COLOUR, **LOOK)
        add_borders(plotter, piece)

    show(plotter, 0, "before: an open scan (A) and a box (B)", CLIP_VIEW, operands)
    show(plotter, 1, "A inside B", CLIP_VIEW, lambda: clip("first_inside_second"))
    show(plotter, 2, "A outside B", CLIP_VIEW, lambda: clip("first_outside_second"))
    save(plotter, "clip.png")


if __name__ == "__main__":
    draw_faults()
    draw_clip()
