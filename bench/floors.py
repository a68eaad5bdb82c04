# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Prints, for one operation, each stage's time beside its floor: how long the machine takes to move
the bytes that the stage cannot do without, at its own speed of copying in the same run.

in: the built benchmark and arguments of it; out: a Markdown table. With --scale: time and memory
per triangle for spheres of growing size, with one thread and with all.
"""

import argparse
import json
import statistics
import subprocess

POINT, TRIANGLE, INDEX, SOURCE = 24, 12, 4, 8  # bytes of the arrays' items


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


def print_floors(program, arguments):
    result = run(program, [*arguments, "--runs", "15"])
    speed = result["copied_bytes_per_second"]
    stages = result["one_operation"]["seconds_per_stage"]
    floors = floor_bytes(result)
    print(f"Copying: {speed / 1e9:.1f} GB/s, read and written.\n")
    print("| stage | time | floor | times the floor |")
    print("|---|---|---|---|")
    rest = 0
    for name, seconds in stages.items():
        if name not in floors:
            rest += seconds
            continue
        floor = floors[name] / speed
        print(f"| {name} | {seconds * 1e3:.1f} ms | {floor * 1e3:.1f} ms | {seconds / floor:.1f} |")
    print(f"| the curve: all other stages | {rest * 1e3:.1f} ms | | |")
    total, least = result["one_operation"]["seconds"], sum(floors.values()) / speed
    print(f"| in all | {total * 1e3:.1f} ms | {least * 1e3:.1f} ms | {total / least:.1f} |")


def print_scale(program, largest):
    print("| faces | one thread | all threads | speed-up | per face | memory per face |")
    print("|---|---|---|---|---|---|")
    faces = 5000
    while faces <= largest:
        results = [
            run(program, ["--spheres", str(faces), "--runs", "5", "--threads", threads])
            for threads in ("1", "0")
        ]
        one, both = (statistics.median(r["one_operation"]["seconds_each_run"]) for r in results)
        count = sum(operand["faces"] for operand in results[1]["operands"])
        peak = results[1]["one_operation"]["peak_memory_bytes"]
        memory = (peak - results[1]["memory_before_bytes"]) / count
        print(
            f"| {count} | {one * 1e3:.3g} ms | {both * 1e3:.3g} ms | {one / both:.2f} "
            f"| {both / count * 1e9:.0f} ns | {memory:.0f} bytes |",
            flush=True,
        )
        faces *= 4


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", help="the built index_boolean_bench")
    parser.add_argument("--scale", type=int, help="faces of the largest of the two spheres")
    args, arguments = parser.parse_known_args()
    if args.scale:
        print_scale(args.program, args.scale)
    else:
        print_floors(args.program, arguments or ["--spheres", "328000"])


if __name__ == "__main__":
    main()
