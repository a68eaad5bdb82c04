# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Expressions over many solids, beside Manifold's batch and trueform's graph; and how time grows
with the number of operands that only touch their neighbours.

in: the installed package and the pinned peers (bench/requirements.txt); out: two Markdown tables.
All systems take turns, arrays to arrays; of ours the core's own seconds count, and the filter's,
with the layers, beside them.
"""

import argparse
import functools
import operator
import pathlib
import statistics
import sys
import time

import manifold3d
import numpy as np
import pymeshlab

import indexboolean

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path.append(str(ROOT / "tests/python"))

import mesh_laws  # noqa: E402
from plain_solids import box  # noqa: E402

sys.path.append(str(ROOT / "sample_meshes"))

import make_samples  # noqa: E402


def spheres(count, divisions, spacing, seed):
    """Spheres of 8 * divisions^2 faces each, in general position: neighbours of a grid overlap."""
    rng = np.random.default_rng(seed)
    vertices, faces = make_samples.octahedral_sphere(divisions)
    side = int(np.ceil(count ** (1 / 3)))
    cells = np.argwhere(np.ones((side,) * 3))[:count]
    turns = (make_samples.turned(vertices, rng.normal(size=4)) for _ in cells)
    return [
        (turned + (cell + rng.uniform(-0.1, 0.1, 3)) * spacing, faces)
        for cell, turned in zip(cells, turns)
    ]


def clump(count, divisions, seed):
    """Bodies that nearly all overlap: spheres about places near the middle."""
    rng = np.random.default_rng(seed)
    vertices, faces = make_samples.octahedral_sphere(divisions)
    return [
        (make_samples.turned(vertices, rng.normal(size=4)) + rng.normal(scale=0.35, size=3), faces)
        for _ in range(count)
    ]


def half_minus_half(count):
    """The first half of the operands united, without the second."""
    half = count // 2
    return (
        f"union({', '.join(map(str, range(half)))})"
        f" - union({', '.join(map(str, range(half, count)))})"
    )


# name: (solids, expression, whether all are united)
CASES = {
    "16 spheres of 5k faces, united": (lambda: spheres(16, 25, 1.3, 1), "union(all)"),
    "64 spheres of 5k faces, united": (lambda: spheres(64, 25, 1.3, 2), "union(all)"),
    "50 solids of 1.6k faces, half without half": (
        lambda: spheres(50, 14, 1.2, 3), half_minus_half(50)
    ),
    "40 overlapping bodies of 20k faces, united": (lambda: clump(40, 50, 4), "union(all)"),
    "50 overlapping bodies of 20k faces, united": (lambda: clump(50, 50, 5), "union(all)"),
}


def document(solids):
    meshes = pymeshlab.MeshSet()
    for number, solid in enumerate(solids):
        meshes.add_mesh(pymeshlab.Mesh(*solid), f"solid {number}")
    return meshes


def ours(solids, expression):
    """(seconds of the core, of the filter, volume)"""
    result = document(solids).generate_index_boolean_expression(
        expression=expression, transfer_attributes=False
    )
    return result["seconds_core"], result["seconds_total"], result["result_0_volume"]


def manifold(solids, expression):
    start = time.perf_counter()
    made = [
        manifold3d.Manifold(
            manifold3d.Mesh64(
                np.ascontiguousarray(vertices), np.ascontiguousarray(faces, dtype=np.uint64)
            )
        )
        for vertices, faces in solids
    ]
    united = functools.partial(manifold3d.Manifold.batch_boolean, op=manifold3d.OpType.Add)
    half = len(made) // 2
    parts = [made] if expression == "union(all)" else [made[:half], made[half:]]
    whole = functools.reduce(manifold3d.Manifold.__sub__, map(united, parts))
    mesh = whole.to_mesh64()
    seconds = time.perf_counter() - start
    return seconds, mesh_laws.volume(mesh.vert_properties[:, :3], mesh.tri_verts.astype(np.int64))


def trueform(solids, expression):
    import trueform as library

    start = time.perf_counter()
    meshes = [
        library.Mesh(np.ascontiguousarray(faces, dtype=np.int32), np.ascontiguousarray(vertices))
        for vertices, faces in solids
    ]
    made = [library.op(number) for number in range(len(meshes))]
    half = len(made) // 2
    parts = [made] if expression == "union(all)" else [made[:half], made[half:]]
    united = [functools.reduce(operator.or_, part) for part in parts]
    wanted = functools.reduce(operator.sub, united)
    faces, points, *_ = library.CsgGraph(meshes).mesh(wanted)
    seconds = time.perf_counter() - start
    return seconds, mesh_laws.volume(np.asarray(points), np.asarray(faces, dtype=np.int64))


def print_cases(names, runs):
    print("| case | faces | here, core | with the layers | Manifold, batch | trueform, graph | "
          "volumes differ by |\n|---|---|---|---|---|---|---|")
    for name in names:
        make, expression = CASES[name]
        solids = make()
        times = {"core": [], "filter": [], "Manifold": [], "trueform": []}
        for _ in range(runs):
            core, total, volume = ours(solids, expression)
            times["core"].append(core)
            times["filter"].append(total)
            off = []
            for peer, run in (("Manifold", manifold), ("trueform", trueform)):
                seconds, other = run(solids, expression)
                times[peer].append(seconds)
                off.append(abs(other / volume - 1))
        median = {system: statistics.median(seconds) for system, seconds in times.items()}
        others = " | ".join(
            f"{1e3 * median[peer]:.0f} ms ({median[peer] / median['core']:.1f}×)"
            for peer in ("Manifold", "trueform")
        )
        faces = sum(len(solid[1]) for solid in solids)
        print(f"| {name} | {faces} | {1e3 * median['core']:.0f} ms | "
              f"{1e3 * median['filter']:.0f} ms | {others} | {max(off):.0e} |", flush=True)


def print_growth(counts, runs):
    """Boxes in a row and in a square, each of which overlaps its neighbours alone."""
    print("\n| boxes that overlap their neighbours | here, core | a box |\n|---|---|---|")
    for count in counts:
        side = int(round(count ** 0.5))
        solids = [
            box((1.5 * i, 1.5 * j, 0.01 * ((i * 7 + j) % 11)),
                (1.5 * i + 2 - 0.01 * j / side, 1.5 * j + 2 - 0.01 * i / side, 2))
            for i in range(side) for j in range(side)
        ]
        seconds = statistics.median(ours(solids, "union(all)")[0] for _ in range(runs))
        print(f"| {len(solids)} | {1e3 * seconds:.0f} ms | {1e6 * seconds / len(solids):.0f} µs |",
              flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--cases", default="", help="only those whose names contain this")
    parser.add_argument("--growth", type=int, nargs="*", default=[64, 256, 1024, 4096])
    args = parser.parse_args()
    indexboolean.load_plugin()
    print_cases([name for name in CASES if args.cases in name], args.runs)
    print_growth(args.growth, min(args.runs, 3))


if __name__ == "__main__":
    main()
