# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Walls merged that rounding has taken off their plane: this project beside Manifold's
simplification and CGAL's remeshing of almost planar patches, all on the same surfaces.

in: the installed package and the pinned peers (bench/requirements.txt); out: a table in Markdown:
of each surface and system the faces that are left, the seconds, how many faces meet others wrongly
as stored (judges.py, libigl's search), and how far samples of either surface are from the other
one, in tolerances. This project's seconds are those of its stages that merge; what finds out that
the surface holds before is beside them.
"""

import argparse
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import igl
import manifold3d
import numpy as np
import pymeshlab

import indexboolean
from compare import duration, markdown
from floors import write_between

ROOT = Path(__file__).resolve().parents[1]
sys.path.append(str(ROOT / "tests/python"))

import chain_kinds  # noqa: E402
import judges  # noqa: E402
import placements  # noqa: E402
from plain_solids import box, turned_about  # noqa: E402

MEASURED_AGAIN = 100  # samples of a surface, those farthest
SHARE = 1e-12  # of the diagonal, where nothing else is said


# --- the surfaces ---------------------------------------------------------------------------------


def last_of_chain(kind, steps, seed=4):
    """What a chain has made, nothing merged on the way."""
    chain = chain_kinds.make_chain(kind, seed, steps)
    mesh = chain.start
    for step in chain.steps:
        mesh = one_block(mesh, step.operand, step.operation)
    return mesh


def one_block(first, second, operation):
    layers = pymeshlab.MeshSet()
    for operand in (first, second):
        layers.add_mesh(pymeshlab.Mesh(*operand))
    wanted = {block: block == operation for block in chain_blocks()}
    result = layers.generate_index_boolean(first_mesh=0, second_mesh=1, **wanted)
    return arrays_of(layers, result[f"{operation}_layer"])


def chain_blocks():
    return ("union", "intersection", "first_minus_second", "second_minus_first")


def arrays_of(layers, number):
    layer = layers.mesh(number)
    return layer.vertex_matrix(), layer.face_matrix()


def plate(count):
    """A turned plate with count * count round holes, made by two runs, so that its walls are cut
    twice."""
    turn = ((1, 2, 3), 0.4)
    mesh = turned_about(box((0, 0, 0), (count, count, 1)), *turn)
    for parity in (0, 1):
        holes = [
            prism(32, x + 0.5, y + 0.5, 0.3)
            for x in range(count) for y in range(count) if (x + y) % 2 == parity
        ]
        points = np.vstack([p for p, _ in holes])
        faces = np.vstack([f + k * len(holes[0][0]) for k, (_, f) in enumerate(holes)])
        mesh = one_block(mesh, turned_about((points, faces), *turn), "first_minus_second")
    return mesh


def prism(sides, x, y, radius):
    """From z = -1 to z = 2 about a line along z."""
    angles = 2 * np.pi * np.arange(sides) / sides
    ring = np.stack([x + radius * np.cos(angles), y + radius * np.sin(angles)], axis=1)
    points = np.vstack([np.column_stack([ring, np.full(sides, z)]) for z in (-1.0, 2.0)])
    i = np.arange(sides)
    j = (i + 1) % sides
    walls = np.vstack([np.stack([i, j, j + sides], 1), np.stack([i, j + sides, i + sides], 1)])
    fan = np.stack([0 * i[1:-1], i[1:-1], i[2:]], 1)
    return points, np.vstack([walls, fan[:, ::-1], fan + sides])


def scan(name):
    return placements.read_mesh(placements.meshes_folder() / f"{name}.obj")


# name: (how it is made, the tolerance as a share of the diagonal)
CASES = {
    "100 cubes united": (lambda: last_of_chain("grow", 100), SHARE),
    "100 cubes carved": (lambda: last_of_chain("carve", 100), SHARE),
    "30 cubes intersected": (lambda: last_of_chain("turned", 30), SHARE),
    "8 boxes of a turned grid": (lambda: last_of_chain("grid_any_8", 8), SHARE),
    "plate with 400 holes": (lambda: plate(20), SHARE),
    "fandisk": (lambda: scan("fandisk"), 1e-6),
    "fandisk, coarser": (lambda: scan("fandisk"), 1e-4),
}


# --- the systems: (mesh, tolerance) -> (mesh, seconds) --------------------------------------------


def here(mesh, tolerance):
    layers = pymeshlab.MeshSet()
    layers.add_mesh(pymeshlab.Mesh(*mesh))
    result = layers.generate_index_boolean_resolve(
        mesh=0, merge_tolerance=pymeshlab.PureValue(tolerance), transfer_attributes=False)
    made = arrays_of(layers, result["resolved_layer"])
    return made, result["seconds_merge_walls"], result["seconds_core"]


def manifold(mesh, tolerance):
    points, faces = mesh
    solid = manifold3d.Manifold(manifold3d.Mesh64(
        np.ascontiguousarray(points), np.ascontiguousarray(faces, dtype=np.uint64)))
    if solid.status() != manifold3d.Error.NoError:
        raise ValueError(str(solid.status()))
    start = time.perf_counter()
    made = solid.simplify(tolerance).to_mesh64()
    seconds = time.perf_counter() - start
    return (made.vert_properties[:, :3], made.tri_verts.astype(np.int64)), seconds


def planar_patches(program):
    def run(mesh, tolerance):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            np.asarray(mesh[0], np.float64).tofile(folder / "points.f64")
            np.asarray(mesh[1], np.uint32).tofile(folder / "triangles.u32")
            done = subprocess.run(
                [program, name, repr(float(tolerance))], capture_output=True, text=True)
            if done.returncode != 0:
                raise ValueError(f"exit status {done.returncode}")
            points = np.fromfile(folder / "remeshed_points.f64").reshape(-1, 3)
            faces = np.fromfile(folder / "remeshed_triangles.u32", np.uint32).reshape(-1, 3)
        return (points, faces.astype(np.int64)), float(done.stdout)

    return run


# --- what came of it ------------------------------------------------------------------------------


def samples_of(mesh, rng):
    """Corners, middles of sides, and four points of each face."""
    corners = mesh[0][mesh[1]]
    weights = rng.dirichlet((1, 1, 1), size=(len(corners), 4))
    inside = np.einsum("fkc,fcd->fkd", weights, corners).reshape(-1, 3)
    middles = (corners + np.roll(corners, -1, axis=1)).reshape(-1, 3) / 2
    return np.concatenate([corners.reshape(-1, 3), middles, inside])


def distance_to_segments(point, a, b):
    along = b - a
    square = np.maximum((along * along).sum(-1), np.longdouble(1e-300))
    share = ((point - a) * along).sum(-1) / square
    return np.sqrt(((a + np.clip(share, 0, 1)[:, None] * along - point) ** 2).sum(-1))


def distance_to_triangles(point, triangles):
    """The least of the distances, in long doubles."""
    a, b, c = (triangles[:, k].astype(np.longdouble) for k in range(3))
    point = point.astype(np.longdouble)
    sides = ((a, b), (b, c), (c, a))
    normal = np.cross(b - a, c - a)
    square = (normal * normal).sum(-1)
    is_above = square > 0
    for p, q in sides:
        is_above &= (np.cross(q - p, point - p) * normal).sum(-1) >= 0
    near = np.min([distance_to_segments(point, *side) for side in sides], axis=0)
    height = np.abs(((point - a) * normal).sum(-1)[is_above]) / np.sqrt(square[is_above])
    return float(min(near.min(), height.min(initial=np.inf)))


def farthest_of(mesh, other):
    """The greatest distance of samples of one surface from the other one. libigl's are taken for
    what they are if small: those to needles are thousands of times too large, so that the largest
    are measured again."""
    samples = samples_of(mesh, np.random.default_rng(1))
    triangles = np.asarray(other[0])[other[1]]
    squares, _, _ = igl.point_mesh_squared_distance(
        samples, np.asarray(other[0]), np.asarray(other[1], dtype=np.int64))
    rough, found = np.sqrt(squares), 0.0
    for tried, number in enumerate(np.argsort(-rough)):
        if rough[number] <= found or tried == MEASURED_AGAIN:
            return max(found, float(rough[number]))
        found = max(found, distance_to_triangles(samples[number], triangles))
    return found


def farthest(mesh, other):
    """The same, both ways."""
    return max(farthest_of(mesh, other), farthest_of(other, mesh))


def row_of(name, system, run, mesh, tolerance, runs):
    try:
        made = [run(mesh, tolerance) for _ in range(runs)]
    except ValueError as error:
        return [name, system, "", str(error), "", ""]
    result = made[0][0]
    seconds = [duration(statistics.median(times)) for times in zip(*(m[1:] for m in made))]
    return [
        name, system, str(len(result[1])), " of ".join(seconds),
        str(judges.judge(*result).meeting), f"{farthest(mesh, result) / tolerance:.2g}",
    ]


def rows_of(name, systems, runs):
    make, share = CASES[name]
    mesh = make()
    tolerance = share * float(np.linalg.norm(np.ptp(mesh[0], axis=0)))
    yield [name, "before", str(len(mesh[1])), "", str(judges.judge(*mesh).meeting), ""]
    for system, run in systems.items():
        yield row_of("", system, run, mesh, tolerance, runs)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--planar-patches", help="the built planar_patches; without it no CGAL")
    parser.add_argument("--cases", default="", help="only those whose names contain this")
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--page", type=Path, help="puts the table between its marks there")
    args = parser.parse_args()
    indexboolean.load_plugin()
    systems = {"here": here, "Manifold": manifold}
    if args.planar_patches:
        systems["CGAL"] = planar_patches(args.planar_patches)
    names = [name for name in CASES if args.cases in name]
    if placements.meshes_folder() is None:
        names = [name for name in names if "fandisk" not in name]
    rows = [row for name in names for row in rows_of(name, systems, args.runs)]
    table = markdown(
        ["surface", "by", "faces", "seconds", "wrong faces", "farthest, in tolerances"], rows)
    print(table)
    if args.page:
        write_between(args.page, "merged", [table])


if __name__ == "__main__":
    main()
