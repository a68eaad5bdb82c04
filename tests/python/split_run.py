# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The split filter as the tests call it, and the laws that every split obeys."""

import numpy as np
import pymeshlab

import indexboolean
import mesh_laws

NUMBERS = ("source_mesh", "source_face", "sub_surface", "block_front", "block_back")
OPERANDS = ("first", "second")


class Piece:
    """A layer of the filter: arrays, and the numbers of its faces by name."""

    def __init__(self, mesh, names=NUMBERS):
        self.vertices = np.ascontiguousarray(mesh.vertex_matrix())
        self.faces = np.ascontiguousarray(mesh.face_matrix(), dtype=np.int64)
        self.numbers = {}
        for name in names:
            values = mesh.face_custom_scalar_attribute_array(name)
            self.numbers[name] = values.astype(np.int64)
            assert np.array_equal(self.numbers[name], values), f"{name} is no integer"

    def __getitem__(self, name):
        return self.numbers[name]

    def part(self, name, value):
        """The faces whose number of that name is the value: vertices, faces."""
        return self.vertices, self.faces[self.numbers[name] == value]


class Split:
    """A run on two meshes: document, result map, and the three layers of pieces."""

    def __init__(self, first, second, **parameters):
        indexboolean.load_plugin()
        self.operands = (first, second)
        self.mesh_set = pymeshlab.MeshSet()
        for label, (vertices, faces) in zip("AB", self.operands):
            self.mesh_set.add_mesh(pymeshlab.Mesh(vertices, faces), label)
        self.result = self.mesh_set.generate_index_boolean_split(
            first_mesh=0, second_mesh=1, **parameters
        )
        self.surfaces = [self._piece(f"sub_surfaces_{name}") for name in OPERANDS]
        self.blocks = self._piece("sub_blocks", (*NUMBERS, "sub_block"))

    def _piece(self, kind, names=NUMBERS):
        return Piece(self.mesh_set.mesh(self.result[f"{kind}_layer"]), names)

    def block(self, number):
        """The boundary of a sub-block: vertices, faces."""
        return self.blocks.part("sub_block", number)

    def counts(self):
        """(sub-surfaces of the first, of the second, sub-blocks)"""
        result = self.result
        return tuple(
            result[key] for key in ("sub_surfaces_first", "sub_surfaces_second", "sub_blocks")
        )

    def volumes(self):
        """The sub-blocks' volumes, ascending."""
        return np.sort(self.result["sub_blocks_volumes"])


def check_laws(split, tolerance=1e-9):
    """Asserts all that holds for every split, with figures taken from the layers."""
    scale = sum(mesh_laws.area(*mesh) for mesh in split.operands)
    for operand in (0, 1):
        _check_surfaces(split, operand, tolerance * scale)
    _check_blocks(split, tolerance)
    _check_sides(split, tolerance * scale)


def _check_surfaces(split, operand, tolerance):
    piece, name = split.surfaces[operand], f"sub_surfaces_{OPERANDS[operand]}"
    count = split.result[name]
    assert np.array_equal(np.unique(piece["sub_surface"]), np.arange(count))
    assert np.all(piece["source_mesh"] == operand)
    areas = [mesh_laws.area(*piece.part("sub_surface", number)) for number in range(count)]
    assert np.allclose(areas, split.result[f"{name}_areas"], rtol=0, atol=tolerance)
    assert abs(sum(areas) - mesh_laws.area(*split.operands[operand])) <= tolerance
    separating = split.result[f"{name}_separating"]
    for number in range(count):
        chosen = piece["sub_surface"] == number
        sides = np.sort(np.stack([piece["block_front"], piece["block_back"]])[:, chosen], axis=0)
        assert np.all(sides == sides[:, :1]), "a sub-surface has one block on each side"
        assert separating[number] == (sides[0, 0] != sides[1, 0])


def _check_blocks(split, tolerance):
    result, blocks = split.result, split.blocks
    assert np.array_equal(np.unique(blocks["sub_block"]), np.arange(result["sub_blocks"]))
    assert np.all(blocks["block_back"] == blocks["sub_block"])
    assert np.all(blocks["block_front"] != blocks["sub_block"])
    volumes = []
    for number in range(result["sub_blocks"]):
        block = split.block(number)
        assert mesh_laws.unmatched_edges(*block) == 0
        assert len(mesh_laws.zero_area_faces(*block)) == 0
        volumes.append(mesh_laws.volume(*block))
        assert volumes[-1] > 0
    scale = sum(volumes)
    assert np.allclose(volumes, result["sub_blocks_volumes"], rtol=0, atol=tolerance * scale)
    for operand, mesh in enumerate(split.operands):
        inside = result[f"sub_blocks_in_{OPERANDS[operand]}"]
        if mesh_laws.unmatched_edges(*mesh) == 0:
            volume = mesh_laws.volume(*mesh)
            assert abs(np.dot(inside, volumes) - abs(volume)) <= tolerance * scale
        else:
            assert not inside.any()


def _check_sides(split, tolerance):
    """Each side of a separating sub-surface bounds the block that it names, and no other."""
    shared = np.zeros(split.result["sub_blocks"])
    for operand, piece in enumerate(split.surfaces):
        for number in range(split.result["sub_blocks"]):
            front, back = piece["block_front"] == number, piece["block_back"] == number
            faces = piece.faces[front != back]
            chosen = piece["sub_surface"][front != back]
            # A sub-surface of both operands is in both layers, and once in the block's boundary.
            if operand == 1:
                rows = mesh_laws.triangle_rows(piece.vertices, faces)
                turned = mesh_laws.triangle_rows(piece.vertices, mesh_laws.reversed_faces(faces))
                first = mesh_laws.triangle_rows(split.surfaces[0].vertices, split.surfaces[0].faces)
                common = mesh_laws.rows_in(rows, first) | mesh_laws.rows_in(turned, first)
                faces, chosen = faces[~common], chosen[~common]
            shared[number] += mesh_laws.area(piece.vertices, faces)
    areas = [mesh_laws.area(*split.block(number)) for number in range(len(shared))]
    assert np.allclose(areas, shared, rtol=0, atol=tolerance)
    assert np.allclose(areas, split.result["sub_blocks_areas"], rtol=0, atol=tolerance)
