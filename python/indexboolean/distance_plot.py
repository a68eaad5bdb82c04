# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of distances: meshes in blue, white and red with their scale, and a histogram.

in: {side: (vertices, faces, distances)}; out: PNG files. Needs pyvista, and no display.
"""

import os
import sys

if sys.platform == "linux":
    os.environ.setdefault("VTK_DEFAULT_OPENGL_WINDOW", "vtkEGLRenderWindow")

import matplotlib.figure  # noqa: E402
import numpy as np  # noqa: E402
import pyvista as pv  # noqa: E402

_COLOURS = "RdBu_r"  # of two ends, with white between them
_BACKGROUND = "white"
_VIEW = (1.0, 0.6, 0.55)  # towards the camera


def colour_limit(meshes):
    """The largest of all distances, by its size; 1 if there is none."""
    sizes = [np.nanmax(np.abs(d), initial=0) for _, _, d in meshes.values() if len(d)]
    return max(sizes, default=0) or 1.0


def draw_mesh(plotter, column, title, mesh, limit):
    """One panel: mesh is (vertices, faces, distances, kind)."""
    vertices, faces, distances, kind = mesh
    plotter.subplot(0, column)
    plotter.set_background(_BACKGROUND)
    surface = (
        pv.PolyData.from_regular_faces(vertices, faces) if len(faces) else pv.PolyData(vertices)
    )
    plotter.add_text(title, position="upper_edge", font_size=11, color="black")
    data = surface.point_data if kind == "vertex" else surface.cell_data
    data[title] = distances
    plotter.add_mesh(
        surface, scalars=title, cmap=_COLOURS, clim=(-limit, limit), nan_color="grey",
        # The bar's own title would lie on its labels.
        scalar_bar_args=dict(title=" " * (column + 1), color="black", vertical=False, fmt="%.3g"),
    )
    plotter.view_vector(_VIEW)


def draw_meshes(meshes, kind, path):
    """One picture, a mesh beside the other, with a common scale. kind: "vertex" or "face"."""
    limit = colour_limit(meshes)
    size = (700 * len(meshes), 600)
    plotter = pv.Plotter(shape=(1, len(meshes)), off_screen=True, window_size=size)
    for column, side in enumerate(meshes):
        draw_mesh(plotter, column, f"distance of the {side}", (*meshes[side], kind), limit)
    plotter.screenshot(path)
    plotter.close()


def draw_histogram(meshes, path):
    """How often which distance occurs, of each mesh."""
    figure = matplotlib.figure.Figure(figsize=(7, 4), dpi=120, layout="constrained")
    axes = figure.add_subplot()
    for side, (_, _, distances) in meshes.items():
        found = distances[np.isfinite(distances)]
        axes.hist(found, bins=100, histtype="step", label=f"{side}: {len(found)} values")
    axes.set_xlabel("distance")
    axes.set_ylabel("values")
    axes.legend()
    figure.savefig(path)
