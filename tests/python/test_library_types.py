# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What one library's meshes have that others' do not: visuals and engines of trimesh, active data
and normals of pyvista, blocks and sets of meshio.
"""

import subprocess
import sys

import meshio
import numpy as np
import pytest
import pyvista
import trimesh
from PIL import Image

import indexboolean
from conftest import box, sphere
from library_meshes import Meshio, volume

BALL = sphere((0.25, 0.125, 0.5), 0.9)
BOX = box((-0.5, -0.25, -1), (0.5, 0.75, 2))


def trimeshes():
    return tuple(trimesh.Trimesh(*mesh, process=False) for mesh in (BALL, BOX))


def plain(points):
    """Texture coordinates that are known at every point."""
    return points[:, :2] * 0.125 + 0.5


def textured(mesh, colour):
    image = Image.new("RGB", (8, 8), colour)
    material = trimesh.visual.material.SimpleMaterial(image=image)
    mesh.visual = trimesh.visual.TextureVisuals(uv=plain(mesh.vertices), material=material)
    return mesh


@pytest.mark.parametrize("kind", ["vertex_colors", "face_colors"])
def test_trimeshColoursAreKept(kind):
    ball, cube = trimeshes()
    setattr(ball.visual, kind, [10, 20, 30, 255])
    setattr(cube.visual, kind, [200, 100, 50, 128])
    result = indexboolean.boolean(ball, cube, "difference", sources=True)
    assert result.visual.kind == kind.split("_")[0]
    colours = getattr(result.visual, kind)
    attributes = result.vertex_attributes if kind[0] == "v" else result.face_attributes
    source = attributes["source_mesh"]
    assert np.all(colours[source == 0] == (10, 20, 30, 255))
    assert np.all(colours[source == 1] == (200, 100, 50, 128))
    assert np.all(colours[source < 0] == (10, 20, 30, 255))  # the curve takes the first mesh's


def test_aTrimeshWithoutColoursIsWhiteBesideOneThatHasSome():
    ball, cube = trimeshes()
    cube.visual.face_colors = [1, 2, 3, 255]
    result = indexboolean.boolean(ball, cube, sources=True)
    source = result.face_attributes["source_mesh"]
    assert np.all(result.visual.face_colors[source == 0] == 255)
    assert np.all(result.visual.face_colors[source == 1] == (1, 2, 3, 255))


def test_trimeshTexturesOfOneMaterialKeepItAndTheirCoordinates():
    ball, cube = trimeshes()
    textured(ball, (255, 0, 0))
    cube.visual = trimesh.visual.TextureVisuals(plain(cube.vertices), ball.visual.material)
    result = indexboolean.boolean(ball, cube)
    assert result.visual.material is ball.visual.material
    assert np.allclose(result.visual.uv, plain(result.vertices), rtol=0, atol=1e-15 * 4)


def test_trimeshTexturesOfTwoMaterialsBecomeOneAsTrimeshJoinsThem():
    ball, cube = textured(trimeshes()[0], (255, 0, 0)), textured(trimeshes()[1], (0, 0, 255))
    result = indexboolean.boolean(ball, cube, sources=True)
    colours = result.visual.to_color().vertex_colors
    source = result.vertex_attributes["source_mesh"]
    assert np.all(colours[source == 0][:, [0, 2]] == (255, 0))
    assert np.all(colours[source == 1][:, [0, 2]] == (0, 255))


def test_aTrimeshWithoutTextureBesideOneThatHasOne():
    ball, cube = trimeshes()
    result = indexboolean.boolean(ball, textured(cube, (0, 255, 0)))
    assert result.visual.kind == "texture" and result.visual.material is cube.visual.material


LOOKS = {
    "vertex_colors": "vertex", "face_colors": "face", "image": "texture", "PBR image": "texture",
    "PBR colour": "texture", "colour": "texture", "no coordinates": None, "none": None,
}


def with_look(mesh, look, colour):
    material = trimesh.visual.material
    image = Image.new("RGB", (8, 8), colour)
    materials = {
        "image": lambda: material.SimpleMaterial(image=image),
        "PBR image": lambda: material.PBRMaterial(baseColorTexture=image, metallicFactor=0.5),
        "PBR colour": lambda: material.PBRMaterial(baseColorFactor=(*colour, 255)),
        "colour": lambda: material.SimpleMaterial(diffuse=colour),
        "no coordinates": lambda: material.SimpleMaterial(diffuse=colour),
    }
    if look in materials:
        uv = None if look == "no coordinates" else plain(mesh.vertices)
        mesh.visual = trimesh.visual.TextureVisuals(uv=uv, material=materials[look]())
    elif look != "none":
        setattr(mesh.visual, look, (*colour, 255))
    return mesh


def drawn_colours(mesh):
    """Of vertices, or of faces where these have them."""
    if mesh.visual.kind != "texture":
        return getattr(mesh.visual, f"{mesh.visual.kind}_colors")
    material = mesh.visual.material
    if getattr(material, "image", None) or getattr(material, "baseColorTexture", None):
        return mesh.visual.to_color().vertex_colors
    return np.tile(material.main_color, (len(mesh.vertices), 1))


@pytest.mark.parametrize("second", LOOKS)
@pytest.mark.parametrize("first", LOOKS)
def test_twoTrimeshesOfAnyLooksHaveThatOfTheFirstThatHasOne(first, second):
    given = [
        with_look(mesh, look, colour) for mesh, look, colour in zip(
            trimeshes(), (first, second), ((255, 0, 0), (0, 255, 0))
        )
    ]
    before = [getattr(mesh.visual, "material", None) for mesh in given]
    result = indexboolean.boolean(*given, sources=True)
    kind = LOOKS[first] or LOOKS[second]
    assert result.visual.kind == kind
    assert before == [getattr(mesh.visual, "material", None) for mesh in given]
    if kind is None:
        return
    attributes = result.face_attributes if kind == "face" else result.vertex_attributes
    colours, source = drawn_colours(result), attributes["source_mesh"]
    for number, look in enumerate((first, second)):
        if LOOKS[look] == kind or LOOKS[look] and kind != "texture":
            own = colours[source == number]
            assert np.all(own == ((255, 0, 0, 255), (0, 255, 0, 255))[number]), number


def test_anImageBesideAPbrMaterialKeepsItsColours():
    ball, cube = trimeshes()
    with_look(ball, "PBR colour", (255, 0, 0))
    with_look(cube, "image", (40, 80, 160))
    result = indexboolean.boolean(ball, cube, sources=True)
    of_cube = result.vertex_attributes["source_mesh"] == 1
    assert np.all(drawn_colours(result)[of_cube] == (40, 80, 160, 255))


def test_trimeshUnitsAreKeptIfTheyAgree():
    ball, cube = trimeshes()
    ball.units = cube.units = "mm"
    assert indexboolean.boolean(ball, cube).units == "mm"
    cube.units = "m"
    assert indexboolean.boolean(ball, cube).units is None


def test_theEngineGivesWhatTheFunctionsGive():
    indexboolean.register_trimesh_engine()
    indexboolean.register_trimesh_engine()
    ball, cube = trimeshes()
    third = trimesh.Trimesh(*box((0, 0, 0), (2, 2, 2)), process=False)
    assert "indexboolean" in trimesh.boolean.engines_available
    for name in ("union", "intersection", "difference"):
        by_engine = getattr(trimesh.boolean, name)([ball, cube], engine="indexboolean")
        by_method = getattr(ball, name)(cube, engine="indexboolean")
        expected = indexboolean.boolean(ball, cube, name)
        for mesh in (by_engine, by_method):
            assert np.array_equal(mesh.vertices, expected.vertices)
            assert np.array_equal(mesh.faces, expected.faces)
        of_three = getattr(trimesh.boolean, name)([ball, cube, third], engine="indexboolean")
        manifold = getattr(trimesh.boolean, name)([ball, cube, third], engine="manifold")
        assert of_three.is_watertight
        assert of_three.volume == pytest.approx(manifold.volume, rel=1e-6)
    crossing = trimesh.util.concatenate([ball, cube])
    alone = trimesh.boolean.union([crossing], engine="indexboolean")
    assert alone.volume == pytest.approx(indexboolean.boolean(ball, cube).volume, rel=1e-12)
    with pytest.raises(ValueError, match="two meshes or more"):
        trimesh.boolean.difference([ball], engine="indexboolean")


def test_theEngineIsThereOnlyIfItIsAskedFor():
    program = (
        "import indexboolean, trimesh; print('indexboolean' in trimesh.boolean.engines_available, "
        "indexboolean.register_trimesh_engine(), 'indexboolean' in trimesh.boolean._engines)"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert done.stdout == "False None True\n", done.stderr


def test_theEngineTakesOptionsAndRefuses():
    indexboolean.register_trimesh_engine()
    ball, cube = trimeshes()
    cube.update_faces(np.arange(12) != 4)
    with pytest.raises(indexboolean.MeshRefusal, match="is not closed") as refusal:
        trimesh.boolean.union([ball, cube], engine="indexboolean")
    assert refusal.value.operand == 1
    report = {}
    trimesh.boolean.union([ball, ball.copy().apply_translation([1, 0, 0])], engine="indexboolean",
                          self_intersections="trust", report=report)
    assert report["union_self_intersections"] == -1  # not known, for want of a search


def test_trimeshWithoutATableOfEnginesIsToldSo(monkeypatch):
    monkeypatch.delattr(trimesh.boolean, "_engines")
    with pytest.raises(ImportError, match="has no table of engines"):
        indexboolean.register_trimesh_engine()


@pytest.mark.parametrize("subdivisions", [3, 4])
@pytest.mark.parametrize("name", ["union", "intersection", "difference", "second_minus_first"])
def test_inFloatsTrimeshsMergingOpensNoResult(name, subdivisions, tmp_path):
    ball = trimesh.creation.icosphere(subdivisions=subdivisions)
    bar = trimesh.creation.box((1, 1, 3))
    for options, is_closed in (({}, False), ({"certify_as": "float"}, True)):
        result = indexboolean.boolean(ball, bar, name, **options)
        shortest = np.ptp(result.vertices[result.edges_unique], axis=1).max(axis=1).min()
        assert result.is_watertight and (shortest > 1e-7) == is_closed
        merged = result.copy()
        merged.merge_vertices()
        assert merged.is_watertight == is_closed
        for suffix in ("stl", "ply", "glb"):
            result.export(tmp_path / f"a.{suffix}")
            loaded = trimesh.load_mesh(tmp_path / f"a.{suffix}")
            assert loaded.is_watertight or not is_closed, suffix


def test_mergedWallsTakeShortEdgesAway():
    ball, bar = trimesh.creation.icosphere(subdivisions=4), trimesh.creation.box((1, 1, 3))
    result = indexboolean.boolean(ball, bar, merge_tolerance=1e-6)
    result.merge_vertices()
    assert result.is_watertight


def test_aSeamOfATrimeshIsClosedOnceItIsMerged():
    ball, cube = trimeshes()
    cube.unmerge_vertices()
    uv = np.random.default_rng(1).random((36, 2))
    cube.visual = trimesh.visual.TextureVisuals(uv=uv)
    result = indexboolean.boolean(ball, cube, certify_as="float")
    assert not result.is_watertight
    result.merge_vertices(merge_tex=True)
    assert result.is_watertight
    assert indexboolean.boolean(ball, cube, transfer_attributes=False).is_watertight


def test_aSeamOfAPolyDataIsClosedOnceItIsCleaned():
    cube, pipe = pyvista.Cube(), pyvista.Cylinder(radius=0.2, height=3)
    result = indexboolean.boolean(cube, pipe)
    assert not result.is_manifold and result.clean().is_manifold
    assert indexboolean.boolean(cube, pipe, transfer_attributes=False).is_manifold
    for mesh in (cube, pipe):
        mesh.point_data.clear()
    assert indexboolean.boolean(cube, pipe).is_manifold


def polydata(mesh):
    points, faces = mesh
    return pyvista.PolyData.from_regular_faces(points, faces)


def test_pyvistaPointsInSinglePrecisionStayAsTheyAre():
    ball, cube = pyvista.Sphere(), pyvista.Cube(x_length=0.5, z_length=2).triangulate()
    assert ball.points.dtype == np.float32
    result = indexboolean.boolean(ball, cube, sources=True)
    own = result.point_data["source_mesh"] == 0
    assert result.points.dtype == np.float64 and result.is_manifold
    sources = ball.points[result.point_data["source_vertex"][own]]
    assert np.array_equal(result.points[own], sources.astype(np.float64))


def test_pyvistaNormalsTurnWithTheFaces():
    ball = pyvista.Sphere(theta_resolution=30, phi_resolution=30)
    second = ball.translate((0.25, 0.125, 0.0625))
    result = indexboolean.boolean(ball, second, "difference", sources=True)
    assert result.point_data.active_normals_name == "Normals"
    normals, source = result.point_data["Normals"], result.point_data["source_mesh"]
    is_new = source < 0
    assert np.allclose(np.linalg.norm(normals[is_new], axis=1), 1) and np.all(normals == normals)
    assert normals.dtype == np.float32
    outward = {0: result.points, 1: (0.25, 0.125, 0.0625) - result.points}
    for number, direction in outward.items():
        assert np.all(np.sum(normals * direction, axis=1)[source == number] > 0.4)
    vertex = result.point_data["source_vertex"]
    of_second = source == 1
    given = np.asarray(second.point_data["Normals"])[vertex[of_second]]
    assert np.array_equal(normals[of_second], -given)


def test_pyvistaNormalsAreLeftOutUnlessAllMeshesHaveThem():
    bare = polydata(BOX)
    assert "Normals" not in indexboolean.boolean(pyvista.Sphere(), bare).point_data
    assert "Normals" not in indexboolean.boolean(bare, pyvista.Sphere()).point_data


def test_pyvistaNormalsOfPolygonsTurnToo():
    cube = pyvista.Cube(clean=False)  # 24 points: each side has its own normals
    bar = pyvista.Cube(center=(0.25, 0.125, 0.5), x_length=0.5, y_length=0.25, clean=False)
    result = indexboolean.boolean(cube, bar, "difference")
    normals = np.asarray(result.point_data["Normals"])
    for face in result.irregular_faces:
        a, b, c = result.points[face[:3]]
        assert np.all(np.abs(np.linalg.norm(normals[face], axis=1) - 1) < 1e-6)
        assert np.all(normals[face] @ np.cross(b - a, c - a) > -1e-7)


def test_pyvistaNormalsOfCellsAreThoseOfTheNewFaces():
    ball, cube = polydata(BALL).compute_normals(), polydata(BOX).compute_normals()
    result = indexboolean.boolean(ball, cube, "difference")
    assert result.cell_data.active_normals_name == "Normals"
    assert np.allclose(result.cell_data["Normals"], result.face_normals, atol=1e-6)


def test_pyvistaActiveDataAndFieldDataAreKept():
    ball, cube = polydata(BALL), polydata(BOX)
    for mesh in (ball, cube):
        mesh.point_data["height"] = mesh.points[:, 2]
        mesh.point_data["uv"] = plain(mesh.points).astype(np.float32)
        mesh.point_data.active_texture_coordinates_name = "uv"
        mesh.cell_data["zone"] = np.arange(mesh.n_cells)
        mesh.set_active_scalars("zone")
        mesh.field_data["made"] = ["by hand"]
    result = indexboolean.boolean(ball, cube)
    assert result.point_data.active_texture_coordinates_name == "uv"
    assert result.cell_data.active_scalars_name == "zone"
    assert list(result.field_data["made"]) == ["by hand"]
    assert np.allclose(result.point_data["height"], result.points[:, 2], atol=1e-15)
    assert np.allclose(result.point_data["uv"], plain(result.points), atol=1e-7)


def test_pyvistaLinesAndVerticesAreLeftOutWithTheirData():
    points, faces = BOX
    mesh = pyvista.PolyData(
        points, verts=[1, 0], lines=[2, 0, 1, 2, 2, 3],
        faces=np.insert(faces, 0, 3, axis=1).ravel(),
    )
    mesh.cell_data["number"] = np.arange(mesh.n_cells)
    result = indexboolean.boolean(mesh, polydata(BALL), sources=True)
    of_first = result.cell_data["source_mesh"] == 0
    assert np.array_equal(
        result.cell_data["number"][of_first], result.cell_data["source_face"][of_first] + 3
    )
    assert result.n_lines == 0 and result.n_verts == 0


def test_pyvistaStripsAreRefusedWithARemedyThatHelps():
    strips = polydata(BALL).strip()
    with pytest.raises(indexboolean.MeshRefusal, match=r"strips, \d+ of them: mesh\.triangulate"):
        indexboolean.boolean(strips, polydata(BOX))
    result = indexboolean.boolean(strips.triangulate(), polydata(BOX))
    assert result.volume == pytest.approx(volume(*indexboolean.boolean(BALL, BOX)), rel=1e-6)


@pytest.mark.parametrize("make", [pyvista.Sphere, pyvista.Cube], ids=["normals", "seams"])
def test_pyvistasEmptyResultIsAnEmptyMesh(make):
    mesh = make()
    mesh.point_data["vector"] = np.asarray(mesh.points)
    mesh.cell_data["colour"] = np.zeros((mesh.n_cells, 3), dtype=np.uint8)
    mesh.cell_data["zone"] = np.arange(mesh.n_cells)
    mesh.set_active_vectors("vector")
    far = mesh.translate((9, 9, 9))
    both = indexboolean.boolean(mesh, far, ("intersection", "union"), sources=True)
    assert both["union"].n_cells > both["intersection"].n_cells == 0
    statements = indexboolean.evaluate("a & b; a - a", {"a": mesh, "b": far})
    for result in (both["intersection"], *statements.values()):
        assert isinstance(result, pyvista.PolyData) and result.n_points == result.n_cells == 0
        assert result.cell_data["zone"].dtype == mesh.cell_data["zone"].dtype
        result.copy().clean()


@pytest.mark.parametrize("kind", ["vertex_colors", "face_colors", "texture"])
def test_trimeshsEmptyResultIsAnEmptyMesh(kind):
    ball, cube = trimeshes()
    if kind == "texture":
        textured(ball, (255, 0, 0))
    else:
        setattr(ball.visual, kind, [10, 20, 30, 255])
    cube.apply_translation((9, 9, 9))
    result = indexboolean.boolean(ball, cube, "intersection").copy()
    assert isinstance(result, trimesh.Trimesh) and result.is_empty


@pytest.mark.parametrize("make, remedy", [
    (lambda: pyvista.Box().cast_to_unstructured_grid(),
     lambda grid: grid.extract_surface(algorithm="dataset_surface")),
    (lambda: trimesh.Scene(trimesh.Trimesh(*BOX)), lambda scene: scene.to_mesh()),
])
def test_whatIsNoMeshIsToldHowToBecomeOne(make, remedy):
    mesh = make()
    with pytest.raises(TypeError, match=r"extract_surface\(\)|to_mesh\(\)"):
        indexboolean.boolean(mesh, BALL)
    indexboolean.boolean(remedy(mesh), BALL)


def meshio_with(kind, name, values):
    mesh = meshio_of(BOX, **{kind: {}})
    getattr(mesh, kind)[name] = values  # as meshio's constructor checks them
    return mesh


def trimesh_with(kind, values):
    mesh = trimesh.Trimesh(*BOX, process=False)
    if kind == "uv":
        mesh.visual = trimesh.visual.TextureVisuals(uv=values)
    else:
        getattr(mesh, kind)["q"] = values
    return mesh


VERTEX_DATA = 'vertex data "q" have 9 values, not 8, one for each vertex'
FACE_DATA = 'face data "q" have 1 value, not 12, one for each face'


@pytest.mark.parametrize("make, sentence", [
    (lambda: trimesh_with("vertex_attributes", np.zeros(9)), VERTEX_DATA),
    (lambda: trimesh_with("face_attributes", np.zeros((1, 3))), FACE_DATA),
    (lambda: trimesh_with("face_attributes", 3), FACE_DATA),
    (lambda: trimesh_with("uv", np.zeros((7, 2))), 'vertex data "visual uv" have 7 values, not 8'),
    (lambda: meshio_with("point_data", "q", np.zeros(9)), VERTEX_DATA),
    (lambda: meshio_with("cell_data", "q", [np.zeros(9)]), '"q, 0" have 9 values, not 12, one'),
    (lambda: meshio_with("cell_data", "q", []), 'cell data "q" has 0 blocks, not 1'),
    (lambda: meshio_with("point_sets", "q", [2, 8]), '"q" names number 8, of which there are 8'),
    (lambda: meshio_with("point_sets", "q", [-1]), 'set "q" names number -1'),
    (lambda: meshio_with("cell_sets", "q", [[12]]), '"q" names number 12, of which there are 12'),
    (lambda: meshio_with("cell_sets", "q", []), 'cell set "q" has 0 blocks, not 1'),
])
def test_dataOfAnotherLengthAreRefused(make, sentence):
    with pytest.raises(indexboolean.MeshRefusal, match=sentence) as refusal:
        indexboolean.boolean(BALL, make())
    assert refusal.value.operand == 1 and 'Mesh "second" cannot be used: its ' in str(refusal.value)


def meshio_of(mesh, **more):
    points, faces = mesh
    return meshio.Mesh(points, [("triangle", faces)], **more)


def test_meshioBlocksWithoutAreaAreLeftOutWithTheirData():
    points, faces = BOX
    mesh = meshio.Mesh(
        points, [("vertex", [[0]]), ("triangle", faces[:5]), ("line", [[0, 1]]),
                 ("triangle", faces[5:])],
        cell_data={"number": [[-1], np.arange(5), [-2], np.arange(5, 12)]},
    )
    result = indexboolean.boolean(mesh, meshio_of(BALL), sources=True)
    assert [block.type for block in result.cells] == ["triangle"]
    of_faces = Meshio.data(result)[1]
    of_first = of_faces["source_mesh"] == 0
    assert np.array_equal(of_faces["number"][of_first], of_faces["source_face"][of_first])


def test_meshioSetsAndFieldDataAreKept():
    top = np.flatnonzero(np.all(BOX[0][BOX[1]][:, :, 2] == 2, axis=1))
    mesh = meshio_of(
        BOX, cell_sets={"top": [top]}, point_sets={"above": np.flatnonzero(BOX[0][:, 2] == 2)},
        field_data={"inlet": np.array([1, 2])},
    )
    result = indexboolean.boolean(mesh, meshio_of(BALL, field_data={"outlet": np.array([2, 2])}))
    (faces,), above = result.cell_sets["top"], result.point_sets["above"]
    corners = result.points[result.cells[0].data[faces]]
    assert len(faces) == 2 and np.all(corners[:, :, 2] == 2)
    assert np.array_equal(above, np.flatnonzero(result.points[:, 2] == 2))
    assert set(result.field_data) == {"inlet", "outlet"}


@pytest.mark.parametrize("kind", ["triangle", "quad"])
def test_meshiosEmptyResultCanBeWritten(kind, tmp_path):
    points, faces = BOX
    if kind == "quad":
        faces = np.array(
            [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
        )
    cube = meshio.Mesh(
        points, [(kind, faces)], point_data={"q": points}, cell_sets={"all": [np.arange(6)]},
        cell_data={"zone": [np.arange(len(faces))]},
    )
    result = indexboolean.boolean(cube, cube, "difference")
    assert [(block.type, block.data.shape) for block in result.cells] == [("triangle", (0, 3))]
    result.write(tmp_path / "empty.vtu")
    assert (tmp_path / "empty.vtu").stat().st_size > 0


@pytest.mark.parametrize("cells, sentence", [
    (("tetra", [[0, 1, 2, 4]]), "cells of type tetra, 1 of them. Take its boundary"),
    (("triangle6", [[0, 1, 2, 3, 4, 5]]), "type triangle6, 1 of them. Leave out the nodes"),
])
def test_meshioCellsThatAreNoFacesAreRefused(cells, sentence):
    with pytest.raises(indexboolean.MeshRefusal, match=sentence) as refusal:
        indexboolean.boolean(meshio_of(BALL), meshio.Mesh(BOX[0], [cells]))
    assert refusal.value.operand == 1


def test_theMeshioRemediesHelp():
    # The boundary of five tetrahedra in a cube; and faces of the second order without the nodes
    # on their edges.
    points = box((0, 0, 0), (1, 1, 1))[0]
    tetra = np.array([(0, 6, 5, 3), (0, 4, 5, 6), (0, 1, 3, 5), (0, 2, 6, 3), (7, 3, 6, 5)])
    sides = np.concatenate([tetra[:, [1, 2, 3]], tetra[:, [0, 3, 2]], tetra[:, [0, 1, 3]],
                            tetra[:, [0, 2, 1]]])
    _, first, counts = np.unique(np.sort(sides), axis=0, return_index=True, return_counts=True)
    boundary = meshio.Mesh(points, [("triangle", sides[first[counts == 1]])])
    one = volume(*Meshio.arrays(indexboolean.resolve(boundary)))
    assert one == pytest.approx(1, rel=1e-15)
    second_order = np.concatenate([BOX[1], BOX[1]], axis=1)
    linear = meshio.Mesh(BOX[0], [("triangle", second_order[:, :3])])
    assert volume(*Meshio.arrays(indexboolean.resolve(linear))) == pytest.approx(3, rel=1e-15)


def test_whatMeshioKeepsAmongTheSetsButIsNoneIsLeftOut():
    entities = {"gmsh:bounding_entities": [np.array([-3, 7, 99])]}
    result = indexboolean.boolean(meshio_of(BOX, cell_sets=entities), meshio_of(BALL))
    assert result.cell_sets == {}


def test_meshioFilesComeBackFromDisk(tmp_path):
    mesh = meshio_of(BOX, cell_data={"zone": [np.arange(12)]}, point_data={"q": BOX[0][:, 0]})
    mesh.write(tmp_path / "box.vtu")
    result = indexboolean.boolean(meshio.read(tmp_path / "box.vtu"), meshio_of(BALL), "difference")
    result.write(tmp_path / "out.vtu")
    again = meshio.read(tmp_path / "out.vtu")
    assert again.points.tobytes() == np.ascontiguousarray(result.points).tobytes()
    assert np.array_equal(again.cell_data["zone"][0], result.cell_data["zone"][0])
