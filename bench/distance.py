# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Signed distances of many points from a mesh, beside other libraries, in one run.

in: the package, and of the peers those that can be imported (bench/distance has all); out: Markdown
tables: seconds for building and for asking, with ratios to ours, by the clock and in processor
time, which other programs disturb less; the largest difference from our distances, and how many
signs differ from ours, which are exact. All take turns, and each round begins anew; medians. Peers
that are slow are given some of the points, and their time is multiplied; the table says so. With
--page the tables go between that page's marks, <!-- distance --> and <!-- /distance -->.
"""

import argparse
import collections
import pathlib
import re
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


class Peer:
    """A library. The constructor, which imports it, and distances() are not timed."""

    signed = True
    most = None  # points that it is given

    def distances(self, answer):
        return np.asarray(answer)


class Ours(Peer):
    name = "Index Boolean"
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


class Igl(Peer):
    """Builds its tree with each call, so that all of its time is that of asking."""

    name, most = "libigl, pseudonormals", 100_000
    kind = "SIGNED_DISTANCE_TYPE_PSEUDONORMAL"

    def __init__(self):
        import igl

        self.igl = igl

    def build(self, vertices, faces):
        self.mesh = vertices, faces

    def ask(self, points):
        return self.igl.signed_distance(points, *self.mesh, getattr(self.igl, self.kind))[0]


class IglWinding(Igl):
    name = "libigl, fast winding numbers"
    kind = "SIGNED_DISTANCE_TYPE_FAST_WINDING_NUMBER"


class Vtk(Peer):
    name, most = "VTK, vtkImplicitPolyDataDistance", 10_000

    def __init__(self):
        import pyvista
        import vtk

        self.vtk, self.pyvista = vtk, pyvista

    def build(self, vertices, faces):
        self.function = self.vtk.vtkImplicitPolyDataDistance()
        self.function.SetInput(self.pyvista.PolyData.from_regular_faces(vertices, faces))

    def ask(self, points):
        return [self.function.FunctionValue(point) for point in points]


class PyVista(Vtk):
    """Builds its tree with each call, too."""

    name, most = "PyVista, compute_implicit_distance", 30_000

    def build(self, vertices, faces):
        self.surface = self.pyvista.PolyData.from_regular_faces(vertices, faces)

    def ask(self, points):
        cloud = self.pyvista.PolyData(points).compute_implicit_distance(self.surface)
        return cloud["implicit_distance"]


class Open3d(Peer):
    """In single precision. Its tree is built by the first question, which is asked while building.

    Its sign is that of one ray, or of as many as it is told, by vote.
    """

    name, most = "Open3D, RaycastingScene", 100_000

    def __init__(self):
        import open3d

        self.core, self.scenes = open3d.core, open3d.t.geometry

    def build(self, vertices, faces):
        self.scene = self.scenes.RaycastingScene()
        self.scene.add_triangles(
            self.core.Tensor(vertices.astype(np.float32)),
            self.core.Tensor(faces.astype(np.uint32)),
        )
        self.ask(vertices[:1])

    def ask(self, points):
        query = self.core.Tensor(points.astype(np.float32))
        return self.scene.compute_signed_distance(query).numpy()


class Trimesh(Peer):
    """Positive inside, by its own convention. Its tree is built by the first question."""

    name, most = "trimesh", 500

    def __init__(self):
        import trimesh

        self.trimesh = trimesh

    def build(self, vertices, faces):
        self.mesh = self.trimesh.Trimesh(vertices, faces, process=False)
        self.ask(vertices[:1])

    def ask(self, points):
        return -self.trimesh.proximity.signed_distance(self.mesh, points)


class Fcpw(Peer):
    """In single precision."""

    name, signed = "fcpw, unsigned", False

    def __init__(self):
        import fcpw

        self.fcpw = fcpw

    def build(self, vertices, faces):
        self.scene = self.fcpw.scene_3D()
        self.scene.set_object_count(1)
        self.scene.set_object_vertices(vertices.astype(np.float32), 0)
        self.scene.set_object_triangles(faces, 0)
        self.scene.build(self.fcpw.aggregate_type.bvh_surface_area, True, False, True)

    def ask(self, points):
        found = self.fcpw.interaction_3D_list()
        squared = np.full(len(points), np.inf, dtype=np.float32)
        self.scene.find_closest_points(points.astype(np.float32), squared, found)
        return found

    def distances(self, answer):
        return np.array([interaction.d for interaction in answer])


class MeshLab(Peer):
    """MeshLab's own filter, which samples a layer's vertices."""

    name, most = "MeshLab, distance from reference mesh", 10_000

    def __init__(self):
        import pymeshlab

        self.host = pymeshlab

    def build(self, vertices, faces):
        self.meshes = self.host.MeshSet()
        self.meshes.add_mesh(self.host.Mesh(vertices, faces))

    def ask(self, points):
        self.meshes.add_mesh(self.host.Mesh(points))
        self.meshes.compute_scalar_by_distance_from_another_mesh_per_vertex(
            measuremesh=self.meshes.current_mesh_id(), refmesh=0, signeddist=True,
        )
        values = self.meshes.current_mesh().vertex_scalar_array()
        self.meshes.delete_current_mesh()
        return values


PEERS = (
    Ours, OursTrusted, Igl, IglWinding, Open3d, PyVista, Vtk, Trimesh, MeshLab, OursUnsigned, Fcpw,
)


def points_beside(mesh, count, share):
    """Points at this share of the mesh's size from faces, edges and vertices, to both sides."""
    vertices, faces = mesh
    rng = np.random.default_rng(2)
    corners = vertices[faces[rng.integers(len(faces), size=count)]]
    weights = rng.dirichlet((1, 1, 1), count)
    weights[::3, 0] = 0
    weights[1::3] = np.eye(3)[0]
    weights /= weights.sum(axis=1)[:, None]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    offset = rng.choice((-1, 1), size=(count, 1)) * share * np.ptp(vertices, axis=0).max()
    return (weights[:, :, None] * corners).sum(axis=1) + offset * normals


def cases(folder):
    """(name, mesh, points) each; folder is that of other people's meshes, or None."""
    if folder:
        vertices, faces, points, _ = placements.load_pair("armadillo-bunny", folder)
        yield "bunny100k's vertices to armadillo", (vertices, faces), points
        beside = points_beside((vertices, faces), 50_000, 1e-6)
        yield "points at 1e-6 of its size from armadillo's surface", (vertices, faces), beside
    sphere = make_samples.octahedral_sphere(202)
    yield "a sphere, the vertices of another", sphere, sphere[0] + (0.5, 0.3, 0.2)
    points = np.random.default_rng(1).uniform(-1.3, 1.3, (1_000_000, 3))
    yield "a sphere, 10⁶ random points", sphere, points


def timed(call):
    """((seconds by the clock, seconds of processors), what it gives)"""
    clock, processors = time.perf_counter(), time.process_time()
    value = call()
    return (time.perf_counter() - clock, time.process_time() - processors), value


Row = collections.namedtuple("Row", "peer build ask distances count")


def measure(peers, mesh, points, runs):
    """A row for each peer; its times are for all points, by the clock and of processors."""
    some = {
        peer: np.sort(np.random.default_rng(3).permutation(len(points))[: peer.most])
        for peer in peers
    }
    times, answers = collections.defaultdict(list), {}
    for _ in range(runs):
        for peer in peers:
            asked = np.ascontiguousarray(points[some[peer]])
            build, _ = timed(lambda: peer.build(*mesh))  # noqa: B023
            ask, answers[peer] = timed(lambda: peer.ask(asked))  # noqa: B023
            times[peer].append((*build, *np.multiply(ask, len(points) / len(asked))))
    for peer in peers:
        medians = [statistics.median(column) for column in zip(*times[peer])]
        distances = np.full(len(points), np.nan)
        distances[some[peer]] = peer.distances(answers[peer])
        yield Row(peer, medians[:2], medians[2:], distances, len(some[peer]))


def table_of(name, mesh, points, rows):
    ours = {row.peer.signed: row for row in reversed(rows) if isinstance(row.peer, Ours)}
    yield f"{name}: {len(points)} points, {len(mesh[1])} faces"
    yield ""
    yield "| | build | × | × CPU | ask | µs a point | × | × CPU | difference | signs that differ |"
    yield "|---|---|---|---|---|---|---|---|---|---|"
    for row in rows:
        base, count = ours[row.peer.signed], len(points)
        few = f", from {row.count} points" if row.count < count else ""
        known = ~np.isnan(row.distances)
        found, truth = row.distances[known], base.distances[known]
        wrong = np.count_nonzero(np.sign(found) != np.sign(truth)) if row.peer.signed else ""
        yield (
            f"| {row.peer.name}{few} | {row.build[0]:.3f} s | {row.build[0] / base.build[0]:.1f} "
            f"| {row.build[1] / base.build[1]:.1f} "
            f"| {row.ask[0]:.2f} s | {1e6 * row.ask[0] / count:.1f} "
            f"| {row.ask[0] / base.ask[0]:.1f} | {row.ask[1] / base.ask[1]:.1f} "
            f"| {np.abs(np.abs(found) - np.abs(truth)).max():.0e} | {wrong} |"
        )


def present(peer_classes):
    for peer in peer_classes:
        try:
            yield peer()
        except ImportError as error:
            print(f"{peer.name} is not here: {error}", file=sys.stderr)


def write_page(page, text):
    marks = re.compile("(<!-- distance -->\n).*?(<!-- /distance -->)", re.DOTALL)
    page.write_text(marks.sub(lambda found: found[1] + text + found[2], page.read_text()))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--cases", default="", help="only cases whose name has this in it")
    parser.add_argument("--peers", default="", help="only these: parts of names, with commas")
    parser.add_argument("--page", type=pathlib.Path, help="the page that the tables go into")
    args = parser.parse_args()
    words = args.peers.split(",")
    wanted = [
        peer for peer in PEERS
        if issubclass(peer, Ours) or any(word in peer.name for word in words)
    ]
    peers, tables = list(present(wanted)), []
    for name, mesh, points in cases(placements.meshes_folder()):
        if args.cases in name:
            mesh = np.ascontiguousarray(mesh[0], dtype=float), np.asarray(mesh[1], dtype=np.int32)
            rows = list(measure(peers, mesh, points, args.runs))
            tables.append("\n".join(table_of(name, mesh, points, rows)) + "\n")
            print(tables[-1], flush=True)
    if args.page:
        write_page(args.page, "\n".join(tables))


if __name__ == "__main__":
    main()
