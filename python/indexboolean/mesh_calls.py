# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The filters as functions on meshes of other libraries: trimesh.Trimesh, pyvista.PolyData,
meshio.Mesh, or pairs of arrays (vertices, faces).

What comes back is of the type of the first mesh, with all that the meshes carried. Meshes are not
changed. All functions take the filters' other parameters as keywords, lengths as numbers; report, a
dict, is given the filter's result map; and with sources new meshes have the data source_mesh,
source_face and source_vertex.

They raise MeshRefusal with the refusal's sentence and the numbers of the faces in question,
TypeError for what is no mesh or no option, ValueError for values that an option does not have,
MemoryError and HostError. A result some of whose faces meet others wrongly as stored is a
RuntimeWarning.
"""

import collections.abc
import re
import typing
import warnings

import numpy as np

from .evaluate_job import result_names
from .expression_text import ExpressionError, ExpressionText, check_operand_name
from .known_meshes import KnownMeshes, kind_of
from .mesh_document import MeshDocument, MeshRefusal
from .mesh_record import Column, MeshRecord
from .option_values import length, truth
from .split_job import CLIPS, SUB_BLOCKS, SUB_SURFACES, SUB_SURFACES_OF_LIST

_BLOCKS = {
    name: name for name in (
        "union", "intersection", "first_minus_second", "second_minus_first", "symmetric_difference",
    )
}
OPERATIONS = {**_BLOCKS, "difference": "first_minus_second", "xor": "symmetric_difference"}
_NUMBERS = ("sub_surface", "block_front", "block_back")
# Parameters of the filters that would have no effect here, and so are no options.
_NO_LAYERS = {"curves": False, "select_curve_vertices": False}
_NO_PIECES = {
    **{name: True for name in SUB_SURFACES}, **{clip: False for clip in CLIPS},
    "separate_layers": False, "max_layers": 64,
}


class SplitPieces(typing.NamedTuple):
    """sub_surfaces: for each mesh, the list of its pieces; sub_blocks: the list of parts of space.

    A piece's place in its list is its number in the result map and in the faces' data.
    """

    sub_surfaces: list
    sub_blocks: list


def boolean(first, second, operation="union", *, sources=False, report=None, **options):
    """The union, intersection, difference or symmetric difference of two closed meshes.

    operation: "union", "intersection", "difference" (or "first_minus_second"),
    "second_minus_first", "symmetric_difference" (or "xor"); or several of them, which cost one
    intersection together: then a dict of meshes by these names.
    """
    asked = _operations_of(operation)
    known = KnownMeshes({"first": first, "second": second})
    document = _document(known, [0], options)
    blocks = {OPERATIONS[name] for name in asked}
    own = {"first_mesh": 0, "second_mesh": 1, **{name: name in blocks for name in _BLOCKS}}
    own.update(_NO_LAYERS)
    result = _run(document, "generate_index_boolean", own, options, sources, report)
    meshes = {}
    for name in asked:
        block = OPERATIONS[name]
        _warn_unless_it_holds(name, result[f"{block}_self_intersections"])
        record = document.record_of(result[f"{block}_layer"], with_sources=sources)
        meshes[name] = known.mesh_of(record)
    return meshes[operation] if isinstance(operation, str) else meshes


def evaluate(expression, meshes, *, sources=False, report=None, **options):
    """The mesh that an expression over closed meshes makes; of several statements a dict of them.

    meshes: {name: mesh}; expression: a text with these names, such as "a - (b | c)". The k-th
    statement, from 0 on, is "result_<k>" if it has no name; another's name must not be that.
    """
    text = _text_of(expression, meshes)
    known = KnownMeshes(meshes)
    document = _document(known, [0], options)
    own = {"expression": text.translated, "hide_operands": False, **_NO_LAYERS}
    try:
        result = _run(
            document, "generate_index_boolean_expression", own, options, sources, report
        )
    except MeshRefusal as error:
        raise MeshRefusal(text.explained(error.sentence), error.operand, error.faces) from None
    made = {}
    for number, name in enumerate(result_names(text)):
        _warn_unless_it_holds(name, result[f"result_{number}_self_intersections"])
        record = document.record_of(
            result[f"result_{number}_layer"], result["operand_layers"], sources
        )
        made[name] = known.mesh_of(record)
    return next(iter(made.values())) if len(made) == 1 else made


def resolve(mesh, *, sources=False, report=None, **options):
    """A closed mesh that meets itself as one that does not; outer_hull: without what is inside."""
    known = KnownMeshes({"mesh": mesh})
    document = _document(known, [0], options)
    own = {"mesh": 0, "select_curve_vertices": False}
    result = _run(document, "generate_index_boolean_resolve", own, options, sources, report)
    _warn_unless_it_holds("resolved mesh", result["resolved_self_intersections"])
    return known.mesh_of(document.record_of(result["resolved_layer"], with_sources=sources))


def split(*meshes, sources=False, report=None, **options):
    """SplitPieces of any number of meshes, open or closed, that cut each other.

    sub_surfaces=False, sub_blocks=False: that list stays empty. Faces have the data sub_surface,
    block_front and block_back.
    """
    known = KnownMeshes({f"mesh {number}": mesh for number, mesh in enumerate(meshes)})
    document = _document(known, range(len(meshes)), options)
    own = {
        "first_mesh": 0, "second_mesh": min(1, len(meshes) - 1), "hide_operands": False,
        "layers": ",".join(str(number) for number in range(len(meshes))), **_NO_PIECES,
    }
    result = document.run("generate_index_boolean_split", own, options)
    _report(result, report)
    surfaces = [[] for _ in meshes]
    for number in range(len(meshes)):
        kind = f"{SUB_SURFACES_OF_LIST}_{number}"
        if options.get(SUB_SURFACES_OF_LIST, True):
            record = document.record_of(result[f"{kind}_layer"], None, sources, _NUMBERS)
            _warn_unless_it_holds(f"sub-surfaces of mesh {number}", _sum_of(result, kind))
            pieces = _pieces(record, "sub_surface", int(result[kind]))
            surfaces[number] = [known.mesh_of(piece, number) for piece in pieces]
    blocks = []
    if options.get(SUB_BLOCKS, True):
        names = (*_NUMBERS, "sub_block")
        record = document.record_of(result["sub_blocks_layer"], None, sources, names)
        _warn_unless_it_holds("sub-blocks", _sum_of(result, SUB_BLOCKS))
        pieces = _pieces(record, "sub_block", int(result[SUB_BLOCKS]))
        blocks = [known.mesh_of(piece) for piece in pieces]
    return SplitPieces(surfaces, blocks)


def distance(first, second, *, both_ways=False, report=None, **options):
    """A copy of the first mesh with its distances from the second one, with an exact sign.

    Its vertices have the data distance, and its faces, where all are triangles, that of their
    centres; with direction=True distance_direction, with closest=True closest_point and
    closest_face, too. both_ways: a pair of meshes, each with its distances from the other. Of a
    pair of arrays the distances themselves come back: (of vertices, of faces).
    """
    known = KnownMeshes({"first": first, "second": second})
    document = MeshDocument(known.records, known.names, columns=False)
    own = {"first_mesh": 0, "second_mesh": 1, "both_ways": both_ways, "color": False}
    result = document.run("compute_index_boolean_distance", own, options)
    _report(result, report)
    sides = (0, 1) if both_ways else (0,)
    measured = [_with_distances(known, document, number) for number in sides]
    return tuple(measured) if both_ways else measured[0]


def _operations_of(operation):
    """The names of what is asked for, a list."""
    try:
        asked = [operation] if isinstance(operation, str) else list(operation)
    except TypeError:
        asked = [operation]
    for name in asked:
        if not isinstance(name, str):
            raise TypeError(
                'operation is a name such as "union", or several names, and not of type '
                f'{kind_of(name)}; evaluate("a | b | c", {{"a": a, "b": b, "c": c}}) is of more '
                "than two meshes"
            )
        if name not in OPERATIONS:
            raise ValueError(f"there is no operation {name!r}; there are {', '.join(OPERATIONS)}")
    if not asked:
        raise ValueError(f"no operation is asked for; there are {', '.join(OPERATIONS)}")
    return asked


def _text_of(expression, meshes):
    """The ExpressionText, if it is a text and the meshes are a dict with names for it."""
    if not isinstance(expression, str):
        kind = kind_of(expression)
        raise TypeError(f'expression is a text such as "a - b", and not of type {kind}')
    if not isinstance(meshes, collections.abc.Mapping):
        raise TypeError(
            'meshes are a dict of the names in the expression, such as {"a": a, "b": b}, and not '
            f"of type {kind_of(meshes)}"
        )
    for name in meshes:
        if not isinstance(name, str):
            raise TypeError(f'a name of a mesh is a text such as "a", not {name!r}')
        check_operand_name(name, "mesh")
    try:
        text = ExpressionText(expression, list(meshes), "mesh")
    except ExpressionError as error:
        raise MeshRefusal(str(error)) from None
    names = result_names(text)
    for number, (name, own) in enumerate(zip(names, text.statement_names())):
        if own is None and names.count(name) > 1:
            raise MeshRefusal(
                f"Statement {number}, counted from 0, has no name of its own and would be "
                f'"{name}", which is the name of another one. Give it a name.'
            )
    return text


def _document(known, results, options):
    """The meshes as a document; results: which of them what is made will be of the type of."""
    merges = (
        truth("merge_coplanar", options.get("merge_coplanar", False))
        or length("merge_tolerance", options.get("merge_tolerance", 0)) > 0
    )
    return MeshDocument(
        known.records, known.names, keeps_polygons=known.can_have_polygons(results) and not merges,
        classes=merges,
        columns=truth("transfer_attributes", options.get("transfer_attributes", True)),
    )


def _run(document, filter_name, own, options, sources, report):
    """Runs a filter; elements say where they come from only if somebody asks."""
    options = {**options, "transfer_attributes": bool(sources) or document.has_columns}
    result = document.run(filter_name, own, options)
    _report(result, report)
    return result


def _report(result, report):
    """Fills the caller's dict; layers are no concern of it."""
    if report is not None:
        report.update((k, v) for k, v in result.items() if not re.search("_layers?$", k))


def _sum_of(result, kind):
    return int(np.maximum(result[f"{kind}_self_intersections"], 0).sum())


def _warn_unless_it_holds(name, faces):
    if faces > 0:
        warnings.warn(
            f"{name}: {faces} face{'s are' if faces > 1 else ' is'} flat, or meet others wrongly, "
            "as stored", RuntimeWarning, stacklevel=3,
        )


def _pieces(record, by, count):
    """A record of each piece; by: the column that says which piece a face belongs to."""
    number = record.of_faces[by].values
    order = np.argsort(number, kind="stable")
    ends = np.searchsorted(number, np.arange(count + 1), sorter=order)
    return [_part(record, order[begin:end]) for begin, end in zip(ends, ends[1:])]


def _part(record, faces):
    """A record of some of the faces, with the vertices that they have."""
    if record.has_polygons:
        chosen = [record.faces[f] for f in faces]
        corners = np.concatenate(chosen or [np.empty(0, dtype=int)])
        vertices, corners = np.unique(corners, return_inverse=True)
        chosen = np.split(corners, np.cumsum([len(face) for face in chosen])[:-1])
    else:
        vertices, corners = np.unique(record.faces[faces], return_inverse=True)
        chosen = corners.reshape(-1, 3)
    of_vertices, of_faces = (
        {name: Column(column.values[rows], column.missing) for name, column in columns.items()}
        for columns, rows in ((record.of_vertices, vertices), (record.of_faces, faces))
    )
    return MeshRecord(record.vertices[vertices], chosen, of_vertices, of_faces, record.normals)


def _with_distances(known, document, number):
    record, layer = known.records[number], document.layer(number)
    data = []
    for kind in ("vertex", "face"):
        scalar = getattr(layer, f"{kind}_custom_scalar_attribute_array")
        point = getattr(layer, f"{kind}_custom_point_attribute_matrix")
        columns = {}
        for name, read in (
            ("distance", scalar), ("distance_direction", point), ("closest_point", point),
            ("closest_face", lambda name: document.faces_of(1 - number, scalar(name))),
        ):
            try:
                columns[name] = Column(np.array(read(name)))
            except _missing_attribute():
                pass
        data.append({} if kind == "face" and record.has_polygons else columns)
    if known.is_pair(number):
        return tuple(columns["distance"].values for columns in data if columns)
    of_vertices, of_faces = data
    return known.mesh_of(
        MeshRecord(
            record.vertices, record.faces, {**record.of_vertices, **of_vertices},
            {**record.of_faces, **of_faces}, record.normals,
        ), number,
    )


def _missing_attribute():
    import pymeshlab

    return pymeshlab.PyMeshLabException
