# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a call costs: the median time of a union of two small solids, of the core and of its peers.

in: index_boolean_bench, which makes the pairs; out: a Markdown table, printed. Each pair runs once
to warm up, then again, timed, from arrays to arrays; a peer runs in a process of its own. What
Python adds to a peer's call, a few microseconds, is in its time.
"""

import argparse
import json
import signal
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

import peers
from compare import duration, markdown

NAMES = ["trueform", "MeshLib", "Manifold", "CGAL", "libigl", "filter"]
CLOSE = 1e-6  # of the volume: peers with single precision are right within that


def run_core(args, folder):
    command = [args.bench, "--small-pairs", str(args.pairs), "--save-arrays", str(folder)]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    return json.loads(done.stdout)["small_pairs"]


def time_peer(name, folder, plugin):
    """Prints the seconds of each pair's second run and the result's volume; null if it failed."""
    peers.IndexBooleanFilter.plugin = plugin
    for pair in sorted(Path(folder).iterdir(), key=lambda path: int(path.name)):
        operands = [peers.load_operand(pair, number) for number in range(2)]
        try:
            peer = peers.PEERS[name](*operands, "union")
            peers.timed_run(peer, 0)
            seconds, result = peers.timed_run(peer, 0)
            print(json.dumps([seconds, peer.figures(result)["volume"]]), flush=True)
        except Exception:
            print("null", flush=True)


def run_peer(args, name, folder):
    command = [
        sys.executable, __file__, "--time", name, "--folder", str(folder), "--plugin", args.plugin,
    ]
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    lines = [line for line in done.stdout.splitlines() if line == "null" or line[:1] == "["]
    note = signal.Signals(-done.returncode).name if done.returncode < 0 else ""
    return [json.loads(line) for line in lines], note


def peer_row(name, results, note, core):
    done = [result for result in results if result]
    wrong = sum(
        result is not None and abs(result[1] - volume) > CLOSE * max(1.0, abs(volume))
        for result, volume in zip(results, core["volumes"])
    )
    failed = len(core["volumes"]) - len(done)
    if not done:
        return [name, note or "failed", "", "", str(failed)]
    seconds = statistics.median(result[0] for result in done)
    ratio = f"{seconds / core['seconds_without_audit']:.3g}×"
    return [name, duration(seconds), ratio, str(wrong), f"{failed} {note}".strip()]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--bench", default="build/release/bench/index_boolean_bench")
    parser.add_argument("--pairs", type=int, default=500)
    parser.add_argument("--peers", default=",".join(NAMES))
    parser.add_argument("--plugin", default="", help="the plugin's file, for the peer 'filter'")
    parser.add_argument("--time", help=argparse.SUPPRESS)
    parser.add_argument("--folder", help=argparse.SUPPRESS)
    args = parser.parse_args()
    if args.time:
        time_peer(args.time, args.folder, args.plugin)
        return
    with tempfile.TemporaryDirectory() as folder:
        core = run_core(args, folder)
        rows = [
            ["core", duration(core["seconds_without_audit"]), "", "0", "0"],
            ["core, with its audit", duration(core["seconds"]), "", "0", "0"],
        ]
        for name in args.peers.split(","):
            rows.append(peer_row(name, *run_peer(args, name, folder), core))
    headers = ["", f"median of {args.pairs} pairs", "times the core", "wrong volume", "no result"]
    print(markdown(headers, rows))


if __name__ == "__main__":
    main()
