# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m indexboolean: the filters on mesh files.

Exit status: 0 done, 1 refused or unreadable input, 2 usage, 130 interrupted.
"""

import argparse
import contextlib
import os
import pathlib
import sys

from rich import box
from rich.console import Console
from rich.progress import BarColumn, Progress, TaskProgressColumn, TextColumn, TimeElapsedColumn
from rich.table import Column, Table

from .boolean_job import BLOCKS, DEFAULT_BLOCKS, FORMATS, JobError, run_boolean_job
from .plugin import HostError

# The options that are parameters of the filter, by the same names.
_SWITCHES = (
    "merge_fragments", "merge_coplanar", "weld_non_manifold", "check_self_intersections",
)


def main(arguments=None):
    """Runs one command; returns the exit status."""
    options = _parser().parse_args(arguments)
    try:
        return options.run(options)
    except KeyboardInterrupt:
        print("interrupted", file=sys.stderr, flush=True)
        os._exit(130)  # a call into the host may still run on its thread, and cannot be stopped


def _parser():
    parser = argparse.ArgumentParser(
        prog="python -m indexboolean", description="Exact Booleans of triangle meshes."
    )
    commands = parser.add_subparsers(required=True, metavar="command")
    boolean = commands.add_parser(
        "boolean",
        help="union, intersection and differences of two closed meshes",
        description="Intersects two closed meshes once and writes the blocks asked for, and "
        "result.json with their volumes, areas, face counts and components. Any format "
        "that MeshLab reads. OMP_NUM_THREADS limits the threads.",
    )
    boolean.add_argument("first", type=pathlib.Path, metavar="A", help="a mesh file")
    boolean.add_argument("second", type=pathlib.Path, metavar="B", help="another mesh file")
    boolean.add_argument(
        "-o", dest="folder", type=pathlib.Path, metavar="DIR", required=True,
        help="where the files go; made if it is not there",
    )
    boolean.add_argument(
        "--only", type=_block_names, default=DEFAULT_BLOCKS, metavar="BLOCK,...",
        help=f"of {', '.join(BLOCKS)} (default: all but the last)",
    )
    boolean.add_argument(
        "--format", choices=FORMATS, default="ply",
        help="of the blocks (default: ply, binary, which alone keeps every bit)",
    )
    boolean.add_argument(
        "--no-merge-fragments", dest="merge_fragments", action="store_false",
        help="keep cuts that separate nothing in a block: blocks that touch then have the same "
        "faces there",
    )
    boolean.add_argument(
        "--merge-coplanar", action="store_true",
        help="merge neighbouring faces that are exactly coplanar, and drop collinear vertices",
    )
    boolean.add_argument(
        "--weld-non-manifold", action="store_true",
        help="where a block meets itself keep one vertex instead of copies (edges with four faces)",
    )
    boolean.add_argument(
        "--check-self-intersections", action="store_true",
        help="first search each mesh for faces that meet others anywhere but in a common vertex or "
        "edge, and refuse it if there are any",
    )
    boolean.set_defaults(run=_run_boolean)
    return parser


def _block_names(text):
    names = text.split(",")
    for name in names:
        if name not in BLOCKS:
            raise argparse.ArgumentTypeError(f"no block {name!r}; there are {', '.join(BLOCKS)}")
    return names


def _run_boolean(options):
    # A console on a descriptor of its own: the host's calls borrow the process's standard error.
    with os.fdopen(os.dup(2), "w") as stderr:
        console = Console(file=stderr, soft_wrap=True, highlight=False)
        try:
            with _progress_bar(console) as on_progress:
                result, messages = run_boolean_job(
                    options.first, options.second, options.folder, options.only, options.format,
                    on_progress, **{name: getattr(options, name) for name in _SWITCHES},
                )
        except (HostError, JobError, OSError) as error:
            console.print(f"error: {error}", style="red", markup=False)
            return 1
        for message in messages:
            console.print(message, markup=False)
    _print_result(result, options)
    return 0


@contextlib.contextmanager
def _progress_bar(console):
    """Yields on_progress(stage, percent); draws nothing unless the console is a terminal."""
    columns = (
        TextColumn("{task.description:<24}"), BarColumn(), TaskProgressColumn(), TimeElapsedColumn(),
    )
    with Progress(
        *columns, console=console, transient=True, disable=not console.is_terminal,
        redirect_stdout=False, redirect_stderr=False,
    ) as progress:
        task = progress.add_task("starting", total=100)

        def on_progress(stage, percent):
            new_stage = stage != progress.tasks[task].description
            progress.update(task, description=stage, completed=percent, refresh=new_stage)

        yield on_progress


def _print_result(result, options):
    columns = [Column(name, justify="right", no_wrap=True)
               for name in ("faces", "volume", "area", "components", "closed")]
    table = Table(Column("block", no_wrap=True), *columns, box=box.SIMPLE_HEAD, pad_edge=False)
    for block in BLOCKS:
        if block in options.only:
            table.add_row(
                block,
                str(result[f"{block}_faces"]),
                f"{result[f'{block}_volume']:.9g}",
                f"{result[f'{block}_area']:.9g}",
                str(result[f"{block}_components"]),
                "yes" if result[f"{block}_closed"] else "NO",
            )
    console = Console(soft_wrap=True, highlight=False)
    console.print(table)
    console.print(
        f"{result['seconds_core']:.3f} seconds for the core, {result['seconds_total']:.3f} with the "
        f"layers; volume law residual {result['volume_law_residual']:.1g}"
    )
