# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether results hold as they are stored: the faces that meet others wrongly or have no area, of
the pairs of fold_pairs.py, this project's four blocks beside other libraries' unions.

in: the built plugin; out: a table in Markdown: as delivered in double / with the coordinates
rounded to floats afterwards, and of a host in float as delivered. With --angles, of some cuts the
histograms of the faces' smallest angles, and how many faces are thin. Each system runs in its own
process, so that a crash or a run over the limit is an entry of the table and not the end.
"""

import argparse
import json
import signal
import subprocess
import sys
from pathlib import Path

import numpy as np

from chain_worker import (
    BLOCKS, CORE_BLOCKS, FloatHost, fold_pairs, judges, peers, sentence_of,
)
from chains import PLUGIN, shortened
from compare import OPERATION_SIGNS, markdown, processor
from floors import write_between

PEERS = ("Manifold", "trueform", "CGAL", "MeshLib", "libigl")
OWN = ("here", "float host", "before")
SIGNS = {**OPERATION_SIGNS, "first_minus_second": "A−B", "second_minus_first": "B−A"}
ANGLES = (0, 1e-9, 1e-6, 1e-3, 0.01, 0.1, 1, 5, 10, 20, 30, 60)  # degrees
LOOKS = {  # in the figure; curves that agree shall all be seen
    "here": {"fill": True, "color": "tab:blue", "alpha": 0.45},
    "before": {"fill": True, "color": "tab:red", "alpha": 0.35},
    "trueform": {"color": "black", "linewidth": 1.6},
    "CGAL": {"color": "gold", "linewidth": 1.6, "linestyle": (0, (2, 2))},
    "Manifold": {"color": "tab:green", "linewidth": 1.2},
}
DRAWN = np.logspace(-16, np.log10(60), 90)  # degrees; smaller angles are drawn as the smallest


# --- in the process of a system -------------------------------------------------------------------


class AllBlocks(peers.IndexBooleanFilter):
    """This project's filter: the four blocks by name."""

    def blocks(self):
        self.prepare()
        result = self.document.apply_filter("generate_index_boolean", first_mesh=0, second_mesh=1)
        return {block: self.arrays(int(result[f"{block}_layer"])) for block in BLOCKS}


def blocks_by(system, operands, wanted):
    """{block: (V, F)}: all four of this project, the one that is wanted of a peer."""
    if system in OWN:
        host = FloatHost if system == "float host" else AllBlocks
        return host(*operands, "union").blocks()
    peer = peers.PEERS[system](*operands, wanted)
    return {wanted: peer.arrays(peer.run())}


def work(args):
    """Prints what a system makes of a pair, as JSON."""
    peers.IndexBooleanFilter.plugin = args.plugin
    FloatHost.program = args.core_blocks
    signal.setitimer(signal.ITIMER_REAL, args.limit)
    try:
        blocks = blocks_by(args.worker, fold_pairs.load_pair(args.pair), args.block)
    except Exception as error:
        peers.emit(error=sentence_of(error))
        return
    signal.setitimer(signal.ITIMER_REAL, 0)
    if args.angles:
        peers.emit(**angles_of(*blocks[args.block]))
        return
    peers.emit(blocks={block: judgement(*mesh) for block, mesh in blocks.items()})


def judgement(points, triangles):
    """Wrong faces as stored but for those with equal corners, wrong faces as floats, needles, those
    with equal corners, all faces."""
    stored, rounded = judges.judge(points, triangles), judges.judge_as_float(points, triangles)
    collapsed = len(stored.collapsed)
    return [stored.meeting, len(rounded.wrong), stored.needles, collapsed, len(triangles)]


def angles_of(points, triangles):
    """How many faces have their smallest angle in each span of ANGLES, and of DRAWN."""
    angles = judges.smallest_angles(points, triangles)
    found = np.histogram(angles, bins=[*ANGLES[:-1], np.inf])[0]
    drawn = np.histogram(np.clip(angles, *DRAWN[[0, -2]]), bins=DRAWN)[0]
    return {
        "faces": len(triangles), "angles": found.tolist(), "drawn": drawn.tolist(),
        "median": float(np.median(angles)), "least": float(angles.min()),
        "needles": judges.needles(points, triangles),
    }


# --- the tables -----------------------------------------------------------------------------------


def ask(args, system, pair):
    """What the process of a system prints; or {"error": why it printed nothing}."""
    plugin = args.before if system == "before" else args.plugin
    command = [
        sys.executable, __file__, "--worker", system, "--pair", pair, "--block", args.block,
        "--limit", str(args.limit), "--plugin", plugin, "--core-blocks", args.core_blocks,
    ] + (["--angles", pair] if args.angles else [])
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    for line in done.stdout.splitlines():
        if line.startswith("{"):
            return json.loads(line)
    if done.returncode == -signal.SIGALRM:
        return {"error": f"> {args.limit:g} s"}
    name = signal.Signals(-done.returncode).name if done.returncode < 0 else "no result"
    return {"error": name}


def cell(answer, system):
    """The blocks' wrong faces: as stored / as floats; a host in float stores floats."""
    if "error" in answer:
        return shortened(answer["error"], 40)
    blocks = answer["blocks"].values()
    stored = [f"{block[0]}+{block[3]}" if block[3] else str(block[0]) for block in blocks]
    if system == "float host":
        return ", ".join(stored)
    return ", ".join(f"{text}/{block[1]}" for text, block in zip(stored, blocks))


def needles_cell(answer):
    return "" if "error" in answer else ", ".join(str(b[2]) for b in answer["blocks"].values())


def pair_line(args, pair, answers):
    line = [pair]
    for system in args.systems:
        line.append(cell(answers[system], system))
        if system == "here":
            line.append(needles_cell(answers[system]))
    return line


def hold_page(args, lines):
    own = {"here": ["here ∪, ∩, A−B, B−A", "its needles"], "float host": ["in a float host"]}
    headers = ["pair"]
    for system in args.systems:
        headers += own.get(system, [f"{system} {SIGNS[args.block]}"])
    return (
        f"{processor()}. Faces that meet others in more than common corners and edges, or have no "
        "area: as delivered in double / with the coordinates rounded to floats afterwards. "
        "After a +: faces with two corners in one place, which rounding takes away.\n\n"
        + markdown(headers, lines) + "\n"
    )


def angle_page(args, pair, answers):
    spans = [f"below {high:g}°" for high in ANGLES[1:]]
    lines = []
    for system, answer in answers.items():
        if "error" in answer:
            lines.append([system, shortened(answer["error"], 40)] + [""] * (len(spans) + 1))
            continue
        counts = [str(count) if count else "" for count in answer["angles"]]
        lines.append([system, str(answer["faces"]), f"{answer['median']:.3g}°", *counts])
    title = f"{pair}, {SIGNS[args.block]}: faces by their smallest angle, each counted once"
    return f"{title}\n\n" + markdown(["system", "faces", "median", *spans], lines) + "\n"


def thin_table(args, everything):
    """A line for each cut: of each system, how many of its faces are thin, and the least angle."""
    def figures(answer):
        if "error" in answer:
            return shortened(answer["error"], 40)
        return f"{answer['needles']} of {answer['faces']}, {answer['least']:.2g}°"

    lines = [[pair, *map(figures, answers.values())] for pair, answers in everything.items()]
    return markdown([f"cut, {SIGNS[args.block]}", *args.systems], lines)


def plot_angles(args, everything):
    """A panel for each cut: how many faces of each system have their smallest angle where."""
    from matplotlib import pyplot

    columns = min(len(everything), 2)
    rows = -(-len(everything) // columns)
    figure, panels = pyplot.subplots(
        rows, columns, figsize=(4.5 * columns, 2.6 * rows), layout="constrained", squeeze=False,
        sharex=True,
    )
    for axes, (pair, answers) in zip(panels.flat, everything.items()):
        for system, answer in answers.items():
            if "error" not in answer:
                axes.stairs(answer["drawn"], DRAWN, label=system, **LOOKS.get(system, {}))
        axes.set(xscale="log", yscale="symlog", ylim=(0, None), title=pair)
        axes.grid(alpha=0.3)
    for axes in panels[-1]:
        axes.set_xlabel("smallest angle, degrees")
    for axes in panels[:, 0]:
        axes.set_ylabel("faces")
    panels[0, 0].legend(loc="upper left", fontsize="small")
    figure.savefig(args.plot)


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    add = parser.add_argument
    add("--pairs", default="", help="only pairs whose name contains this")
    add("--systems", default=",".join((*OWN[:2], *PEERS[:-1])), help="comma-separated")
    add("--block", default=None, choices=BLOCKS[:3], help="of the peers; default: union")
    add("--angles", metavar="PAIRS", help="histograms of some pairs' smallest angles, of A − B: "
        "their names, separated by semicolons")
    add("--plot", type=Path, help="with --angles: the figure to write")
    add("--thin", type=Path, help="with --angles: a page with marks for the table of thin faces")
    add("--limit", type=float, default=60, help="seconds for a system and a pair")
    add("--page", type=Path, help="file for the table, in Markdown")
    add("--json", type=Path, help="file for all figures")
    add("--plugin", default=str(PLUGIN), help="the plugin's file")
    add("--before", help="an older plugin's file, for the system 'before'")
    add("--core-blocks", default=str(CORE_BLOCKS), help="the built core_blocks, for the float host")
    add("--worker", help=argparse.SUPPRESS)
    add("--pair", help=argparse.SUPPRESS)
    args = parser.parse_args()
    args.systems = args.systems.split(",")
    unknown = set(args.systems) - {*OWN, *PEERS}
    if unknown:
        parser.error(f"no system {', '.join(sorted(unknown))}")
    if "before" in args.systems and not args.before:
        parser.error("the system before needs --before PLUGIN")
    args.block = args.block or ("first_minus_second" if args.angles else "union")
    return args


def chosen_pairs(args):
    """Those with the text in their names; other people's only where their folder is."""
    if args.angles:
        names = [name.strip() for name in args.angles.split(";")]
    else:
        names = [name for name in fold_pairs.PAIR_NAMES if args.pairs in name]
    unknown = set(names) - set(fold_pairs.PAIR_NAMES)
    if unknown or not names:
        sys.exit(f"there are the pairs {'; '.join(fold_pairs.PAIR_NAMES)}")
    folder = fold_pairs.placements.meshes_folder()
    absent = [name for name in names if fold_pairs.needs_meshes(name) and not folder]
    if absent:
        print(f"{fold_pairs.placements.MESHES_VARIABLE} is not set: left out are "
              f"{'; '.join(absent)}", file=sys.stderr)
    return [name for name in names if name not in absent]


def main():
    args = parse_arguments()
    if args.worker:
        return work(args)
    lines, pages, everything = [], [], {}
    for pair in chosen_pairs(args):
        answers = {}
        for system in args.systems:
            print(f"{pair}: {system}", file=sys.stderr, flush=True)
            answers[system] = ask(args, system, pair)
        everything[pair] = answers
        # After every pair, so that a run that is ended early leaves what it has.
        if args.angles:
            pages.append(angle_page(args, pair, answers))
            text = "\n".join([*pages, thin_table(args, everything)])
        else:
            lines.append(pair_line(args, pair, answers))
            text = hold_page(args, lines)
        if args.page:
            args.page.write_text(text, encoding="utf-8")
        if args.json:
            args.json.write_text(json.dumps(everything, indent=1) + "\n", encoding="utf-8")
    print(text)
    if args.angles and args.plot:
        plot_angles(args, everything)
    if args.angles and args.thin:
        write_between(args.thin, "thin", [thin_table(args, everything)])


if __name__ == "__main__":
    main()
