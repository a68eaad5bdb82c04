# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs one chain with one system; chains.py starts it for each.

in: a kind of chain_kinds.py, a seed, a system; out: one JSON object per step, and in --keep the
last result with the operands of its step. A step that takes longer than what is left of the limit
ends the process by SIGALRM. Timed is what peers.py times, each step from arrays to arrays: storing
a result, checks and judgements are not.
"""

import argparse
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

import peers

ROOT = Path(__file__).resolve().parents[1]
sys.path.append(str(ROOT / "tests" / "python"))

import chain_kinds  # noqa: E402
import fold_pairs  # noqa: E402, F401  (for results_hold.py)
import judges  # noqa: E402
import placements  # noqa: E402

CORE_BLOCKS = ROOT / "build/release/tests/core_blocks"
BLOCKS = ("union", "intersection", "first_minus_second", "second_minus_first")


class OneBlock(peers.IndexBooleanFilter):
    """This project's filter, asked for one block."""

    def run(self):
        result = self.document.apply_filter(
            "generate_index_boolean", first_mesh=0, second_mesh=1,
            **{block: block == self.operation for block in BLOCKS}, **self.parameters(),
        )
        return int(result[f"{self.operation}_layer"])

    def parameters(self):
        return {}


class MergedBlock(OneBlock):
    """The same, with walls merged that rounding has taken off their plane."""

    share = 1e-10  # per cent of the operands' diagonal

    def parameters(self):
        import pymeshlab

        return {"merge_tolerance": pymeshlab.PercentageValue(self.share)}


class FloatHost(peers.Peer):
    """What a host in float delivers: the core's float run, a process of its own, all blocks."""

    package = "numpy"
    program = str(CORE_BLOCKS)

    def __init__(self, *args):
        super().__init__(*args)
        self.operands = [
            (points.astype(np.float32).astype(np.float64), triangles)
            for points, triangles in self.converted(np.float64, np.uint32)
        ]

    def run(self):
        return self.blocks()[self.operation]

    def blocks(self):
        """All four."""
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            for number, (points, triangles) in enumerate(self.operands):
                points.tofile(folder / f"points_{number}.f64")
                triangles.tofile(folder / f"triangles_{number}.u32")
            done = subprocess.run(
                [self.program, "float", name], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                text=True,
            )
            if done.returncode != 0:
                raise ValueError(done.stderr.strip() or f"exit status {done.returncode}")
            return {block: read_block(folder, block) for block in BLOCKS}


def read_block(folder, block):
    """One block of the core's run: (V, F)."""
    points = np.fromfile(folder / f"{block}_points.f64").reshape(-1, 3)
    return points, np.fromfile(folder / f"{block}_triangles.u32", np.uint32).reshape(-1, 3)


SYSTEMS = {
    "here": OneBlock,
    "merged": MergedBlock,
    "float host": FloatHost,
    **{name: peers.PEERS[name] for name in ("Manifold", "trueform", "MeshLib", "CGAL", "libigl")},
}


# --- storing --------------------------------------------------------------------------------------


def as_float(mesh):
    """Each coordinate rounded to a float."""
    return mesh[0].astype(np.float32).astype(np.float64), mesh[1]


def through_file(mesh, ending):
    """The mesh as it is read from a file that the host has written."""
    import pymeshlab

    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / f"step.{ending}"
        document = pymeshlab.MeshSet()
        document.add_mesh(pymeshlab.Mesh(*mesh))
        document.save_current_mesh(str(path))
        return placements.read_mesh(path)


STORAGES = {
    "arrays": lambda mesh: mesh,
    "float": as_float,
    "ply": lambda mesh: through_file(mesh, "ply"),
    "stl": lambda mesh: through_file(mesh, "stl"),
}


# --- a chain --------------------------------------------------------------------------------------


def libigl_volume(operands, operation):
    """The volume of the same operation by libigl; None if it refuses."""
    try:
        peer = peers.Libigl(*operands, operation)
        return peer.figures(peer.run())["volume"]
    except Exception:
        return None


class Progress:
    """What the steps so far have left: the mesh, the seconds, whether it has folded."""

    def __init__(self, args, start):
        self.args, self.left, self.folded = args, args.limit, False
        self.mesh = STORAGES[args.storage](start)

    def take(self, number, step):
        """One step; its line."""
        operand = STORAGES["float" if self.args.storage == "float" else "arrays"](step.operand)
        operands = self.mesh, operand
        peer = SYSTEMS[self.args.system](*operands, step.operation)
        seconds, result = peers.timed_run(peer, self.left)
        self.left -= seconds
        points, triangles = peer.arrays(result)
        if len(triangles) == 0:
            raise ValueError("the result is empty")
        # Copies, since nobody takes arrays that cannot be written to.
        made = np.array(points, np.float64), np.array(triangles, np.int64)
        line = {"step": number, "seconds": seconds, "faces": len(triangles),
                "volume": peers.volume(*made), "expected": step.volume}
        if self.args.check:
            line["libigl"] = libigl_volume(operands, step.operation)
        self.mesh = STORAGES[self.args.storage](made)
        if self.args.folds and not self.folded:
            line["wrong"] = judges.judge(*self.mesh).meeting
            self.folded = line["wrong"] > 0
        self.keep(operands, step.operation)
        return line

    def keep(self, operands, operation):
        names = ("points", "triangles", "points_0", "triangles_0", "points_1", "triangles_1")
        arrays = [array for mesh in (self.mesh, *operands) for array in mesh]
        np.savez(self.args.keep, operation=operation, **dict(zip(names, arrays)))


def sentence_of(error):
    """What a system says, without the host's words before it."""
    text = " ".join(str(error).split()) or repr(error)
    return text.split("Details: ")[-1]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    add = parser.add_argument
    add("kind", choices=chain_kinds.KINDS)
    add("system", choices=SYSTEMS)
    add("--seed", type=int, default=1)
    add("--steps", type=int, help="default: the kind's own number")
    add("--storage", choices=STORAGES, default="arrays", help="what each result goes through")
    add("--limit", type=float, default=120, help="seconds for all steps")
    add("--check", action="store_true", help="ask libigl for the volume of each step")
    add("--folds", action="store_true", help="judge each step until one has folded")
    add("--plugin", default="", help="the plugin's file")
    add("--core-blocks", default=FloatHost.program, help="the built core_blocks")
    add("--keep", default="", help="file for the last result")
    args = parser.parse_args()

    peers.IndexBooleanFilter.plugin = args.plugin
    FloatHost.program = args.core_blocks
    chain = chain_kinds.make_chain(args.kind, args.seed, args.steps)
    progress = Progress(args, chain.start)
    for number, step in enumerate(chain.steps, 1):
        try:
            peers.emit(**progress.take(number, step))
        except Exception as error:
            peers.emit(step=number, refused=sentence_of(error))
            return 1
        if progress.left <= 0:
            peers.emit(step=number, cut=args.limit)
            return 1
    peers.emit(done=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
