# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares two builds of index_boolean_bench, to find what has become slower.

in: two programs; out: a table and the exit status, 1 if a case takes more than the tolerance
longer. The builds run in turn, so that what disturbs the machine disturbs both; the ratio is the
median of the pairs' ratios, and it counts only if nearly all pairs agree on its side.
"""

import argparse
import json
import statistics
import subprocess
import sys

CASES = {
    "spheres": ["--spheres", "328000"],
    "cube and sphere": ["--cube-and-sphere", "328000", "--operation", "first_minus_second"],
    "sphere and itself": ["--twin-spheres", "82000"],
    "sphere shifted by 1e-8": [
        "--twin-spheres", "82000", "--transform-second", "1,0,0,1e-8,0,1,0,0,0,0,1,0",
    ],
    "sphere turned by 1e-7": [
        "--twin-spheres", "20000", "--transform-second", "1,-1e-7,0,0,1e-7,1,0,0,0,0,1,0",
    ],
    "boxes with a common wall": ["--grid-boxes", "24"],
    "terrain": ["--terrain", "300000", "30000"],
}
AGREEING = 0.8  # the share of pairs on one side that is no accident


def seconds(program, arguments, runs):
    """The fastest of a few runs in one process: what disturbs only makes them slower."""
    command = [program, *arguments, "--runs", str(runs)]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        return None  # an option that the older build has not, or a refusal
    result = json.loads(done.stdout)
    return min(result.get("one_operation", result.get("split"))["seconds_each_run"])


def compare(before, after, arguments, args):
    """Pairs of seconds, or None."""
    pairs = []
    for pair in range(args.pairs):
        order = (before, after) if pair % 2 == 0 else (after, before)
        times = {program: seconds(program, arguments, args.runs) for program in order}
        if None in times.values():
            return None
        pairs.append((times[before], times[after]))
    return pairs


def verdict(pairs, tolerance):
    """(The median of the pairs' ratios after/before, whether it says: slower.)"""
    ratios = [after / before for before, after in pairs]
    ratio = statistics.median(ratios)
    agree = sum(r > 1 for r in ratios) >= AGREEING * len(ratios)
    return ratio, agree and ratio > 1 + tolerance


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("before", help="the build to compare with")
    parser.add_argument("after")
    parser.add_argument("--cases", default="", help="only cases whose name contains this")
    parser.add_argument("--pairs", type=int, default=7)
    parser.add_argument("--runs", type=int, default=3, help="runs of each process")
    parser.add_argument("--tolerance", type=float, default=0.05)
    args = parser.parse_args()

    slower = False
    print(f"{'case':26}{'before':>10}{'after':>10}{'after/before':>14}")
    for name, arguments in CASES.items():
        if args.cases not in name:
            continue
        pairs = compare(args.before, args.after, arguments, args)
        if pairs is None:
            print(f"{name:26}{'not run by both':>34}")
            continue
        ratio, is_slower = verdict(pairs, args.tolerance)
        slower |= is_slower
        before, after = (1000 * statistics.median(column) for column in zip(*pairs))
        mark = "  SLOWER" if is_slower else ""
        print(f"{name:26}{before:>7.1f} ms{after:>7.1f} ms{ratio:>14.2f}{mark}", flush=True)
    return 1 if slower else 0


if __name__ == "__main__":
    sys.exit(main())
