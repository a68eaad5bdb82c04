# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The union of two meshes of other libraries: what the functions of the package cost over the
filter on pymeshlab's layers, and what each library's own Boolean takes, in one run.

in: the installed package, trimesh, manifold3d, pyvista and meshio (tools/setup has all); out:
Markdown tables. All ways take turns, and each begins with meshes that it has not seen; the fastest
of the runs counts, since other programs can only slow them down, and the first is not counted. With
--page the tables go between that page's marks, <!-- libraries --> and <!-- /libraries -->.
"""

import argparse
import gc
import pathlib
import re
import sys
import time

import meshio
import numpy as np
import pymeshlab
import pyvista
import trimesh
from vtkmodules.vtkFiltersGeneral import vtkLoopBooleanPolyDataFilter

import indexboolean

ROOT = pathlib.Path(__file__).resolve().parents[1]
for folder in ("sample_meshes", "tests/python"):
    sys.path.append(str(ROOT / folder))

import make_samples  # noqa: E402
import placements  # noqa: E402

BLOCKS = ("union", "intersection", "first_minus_second", "second_minus_first")


class Way:
    """make(mesh, data) gives an operand, which is not timed; unite(a, b) the union, which is."""

    group = None  # of what is compared with this library's own Boolean
    most = 1000  # rounds that it takes part in
    carries = True  # data, where the meshes have some

    def volume(self, result):
        return result.volume


class Layers(Way):
    """The filter on layers that are there."""

    name = "pymeshlab, layers that are there"

    def make(self, mesh, data):
        vertices, faces = mesh
        more = {}
        if data:
            more = {"v_color_matrix": data["colour"] / 255, "f_scalar_array": data["number"]}
        layer = pymeshlab.Mesh(vertices, faces.astype(np.int32), **more)
        if data:
            layer.add_vertex_custom_scalar_attribute(data["height"], "height")
        return layer

    def unite(self, a, b):
        return self.union_of(self.document(a, b), bool(a.has_face_scalar()))

    def document(self, a, b):
        meshes = pymeshlab.MeshSet()
        meshes.add_mesh(a)
        meshes.add_mesh(b)
        return meshes

    def union_of(self, meshes, carries):
        self.result = meshes.generate_index_boolean(
            first_mesh=0, second_mesh=1, transfer_attributes=carries,
            **{block: block == "union" for block in BLOCKS},
        )
        return meshes

    def volume(self, result):
        return self.result["union_volume"]


class LayersOfArrays(Layers):
    """What one would write: arrays into layers, the filter, arrays from the new layer."""

    name = "pymeshlab, arrays into layers and back"

    def make(self, mesh, data):
        return mesh, data

    def unite(self, a, b):
        layers = [Layers.make(self, *operand) for operand in (a, b)]
        meshes = self.union_of(self.document(*layers), bool(a[1]))
        new = meshes.mesh(self.result["union_layer"])
        arrays = [np.array(new.vertex_matrix()), np.array(new.face_matrix())]
        if a[1]:
            arrays += [
                new.vertex_color_matrix(), new.face_scalar_array(),
                new.vertex_custom_scalar_attribute_array("height"),
            ]
        return arrays


class Ours(Way):
    def unite(self, a, b):
        self.report = {}
        return indexboolean.boolean(a, b, report=self.report)

    def volume(self, result):
        return self.report["union_volume"]


class OursOnArrays(Ours):
    name, carries = "indexboolean.boolean, arrays", False

    def make(self, mesh, data):
        return mesh


class OursOnTrimesh(Ours):
    name, group = "indexboolean.boolean, trimesh", "trimesh"

    def make(self, mesh, data):
        made = trimesh.Trimesh(*mesh, process=False)
        if data:
            made.visual.vertex_colors = data["colour"]
            made.face_attributes["number"] = data["number"]
            made.vertex_attributes["height"] = data["height"]
        return made


class OursOnPyVista(Ours):
    name, group = "indexboolean.boolean, pyvista", "pyvista"

    def make(self, mesh, data):
        made = pyvista.PolyData.from_regular_faces(*mesh)
        if data:
            made.point_data["colour"] = data["colour"]
            made.cell_data["number"] = data["number"]
            made.point_data["height"] = data["height"]
        return made


class OursOnMeshio(Ours):
    name = "indexboolean.boolean, meshio"

    def make(self, mesh, data):
        vertices, faces = mesh
        if not data:
            return meshio.Mesh(vertices, [("triangle", faces)])
        return meshio.Mesh(
            vertices, [("triangle", faces)], cell_data={"number": [data["number"]]},
            point_data={"colour": data["colour"], "height": data["height"]},
        )


class Manifold(OursOnTrimesh):
    """In single precision, as trimesh calls it; nothing is carried."""

    name, carries = "trimesh.boolean.union, manifold3d", False

    def unite(self, a, b):
        return trimesh.boolean.union([a, b])

    def volume(self, result):
        return result.volume


class VtkBoolean(OursOnPyVista):
    """vtkBooleanOperationPolyDataFilter."""

    most = 2
    name = "pyvista's boolean_union"

    def unite(self, a, b):
        return a.boolean_union(b)

    def volume(self, result):
        return result.volume


class VtkLoopBoolean(VtkBoolean):
    """VTK's newer filter."""

    name, carries = "VTK's vtkLoopBooleanPolyDataFilter", False

    def unite(self, a, b):
        boolean = vtkLoopBooleanPolyDataFilter()
        boolean.SetOperationToUnion()
        boolean.SetInputData(0, a)
        boolean.SetInputData(1, b)
        boolean.Update()
        return pyvista.wrap(boolean.GetOutput())


WAYS = (Layers, LayersOfArrays, OursOnArrays, OursOnTrimesh, OursOnPyVista, OursOnMeshio, Manifold,
        VtkBoolean, VtkLoopBoolean)


def spheres(n):
    """Two spheres of 8 n^2 faces that cross in a circle."""
    points, faces = make_samples.octahedral_sphere(n)
    return (points, faces), (points @ np.diag((1, -1, -1)) + (0.5, 0.3, 0.2), faces)


def scans():
    """Armadillo and bunny in standard placement, or None where the folder is not named."""
    folder = placements.meshes_folder()
    if not folder:
        return None
    first_points, first, second_points, second = placements.load_pair("armadillo-bunny", folder)
    return (first_points, first), (second_points, second)


def data_of(mesh):
    """Four bytes and a double a vertex, an integer a face."""
    vertices, faces = mesh
    rng = np.random.default_rng(1)
    return {
        "colour": rng.integers(0, 256, (len(vertices), 4), dtype=np.uint8),
        "height": np.ascontiguousarray(vertices[:, 2]), "number": np.arange(len(faces)),
    }


def seconds(way, pair, with_data):
    """(seconds, the volume) of a union of new meshes."""
    operands = [way.make(mesh, data_of(mesh) if with_data else None) for mesh in pair]
    if type(way) is Layers:
        document = way.document(*operands)
        gc.collect()
        start = time.perf_counter()
        result = way.union_of(document, with_data)
    else:
        gc.collect()
        start = time.perf_counter()
        result = way.unite(*operands)
    return time.perf_counter() - start, way.volume(result)


def measure(pair, with_data, ways, rounds):
    """{way: (the fewest seconds, volume)}."""
    times = {way: [] for way in ways}
    volumes = {}
    for turn in range(rounds + 1):
        for way in (way for way in ways if turn <= way.most):
            taken, volumes[way] = seconds(way, pair, with_data)
            if turn > 0:
                times[way].append(taken)
    return {way: (min(times[way]), volumes[way]) for way in ways}


def table(title, measured):
    lines = [
        f"{title}:", "",
        "| | | × filter | × layers | × ours of the same library | volume differs by |",
        "|---|---|---|---|---|---|",
    ]
    by_type = {type(way): values for way, values in measured.items()}
    filter_alone, layers = by_type[Layers][0], by_type[LayersOfArrays][0]
    ours = {
        way.group: values for way, values in measured.items()
        if way.group is not None and way.volume.__func__ is Ours.volume
    }
    exact = by_type[Layers][1]
    for way, (taken, volume) in measured.items():
        is_peer = way.group in ours and ours[way.group][0] != taken
        times = f"{taken / ours[way.group][0]:.2f}" if is_peer else ""
        differs = f"{abs(volume / exact - 1):.0e}" if volume != exact else "0"
        lines.append(
            f"| {way.name} | {1000 * taken:.0f} ms | {taken / filter_alone:.2f} "
            f"| {taken / layers:.2f} | {times} | {differs} |"
        )
    return "\n".join(lines)


def cases(finenesses):
    for n in finenesses:
        pair = spheres(n)
        for with_data in (False, True):
            carried = "with a colour and a number a vertex and a number a face" if with_data else ""
            yield f"Two spheres of {len(pair[0][1])} faces {carried}".strip(), pair, with_data
    pair = scans()
    if pair is not None:
        counts = " and ".join(str(len(faces)) for _, faces in pair)
        yield f"Armadillo and bunny, {counts} faces", pair, False


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--fineness", type=int, nargs="*", default=[79, 112],
                        help="n of 8 n^2 faces a sphere")
    parser.add_argument("--runs", type=int, default=9)
    parser.add_argument("--page", type=pathlib.Path, help="put the tables there")
    args = parser.parse_args()
    indexboolean.load_plugin()
    tables = []
    for title, pair, with_data in cases(args.fineness):
        ways = [way() for way in WAYS if way.carries or not with_data]
        tables.append(table(title, measure(pair, with_data, ways, args.runs)))
        print(tables[-1], end="\n\n", flush=True)
    if args.page:
        text = args.page.read_text(encoding="utf-8")
        marks = re.compile(r"(<!-- libraries -->\n).*(<!-- /libraries -->)", re.DOTALL)
        body = "\n\n".join(tables) + "\n"
        args.page.write_text(marks.sub(lambda m: m[1] + body + m[2], text), encoding="utf-8")


if __name__ == "__main__":
    main()
