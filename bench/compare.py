# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the core and the filter beside other libraries on the same arrays and cores.

in: the built benchmark and plugin, and the folder of INDEXBOOLEAN_MESHES; out: compare.json and
compare.md (also printed): medians and ratios. Each peer runs in its own process, so that a crash
or a run over the limit is an entry of the table and not the end.
"""

import argparse
import contextlib
import json
import os
import platform
import signal
import statistics
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

from rich import box
from rich.console import Console
from rich.table import Table

from mesh_pairs import MESHES_VARIABLE, ember_pairs, standard_pair

HERE = Path(__file__).resolve().parent
LIBRARIES = ["trueform", "MeshLib", "Manifold", "CGAL", "libigl", "VTK"]
FILTERS = ["filter", "MeshLab"]
SPLITTERS = ["trueform_arrangement", "trueform_cells"]  # of the peer trueform
VOLUME_TOLERANCE = 1e-6  # some peers compute in float32
ROUNDING = 1e-15  # of the sum that is a volume; operands are about of size 1
# What hosts do by default: operands are searched for faces that meet wrongly, results certified.
DEFAULTS = ["--resolve", "--certify", "--one-operation"]
OPERATION_SIGNS = {
    "union": "∪", "intersection": "∩", "first_minus_second": "−", "split": "cut by",
}


@dataclass
class Case:
    name: str  # with {} for the operation's sign
    operation: str
    arguments: list  # of index_boolean_bench
    files: tuple = ()

    def title(self):
        return self.name.format(OPERATION_SIGNS[self.operation])


def sphere_cases(faces):
    size = f"{round(faces / 1000)}k" if faces >= 1000 else str(faces)
    return [
        Case(f"sphere {{}} sphere (2 × {size})", "union", ["--spheres", str(faces)]),
        Case(f"cube {{}} sphere ({size})", "first_minus_second", ["--cube-and-sphere", str(faces)]),
    ]


def twin_cases(faces):
    """A sphere and itself: in one place, almost in one place."""
    size = f"{round(faces / 1000)}k" if faces >= 1000 else str(faces)

    def twin(name, *transform):
        arguments = ["--twin-spheres", str(faces)]
        if transform:
            arguments += ["--transform-second", ",".join(map(str, transform))]
        return Case(f"sphere {{}} {name} ({size})", "first_minus_second", arguments)

    return [
        twin("itself"),
        twin("itself shifted by 1e-8", 1, 0, 0, 1e-8, 0, 1, 0, 0, 0, 0, 1, 0),
        twin("itself turned by 1e-7", 1, -1e-7, 0, 0, 1e-7, 1, 0, 0, 0, 0, 1, 0),
    ]


def plate_case(holes):
    """Two huge walls with many holes: components, and faces that are cut into many pieces."""
    name = f"plate {{}} {holes} prisms ({holes * 0.128:.3g}k)"
    return Case(name, "first_minus_second", ["--plate", str(holes)])


def box_case():
    """As small as solids get: what a call costs."""
    return Case("box {} box (2 × 12 faces)", "first_minus_second", ["--boxes"])


def wall_case(squares):
    """Two boxes with a wall in common: all contacts are overlaps of coplanar faces."""
    name = f"box {{}} box beside it (walls of {squares} × {squares})"
    return Case(name, "union", ["--grid-boxes", str(squares)])


def terrain_case(faces):
    """Two open surfaces, which are split."""
    sheet = faces // 10
    name = f"terrain {{}} sheet ({faces / 1000:.4g}k, {sheet / 1000:.4g}k)"
    return Case(name, "split", ["--terrain", str(faces), str(sheet)])


def mesh_cases(folder):
    def pair(name, operation, first, second):
        files, arguments = standard_pair(folder, first, second)
        return Case(name, operation, arguments, files)

    cases = [
        pair("armadillo {} bunny100k", "first_minus_second", "armadillo.obj", "bunny100k.obj"),
        pair("fertility {} itself, moved", "union", "fertility.obj", "fertility.obj"),
        pair("falconstatue {} skull", "intersection", "falconstatue.obj", "skull.obj"),
    ]
    for files, arguments in ember_pairs(folder):
        name = f"{files[0].stem} {{}} {files[1].stem}"
        cases.append(Case(name, "first_minus_second", arguments, files))
    return cases


@contextlib.contextmanager
def busy(count):
    """That many processes which compute meanwhile, on the cores that this one may use."""
    others = [subprocess.Popen([sys.executable, "-c", "while True: pass"]) for _ in range(count)]
    try:
        yield
    finally:
        for other in others:
            other.kill()
            other.wait()


def run_core(args, case, arrays, options=()):
    """The JSON of index_boolean_bench, or {"error": ...}."""
    operation = ["--split"] if case.operation == "split" else ["--operation", case.operation]
    command = [
        args.bench, *case.arguments, *operation, *options,
        "--runs", str(args.runs), "--seconds", str(args.seconds), "--save-arrays", str(arrays),
    ]
    try:
        done = subprocess.run(
            command, capture_output=True, text=True, timeout=args.limit * 2 * (args.runs + 1)
        )
    except subprocess.TimeoutExpired:
        return {"cut": args.limit}
    if done.returncode < 0:
        return {"error": signal.Signals(-done.returncode).name}
    if not done.stdout:
        return {"error": done.stderr.strip()}
    core = json.loads(done.stdout)
    if core["status"] != "ok":
        core["error"] = core["status"]
    return core


def run_peer(args, name, case, arrays):
    """What peers.py measured: median seconds and figures, or why there are none."""
    command = [
        sys.executable, str(HERE / "peers.py"), name, str(arrays), case.operation,
        "--runs", str(args.runs), "--seconds", str(args.seconds), "--limit", str(args.limit),
        "--plugin", args.plugin,
    ]
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    seconds, peer = [], {}
    for line in done.stdout.splitlines():
        if not line.startswith("{"):  # a library's own chatter
            continue
        values = json.loads(line)
        if "seconds" in values:
            seconds.append(values["seconds"])
        else:
            peer.update(values)
    if done.returncode == -signal.SIGALRM:
        peer["cut"] = args.limit
    elif done.returncode < 0:
        peer["error"] = signal.Signals(-done.returncode).name
    elif done.returncode > 0 and "error" not in peer:
        peer["error"] = f"exit status {done.returncode}"
    if seconds:
        peer.update(seconds=statistics.median(seconds), seconds_each_run=seconds)
    return peer


def peers_for(case, peers):
    """Those of the peers that can do it."""
    if case.operation != "split":
        return peers
    return SPLITTERS if "trueform" in peers else []


def measure(args, case):
    arrays = args.out / "arrays"
    row = {"case": case.title(), "operation": case.operation, "peers": {}}
    print(f"{row['case']}: core", end="", file=sys.stderr, flush=True)
    row["core"] = run_core(args, case, arrays)
    row["defaults"] = run_core(args, case, arrays, DEFAULTS) if case.operation != "split" else {}
    for name in peers_for(case, args.peers):
        print(f", {name}", end="", file=sys.stderr, flush=True)
        row["peers"][name] = run_peer(args, name, case, arrays)
    print(file=sys.stderr)
    return row


def duration(seconds):
    return f"{seconds * 1000:.3g} ms" if seconds < 0.9995 else f"{seconds:.3g} s"


def reference_volume(row):
    """The core's volume, or the peers' median where the core gives none."""
    if row["operation"] == "split":
        return row["core"].get("split", {}).get("sub_blocks_volume")
    core = row["core"].get("one_operation", {}).get("blocks", {}).get(row["operation"])
    volumes = [peer["volume"] for peer in row["peers"].values() if "volume" in peer]
    return core["volume"] if core else statistics.median(volumes) if volumes else None


def peer_cell(row, name, *bases):
    """Seconds and their ratios to `bases`, with * for a wrong volume and ! for an open surface."""
    peer = row["peers"].get(name)
    if peer is None:
        return ""
    if "cut" in peer:
        return f"> {duration(peer['cut'])}{multiples(peer['cut'], bases, '> ', 0)}"
    if "error" in peer:
        return peer["error"][:40]
    return f"{duration(peer['seconds'])}{marks(row, peer)}{multiples(peer['seconds'], bases)}"


def multiples(seconds, bases, sign="", digits=1):
    ratios = [f"{sign}{seconds / base:.{digits}f}×" for base in bases if base]
    return f" ({', '.join(ratios)})" if ratios else ""


def marks(row, peer):
    """None for a result that bounds nothing."""
    if "volume" not in peer:
        return ""
    reference = reference_volume(row)
    right = reference is None or (
        abs(peer["volume"] - reference) <= VOLUME_TOLERANCE * abs(reference) + ROUNDING
    )
    if "cells" in peer and "split" in row["core"]:
        right = right and peer["cells"] == row["core"]["split"]["sub_blocks"]
    return ("" if right else "*") + ("" if peer["closed"] else "!")


def core_seconds(row, which, key="seconds_without_audit", run="core"):
    return None if "error" in row[run] else row[run].get(which, {}).get(key)


def core_cell(row, which, key="seconds_without_audit", run="core"):
    seconds = core_seconds(row, which, key, run)
    if seconds is not None:
        return duration(seconds)
    return row[run].get("error") or f"> {duration(row[run]['cut'])}"


def markdown(headers, rows):
    """A Markdown table that is aligned to be read as plain text too."""
    table = Table(*headers, box=box.MARKDOWN)
    for row in rows:
        table.add_row(*row)
    console = Console(width=1000, color_system=None, markup=False)
    with console.capture() as text:
        console.print(table)
    return "\n".join(line.strip() for line in text.get().splitlines() if line.strip())


def library_table(rows, peers):
    names = [name for name in LIBRARIES if name in peers]
    table = []
    for row in rows:
        bases = [core_seconds(row, "one_operation", run=run) for run in ("defaults", "core")]
        table.append(
            [
                row["case"], core_cell(row, "one_operation", run="defaults"),
                core_cell(row, "one_operation"), core_cell(row, "one_operation", "seconds"),
                core_cell(row, "four_blocks"),
            ]
            + [peer_cell(row, name, *bases) for name in names]
        )
    headers = ["case", "all defaults", "bare", "bare, with its audit", "bare, all four", *names]
    return markdown(headers, table)


def split_table(rows):
    table = []
    for row in rows:
        base = core_seconds(row, "split")
        peers = [peer_cell(row, name, base) for name in SPLITTERS]
        table.append(
            [row["case"], core_cell(row, "split"), core_cell(row, "split", "seconds"), *peers]
        )
    headers = [
        "case", "core, all sub-surfaces and sub-blocks", "with their audit",
        "trueform, arrangement",
        "trueform, arrangement and cells",
    ]
    return markdown(headers, table)


def filter_table(rows):
    table = []
    for row in rows:
        base = row["peers"]["filter"].get("seconds")
        others = [peer_cell(row, name, base) for name in ("MeshLab", "trueform")]
        table.append([row["case"], peer_cell(row, "filter", None), *others])
    headers = [
        "case", "generate_index_boolean, all four layers",
        "MeshLab's own filter, one layer", "trueform, one operation",
    ]
    return markdown(headers, table)


def processor():
    lines = Path("/proc/cpuinfo").read_text().splitlines()
    names = [line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")]
    return names[0] if names else platform.processor()


def busy_words(count):
    return f", with {count} busy processes beside each" if count else ""


def report(machine, rows, peers):
    parts = [
        f"{machine['processor']}, {machine['cores']} cores, load {machine['load']:.1f} at the "
        f"start. Medians of {machine['runs']} runs after a warm-up (of one run where it takes more "
        f"than 10 s; of as many as take {machine['seconds']} s where these are more)"
        f"{busy_words(machine['busy'])}. In parentheses: the time as a multiple of the core's; in "
        "the first table of its run with all defaults, operands searched and the result "
        "certified, and of its bare run, which does neither, as the peers do. "
        "`*` the volume is off by more than 1e-6 of itself or cells are too many or few, `!` the "
        "result is not closed.",
    ]
    booleans = [row for row in rows if row["operation"] != "split"]
    splits = [row for row in rows if row["operation"] == "split"]
    if booleans:
        parts.append("Arrays in, arrays out, fresh meshes:\n\n" + library_table(booleans, peers))
    if splits:
        parts.append("Open surfaces, arrays in, arrays out:\n\n" + split_table(splits))
    if booleans and "filter" in peers:
        parts.append("Filter calls in pymeshlab, layers to layers:\n\n" + filter_table(booleans))
    versions = {
        peer["package"]: peer["version"]
        for row in rows for peer in row["peers"].values() if "version" in peer
    }
    parts.append(", ".join(f"{name} {number}" for name, number in sorted(versions.items())))
    return "\n\n".join(part for part in parts if part) + "\n"


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    add = parser.add_argument
    add("--bench", required=True, help="the built index_boolean_bench")
    add("--plugin", default="", help="the built plugin; without it the filters are left out")
    add("--out", type=Path, default=Path("out/bench"), help="folder of the results")
    add("--peers", help="comma-separated, default: all; none: the core alone")
    add("--cases", default="", help="only cases whose title contains this")
    add("--spheres", type=int, default=328000, help="faces of the generated spheres")
    add("--terrain", type=int, default=1000000, help="faces of the generated terrain")
    add("--runs", type=int, default=5)
    # Medians of five calls of a tenth of a millisecond scatter by more than half.
    add("--seconds", type=float, default=0.25, help="more runs, until they took that long in all")
    add("--limit", type=float, default=120, help="seconds that one run may take")
    add("--cores", type=int, default=2)
    add("--busy", type=int, default=0, help="processes that compute beside all that is measured")
    args = parser.parse_args()
    known = LIBRARIES + (FILTERS if args.plugin else [])
    args.peers = known if args.peers is None else [p for p in args.peers.split(",") if p != "none"]
    unknown = set(args.peers) - set(known)
    if unknown:
        parser.error(f"unknown or without --plugin: {', '.join(sorted(unknown))}")
    return args


def select_cases(spheres, terrain, name):
    """Those with `name` in their titles, with spheres and a terrain of about that many faces."""
    cases = [
        *sphere_cases(spheres), *sphere_cases(4 * spheres)[:1], *twin_cases(spheres // 4),
        wall_case(64), plate_case(100), plate_case(2500), box_case(), terrain_case(terrain),
    ]
    folder = os.environ.get(MESHES_VARIABLE)
    if folder:
        cases += mesh_cases(Path(folder).resolve())
    else:
        print(f"{MESHES_VARIABLE} is not set: only generated spheres", file=sys.stderr)
    cases = [case for case in cases if name in case.title()]
    if not cases:
        sys.exit(f"no case has {name!r} in its title")
    return cases


def main():
    args = parse_arguments()
    cores = sorted(os.sched_getaffinity(0))[: args.cores]
    os.sched_setaffinity(0, cores)  # inherited by all that is measured
    machine = {
        "processor": processor(), "cores": len(cores), "load": os.getloadavg()[0],
        "runs": args.runs, "seconds": args.seconds, "limit": args.limit, "busy": args.busy,
    }
    args.out.mkdir(parents=True, exist_ok=True)
    rows = []
    for case in select_cases(args.spheres, args.terrain, args.cases):
        with busy(args.busy):
            rows.append(measure(args, case))
        # After every case, so that a run that is ended early leaves what it has.
        results = json.dumps({"machine": machine, "rows": rows}, indent=1)
        (args.out / "compare.json").write_text(results + "\n", encoding="utf-8")
        text = report(machine, rows, args.peers)
        (args.out / "compare.md").write_text(text, encoding="utf-8")
    print(text)
    return 0


if __name__ == "__main__":
    sys.exit(main())
