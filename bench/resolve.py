# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What it costs that layers may meet themselves: searching clean pairs, and resolving a layer.

in: the installed package, libigl as the tests have it, the folder that INDEXBOOLEAN_MESHES names,
and, for its columns, an interpreter that has the peers of requirements.txt; out: Markdown tables of
median milliseconds, with ratios. All systems take turns.
"""

import argparse
import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

import igl.copyleft.cgal
import numpy as np
import pymeshlab

import indexboolean

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent
sys.path.append(str(ROOT / "tests/python"))

import mesh_laws  # noqa: E402
from plain_solids import joined  # noqa: E402

sys.path.append(str(ROOT / "sample_meshes"))

import make_samples  # noqa: E402

ONE_BLOCK = {
    "intersection": False, "first_minus_second": False, "second_minus_first": False,
    "transfer_attributes": False, "certify": False,
}


def load(name):
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(str(pathlib.Path(os.environ["INDEXBOOLEAN_MESHES"]) / name))
    return meshes.current_mesh().vertex_matrix(), meshes.current_mesh().face_matrix()


def beside(mesh, shift):
    """A copy of the mesh, moved by parts of its size."""
    return mesh[0] + np.ptp(mesh[0], axis=0) * shift, mesh[1]


def clean_pairs():
    sphere = make_samples.octahedral_sphere(202)
    yield "two spheres", (sphere, (sphere[0] + (0.5, 0.3, 0.2), sphere[1]))
    armadillo, bunny = load("armadillo.obj"), load("bunny100k.obj")
    scale = np.ptp(armadillo[0], axis=0).max() / np.ptp(bunny[0], axis=0).max()
    centred = (bunny[0] - bunny[0].mean(axis=0)) * scale + armadillo[0].mean(axis=0)
    yield "armadillo and bunny", (armadillo, (centred, bunny[1]))
    yield "EMBER 73416 and 1063852", (load("73416.stl"), load("1063852.stl"))


def core_seconds(first, second, self_intersections):
    """Of one run: the core's, and what the result map says."""
    meshes = pymeshlab.MeshSet()
    meshes.add_mesh(pymeshlab.Mesh(*first))
    meshes.add_mesh(pymeshlab.Mesh(*second))
    result = meshes.generate_index_boolean(
        first_mesh=0, second_mesh=1, self_intersections=self_intersections, **ONE_BLOCK
    )
    return result["seconds_core"], result


def save_arrays(folder, operands):
    """As peers.py reads them."""
    for number, (points, triangles) in enumerate(operands):
        np.asarray(points, np.float64).tofile(folder / f"points_{number}.f64")
        np.asarray(triangles, np.uint32).tofile(folder / f"triangles_{number}.u32")


def peer_seconds(python, peer, folder, operation):
    """(One run of a peer after a warm-up, in a process of its own; its figures.)"""
    done = subprocess.run(
        [python, HERE / "peers.py", peer, folder, operation, "--runs", "1"],
        capture_output=True, text=True,
    )
    lines = [json.loads(line) for line in done.stdout.splitlines()]
    if done.returncode != 0:
        raise SystemExit(f"resolve.py: {peer}: {lines[-1] if lines else done.stderr}")
    return lines[1]["seconds"], lines[-1]


def print_searches(runs, python):
    """The search alone, beside those of libraries, whose meshes are built before."""
    print("| clean pair | here | trueform | MeshLib | libigl | the fastest of them / here |\n"
          "|---|---|---|---|---|---|")
    peers = ("trueform_search", "MeshLib_search", "libigl_search")
    for name, pair in clean_pairs():
        times = {peer: [] for peer in ("here", *peers)}
        with tempfile.TemporaryDirectory() as folder:
            save_arrays(pathlib.Path(folder), pair)
            for _ in range(runs):
                result = core_seconds(*pair, "resolve")[1]
                times["here"].append(result["seconds_self_intersections"])
                for peer in peers:
                    seconds, figures = peer_seconds(python, peer, folder, "search")
                    times[peer].append(seconds)
                    if figures["meeting_themselves"]:
                        print(f"{peer} finds that an operand of {name} meets itself")
        medians = {peer: 1e3 * statistics.median(seconds) for peer, seconds in times.items()}
        fastest = min(medians[peer] for peer in peers)
        print("| " + " | ".join([name, *(f"{ms:.1f} ms" for ms in medians.values()),
                                 f"{fastest / medians['here']:.1f}"]) + " |")
    print()


def print_search(runs):
    print("| clean pair | faces | not searched | searched | ratio |\n|---|---|---|---|---|")
    for name, (first, second) in clean_pairs():
        times = {"trust": [], "resolve": []}
        for _ in range(runs):
            for mode, seconds in times.items():
                seconds.append(core_seconds(first, second, mode)[0])
        trust, resolve = (1e3 * statistics.median(times[mode]) for mode in times)
        print(f"| {name} | {len(first[1]) + len(second[1])} | {trust:.1f} ms | {resolve:.1f} ms | "
              f"{resolve / trust:.2f} |")


def print_resolve(runs, python):
    """A layer of two copies that overlap, united with nothing; libigl resolves by its union,
    trueform cuts it at itself."""
    copy = load("armadillo.obj")
    layer = joined(copy, beside(copy, (0.1, 0.07, 0.05)))
    far = beside(copy, 9)
    ours, libigl, trueform = [], [], []
    for _ in range(runs):
        if python:
            with tempfile.TemporaryDirectory() as folder:
                save_arrays(pathlib.Path(folder), (layer, far))
                trueform.append(peer_seconds(python, "trueform_within", folder, "split")[0])
        seconds, result = core_seconds(layer, far, "resolve")
        ours.append(seconds)
        start = time.perf_counter()
        points, faces, _ = igl.copyleft.cgal.mesh_boolean(
            np.ascontiguousarray(layer[0]), np.ascontiguousarray(layer[1], dtype=np.int64),
            np.empty((0, 3)), np.empty((0, 3), dtype=np.int64), "union",
        )
        libigl.append(time.perf_counter() - start)
    alone = result["union_volume"] - mesh_laws.volume(*far)
    off = abs(alone / mesh_laws.volume(points, faces) - 1)
    print("\n| layer that meets itself | faces | here, with a far layer | libigl | ratio | volumes "
          "differ by | trueform, cut only | ratio |\n|---|---|---|---|---|---|---|---|")
    here, there = statistics.median(ours), statistics.median(libigl)
    cut = statistics.median(trueform) if trueform else None
    print(f"| two armadillos | {len(layer[1])} | {1e3 * here:.0f} ms | {1e3 * there:.0f} ms | "
          f"{there / here:.1f} | {off:.0e} | "
          + (f"{1e3 * cut:.0f} ms | {cut / here:.1f} |" if cut else " | |"))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--runs", type=int, default=7)
    parser.add_argument("--peers", default="", help="a Python with requirements.txt installed")
    args = parser.parse_args()
    indexboolean.load_plugin()
    if args.peers:
        print_searches(args.runs, args.peers)
    print_search(args.runs)
    print_resolve(min(args.runs, 3), args.peers)


if __name__ == "__main__":
    main()
