# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Nothing on the meshes is lost: each attribute, through each block and the split filter."""

import numpy as np
import pymeshlab
import pytest

import indexboolean
import mesh_laws
from carried import FACE_READERS, VERTEX_READERS, Parents, carriers
from conftest import box, document, joined, sphere
from test_filter import log_of
from textured_pair import checks, stripes, textured_document

BLOCKS = ("union", "intersection", "first_minus_second", "second_minus_first")
PIECES = ("sub_surfaces_first", "sub_surfaces_second", "sub_blocks")
FIRST = sphere(subdivisions=2)
MEETS_ITSELF = joined(FIRST, sphere((0.6, 0.3, 0.2), 0.8, 1))
TOLERANCES = {"colour": 0.5001, "texture": 1e-6, "direction 1": 1e-6}  # bytes, floats
SECOND = box((0.1, 0.2, -0.3), (1.4, 1.5, 1.6))


class Run:
    """Both operands with every attribute, all blocks and all pieces of the split."""

    def __init__(self, second_has=True, first=FIRST):
        self.mesh_set = carriers(first, SECOND, second_has)
        result = self.mesh_set.generate_index_boolean(first_mesh=0, second_mesh=1)
        self.layers = {block: self.mesh_set.mesh(result[f"{block}_layer"]) for block in BLOCKS}
        result = self.mesh_set.generate_index_boolean_split(first_mesh=0, second_mesh=1)
        self.layers.update(
            {piece: self.mesh_set.mesh(result[f"{piece}_layer"]) for piece in PIECES}
        )
        self.operands = [self.mesh_set.mesh(0), self.mesh_set.mesh(1)]
        self.parents = {
            name: Parents(layer, self.operands) for name, layer in self.layers.items()
        }


@pytest.fixture(scope="module", params=[FIRST, MEETS_ITSELF], ids=["embedded", "meetsItself"])
def run(request):
    return Run(first=request.param)


def signs(name, parents, values, chosen):
    """The values as an operand has them: normals of turned faces are turned back."""
    if name != "normal":
        return values
    turned = []
    for face in chosen:
        corners = parents.operands[parents.mesh[face]].transformed_vertex_matrix()
        a, b, c = corners[parents.corners(face)]
        p, q, r = parents.points[parents.faces[face]]
        turned.append(np.cross(b - a, c - a) @ np.cross(q - p, r - p) < 0)
    return np.where(np.array(turned)[:, None], -values, values)


def mean_of(name, parents, face, vertex, given):
    """What a vertex has as a point of the face's parent."""
    weights = parents.weights(face, vertex)
    corners = given[parents.mesh[face]][parents.corners(face)]
    mean = weights @ corners
    if name == "direction 1":
        mean = np.where(corners @ corners[np.argmax(weights)] < 0, -1, 1) * weights @ corners
    if name in ("normal", "direction 1"):
        mean /= np.linalg.norm(mean)
    return np.all(corners[weights > 1e-9], axis=0) if name == "selection" else mean


@pytest.mark.parametrize("layer", (*BLOCKS, *PIECES))
@pytest.mark.parametrize("name", VERTEX_READERS)
def test_verticesCarryTheirValues(run, name, layer):
    read, _ = VERTEX_READERS[name]
    parents = run.parents[layer]
    chosen = parents.faces_at()
    values = signs(name, parents, read(parents.layer), chosen)
    given = [read(operand) for operand in run.operands]
    old = (parents.vertex >= 0) & (parents.vertex_mesh == parents.mesh[chosen])
    expected = np.array([given[m][v] for m, v in zip(parents.vertex_mesh, parents.vertex)])
    assert old.sum() > 3
    assert np.array_equal(values[old], expected[old])
    new = np.flatnonzero(~old)
    assert len(new) > 10
    for vertex in new:
        # Where sheets of one operand meet, the values are those of one of them, turned as it is.
        faces = parents.faces_like(vertex, chosen)
        means = [mean_of(name, parents, face, vertex, given) for face in faces]
        if name == "normal" and len(set(parents.face[faces])) > 1:
            means += [-mean for mean in means]
        tolerance = TOLERANCES.get(name, 1e-9)
        assert any(np.allclose(values[vertex], mean, rtol=0, atol=tolerance) for mean in means)


@pytest.mark.parametrize("layer", (*BLOCKS, *PIECES))
@pytest.mark.parametrize("name", FACE_READERS)
def test_facesCarryTheirValues(run, name, layer):
    read, _ = FACE_READERS[name]
    parents = run.parents[layer]
    given = [read(operand) for operand in run.operands]
    expected = np.array([given[m][f] for m, f in zip(parents.mesh, parents.face)])
    assert np.array_equal(read(parents.layer), expected)


@pytest.mark.parametrize("layer", (*BLOCKS, *PIECES))
def test_wedgesCarryTheirTextureCoordinates(run, layer):
    parents = run.parents[layer]
    given = [operand.wedge_tex_coord_matrix().reshape(-1, 3, 2) for operand in run.operands]
    points = [operand.vertex_matrix() for operand in run.operands]
    got = parents.layer.wedge_tex_coord_matrix().reshape(-1, 3, 2)
    exact = 0
    for face in range(len(parents.faces)):
        wedges = given[parents.mesh[face]][parents.face[face]]
        corners = points[parents.mesh[face]][parents.corners(face)]
        for corner, vertex in enumerate(parents.faces[face]):
            same = np.flatnonzero(np.all(corners == parents.points[vertex], axis=1))
            if len(same):
                exact += 1
                assert np.array_equal(got[face, corner], wedges[same[0]])
            else:
                expected = parents.weights(face, vertex) @ wedges
                assert np.allclose(got[face, corner], expected, rtol=0, atol=1e-6)  # floats
    assert 10 < exact < 3 * len(parents.faces)


@pytest.mark.parametrize("layer", (*BLOCKS, *PIECES))
def test_sourcesAreTrue(run, layer):
    parents = run.parents[layer]
    points = [operand.vertex_matrix() for operand in run.operands]
    for mesh, vertex, point in zip(parents.vertex_mesh, parents.vertex, parents.points):
        assert (mesh < 0) == (vertex < 0)
        if vertex >= 0:
            assert np.array_equal(points[mesh][vertex], point)
        else:
            assert not any(np.any(np.all(p == point, axis=1)) for p in points)
    for face in range(len(parents.faces)):
        for vertex in parents.faces[face]:
            weights = parents.weights(face, vertex)
            assert np.all(weights > -1e-9)
            corners = points[parents.mesh[face]][parents.corners(face)]
            assert np.allclose(weights @ corners, parents.points[vertex], atol=1e-12)


@pytest.fixture(scope="module")
def lacking():
    return Run(second_has=False)


class TestOneOperandCarriesNothing:
    @pytest.mark.parametrize("block", BLOCKS)
    def test_itsElementsHaveMeshLabsDefaults(self, lacking, block):
        parents = lacking.parents[block]
        chosen = parents.faces_at()
        of_second = parents.mesh[chosen] == 1
        assert np.any(of_second) and not np.all(of_second)
        for name, (read, default) in VERTEX_READERS.items():
            if default is not None:
                assert np.all(read(parents.layer)[of_second] == default), name
        for name, (read, default) in FACE_READERS.items():
            assert np.all(read(parents.layer)[parents.mesh == 1] == default), name
        wedges = parents.layer.wedge_tex_coord_matrix().reshape(-1, 3, 2)
        assert np.all(wedges[parents.mesh == 1] == 0.5)

    def test_theLogSaysWhatIsMissing(self):
        log = log_of('__import__("carried").carriers(FIRST, SECOND, second_has=False)')
        assert 'Layer "B" (id 1) has no vertex curvature directions, face colours' in log
        assert 'face attribute "part"' in log and 'vertex attribute "flow"' in log
        assert 'Layer "A" (id 0) has no' not in log


def test_radiiAreCarried(tmp_path):
    """Through files, since a script has no other way to a layer's radii."""
    indexboolean.load_plugin()
    mesh_set = pymeshlab.MeshSet()
    for name, (vertices, faces) in (("a", FIRST), ("b", SECOND)):
        radii = 1 + np.arange(len(vertices))
        write_ply_with_radii(tmp_path / f"{name}.ply", vertices, faces, radii)
        mesh_set.load_new_mesh(str(tmp_path / f"{name}.ply"))
    result = mesh_set.generate_index_boolean(first_mesh=0, second_mesh=1)
    union = mesh_set.mesh(result["union_layer"])
    parents = Parents(union, [mesh_set.mesh(0), mesh_set.mesh(1)])
    mesh_set.set_current_mesh(result["union_layer"])
    mesh_set.save_current_mesh(
        str(tmp_path / "union.ply"), binary=False, save_vertex_radius=True
    )
    lines = (tmp_path / "union.ply").read_text().split("end_header\n")[1].splitlines()
    radii = np.array([float(line.split()[-1]) for line in lines[: union.vertex_number()]])
    chosen = parents.faces_at()
    for vertex, radius in enumerate(radii):
        of_chosen = parents.vertex_mesh[vertex] == parents.mesh[chosen[vertex]]
        if parents.vertex[vertex] >= 0 and of_chosen:
            assert radius == 1 + parents.vertex[vertex]
        else:
            given = 1 + parents.corners(chosen[vertex])
            assert abs(radius - parents.weights(chosen[vertex], vertex) @ given) < 1e-4


def write_ply_with_radii(path, vertices, faces, radii):
    head = ["ply", "format ascii 1.0", f"element vertex {len(vertices)}"]
    head += [f"property double {axis}" for axis in "xyz"] + ["property float radius"]
    head += [f"element face {len(faces)}", "property list uchar int vertex_indices", "end_header"]
    rows = [" ".join(repr(float(c)) for c in (*point, r)) for point, r in zip(vertices, radii)]
    rows += [f"3 {a} {b} {c}" for a, b, c in faces]
    path.write_text("\n".join(head + rows) + "\n")


def test_withoutTransferNothingIsCarried():
    mesh_set = carriers(FIRST, SECOND)
    result = mesh_set.generate_index_boolean(
        first_mesh=0, second_mesh=1, transfer_attributes=False
    )
    layer = mesh_set.mesh(result["union_layer"])
    assert not layer.has_vertex_color() and not layer.has_face_color()
    assert not layer.has_wedge_tex_coord() and not layer.has_vertex_scalar()
    assert layer.selected_face_number() == layer.selected_vertex_number() == 0
    with pytest.raises(Exception, match="source_face"):
        layer.face_custom_scalar_attribute_array("source_face")


def test_operandsAreNotTouched():
    mesh_set = carriers(FIRST, SECOND)
    readers = [read for read, _ in (*VERTEX_READERS.values(), *FACE_READERS.values())]
    readers += [lambda m: m.vertex_matrix(), lambda m: m.face_matrix()]
    before = [[read(mesh_set.mesh(k)) for read in readers] for k in (0, 1)]
    mesh_set.generate_index_boolean(first_mesh=0, second_mesh=1)
    for k in (0, 1):
        for old, read in zip(before[k], readers):
            assert np.array_equal(old, read(mesh_set.mesh(k)))


class TestCurveVertices:
    def test_canBeSelected(self):
        mesh_set = carriers(FIRST, SECOND)
        result = mesh_set.generate_index_boolean(
            first_mesh=0, second_mesh=1, select_curve_vertices=True
        )
        for block in BLOCKS:
            layer = mesh_set.mesh(result[f"{block}_layer"])
            new = layer.vertex_custom_scalar_attribute_array("source_vertex") < 0
            assert np.array_equal(layer.vertex_selection_array(), new) and np.any(new)

    def test_canBeDuplicated(self):
        mesh_set = carriers(FIRST, SECOND)
        result = mesh_set.generate_index_boolean(
            first_mesh=0, second_mesh=1, duplicate_curve_vertices=True
        )
        for block in BLOCKS:
            operands = [mesh_set.mesh(0), mesh_set.mesh(1)]
            parents = Parents(mesh_set.mesh(result[f"{block}_layer"]), operands)
            sides = [set(parents.faces[parents.mesh == k].ravel()) for k in (0, 1)]
            assert not sides[0] & sides[1]
            assert mesh_laws.unmatched_edges(parents.points, parents.faces) == 0
            read, _ = VERTEX_READERS["quality"]
            values = read(parents.layer)
            for face in np.flatnonzero(parents.mesh == 1):
                given = read(mesh_set.mesh(1))[parents.corners(face)]
                for vertex in parents.faces[face]:
                    expected = parents.weights(face, vertex) @ given
                    assert np.allclose(values[vertex], expected, atol=1e-9)


class TestSeams:
    """A cube with four vertices of its own for each side, minus a sphere."""

    @staticmethod
    def cube():
        """(vertices, faces, normals, texture coordinates): each side has the whole picture."""
        vertices, faces = box((-1, -1, -1), (1, 1, 1))
        corners = vertices[faces]
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        normals /= np.linalg.norm(normals, axis=1)[:, None]
        keyed = np.concatenate(
            [corners.reshape(-1, 3), np.repeat(normals, 3, axis=0)], axis=1
        )
        unique, index = np.unique(keyed, axis=0, return_inverse=True)
        assert len(unique) == 24
        points, normals = unique[:, :3], unique[:, 3:]
        side = np.abs(normals).argmax(axis=1)
        first, second = (side + 1) % 3, (side + 2) % 3
        rows = np.arange(len(points))
        places = np.stack([points[rows, first], points[rows, second]], axis=1)
        return points, index.reshape(-1, 3), normals, places * 0.25 + side[:, None]

    def difference(self, with_texture):
        indexboolean.load_plugin()
        mesh_set = self.document = pymeshlab.MeshSet()  # a layer lives as long as its document
        vertices, faces, normals, places = self.cube()
        texture = {"v_tex_coords_matrix": places} if with_texture else {}
        cube = pymeshlab.Mesh(vertices, faces, v_normals_matrix=normals, **texture)
        mesh_set.add_mesh(cube, "cube")
        mesh_set.add_mesh(pymeshlab.Mesh(*sphere((0.9, 0.95, 0.1), 0.7, 3)), "ball")
        result = mesh_set.generate_index_boolean(first_mesh=0, second_mesh=1)
        assert result["first_minus_second_closed"]
        difference = mesh_set.mesh(result["first_minus_second_layer"])
        points, faces = difference.vertex_matrix(), difference.face_matrix()
        assert mesh_laws.unmatched_edges(points, faces) == 0
        return difference, result["first_minus_second_open_edges"]

    def test_ofTexturesStaySplitAlsoAtNewVertices(self):
        difference, open_edges = self.difference(with_texture=True)
        assert open_edges > 0
        points, faces = difference.vertex_matrix(), difference.face_matrix()
        of_cube = difference.face_custom_scalar_attribute_array("source_mesh") == 0
        new = difference.vertex_custom_scalar_attribute_array("source_vertex") < 0
        normals = np.round(difference.face_normal_matrix())
        places = difference.vertex_tex_coord_matrix()
        split = {}
        for face in np.flatnonzero(of_cube):
            side = np.abs(normals[face]).argmax()
            for vertex in faces[face]:
                expected = points[vertex][[(side + 1) % 3, (side + 2) % 3]] * 0.25 + side
                assert np.allclose(places[vertex], expected, atol=1e-12), vertex
                split.setdefault(tuple(points[vertex]), set()).add(vertex)
        sides = [sum(abs(c) == 1 for c in place) for place in split]
        assert [len(s) for s in split.values()] == sides
        assert any(len(s) == 2 and new[min(s)] for s in split.values())

    def test_areNotMadeByNormalsAlone(self):
        difference, open_edges = self.difference(with_texture=False)
        assert open_edges == 0
        points = difference.vertex_matrix()
        assert len(np.unique(points, axis=0)) == len(points)


def test_aSoupIsSewn():
    vertices, faces = box((0, 0, 0), (2, 2, 2))
    soup = vertices[faces.ravel()], np.arange(3 * len(faces)).reshape(-1, 3)
    mesh_set = document(soup, box((1, 1, 1), (3, 3, 3)))
    result = mesh_set.generate_index_boolean()
    layer = mesh_set.mesh(result["union_layer"])
    points = layer.vertex_matrix()
    assert len(np.unique(points, axis=0)) == len(points)


class TestMergeCoplanar:
    """Boxes with one wall in common: union, with coplanar faces merged where attributes agree."""

    def union(self, colours):
        indexboolean.load_plugin()
        mesh_set = pymeshlab.MeshSet()
        for solid, colour in zip((box((0, 0, 0), (1, 1, 1)), box((1, 0, 0), (2, 1, 1))), colours):
            table = np.tile(np.array(colour, float), (12, 1))
            mesh_set.add_mesh(pymeshlab.Mesh(*solid, f_color_matrix=table))
        result = mesh_set.generate_index_boolean(merge_coplanar=True)
        union = mesh_set.mesh(result["union_layer"])
        return union.vertex_matrix()[union.face_matrix()], union.face_color_matrix()

    def test_facesOfOneColourBecomeOne(self):
        corners, _ = self.union([(1, 0, 0, 1), (1, 0, 0, 1)])
        assert len(corners) == 12

    def test_facesOfOtherColoursStayApart(self):
        corners, colours = self.union([(1, 0, 0, 1), (0, 1, 0, 1)])
        assert len(corners) == 20
        assert np.array_equal(colours[:, 0] == 1, corners[:, :, 0].max(axis=1) <= 1)


class TestTextures:
    BLOCKS = ("union", "first_minus_second")

    def wedges(self, layer):
        """Each face's corners and texture coordinates, in an order of their own."""
        corners = layer.vertex_matrix()[layer.face_matrix()].reshape(-1, 9)
        table = np.hstack([corners, layer.wedge_tex_coord_matrix().reshape(-1, 6)])
        return table[np.lexsort(table.T)]

    @pytest.mark.parametrize("block", BLOCKS)
    def test_blocksSavedAndReadAgainAreTheSame(self, tmp_path, block):
        mesh_set = textured_document(tmp_path / "given")
        result = mesh_set.generate_index_boolean(first_mesh=0, second_mesh=1)
        layer = mesh_set.mesh(result[f"{block}_layer"])
        assert list(layer.textures()) == ["checks.png", "stripes.png"]
        number = layer.face_custom_scalar_attribute_array("source_mesh").astype(int)
        assert 0 < number.sum() < len(number)
        mesh_set.set_current_mesh(result[f"{block}_layer"])
        for suffix, tolerance in (("ply", 0), ("obj", 1e-5)):
            (tmp_path / suffix).mkdir()
            mesh_set.set_current_mesh(result[f"{block}_layer"])
            path = tmp_path / suffix / f"result.{suffix}"
            mesh_set.save_current_mesh(str(path))
            again = pymeshlab.MeshSet()
            again.load_new_mesh(str(path))
            read = again.current_mesh()
            assert sorted(read.textures()) == ["checks.png", "stripes.png"]
            assert np.allclose(self.wedges(read), self.wedges(layer), rtol=0, atol=tolerance)
            assert np.array_equal(texture_numbers(path), number)

    def test_uncutFacesShowTheSamePicture(self, tmp_path):
        mesh_set = textured_document(tmp_path)
        result = mesh_set.generate_index_boolean(first_mesh=0, second_mesh=1)
        given = [
            mesh_set.mesh(k).wedge_tex_coord_matrix().astype(np.float32).reshape(-1, 6)
            for k in (0, 1)
        ]
        layer = mesh_set.mesh(result["union_layer"])
        parents = Parents(layer, [mesh_set.mesh(0), mesh_set.mesh(1)])
        got = layer.wedge_tex_coord_matrix().reshape(-1, 6)
        uncut = np.all(parents.vertex[parents.faces] >= 0, axis=1)
        expected = np.array([given[m][f] for m, f in zip(parents.mesh, parents.face)])
        assert uncut.sum() > 1000
        assert np.array_equal(got[uncut], expected[uncut])

    def test_aCommonTextureIsThereOnce(self, tmp_path):
        mesh_set = textured_document(tmp_path, ("same.png", "same.png"), (checks, checks))
        result = mesh_set.generate_index_boolean(first_mesh=0, second_mesh=1)
        assert list(mesh_set.mesh(result["union_layer"]).textures()) == ["same.png"]

    def test_otherPicturesOfOneNameGetAnother(self, tmp_path):
        mesh_set = textured_document(tmp_path, ("skin.png", "skin.png"), (checks, stripes))
        result = mesh_set.generate_index_boolean(first_mesh=0, second_mesh=1)
        union = mesh_set.mesh(result["union_layer"])
        assert list(union.textures()) == ["skin.png", "skin_2.png"]


def texture_numbers(path):
    """Per face, the number of its texture in the file."""
    if path.suffix == ".obj":
        pictures, numbers, material = {}, [], None
        for line in path.with_name(path.name + ".mtl").read_text().splitlines():
            words = line.split()
            if words[:1] == ["newmtl"]:
                material = words[1]
            elif words[:1] == ["map_Kd"]:
                pictures[material] = ["checks.png", "stripes.png"].index(words[1])
        for line in path.read_text().splitlines():
            words = line.split()
            if words[:1] == ["usemtl"]:
                material = words[1]
            elif words[:1] == ["f"]:
                numbers.append(pictures[material])
        return np.array(numbers)
    data = path.read_bytes()
    start = data.index(b"end_header\n") + len(b"end_header\n")
    head = data[:start].decode().split("element face ")
    sizes = {"double": 8, "float": 4, "uchar": 1}
    row = sum(sizes[line.split()[1]] for line in head[0].splitlines() if line[:8] == "property")
    faces = int(head[1].split()[0])
    vertices = int(head[0].split("element vertex ")[1].split()[0])
    face = np.dtype([("n", "u1"), ("v", "<i4", 3), ("m", "u1"), ("uv", "<f4", 6), ("tex", "<i4")])
    return np.frombuffer(data, face, faces, start + vertices * row)["tex"]


class TestLayerMatrices:
    ROTATED = np.array(
        [[0.6, -0.8, 0, 0.125], [0.8, 0.6, 0, 0.25], [0, 0, 1, -0.5], [0, 0, 0, 1]]
    )
    MIRRORED = np.array([[-1, 0, 0, 0.25], [0, 1, 0, 0], [0, 0, 1, 0.125], [0, 0, 0, 1]], float)

    @pytest.mark.parametrize("matrix", (ROTATED, MIRRORED), ids=("rotated", "mirrored"))
    def test_giveTheSameAsFrozenOnes(self, matrix):
        def blocks(frozen):
            mesh_set = carriers(FIRST, SECOND)
            mesh_set.set_current_mesh(1)
            mesh_set.set_matrix(transformmatrix=matrix, freeze=frozen)
            result = mesh_set.generate_index_boolean(first_mesh=0, second_mesh=1)
            return mesh_set, [mesh_set.mesh(result[f"{block}_layer"]) for block in BLOCKS]

        (_moved_set, moved_blocks), (_frozen_set, frozen_blocks) = blocks(False), blocks(True)
        for moved, frozen in zip(moved_blocks, frozen_blocks):
            assert np.array_equal(moved.vertex_matrix(), frozen.vertex_matrix())
            assert np.array_equal(moved.face_matrix(), frozen.face_matrix())
            for name, (read, _) in VERTEX_READERS.items():
                if name not in ("normal", "direction 1"):  # freezing computes normals anew
                    assert np.array_equal(read(moved), read(frozen)), name
            for name, (read, _) in FACE_READERS.items():
                assert np.array_equal(read(moved), read(frozen)), name
            wedges = moved.wedge_tex_coord_matrix(), frozen.wedge_tex_coord_matrix()
            assert np.array_equal(*wedges)

    @pytest.mark.parametrize("matrix", (ROTATED, MIRRORED), ids=("rotated", "mirrored"))
    def test_turnNormalsWithTheirFaces(self, matrix):
        indexboolean.load_plugin()
        mesh_set = document(FIRST, sphere((0.5, 0, 0), 1, 3))
        mesh_set.set_current_mesh(1)
        mesh_set.set_matrix(transformmatrix=matrix, freeze=False)
        result = mesh_set.generate_index_boolean()
        for block in BLOCKS:
            layer = mesh_set.mesh(result[f"{block}_layer"])
            old = layer.vertex_custom_scalar_attribute_array("source_vertex") >= 0
            faces, normals = layer.face_matrix(), layer.vertex_normal_matrix()
            for face, normal in zip(faces, layer.face_normal_matrix()):
                for vertex in face[old[face]]:
                    cosine = normals[vertex] @ normal / np.linalg.norm(normals[vertex])
                    assert cosine > 0.7


def test_newLayersCanBeDeleted():
    mesh_set = carriers(FIRST, SECOND)
    result = mesh_set.generate_index_boolean(first_mesh=0, second_mesh=1)
    for block in BLOCKS:
        mesh_set.set_current_mesh(result[f"{block}_layer"])
        mesh_set.delete_current_mesh()
    assert mesh_set.mesh_number() == 2
    mesh_set.generate_index_boolean(first_mesh=0, second_mesh=1)
