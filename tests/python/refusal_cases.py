# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Layers that the Boolean refuses, with what the refusal says to do and the performance of it.

tests/python/refusals_of_filters.py has those of the other filters. tests/python/test_refusals.py
performs each and writes the table of docs/refusals.md from both lists.
"""

import dataclasses
import re
from typing import Callable

import numpy as np
import pymeshlab

import mesh_laws
import oracles
from conftest import box, crossing_bars, document, joined, sphere
from open_shapes import square
from plain_solids import one_sided
from test_reports import load, load_stl

BOOLEAN = "generate_index_boolean"
SPLIT = "generate_index_boolean_split"
CURVES = "generate_index_boolean_curves"
EXPRESSION = "generate_index_boolean_expression"
RESOLVE = "generate_index_boolean_resolve"
DISTANCE = "compute_index_boolean_distance"
IMPLICIT = "compute_index_boolean_implicit"
# What each filter is given where a case does not say it: layer 0 is the one to be refused.
LAYERS = {
    EXPRESSION: {"expression": "0 - 1"},
    RESOLVE: {"mesh": 0},
    IMPLICIT: {"points_mesh": 1, "reference_mesh": 0},
}
SECOND = box((1, 1.125, 1.25), (2.5, 2.625, 2.75))
CUBE = box((0, 0, 0), (2, 2, 2))
BALL = sphere((1.1, 1.2, 1.3), 0.9)
TOP = int(BALL[0][:, 2].argmax())


@dataclasses.dataclass(frozen=True)
class Case:
    """A document whose layer 0 is refused.

    sentence is a regular expression of what the refusal says; remedy is how the table puts it.
    perform(mesh_set, message) does what it says and runs the filter again; returns its result map.
    is_right(result, mesh_set) compares that with what does not depend on this filter.
    """

    refusal: str
    layer: str
    remedy: str
    sentence: str
    make: Callable
    perform: Callable
    is_right: Callable
    filter: str = BOOLEAN
    parameters: dict = dataclasses.field(default_factory=dict)

    @property
    def name(self):
        return re.sub(r"\W+", "_", f"{self.refusal}, {self.layer}, {self.filter}")


def run(mesh_set, filter_name=BOOLEAN, **parameters):
    layers = LAYERS.get(filter_name, {"first_mesh": 0, "second_mesh": 1})
    return getattr(mesh_set, filter_name)(**{**layers, **parameters})


def with_parameters(filter_name=BOOLEAN, **parameters):
    """A performance: the same layers, with other parameters."""
    return lambda mesh_set, message: run(mesh_set, filter_name, **parameters)


def after(*filters, then=BOOLEAN, parameters=None):
    """A performance: MeshLab's filters on layer 0, each (name, parameters), then the filter."""

    def perform(mesh_set, message):
        mesh_set.set_current_mesh(0)
        for name, values in filters:
            mesh_set.apply_filter(name, **values)
        return run(mesh_set, then, **(parameters or {}))

    return perform


def by_the_distance_named_in(filter_name, **parameters):
    """A performance: the same, with the weld_distance that the refusal names."""

    def perform(mesh_set, message):
        distance = float(re.search(r"weld_distance = ([\d.e+-]*\d)", message)[1])
        weld_distance = pymeshlab.PureValue(distance)
        return run(mesh_set, filter_name, weld_distance=weld_distance, **parameters)

    return perform


def blocks_of(first, second, tolerance=1e-9):
    """Whether union, intersection and differences have the volumes that libigl gives."""
    expected = {b: mesh_laws.volume(*mesh) for b, mesh in
                oracles.libigl_blocks(*first, *second).items()}
    size = sum(mesh_laws.volume(*mesh) for mesh in (first, second))

    def is_right(result, mesh_set):
        return all(
            abs(result[f"{block}_volume"] - volume) <= tolerance * size
            and result[f"{block}_closed"]
            for block, volume in expected.items()
        )

    return is_right


def union_is(volume, relative=1e-12):
    return lambda result, mesh_set: abs(result["union_volume"] / volume - 1) <= relative


def sub_blocks_are(*volumes):
    """Whether the split has sub-blocks of these volumes, in any order."""

    def is_right(result, mesh_set):
        found = np.sort(result["sub_blocks_volumes"])
        return len(found) == len(volumes) and np.allclose(found, sorted(volumes), rtol=1e-12)

    return is_right


def double_sided(mesh):
    return mesh[0], np.concatenate([mesh[1], mesh[1][:, ::-1]])


def without_faces(mesh, *faces):
    return mesh[0], np.delete(mesh[1], faces, axis=0)


def with_vertex(mesh, vertex, value):
    vertices = mesh[0].copy()
    vertices[vertex, 1] = value
    return vertices, mesh[1]


def flat(corners):
    """A polygon twice, its two sides triangulated differently: closed, and of no volume."""
    corners = np.array(corners, dtype=np.float64)
    n = len(corners)
    top = [(0, i, i + 1) for i in range(1, n - 1)]
    below = [(1, (i + 1) % n, i % n) for i in range(2, n)]
    return corners, np.array(top + below)


def cracked(mesh, most, seed):
    """Each face by itself, its corners moved by up to that much along each axis."""
    soup = mesh[0][mesh[1]].reshape(-1, 3)
    moved = soup + np.random.default_rng(seed).uniform(-most, most, soup.shape)
    return moved, np.arange(len(soup)).reshape(-1, 3)


def matrix(mesh_set, values):
    mesh_set.set_current_mesh(0)
    mesh_set.set_matrix(transformmatrix=values, freeze=False)
    return mesh_set


def covered(mesh, vertex):
    """Whether the union has the volume of the layer with a flat cover for what was at the vertex,
    up to what lies between the possible covers; the other layer is far away."""
    around = mesh[0][np.unique(mesh[1][(mesh[1] == vertex).any(axis=1)])]
    size = np.linalg.norm(around.max(axis=0) - around.min(axis=0))
    whole = mesh_laws.volume(*mesh)

    def is_right(result, mesh_set):
        lost = whole + FAR_VOLUME - result["union_volume"]
        return 0 < lost < size ** 3 and result["union_closed"]

    return is_right


FAR, FAR_VOLUME = box((10, 10, 10), (11, 11, 11)), 1
DELETE = ("meshing_remove_selected_vertices_and_faces", {})
CLOSE = ("meshing_close_holes", {})
REMOVE_DUPLICATES = ("meshing_remove_duplicate_faces", {})
PANE = square(-1.0, 3.0, 1.0)  # across the cube's middle
HALVES = sub_blocks_are(4, 4)
IDLER = load_stl("idler_riser.STL")
KIGUMI = load("kigumi33_vertices_not_quite_equal")[0]
BESIDE_IDLER = box(IDLER[0].mean(axis=0), IDLER[0].max(axis=0) + 1)
BESIDE_KIGUMI = box(KIGUMI[0].mean(axis=0), KIGUMI[0].max(axis=0) + 1)


def welded_by_hand(mesh, distance):
    """Places that are nearer than that become one, compared with all others; the first stands for
    them. Slow, and shares nothing with the filter."""
    vertices, faces = mesh
    places, number = np.unique(vertices, axis=0, return_inverse=True)
    stands = np.arange(len(places))
    for i, place in enumerate(places):
        near = np.flatnonzero(((places - place) ** 2).sum(axis=1) < distance ** 2)
        stands[np.isin(stands, stands[near])] = stands[near].min()
    faces = stands[number.ravel()][faces]
    whole = (faces[:, 0] != faces[:, 1]) & (faces[:, 1] != faces[:, 2])
    whole &= faces[:, 2] != faces[:, 0]
    return places, faces[whole]


def crack_cases():
    welds = (
        ("a CAD part, cracked by an ulp", IDLER, BESIDE_IDLER, 1e-4),
        ("a joint whose corners are 1e-7 apart", KIGUMI, BESIDE_KIGUMI, 1e-5),
        ("a ball whose faces are moved by up to 1e-9", cracked(BALL, 1e-9, 1), SECOND, 1e-8),
        ("a cube whose faces are moved by up to 1e-4", cracked(CUBE, 1e-4, 2), SECOND, 1e-3),
    )
    for layer, mesh, other, distance in welds:
        yield Case(
            "is not closed, by cracks", layer, "set `weld_distance` to the length that is named",
            r"They only just miss each other: with weld_distance = [\d.e+-]*\d the layer is closed",
            lambda mesh=mesh, other=other: document(mesh, other),
            by_the_distance_named_in(BOOLEAN),
            blocks_of(welded_by_hand(mesh, distance), other, 1e-6),
        )


def cases():
    """All of them."""
    yield from crack_cases()
    hole = r'"Close Holes" \(meshing_close_holes\) closes those of up to maxholesize edges'
    yield Case(
        "is not closed", "a cube without a face", "if it is a solid: Close Holes", hole,
        lambda: document(without_faces(CUBE, 5), SECOND), after(CLOSE), blocks_of(CUBE, SECOND))
    yield Case(
        "is not closed", "a box without a side of 40 faces",
        "if it is a solid: Close Holes, with `maxholesize`", hole,
        lambda: document(lidless(), SECOND),
        after(("meshing_close_holes", {"maxholesize": 100})), union_is(8 + 3.375 - 0.65625, 1e-9))
    sheet = r"If it is a sheet, generate_index_boolean_split .* cuts with it"
    for layer, mesh, blocks in (
        ("a pane", PANE, HALVES),
        ("a pane that ends in the cube", square(-1.0, 1.0, 1.0), sub_blocks_are(8)),
    ):
        yield Case(
            "is not closed", layer, "if it is a sheet: split", sheet,
            lambda mesh=mesh: document(mesh, CUBE), with_parameters(SPLIT), blocks)
    twice = r'It is double-sided: .*"Remove Duplicate Faces" \(meshing_remove_duplicate_faces\)'
    for layer, mesh in (("a cube, each face in both directions", CUBE),
                        ("a ball, each face in both directions", BALL)):
        yield Case(
            "is double-sided", layer, "Remove Duplicate Faces", twice,
            lambda mesh=mesh: document(double_sided(mesh), SECOND), after(REMOVE_DUPLICATES),
            blocks_of(mesh, SECOND))
    yield Case(
        "is double-sided", "a pane, each face in both directions",
        "Remove Duplicate Faces, then split", twice + ".*generate_index_boolean_split",
        lambda: document(double_sided(PANE), CUBE), after(REMOVE_DUPLICATES, then=SPLIT), HALVES)
    odd = r"With winding_rule = odd it does not matter how they are turned"
    yield Case(
        "is not consistently oriented", "a one-sided surface of four triangles and three squares",
        "set `winding_rule` to odd", odd, lambda: document(one_sided(), FAR),
        with_parameters(winding_rule="odd"), union_is(2 / 3 + 1))
    yield Case(
        "is not consistently oriented", "two one-sided surfaces, one beside the other",
        "set `winding_rule` to odd", odd,
        lambda: document(joined(one_sided(), (one_sided()[0] * 2 + 5, one_sided()[1])), FAR),
        with_parameters(winding_rule="odd"), union_is(2 / 3 + 16 / 3 + 1))
    nothing = r"What has no inside is no solid\. generate_index_boolean_split"
    quad = [(-1, -1, 1), (3, -1, 1), (3, 3, 1), (-1, 3, 1)]
    hexagon = [(1, -2, 1), (4, -1, 1), (4, 3, 1), (1, 5, 1), (-2, 3, 1), (-2, -1, 1)]
    for layer, corners in (("a flat bag over a square", quad), ("one over a hexagon", hexagon)):
        yield Case(
            "encloses nothing", layer, "split takes it for a surface", nothing,
            lambda corners=corners: document(flat(corners), CUBE), with_parameters(SPLIT), HALVES)
    yield from not_finite_cases()
    yield from empty_cases()
    yield from self_intersecting_cases()
    yield from too_wide_cases()
    yield from parameter_cases()


def lidless():
    """The cube without its lid: a hole of 40 edges."""
    steps = np.arange(10) / 5
    rim = [(x, 0) for x in steps] + [(2, y) for y in steps]
    rim += [(2 - x, 2) for x in steps] + [(0, 2 - y) for y in steps]
    vertices = np.array([(x, y, z) for z in (0, 2) for x, y in rim], dtype=np.float64)
    faces = [(0, i + 1, i) for i in range(1, 39)]  # the floor
    for i in range(40):
        j = (i + 1) % 40
        faces += [(i, j, 40 + j), (i, 40 + j, 40 + i)]
    return vertices, np.array(faces)


def not_finite_cases():
    blown_up = np.diag((1e308, 1e308, 1e308, 1.0))
    blame = "If the layer's matrix is to blame, correct it"
    identity = ("set_matrix", {"transformmatrix": np.eye(4), "freeze": False})
    for layer, mesh in (("a cube under a matrix of 1e308", CUBE), ("a ball under one", BALL)):
        for filter_name in (BOOLEAN, SPLIT):
            right = blocks_of(mesh, SECOND) if filter_name == BOOLEAN else (
                lambda result, mesh_set: len(result["sub_blocks_volumes"]) == 3)
            yield Case(
                "is not finite", layer, "correct the layer's matrix", blame,
                lambda mesh=mesh: matrix(document(mesh, SECOND), blown_up),
                after(identity, then=filter_name), right, filter=filter_name)
    covers = r'"Close Holes" \(meshing_close_holes\) then covers the hole'
    for layer, mesh, value in (("a ball with a vertex that is not a number", BALL, np.nan),
                               ("a ball with an infinite vertex", BALL, np.inf)):
        yield Case(
            "is not finite", layer,
            "delete the selected faces, and cover the hole that is left by Close Holes", covers,
            lambda mesh=mesh, value=value: document(with_vertex(mesh, TOP, value), FAR),
            after(DELETE, CLOSE), covered(mesh, TOP))
        yield Case(
            "is not finite", layer, "delete the selected faces",
            r'delete them with "Delete Selected Faces and Vertices" \([^)]*\)\.$',
            lambda mesh=mesh, value=value: document(with_vertex(mesh, TOP, value), PANE),
            after(DELETE, then=SPLIT), lambda result, mesh_set: result["sub_surfaces_second"] == 2,
            filter=SPLIT)


def empty_cases():
    points = (CUBE[0], np.empty((0, 3), dtype=int))
    one = (CUBE[0][:1], points[1])
    for layer, mesh in (("a cloud of points", points), ("a single point", one)):
        for filter_name, right in (
            (BOOLEAN, blocks_of(CUBE, SECOND)),
            (SPLIT, lambda result, mesh_set: len(result["sub_blocks_volumes"]) == 3),
            (CURVES, lambda result, mesh_set: result["loops_hard_closed"] == 1),
        ):
            yield Case(
                "has no face", layer, "choose a layer with faces", "Choose a layer with faces",
                lambda mesh=mesh: document(mesh, SECOND, CUBE),
                with_parameters(filter_name, first_mesh=2), right, filter=filter_name)
    for layer, distance in (("a cube, welded over ten times its size", 20.0),
                            ("a cube, welded over its size", 4.0)):
        yield Case(
            "has no face", layer, "choose a `weld_distance` below the length of its edges",
            "a weld_distance below the length of its edges", lambda: document(CUBE, SECOND),
            with_parameters(weld_distance=pymeshlab.PureValue(0.25)), blocks_of(CUBE, SECOND),
            parameters={"weld_distance": pymeshlab.PureValue(distance)})


def self_intersecting_cases():
    resolve = "With self_intersections = resolve"
    layers = (
        ("two bars that cross", crossing_bars(), union_is(8.0625 + 1)),
        ("two cubes that overlap", joined(CUBE, box((1, 1, 1), (3, 3, 3))), union_is(15 + 1)),
    )
    for layer, mesh, right in layers:
        yield Case(
            "intersects itself", layer, "set `self_intersections` to resolve, the default",
            resolve + " the layer is taken for what its winding rule says",
            lambda mesh=mesh: document(mesh, FAR), with_parameters(), right,
            parameters={"self_intersections": "refuse"})
    cells = (sub_blocks_are(1, 7, 7, 1), sub_blocks_are(1, 7, 7, 1))
    shifted = joined(box((1, 1, 1), (3, 3, 3)), CUBE)
    for (layer, mesh), right in zip(
        (("two cubes that overlap", layers[1][1]), ("the same in the other order", shifted)), cells
    ):
        yield Case(
            "intersects itself", layer, "set `self_intersections` to resolve, the default",
            resolve + " the layer is cut by itself", lambda mesh=mesh: document(mesh, FAR),
            with_parameters(SPLIT), right, filter=SPLIT,
            parameters={"self_intersections": "refuse"})


def too_wide(filters):
    """Balls welded over more than their edges, in these filters: (name, what is right then)."""
    smaller = "Choose a smaller weld_distance: one that is larger than the cracks"
    for layer, mesh, near in (
        ("a ball with edges of 0.2 by a distance of 0.3", BALL, 1e-3),
        ("a cracked ball by the same", cracked(BALL, 1e-9, 3), 1e-8),
    ):
        for filter_name, right in filters:
            yield Case(
                "has vertices that are linked over too far a way", layer,
                "choose a smaller `weld_distance`", smaller,
                lambda mesh=mesh: document(mesh, SECOND),
                with_parameters(filter_name, weld_distance=pymeshlab.PureValue(near)), right,
                filter=filter_name, parameters={"weld_distance": pymeshlab.PureValue(0.3)})


def too_wide_cases():
    return too_wide((
        (BOOLEAN, blocks_of(BALL, SECOND, 1e-7)),
        (SPLIT, lambda result, mesh_set: len(result["sub_blocks_volumes"]) == 3),
        (CURVES, lambda result, mesh_set: result["loops_hard_closed"] == 1),
    ))


def parameter_cases():
    copy = "a layer is copied with .*generate_copy_of_current_mesh"
    for layer, mesh in (("a cube", CUBE), ("a ball", BALL)):
        yield Case(
            "is given twice", layer, "Duplicate Current layer", copy,
            lambda mesh=mesh: document(mesh, SECOND),
            after(("generate_copy_of_current_mesh", {}), parameters={"second_mesh": 2}),
            blocks_of(mesh, mesh), parameters={"second_mesh": 0})
        yield Case(
            "is no layer", layer, "choose a layer of the document",
            "Choose a layer of the document",
            lambda mesh=mesh: document(mesh, SECOND), with_parameters(), blocks_of(mesh, SECOND),
            parameters={"second_mesh": 7})
        yield Case(
            "nothing is asked for", layer, "set a block to true",
            "Set at least one of these to true",
            lambda mesh=mesh: document(mesh, SECOND), with_parameters(), blocks_of(mesh, SECOND),
            parameters={block: False for block in (
                "union", "intersection", "first_minus_second", "second_minus_first")})
        yield Case(
            "a number is out of range", layer, "choose one in the range that is named",
            "octree_max_depth is 0. Choose a number from 1 to 20",
            lambda mesh=mesh: document(mesh, SECOND), with_parameters(octree_max_depth=1),
            blocks_of(mesh, SECOND), parameters={"octree_max_depth": 0})
        yield Case(
            "a length is negative", layer, "choose one of 0 or more",
            "weld_distance is -1. Choose a length of 0 or more",
            lambda mesh=mesh: document(mesh, SECOND), with_parameters(), blocks_of(mesh, SECOND),
            parameters={"weld_distance": pymeshlab.PureValue(-1)})
