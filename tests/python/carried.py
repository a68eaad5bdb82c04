# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Operands that carry every attribute, and what a layer made of them must carry.

Shares nothing with the library under test: parents are taken from source_mesh and source_face, but
the weights of new points are solved for anew, by least squares in the parent's plane.
"""

import numpy as np
import pymeshlab

import indexboolean

# Per attribute: how it is read from a layer, and what MeshLab has where there is none.
VERTEX_READERS = {
    "colour": (lambda m: m.vertex_color_matrix()[:, :4] * 255, (255, 255, 255, 255)),
    "quality": (lambda m: m.vertex_scalar_array()[:, None], (0,)),
    "texture": (lambda m: m.vertex_tex_coord_matrix(), (0, 0)),
    "normal": (lambda m: m.vertex_normal_matrix(), None),
    "direction 1": (lambda m: m.vertex_curvature_principal_dir1_matrix(), (0, 0, 0)),
    "scalar": (lambda m: m.vertex_custom_scalar_attribute_array("heat")[:, None], (0,)),
    "point": (lambda m: m.vertex_custom_point_attribute_matrix("flow"), (0, 0, 0)),
    "selection": (lambda m: m.vertex_selection_array()[:, None], (0,)),
}
FACE_READERS = {
    "colour": (lambda m: m.face_color_matrix() * 255, (255, 255, 255, 255)),
    "quality": (lambda m: m.face_scalar_array()[:, None], (0,)),
    "scalar": (lambda m: m.face_custom_scalar_attribute_array("part")[:, None], (0,)),
    "point": (lambda m: m.face_custom_point_attribute_matrix("axis"), (0, 0, 0)),
    "selection": (lambda m: m.face_selection_array()[:, None], (0,)),
}


def add_carrier(mesh_set, mesh, seed, label, attributes=True):
    """Adds the mesh as a layer with random values of all attributes, or with none."""
    vertices, faces = mesh
    if not attributes:
        mesh_set.add_mesh(pymeshlab.Mesh(vertices, faces), label)
        return
    rng = np.random.default_rng(seed)
    n, m = len(vertices), len(faces)
    colours = rng.integers(0, 256, (n + m, 4)) / 255
    mesh_set.add_mesh(
        pymeshlab.Mesh(
            vertices,
            faces,
            v_normals_matrix=rng.normal(size=(n, 3)),
            v_scalar_array=rng.normal(size=n),
            f_scalar_array=rng.normal(size=m),
            v_color_matrix=colours[:n],
            f_color_matrix=colours[n:],
            v_tex_coords_matrix=rng.uniform(size=(n, 2)),
            w_tex_coords_matrix=rng.uniform(size=(3 * m, 2)),
        ),
        label,
    )
    layer = mesh_set.current_mesh()
    layer.add_vertex_custom_scalar_attribute(rng.normal(size=n), "heat")
    layer.add_vertex_custom_point_attribute(rng.normal(size=(n, 3)), "flow")
    layer.add_face_custom_scalar_attribute(rng.normal(size=m), "part")
    layer.add_face_custom_point_attribute(rng.normal(size=(m, 3)), "axis")
    mesh_set.compute_curvature_principal_directions_per_vertex(method="Taubin approximation")
    side = vertices[:, 0] > np.median(vertices[:, 0])
    mesh_set.compute_selection_by_condition_per_vertex(
        condselect=f"(x > {float(np.median(vertices[side, 0]))!r})"
    )
    mesh_set.compute_selection_by_condition_per_face(condselect="(fi < 6)")


def carriers(first, second, second_has=True):
    """A document with both operands."""
    indexboolean.load_plugin()
    mesh_set = pymeshlab.MeshSet()
    add_carrier(mesh_set, first, 1, "A")
    add_carrier(mesh_set, second, 2, "B", second_has)
    return mesh_set


class Parents:
    """Where the elements of a layer came from, by its own attributes and by its coordinates."""

    def __init__(self, layer, operands):
        self.layer, self.operands = layer, operands
        self.points = layer.vertex_matrix()
        self.faces = layer.face_matrix()
        self.mesh = layer.face_custom_scalar_attribute_array("source_mesh").astype(int)
        self.face = layer.face_custom_scalar_attribute_array("source_face").astype(int)
        self.vertex_mesh = layer.vertex_custom_scalar_attribute_array("source_mesh").astype(int)
        self.vertex = layer.vertex_custom_scalar_attribute_array("source_vertex").astype(int)

    def corners(self, face):
        """The parent's three vertices."""
        return self.operands[self.mesh[face]].face_matrix()[self.face[face]]

    def weights(self, face, vertex):
        """The vertex as a mean of its face's parent's corners."""
        corners = self.operands[self.mesh[face]].transformed_vertex_matrix()[self.corners(face)]
        system = np.vstack([corners.T - corners.mean(axis=0)[:, None], np.ones(3)])
        right = np.append(self.points[vertex] - corners.mean(axis=0), 1)
        return np.linalg.lstsq(system, right, rcond=None)[0]

    def faces_like(self, vertex, chosen):
        """The faces at a vertex of the operand that its chosen one is of."""
        at_vertex = np.flatnonzero((self.faces == vertex).any(axis=1))
        return at_vertex[self.mesh[at_vertex] == self.mesh[chosen[vertex]]]

    def faces_at(self):
        """Per vertex, a face of the first operand, else of the second."""
        chosen = np.full(len(self.points), -1)
        for operand in (1, 0):
            for face in np.flatnonzero(self.mesh == operand):
                chosen[self.faces[face]] = face
        return chosen
