# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Layers and texts that the filters beside the Boolean refuse, as refusal_cases.py has them.

Each refusal is met on two inputs in each filter that has it, and ALL joins both lists.
"""

import numpy as np
import pymeshlab

import mesh_laws
import oracles
import refusal_cases
from conftest import box, crossing_bars, document, joined
from plain_solids import one_sided
from refusal_cases import (
    BALL, BOOLEAN, CLOSE, CUBE, CURVES, DELETE, DISTANCE, EXPRESSION, FAR, IMPLICIT, PANE,
    REMOVE_DUPLICATES, RESOLVE, SECOND, SPLIT, TOP, Case, after, by_the_distance_named_in,
    cracked, double_sided, flat, run, too_wide, with_parameters, with_vertex, without_faces,
)

CLIP = {"second_inside_first": True, "sub_blocks": False}
QUAD = flat([(-1, -1, 1), (3, -1, 1), (3, 3, 1), (-1, 3, 1)])
HEXAGON = flat([(1, -2, 1), (4, -1, 1), (4, 3, 1), (1, 5, 1), (-2, 3, 1), (-2, -1, 1)])


def is_about(key, value, relative=1e-9):
    """Whether a number of the result map is this one."""
    return lambda result, mesh_set: abs(result[key] - value) <= relative * abs(value)


def difference_of(mesh):
    block = oracles.libigl_block("first_minus_second", *mesh, *SECOND)
    return mesh_laws.volume(*block)


def clipped_area(mesh):
    """The area of the pane in a solid, by this filter's own clip of the solid without a defect."""
    return run(document(mesh, PANE), SPLIT, **CLIP)["second_inside_first_area"]


def solids(refusal, remedy, sentence, layers, perform, relative=1e-9):
    """Cases of an expression, of resolving and of a clip; perform(filter, parameters) makes the
    performance. layers are (name, the mesh that is refused, the solid that is meant)."""
    for layer, mesh, meant in layers:
        for filter_name, parameters, key, value in (
            (EXPRESSION, {}, "result_0_volume", difference_of(meant)),
            (RESOLVE, {}, "resolved_volume", mesh_laws.volume(*meant)),
            (SPLIT, CLIP, "second_inside_first_area", None),
        ):
            other = PANE if filter_name == SPLIT else SECOND
            right = is_about(key, value, relative) if value else (
                lambda result, mesh_set, meant=meant: abs(
                    result["second_inside_first_area"] - clipped_area(meant)) <= relative * 10)
            yield Case(
                refusal, layer, remedy, sentence[filter_name] if isinstance(sentence, dict)
                else sentence, lambda mesh=mesh, other=other: document(mesh, other),
                perform(filter_name, parameters), right, filter=filter_name, parameters=parameters)


def open_cases():
    yield from solids(
        "is not closed, by cracks", "set `weld_distance` to the length that is named",
        r"They only just miss each other: with weld_distance = [\d.e+-]*\d the layer is closed",
        (("a ball whose faces are moved by up to 1e-9", cracked(BALL, 1e-9, 1), BALL),
         ("a cube whose faces are moved by up to 1e-9", cracked(CUBE, 1e-9, 2), CUBE)),
        lambda name, parameters: by_the_distance_named_in(name, **parameters), relative=1e-7)
    hole = r'"Close Holes" \(meshing_close_holes\) closes those of up to maxholesize edges'
    clips = r'What clips another layer must be closed.*"Close Holes" \(meshing_close_holes\)'
    yield from solids(
        "is not closed", "if it is a solid: Close Holes",
        {EXPRESSION: hole, RESOLVE: hole, SPLIT: clips},
        (("a cube without a face", without_faces(CUBE, 5), CUBE),
         ("a cube without another face", without_faces(CUBE, 0), CUBE)),
        lambda name, parameters: after(CLOSE, then=name, parameters=parameters))
    sheet = r"If it is a sheet, generate_index_boolean_split .* cuts with it"
    for layer, mesh, blocks in (("a pane", PANE, (4, 4)),
                                ("a pane that ends in the cube", half_pane(), (8,))):
        for filter_name in (EXPRESSION, RESOLVE):
            yield Case(
                "is not closed", layer, "if it is a sheet: split", sheet,
                lambda mesh=mesh: document(mesh, CUBE), with_parameters(SPLIT),
                refusal_cases.sub_blocks_are(*blocks), filter=filter_name)
        yield Case(
            "is not closed", layer, "if it is to clip another one: no clip, or the other way round",
            "The layer that is clipped may be open, and without a clip both may",
            lambda mesh=mesh: document(mesh, CUBE), with_parameters(SPLIT),
            refusal_cases.sub_blocks_are(*blocks), filter=SPLIT, parameters=CLIP)


def half_pane():
    vertices, faces = PANE
    return np.minimum(vertices, 1.0), faces


def not_solid_cases():
    yield from solids(
        "is double-sided", "Remove Duplicate Faces",
        r'It is double-sided: .*"Remove Duplicate Faces" \(meshing_remove_duplicate_faces\)',
        (("a cube, each face in both directions", double_sided(CUBE), CUBE),
         ("a ball, each face in both directions", double_sided(BALL), BALL)),
        lambda name, parameters: after(REMOVE_DUPLICATES, then=name, parameters=parameters))
    two = joined(one_sided(), (one_sided()[0] * 2 + 5, one_sided()[1]))
    for layer, mesh, volume in (
        ("a one-sided surface of four triangles and three squares", one_sided(), 2 / 3),
        ("two one-sided surfaces, one beside the other", two, 6),
    ):
        for filter_name, key in ((EXPRESSION, "result_0_volume"), (RESOLVE, "resolved_volume")):
            yield Case(
                "is not consistently oriented", layer, "set `winding_rule` to odd",
                "With winding_rule = odd it does not matter how they are turned",
                lambda mesh=mesh: document(mesh, FAR),
                with_parameters(filter_name, winding_rule="odd"), is_about(key, volume),
                filter=filter_name)
        yield Case(
            "is not consistently oriented", layer, "set `winding_rule` to odd",
            "With winding_rule = odd it does not matter how they are turned",
            lambda mesh=mesh: document(mesh, at_height(0.25)),
            with_parameters(SPLIT, winding_rule="odd", **CLIP),
            is_about("second_inside_first_area", 0.75 ** 2), filter=SPLIT,
            parameters=CLIP)
    for layer, mesh in (("a flat bag over a square", QUAD), ("one over a hexagon", HEXAGON)):
        for filter_name in (EXPRESSION, RESOLVE):
            yield Case(
                "encloses nothing", layer, "split takes it for a surface",
                r"What has no inside is no solid\. generate_index_boolean_split",
                lambda mesh=mesh: document(mesh, CUBE), with_parameters(SPLIT),
                refusal_cases.sub_blocks_are(4, 4), filter=filter_name)
        yield Case(
            "encloses nothing", layer, "if it is to clip another one: no clip",
            "What has no inside clips nothing: without a clip it is a surface",
            lambda mesh=mesh: document(mesh, CUBE), with_parameters(SPLIT),
            refusal_cases.sub_blocks_are(4, 4), filter=SPLIT, parameters=CLIP)
        for filter_name, key in ((DISTANCE, "max_second"), (IMPLICIT, "max")):
            yield Case(
                "encloses nothing", layer,
                "for distances: set `self_intersections` to trust",
                "With self_intersections = trust distances are measured to its faces as they are",
                lambda mesh=mesh: document(mesh, FAR),
                with_parameters(filter_name, self_intersections="trust"),
                lambda result, mesh_set, key=key: result[key] > 11, filter=filter_name)


def at_height(height):
    """A square about the axis, wider than what it cuts."""
    return refusal_cases.square(-3.5, 3.5, height)


def number_cases():
    big, bigger = ((mesh[0] * 1e60, mesh[1]) for mesh in (CUBE, BALL))
    for layer, mesh in (("a cube of 2e60", big), ("a ball of 1e60", bigger)):
        for filter_name, key in ((BOOLEAN, "union_volume"), (EXPRESSION, "result_0_volume"),
                                 (RESOLVE, "resolved_volume")):
            yield Case(
                "has numbers beyond single precision", layer, "set `certify_as` to host",
                "beyond 3.4e38.*With certify_as = host results are kept in double precision",
                lambda mesh=mesh: document(mesh, FAR), with_parameters(filter_name),
                is_about(key, mesh_laws.volume(*mesh), 1e-9), filter=filter_name,
                parameters={"certify_as": "float"})
    end = r'delete them with "Delete Selected Faces and Vertices" \([^)]*\)\.$'
    for layer, value in (("a ball with a vertex that is not a number", np.nan),
                         ("a ball with an infinite vertex", np.inf)):
        mesh = with_vertex(BALL, TOP, value)
        for filter_name, right in (
            (CURVES, lambda result, mesh_set: result["loops_hard_closed"] == 1),
            (DISTANCE, is_about("min_second", far_from_ball(), 0.01)),
            (IMPLICIT, is_about("min", far_from_ball(), 0.01)),
        ):
            other = PANE if filter_name == CURVES else FAR
            yield Case(
                "is not finite", layer, "delete the selected faces", end,
                lambda mesh=mesh, other=other: document(mesh, other),
                after(DELETE, then=filter_name), right, filter=filter_name)


def far_from_ball():
    """About: from the ball to the near corner of the far box."""
    return float(np.linalg.norm(np.array((10, 10, 10)) - (1.1, 1.2, 1.3)) - 0.9)


def same_layer_cases():
    """Layers without faces."""
    nothing = np.empty((0, 3), dtype=int)
    for layer, mesh in (("a cloud of points", (CUBE[0], nothing)),
                        ("a single point", (CUBE[0][:1], nothing))):
        for filter_name, parameters, right in (
            (EXPRESSION, {"expression": "2 - 1"}, is_about("result_0_volume", difference_of(CUBE))),
            (RESOLVE, {"mesh": 2}, is_about("resolved_volume", 8)),
            (IMPLICIT, {"reference_mesh": 2}, lambda result, mesh_set: result["inside"] == 1),
        ):
            yield Case(
                "has no face", layer, "choose a layer with faces", "Choose a layer with faces",
                lambda mesh=mesh: document(mesh, SECOND, CUBE),
                with_parameters(filter_name, **parameters), right, filter=filter_name)


def self_intersecting_cases():
    refuse = {"self_intersections": "refuse"}
    overlapping = joined(CUBE, box((1, 1, 1), (3, 3, 3)))
    layers = (("two bars that cross", crossing_bars(), 8.0625, 0.25, 20.5),
              ("two cubes that overlap", overlapping, 15, 1.5, 16))
    for layer, mesh, volume, height, length in layers:
        for filter_name, key in ((EXPRESSION, "result_0_volume"), (RESOLVE, "resolved_volume")):
            yield Case(
                "intersects itself", layer, "set `self_intersections` to resolve, the default",
                "= resolve the layer is taken for what its winding rule says",
                lambda mesh=mesh: document(mesh, FAR), with_parameters(filter_name),
                is_about(key, volume), filter=filter_name, parameters=refuse)
        # The centre of what both parts have in common is on no face then.
        for filter_name, key in ((DISTANCE, "min_second"), (IMPLICIT, "min")):
            yield Case(
                "intersects itself", layer, "set `self_intersections` to resolve, the default",
                "= resolve the layer is taken for what its winding rule says",
                lambda mesh=mesh: document(mesh, small_box()), with_parameters(filter_name),
                lambda result, mesh_set, key=key: result[key] < -0.2, filter=filter_name,
                parameters=refuse)
        yield Case(
            "intersects itself", layer, "set `self_intersections` to resolve, the default",
            "= resolve the layer is cut by itself, too",
            lambda mesh=mesh, height=height: document(mesh, at_height(height)),
            with_parameters(CURVES),
            lambda result, mesh_set, length=length: (
                abs(sum(result["loop_lengths"]) - length) < 1e-9),
            filter=CURVES, parameters=refuse)


def small_box():
    return box((0.1, 0.1, 0.2), (0.4, 0.4, 0.4))


def weld_cases():
    return too_wide((
        (EXPRESSION, is_about("result_0_volume", difference_of(BALL), 1e-7)),
        (RESOLVE, is_about("resolved_volume", mesh_laws.volume(*BALL), 1e-7)),
        (DISTANCE, lambda result, mesh_set: result["hausdorff"] > 0),
        (IMPLICIT, lambda result, mesh_set: result["inside"] == 1),
    ))


def list_cases():
    """Lists of layers and texts."""
    sheet, names = (4, 4), {"expression": '"A" - "B"'}
    for layer, again in (("two cubes of one name", CUBE), ("two balls of one name", BALL)):
        yield Case(
            "has the name of another one", layer, "name it by its id",
            "several layers have the label .A.: name one of them by its id, 0 or 2",
            lambda again=again: twins(again), with_parameters(EXPRESSION, expression="0 - 1"),
            is_about("result_0_volume", difference_of(again)), filter=EXPRESSION, parameters=names)
        yield Case(
            "has the name of another one", layer, "name it by its id",
            "several layers have the label .A.: name one of them by its id, 0 or 2",
            lambda again=again: twins(again), with_parameters(SPLIT, layers="0, 1"),
            lambda result, mesh_set: result["sub_blocks"] == 3, filter=SPLIT,
            parameters={"layers": '"A", "B"'})
    for layer, mesh in (("results alone, of a cube", CUBE), ("results alone, of a ball", BALL)):
        for filter_name, parameters, named, right in (
            (EXPRESSION, {"expression": "union(visible)"}, {"expression": "union(2, 3)"},
             lambda result, mesh_set: result["result_0_closed"]),
            (SPLIT, {"layers": "visible"}, {"layers": "2, 3"},
             lambda result, mesh_set: result["sub_blocks"] >= 2),
        ):
            yield Case(
                "a list stands for no layer", layer, "name layers by their ids",
                ".visible. stands for no layer",
                lambda mesh=mesh: results_alone(mesh), with_parameters(filter_name, **named),
                right, filter=filter_name, parameters=parameters)
    for text, mended, sentence in (
        ("-0", "1 & ~0", 'there is no "-" before an operand; "~" is what is outside it'),
        ("~0", "1 & ~0", "this is true of the outside, which has no boundary"),
        ("1 - (0", "1 - (0)", r'the text ends where an operator or a "\)" is expected'),
    ):
        volume = mesh_laws.volume(*oracles.libigl_block("second_minus_first", *CUBE, *SECOND))
        yield Case(
            "a text does not read", f"`{text}`", "mend it at the caret", sentence,
            lambda: document(CUBE, SECOND), with_parameters(EXPRESSION, expression=mended),
            is_about("result_0_volume", volume), filter=EXPRESSION,
            parameters={"expression": text})
    for text, mended, sentence in (
        ("0, 0", "0, 1", "this layer is named twice"),
        ("0, 7", "0, 1", "there is no layer with id 7"),
        ("0 1", "0, 1", "a comma is missing here, or this is too much"),
    ):
        yield Case(
            "a text does not read", f"`{text}`", "mend it at the caret", sentence,
            lambda: document(CUBE, PANE), with_parameters(SPLIT, layers=mended),
            refusal_cases.sub_blocks_are(*sheet), filter=SPLIT, parameters={"layers": text})


def twins(mesh):
    mesh_set = document(mesh, SECOND)
    mesh_set.add_mesh(pymeshlab.Mesh(*mesh))
    mesh_set.current_mesh().set_label("A")  # a label that is given with the mesh is made its own
    return mesh_set


def results_alone(mesh):
    """The Boolean's results 2 and 3 without what they were made of."""
    mesh_set = document(mesh, SECOND)
    run(mesh_set, union=True, intersection=True, first_minus_second=False,
        second_minus_first=False)
    for operand in (0, 1):
        mesh_set.set_current_mesh(operand)
        mesh_set.delete_current_mesh()
    return mesh_set


def request_cases():
    copy = "a layer is copied with .*generate_copy_of_current_mesh"
    for layer, mesh in (("a cube", CUBE), ("a ball", BALL)):
        for filter_name, right in (
            (SPLIT, lambda result, mesh_set: result["sub_blocks"] == 1),
            (CURVES, lambda result, mesh_set: result["loops_open"] == 0),
            (DISTANCE, lambda result, mesh_set: result["hausdorff"] < 1e-12),
        ):
            yield Case(
                "is given twice", layer, "Duplicate Current layer", copy,
                lambda mesh=mesh: document(mesh, SECOND),
                after(("generate_copy_of_current_mesh", {}), then=filter_name,
                      parameters={"second_mesh": 2}), right, filter=filter_name,
                parameters={"second_mesh": 0})
        for filter_name, wrong, right in (
            (SPLIT, {"second_mesh": 7}, lambda result, mesh_set: result["sub_blocks"] == 3),
            (CURVES, {"second_mesh": 7}, lambda result, mesh_set: result["loops_hard_closed"] == 1),
            (RESOLVE, {"mesh": 7}, is_about("resolved_volume", mesh_laws.volume(*mesh))),
            (DISTANCE, {"second_mesh": 7}, lambda result, mesh_set: result["hausdorff"] > 0),
            (IMPLICIT, {"points_mesh": 7}, lambda result, mesh_set: result["inside"] == 1),
        ):
            yield Case(
                "is no layer", layer, "choose a layer of the document",
                "Choose a layer of the document", lambda mesh=mesh: document(mesh, SECOND),
                with_parameters(filter_name), right, filter=filter_name, parameters=wrong)


def value_cases():
    for layer, mesh in (("a cube", CUBE), ("a ball", BALL)):
        for filter_name, off, right in (
            (SPLIT, ("sub_surfaces_first", "sub_surfaces_second", "sub_blocks"),
             lambda result, mesh_set: result["sub_blocks"] == 3),
            (DISTANCE, ("at_vertices", "at_faces"),
             lambda result, mesh_set: result["hausdorff"] > 0),
        ):
            yield Case(
                "nothing is asked for", layer, "set one of what is named to true",
                "is asked for. Set at least one of these to true",
                lambda mesh=mesh: document(mesh, SECOND), with_parameters(filter_name), right,
                filter=filter_name, parameters={name: False for name in off})
        yield Case(
            "a number is out of range", layer, "choose one in the range that is named",
            "max_layers is 0. Choose a number from 1 to 1000",
            lambda mesh=mesh: document(mesh, SECOND), with_parameters(SPLIT, max_layers=1000),
            lambda result, mesh_set: result["sub_blocks"] == 3, filter=SPLIT,
            parameters={"max_layers": 0})
        for name in ("max_distance", "weld_distance"):
            yield Case(
                "a length is negative", layer, "choose one of 0 or more",
                f"{name} is -1. Choose a length of 0 or more",
                lambda mesh=mesh: document(mesh, SECOND), with_parameters(DISTANCE),
                lambda result, mesh_set: result["hausdorff"] > 0, filter=DISTANCE,
                parameters={name: pymeshlab.PureValue(-1)})


def clip_list_cases():
    for layer, mesh in (("a cube", CUBE), ("a ball", BALL)):
        for remedy, parameters in (
            ("name both layers in `layers`", {"layers": "0, 1, 2"}),
            ("choose `first_mesh` and `second_mesh` among those named", {"second_mesh": 2}),
            ("leave `layers` empty", {"layers": ""}),
        ):
            given = {"layers": "0, 2", "first_inside_second": True}
            yield Case(
                "a clip is of a layer that is not in the list", layer, remedy,
                "Add it there, or choose first_mesh and second_mesh among them, or leave layers",
                lambda mesh=mesh: document(mesh, SECOND, box((-1, -1, -1), (3, 3, 3))),
                with_parameters(SPLIT, **{**given, **parameters}),
                lambda result, mesh_set: result["first_inside_second_area"] > 0, filter=SPLIT,
                parameters=given)


def cases():
    yield from open_cases()
    yield from not_solid_cases()
    yield from number_cases()
    yield from same_layer_cases()
    yield from self_intersecting_cases()
    yield from weld_cases()
    yield from list_cases()
    yield from request_cases()
    yield from value_cases()
    yield from clip_list_cases()


ALL = [*refusal_cases.cases(), *cases()]
WORDS = {
    BOOLEAN: "Boolean", EXPRESSION: "expression", RESOLVE: "resolve", SPLIT: "split",
    CURVES: "curves", DISTANCE: "distance", IMPLICIT: "implicit",
}


def table():
    """The table of docs/refusals.md: each refusal, what helps, and what it was tried on."""
    order = list(dict.fromkeys(case.refusal for case in ALL))
    tried = {}
    for case in sorted(ALL, key=lambda case: order.index(case.refusal)):
        layers = tried.setdefault((case.refusal, case.remedy), {})
        layers.setdefault(case.layer, []).append(case.filter)
    lines = ["| the layer … | what helps | tried on | by |", "|---|---|---|---|"]
    for (refusal, remedy), layers in tried.items():
        used = [WORDS[name] for name in WORDS if any(name in some for some in layers.values())]
        lines.append(f"| {refusal} | {remedy} | {'; '.join(layers)} | {', '.join(used)} |")
    return "\n".join(lines) + "\n"
