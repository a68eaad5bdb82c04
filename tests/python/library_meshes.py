# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of each library by one interface, for the tests that hold for all of them."""

import meshio
import numpy as np
import pyvista
import trimesh


class Trimesh:
    """trimesh.Trimesh, with vertex_attributes and face_attributes."""

    type = trimesh.Trimesh
    has_polygons = False

    @staticmethod
    def make(vertices, faces, of_vertices, of_faces):
        return trimesh.Trimesh(
            vertices, faces, process=False, vertex_attributes=of_vertices, face_attributes=of_faces
        )

    @staticmethod
    def arrays(mesh):
        return np.array(mesh.vertices), [np.array(face) for face in mesh.faces]

    @staticmethod
    def data(mesh):
        return dict(mesh.vertex_attributes), dict(mesh.face_attributes)


class PyVista:
    """pyvista.PolyData, with point_data and cell_data."""

    type = pyvista.PolyData
    has_polygons = True

    @staticmethod
    def make(vertices, faces, of_vertices, of_faces):
        mesh = pyvista.PolyData.from_irregular_faces(np.asarray(vertices, float), list(faces))
        for name, values in of_vertices.items():
            mesh.point_data[name] = values
        for name, values in of_faces.items():
            mesh.cell_data[name] = values
        return mesh

    @staticmethod
    def arrays(mesh):
        return np.array(mesh.points), [np.array(face) for face in mesh.irregular_faces]

    @staticmethod
    def data(mesh):
        return tuple(
            {name: np.asarray(values) for name, values in data.items()}
            for data in (mesh.point_data, mesh.cell_data)
        )


class Meshio:
    """meshio.Mesh, with a block for each size of faces, point_data and cell_data."""

    type = meshio.Mesh
    has_polygons = True

    @staticmethod
    def make(vertices, faces, of_vertices, of_faces):
        sizes = np.array([len(face) for face in faces])
        blocks = [np.flatnonzero(sizes == size) for size in np.unique(sizes)]
        cells = [np.array([faces[f] for f in block]) for block in blocks]
        types = {3: "triangle", 4: "quad"}
        return meshio.Mesh(
            vertices, [(types.get(block.shape[1], "polygon"), block) for block in cells],
            point_data=dict(of_vertices),
            cell_data={
                name: [np.asarray(values)[block] for block in blocks]
                for name, values in of_faces.items()
            },
        )

    @staticmethod
    def arrays(mesh):
        return mesh.points, [face for block in mesh.cells for face in block.data]

    @staticmethod
    def data(mesh):
        of_faces = {name: np.concatenate(blocks) for name, blocks in mesh.cell_data.items()}
        return mesh.point_data, of_faces


class Arrays:
    """Pairs (vertices, faces); they carry nothing."""

    type = tuple
    has_polygons = True

    @staticmethod
    def make(vertices, faces, of_vertices, of_faces):
        return vertices, faces

    @staticmethod
    def arrays(mesh):
        return mesh[0], list(mesh[1])

    @staticmethod
    def data(mesh):
        return {}, {}


CARRYING = [Trimesh, PyVista, Meshio]
ALL = [*CARRYING, Arrays]


def volume(vertices, faces):
    """What the faces enclose; polygons as fans."""
    total = 0.0
    for face in faces:
        first, *others = vertices[np.asarray(face)]
        for a, b in zip(others, others[1:]):
            total += np.dot(first, np.cross(a, b)) / 6
    return total
