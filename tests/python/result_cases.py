# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The operands on which two builds of the plugin are compared, and what is run on them.

out: case_names(), runs_of(name), loaded(name). A name has no blank: its first part, up to the
slash, is the kind of case. Guarantee: no plugin is loaded here; names and operands are the same
in each process.
"""

import tempfile
from pathlib import Path

import pymeshlab

import carried
import contact_cases
import placements
import textured_pair
from conftest import box, crossing_bars, document, sphere
from open_shapes import bumpy_sheet, square
from paper_figures import FIGURES
from sample_catalogue import PAIRS, sample
from test_polygons import quad_box, quad_sphere

BOOLEAN, SPLIT, CURVES = (
    "generate_index_boolean", "generate_index_boolean_split", "generate_index_boolean_curves",
)
ALL_BLOCKS = dict.fromkeys(
    (
        "union", "intersection", "first_minus_second", "second_minus_first",
        "symmetric_difference",
    ),
    True,
)
# (filter, variant, parameters)
BLOCK_RUNS = (
    (BOOLEAN, "default", ALL_BLOCKS),
    (BOOLEAN, "merge_coplanar", {**ALL_BLOCKS, "merge_coplanar": True}),
    (BOOLEAN, "welded_with_cuts",
     {**ALL_BLOCKS, "weld_non_manifold": True, "merge_fragments": False}),
)
PIECE_RUNS = ((SPLIT, "default", {}), (CURVES, "default", {}))
STANDARD_RUNS = BLOCK_RUNS + PIECE_RUNS
# Of open operands: pieces, and the Boolean's refusal.
OPEN_RUNS = BLOCK_RUNS[:1] + PIECE_RUNS
ATTRIBUTE_RUNS = (
    *STANDARD_RUNS,
    (BOOLEAN, "duplicated",
     {**ALL_BLOCKS, "duplicate_curve_vertices": True, "select_curve_vertices": True}),
    (BOOLEAN, "without_attributes", {**ALL_BLOCKS, "transfer_attributes": False}),
)
SAMPLE_RUNS = (
    *STANDARD_RUNS,
    (BOOLEAN, "checked_with_curves",
     {**ALL_BLOCKS, "self_intersections": "refuse", "curves": True}),
    (SPLIT, "separate", {"separate_layers": True}),
)
SHIFT = ((1, 0, 0, 0.0625), (0, 1, 0, 0.03125), (0, 0, 1, -0.015625), (0, 0, 0, 1))
SHEET = bumpy_sheet((0.2, 0.1, 1), 0.1, 2, 31)


def without_some_faces(mesh):
    """The mesh with a hole."""
    return mesh[0], mesh[1][len(mesh[1]) // 20 :]


def named_sample_pair(name):
    """Both meshes of a pair of samples."""
    return tuple(sample(mesh) for mesh in PAIRS[name][:2])


def opened_sample_pair(name):
    """A pair of samples, both with a hole."""
    return tuple(without_some_faces(mesh) for mesh in named_sample_pair(name))


def sheet_across_sample(name):
    """A sample mesh and an open sheet as large as all of them."""
    return sample(name), SHEET


def contact_pair(name, swapped):
    """Both operands of a contact case."""
    case = contact_cases.load_case(name)
    return (case.second, case.first) if swapped else (case.first, case.second)


def placed_pair(name):
    """Both operands of a standard placement."""
    operands = placements.load_pair(name, placements.meshes_folder())
    return operands[:2], operands[2:]


def carrier_document(name, second_has=True, moved=False):
    """A pair of samples whose layers have attributes of all kinds."""
    first, second = named_sample_pair(name)
    mesh_set = pymeshlab.MeshSet()
    carried.add_carrier(mesh_set, first, 1, "A")
    carried.add_carrier(mesh_set, second, 2, "B", second_has)
    if moved:
        mesh_set.set_matrix(transformmatrix=SHIFT, freeze=False)
    return mesh_set


def quad_document():
    """Two layers of quads."""
    mesh_set = pymeshlab.MeshSet()
    pair = quad_sphere(), quad_box((0.125, 0.1875, 0.3125), (2, 2, 2))
    for label, (vertices, faces) in zip("AB", pair):
        mesh_set.add_mesh(pymeshlab.Mesh(vertex_matrix=vertices, face_list_of_indices=faces), label)
    return mesh_set


def textured_document():
    """Two layers with textures; their pictures are gone afterwards."""
    with tempfile.TemporaryDirectory() as folder:
        return textured_pair.textured_layers(Path(folder))


# Operands as they are refused, or nearly.
REFUSED_PAIRS = {
    "crossing_bars": lambda: (crossing_bars(), box((0, 0, 0), (3, 3, 3))),
    "sheet": lambda: (sphere(), square(-2, 2, 0.25, 8)),
    "hole": lambda: (without_some_faces(sphere()), box((0, 0, 0), (3, 3, 3))),
    "nested_components": lambda: (
        contact_cases.joined(sphere(), sphere(radius=0.5)), box((0, 0, 0), (3, 3, 3))
    ),
    "no_faces": lambda: (sphere(), (sphere()[0], sphere()[1][:0])),
    "apart": lambda: (sphere(), sphere((9, 9, 9))),
}
DOCUMENTS = {
    "attributes/general": lambda: carrier_document("general"),
    "attributes/cavity,_of_one": lambda: carrier_document("cavity", second_has=False),
    "attributes/equal_cylinders": lambda: carrier_document("equal_cylinders"),
    "attributes/components,_moved": lambda: carrier_document("components", moved=True),
    "attributes/quads": quad_document,
    "attributes/textures": textured_document,
}


def _pairs():
    """{name: (runs, function that gives the pair)} of all cases whose layers are plain meshes."""
    found = {}
    for name in PAIRS:
        found[f"samples/{name}"] = SAMPLE_RUNS, lambda n=name: named_sample_pair(n)
    for name in contact_cases.CASE_NAMES:
        if name != contact_cases.FANDISK or placements.meshes_folder():
            for order in ("as_given", "swapped"):
                found[f"contacts/{name}/{order}"] = (
                    STANDARD_RUNS, lambda n=name, o=order: contact_pair(n, o == "swapped")
                )
    for name in PAIRS:
        found[f"open/{name}"] = OPEN_RUNS, lambda n=name: opened_sample_pair(n)
    for name in ("bumpy_sphere", "ribbed_torus", "hollow_ball", "statue"):
        found[f"open/sheet_across_{name}"] = OPEN_RUNS, lambda n=name: sheet_across_sample(n)
    for name, pair in REFUSED_PAIRS.items():
        found[f"refused/{name}"] = STANDARD_RUNS, pair
    for name, (_, _, pair, _) in FIGURES.items():
        if placements.meshes_folder() or name not in ("falcon", "lion"):
            found[f"figures/{name}"] = OPEN_RUNS, pair
    if placements.meshes_folder():
        for name in placements.PAIR_NAMES:
            found[f"meshes/{name}"] = STANDARD_RUNS, lambda n=name: placed_pair(n)
    return {name.replace(" ", "_"): entry for name, entry in found.items()}


_PAIRS = _pairs()


def case_names():
    """All cases, those with other people's meshes only where their folder is."""
    return (*_PAIRS, *DOCUMENTS)


def runs_of(name):
    """What is run on a case: (filter, variant, parameters) each."""
    return ATTRIBUTE_RUNS if name in DOCUMENTS else _PAIRS[name][0]


def loaded(name):
    """Reads a case's operands; a function that makes a document with both, as often as called."""
    if name in DOCUMENTS:
        return DOCUMENTS[name]
    pair = _PAIRS[name][1]()
    return lambda: document(*pair)
