# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Signed distances of many points from a mesh, beside other libraries, in one run.

in: the installed package, and of the peers those that can be imported; out: Markdown tables of
median seconds for building and for asking, with ratios to ours, and how many signs are wrong: those
that differ from ours, whose sign is exact. Peers that are slow are given a share of the points, and
their time is multiplied; the table says so.
"""

import argparse
import pathlib
import statistics
import sys
import time

import numpy as np

import indexboolean

ROOT = pathlib.Path(__file__).resolve().parents[1]
for folder in ("sample_meshes", "tests/python"):
    sys.path.append(str(ROOT / folder))

import make_samples  # noqa: E402
import placements  # noqa: E402


class Ours:
    name, signed = "Index Boolean", True
    options = {}

    def build(self, vertices, faces):
        self.tree = indexboolean.SignedDistance((vertices, faces), **self.options)

    def ask(self, points):
        return self.tree(points)[0]


class OursTrusted(Ours):
    name = "Index Boolean, `trust`"
    options = {"self_intersections": "trust"}


class OursUnsigned(Ours):
    name, signed = "Index Boolean, unsigned", False
    options = {"signed": False}


class Igl:
    """libigl builds its tree with each call, so that all of its time is that of asking."""

    name, signed, share = "libigl, pseudonormals", True, 1

    def build(self, vertices, faces):
        import igl

        self.igl, self.mesh = igl, (vertices, faces.astype(np.int64))

    def ask(self, points):
        kind = self.igl.SIGNED_DISTANCE_TYPE_PSEUDONORMAL
        return self.igl.signed_distance(points, *self.mesh, kind)[0]


class IglWinding(Igl):
    name = "libigl, fast winding numbers"

    def ask(self, points):
        kind = self.igl.SIGNED_DISTANCE_TYPE_FAST_WINDING_NUMBER
        return self.igl.signed_distance(points, *self.mesh, kind)[0]


class Vtk:
    name, signed, share = "VTK, vtkImplicitPolyDataDistance", True, 0.02

    def build(self, vertices, faces):
        import pyvista
        import vtk

        self.surface = pyvista.PolyData.from_regular_faces(vertices, faces)
        self.function = vtk.vtkImplicitPolyDataDistance()
        self.function.SetInput(self.surface)

    def ask(self, points):
        return np.array([self.function.FunctionValue(point) for point in points])


class PyVista:
    name, signed, share = "PyVista, compute_implicit_distance", True, 0.1

    def build(self, vertices, faces):
        import pyvista

        self.pyvista = pyvista
        self.surface = pyvista.PolyData.from_regular_faces(vertices, faces)

    def ask(self, points):
        cloud = self.pyvista.PolyData(points).compute_implicit_distance(self.surface)
        return np.asarray(cloud["implicit_distance"])


class Open3d:
    """In single precision."""

    name, signed = "Open3D, RaycastingScene", True

    def build(self, vertices, faces):
        import open3d

        self.core = open3d.core
        self.scene = open3d.t.geometry.RaycastingScene()
        self.scene.add_triangles(
            open3d.core.Tensor(vertices.astype(np.float32)),
            open3d.core.Tensor(faces.astype(np.uint32)),
        )

    def ask(self, points):
        query = self.core.Tensor(points.astype(np.float32))
        return self.scene.compute_signed_distance(query).numpy()


class Trimesh:
    """Positive inside, by its own convention."""

    name, signed, share = "trimesh", True, 0.005

    def build(self, vertices, faces):
        import trimesh

        self.trimesh = trimesh
        self.mesh = trimesh.Trimesh(vertices, faces, process=False)

    def ask(self, points):
        return -self.trimesh.proximity.signed_distance(self.mesh, points)


class Fcpw:
    """In single precision."""

    name, signed = "fcpw, unsigned", False

    def build(self, vertices, faces):
        import fcpw

        self.fcpw = fcpw
        self.scene = fcpw.scene_3D()
        self.scene.set_object_count(1)
        self.scene.set_object_vertices(vertices.astype(np.float32), 0)
        self.scene.set_object_triangles(faces.astype(np.int32), 0)
        self.scene.build(fcpw.aggregate_type.bvh_surface_area, True, True, True)

    def ask(self, points):
        found = self.fcpw.interaction_3D_list()
        squared = np.full(len(points), np.inf, dtype=np.float32)
        self.scene.find_closest_points(points.astype(np.float32), squared, found)
        return np.array([interaction.d for interaction in found])


class MeshLab:
    """MeshLab's own filter, which samples a layer's vertices."""

    name, signed = "MeshLab, distance from reference mesh", True

    def build(self, vertices, faces):
        import pymeshlab

        self.meshes = pymeshlab.MeshSet()
        self.meshes.add_mesh(pymeshlab.Mesh(vertices, faces))
        self.host = pymeshlab

    def ask(self, points):
        self.meshes.add_mesh(self.host.Mesh(points))
        layer = self.meshes.current_mesh_id()
        self.meshes.compute_scalar_by_distance_from_another_mesh_per_vertex(
            measuremesh=layer, refmesh=0, signeddist=True,
        )
        values = np.array(self.meshes.mesh(layer).vertex_scalar_array())
        self.meshes.delete_current_mesh()
        return values


PEERS = (
    Ours, OursTrusted, Igl, IglWinding, Open3d, PyVista, Vtk, Trimesh, MeshLab, OursUnsigned, Fcpw,
)


def cases(folder):
    """(name, mesh, points) each; folder is that of other people's meshes, or None."""
    if folder:
        vertices, faces, points, _ = placements.load_pair("armadillo-bunny", folder)
        yield "bunny100k's vertices to armadillo", (vertices, faces), points
    sphere = make_samples.octahedral_sphere(202)
    yield "a sphere of 326 432 faces, vertices of another", sphere, sphere[0] + (0.5, 0.3, 0.2)
    points = np.random.default_rng(1).uniform(-1.3, 1.3, (1_000_000, 3))
    yield "the same, 10⁶ random points", sphere, points


def median_seconds(call, runs):
    times = []
    for _ in range(runs):
        start = time.perf_counter()
        value = call()
        times.append(time.perf_counter() - start)
    return statistics.median(times), value


def measure(peer_class, mesh, points, runs):
    """(seconds to build, seconds to ask, share of the points that was asked, distances)"""
    share = getattr(peer_class, "share", 1)
    asked = points[: max(1, int(share * len(points)))]
    peer = peer_class()
    build, _ = median_seconds(lambda: peer.build(*mesh), runs)
    ask, distances = median_seconds(lambda: peer.ask(asked), runs)
    return build, ask / share, share, distances


def print_case(name, mesh, points, runs):
    vertices, faces = np.ascontiguousarray(mesh[0], dtype=float), np.asarray(mesh[1])
    print(f"\n{name}: {len(points)} points, {len(faces)} faces\n")
    print("| | build | ask | µs a point | asking, beside ours | signs that differ |")
    print("|---|---|---|---|---|---|")
    truth = ours = None
    for peer in PEERS:
        try:
            build, ask, share, distances = measure(peer, (vertices, faces), points, runs)
        except ImportError as error:
            print(f"| {peer.name} | not here: {error} | | | | |")
            continue
        if truth is None:
            truth, ours = distances, ask
        wrong = np.count_nonzero(np.sign(distances) != np.sign(truth[: len(distances)]))
        remark = f", from {share:.1%} of the points" if share < 1 else ""
        print(
            f"| {peer.name}{remark} | {build:.3f} s | {ask:.3f} s | {1e6 * ask / len(points):.2f} "
            f"| {ask / ours:.2f} | {wrong if peer.signed else ''} |", flush=True,
        )


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--cases", default="", help="only cases whose name has this in it")
    args = parser.parse_args()
    for name, mesh, points in cases(placements.meshes_folder()):
        if args.cases in name:
            print_case(name, mesh, points, args.runs)


if __name__ == "__main__":
    main()
