# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What it costs to carry attributes: the filter's four blocks with and without them, in turn.

in: the installed package; out: a Markdown table of median milliseconds, and the ratio.
"""

import argparse
import pathlib
import statistics
import sys
import time

import numpy as np
import pymeshlab

import indexboolean

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path.append(str(ROOT / "sample_meshes"))

import make_samples  # noqa: E402


def operands(n):
    """Two spheres of 8 n^2 faces that cross in a circle."""
    points, faces = make_samples.octahedral_sphere(n)
    return (points, faces), (points @ np.diag((1, -1, -1)) + (0.5, 0.3, 0.2), faces)


def layer(mesh, carries, rng):
    """A layer; pymeshlab's always have colours and qualities of vertices."""
    points, faces = mesh
    if not carries:
        return pymeshlab.Mesh(points, faces)
    return pymeshlab.Mesh(
        points,
        faces,
        v_color_matrix=rng.uniform(size=(len(points), 4)),
        f_color_matrix=rng.uniform(size=(len(faces), 4)),
        f_scalar_array=rng.uniform(size=len(faces)),
        w_tex_coords_matrix=rng.uniform(size=(3 * len(faces), 2)),
    )


def seconds(meshes, carries, transfer):
    rng = np.random.default_rng(1)
    mesh_set = pymeshlab.MeshSet()
    for mesh in meshes:
        mesh_set.add_mesh(layer(mesh, carries, rng))
    start = time.perf_counter()
    mesh_set.generate_index_boolean(first_mesh=0, second_mesh=1, transfer_attributes=transfer)
    return time.perf_counter() - start


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--fineness", type=int, default=128, help="n of 8 n^2 faces a sphere")
    parser.add_argument("--runs", type=int, default=9)
    args = parser.parse_args()
    indexboolean.load_plugin()
    meshes = operands(args.fineness)
    print("| layers of 2 × {} faces | without | with | ratio |".format(len(meshes[0][1])))
    print("|---|---|---|---|")
    cases = ("with nothing of their own", False), ("with all that scripts give", True)
    for name, carries in cases:
        times = {False: [], True: []}
        for run in range(args.runs + 1):
            for transfer in (run % 2 == 0, run % 2 != 0):
                taken = seconds(meshes, carries, transfer)
                if run > 0:  # the first warms up
                    times[transfer].append(1000 * taken)
        without, full = (statistics.median(times[transfer]) for transfer in (False, True))
        print(f"| {name} | {without:.0f} ms | {full:.0f} ms | {full / without:.2f} |")


if __name__ == "__main__":
    main()
