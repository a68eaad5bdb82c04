# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Expressions over layers: truth tables that Python itself evaluates, in every cube of a grid; what
layers are called and listed as; every parameter, every key, every refusal."""

import random
import re

import numpy as np
import pymeshlab
import pytest

import judges
import mesh_laws
from conftest import box, crossing_bars, document, joined, sphere
from test_attributes import texture_numbers
from textured_pair import write_picture

KEYS = (
    "layer", "volume", "area", "faces", "components", "closed", "self_intersections",
    "repair_rounds", "moved_vertices", "largest_move", "volume_change", "vanished_components",
)
# Three boxes of volume 8 in a row, each of which has a box of volume 4 in common with the next.
ROW = [box((k, 0, 0), (k + 2, 2, 2)) for k in range(3)]


def evaluate(mesh_set, expression, **parameters):
    return mesh_set.generate_index_boolean_expression(expression=expression, **parameters)


def volumes(result):
    return [result[f"result_{k}_volume"] for k in range(result["results"])]


def arrays(mesh_set, layer):
    mesh = mesh_set.mesh(int(layer))
    return np.array(mesh.vertex_matrix()), np.array(mesh.face_matrix(), dtype=np.int64)


def labels(mesh_set):
    return [mesh.label() for mesh in mesh_set]


def labelled(*pairs):
    """A document with a layer for each (label, mesh)."""
    mesh_set = pymeshlab.MeshSet()
    for label, mesh in pairs:
        mesh_set.add_mesh(pymeshlab.Mesh(*mesh))
        mesh_set.current_mesh().set_label(label)  # another layer may have the same
    return mesh_set


class Places(frozenset):
    """A set of places, with the operators of expressions: Python's own precedence evaluates."""

    everything = frozenset()

    def __new__(cls, places=()):
        return super().__new__(cls, places)

    __or__ = __add__ = lambda a, b: Places(frozenset.__or__(a, b))
    __and__ = __mul__ = lambda a, b: Places(frozenset.__and__(a, b))
    __sub__ = lambda a, b: Places(frozenset.__sub__(a, b))  # noqa: E731
    __xor__ = lambda a, b: Places(frozenset.__xor__(a, b))  # noqa: E731
    __invoke__ = None

    def __invert__(self):
        return Places(Places.everything - frozenset(self))


def union(first, *others):
    for other in others:
        first = first | other
    return first


def intersection(first, *others):
    for other in others:
        first = first & other
    return first


def difference(first, *others):
    for other in others:
        first = first - other
    return first


def xor(first, *others):
    for other in others:
        first = first ^ other
    return first


def at_least(count, *items):
    return Places(p for p in Places.everything if sum(p in item for item in items) >= count)


class Grid:
    """Layers of unit cubes in a grid, each of a few boxes that may overlap, so that winding numbers
    are counts of boxes; some layers are inside out as a whole."""

    SIZE = 5
    OUTSIDE = "outside"

    def __init__(self, count, rng):
        self.windings, meshes = [], []
        for _ in range(count):
            grid = np.zeros((self.SIZE,) * 3, dtype=int)
            parts = []
            for _ in range(rng.randint(1, 3)):
                low = [rng.randint(0, self.SIZE - 1) for _ in range(3)]
                high = [rng.randint(a + 1, self.SIZE) for a in low]
                grid[tuple(slice(a, b) for a, b in zip(low, high))] += 1
                parts.append(box(low, high))
            vertices, faces = joined(*parts) if len(parts) > 1 else parts[0]
            meshes.append((vertices, faces[:, ::-1] if rng.random() < 0.25 else faces))
            self.windings.append(grid)
        Places.everything = frozenset([self.OUTSIDE, *np.ndindex(*grid.shape)])
        self.document = labelled(*((f"l{k}", mesh) for k, mesh in enumerate(meshes)))

    def where(self, layer, test):
        places = map(tuple, np.argwhere(test(self.windings[layer])).tolist())
        return Places([*places, *([self.OUTSIDE] if test(np.int64(0)) else [])])

    def evaluated(self, text):
        """What Python makes of the text, with names for layers."""
        names = {f"l{k}": self.where(k, lambda w: w != 0) for k in range(len(self.windings))}
        tests = {
            "odd": lambda k: self.where(k, lambda w: w % 2 != 0),
            "positive": lambda k: self.where(k, lambda w: w > 0),
            "nonzero": lambda k: self.where(k, lambda w: w != 0),
            "winding": lambda k, least: self.where(k, lambda w: w >= least),
        }
        functions = {f.__name__: f for f in (union, intersection, difference, xor, at_least)}
        return eval(text, {"__builtins__": {}}, {**names, **tests, **functions})

    @classmethod
    def occupied(cls, vertices, faces):
        """The cubes that a surface winds around once; fails if it winds otherwise around any."""
        windings = np.zeros((cls.SIZE,) * 3, dtype=int)
        corners = vertices[faces]
        offsets = np.arange(cls.SIZE)
        y, z = np.meshgrid(offsets + 0.3712, offsets + 0.5391, indexing="ij")
        for a, b, c in corners:
            # Faces at right angles to x, seen along x from a point off all their edges.
            turns = [
                (q[1] - p[1]) * (z - p[2]) - (q[2] - p[2]) * (y - p[1])
                for p, q in ((a, b), (b, c), (c, a))
            ]
            turns = np.stack(turns)
            sign = np.where((turns > 0).all(0), 1, np.where((turns < 0).all(0), -1, 0))
            behind = (offsets + 0.5 < a[0])[:, None, None]
            windings += behind * sign[None]
        assert set(np.unique(windings)) <= {0, 1}
        return Places(map(tuple, np.argwhere(windings == 1).tolist()))


class Texts:
    """Random expressions, as Python reads them: layers have names, l0, l1, ..."""

    def __init__(self, count, rng):
        self.count, self.rng = count, rng

    def make(self, depth):
        rng = self.rng
        if depth == 0 or rng.random() < 0.2:
            layer = rng.randrange(self.count)
            test = rng.choice(["", "", "", "odd", "positive", "nonzero", "winding"])
            least = f", {rng.randint(1, 3)}" if test == "winding" else ""
            return f"{test}({layer}{least})" if test else f"l{layer}"
        kind = rng.random()
        if kind < 0.3:
            name = rng.choice(["union", "intersection", "difference", "xor", "at_least"])
            items = [self.make(depth - 1) for _ in range(rng.randint(1, 4))]
            return f"{name}({', '.join([str(rng.randint(1, 3))] * (name == 'at_least') + items)})"
        if kind < 0.4:
            return f"~{self.make(0)}" if rng.random() < 0.5 else f"~({self.make(depth - 1)})"
        operators = rng.choices("|^&+-*", k=rng.randint(1, 3))
        text = self.make(depth - 1)
        for operator in operators:
            text += f" {operator} {self.make(depth - 1)}"
        return f"({text})" if rng.random() < 0.4 else text


def for_filter(text, rng):
    """Layers by their ids or labels in place of names."""
    def named(match):
        return match[1] if rng.random() < 0.5 else f'"l{match[1]}"'

    return re.sub(r"\bl(\d+)\b", named, text)


@pytest.mark.parametrize("seed", range(42))
def test_randomExpressionsAreWhatPythonMakesOfThem(seed):
    """42 documents of up to 12 layers, 50 expressions each."""
    rng = random.Random(seed)
    grid = Grid(rng.randint(1, 12), rng)
    texts = Texts(len(grid.windings), rng)
    wanted, statements = [], []
    while len(wanted) < 50:
        text = texts.make(rng.randint(1, 4))
        places = grid.evaluated(text)
        if Grid.OUTSIDE in places:
            with pytest.raises(pymeshlab.PyMeshLabException, match="true of the outside"):
                evaluate(grid.document, for_filter(text, rng))
            text = f"({text}) & union({', '.join(f'l{k}' for k in range(len(grid.windings)))})"
            places = grid.evaluated(text)
        wanted.append(places)
        statements.append(for_filter(text, rng))
    result = evaluate(grid.document, "; ".join(statements))
    assert result["results"] == 50
    assert result["volume_law_residual"] < 1e-12
    for k, places in enumerate(wanted):
        assert result[f"result_{k}_volume"] == pytest.approx(len(places), abs=1e-9), statements[k]
        assert result[f"result_{k}_closed"] and result[f"result_{k}_self_intersections"] == 0
        found = Grid.occupied(*arrays(grid.document, result[f"result_{k}_layer"]))
        assert found == places, statements[k]


class TestTexts:
    def test_theDefaultIsTheUnionOfAllVisibleLayers(self):
        mesh_set = document(*ROW)
        result = mesh_set.generate_index_boolean_expression()
        assert volumes(result) == pytest.approx([16])
        assert labels(mesh_set)[3:] == ["union(visible)"]
        assert mesh_set.current_mesh_id() == 3

    def test_aSecondRunTakesNoResultsAndGivesTheSameBytes(self):
        mesh_set = document(*(sphere((0.3 * k, 0.1 * k, 0), 1, 3) for k in range(4)))
        first = evaluate(mesh_set, "union(visible)")
        second = evaluate(mesh_set, "union(visible)")
        one, other = (arrays(mesh_set, r["result_0_layer"]) for r in (first, second))
        assert all(a.tobytes() == b.tobytes() for a, b in zip(one, other))
        assert second["operands"] == 4 and list(second["operand_layers"]) == [0, 1, 2, 3]
        named = evaluate(mesh_set, f"0 - {int(first['result_0_layer'])}")
        assert named["operands"] == 2  # by its id a result is an operand like any other
        assert named["result_0_volume"] < 1e-12

    def test_severalStatementsAreOneArrangement(self):
        mesh_set = document(*ROW)
        result = evaluate(mesh_set, "walls = 0 - 1; rest = at_least(2, all) - walls; 2 ^ walls;")
        assert volumes(result) == pytest.approx([4, 8, 12])
        assert labels(mesh_set)[3:] == ["walls", "rest", "2 ^ walls"]
        assert result["cells"] == 4
        assert list(result["operand_layers"]) == [0, 1, 2]

    def test_operandsAreNumberedByFirstAppearance(self):
        mesh_set = document(*ROW)
        result = evaluate(mesh_set, "2 - 0")
        assert list(result["operand_layers"]) == [2, 0]
        mesh = mesh_set.mesh(int(result["result_0_layer"]))
        source = mesh.face_custom_scalar_attribute_array("source_mesh")
        centres = np.array(mesh.vertex_matrix())[mesh.face_matrix()].mean(1)
        assert set(source[centres[:, 0] > 3]) == {0}

    @pytest.mark.parametrize(
        ("label", "text"),
        [
            ("left wall", '"left wall"'), ("Tür Größe", '"Tür Größe"'), ('say "a"', r'"say \"a\""'),
            ("back\\slash", r'"back\\slash"'), ("a;b,c)|", '"a;b,c)|"'), ("12", '"12"'),
            ("", '""'), ("visible", '"visible"'), ("部品.ply", '"部品.ply"'),
        ],
    )
    def test_labels(self, label, text):
        mesh_set = labelled(("first", ROW[0]), (label, ROW[1]))
        assert volumes(evaluate(mesh_set, f'"first" - {text}')) == pytest.approx([4])
        assert volumes(evaluate(mesh_set, f"difference(1, {text} - 0)")) == pytest.approx([4])

    def test_longTextsAreShortenedInLabelsAndDotsAreNone(self):
        mesh_set = labelled(("a.ply", ROW[0]), ("b.ply", ROW[1]))
        evaluate(mesh_set, '"a.ply" - "b.ply"')
        evaluate(mesh_set, " | ".join(["0 - 1"] * 20))
        assert labels(mesh_set)[2] == '"a_ply" - "b_ply"'
        assert len(labels(mesh_set)[3]) == 60 and labels(mesh_set)[3].endswith("…")


class TestLists:
    def test_visibleAndAll(self):
        mesh_set = document(*ROW)
        mesh_set.set_current_mesh(1)
        mesh_set.set_current_mesh_visibility(False)
        assert volumes(evaluate(mesh_set, "union(visible); union(all)")) == pytest.approx([16, 16])
        result = evaluate(mesh_set, "intersection(visible)")
        assert list(result["operand_layers"]) == [0, 2]

    def test_layersWithoutFacesAreLeftOut(self):
        mesh_set = document(*ROW[:2])
        mesh_set.add_mesh(pymeshlab.Mesh(np.zeros((1, 3))), "points")
        assert evaluate(mesh_set, "union(all)")["operands"] == 2
        with pytest.raises(pymeshlab.PyMeshLabException, match=r'"points" \(id 2\) has no face'):
            evaluate(mesh_set, "0 - 2")

    def test_aListLeavesOutTheLayerBeforeIt(self):
        assert volumes(evaluate(document(*ROW), "difference(2, all)")) == pytest.approx([4])

    def test_hideOperands(self):
        mesh_set = document(*ROW)
        evaluate(mesh_set, "0 | 1")
        assert [mesh.is_visible() for mesh in mesh_set] == [True] * 4
        evaluate(mesh_set, "0 | 1", hide_operands=True)
        assert [mesh.is_visible() for mesh in mesh_set] == [False, False, True, True, True]


class TestRefusals:
    """One sentence with line and column, the text, and a caret under the place."""

    @pytest.mark.parametrize(
        ("text", "column", "sentence"),
        [
            ("", 1, "the text ends"), ("0 |", 4, "the text ends"), ("0 1", 3, "an operator"),
            ("0 | 7", 5, "there is no layer with id 7"),
            ("0 | 99999999999999999999", 5, "there is no layer with id 99999999999999999999"),
            ('0 | "Ü" | "nö"', 11, 'there is no layer with the label "nö"'),
            ('"Ü', 1, "the double quote at the end"), ("a - 0", 1, 'defines the name "a"'),
            ("a = 0; a = 1", 8, "defined twice"), ("xor = 1", 1, "a word of the grammar"),
            ("union(0", 8, "the text ends"), ("-0", 1, 'there is no "-"'),
            ("~0", 1, "true of the outside"), ("0 | all", 5, "is a list"),
            ('"same"', 1, "its id, 3 or 4"), ("winding(0, 0)", 1, "true of the outside"),
            ("0 € 1", 3, "means nothing"),
        ],
    )
    def test_aCaretIsUnderThePlace(self, text, column, sentence):
        mesh_set = labelled(
            ("A", ROW[0]), ("B", ROW[1]), ("Ü", ROW[2]), ("same", ROW[0]), ("same", ROW[1])
        )
        mesh_set.set_current_mesh(4)
        with pytest.raises(pymeshlab.PyMeshLabException) as refused:
            evaluate(mesh_set, text)
        *_, place, shown, caret = str(refused.value).rstrip("\n").split("\n")
        assert place.endswith(".") and f"line 1, column {column}: " in place
        assert sentence in place
        assert shown == text and caret == " " * (column - 1) + "^"
        assert mesh_set.mesh_number() == 5

    def test_theLineOfThePlaceIsShown(self):
        with pytest.raises(pymeshlab.PyMeshLabException, match="line 2, column 11: ") as refused:
            evaluate(document(*ROW), "a = 0;\n  b = a - c;\nd = 1")
        assert str(refused.value).rstrip().endswith("  b = a - c;\n          ^")

    def test_longLinesAreShownAroundThePlace(self):
        text = "0 | " * 200 + "9" + " | 1" * 200
        with pytest.raises(pymeshlab.PyMeshLabException) as refused:
            evaluate(document(*ROW), text)
        shown, caret = str(refused.value).rstrip("\n").split("\n")[-2:]
        assert shown[len(caret) - 1] == "9" and len(shown) < 120

    @pytest.mark.parametrize("word", ["visible", "all"])
    def test_listsOfNone(self, word):
        mesh_set = document(ROW[0])
        with pytest.raises(pymeshlab.PyMeshLabException, match="stands for no layer"):
            evaluate(mesh_set, f"difference(0, {word})")

    def test_openLayersThatAreReadOnly(self):
        vertices, faces = box((0, 0, 0), (1, 1, 1))
        mesh_set = document(*ROW[:2], (vertices, faces[:-1]))
        assert volumes(evaluate(mesh_set, "0 | 1")) == pytest.approx([12])
        with pytest.raises(pymeshlab.PyMeshLabException, match=r'"C" \(id 2\) is not closed'):
            evaluate(mesh_set, "0 - 1; 2")
        assert mesh_set.mesh(2).selected_face_number() > 0
        assert mesh_set.mesh(0).selected_face_number() == 0

    def test_doubleSidedLayersAreRefused(self):
        vertices, faces = ROW[1]
        mesh_set = document(ROW[0], (vertices, np.concatenate([faces, faces[:, ::-1]])))
        with pytest.raises(pymeshlab.PyMeshLabException, match=r'"B" \(id 1\) .*double-sided'):
            evaluate(mesh_set, "0 - 1")

    def test_selfIntersectionsAreRefusedIfAsked(self):
        mesh_set = document(ROW[0], crossing_bars())
        with pytest.raises(pymeshlab.PyMeshLabException, match=r'"B" \(id 1\) intersects itself'):
            evaluate(mesh_set, "0 | 1", self_intersections="refuse")
        assert mesh_set.mesh(1).selected_face_number() > 0
        assert evaluate(mesh_set, "0 | 1")["result_0_closed"]


class TestParameters:
    def test_everyKey(self):
        result = evaluate(document(*ROW, crossing_bars()), "0 - 1; 3")
        for k in range(2):
            assert {f"result_{k}_{key}" for key in KEYS} <= set(result)
        assert result["results"] == 2 and result["operands"] == 3
        assert list(result["self_intersecting_faces"][:2]) == [0, 0]
        assert result["self_intersecting_faces"][2] > 0
        assert result["labelled_by_cells"] is True
        assert result["volume_law_residual"] < 1e-12
        for key in ("seconds_soup_contacts", "seconds_cell_labels", "seconds_total",
                    "zero_area_faces_removed", "loops_open", "loops_hard_closed"):
            assert key in result
        assert not any(key.endswith(("_first", "_second")) for key in result)

    def test_windingRule(self):
        twice = joined(box((0, 0, 0), (2, 2, 2)), box((1, 0, 0), (3, 2, 2)))
        mesh_set = document(twice, ROW[0])
        texts = "0; odd(0); winding(0, 2); positive(0); nonzero(0)"
        assert volumes(evaluate(mesh_set, texts)) == pytest.approx([12, 8, 4, 12, 12])
        assert volumes(evaluate(mesh_set, texts, winding_rule="odd")) == pytest.approx(
            [8, 8, 4, 12, 12]
        )
        half = joined(box((0, 0, 0), (2, 2, 2)), (box((4, 0, 0), (5, 1, 1))[0],
                                                  box((4, 0, 0), (5, 1, 1))[1][:, ::-1]))
        mesh_set = document(half)
        assert volumes(evaluate(mesh_set, "0", winding_rule="positive")) == pytest.approx([8])
        assert volumes(evaluate(mesh_set, "0; winding(0, 1)")) == pytest.approx([9, 8])

    def test_mergeAndWeld(self):
        mesh_set = document(box((0, 0, 0), (1, 1, 1)), box((1, 1, 0), (2, 2, 1)), ROW[0])
        faces = {}
        for name, parameters in {
            "merged": {}, "cut": {"merge_fragments": False}, "coplanar": {"merge_coplanar": True},
        }.items():
            faces[name] = evaluate(mesh_set, "2 - 0", **parameters)["result_0_faces"]
        assert faces["coplanar"] <= faces["merged"] <= faces["cut"]
        copies = evaluate(mesh_set, "0 | 1")
        welded = evaluate(mesh_set, "0 | 1", weld_non_manifold=True)
        vertices = [
            mesh_set.mesh(int(r["result_0_layer"])).vertex_number() for r in (copies, welded)
        ]
        assert vertices == [16, 14]

    def test_certificates(self):
        mesh_set = document(sphere(), sphere((0.5, 0.25, 0.125)))
        result = evaluate(mesh_set, "0 - 1", certify=False)
        assert result["result_0_self_intersections"] == -1
        assert "result_0_moved_vertices" not in result
        result = evaluate(mesh_set, "0 - 1", certify_as="float")
        vertices, faces = arrays(mesh_set, result["result_0_layer"])
        assert (vertices == vertices.astype(np.float32)).all()
        assert not judges.judge(vertices, faces).wrong

    def test_curves(self):
        mesh_set = document(*ROW)
        mesh_set.add_mesh(pymeshlab.Mesh(*sphere((1, 1, 2), 0.5)), "D")
        result = evaluate(mesh_set, "0 | 3", curves=True)
        lines = mesh_set.mesh(int(result["curves_layer"]))
        assert lines.edge_number() > 0 and len(result["loop_lengths"]) == 1
        result = evaluate(mesh_set, "union(all)", curves=True)
        lines = mesh_set.mesh(int(result["curves_layer"]))
        first, second = (
            lines.vertex_custom_scalar_attribute_array(f"source_mesh_{side}")
            for side in ("first", "second")
        )
        assert (first < second).all() and set(second) <= {1, 2, 3}

    def test_attributes(self):
        mesh_set = document(*ROW)
        for k, red in enumerate((40, 80, 120)):
            mesh_set.set_current_mesh(k)
            mesh_set.compute_color_by_function_per_vertex(x=str(red), y="0", z="0")
            if k != 1:
                mesh_set.compute_scalar_by_function_per_vertex(q=f"{k} + x")
        result = evaluate(mesh_set, "0 | 1 | 2; 2 - 1", select_curve_vertices=True)
        for k in range(2):
            mesh = mesh_set.mesh(int(result[f"result_{k}_layer"]))
            source = mesh.vertex_custom_scalar_attribute_array("source_mesh")
            colours = (mesh.vertex_color_matrix()[:, 0] * 255).round()
            old = source >= 0
            assert (colours[old] == 40 * (source[old] + 1)).all()
            assert mesh.selected_vertex_number() == (~old).sum()
        result = evaluate(mesh_set, "0 | 1", transfer_attributes=False)
        assert not mesh_set.mesh(int(result["result_0_layer"])).has_vertex_color()
        parted = evaluate(mesh_set, "0 | 1", duplicate_curve_vertices=True)["result_0_layer"]
        shared = evaluate(mesh_set, "0 | 1")["result_0_layer"]
        counts = [mesh_set.mesh(int(layer)).vertex_number() for layer in (parted, shared)]
        assert counts[0] > counts[1]

    def test_texturesOfAllLayersAreInOneResult(self, tmp_path):
        mesh_set = pymeshlab.MeshSet()
        for k, mesh in enumerate(ROW):
            picture = tmp_path / f"skin_{k}.png"
            write_picture(np.full((8, 8, 3), 60.0 * k), picture)
            corners = np.tile([(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)], (len(mesh[1]), 1))
            mesh_set.add_mesh(pymeshlab.Mesh(*mesh, w_tex_coords_matrix=corners), f"box {k}")
            mesh_set.set_texture_per_mesh(textname=str(picture))
        result = evaluate(mesh_set, "2 | 1 | 0")
        mesh = mesh_set.mesh(int(result["result_0_layer"]))
        source = mesh.face_custom_scalar_attribute_array("source_mesh").astype(int)
        mesh_set.save_current_mesh(str(tmp_path / "union.ply"))
        header = (tmp_path / "union.ply").read_bytes().split(b"end_header")[0].decode()
        names = re.findall(r"comment TextureFile (\S+)", header)
        numbers = texture_numbers(tmp_path / "union.ply")
        assert sorted(names) == ["skin_0.png", "skin_1.png", "skin_2.png"]
        assert [names[n] for n in numbers] == [f"skin_{2 - k}.png" for k in source]

    @pytest.mark.parametrize("name, wrong", [("octree_max_depth", 77), ("octree_leaf_size", 2000)])
    def test_octree(self, name, wrong):
        with pytest.raises(pymeshlab.PyMeshLabException, match=f"{name} is {wrong}"):
            evaluate(document(*ROW), "0 - 1", **{name: wrong})
        assert volumes(evaluate(document(*ROW), "0 - 1", **{name: 3})) == pytest.approx([4])

    def test_matrices(self):
        mesh_set = document(*ROW)
        mesh_set.set_current_mesh(1)
        mirror = np.diag([-1.0, 1, 1, 1])
        mirror[0, 3] = 4  # [1, 3] in x stays where it is
        mesh_set.set_matrix(transformmatrix=mirror)
        assert volumes(evaluate(mesh_set, "0 - 1; at_least(2, all)")) == pytest.approx([4, 8])

    def test_polygons(self):
        mesh_set = pymeshlab.MeshSet()
        for k in range(3):
            low = np.array([float(k), 0, 0])
            corners, faces = box(low, low + 2)
            mesh_set.add_mesh(pymeshlab.Mesh(corners, faces), f"box {k}")
            mesh_set.meshing_tri_to_quad_by_smart_triangle_pairing()
        result = evaluate(mesh_set, "union(all)", merge_coplanar=True)
        assert result["result_0_closed"] and result["result_0_volume"] == pytest.approx(16)


def test_overlappingBallsOfManyKindsHoldBesideManifold():
    balls = [sphere((0.7 * (k % 4), 0.6 * (k // 4 % 4), 0.05 * k), 0.5, 2) for k in range(16)]
    mesh_set = document()
    for k, ball in enumerate(balls):
        mesh_set.add_mesh(pymeshlab.Mesh(*ball), f"ball {k}")
    texts = "whole = union(all); first = difference(0, all); two = at_least(2, all)"
    result = evaluate(mesh_set, texts)
    import manifold3d

    solids = [
        manifold3d.Manifold(
            manifold3d.Mesh64(np.ascontiguousarray(v), np.ascontiguousarray(f, dtype=np.uint64))
        )
        for v, f in balls
    ]
    whole = manifold3d.Manifold.batch_boolean(solids, manifold3d.OpType.Add)
    first = manifold3d.Manifold.batch_boolean(solids, manifold3d.OpType.Subtract)
    assert result["result_0_volume"] == pytest.approx(whole.volume(), rel=1e-9)
    assert result["result_1_volume"] == pytest.approx(first.volume(), rel=1e-9)
    for k in range(3):
        made = arrays(mesh_set, result[f"result_{k}_layer"])
        assert mesh_laws.unmatched_edges(*made) == 0
        assert not judges.judge(*made).wrong


class TestResolve:
    def test_rulesAndOuterHull(self):
        inner = box((0.5, 0.5, 0.5), (1, 1, 1))
        hollow = joined(box((0, 0, 0), (2, 2, 2)), (inner[0], inner[1][:, ::-1]),
                        box((1.5, 0, 0), (3, 2, 2)))
        mesh_set = document(ROW[0], hollow)
        result = mesh_set.generate_index_boolean_resolve(mesh=1)
        assert result["resolved_volume"] == pytest.approx(12 - 0.125)
        assert labels(mesh_set)[-1] == "B resolved"
        assert {f"resolved_{key}" for key in KEYS} <= set(result)
        assert result["self_intersecting_faces"] > 0 and result["labelled_by_cells"]
        made = arrays(mesh_set, result["resolved_layer"])
        assert not judges.judge(*made).wrong
        hull = mesh_set.generate_index_boolean_resolve(mesh=1, outer_hull=True)
        assert hull["resolved_volume"] == pytest.approx(12) and hull["resolved_components"] == 1
        odd = mesh_set.generate_index_boolean_resolve(mesh=1, winding_rule="odd")
        assert odd["resolved_volume"] == pytest.approx(12 - 0.125 - 2)

    def test_theCurrentLayerIsTheDefault(self):
        mesh_set = document(ROW[0], crossing_bars())
        result = mesh_set.generate_index_boolean_resolve()
        assert result["resolved_volume"] == pytest.approx(8.0625)

    def test_openLayersAreRefused(self):
        vertices, faces = box((0, 0, 0), (1, 1, 1))
        mesh_set = document((vertices, faces[:-1]))
        with pytest.raises(pymeshlab.PyMeshLabException, match="is not closed"):
            mesh_set.generate_index_boolean_resolve()
        assert mesh_set.mesh(0).selected_face_number() > 0

    def test_attributesStay(self):
        mesh_set = document(crossing_bars())
        mesh_set.compute_color_by_function_per_vertex(x="90", y="0", z="0")
        mesh_set.generate_index_boolean_resolve()
        mesh = mesh_set.current_mesh()
        assert ((mesh.vertex_color_matrix()[:, 0] * 255).round() == 90).all()
        assert set(mesh.face_custom_scalar_attribute_array("source_mesh")) == {0}
