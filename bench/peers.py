# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Times one Boolean or split of one peer, from arrays to arrays; compare.py starts it for each.

in: a folder of arrays (index_boolean_bench --save-arrays); out: one JSON object per line, the
seconds of each run and then the result's figures. A run that takes longer than the limit ends the
process by SIGALRM, since no library can be interrupted otherwise.

Timed is what a caller waits for: building the peer's own meshes from arrays of the types that it
wants, the operation, and its arrays back. Not timed: importing, converting types, reading, and for
MeshLab's filters the layers before and after, as they work on layers.
"""

import argparse
import json
import math
import signal
import sys
import time
from importlib.metadata import version
from pathlib import Path

import numpy as np

LONG_RUN_SECONDS = 10.0


class Peer:
    """One library. The constructor and prepare() are not timed, run() is."""

    package = ""

    def __init__(self, first, second, operation):
        self.operands = (first, second)
        self.operation = operation

    def prepare(self):
        """Sets up what one run changes, and frees what the run before left."""

    def run(self):
        """Returns the result, as (points, triangles) unless arrays() says otherwise."""
        raise NotImplementedError

    def arrays(self, result):
        return result

    def figures(self, result):
        """What the result is checked by."""
        points, triangles = self.arrays(result)
        return {
            "faces": len(triangles),
            "volume": volume(points, triangles) if len(triangles) else 0.0,
            "closed": is_closed(triangles),
        }

    def converted(self, point_type, index_type):
        """Both operands as contiguous arrays of other types."""
        return [
            (np.ascontiguousarray(points, point_type), np.ascontiguousarray(triangles, index_type))
            for points, triangles in self.operands
        ]


class Manifold(Peer):
    package = "manifold3d"

    def __init__(self, *args):
        super().__init__(*args)
        import manifold3d

        self.library = manifold3d
        self.operands = self.converted(np.float64, np.uint64)
        self.call = {
            "union": manifold3d.Manifold.__add__,
            "intersection": manifold3d.Manifold.__xor__,
            "first_minus_second": manifold3d.Manifold.__sub__,
        }[self.operation]

    def run(self):
        first, second = (
            self.library.Manifold(self.library.Mesh64(points, triangles))
            for points, triangles in self.operands
        )
        for operand in (first, second):
            if operand.status() != self.library.Error.NoError:
                raise ValueError(f"an operand is refused: {operand.status().name}")
        mesh = self.call(first, second).to_mesh64()
        return mesh.vert_properties, mesh.tri_verts


class TrueformPeer(Peer):
    package = "trueform"

    def __init__(self, *args):
        super().__init__(*args)
        import trueform

        self.library = trueform
        self.operands = self.converted(np.float64, np.int32)

    def meshes(self):
        return [self.library.Mesh(triangles, points) for points, triangles in self.operands]


class Trueform(TrueformPeer):
    def __init__(self, *args):
        super().__init__(*args)
        self.call = {
            "union": self.library.boolean_union,
            "intersection": self.library.boolean_intersection,
            "first_minus_second": self.library.boolean_difference,
        }[self.operation]

    def run(self):
        (triangles, points), *_ = self.call(*self.meshes())
        return points, triangles


class TrueformArrangement(TrueformPeer):
    """Both operands cut at each other: one mesh, whose faces know where they come from."""

    def run(self):
        (triangles, points), *_ = self.library.mesh_arrangements(self.meshes())
        return points, triangles

    def figures(self, result):
        return {"faces": len(result[1])}


class TrueformCells(TrueformArrangement):
    """The arrangement, and from it a mesh of each bounded cell."""

    def run(self):
        points, triangles = super().run()
        labels = self.library.domain_labels(
            (triangles, points), ignore_open_fragments=True, exclude_outer_shell=True
        )
        cells, _ = self.library.split_into_domains((triangles, points), labels)
        return [(points, triangles) for triangles, points in cells]

    def figures(self, result):
        cells = [Peer.figures(self, cell) for cell in result]
        return {
            "faces": sum(cell["faces"] for cell in cells),
            "volume": sum(cell["volume"] for cell in cells),
            "closed": all(cell["closed"] for cell in cells),
            "cells": len(cells),
        }


class MeshLib(Peer):
    package = "meshlib"

    def __init__(self, *args):
        super().__init__(*args)
        from meshlib import mrmeshnumpy, mrmeshpy

        self.numpy, self.library = mrmeshnumpy, mrmeshpy
        self.operands = self.converted(np.float64, np.int32)
        self.kind = {
            "union": mrmeshpy.BooleanOperation.Union,
            "intersection": mrmeshpy.BooleanOperation.Intersection,
            "first_minus_second": mrmeshpy.BooleanOperation.DifferenceAB,
        }[self.operation]

    def run(self):
        first, second = (
            self.numpy.meshFromFacesVerts(triangles, points) for points, triangles in self.operands
        )
        result = self.library.boolean(first, second, self.kind)
        if not result.valid():
            raise ValueError(result.errorString)
        mesh = result.mesh
        return self.numpy.getNumpyVerts(mesh), self.numpy.getNumpyFaces(mesh.topology)


class Cgal(Peer):
    package = "compas_cgal"

    def __init__(self, *args):
        super().__init__(*args)
        from compas_cgal import booleans

        self.operands = self.converted(np.float64, np.int32)
        self.call = {
            "union": booleans.boolean_union_mesh_mesh,
            "intersection": booleans.boolean_intersection_mesh_mesh,
            "first_minus_second": booleans.boolean_difference_mesh_mesh,
        }[self.operation]

    def run(self):
        return self.call(*self.operands)


class Libigl(Peer):
    package = "libigl"

    def __init__(self, *args):
        super().__init__(*args)
        from igl.copyleft import cgal

        self.library = cgal
        self.operands = self.converted(np.float64, np.int64)
        self.kind = {
            "union": "union",
            "intersection": "intersect",
            "first_minus_second": "minus",
        }[self.operation]

    def run(self):
        first, second = self.operands
        points, triangles, _ = self.library.mesh_boolean(*first, *second, type_str=self.kind)
        return points, triangles


class Vtk(Peer):
    package = "vtk"

    def __init__(self, *args):
        super().__init__(*args)
        import pyvista

        self.library = pyvista
        self.operands = self.converted(np.float64, np.int64)
        self.method = {
            "union": "boolean_union",
            "intersection": "boolean_intersection",
            "first_minus_second": "boolean_difference",
        }[self.operation]

    def run(self):
        first, second = (
            self.library.PolyData.from_regular_faces(points, triangles)
            for points, triangles in self.operands
        )
        result = getattr(first, self.method)(second)
        return np.asarray(result.points), result.regular_faces


class MeshLab(Peer):
    """MeshLab's own filter, one operation. Timed is the filter call, layers to layer."""

    package = "pymeshlab"

    def __init__(self, *args):
        super().__init__(*args)
        import pymeshlab

        self.library = pymeshlab
        self.operands = self.converted(np.float64, np.int32)
        self.filter = {
            "union": "generate_boolean_union",
            "intersection": "generate_boolean_intersection",
            "first_minus_second": "generate_boolean_difference",
        }[self.operation]

    def prepare(self):
        self.document = self.library.MeshSet()
        for points, triangles in self.operands:
            self.document.add_mesh(self.library.Mesh(points, triangles))

    def run(self):
        self.document.apply_filter(self.filter, first_mesh=0, second_mesh=1)
        return self.document.current_mesh_id()

    def arrays(self, result):
        mesh = self.document.mesh(result)
        return mesh.vertex_matrix(), mesh.face_matrix()


class IndexBooleanFilter(MeshLab):
    """This project's filter: all four blocks as layers, in one call."""

    plugin = ""
    loaded = False  # a second time it would be refused

    def __init__(self, *args):
        super().__init__(*args)
        if not IndexBooleanFilter.loaded:
            self.library.load_plugin(self.plugin)
            IndexBooleanFilter.loaded = True

    def run(self):
        result = self.document.apply_filter("generate_index_boolean", first_mesh=0, second_mesh=1)
        return int(result[f"{self.operation}_layer"])


class Search(Peer):
    """How many of the two operands meet themselves. Meshes are built before: timed is the search,
    with whatever tree it needs."""

    def run(self):
        return [self.meets_itself(mesh) for mesh in self.meshes]

    def meets_itself(self, mesh):
        raise NotImplementedError

    def figures(self, result):
        return {"meeting_themselves": sum(map(bool, result))}


class TrueformSearch(Search):
    """Stops at the first contact; neighbours that fold onto each other are none to it."""

    package = "trueform"

    def __init__(self, *args):
        super().__init__(*args)
        import trueform

        self.library = trueform
        self.operands = self.converted(np.float64, np.int32)

    def prepare(self):
        self.meshes = [
            self.library.Mesh(triangles, points) for points, triangles in self.operands
        ]

    def meets_itself(self, mesh):
        return self.library.has_self_intersections(mesh)


class MeshLibSearch(Search):
    """In single precision."""

    package = "meshlib"

    def __init__(self, *args):
        super().__init__(*args)
        from meshlib import mrmeshnumpy, mrmeshpy

        self.numpy, self.library = mrmeshnumpy, mrmeshpy
        self.operands = self.converted(np.float64, np.int32)

    def prepare(self):
        self.meshes = [
            self.numpy.meshFromFacesVerts(triangles, points) for points, triangles in self.operands
        ]

    def meets_itself(self, mesh):
        return len(self.library.findSelfCollidingTriangles(self.library.MeshPart(mesh)))


class LibiglSearch(Search):
    """The search alone, without the cutting."""

    package = "libigl"

    def __init__(self, *args):
        super().__init__(*args)
        from igl.copyleft import cgal

        self.library = cgal
        self.meshes = self.converted(np.float64, np.int64)

    def meets_itself(self, mesh):
        found = self.library.remesh_self_intersections(*mesh, detect_only=True)
        return len(found[2])


class TrueformWithin(TrueformPeer):
    """The operands cut at each other and at themselves."""

    def run(self):
        (triangles, points), *_ = self.library.mesh_arrangements(self.meshes(), within=True)
        return points, triangles

    def figures(self, result):
        return {"faces": len(result[1])}


PEERS = {
    "trueform": Trueform,
    "trueform_arrangement": TrueformArrangement,
    "trueform_cells": TrueformCells,
    "MeshLib": MeshLib,
    "Manifold": Manifold,
    "CGAL": Cgal,
    "libigl": Libigl,
    "VTK": Vtk,
    "MeshLab": MeshLab,
    "filter": IndexBooleanFilter,
    "trueform_search": TrueformSearch,
    "MeshLib_search": MeshLibSearch,
    "libigl_search": LibiglSearch,
    "trueform_within": TrueformWithin,
}


def load_operand(folder, number):
    points = np.fromfile(folder / f"points_{number}.f64", np.float64).reshape(-1, 3)
    triangles = np.fromfile(folder / f"triangles_{number}.u32", np.uint32).reshape(-1, 3)
    return points, triangles


def volume(points, triangles):
    """From the edges' cross products, which are small where faces are, so that the volume of a thin
    shell is right to more digits than it is compared by."""
    a, b, c = np.asarray(points, np.float64)[np.asarray(triangles, np.int64)].transpose(1, 0, 2)
    return math.fsum(np.einsum("ij,ij->i", a, np.cross(b - a, c - a))) / 6


def is_closed(triangles):
    """Whether each directed edge occurs as often as its reverse, by indices."""
    tails = np.asarray(triangles, np.uint64).ravel()
    heads = np.roll(np.asarray(triangles, np.uint64), -1, axis=1).ravel()
    shift = np.uint64(32)
    return bool(
        np.array_equal(np.sort(tails << shift | heads), np.sort(heads << shift | tails))
    )


def peak_memory():
    """In bytes, since this process began: getrusage would count the one that started it."""
    status = Path("/proc/self/status").read_text().split()
    return int(status[status.index("VmHWM:") + 1]) * 1024


def timed_run(peer, limit):
    peer.prepare()
    signal.setitimer(signal.ITIMER_REAL, limit)
    start = time.perf_counter()
    result = peer.run()
    seconds = time.perf_counter() - start
    signal.setitimer(signal.ITIMER_REAL, 0)
    return seconds, result


def emit(**values):
    print(json.dumps(values), flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("peer", choices=PEERS)
    parser.add_argument("arrays", type=Path)
    parser.add_argument(
        "operation", choices=["union", "intersection", "first_minus_second", "split", "search"]
    )
    parser.add_argument("--runs", type=int, default=5, help="timed runs after a warm-up")
    parser.add_argument(
        "--seconds", type=float, default=0, help="more runs, until they took that long in all"
    )
    parser.add_argument("--limit", type=float, default=120, help="seconds that a run may take")
    parser.add_argument("--plugin", default="", help="the plugin's file, for the peer 'filter'")
    args = parser.parse_args()

    IndexBooleanFilter.plugin = args.plugin
    peer_class = PEERS[args.peer]
    emit(package=peer_class.package, version=version(peer_class.package))
    try:
        operands = [load_operand(args.arrays, number) for number in range(2)]
        peer = peer_class(*operands, args.operation)
        seconds, result = timed_run(peer, args.limit)
        if seconds > LONG_RUN_SECONDS:  # the warm-up is the measurement
            emit(seconds=seconds)
        else:
            runs, timed = 0, 0.0
            while runs < args.runs or timed < args.seconds:
                result = None
                seconds, result = timed_run(peer, args.limit)
                emit(seconds=seconds)
                runs, timed = runs + 1, timed + seconds
        figures = peer.figures(result)
    except Exception as error:
        emit(error=str(error).strip().splitlines()[0] if str(error) else repr(error))
        return 1
    emit(**figures, peak_memory_bytes=peak_memory())
    return 0


if __name__ == "__main__":
    sys.exit(main())
