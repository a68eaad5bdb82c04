# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares inputs made to be hard with the benchmark's spheres of as many faces, to find what grows
with more than an input's size.

in: the built benchmark; out: a Markdown table and the exit status, 1 if an input takes more than 3
times the time or 2 times the peak memory of the spheres. Both run in turn, in a few processes each,
so that what disturbs the machine disturbs both; figures are medians over the processes. An input
that takes more than --timeout or more than MOST_MEMORY has exceeded its limits.
"""

import argparse
import json
import resource
import statistics
import subprocess
import sys
from dataclasses import dataclass, field
from typing import List, Optional

TIME_LIMIT, MEMORY_LIMIT = 3, 2  # times what the spheres take
MOST_MEMORY = 10 << 30  # bytes of address space that a process is given
KIB = 1024


@dataclass
class Row:
    name: str
    option: str
    size: int
    both: List[str] = field(default_factory=list)  # arguments for the spheres too


ROWS = [
    Row("S2 tower of touching boxes", "--tower", 10000),
    Row("S3 wall of cubes across x", "--wall", 100),
    Row("S4 spheres with stray vertices", "--stray-spheres", 80000),
    Row("S5 cones, tip on tip", "--cones", 10000),
    Row("S7 polygon cut by a prism", "--polygon-plate", 300, ["--attributes"]),
    Row("S8 row of cubes, split", "--row", 5000, ["--split"]),
    Row("S10 pinwheel", "--pinwheel", 20000),
]


@dataclass
class Measured:
    """What a process, or the median of some, took; or why it has no result."""

    seconds: float = 0
    memory: int = 0  # peak, in bytes
    trouble: str = ""


def peak_memory(process):
    """Of a running process, in bytes; 0 where the system does not say."""
    try:
        with open(f"/proc/{process.pid}/status", encoding="ascii") as status:
            words = [line.split() for line in status if line.startswith("VmHWM:")]
    except OSError:
        return 0
    return int(words[0][1]) * KIB if words else 0


def limit_memory():
    resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, MOST_MEMORY))


def read_report(text):
    """The fastest run of a process: what disturbs only makes them slower."""
    report = json.loads(text)
    if report["status"] != "ok":
        return Measured(trouble=report["status"])
    part = report.get("one_operation") or report["split"]
    return Measured(min(part["seconds_each_run"]), part["peak_memory_bytes"])


def report_of(program, arguments, timeout):
    """What one process of the benchmark prints, which has to be done in time and without fault."""
    done = subprocess.run(
        [program, *arguments], capture_output=True, text=True, timeout=timeout,
        preexec_fn=limit_memory,
    )
    report = json.loads(done.stdout)
    if report["status"] != "ok":
        raise RuntimeError(f"{' '.join(arguments)}: {report['status']}")
    return report


def measure(program, arguments, timeout):
    """One process. Its memory is that of the program once it has its operands."""
    process = subprocess.Popen(
        [program, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
        preexec_fn=limit_memory,
    )
    try:
        out, err = process.communicate(timeout=timeout)
    except subprocess.TimeoutExpired:
        memory = peak_memory(process)
        process.kill()
        process.communicate()
        return Measured(timeout, memory, f"more than {timeout:g} s")
    try:
        return read_report(out)
    except (ValueError, KeyError):
        words = err.strip().splitlines()
        return Measured(trouble=words[-1] if words else f"exit status {process.returncode}")


def median(runs):
    """The medians of some processes; that of the first that failed, if one did."""
    for run in runs:
        if run.trouble:
            return run
    return Measured(
        statistics.median(run.seconds for run in runs),
        statistics.median(run.memory for run in runs),
    )


def faces_of(program, arguments):
    done = subprocess.run(
        [program, *arguments, "--sizes"], capture_output=True, text=True, check=True
    )
    return sum(operand["faces"] for operand in json.loads(done.stdout)["operands"])


def compare(row, args):
    """(Faces of the input, what it takes, what spheres take.)"""
    hard = [row.option, str(row.size)]
    faces = faces_of(args.program, hard)
    spheres = ["--spheres", str(max(1, faces // 2))]
    common = [*row.both, "--one-operation", "--runs", str(args.runs), "--threads",
              str(args.threads)]
    runs = {"hard": [], "spheres": []}
    for _ in range(args.processes):
        runs["spheres"].append(measure(args.program, [*spheres, *common], args.timeout))
        runs["hard"].append(measure(args.program, [*hard, *common], args.timeout))
        if runs["hard"][-1].trouble or runs["spheres"][-1].trouble:
            break
    return faces, median(runs["hard"]), median(runs["spheres"])


def ratio(hard, spheres) -> Optional[float]:
    return hard / spheres if hard and spheres else None


def verdict(hard, spheres):
    """What is exceeded, in words; none if nothing is."""
    if spheres.trouble:
        return [f"the spheres failed: {spheres.trouble}"]
    exceeded = [hard.trouble] if hard.trouble else []
    for what, limit in (("seconds", TIME_LIMIT), ("memory", MEMORY_LIMIT)):
        times = ratio(getattr(hard, what), getattr(spheres, what))
        if times is not None and times > limit:
            exceeded.append(f"{what} > {limit} times")
    return exceeded


def cells(hard, spheres, what, show):
    """An input's figure, the spheres', and the ratio; blank where there is none."""
    mine, theirs = getattr(hard, what), getattr(spheres, what)
    more = "> " if hard.trouble else ""
    times = ratio(mine, theirs)
    return [
        more + show(mine) if mine else "",
        show(theirs) if theirs else "",
        f"{more}{times:.1f}" if times is not None else "",
    ]


def show_seconds(seconds):
    return f"{seconds * 1e3:.1f} ms" if seconds < 1 else f"{seconds:.1f} s"


def table_line(row, faces, hard, spheres):
    columns = [row.name, str(faces)]
    columns += cells(hard, spheres, "seconds", show_seconds)
    columns += cells(hard, spheres, "memory", lambda m: f"{m / 1e6:.0f} MB")
    columns.append("; ".join(verdict(hard, spheres)) or "kept")
    return "| " + " | ".join(columns) + " |"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", help="the built index_boolean_bench")
    parser.add_argument("--cases", default="", help="only cases whose name contains this")
    parser.add_argument("--processes", type=int, default=3, help="of each, for the median")
    parser.add_argument("--runs", type=int, default=3, help="runs of each process")
    parser.add_argument("--threads", type=int, default=0, help="0: as many as there are")
    parser.add_argument("--timeout", type=float, default=60, help="seconds a process is given")
    args = parser.parse_args()

    rows = [row for row in ROWS if args.cases in row.name]
    if not rows:
        raise SystemExit(f"limits.py: no case has {args.cases!r} in its name")
    print(f"Limits: {TIME_LIMIT} times the time and {MEMORY_LIMIT} times the memory.\n")
    print("| input | faces | time | spheres | times | peak memory | spheres | times | limits |")
    print("|---|---|---|---|---|---|---|---|---|")
    exceeded = False
    for row in rows:
        faces, hard, spheres = compare(row, args)
        exceeded |= bool(verdict(hard, spheres))
        print(table_line(row, faces, hard, spheres), flush=True)
    return 1 if exceeded else 0


if __name__ == "__main__":
    sys.exit(main())
