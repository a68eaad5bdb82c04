# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""meshio.Mesh: its triangles, quads and polygons, point data, cell data, sets and field data.

meshio itself is what the caller has imported. Vertices and lines bound nothing and are left out,
with their cell data.
"""

import sys

import numpy as np

from .mesh_record import Column, check_lengths, checked_record, columns_of, is_of

_FACES = ("triangle", "quad", "polygon")
_NO_SETS = ("gmsh:bounding_entities",)  # meshio keeps the tags of a block's boundary among the sets
HAS_POLYGONS = True


def is_mesh(mesh):
    """Whether it is a meshio.Mesh."""
    return is_of("meshio", "Mesh", mesh)


def read_all(meshes):
    """A MeshRecord of each."""
    return [_read(mesh) for mesh in meshes]


def write(record, operands):
    """A Mesh with a block of triangles, one of quads, and one of polygons of each other size."""
    sizes, blocks, faces = [3], [slice(None)], [record.faces]
    if record.has_polygons and not record.faces:
        faces = [np.empty((0, 3), dtype=int)]  # meshio writes no mesh without a block
    elif record.has_polygons:
        counts = np.array([len(face) for face in record.faces])
        sizes = np.unique(counts)
        blocks = [np.flatnonzero(counts == size) for size in sizes]
        faces = [np.array([record.faces[f] for f in block]) for block in blocks]
    types = [_FACES[min(size, 5) - 3] for size in sizes]
    point_sets, point_data = _parted(record.of_vertices)
    cell_sets, cell_data = _parted(record.of_faces)
    return sys.modules["meshio"].Mesh(
        record.vertices, list(zip(types, faces)), point_data=point_data,
        cell_data={
            name: [values[block] for block in blocks] for name, values in cell_data.items()
        },
        field_data={
            name: values for mesh in reversed(operands) for name, values in mesh.field_data.items()
        },
        point_sets={name: np.flatnonzero(values) for name, values in point_sets.items()},
        cell_sets={
            name: [np.flatnonzero(values[block]) for block in blocks]
            for name, values in cell_sets.items()
        },
    )


def _parted(columns):
    """({name: flags} of the sets, {name: values} of the data)."""
    sets = {name[1]: c.values for name, c in columns.items() if isinstance(name, tuple)}
    return sets, {name: c.values for name, c in columns.items() if not isinstance(name, tuple)}


def _read(mesh):
    kept = [number for number, block in enumerate(mesh.cells) if _is_surface(block)]
    faces = [mesh.cells[number].data for number in kept]
    is_triangles = all(np.ndim(data) == 2 and np.shape(data)[1] == 3 for data in faces)
    if is_triangles:
        faces = np.concatenate(faces) if faces else np.empty((0, 3), dtype=int)
    else:
        faces = [face for data in faces for face in data]
    of_vertices = columns_of(mesh.point_data.items())
    of_faces = {
        name: Column(np.concatenate(_of_blocks(mesh, kept, name, data)))
        for name, data in mesh.cell_data.items() if kept
    }
    for name, members in mesh.point_sets.items():
        of_vertices["set", name] = Column(_flags(len(mesh.points), members, name))
    for name, members in mesh.cell_sets.items():
        if name in _NO_SETS:
            continue
        _check_blocks(mesh, "cell set", name, members)
        flags = [_flags(len(mesh.cells[number].data), members[number], name) for number in kept]
        of_faces["set", name] = Column(np.concatenate(flags or [np.zeros(0, dtype=bool)]))
    return checked_record(mesh.points, faces, of_vertices=of_vertices, of_faces=of_faces)


def _of_blocks(mesh, kept, name, data):
    """The values of those blocks, as arrays, each with a row for each of its cells."""
    _check_blocks(mesh, "cell data", name, data)
    values = [np.asarray(data[number]) for number in kept]
    for number, of_block in zip(kept, values):
        check_lengths("cell", len(mesh.cells[number].data), {f"{name}, {number}": Column(of_block)})
    return values


def _check_blocks(mesh, kind, name, data):
    if len(data) != len(mesh.cells):
        raise ValueError(
            f'its {kind} "{name}" has {len(data)} blocks, not {len(mesh.cells)}, one for each '
            "block of cells"
        )


def _is_surface(block):
    """Whether its cells are faces; False: they bound nothing. Raises ValueError of all others."""
    if block.type in _FACES:
        return True
    if block.dim < 2:
        return False
    remedy = (
        "Take its boundary, the faces that one cell alone has" if block.dim == 3
        else "Leave out the nodes on its edges: the first three columns of a triangle's, four of a "
        "quad's"
    )
    raise ValueError(f"it has cells of type {block.type}, {len(block.data)} of them. {remedy}")


def _flags(count, members, name):
    """Whether each of `count` points, or cells, is in the set of that name."""
    flags = np.zeros(count, dtype=bool)
    members = np.asarray([] if members is None else members, dtype=int)
    beyond = members[(members < 0) | (members >= count)]
    if len(beyond) > 0:
        raise ValueError(f'its set "{name}" names number {beyond[0]}, of which there are {count}')
    flags[members] = True
    return flags
