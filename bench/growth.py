# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether layers that meet themselves in unpleasant ways cost in proportion to what there is.

in: the built benchmark; out: a Markdown table and the exit status, 1 if a segment on a face of the
largest input of a row takes more than MOST_GROWTH times the time or memory of one of the smallest.
Each input is resolved: searched, cut, labelled by cells, united. A segment on a face is the least
that a step has to look at: a piece of the line in which the face meets another, once for each face.
"""

import argparse
import statistics
import sys
from dataclasses import dataclass
from typing import List

import limits

MOST_GROWTH = 1.5


@dataclass
class Row:
    name: str
    option: str
    sizes: List[int]


ROWS = [
    Row("stack of coplanar faces", "--stack", [8, 16, 32]),
    Row("crossed cones, tip on tip", "--crossed-cones", [500, 1000, 2000]),
    Row("near-coincident spheres", "--near-copies", [500, 1000, 2000]),
    Row("plates through one axis", "--pencil", [3, 6, 12]),
]


@dataclass
class Point:
    """What one size took: the fastest run of each process, the median of those."""

    size: int
    faces: int
    segments: int
    pieces: int
    seconds: float
    memory: float

    def per_segment(self, what):
        return getattr(self, what) / self.segments


def measure(program, row, size, args):
    arguments = [row.option, str(size), "--resolve", "--one-operation", "--runs", str(args.runs),
                 "--threads", str(args.threads)]
    reports = [limits.report_of(program, arguments, args.timeout) for _ in range(args.processes)]
    parts = [report["one_operation"] for report in reports]
    arrangement = parts[0]["arrangement"]
    before = [report["memory_before_bytes"] for report in reports]
    return Point(
        size,
        sum(operand["faces"] for operand in reports[0]["operands"]),
        arrangement["segments_on_faces"],
        arrangement["pieces"],
        statistics.median(min(part["seconds_each_run"]) for part in parts),
        statistics.median(
            part["peak_memory_bytes"] - least for part, least in zip(parts, before)
        ),
    )


def growth(points, what):
    """How much more a segment takes in the largest input than in the smallest."""
    return points[-1].per_segment(what) / points[0].per_segment(what)


def table_lines(row, points):
    for point in points:
        yield (f"| {row.name} {point.size} | {point.faces} | {point.segments} | {point.pieces} | "
               f"{point.seconds * 1e3:.1f} ms | {point.per_segment('seconds') * 1e6:.2f} µs | "
               f"{point.memory / 1e6:.1f} MB | {point.per_segment('memory'):.0f} B |")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", help="the built index_boolean_bench")
    parser.add_argument("--cases", default="", help="only cases whose name contains this")
    parser.add_argument("--processes", type=int, default=3, help="of each, for the median")
    parser.add_argument("--runs", type=int, default=3, help="runs of each process")
    parser.add_argument("--threads", type=int, default=1, help="0: as many as there are")
    parser.add_argument("--timeout", type=float, default=60, help="seconds a process is given")
    args = parser.parse_args()

    rows = [row for row in ROWS if args.cases in row.name]
    if not rows:
        raise SystemExit(f"growth.py: no case has {args.cases!r} in its name")
    print("| input | faces | segments on faces | pieces | time | a segment | memory | a segment |")
    print("|---|---|---|---|---|---|---|---|")
    exceeded = []
    for row in rows:
        points = [measure(args.program, row, size, args) for size in row.sizes]
        print("\n".join(table_lines(row, points)), flush=True)
        exceeded += [
            f"{row.name}: {what} of a segment grow to {growth(points, what):.1f} times"
            for what in ("seconds", "memory") if growth(points, what) > MOST_GROWTH
        ]
    print("\n" + ("\n".join(exceeded) or f"No segment takes {MOST_GROWTH} times as much."))
    return 1 if exceeded else 0


if __name__ == "__main__":
    sys.exit(main())
