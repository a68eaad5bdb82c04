# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""bench/batch.py: many pairs by the command `batch`, and by the loops that one would write instead.

in: --jobs pairs of the sample meshes, the second mesh of each moved a little; out: out/batch/
batch.md and batch.json, the seconds of each way to do them all, in one run, one after another:

    a shell loop of meshlabserver 2020.09, a process a pair (float, and one thread as the others)
    a plain pymeshlab loop in one process
    batch with one worker, with one a core, and on a Dask cluster of one worker a core

Every way reads the same files, makes the same four blocks and writes them. The scheduling overhead
of a job is what batch with one worker takes more than the plain loop, its start apart, which a
batch of one job tells. Needs tools/setup, and on Debian 12 its meshlabserver.
"""

import argparse
import csv
import json
import os
import shutil
import statistics
import subprocess
import sys
import time
from pathlib import Path

from compare import duration, markdown, processor

ROOT = Path(__file__).resolve().parents[1]
sys.path.append(str(ROOT / "tests" / "python"))

import meshlabserver  # noqa: E402

PAIRS = (
    ("bumpy_sphere", "ribbed_torus"), ("statue", "wavy_cutter"), ("torus_about_z", "torus_about_x"),
    ("hollow_ball", "bar"),
)
BLOCKS = ("union", "intersection", "first_minus_second", "second_minus_first")
PLAIN_LOOP = """
import csv, pathlib, sys
import indexboolean, pymeshlab
indexboolean.load_plugin()
for row in csv.DictReader(open(sys.argv[1])):
    folder = pathlib.Path(sys.argv[2], row["name"])
    folder.mkdir(parents=True)
    ms = pymeshlab.MeshSet()
    ms.load_new_mesh(row["first"])
    ms.load_new_mesh(row["second"])
    result = ms.generate_index_boolean(first_mesh=0, second_mesh=1)
    for block in %r:
        ms.set_current_mesh(result[block + "_layer"])
        ms.save_current_mesh(str(folder / (block + ".ply")))
""" % (BLOCKS,)
SERVER_LOOP = """
while IFS=, read -r first second name; do
    mkdir -p "$out/$name"
    "$program" -i "$first" -i "$second" -s "$script" \
        -o "$out/$name/union.ply" -l 2 -o "$out/$name/intersection.ply" -l 3 \
        -o "$out/$name/first_minus_second.ply" -l 4 -o "$out/$name/second_minus_first.ply" -l 5
done
"""


def make_table(folder, count):
    """A table of `count` pairs of files of its own."""
    import numpy as np
    import pymeshlab

    rows = []
    for number in range(count):
        first, second = PAIRS[number % len(PAIRS)]
        meshes = pymeshlab.MeshSet()
        meshes.load_new_mesh(str(ROOT / f"sample_meshes/{second}.ply"))
        mesh = meshes.current_mesh()
        shift = np.array((1, 2, 3)) * number * 2.0**-12
        moved = pymeshlab.Mesh(mesh.vertex_matrix() + shift, mesh.face_matrix())
        meshes.add_mesh(moved)
        path = folder / f"second_{number:04}.ply"
        meshes.save_current_mesh(str(path), save_vertex_normal=False)
        rows.append((ROOT / f"sample_meshes/{first}.ply", path, f"{number:04}"))
    table = folder / "jobs.csv"
    with open(table, "w", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows([("first", "second", "name"), *rows])
    return table


def seconds_of(words, **details):
    start = time.monotonic()
    done = subprocess.run(
        [str(word) for word in words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
        **details,
    )
    if done.returncode != 0:
        sys.exit(f"{words[:4]} ended with {done.returncode}:\n{done.stdout[-2000:]}")
    return time.monotonic() - start


def one_thread():
    return {**os.environ, "OMP_NUM_THREADS": "1"}


def server_loop(table, out, program):
    rows = "".join(open(table).readlines()[1:])
    environment = {
        **one_thread(), "out": str(out), "program": str(program), "LC_ALL": "C.UTF-8",
        "script": str(meshlabserver.EXAMPLES / "generate_index_boolean.mlx"),
    }
    screen = ["xvfb-run", "-a", "-s", "-screen 0 1280x1024x24"]
    return seconds_of([*screen, "sh", "-c", SERVER_LOOP], env=environment, input=rows)


def plain_loop(table, out):
    return seconds_of([sys.executable, "-c", PLAIN_LOOP, table, out], env=one_thread())


def batch(table, out, *options):
    words = [sys.executable, "-m", "indexboolean", "batch", table, "-o", out, *options]
    return seconds_of(words, env=one_thread())


def count_blocks(out, jobs):
    """Ends the run if a way has not made all blocks: its time would mean nothing."""
    found = sum(len(list(out.glob(f"*/{block}.ply"))) for block in BLOCKS)
    if found != jobs * len(BLOCKS):
        sys.exit(f"{out} has {found} blocks, not {jobs * len(BLOCKS)}")


def ways(args, folder):
    """(name, function of a table and a folder) of each way, the cluster's with its own start."""
    cores = len(os.sched_getaffinity(0))
    if meshlabserver.is_debian_12():
        program = meshlabserver.install(folder / "meshlab-2020.09")
        yield "shell loop of meshlabserver", lambda *at: server_loop(*at, program)
    yield "plain pymeshlab loop", plain_loop
    yield "batch, 1 worker", lambda *at: batch(*at, "--workers", "1")
    yield f"batch, {cores} workers", lambda *at: batch(*at, "--workers", cores)
    import distributed

    with distributed.LocalCluster(
        n_workers=cores, threads_per_worker=1, dashboard_address=":0", silence_logs=50
    ) as cluster:
        address = cluster.scheduler_address
        yield f"batch, Dask, {cores} workers", lambda *at: batch(*at, "--scheduler", address)


def measure(args, folder):
    """{way: {"all": seconds of all jobs, "one": seconds of a batch of one}}, medians of runs."""
    tables = {"all": make_table(folder, args.jobs)}
    tables["one"] = folder / "one.csv"
    tables["one"].write_text("".join(open(tables["all"]).readlines()[:2]))
    measured = {}
    for name, way in ways(args, folder):
        seconds = {"all": [], "one": []}
        for _ in range(args.runs):
            for which, table in tables.items():
                out = folder / "out"
                shutil.rmtree(out, ignore_errors=True)
                seconds[which].append(way(table, out))
                count_blocks(out, args.jobs if which == "all" else 1)
        measured[name] = {which: statistics.median(times) for which, times in seconds.items()}
        print(name, measured[name], file=sys.stderr, flush=True)
    return measured


def per_job(times, jobs):
    """Seconds that one more job takes."""
    return (times["all"] - times["one"]) / (jobs - 1)


def report(measured, args):
    base = measured["batch, 1 worker"]["all"]
    best = min(measured, key=lambda name: measured[name]["all"])
    rows = [
        [
            name, duration(times["all"]), f"{args.jobs / times['all']:.1f}",
            f"{times['all'] / measured[best]['all']:.1f}×", duration(times["one"]),
            duration(per_job(times, args.jobs)),
        ]
        for name, times in measured.items()
    ]
    headers = [
        f"{args.jobs} pairs, four blocks each", "seconds", "pairs a second", "ratio to the fastest",
        "one pair alone", "each further pair",
    ]
    overhead = per_job(measured["batch, 1 worker"], args.jobs) - per_job(
        measured["plain pymeshlab loop"], args.jobs
    )
    return (
        f"{processor()}, {len(os.sched_getaffinity(0))} cores, load {os.getloadavg()[0]:.1f} at "
        f"the end; medians of {args.runs} runs, one thread a process.\n\n"
        + markdown(headers, rows)
        + f"\n\nScheduling overhead of batch: {1000 * overhead:.1f} ms a job, with its record, "
        f"result.json and all files on the disk before the next; {duration(base)} in all with one "
        "worker.\n"
    )


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--jobs", type=int, default=200)
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--out", type=Path, default=Path("out/batch"))
    args = parser.parse_args()
    folder = args.out.resolve()
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    measured = measure(args, folder)
    text = report(measured, args)
    (folder / "batch.md").write_text(text, encoding="utf-8")
    (folder / "batch.json").write_text(json.dumps(measured, indent=1) + "\n")
    print(text)


if __name__ == "__main__":
    main()
