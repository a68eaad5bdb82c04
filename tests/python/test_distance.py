# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""compute_index_boolean_distance and _implicit, SignedDistance on arrays, and their command.

Oracles: closed forms of boxes and spheres, and libigl's distances and winding numbers.
"""

import json
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

import igl
import numpy as np
import pymeshlab
import pytest
import pyvista
import vtk

import indexboolean
from conftest import box, document, joined, sphere
from make_samples import octahedral_sphere
from open_shapes import square
from sample_catalogue import FOLDER, sample
from test_filter import log_of, set_matrix, translation

UNIT = box((0, 0, 0), (1, 1, 1))


def from_box(points, low, high):
    """The signed distance from a box, in closed form."""
    out = np.maximum(np.asarray(low) - points, points - np.asarray(high))
    outside = np.linalg.norm(np.maximum(out, 0), axis=1)
    return np.where(out.max(axis=1) > 0, outside, out.max(axis=1))


def points_around(mesh, count, seed=1):
    vertices = mesh[0]
    low, high = vertices.min(axis=0), vertices.max(axis=0)
    margin = 0.3 * (high - low).max()
    return np.random.default_rng(seed).uniform(low - margin, high + margin, (count, 3))


def centres(mesh):
    return mesh.transformed_vertex_matrix()[mesh.face_matrix()].mean(axis=1)


# --- arrays ---------------------------------------------------------------------------------------


def test_arraysOfABox():
    points = points_around(UNIT, 5000)
    signed_distance = indexboolean.SignedDistance(UNIT)
    distance, gradient, face = signed_distance(points)
    truth = from_box(points, (0, 0, 0), (1, 1, 1))
    assert np.all(np.abs(distance - truth) <= signed_distance.error_bound(truth))
    assert np.allclose(np.linalg.norm(gradient, axis=1), 1, rtol=0, atol=1e-14)
    closest, of = signed_distance.closest(points)
    assert np.array_equal(of, face)
    assert np.allclose(closest + distance[:, None] * gradient, points, rtol=0, atol=1e-13)
    assert np.allclose(np.clip(closest, 0, 1), closest)
    assert np.array_equal(signed_distance.sign(points), np.sign(truth))
    assert signed_distance.is_closed and not signed_distance.is_resolved
    assert signed_distance.volume == pytest.approx(1)


CLOSED = sorted(path.stem for path in FOLDER.glob("*.ply") if path.stem != "wavy_cutter")


@pytest.mark.parametrize("name", CLOSED)
def test_arraysOfSamplesAgreeWithLibigl(name):
    mesh = sample(name)
    vertices, faces = np.asarray(mesh[0], dtype=np.float64), np.asarray(mesh[1])
    points = points_around(mesh, 10_000)
    distance, _, face = indexboolean.SignedDistance((vertices, faces))(points)
    squared, index, _ = igl.point_mesh_squared_distance(points, vertices, faces)
    assert np.allclose(np.abs(distance), np.sqrt(squared), rtol=0, atol=1e-12)
    winding = np.atleast_1d(igl.winding_number(vertices, faces, points))
    assert np.array_equal(distance < 0, np.abs(winding) > 0.5)
    same = face == index
    corners = vertices[faces[face[~same]]]
    again = [
        igl.point_mesh_squared_distance(point[None], three, np.array([[0, 1, 2]]))[0]
        for point, three in zip(points[~same][:200], corners[:200])
    ]
    assert np.allclose(np.ravel(again), np.ravel(squared[~same][:200]), rtol=1e-9, atol=1e-15)


def to_segment(points, start, end):
    """Of pairs of points and segments, row by row, in the type of the arrays."""
    edge, offset = end - start, points - start
    along = np.clip((edge * offset).sum(axis=1) / (edge * edge).sum(axis=1), 0, 1)
    return np.sqrt(((offset - along[:, None] * edge) ** 2).sum(axis=1))


def to_faces(points, corners):
    a, b, c = np.moveaxis(corners, 1, 0)
    normal = np.cross(b - a, c - a)
    is_above = np.all([
        (normal * np.cross(end - start, points - start)).sum(axis=1) >= 0
        for start, end in ((a, b), (b, c), (c, a))
    ], axis=0)
    height = np.abs((normal * (points - a)).sum(axis=1)) / np.sqrt((normal**2).sum(axis=1))
    edges = np.min([to_segment(points, *ends) for ends in ((a, b), (b, c), (c, a))], axis=0)
    return np.where(is_above, height, edges)


def by_all_faces(vertices, faces, points, claimed):
    """The distances from all faces, in long double. A face is passed over where a ball around it
    is farther than is claimed, which shows that it is not nearer."""
    corners = vertices[faces]
    middle = corners.mean(axis=1)
    radius = np.linalg.norm(corners - middle[:, None], axis=2).max(axis=1)
    least = np.full(len(points), np.inf, dtype=np.longdouble)
    for begin in range(0, len(points), 200):
        some = points[begin : begin + 200]
        reach = claimed[begin : begin + 200, None] + radius + 1e-9
        squares = (some**2).sum(axis=1)[:, None] + (middle**2).sum(axis=1)
        squared = squares - 2 * some @ middle.T
        which, face = np.nonzero(squared <= reach**2 + 1e-9)
        found = to_faces(some[which].astype(np.longdouble), corners[face].astype(np.longdouble))
        np.minimum.at(least, begin + which, found)
    return least


@pytest.mark.parametrize("count", [1000, pytest.param(10_000, marks=pytest.mark.long)])
@pytest.mark.parametrize("name", CLOSED)
def test_arraysOfSamplesAreWithinTheBoundOfAllFacesInLongDouble(name, count):
    vertices, faces = np.asarray(sample(name)[0], dtype=np.float64), np.asarray(sample(name)[1])
    points = points_around((vertices, faces), count, seed=2)
    unsigned = indexboolean.SignedDistance((vertices, faces), signed=False)
    distance, _, _ = unsigned(points)
    truth = by_all_faces(vertices, faces, points, distance)
    assert np.all(np.abs(distance - truth) <= unsigned.error_bound(distance))


def test_twoSolidsThatOverlapAreOne():
    both = joined(box((0, 0, 0), (2, 2, 2)), box((1, 1, 1), (3, 3, 3)))
    resolved = indexboolean.SignedDistance(both)
    assert resolved.is_resolved and resolved.self_intersecting_faces > 0
    inner = np.array([(1.25, 1.5, 1.5)])
    assert resolved(inner)[0][0] == pytest.approx(-np.hypot(0.25, 0.5), abs=1e-15)
    trusted = indexboolean.SignedDistance(both, self_intersections="trust")
    assert trusted(inner)[0][0] == -0.25
    odd = indexboolean.SignedDistance(both, winding_rule="odd")
    assert odd(inner)[0][0] == 0.25
    with pytest.raises(ValueError, match="meets itself|intersect"):
        indexboolean.SignedDistance(both, self_intersections="refuse")


def test_whatIsNoPointIsNoNumber():
    points = np.array([(0.5, 0.5, 0.5), (np.nan, 0, 0), (np.inf, 0, 0), (1e300, 0, 0)])
    signed_distance = indexboolean.SignedDistance(UNIT)
    distance, gradient, face = signed_distance(points)
    assert np.array_equal(np.isnan(distance), [False, True, True, False])
    assert np.array_equal(np.isnan(gradient[:, 0]), np.isnan(distance))
    assert np.array_equal(face == -1, np.isnan(distance))
    assert distance[3] == pytest.approx(1e300)
    assert signed_distance(np.empty((0, 3)))[0].shape == (0,)


@pytest.mark.parametrize("mesh, sentence", [
    ((np.empty((0, 3)), np.empty((0, 3), dtype=int)), "no face"),
    ((np.array([(0, 0, 0), (1, 0, 0), (0, np.nan, 0)]), np.array([(0, 1, 2)])), "NaN|finite"),
    ((np.zeros((3, 3)), np.array([(0, 1, 7)])), "vertex|vertices"),
    ((np.zeros((3, 2)), np.array([(0, 1, 2)])), "n x 3"),
    ((np.zeros((3, 3)), np.array([(0.0, 1.0, 2.0)])), "indices"),
])
def test_meshesThatCannotBeUsedAreRefused(mesh, sentence):
    with pytest.raises(ValueError, match=sentence):
        indexboolean.SignedDistance(mesh)


def test_unsignedNegatedAndBounded():
    points = points_around(UNIT, 1000)
    truth = from_box(points, (0, 0, 0), (1, 1, 1))
    unsigned = indexboolean.SignedDistance(UNIT, signed=False)
    assert np.allclose(unsigned(points)[0], np.abs(truth), rtol=0, atol=1e-13)
    signed_distance = indexboolean.SignedDistance(UNIT)
    assert np.array_equal(signed_distance(points, negate=True)[0], -signed_distance(points)[0])
    bounded, _, face = signed_distance(points, max_distance=0.1)
    assert np.array_equal(np.isnan(bounded), np.abs(truth) > 0.1)
    assert np.array_equal(face == -1, np.isnan(bounded))


def test_queriesFromManyThreadsAtOnce():
    mesh = sample("bumpy_sphere")
    signed_distance = indexboolean.SignedDistance(mesh)
    parts = [points_around(mesh, 2000, seed) for seed in range(8)]
    alone = [signed_distance(part) for part in parts]
    with ThreadPoolExecutor(8) as pool:
        together = list(pool.map(signed_distance, parts))
    for one, other in zip(alone, together):
        assert all(np.array_equal(a, b) for a, b in zip(one, other))


def test_aMeshOfThePluginsHostIsTakenWithItsMatrix():
    mesh_set = document(UNIT)
    set_matrix(mesh_set, 0, translation(5, 0, 0))
    signed_distance = indexboolean.SignedDistance(mesh_set.mesh(0))
    assert signed_distance(np.array([(5.5, 0.5, 0.5)]))[0][0] == -0.5


# --- next to the surface --------------------------------------------------------------------------


def exact_sides(vertices, face, points):
    """On which side of a face's plane points lie: signs of determinants of whole numbers."""
    a, b, c = (vertices[corner].astype(object) for corner in face)
    u, v, w = b - a, c - a, points - a
    normal = np.array([u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                       u[0] * v[1] - u[1] * v[0]], dtype=object)
    return np.sign((w * normal).sum(axis=1).astype(object)).astype(int)


@pytest.mark.parametrize("count", [
    30_000, pytest.param(1_000_000, marks=pytest.mark.long),
])
def test_signsWithinATrillionthOfTheSurfaceAreExact(count):
    """A tetrahedron of whole numbers, and points in units of 2^-42 of its size, at most 1e-12 of
    that from faces, edges and vertices: Python's integers tell their sides."""
    rng = np.random.default_rng(5)
    size = 2**50
    vertices = np.array([(0, 0, 0), (7, 1, 2), (1, 6, 3), (2, 3, 9)]) * (size // 16)
    faces = np.array([(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)])
    weights = rng.dirichlet((0.3, 0.3, 0.3), count)
    weights[::3, 0] = 0  # next to an edge
    weights[::17] = np.eye(3)[rng.integers(3, size=len(weights[::17]))]
    weights /= weights.sum(axis=1)[:, None]
    corners = vertices[faces[rng.integers(4, size=count)]]
    on = np.rint((weights[:, :, None] * corners).sum(axis=1))
    points = on + rng.integers(-900, 901, size=(count, 3))  # 900 / 2^50 < 1e-12
    assert np.array_equal(points, points.astype(np.float64).astype(np.int64))
    whole = points.astype(np.int64).astype(object)
    sides = np.array([exact_sides(vertices, face, whole) for face in faces]).max(axis=0)
    found = indexboolean.SignedDistance((vertices.astype(float), faces)).sign(points)
    assert np.array_equal(found, sides)
    assert min((sides == -1).mean(), (sides == 1).mean()) > 0.1


# --- many points and faces ------------------------------------------------------------------------

ASKING_FOR_MANY = """
import sys
import numpy as np
import indexboolean

def most_memory():
    status = dict(line.split(":", 1) for line in open("/proc/self/status"))
    return int(status["VmHWM"].split()[0]) * 1024

vertices, faces, points = (np.load(f"{sys.argv[1]}/{name}.npy") for name in "VFP")
indexboolean.SignedDistance(([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)]))  # loads the library
before = most_memory()
signed_distance = indexboolean.SignedDistance((vertices, faces))
built = most_memory()
signed_distance(points[: len(points) // 2])
half = most_memory()
distance, _, _ = signed_distance(points)
np.save(f"{sys.argv[1]}/D.npy", distance)
print(built - before, half - built, most_memory() - half)
"""


@pytest.mark.long
@pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")
def test_aMillionFacesAndManyMillionPointsInBoundedMemory(tmp_path):
    """Building takes bytes in proportion to faces, and asking those of the answer, besides what is
    kept for a portion of the points."""
    vertices, faces = octahedral_sphere(354)
    assert len(faces) > 1_000_000
    rng = np.random.default_rng(3)
    points = rng.normal(size=(4_000_000, 3))
    points *= rng.uniform(0.8, 1.2, len(points))[:, None] / np.linalg.norm(points, axis=1)[:, None]
    for name, array in zip("VFP", (vertices, faces, points)):
        np.save(tmp_path / f"{name}.npy", array)
    done = subprocess.run([sys.executable, "-c", ASKING_FOR_MANY, tmp_path], capture_output=True,
                          text=True, check=True)
    built, half, rest = map(int, done.stdout.split())
    answer = 8 + 24 + 8 + 24 + 1  # bytes a point: all arrays that there are
    portion = 2**20 * 200
    print(f"{built / len(faces):.0f} bytes a face, {rest / 2_000_000:.0f} a point")
    assert 0 < built < 400 * len(faces), built
    assert half < answer * 2_000_000 + portion, half
    assert rest < answer * 2_000_000 + portion // 4, rest
    truth = np.linalg.norm(points, axis=1) - 1
    distance = np.load(tmp_path / "D.npy")
    assert np.abs(distance - truth).max() < 2e-5  # chords are as much below the sphere
    clear = np.abs(truth) > 2e-5
    assert np.array_equal(distance[clear] < 0, truth[clear] < 0)


# --- VTK's filter ---------------------------------------------------------------------------------


def distances_by_vtk(first, second):
    """Those of the first's vertices, and of its face centres, by VTK's filter."""
    polydata = vtk.vtkDistancePolyDataFilter()
    for port, mesh in enumerate((first, second)):
        polydata.SetInputData(port, pyvista.PolyData.from_regular_faces(*mesh))
    polydata.ComputeCellCenterDistanceOn()
    polydata.Update()
    output = polydata.GetOutput(0)
    return [np.array(data.GetArray("Distance")) for data in
            (output.GetPointData(), output.GetCellData())]


def test_vtksFilterIsReproducedOnItsArrays():
    first, second = sample("bumpy_sphere"), sample("ribbed_torus")
    mesh_set = document(first, second)
    mesh_set.compute_index_boolean_distance()
    for layer, pair in enumerate(((first, second), (second, first))):
        mesh = mesh_set.mesh(layer)
        of_points, of_cells = distances_by_vtk(*pair)
        assert np.allclose(mesh.vertex_scalar_array(), of_points, rtol=0, atol=1e-14)
        assert np.allclose(mesh.face_scalar_array(), of_cells, rtol=0, atol=1e-14)


def test_whereVtksFilterHasTheWrongSign():
    """Inside the first of two solids that overlap, in front of a wall of the second."""
    both = joined(box((0, 0, 0), (2, 2, 2)), box((1, 1, 1), (3, 3, 3)))
    small = box((0.8, 1.4, 1.4), (0.9, 1.6, 1.6))
    of_points, _ = distances_by_vtk(small, both)
    assert np.all(of_points > 0)
    distance, _, _ = indexboolean.SignedDistance(both)(small[0])
    assert np.all(distance < 0)
    assert np.all(from_box(small[0], (0, 0, 0), (2, 2, 2)) < 0)


# --- the filter -----------------------------------------------------------------------------------


def test_bothLayersAreMeasured():
    mesh_set = document(sphere(radius=2), box((-1, -1, -1), (1, 1, 1)))
    result = mesh_set.compute_index_boolean_distance(direction=True, closest=True)
    first, second = mesh_set.mesh(0), mesh_set.mesh(1)
    for mesh, at in ((first, first.vertex_matrix()), (first, centres(first))):
        kind = "vertex" if len(at) == mesh.vertex_number() else "face"
        truth = from_box(at, (-1, -1, -1), (1, 1, 1))
        found = getattr(mesh, f"{kind}_custom_scalar_attribute_array")("distance")
        assert np.allclose(found, truth, rtol=0, atol=1e-12)
        assert np.array_equal(getattr(mesh, f"{kind}_scalar_array")(), found)
        direction = getattr(mesh, f"{kind}_custom_point_attribute_matrix")("distance_direction")
        closest = getattr(mesh, f"{kind}_custom_point_attribute_matrix")("closest_point")
        assert np.allclose(closest + found[:, None] * direction, at, rtol=0, atol=1e-12)
        face = getattr(mesh, f"{kind}_custom_scalar_attribute_array")("closest_face")
        assert face.min() >= 0 and face.max() < second.face_number()
    values = np.concatenate([first.vertex_scalar_array(), first.face_scalar_array()])
    assert result["min_first"] == values.min() and result["max_first"] == values.max()
    assert result["mean_first"] == pytest.approx(values.mean())
    assert result["rms_first"] == pytest.approx(np.sqrt((values**2).mean()))
    assert result["mean_absolute_first"] == pytest.approx(np.abs(values).mean())
    inside = np.concatenate([second.vertex_scalar_array(), second.face_scalar_array()])
    assert np.all(inside < 0) and result["max_second"] == inside.max()
    assert result["hausdorff"] == max(np.abs(values).max(), np.abs(inside).max())
    assert result["beyond_first"] == result["beyond_second"] == 0
    assert {"seconds_build", "seconds_query"} <= set(result)


def test_coloursAreBlueBelowAndRedAboveZero():
    mesh_set = document(joined(box((2, 2, 2), (3, 3, 3)), box((0.4, 0.4, 0.4), (0.5, 0.5, 0.5))),
                        UNIT)
    mesh_set.compute_index_boolean_distance(both_ways=False)
    mesh = mesh_set.mesh(0)
    red, _, blue, _ = mesh.vertex_color_matrix().T
    outside = mesh.vertex_scalar_array() > 0
    assert np.all(red[outside] > blue[outside]) and np.all(blue[~outside] >= red[~outside])


def test_oneWayAtVerticesAloneLeavesTheRestAlone():
    mesh_set = document(UNIT, box((2, 0, 0), (3, 1, 1)))
    result = mesh_set.compute_index_boolean_distance(
        both_ways=False, at_faces=False, color=False
    )
    assert "min_second" not in result and "hausdorff" not in result
    assert not mesh_set.mesh(0).has_face_scalar() and not mesh_set.mesh(1).has_face_scalar()
    with pytest.raises(pymeshlab.PyMeshLabException):
        mesh_set.mesh(1).vertex_custom_scalar_attribute_array("distance")


def test_matricesAreApplied():
    mesh_set = document(UNIT, UNIT)
    set_matrix(mesh_set, 1, translation(3, 0, 0))
    result = mesh_set.compute_index_boolean_distance(closest=True)
    assert result["min_first"] == 2 and result["max_first"] == 3
    closest = mesh_set.mesh(0).vertex_custom_point_attribute_matrix("closest_point")
    assert np.all(closest[:, 0] == 3)


def test_aCloudOfPointsMayBeTheFirst():
    points = points_around(UNIT, 500)
    mesh_set = pymeshlab.MeshSet()
    mesh_set.add_mesh(pymeshlab.Mesh(points), "cloud")
    mesh_set.add_mesh(pymeshlab.Mesh(*UNIT), "box")
    result = mesh_set.compute_index_boolean_distance()
    assert np.allclose(mesh_set.mesh(0).vertex_scalar_array(),
                       from_box(points, (0, 0, 0), (1, 1, 1)), rtol=0, atol=1e-13)
    assert "min_second" not in result and "hausdorff" not in result
    with pytest.raises(pymeshlab.PyMeshLabException, match="cloud.*no face"):
        mesh_set.compute_index_boolean_distance(first_mesh=1, second_mesh=0)


def test_beyondTheMaximumQualitiesAreItAndAttributesNoNumbers():
    mesh_set = document(sphere(radius=3), box((-1, -1, -1), (1, 1, 1)))
    result = mesh_set.compute_index_boolean_distance(max_distance=pymeshlab.PureValue(1.5))
    mesh = mesh_set.mesh(0)
    distance = mesh.vertex_custom_scalar_attribute_array("distance")
    truth = from_box(mesh.vertex_matrix(), (-1, -1, -1), (1, 1, 1))
    beyond = truth > 1.5
    assert np.array_equal(np.isnan(distance), beyond) and beyond.any() and not beyond.all()
    assert np.all(mesh.vertex_scalar_array()[beyond] == 1.5)
    assert np.ptp(mesh.vertex_color_matrix()[beyond][:, :3], axis=1).max() == 0  # grey
    of_faces = np.isnan(mesh.face_custom_scalar_attribute_array("distance")).sum()
    assert result["beyond_first"] == beyond.sum() + of_faces
    assert np.isnan(result["hausdorff"])


def test_anOpenReferenceIsToldOnceAndHasSides():
    sheet = "(np.array([(-2, -2, 0), (2, -2, 0), (2, 2, 0.0)]), np.array([(0, 1, 2)]))"
    log = log_of(
        f"document(box((0, 0, 1), (1, 1, 2)), {sheet})", "compute_index_boolean_distance"
    )
    assert log.count("is open") == 1 and "Hausdorff distance" in log and "Colours: " in log
    mesh_set = document(box((0, 0, 1), (1, 1, 2)), square(-2, 2))
    mesh_set.compute_index_boolean_distance()
    assert np.array_equal(mesh_set.mesh(0).vertex_scalar_array(), UNIT[0][:, 2] + 1)


def test_aSecondRunReplacesTheAttributes():
    mesh_set = document(UNIT, box((3, 0, 0), (4, 1, 1)), box((6, 0, 0), (7, 1, 1)))
    mesh_set.compute_index_boolean_distance()
    mesh_set.compute_index_boolean_distance(first_mesh=0, second_mesh=2)
    assert mesh_set.mesh(0).vertex_custom_scalar_attribute_array("distance").max() == 6


def test_whatIsNoPointOfALayerIsGreyAndNotCounted():
    points = np.array([(0.5, 0.5, 0.5), (np.nan, 0, 0), (0, np.inf, 0), (2, 0.5, 0.5)])
    mesh_set = pymeshlab.MeshSet()
    mesh_set.add_mesh(pymeshlab.Mesh(points), "cloud")
    mesh_set.add_mesh(pymeshlab.Mesh(*UNIT), "box")
    result = mesh_set.compute_index_boolean_distance(closest=True)
    cloud = mesh_set.mesh(0)
    distance = cloud.vertex_custom_scalar_attribute_array("distance")
    assert np.array_equal(distance, [-0.5, np.nan, np.nan, 1], equal_nan=True)
    assert np.array_equal(cloud.vertex_scalar_array(), [-0.5, 0, 0, 1])
    assert np.array_equal(cloud.vertex_custom_scalar_attribute_array("closest_face") < 0,
                          np.isnan(distance))
    assert np.ptp(cloud.vertex_color_matrix()[1:3, :3], axis=1).max() == 0
    assert (result["min_first"], result["max_first"], result["beyond_first"]) == (-0.5, 1, 0)


def test_emptyLayers():
    mesh_set = pymeshlab.MeshSet()
    mesh_set.add_mesh(pymeshlab.Mesh(np.zeros((1, 3))), "empty")
    mesh_set.set_selection_all()
    mesh_set.meshing_remove_selected_vertices()
    assert mesh_set.mesh(0).vertex_number() == 0
    mesh_set.add_mesh(pymeshlab.Mesh(*UNIT), "box")
    result = mesh_set.compute_index_boolean_distance()
    assert np.isnan(result["min_first"]) and result["beyond_first"] == 0
    assert "hausdorff" not in result and "min_second" not in result
    result = mesh_set.compute_index_boolean_implicit(points_mesh=0, reference_mesh=1)
    assert np.isnan(result["max"]) and result["inside"] == 0
    for name, layers in (("distance", ("first_mesh", "second_mesh")),
                         ("implicit", ("points_mesh", "reference_mesh"))):
        compute = getattr(mesh_set, f"compute_index_boolean_{name}")
        with pytest.raises(pymeshlab.PyMeshLabException, match='"empty".*no face'):
            compute(**dict(zip(layers, (1, 0))))


@pytest.mark.parametrize("parameters, sentence", [
    (dict(first_mesh=0, second_mesh=0), "both first_mesh and second_mesh"),
    (dict(at_vertices=False, at_faces=False), "place to measure at"),
    (dict(second_mesh=9), "no layer"),
])
def test_refusals(parameters, sentence):
    mesh_set = document(UNIT, box((3, 0, 0), (4, 1, 1)))
    with pytest.raises(pymeshlab.PyMeshLabException, match=sentence):
        mesh_set.compute_index_boolean_distance(**parameters)


def test_aReferenceThatMeetsItselfIsRefusedIfAskedForWithItsFacesSelected():
    both = joined(box((0, 0, 0), (2, 2, 2)), box((1, 1, 1), (3, 3, 3)))
    mesh_set = document(UNIT, both)
    with pytest.raises(pymeshlab.PyMeshLabException, match='"B"'):
        mesh_set.compute_index_boolean_distance(self_intersections="refuse")
    assert mesh_set.mesh(1).selected_face_number() > 0
    assert not mesh_set.mesh(0).has_face_scalar()


# --- the implicit function ------------------------------------------------------------------------


def test_implicitFunctionOnAGrid():
    axis = np.linspace(-0.5, 1.5, 9)
    points = np.stack(np.meshgrid(axis, axis, axis, indexing="ij"), axis=-1).reshape(-1, 3)
    mesh_set = pymeshlab.MeshSet()
    mesh_set.add_mesh(pymeshlab.Mesh(points), "grid")
    mesh_set.add_mesh(pymeshlab.Mesh(*UNIT), "box")
    result = mesh_set.compute_index_boolean_implicit(gradient=True)
    grid = mesh_set.mesh(0)
    truth = from_box(points, (0, 0, 0), (1, 1, 1))
    assert np.array_equal(grid.vertex_scalar_array(), truth)
    assert np.array_equal(grid.vertex_selection_array(), truth < 0)
    assert result["inside"] == (truth < 0).sum() and result["min"] == -0.5
    normals = grid.vertex_normal_matrix()
    assert np.allclose(np.linalg.norm(normals, axis=1), 1)
    direction = grid.vertex_custom_point_attribute_matrix("distance_direction")
    assert np.allclose(normals, direction)
    mesh_set.compute_index_boolean_implicit(negate=True, select_inside=False)
    assert np.array_equal(mesh_set.mesh(0).vertex_scalar_array(), -truth)


# --- the command ----------------------------------------------------------------------------------


def run_command(folder, *words):
    return subprocess.run(
        [sys.executable, "-m", "indexboolean", *words], cwd=folder, capture_output=True, text=True,
        timeout=200,
    )


@pytest.fixture
def files(tmp_path):
    mesh_set = document(sphere(radius=2), box((-1, -1, -1), (1, 1, 1)))
    for layer, name in enumerate(("A.ply", "B.ply")):
        mesh_set.set_current_mesh(layer)
        mesh_set.save_current_mesh(str(tmp_path / name))
    return tmp_path


def test_commandWritesPropertiesAndStatistics(files):
    done = run_command(files, "distance", "A.ply", "B.ply", "-o", "out", "--plot")
    assert done.returncode == 0, done.stderr
    names = {path.name for path in (files / "out").iterdir()}
    assert names == {"first.ply", "second.ply", "result.json", "distance.png", "histogram.png"}
    header = (files / "out" / "first.ply").read_bytes().split(b"end_header")[0].decode()
    for name in ("double distance", "double direction_x", "double closest_z", "int closest_face",
                 "uchar red"):
        assert header.count(f"property {name}") == 2  # of vertices and of faces
    record = json.loads((files / "out" / "result.json").read_text())
    assert record["max_first"] == pytest.approx(1, abs=1e-12)  # on the axes of the sphere
    assert record["hausdorff"] >= record["max_first"]
    mesh_set = pymeshlab.MeshSet()
    mesh_set.load_new_mesh(str(files / "out" / "first.ply"))
    assert mesh_set.current_mesh().vertex_number() > 100


def test_commandRefusesASecondWithoutFaces(files):
    mesh_set = pymeshlab.MeshSet()
    mesh_set.add_mesh(pymeshlab.Mesh(np.random.default_rng(1).random((9, 3))))
    mesh_set.save_current_mesh(str(files / "C.ply"))
    assert run_command(files, "distance", "A.ply", "C.ply", "-o", "out").returncode == 1
    done = run_command(files, "distance", "C.ply", "A.ply", "-o", "out", "--one-way", "--negate")
    assert done.returncode == 0, done.stderr
    assert not (files / "out" / "second.ply").exists()
