# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""render_textured.py: docs/textured.png, two textured sample meshes, their union and difference.

Each is saved as OBJ with its pictures, and drawn from those files.
"""

import os
import pathlib
import sys
import tempfile

os.environ.setdefault("VTK_DEFAULT_OPENGL_WINDOW", "vtkEGLRenderWindow")  # needs no display

import numpy as np  # noqa: E402
import pymeshlab  # noqa: E402
import pyvista as pv  # noqa: E402
from PIL import Image  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path.append(str(ROOT / "tests" / "python"))

from textured_pair import textured_document  # noqa: E402

TITLES = ("A", "B", "A union B", "A minus B")
DIRECTION = (1.0, -1.2, 0.9)
SIDE = 420  # pixels of each drawing


def save_all(folder):
    """The operands and two blocks as OBJ files, in the order of TITLES."""
    mesh_set = textured_document(folder / "given")
    result = mesh_set.generate_index_boolean(first_mesh=0, second_mesh=1)
    layers = 0, 1, result["union_layer"], result["first_minus_second_layer"]
    paths = []
    for title, layer in zip(TITLES, layers):
        place = folder / title.replace(" ", "_")
        place.mkdir()
        mesh_set.set_current_mesh(layer)
        mesh_set.save_current_mesh(str(place / "mesh.ply"))
        again = pymeshlab.MeshSet()
        again.load_new_mesh(str(place / "mesh.ply"))
        again.save_current_mesh(str(place / "mesh.obj"), save_vertex_color=False)
        paths.append(place / "mesh.obj")
    return paths


def drawing_of(title, path):
    """A picture of one file."""
    plotter = pv.Plotter(off_screen=True, window_size=(SIDE, SIDE))
    plotter.import_obj(path, f"{path}.mtl")
    plotter.set_background("lightgrey")
    plotter.remove_all_lights()
    plotter.add_light(pv.Light(light_type="headlight", intensity=0.7))
    plotter.add_text(title, font_size=12, color="black")
    plotter.view_vector(DIRECTION, viewup=(0, 0, 1))
    plotter.camera.zoom(1.3)
    return plotter.screenshot(return_img=True)


def main():
    with tempfile.TemporaryDirectory() as folder:
        paths = save_all(pathlib.Path(folder))
        drawings = [drawing_of(title, path) for title, path in zip(TITLES, paths)]
    Image.fromarray(np.hstack(drawings)).save(ROOT / "docs" / "textured.png", optimize=True)


if __name__ == "__main__":
    main()
