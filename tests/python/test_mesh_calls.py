# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The functions on meshes of other libraries: the same type back, bits and data kept, errors that
carry the sentence and the faces.
"""

import os
import re
import subprocess
import sys
import warnings

import numpy as np
import pymeshlab
import pytest
import trimesh

import indexboolean
import refusal_cases
from conftest import box, crossing_bars, joined, sphere
from indexboolean.host_words import in_words_of_python
from library_meshes import ALL, CARRYING, Arrays, Meshio, PyVista, Trimesh, volume
from plain_solids import halved
from refusals_of_filters import ALL as CASES

SPHERE = sphere((0.25, 0.125, 0.5), 0.9)
BOX = box((-0.5, -0.25, -1), (0.5, 0.75, 2))
QUADS = np.array([
    (0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5),
])


def cube_of_quads(low, high):
    """A box whose faces are quads."""
    corners = np.array([(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)], float)
    return low + corners * (np.subtract(high, low)), QUADS


def affine(points):
    """What is exactly its own mean over any face, but for rounding."""
    return points @ np.array((1.0, 2.0, -3.0)) + 0.5


def vertex_data(points, rng):
    """Data of each type and shape; "affine" and "matrix" are known at every point."""
    n = len(points)
    return {
        "affine": affine(points),
        "single": affine(points).astype(np.float32),
        "pair": np.stack([affine(points), -affine(points)], axis=1),
        "colour": rng.integers(0, 256, (n, 4), dtype=np.uint8),
        "large": 2**62 + np.arange(n),
        "flag": rng.integers(0, 2, n).astype(bool),
    }


def face_data(count, rng):
    return {
        "number": np.arange(count),
        "large": 2**63 + np.arange(count, dtype=np.uint64),
        "vector": rng.normal(size=(count, 3)),
        "flag": rng.integers(0, 2, count).astype(bool),
    }


def made(library, mesh, seed):
    points, faces = mesh
    rng = np.random.default_rng(seed)
    return library.make(points, faces, vertex_data(points, rng), face_data(len(faces), rng))


def operands(library):
    return made(library, SPHERE, 1), made(library, BOX, 2)


@pytest.mark.parametrize("library", ALL)
@pytest.mark.parametrize("operation", ["union", "intersection", "difference", "second_minus_first"])
def test_theResultIsOfTheSameTypeAndAsTheFilters(library, operation):
    meshes = pymeshlab.MeshSet()
    for points, faces in (SPHERE, BOX):
        meshes.add_mesh(pymeshlab.Mesh(points, faces))
    name = {"difference": "first_minus_second"}.get(operation, operation)
    expected = meshes.generate_index_boolean(first_mesh=0, second_mesh=1)
    layer = meshes.mesh(expected[f"{name}_layer"])

    report = {}
    result = indexboolean.boolean(*operands(library), operation, report=report)
    assert type(result) is library.type
    points, faces = library.arrays(result)
    assert points.dtype == np.float64
    assert np.array_equal(points, layer.vertex_matrix())
    assert np.array_equal(faces, layer.face_matrix())
    assert report[f"{name}_volume"] == expected[f"{name}_volume"]
    assert not [key for key in report if "layer" in key]


@pytest.mark.parametrize("library", CARRYING)
@pytest.mark.parametrize("operation", ["union", "difference", "xor"])
def test_whatWasNotCutKeepsEveryBit(library, operation):
    given = operands(library)
    result = indexboolean.boolean(*given, operation, sources=True)
    points, faces = library.arrays(result)
    of_vertices, of_faces = library.data(result)
    mesh, vertex = of_vertices["source_mesh"], of_vertices["source_vertex"]
    assert np.array_equal(mesh < 0, vertex < 0) and np.count_nonzero(vertex < 0) > 10
    for number, operand in enumerate(given):
        own_points, own_faces = library.arrays(operand)
        own_vertex_data, own_face_data = library.data(operand)
        of_mesh = mesh == number
        sources = vertex[of_mesh]
        assert len(sources) > 3 or operation == "difference"  # the box's corners are outside
        assert points[of_mesh].tobytes() == own_points[sources].tobytes()
        for name, values in own_vertex_data.items():
            assert of_vertices[name].dtype == values.dtype
            assert of_vertices[name][of_mesh].tobytes() == values[sources].tobytes(), name
        comes = of_faces["source_mesh"] == number
        source = of_faces["source_face"]
        for name, values in own_face_data.items():
            assert of_faces[name].dtype == values.dtype
            assert of_faces[name][comes].tobytes() == values[source[comes]].tobytes(), name
        for face in np.flatnonzero(comes & np.all(mesh[np.array(faces)] == number, axis=1)):
            whole = own_faces[source[face]]
            if set(vertex[faces[face]]) == set(whole):
                assert {*map(bytes, points[faces[face]])} == {*map(bytes, own_points[whole])}


@pytest.mark.parametrize("library", CARRYING)
def test_newVerticesHaveTheMeanOfTheFaceThatTheyLieIn(library):
    result = indexboolean.boolean(*operands(library), sources=True)
    points, _ = library.arrays(result)
    of_vertices, _ = library.data(result)
    is_new = of_vertices["source_vertex"] < 0
    assert np.allclose(of_vertices["affine"], affine(points), rtol=0, atol=1e-14 * 8)
    assert np.allclose(of_vertices["pair"][:, 1], -affine(points), rtol=0, atol=1e-14 * 8)
    assert np.allclose(of_vertices["single"], affine(points), rtol=1e-6, atol=1e-6)
    assert np.all(of_vertices["large"][is_new] >= 2**62)
    # The curve takes the values of the first mesh: a colour lies between those of a face's corners.
    colours = library.data(made(library, SPHERE, 1))[0]["colour"]
    assert np.all(of_vertices["colour"][is_new] <= colours.max(axis=0))


@pytest.mark.parametrize("library", CARRYING)
@pytest.mark.parametrize("kind", [np.int64, np.uint64, np.int8])
@pytest.mark.parametrize("limit", ["min", "max"])
def test_theLimitsOfIntegersStayThemselvesWithoutAWarning(library, kind, limit):
    value = getattr(np.iinfo(kind), limit)
    first, second = (
        library.make(*mesh, {"limit": np.full(len(mesh[0]), value)}, {}) for mesh in (SPHERE, BOX)
    )
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        values = library.data(indexboolean.boolean(first, second))[0]["limit"]
    assert np.all(values == value)


@pytest.mark.parametrize("library", CARRYING)
def test_dataThatOneMeshLacksIsMissingThere(library):
    points, faces = SPHERE
    first = library.make(points, faces, {"q": affine(points)}, {"k": np.arange(len(faces))})
    second = library.make(*BOX, {}, {"own": np.ones(12), "k": np.ones((12, 2))})
    of_vertices, of_faces = library.data(indexboolean.boolean(first, second, sources=True))
    of_second = of_faces["source_mesh"] == 1
    assert np.all(of_faces["k"][of_second] == 0) and of_faces["k"].dtype.kind == "i"
    assert np.array_equal(np.isnan(of_faces["own"]), ~of_second)
    assert np.array_equal(np.isnan(of_vertices["q"]), of_vertices["source_mesh"] == 1)


@pytest.mark.parametrize("library", ALL)
def test_meshesAreNotChanged(library):
    given = operands(library)
    before = [str(library.arrays(mesh)) + str(library.data(mesh)) for mesh in given]
    indexboolean.boolean(*given)
    indexboolean.split(*given)
    indexboolean.distance(*given)
    assert before == [str(library.arrays(mesh)) + str(library.data(mesh)) for mesh in given]


def test_severalOperationsComeFromOneIntersection():
    report = {}
    names = ("union", "difference", "second_minus_first", "intersection", "xor")
    meshes = indexboolean.boolean(SPHERE, BOX, names, report=report)
    assert tuple(meshes) == names
    volumes = {name: volume(*mesh) for name, mesh in meshes.items()}
    assert volumes["union"] - volumes["intersection"] == pytest.approx(volumes["xor"], rel=1e-13)
    assert volumes["difference"] == pytest.approx(report["first_minus_second_volume"], rel=1e-13)


@pytest.mark.parametrize("library", CARRYING)
def test_sourcesAreThereOnlyIfTheyAreAskedFor(library):
    of_vertices, of_faces = library.data(indexboolean.boolean(*operands(library)))
    assert not [name for name in (*of_vertices, *of_faces) if name.startswith("source")]


def test_facesHaveTheTypeOfTheFirstMeshsIndices():
    for kind in (np.int32, np.int64, np.uint32):
        (points, faces) = SPHERE
        assert indexboolean.boolean((points, faces.astype(kind)), BOX)[1].dtype == kind


@pytest.mark.parametrize("library", [library for library in ALL if library.has_polygons])
def test_quadsStayQuads(library):
    rng = np.random.default_rng(3)
    first, second = (
        library.make(*mesh, {}, {"number": rng.permutation(6)})
        for mesh in (cube_of_quads((0, 0, 0), (2, 2, 2)), cube_of_quads((1, 0.5, 0.5), (4, 1, 1.5)))
    )
    result = indexboolean.boolean(first, second, sources=True)
    points, faces = library.arrays(result)
    sizes = [len(face) for face in faces]
    # A bar stands out of one side: that side has a hole, and is pieces; all others are quads.
    assert sizes.count(4) >= 10
    assert volume(points, faces) == pytest.approx(8 + 2 * 0.5 * 1, rel=1e-14)
    if library is Arrays:
        return
    _, of_faces = library.data(result)
    for face, number, mesh, source in zip(
        faces, of_faces["number"], of_faces["source_mesh"], of_faces["source_face"]
    ):
        operand = (first, second)[mesh]
        assert library.data(operand)[1]["number"][source] == number
        own_points, own_faces = library.arrays(operand)
        corners = own_points[own_faces[source]]
        normal = np.cross(corners[1] - corners[0], corners[2] - corners[0])
        assert np.all((points[face] - corners[0]) @ normal == 0)  # in the plane of its source


def test_trianglesComeBackWhereTheTypeHasNoPolygons():
    first = made(Trimesh, SPHERE, 1)
    second = made(PyVista, cube_of_quads((-0.5, -0.25, -1), (0.5, 0.75, 2)), 2)
    result = indexboolean.boolean(first, second, sources=True)
    assert type(result) is Trimesh.type
    of_second = result.face_attributes["source_mesh"] == 1
    assert set(result.face_attributes["number"][of_second]) <= set(range(6))
    assert np.all(result.face_attributes["source_face"][of_second] < 6)


@pytest.mark.parametrize("library", CARRYING)
@pytest.mark.parametrize("merging", [{"merge_coplanar": True}, {"merge_tolerance": 1e-12}], ids=str)
def test_coplanarFacesAreMergedWhereTheirDataAreEqual(library, merging):
    points, faces = halved(*BOX)  # each side is eight faces
    other = box((0.25, 0, 1), (3, 0.25, 1.5))
    counts = []
    for labels in (np.zeros(48), np.repeat([0, 1], 24), np.arange(48)):
        first = library.make(points, faces, {}, {"label": labels, "one": np.ones(48, dtype="<U1")})
        second = library.make(*other, {}, {"label": np.zeros(12), "one": np.ones(12, dtype="<U1")})
        result = indexboolean.boolean(first, second, **merging)
        counts.append(len(library.arrays(result)[1]))
    assert counts[0] < counts[1] < counts[2]


def test_aVertexOnASeamStaysTwo():
    points, faces = BOX
    twice = points[faces.ravel()], np.arange(36).reshape(-1, 3)
    smooth = Trimesh.make(*twice, {"q": affine(twice[0])}, {})
    seamed = Trimesh.make(*twice, {"q": np.repeat(np.arange(12.0), 3)}, {})
    ball = made(Trimesh, SPHERE, 1)
    assert indexboolean.boolean(smooth, ball).is_watertight
    result = indexboolean.boolean(seamed, ball)
    assert not result.is_watertight
    result.merge_vertices(merge_tex=True)
    assert result.is_watertight


@pytest.mark.parametrize("library", ALL)
def test_evaluateTakesNamesAndGivesAResultForEachStatement(library):
    a, b = operands(library)
    report = {}
    made_of = indexboolean.evaluate("common = a & b; a - common", {"b": b, "a": a}, report=report)
    assert list(made_of) == ["common", "result_1"]
    expected = indexboolean.boolean(a, b, ("intersection", "difference"))
    for name, mesh in zip(made_of, expected.values()):
        points, faces = library.arrays(made_of[name])
        assert volume(points, faces) == pytest.approx(volume(*library.arrays(mesh)), rel=1e-13)
    assert report["results"] == 2
    assert type(indexboolean.evaluate("a | b", {"a": a, "b": b})) is library.type


@pytest.mark.parametrize("text, name", [
    ("result_1 = a - b; a & b", "result_1"), ("a - b; result_0 = a & b", "result_0"),
    ("a - b; b - a; result_2 = a; result_1 = b", "result_1"),
])
def test_aNameThatAnUnnamedStatementWouldHaveIsRefused(text, name):
    with pytest.raises(indexboolean.MeshRefusal, match=f'would be "{name}".* Give it a name'):
        indexboolean.evaluate(text, {"a": SPHERE, "b": BOX})


def test_aStatementMayHaveTheNameThatItWouldHave():
    made_of = indexboolean.evaluate("result_0 = a - b; result_0 | b", {"a": SPHERE, "b": BOX})
    assert list(made_of) == ["result_0", "result_1"]


@pytest.mark.parametrize("call, options", [
    (indexboolean.boolean, ("curves", "select_curve_vertices")),
    (lambda a, b, **options: indexboolean.evaluate("a - b", {"a": a, "b": b}, **options),
     ("curves", "select_curve_vertices", "hide_operands")),
    (lambda a, b, **options: indexboolean.resolve(a, **options), ("select_curve_vertices",)),
    (indexboolean.split, (
        "sub_surfaces_first", "sub_surfaces_second", "first_inside_second", "second_outside_first",
        "separate_layers", "max_layers", "layers", "transfer_attributes",
    )),
    (indexboolean.distance, ("color", "sources", "transfer_attributes")),
])
def test_whatWouldHaveNoEffectIsNoOption(call, options):
    for option in options:
        with pytest.raises(TypeError, match=f"there is no option {option};"):
            call(SPHERE, BOX, **{option: False})


def test_dataFollowTheOrderInWhichTheTextNamesMeshes():
    a, b = operands(Trimesh)
    result = indexboolean.evaluate("b - a", {"a": a, "b": b}, sources=True)
    expected = indexboolean.boolean(a, b, "second_minus_first", sources=True)
    assert np.array_equal(
        np.unique(result.face_attributes["source_mesh"], return_counts=True),
        np.unique(expected.face_attributes["source_mesh"], return_counts=True),
    )
    of_b = result.face_attributes["source_mesh"] == 1
    numbers, sources = (result.face_attributes[name][of_b] for name in ("number", "source_face"))
    assert np.array_equal(numbers, sources)


@pytest.mark.parametrize("library", ALL)
@pytest.mark.parametrize("has_polygons", [False, True])
def test_anEmptyResultIsAnEmptyMesh(library, has_polygons):
    first, far = (
        made(library, mesh, 1) for mesh in (
            (cube_of_quads((0, 0, 0), (1, 1, 1)), cube_of_quads((9, 9, 9), (10, 10, 10)))
            if has_polygons and library.has_polygons else (SPHERE, sphere((9, 9, 9)))
        )
    )
    for options in ({}, {"sources": True}):
        results = [
            indexboolean.boolean(first, far, "intersection", **options),
            *indexboolean.boolean(first, first, ("difference", "xor"), **options).values(),
            *indexboolean.evaluate("a & b; a - a", {"a": first, "b": far}, **options).values(),
        ]
        for result in results:
            points, faces = library.arrays(result)
            assert type(result) is library.type and len(points) == len(faces) == 0


@pytest.mark.parametrize("library", ALL)
def test_resolveGivesOneSurface(library):
    bars = library.make(*crossing_bars(), {}, {})
    report = {}
    points, faces = library.arrays(indexboolean.resolve(bars, report=report))
    assert report["resolved_components"] == 1
    assert volume(points, faces) == pytest.approx(report["resolved_volume"], rel=1e-14)
    inner = box((-0.25, -0.25, -0.25), (0.25, 0.25, 0.25))
    hollow = joined(box((-1, -1, -1), (1, 1, 1)), (inner[0], inner[1][:, ::-1]))
    points, faces = library.arrays(
        indexboolean.resolve(library.make(*hollow, {}, {}), outer_hull=True)
    )
    assert volume(points, faces) == 8


@pytest.mark.parametrize("library", ALL)
def test_splitGivesEveryPieceWithItsNumbers(library):
    corners = np.array([(-2, -2, 0.3), (2, -2, 0.4), (2, 2, 0.5), (-2, 2, 0.6)])
    sheet = corners, np.array([(0, 1, 2), (0, 2, 3)])
    a, b = operands(library)
    report = {}
    pieces = indexboolean.split(a, b, library.make(*sheet, {}, {}), report=report)
    assert [len(surfaces) for surfaces in pieces.sub_surfaces] == [
        report[f"sub_surfaces_{number}"] for number in range(3)
    ]
    assert len(pieces.sub_blocks) == report["sub_blocks"] > 3
    for block, expected in zip(pieces.sub_blocks, report["sub_blocks_volumes"]):
        assert type(block) is library.type
        assert volume(*library.arrays(block)) == pytest.approx(expected, rel=1e-12)
    if library is Arrays:
        return
    for surfaces in pieces.sub_surfaces:
        for number, surface in enumerate(surfaces):
            assert np.all(library.data(surface)[1]["sub_surface"] == number)
    for number, block in enumerate(pieces.sub_blocks):
        of_vertices, of_faces = library.data(block)
        assert np.all((of_faces["block_front"] == number) | (of_faces["block_back"] == number))
        points = library.arrays(block)[0]
        known = ~np.isnan(of_vertices["affine"])
        assert np.allclose(of_vertices["affine"][known], affine(points[known]), atol=1e-13)


def test_splitOfOneKindAndOfNothing():
    pieces = indexboolean.split(SPHERE, BOX, sub_blocks=False)
    assert pieces.sub_blocks == [] and len(pieces.sub_surfaces[0]) > 1
    far = sphere((9, 9, 9))
    assert indexboolean.split(SPHERE, far, sub_surfaces=False).sub_surfaces == [[], []]


@pytest.mark.parametrize("library", CARRYING)
def test_distanceIsThatOfTheArrays(library):
    a, b = operands(library)
    measure = indexboolean.SignedDistance(BOX)
    report = {}
    result = indexboolean.distance(a, b, closest=True, direction=True, report=report)
    points, faces = library.arrays(result)
    of_vertices, of_faces = library.data(result)
    distance, gradient, face = measure(points)
    assert np.array_equal(of_vertices["distance"], distance)
    assert np.array_equal(of_vertices["distance_direction"], gradient)
    assert np.array_equal(of_vertices["closest_face"], face)
    assert np.array_equal(of_vertices["affine"], affine(SPHERE[0]))
    assert len(of_faces["distance"]) == len(faces)
    both = indexboolean.distance(a, b, both_ways=True, report=report)
    assert report["hausdorff"] == max(
        np.abs(values["distance"]).max() for mesh in both for values in library.data(mesh)
    )


def test_distanceOfArraysIsArrays():
    at_vertices, at_faces = indexboolean.distance(SPHERE, BOX)
    assert np.array_equal(at_vertices, indexboolean.SignedDistance(BOX)(SPHERE[0])[0])
    assert len(at_faces) == len(SPHERE[1])


def test_closestFacesOfPolygonsAreTheirNumbers():
    cube = PyVista.make(*cube_of_quads((0, 0, 0), (1, 1, 1)), {}, {})
    points = np.array([(0.5, 0.5, 3), (0.5, 0.5, -3), (-3, 0.5, 0.5)])
    cloud = (points, np.empty((0, 3), int))
    result = indexboolean.distance(
        PyVista.make(points, [(0, 1, 2)], {}, {}), cube, closest=True
    )
    assert list(result.point_data["closest_face"]) == [1, 0, 4]
    assert np.array_equal(result.point_data["distance"], [2, 3, 3])
    assert np.array_equal(indexboolean.distance(cloud, cube)[0], [2, 3, 3])


OPEN = BOX[0], BOX[1][1:]


@pytest.mark.parametrize("library", ALL)
def test_aRefusalCarriesItsSentenceAndItsFaces(library):
    open_box = library.make(*OPEN, {}, {})
    ball = library.make(*SPHERE, {}, {})
    meshes = pymeshlab.MeshSet()
    meshes.add_mesh(pymeshlab.Mesh(*SPHERE), "first")
    meshes.add_mesh(pymeshlab.Mesh(*OPEN), "second")
    with pytest.raises(pymeshlab.PyMeshLabException) as host:
        meshes.generate_index_boolean(first_mesh=0, second_mesh=1)
    expected = np.flatnonzero(meshes.mesh(1).face_selection_array())
    with pytest.raises(indexboolean.MeshRefusal) as refusal:
        indexboolean.boolean(ball, open_box)
    sentence = refusal.value.sentence
    assert str(refusal.value) == sentence
    assert sentence.startswith('Mesh "second" is not closed: 7 edges have a face on one side only')
    defect = re.search(r"is not closed: .*?\. (?=The faces)", str(host.value))[0]
    assert defect.strip() in sentence and "indexboolean.split cuts with it" in sentence
    assert refusal.value.operand == 1
    assert np.array_equal(refusal.value.faces, expected) and len(expected) > 2
    assert isinstance(refusal.value, ValueError)


def test_facesOfARefusalArePolygons():
    points, faces = cube_of_quads((0, 0, 0), (1, 1, 1))
    with pytest.raises(indexboolean.MeshRefusal) as refusal:
        indexboolean.boolean(PyVista.make(points, faces[1:], {}, {}), PyVista.make(*SPHERE, {}, {}))
    assert refusal.value.operand == 0
    assert list(refusal.value.faces) == [1, 2, 3, 4]  # all but the one that is opposite the hole


@pytest.mark.parametrize("faces, sentence, numbers", [
    (np.array([(0, 1, 2), (0, 1, 8), (0, -1, 2)]), "face 1 names vertex 8, of which there are 8, "
     "as does 1 more", [1, 2]),
    ([(0, 1, 2), (0, 1, 2, 9)], "face 1 names vertex 9, of which there are 8", [1]),
    ([(0, 1, 2), (0, 1)], "face 1 has fewer than three corners", [1]),
    (np.array([(0, 1, 2**40)]), f"face 0 names vertex {2**40}", [0]),
    (np.array([(0.0, 1.0, 2.0)]), "faces are indices, not float64", []),
    (np.array([0, 1, 2]), "not (3,)", []),
])
def test_facesThatAreNoneAreRefused(faces, sentence, numbers):
    with pytest.raises(indexboolean.MeshRefusal, match=re.escape(sentence)) as refusal:
        indexboolean.boolean(SPHERE, (BOX[0], faces))
    assert refusal.value.operand == 1
    assert list(refusal.value.faces) == numbers


@pytest.mark.parametrize("vertices", [np.zeros((8, 2)), np.zeros(8)])
def test_verticesThatAreNoneAreRefused(vertices):
    with pytest.raises(indexboolean.MeshRefusal, match="vertices are n x 3 numbers"):
        indexboolean.boolean((vertices, BOX[1]), SPHERE)


@pytest.mark.parametrize("empty", [
    ([], []), (np.empty((0, 3)), np.empty((0, 3), dtype=int)), Trimesh.type(), PyVista.type(),
    Meshio.type(np.empty((0, 3)), []),
])
def test_aMeshWithoutVerticesIsRefused(empty):
    calls = {
        "first": lambda: indexboolean.boolean(empty, BOX),
        "second": lambda: indexboolean.boolean(BOX, empty),
        "b": lambda: indexboolean.evaluate("a - b", {"a": BOX, "b": empty}),
        "mesh": lambda: indexboolean.resolve(empty),
        "mesh 1": lambda: indexboolean.split(BOX, empty),
    }
    for name, call in calls.items():
        with pytest.raises(indexboolean.MeshRefusal, match="is empty: it has no faces") as refusal:
            call()
        assert f'Mesh "{name}"' in refusal.value.sentence
        assert refusal.value.operand == (name in ("second", "b", "mesh 1"))
    for meshes in ((empty, BOX), (BOX, empty)):
        with pytest.raises(indexboolean.MeshRefusal, match="is empty: it has no faces"):
            indexboolean.distance(*meshes)


def test_coordinatesThatAreNotFiniteAreRefused():
    points = BOX[0].copy()
    points[3, 1] = np.nan
    with pytest.raises(indexboolean.MeshRefusal, match='Mesh "first"') as refusal:
        indexboolean.boolean((points, BOX[1]), SPHERE)
    assert np.array_equal(refusal.value.faces, np.flatnonzero(np.any(BOX[1] == 3, axis=1)))


MESH = Trimesh.type(*BOX)
LISTS = [(points.tolist(), faces.tolist()) for points, faces in (SPHERE, BOX)]


def trimesh_union(meshes):
    indexboolean.register_trimesh_engine()
    return trimesh.boolean.union(meshes, engine="indexboolean")


@pytest.mark.parametrize("call, error, sentence", [
    (lambda: indexboolean.boolean(SPHERE, 3), TypeError, 'mesh "second" is of type int; known'),
    (lambda: indexboolean.boolean(SPHERE, BOX, "plus"), ValueError, "no operation 'plus'"),
    (lambda: indexboolean.boolean(SPHERE, BOX, winding_role="odd"), TypeError,
     "no option winding_role; there are .*winding_rule"),
    (lambda: indexboolean.boolean(SPHERE, BOX, winding_rule="even"), ValueError, "nonzero"),
    (lambda: indexboolean.boolean(SPHERE, BOX, weld_distance=-1), ValueError,
     "weld_distance is -1"),
    (lambda: indexboolean.evaluate("a - ", {"a": BOX}), indexboolean.MeshRefusal,
     "line 1, column 5"),
    (lambda: indexboolean.evaluate("a = 1 - 0", {"a": BOX}), indexboolean.MeshRefusal,
     "is the name of a mesh"),
    (lambda: indexboolean.evaluate("a", {"union": BOX}), ValueError, "cannot be a mesh's name"),
    (lambda: indexboolean.split(), TypeError, "there is no mesh"),
    (lambda: indexboolean.boolean(SPHERE, BOX, BOX), TypeError, "operation is a name such"),
    (lambda: indexboolean.boolean(SPHERE, BOX, MESH), TypeError, "evaluate.* is of more"),
    (lambda: indexboolean.boolean(SPHERE, BOX, None), TypeError, "and not of type NoneType; evalu"),
    (lambda: indexboolean.boolean(SPHERE, BOX, ()), ValueError, "no operation is asked for; there"),
    (lambda: indexboolean.boolean([MESH, MESH], BOX), TypeError, '"first" is a list of meshes'),
    (lambda: indexboolean.split([MESH, MESH]), TypeError, r"one by one, as in split\(a, b\)"),
    (lambda: indexboolean.split([SPHERE, BOX, BOX]), TypeError, '"mesh 0" is a list of meshes'),
    (lambda: indexboolean.split(LISTS), TypeError, '"mesh 0" is a list of meshes'),
    (lambda: indexboolean.evaluate("a - b", [SPHERE, BOX]), TypeError, 'such as {"a": a, "b": b}'),
    (lambda: indexboolean.evaluate("a", {1: BOX}), TypeError, "a name of a mesh is a text"),
    (lambda: indexboolean.evaluate(BOX, {"a": BOX}), TypeError, "expression is a text such as"),
    (lambda: indexboolean.boolean(SPHERE, BOX, merge_tolerance=None), TypeError,
     "merge_tolerance is a number, not None"),
    (lambda: indexboolean.boolean(SPHERE, BOX, weld_distance="1"), TypeError, "a number, not '1'"),
    (lambda: indexboolean.boolean(SPHERE, BOX, octree_max_depth="7"), TypeError,
     "octree_max_depth is a whole number, not '7'"),
    (lambda: indexboolean.boolean(SPHERE, BOX, winding_rule=None), TypeError, "is a word such as"),
    (lambda: indexboolean.boolean(SPHERE, BOX, merge_coplanar="no"), TypeError, "True or False"),
    (lambda: indexboolean.resolve(SPHERE, outer_hull="no"), TypeError, "outer_hull is True"),
    (lambda: indexboolean.boolean(SPHERE, BOX, transfer_attributes=None), TypeError, "or False"),
    (lambda: trimesh_union([]), ValueError, "there is no mesh; union takes a list of one or more"),
])
def test_mistakesAreToldApart(call, error, sentence):
    with pytest.raises(error, match=sentence):
        call()


# What speaks of lists of layers and of their names cannot be met by the functions.
OF_LAYERS = "given twice|no layer|nothing is asked|name of another|a list stands|not in the list"


@pytest.mark.parametrize("case", [
    case for case in CASES
    if not re.search("implicit|curves", case.filter) and not re.search(OF_LAYERS, case.refusal)
], ids=lambda case: case.name)
def test_refusalsAreInTheWordsOfTheFunctions(case):
    meshes = case.make()
    with pytest.raises(pymeshlab.PyMeshLabException) as error:
        refusal_cases.run(meshes, case.filter, **case.parameters)
    words = in_words_of_python(str(error.value).partition("Details: ")[2])
    assert not re.search(r"(?i)\blayers?\b|selected|generate_index|\(id \d|\w = ", words), words


def test_aDocumentThatWasRefusedHarmsNoLaterCall():
    program = """
import gc, numpy as np, pymeshlab, indexboolean
from conftest import box, sphere
ball, (points, faces) = sphere(), box((0, 0, 0), (2, 2, 2))
for turn in range(40):
    try:
        indexboolean.boolean(ball, (points, faces[1:]))
    except indexboolean.MeshRefusal as refusal:
        assert len(refusal.faces) == 3
    gc.collect()
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh("sample_meshes/bar.ply")
    if turn % 3 == 0:
        indexboolean.boolean(ball, (points, faces))
print("done")
"""
    root = refusal_cases.__file__.split("/tests/")[0]
    done = subprocess.run(
        [sys.executable, "-c", f"import sys; sys.path.append('tests/python')\n{program}"], cwd=root,
        capture_output=True, text=True, timeout=120,
        env={**os.environ, "MALLOC_PERTURB_": "165"},  # what is freed is overwritten
    )
    assert done.returncode == 0 and done.stdout.endswith("done\n"), done.stderr


def test_noLibraryIsImported():
    program = """
import sys
import indexboolean
box = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
quads = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
moved = [[x + 0.5 for x in p] for p in box]
vertices, faces = indexboolean.boolean((box, quads), (moved, quads))
indexboolean.split((box, quads), (moved, quads))
indexboolean.distance((box, quads), (moved, quads))
try:
    indexboolean.boolean(3, 4)
except TypeError:
    pass
found = {"trimesh", "pyvista", "meshio", "vtk", "vtkmodules", "scipy", "rich"} & set(sys.modules)
print(len(faces), sorted(found))
"""
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert done.stdout.split(maxsplit=1)[1] == "[]\n"


def test_aResultThatDoesNotHoldIsAWarning(monkeypatch):
    from indexboolean.mesh_document import MeshDocument

    run = MeshDocument.run

    def with_faults(self, *arguments):
        return {**run(self, *arguments), "union_self_intersections": 2}

    monkeypatch.setattr(MeshDocument, "run", with_faults)
    with pytest.warns(RuntimeWarning, match="union: 2 faces are flat, or meet others wrongly"):
        indexboolean.boolean(SPHERE, BOX)
    monkeypatch.undo()
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        indexboolean.boolean(SPHERE, BOX)
