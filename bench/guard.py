# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares two builds of index_boolean_bench, to find what has become slower.

in: two programs; out: a table and the exit status, 1 if a case takes longer by more than its
tolerance and the noise, or was not run by both. The first build also runs a second time in every
round: what it differs from itself is the noise. Arguments after -- are given to both builds.
"""

import argparse
import itertools
import json
import math
import os
import statistics
import subprocess
import sys
import time
from dataclasses import dataclass, replace
from pathlib import Path

from mesh_pairs import MESHES_VARIABLE, ember_pairs, standard_pair


@dataclass
class Case:
    name: str
    arguments: list
    tolerance: float = 0.05  # by how much slower it may become


DIFFERENCE = ["--operation", "first_minus_second"]
OWN_CASES = [
    Case("spheres", ["--spheres", "328000"]),
    Case("cube and sphere", ["--cube-and-sphere", "328000", *DIFFERENCE]),
    Case("sphere and itself", ["--twin-spheres", "82000"]),
    Case("sphere shifted by 1e-8", [
        "--twin-spheres", "82000", "--transform-second", "1,0,0,1e-8,0,1,0,0,0,0,1,0",
    ]),
    Case("sphere turned by 1e-7", [
        "--twin-spheres", "20000", "--transform-second", "1,-1e-7,0,0,1e-7,1,0,0,0,0,1,0",
    ]),
    Case("boxes with a common wall", ["--grid-boxes", "24"]),
    Case("plate, 100 cylinders", ["--plate", "100", *DIFFERENCE]),
    Case("two boxes", ["--boxes", *DIFFERENCE], 0.1),
    Case("500 small pairs", ["--small-pairs", "500"], 0.1),
    Case("terrain", ["--terrain", "300000", "30000"]),
]
STANDARD_NAME = "armadillo, bunny"
EMBER_NAMES = ["EMBER 88566, 58011", "EMBER 908460, 73416"]
MESH_NAMES = [STANDARD_NAME, *EMBER_NAMES]
CHANCE = 0.05  # that the median lies outside of its interval
ENOUGH = 0.5  # of the tolerance: less noise decides no case


def mesh_cases(folder):
    """Ends the program if the folder has not all of their files: nobody sets it to skip them."""
    try:
        pairs = [
            (STANDARD_NAME, standard_pair(folder, "armadillo.obj", "bunny100k.obj"), []),
            *((name, pair, DIFFERENCE) for name, pair in zip(EMBER_NAMES, ember_pairs(folder))),
        ]
    except OSError as error:
        sys.exit(f"{MESHES_VARIABLE}: {error}")
    absent = [str(file) for _, (files, _), _ in pairs for file in files if not file.is_file()]
    if absent:
        sys.exit(f"{MESHES_VARIABLE}: there is no {', no '.join(absent)}")
    return [Case(name, [*arguments, *operation]) for name, (_, arguments), operation in pairs]


class NotRun(Exception):
    """An option that a build has not, a refusal, or a crash."""


def seconds(program, case, args):
    """The fastest run of one process: what disturbs only makes them slower.

    Of small pairs, the median pair's: each runs once."""
    length = ["--runs", str(args.runs), "--seconds", str(args.seconds)]
    command = [program, *case.arguments, *length, *args.options]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        said = done.stderr.strip().splitlines() or [f"exit status {done.returncode}"]
        raise NotRun(f"{program}: {said[0]}")
    result = json.loads(done.stdout)
    if "small_pairs" in result:
        return result["small_pairs"]["seconds"]
    return min(result.get("one_operation", result.get("split"))["seconds_each_run"])


def noise(rounds):
    """How far from 1 the median ratio of a build to itself may lie.

    The farther end of the median's interval by ranks, so that no distribution is assumed."""
    ratios = sorted(again / before for before, _, again in rounds)
    n = len(ratios)

    def outside(k):
        """The chance that the median lies outside, with k ratios left out on either side."""
        return 2 * sum(math.comb(n, i) for i in range(k + 1)) / 2**n

    left_out = max((k for k in range(n // 2) if outside(k) <= CHANCE), default=0)
    return max(ratios[n - 1 - left_out] - 1, 1 - ratios[left_out])


def verdict(rounds, tolerance):
    """(The median ratio of after to before, the noise, a word.)

    It is only ok if the noise could not hide that it is slower."""
    ratio = statistics.median(
        after / base for before, after, again in rounds for base in (before, again)
    )
    scatter = noise(rounds)
    if ratio > 1 + tolerance + scatter:
        return ratio, scatter, "SLOWER"
    return ratio, scatter, "unclear" if ratio > 1 + tolerance - scatter else "ok"


def measure(programs, case, args):
    """Rounds of seconds (before, after, before again), until they are quiet or time is up.

    All orders take turns, so that what disturbs the machine disturbs all three alike."""
    rounds = []
    end = time.monotonic() + args.limit
    for order in itertools.cycle(itertools.permutations(range(3))):
        times = [0.0] * 3
        for place in order:
            times[place] = seconds(programs[place], case, args)
        rounds.append(tuple(times))
        quiet = noise(rounds) <= ENOUGH * case.tolerance
        if len(rounds) >= args.pairs and (quiet or time.monotonic() > end):
            return rounds


def passes(programs, case, args):
    """Whether the case was run by both builds and has not become slower; prints its row."""
    try:
        rounds = measure(programs, case, args)
    except NotRun as error:
        print(f"{case.name:26}not run by both: {error}", flush=True)
        return False
    ratio, scatter, word = verdict(rounds, case.tolerance)
    before, after, _ = (1000 * statistics.median(column) for column in zip(*rounds))
    print(
        f"{case.name:26}{before:>8.2f} ms{after:>8.2f} ms{ratio:>14.3f}{case.tolerance:>11.3f}"
        f"{scatter:>8.3f}{len(rounds):>8}  {word}",
        flush=True,
    )
    return word != "SLOWER"


def named_number(text):
    """NAME=VALUE, or VALUE with the empty name."""
    name, _, value = text.rpartition("=")
    return name, float(value)


def parse_arguments(arguments):
    mark = arguments.index("--") if "--" in arguments else len(arguments)
    parser = argparse.ArgumentParser(
        usage="%(prog)s before after [options] [-- OPTIONS of both builds]",
        description=__doc__.splitlines()[0],
    )
    parser.add_argument("before", help="the build to compare with")
    parser.add_argument("after")
    parser.add_argument("--cases", default="", help="only cases whose name contains this")
    parser.add_argument("--pairs", type=int, default=6, help="rounds at least")
    parser.add_argument("--limit", type=float, default=60, help="seconds for more rounds")
    parser.add_argument("--runs", type=int, default=3, help="runs of each process")
    parser.add_argument("--seconds", type=float, default=0.5, help="more, until they took so long")
    parser.add_argument(
        "--tolerance", type=named_number, action="append", default=[], metavar="[NAME=]VALUE",
        help="of one case, or of all that have none by name; may be given again",
    )
    args = parser.parse_args(arguments[:mark])
    args.options = arguments[mark + 1 :]
    names = [case.name for case in OWN_CASES] + MESH_NAMES
    unknown = {name for name, _ in args.tolerance} - {"", *names}
    if unknown:
        parser.error(f"--tolerance: no case is named {', '.join(sorted(unknown))}")
    if not any(args.cases in name for name in names):
        parser.error(f"--cases: no case has {args.cases!r} in its name")
    return args


def select_cases(args):
    """Those asked for, with the tolerances asked for. Says which are skipped."""
    folder = os.environ.get(MESHES_VARIABLE)
    cases = OWN_CASES + (mesh_cases(Path(folder).resolve()) if folder else [])
    skipped = [] if folder else [name for name in MESH_NAMES if args.cases in name]
    if skipped:
        print(f"{MESHES_VARIABLE} is not set: skipped: {'; '.join(skipped)}", flush=True)
    given = dict(args.tolerance)
    return [
        replace(case, tolerance=given.get(case.name, given.get("", case.tolerance)))
        for case in cases
        if args.cases in case.name
    ]


def main():
    args = parse_arguments(sys.argv[1:])
    cases = select_cases(args)
    print(
        f"{'case':26}{'before':>11}{'after':>11}{'after/before':>14}{'tolerance':>11}"
        f"{'noise':>8}{'rounds':>8}",
        flush=True,
    )
    programs = (args.before, args.after, args.before)
    passed = [passes(programs, case, args) for case in cases]
    return 0 if all(passed) else 1


if __name__ == "__main__":
    sys.exit(main())
