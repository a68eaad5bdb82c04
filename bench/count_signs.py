# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What decides the signs: counts for each benchmark case, and the time that a pair of faces takes.

in: the benchmark built twice, by the presets count-signs and release, and the folder of
INDEXBOOLEAN_MESHES; out: a Markdown table, printed, and written between the marks of the page
given by --page.
"""

import argparse
import json
import re
import subprocess
import sys
from pathlib import Path

import compare

# The stages whose work grows with the pairs, not with the faces.
PAIR_STAGES = (
    "octree_pairs", "triangle_contact", "curve_points", "cut_lines", "retriangulate",
    "repair_places", "loops", "labels", "overlap_owners",
)
SIGNS = ("orient3d", "orient2d", "curve_orient2d", "curve_order")
HEADERS = (
    "case", "pairs whose boxes meet", "of these parted by a plane",
    "signs by double", "by double-double", "by integers",
    "points rounded by double-double", "by integers", "time a pair",
)


def one_operation(bench, case, *options):
    command = [bench, *case.arguments, "--operation", case.operation, *options]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{case.title()}: {done.stdout}{done.stderr}")
    return json.loads(done.stdout)["one_operation"]


def table_row(case, counted, timed, base):
    """The row's cells, and the seconds that a pair takes; `base`: those of the first case."""
    signs = counted.get("signs", {})  # none where no question was asked

    def total(decider, predicates):
        return sum(signs.get(predicate, {}).get(decider, 0) for predicate in predicates)

    pairs = sum(signs.get("pair_sieve", {}).values())
    counts = [
        pairs, total("double", ["pair_sieve"]),
        *(total(decider, SIGNS) for decider in ("double", "double_double", "integers")),
        *(total(decider, ["rounding"]) for decider in ("double_double", "integers")),
    ]
    seconds = sum(timed["seconds_per_stage"].get(stage, 0) for stage in PAIR_STAGES)
    if pairs == 0:
        return [case.title(), *map(grouped, counts), "none"], None
    each = seconds / pairs
    ratio = "" if base is None else f" ({each / base:.2g}×)"
    return [case.title(), *map(grouped, counts), f"{each * 1e6:.2g} µs{ratio}"], each


def grouped(number):
    return f"{number:,}".replace(",", " ")


def write_between_marks(page, table):
    text = page.read_text(encoding="utf-8")
    marked = re.compile(r"(?<=<!-- signs -->\n).*?(?=<!-- /signs -->)", re.DOTALL)
    page.write_text(marked.sub(lambda _: table + "\n", text), encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--counting", default="build/count-signs/bench/index_boolean_bench")
    parser.add_argument("--timing", default="build/release/bench/index_boolean_bench")
    parser.add_argument("--spheres", type=int, default=328000, help="faces of the spheres")
    parser.add_argument("--runs", type=int, default=5, help="timed runs of each case")
    parser.add_argument("--cases", default="", help="only cases whose title contains this")
    parser.add_argument("--page", type=Path, help="a page with <!-- signs --> marks")
    args = parser.parse_args()
    rows, base = [], None
    cases = compare.select_cases(args.spheres, 1000, args.cases)
    for case in [case for case in cases if case.operation != "split"]:
        counted = one_operation(args.counting, case, "--runs", "1", "--warmups", "0")
        if "signs" not in counted and base is None:
            sys.exit(f"{args.counting} does not count: build it by the preset count-signs")
        timed = one_operation(args.timing, case, "--runs", str(args.runs))
        row, each = table_row(case, counted, timed, base)
        base = base or each
        rows.append(row)
        print(" | ".join(row), file=sys.stderr, flush=True)
    table = compare.markdown(HEADERS, rows)
    print(table)
    if args.page:
        write_between_marks(args.page, table)


if __name__ == "__main__":
    main()
