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
from merged_chains import one_block  # noqa: E402
from plain_solids import box, column, joined, turned_about  # noqa: E402
from surface_distance import farthest  # noqa: E402

SHARE = 1e-12  # of the diagonal, where nothing else is said


# --- the surfaces ---------------------------------------------------------------------------------


def last_of_chain(kind, steps, seed=4):
    """What a chain has made, nothing merged on the way."""
    chain = chain_kinds.make_chain(kind, seed, steps)
    mesh = chain.start
    for step in chain.steps:
        mesh, _ = one_block((mesh, step.operand), step.operation, "host", 0)
    return mesh


def plate(count):
    """A turned plate with count * count round holes, made by two runs, so that its walls are cut
    twice."""
    turn = ((1, 2, 3), 0.4)
    mesh = turned_about(box((0, 0, 0), (count, count, 1)), *turn)
    for parity in (0, 1):
        holes = [
            column(32, x + 0.5, y + 0.5, 0.3)
            for x in range(count) for y in range(count) if (x + y) % 2 == parity
        ]
        operands = mesh, turned_about(joined(*holes), *turn)
        mesh, _ = one_block(operands, "first_minus_second", "host", 0)
    return mesh


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
    layer = layers.mesh(result["resolved_layer"])
    made = layer.vertex_matrix(), layer.face_matrix()
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


def row_of(name, system, run, mesh, tolerance, runs):
    try:
        made = [run(mesh, tolerance) for _ in range(runs)]
    except ValueError as error:
        return [name, system, "", str(error), "", ""]
    result = made[0][0]
    seconds = [duration(statistics.median(times)) for times in zip(*(m[1:] for m in made))]
    return [
        name, system, str(len(result[1])), " of ".join(seconds),
        str(judges.judge(*result).meeting), f"{farthest(mesh, result, per_face=4) / tolerance:.2g}",
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
