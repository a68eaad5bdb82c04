# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Prints, for one operation, each stage's time beside its floor: how long the machine takes to move
the bytes that the stage cannot do without, at its own speed of copying in the same run.

in: the built benchmark and arguments of it; out: a Markdown table. With --scale: time and memory
per triangle for spheres of growing size, with one thread and with all, and with --plot a figure of
them. With --page the table goes between that page's marks, <!-- floors --> or <!-- scale -->.
"""

import argparse
import json
import re
import statistics
import subprocess
from pathlib import Path

POINT, TRIANGLE, INDEX, SOURCE = 24, 12, 4, 8  # bytes of the arrays' items
MOST_MEMORY = 400  # bytes per face beyond the operands that the project allows itself

# What a stage does beyond moving its bytes once, and what keeps that small.
GAPS = {
    "copy in": "first touch of memory: huge pages, each touched by the thread that fills it",
    "operands": "every vertex's faces are gathered and followed round it, which shows that the "
    "operand is closed, oriented and a manifold; coordinates are hashed for welding; volumes. "
    "Parallel over vertices; what is in order is looked at once, and only a defect starts a search",
    "octree_pairs": "boxes of faces in the operands' common box, sorted into octants; far nodes "
    "leave at once, and nodes are never stored",
    "labels": "a union-find over vertices: it jumps in memory where a stream would not; neighbours "
    "that agree already are looked at only",
    "block": "each corner looks up its vertex's new number; vertices are counted, then written, "
    "by all threads",
    "audit": "arithmetic: compensated sums of volumes and areas, a checksum of edges and a "
    "union-find, in one pass",
}
CURVE_GAP = "exact signs, names and sorting: it grows with the curve, not with the faces"


def run(program, arguments):
    done = subprocess.run([program, *arguments], capture_output=True, text=True, check=True)
    return json.loads(done.stdout)


def floor_bytes(result):
    """By stage: what is read and written at least, each item once. Others work on the curve."""
    vertices = sum(operand["vertices"] for operand in result["operands"])
    faces = sum(operand["faces"] for operand in result["operands"])
    operands = POINT * vertices + TRIANGLE * faces
    (block,) = result["one_operation"]["blocks"].values()
    surface = POINT * block["vertices"] + TRIANGLE * block["faces"]
    sources = INDEX * block["vertices"] + SOURCE * block["faces"]
    return {
        "copy in": 2 * operands,
        "operands": operands,
        "octree_pairs": operands,
        "labels": TRIANGLE * faces + vertices,
        f"block {result['operation']}": 2 * surface + sources,
        "audit": surface,
    }


def gap_of(stage):
    return GAPS["block" if stage.startswith("block ") else stage]


def floor_table(program, arguments):
    result = run(program, [*arguments, "--runs", "15"])
    speed = result["copied_bytes_per_second"]
    stages = result["one_operation"]["seconds_per_stage"]
    floors = floor_bytes(result)
    faces = sum(operand["faces"] for operand in result["operands"])
    lines = [
        f"{faces / 1000:.0f} thousand faces, {result['operation']}; this machine copies "
        f"{speed / 1e9:.1f} GB/s, read and written.",
        "",
        "| stage | time | floor | times the floor | what the gap is, and what was done about it |",
        "|---|---|---|---|---|",
    ]
    rest = 0
    for name, seconds in stages.items():
        if name not in floors:
            rest += seconds
            continue
        floor = floors[name] / speed
        lines.append(
            f"| {name} | {seconds * 1e3:.1f} ms | {floor * 1e3:.1f} ms | {seconds / floor:.0f} "
            f"| {gap_of(name)} |"
        )
    lines.append(f"| the curve: all other stages | {rest * 1e3:.1f} ms | | | {CURVE_GAP} |")
    total, least = result["one_operation"]["seconds"], sum(floors.values()) / speed
    lines.append(
        f"| in all | {total * 1e3:.1f} ms | {least * 1e3:.1f} ms | {total / least:.0f} | |"
    )
    return lines


def measure_scale(program, largest):
    """A row for each size: faces of both spheres, seconds with one thread and with all, and bytes
    of memory per face beyond the operands."""
    rows = []
    faces = 5000
    while faces <= largest * 1.1:  # a sphere has not exactly as many faces as are asked for
        results = [
            run(program, ["--spheres", str(faces), "--runs", "5", "--threads", threads])
            for threads in ("1", "0")
        ]
        one, both = (statistics.median(r["one_operation"]["seconds_each_run"]) for r in results)
        count = sum(operand["faces"] for operand in results[1]["operands"])
        peak = results[1]["one_operation"]["peak_memory_bytes"]
        rows.append((count, one, both, (peak - results[1]["memory_before_bytes"]) / count))
        faces *= 4
    return rows


def scale_table(rows):
    lines = [
        "| faces | one thread | all threads | speed-up | per face | memory per face |",
        "|---|---|---|---|---|---|",
    ]
    for faces, one, both, memory in rows:
        lines.append(
            f"| {faces} | {one * 1e3:.3g} ms | {both * 1e3:.3g} ms | {one / both:.2f} "
            f"| {both / faces * 1e9:.0f} ns | {memory:.0f} bytes |"
        )
    return lines


def plot_scale(rows, file):
    from matplotlib import pyplot

    faces, one, both, memory = zip(*rows)
    figure, (times, bytes_) = pyplot.subplots(1, 2, figsize=(9, 3.4), layout="constrained")
    for seconds, label in ((one, "one thread"), (both, "all threads")):
        per_face = [s / n * 1e9 for s, n in zip(seconds, faces)]
        times.plot(faces, per_face, marker="o", label=label)
    times.set(ylabel="time per face, ns", title="union of two spheres")
    times.legend()
    bytes_.plot(faces, memory, marker="o", label="peak")
    bytes_.axhline(MOST_MEMORY, color="grey", linestyle="--", label="limit")
    bytes_.set(ylabel="bytes per face beyond the operands", title="memory")
    bytes_.legend()
    for axes in (times, bytes_):
        axes.set(xscale="log", xlabel="faces of both operands")
        axes.set_ylim(bottom=0)
        axes.grid(alpha=0.3)
    figure.savefig(file)


def write_between(page, mark, lines):
    text = page.read_text(encoding="utf-8")
    marked = re.compile(rf"(?<=<!-- {mark} -->\n).*?(?=<!-- /{mark} -->)", re.DOTALL)
    if not marked.search(text):
        raise SystemExit(f"floors.py: no <!-- {mark} --> in {page}")
    page.write_text(marked.sub(lambda _: "\n".join(lines) + "\n", text), encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", help="the built index_boolean_bench")
    parser.add_argument("--scale", type=int, help="faces of the largest of the two spheres")
    parser.add_argument("--plot", type=Path, help="with --scale: the figure to write")
    parser.add_argument("--page", type=Path, help="a page with marks for the table")
    args, arguments = parser.parse_known_args()
    if args.scale:
        rows = measure_scale(args.program, args.scale)
        mark, lines = "scale", scale_table(rows)
        if args.plot:
            plot_scale(rows, args.plot)
    else:
        mark, lines = "floors", floor_table(args.program, arguments or ["--spheres", "328000"])
    print("\n".join(lines))
    if args.page:
        write_between(args.page, mark, lines)


if __name__ == "__main__":
    main()
