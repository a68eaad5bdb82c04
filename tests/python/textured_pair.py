# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Two sample meshes with textures made here: layers whose wedges have texture coordinates."""

import numpy as np
import pymeshlab
from PIL import Image

import indexboolean
from sample_catalogue import sample

SIZE = 256  # pixels of a texture's side


def checks():
    """Squares in orange and cream, darker towards the top."""
    y, x = np.mgrid[:SIZE, :SIZE] / SIZE
    even = (np.floor(16 * x) + np.floor(8 * y)) % 2 == 0
    picture = np.where(even[..., None], (226, 120, 50), (250, 236, 205))
    return picture * (0.75 + 0.25 * y[..., None])


def stripes():
    """Slanting stripes in blue and white."""
    y, x = np.mgrid[:SIZE, :SIZE] / SIZE
    even = np.floor(12 * (x + y)) % 2 == 0
    return np.where(even[..., None], (45, 95, 165), (232, 240, 248))


def write_picture(picture, path):
    Image.fromarray(np.uint8(np.round(picture))).save(path)


def longitude_and_latitude(vertices, faces):
    """Wedge coordinates (3m x 2) around the z axis; no face goes the long way round."""
    corners = vertices[faces]
    u = np.arctan2(corners[..., 1], corners[..., 0]) / (2 * np.pi) + 0.5
    u[(u < 0.5) & (np.ptp(u, axis=1) > 0.5)[:, None]] += 1
    v = np.arctan2(corners[..., 2], np.hypot(corners[..., 0], corners[..., 1])) / np.pi + 0.5
    return np.stack([u, v], axis=2).reshape(-1, 2)


def textured_document(folder, *names_and_pictures):
    """textured_layers() in a document that has the package's filters."""
    indexboolean.load_plugin()
    return textured_layers(folder, *names_and_pictures)


def textured_layers(folder, names=("checks.png", "stripes.png"), pictures=(checks, stripes)):
    """The bumpy sphere and the ribbed torus as layers, with their textures from the folder."""
    mesh_set = pymeshlab.MeshSet()
    meshes = sample("bumpy_sphere"), sample("ribbed_torus")
    for label, mesh, name, picture in zip(("sphere", "torus"), meshes, names, pictures):
        path = folder / label / name
        path.parent.mkdir(exist_ok=True, parents=True)
        write_picture(picture(), path)
        layer = pymeshlab.Mesh(*mesh, w_tex_coords_matrix=longitude_and_latitude(*mesh))
        mesh_set.add_mesh(layer, label)
        mesh_set.set_texture_per_mesh(textname=str(path))
    return mesh_set
