# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Chains, in which each result is the next step's first operand: how far this project and other
libraries come, and what their last surfaces are worth.

in: the built plugin; out: a table for each kind of chain, on the page and printed, and JSON with
each step. Each system runs in its own process, so that a crash or a run over the limit is an entry
of the table and not the end. The last result is judged as it is stored and with its coordinates
rounded to floats; its volume is compared with the closed form, or with libigl's on the operands of
the last step.
"""

import argparse
import json
import signal
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

from chain_worker import CORE_BLOCKS, STORAGES, SYSTEMS, chain_kinds, judges, libigl_volume
from compare import duration, markdown, processor

HERE = Path(__file__).resolve().parent
PLUGIN = HERE.parent / "build/release/hosts/pymeshlab/libfilter_indexboolean.so"
KINDS = chain_kinds.KINDS
JUDGED_FACES = 400_000  # a larger surface is not judged
WRONG = 1e-6  # of a volume, relative
HEADERS = [
    "system", "chains finished", "steps", "seconds in sum", "faces", "volume off by",
    "wrong faces, as stored / as floats", "first wrong at step", "stopped by",
]


# --- running --------------------------------------------------------------------------------------


def run_chain(args, kind, seed, system):
    """What a system makes of a chain: its steps, how it ended, and its last result's figures."""
    with tempfile.TemporaryDirectory() as folder:
        keep = Path(folder) / "last.npz"
        done = subprocess.run(
            worker_command(args, kind, seed, system, keep),
            stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True,
        )
        lines = [json.loads(line) for line in done.stdout.splitlines() if line.startswith("{")]
        row = {"kind": kind, "seed": seed, "system": system}
        row["steps"] = [line for line in lines if "seconds" in line]
        row["stopped"] = ending(args, lines, done.returncode)
        if row["steps"] and keep.exists():
            row.update(judged(keep, row["steps"][-1]))
    return row


def worker_command(args, kind, seed, system, keep):
    command = [
        sys.executable, str(HERE / "chain_worker.py"), kind, system, "--seed", str(seed),
        "--limit", str(args.limit), "--plugin", args.plugin, "--core-blocks", args.core_blocks,
        "--storage", storage_of(args, kind), "--keep", str(keep),
    ]
    if args.steps:
        command += ["--steps", str(args.steps)]
    return command + [f"--{name}" for name in ("check", "folds") if getattr(args, name)]


def storage_of(args, kind):
    return "float" if args.float else args.storage or KINDS[kind].storage


def ending(args, lines, status):
    """None if the chain is finished; else why it is not, in a sentence."""
    last = lines[-1] if lines else {}
    if last.get("done"):
        return None
    if "refused" in last:
        return last["refused"]
    if "cut" in last or status == -signal.SIGALRM:
        return f"more than {args.limit:g} s"
    return signal.Signals(-status).name if status < 0 else f"exit status {status}"


def judged(path, last):
    """Of the last result: the relative error of its volume, and its faces that are wrong."""
    with np.load(path) as kept:
        result, *operands = (
            (kept[f"points{end}"], kept[f"triangles{end}"]) for end in ("", "_0", "_1")
        )
        operation = str(kept["operation"])
    figures = {"off": None}
    expected = last["expected"]
    if expected is None:
        expected = last.get("libigl") or libigl_volume(operands, operation)
    if expected:
        figures["off"] = abs(last["volume"] / expected - 1)
    if len(result[1]) <= JUDGED_FACES:
        figures["wrong"] = judges.judge(*result).meeting
        figures["wrong_as_float"] = judges.judge_as_float(*result).meeting
    return figures


def first_wrong(row):
    """The first step whose result has folded; None if none was found."""
    return next((step["step"] for step in row["steps"] if step.get("wrong")), None)


def largest_error(row):
    """Of the last step, or of all that libigl was asked about."""
    errors = [abs(s["volume"] / s["libigl"] - 1) for s in row["steps"] if s.get("libigl")]
    return max([*errors, *([row["off"]] if row.get("off") is not None else [])], default=None)


# --- tables ---------------------------------------------------------------------------------------


def span(numbers):
    """One number, or the least and the greatest."""
    low, high = min(numbers, default=0), max(numbers, default=0)
    return f"{low}" if low == high else f"{low} to {high}"


def system_line(system, rows):
    """A line of a table: of one system, over all seeds."""
    finished = [row for row in rows if row["stopped"] is None]
    steps = [len(row["steps"]) for row in rows]
    seconds = [sum(step["seconds"] for step in row["steps"]) for row in rows]
    faces = [row["steps"][-1]["faces"] for row in rows if row["steps"]]
    errors = [error for error in map(largest_error, rows) if error is not None]
    wrong = [
        "?" if any(key not in row for row in rows if row["steps"])
        else span([row[key] for row in rows if row["steps"]])
        for key in ("wrong", "wrong_as_float")
    ]
    starts = [step for step in map(first_wrong, rows) if step is not None]
    reasons = sorted({row["stopped"] for row in rows if row["stopped"]})
    return [
        system, f"{len(finished)} of {len(rows)}", span(steps),
        duration(statistics.median(seconds)), span(faces),
        f"{max(errors):.1g}" if errors else "?", " / ".join(wrong),
        span(starts) if starts else "", shortened(reasons[0]) if reasons else "",
    ]


def shortened(sentence, length=90):
    text = sentence.replace("|", "/")
    return text if len(text) <= length else text[: length - 1] + "…"


def kind_part(args, kind, rows):
    """A kind's heading and table."""
    systems = [system for system in args.systems if any(r["system"] == system for r in rows)]
    table = [system_line(s, [row for row in rows if row["system"] == s]) for s in systems]
    seeds = f"{len(args.seeds)} seeds" if len(args.seeds) > 1 else f"seed {args.seeds[0]}"
    headers, keep = HEADERS, range(len(HEADERS))
    if not args.folds:
        keep = [column for column in keep if headers[column] != "first wrong at step"]
    table = [[line[column] for column in keep] for line in table]
    title = f"{kind}: {KINDS[kind].about} ({steps_of(args, kind)} steps, {seeds}, " \
        f"{storage_of(args, kind)})"
    return f"{title}\n\n" + markdown([headers[column] for column in keep], table)


def sums_part(args, rows):
    """Of each kind the seconds of all steps in sum, of the chains that every system finished."""
    unfinished = {(row["kind"], row["seed"]) for row in rows if row["stopped"]}
    rows = [row for row in rows if (row["kind"], row["seed"]) not in unfinished]
    wrong = {(row["kind"], row["seed"]) for row in rows if has_wrong_volume(row)}
    right = [row for row in rows if (row["kind"], row["seed"]) not in wrong]
    kinds = [kind for kind in args.kinds if any(row["kind"] == kind for row in rows)]
    parts = [(kind, [row for row in rows if row["kind"] == kind]) for kind in kinds]
    parts += [("in sum", rows), ("those without *, in sum", right)]
    lines = [sums_line(args.systems, name, chosen) for name, chosen in parts if chosen]
    table = markdown(["kind", "chains", *args.systems], lines)
    title = "Seconds of the chains that all of these systems finish; *: to a wrong volume"
    return f"{title}\n\n{table}"


def sums_line(systems, name, rows):
    """The seconds of the systems on the same chains, and multiples of the first's."""
    cells, first = [], None
    for system in systems:
        own = [row for row in rows if row["system"] == system]
        seconds = sum(step["seconds"] for row in own for step in row["steps"])
        first = first or seconds
        cell = duration(seconds) + ("*" if any(map(has_wrong_volume, own)) else "")
        cells.append(f"{cell} ({seconds / first:.2g}×)" if cells else cell)
    return [name, str(len({(row["kind"], row["seed"]) for row in rows})), *cells]


def has_wrong_volume(row):
    return (largest_error(row) or 0) > WRONG


def steps_of(args, kind):
    most = KINDS[kind].steps
    if args.steps is None:
        return most
    return args.steps if KINDS[kind].endless else min(args.steps, most)


def page(args, rows):
    head = (
        f"{processor()}. Each system is given {args.limit:g} s a chain; seconds are of all steps "
        "in sum, the median over the seeds. Wrong faces meet others in more than common corners "
        "and edges, or have no area; those with two corners in one place are not counted."
    )
    kinds = [kind for kind in args.kinds if any(row["kind"] == kind for row in rows)]
    tables = [kind_part(args, kind, [r for r in rows if r["kind"] == kind]) for kind in kinds]
    return "\n\n".join([head, *tables, sums_part(args, rows)]) + "\n"


def names_from(text, known, what, parser):
    names = list(known) if text is None else [name for name in text.split(",") if name]
    unknown = sorted(set(names) - set(known))
    if unknown:
        parser.error(f"no {what} {', '.join(unknown)}; there are {', '.join(known)}")
    return names


def seeds_from(text):
    """1,2,5-9 as numbers."""
    seeds = []
    for part in text.split(","):
        low, _, high = part.partition("-")
        seeds += range(int(low), int(high or low) + 1)
    return seeds


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    add = parser.add_argument
    add("--kinds", help=f"comma-separated, default: all of {', '.join(KINDS)}")
    add("--systems", help=f"comma-separated, default: all of {', '.join(SYSTEMS)}")
    add("--seeds", type=seeds_from, default=[1], help="such as 1,2,5-9")
    add("--steps", type=int, help="of each chain; default: each kind's own number")
    add("--limit", type=float, default=60, help="seconds for a system and a chain")
    add("--float", action="store_true", help="round each result to floats")
    add("--storage", choices=STORAGES, help="what each result goes through before the next step")
    add("--check", action="store_true", help="compare each step's volume with libigl's")
    add("--folds", action="store_true", help="find the first step with wrong faces")
    add("--json", type=Path, help="file for each step's figures")
    add("--page", type=Path, help="file for the tables, in Markdown")
    add("--plugin", default=str(PLUGIN), help="the plugin's file")
    add("--core-blocks", default=str(CORE_BLOCKS), help="the built core_blocks, for the float host")
    args = parser.parse_args()
    args.kinds = names_from(args.kinds, KINDS, "kind", parser)
    args.systems = names_from(args.systems, SYSTEMS, "system", parser)
    return args


def main():
    args = parse_arguments()
    rows = []
    for kind in args.kinds:
        for seed in args.seeds:
            for system in args.systems:
                print(f"{kind}, seed {seed}: {system}", file=sys.stderr, flush=True)
                rows.append(run_chain(args, kind, seed, system))
        # After every kind, so that a run that is ended early leaves what it has.
        if args.json:
            args.json.write_text(json.dumps(rows, indent=1) + "\n", encoding="utf-8")
        if args.page:
            args.page.write_text(page(args, rows), encoding="utf-8")
    print(page(args, rows))
    return 0


if __name__ == "__main__":
    sys.exit(main())
