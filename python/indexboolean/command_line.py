# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m indexboolean: the filters on mesh files.

Exit status: 0 done, 1 refused or unreadable input, 2 usage, 3 some jobs of a batch failed, 130
interrupted.
"""

import argparse
import contextlib
import importlib.util
import os
import pathlib
import re
import sys

from rich.console import Console
from rich.progress import BarColumn, Progress, TaskProgressColumn, TextColumn, TimeElapsedColumn

from .batch_command import run_batch_command
from .boolean_job import BLOCKS, DEFAULT_BLOCKS, FORMATS, run_boolean_job
from .curves_job import LOOP_KINDS, run_curves_job
from .job import Job, JobError
from .plugin import HostError
from .printed_table import new_table
from .split_job import PIECES, run_split_job


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
    _add_boolean(commands)
    _add_split(commands)
    _add_curves(commands)
    _add_batch(commands)
    return parser


def _add_pair_command(commands, name, run, text, description):
    """A command on two mesh files, with the options that all commands have."""
    command = _add_command(
        commands, name, run, text,
        f"{description} Any format that MeshLab reads. OMP_NUM_THREADS limits the threads. Exit "
        "status: 0 done, 1 refused or unreadable input, 2 usage, 130 interrupted.",
    )
    command.add_argument("first", type=pathlib.Path, metavar="A", help="a mesh file")
    command.add_argument("second", type=pathlib.Path, metavar="B", help="another mesh file")
    return command


def _add_command(commands, name, run, text, description):
    command = commands.add_parser(name, help=text, description=description)
    command.add_argument(
        "-o", dest="folder", type=pathlib.Path, metavar="DIR", required=True,
        help="where the files go; made if it is not there",
    )
    command.set_defaults(run=run, filter_options=[])
    _add_filter_option(
        command, "self_intersections", "--self-intersections",
        choices=("resolve", "trust", "refuse"), default="resolve",
        help="what is done about a mesh that meets itself: searched and taken for what its winding "
        "rule says (default), not searched, or searched and refused",
    )
    _add_filter_option(
        command, "winding_rule", "--winding-rule", choices=("nonzero", "positive", "odd"),
        default="nonzero",
        help="what is inside a mesh that meets itself: all places that its surface winds around "
        "(default), those where it does so right side out, or an odd number of times",
    )
    _add_filter_option(
        command, "weld_distance", "--weld-distance", type=_length, default="0", metavar="LENGTH",
        help="vertices of one mesh that are nearer to each other than this become one before "
        "anything else, for meshes whose faces do not quite meet: a length, as 1e-6, or a share of "
        "the diagonal of the box around all meshes, as 0.001%% (default: 0)",
    )
    return command


def _add_filter_option(command, name, *flags, **details):
    """An option that is a parameter of the filter, by the same name."""
    command.add_argument(*flags, dest=name, **details)
    command.get_default("filter_options").append(name)


def _add_certify(command):
    _add_filter_option(
        command, "certify", "--no-certify", action="store_false",
        help="do not search whether the results hold as they are stored, nor move new points by "
        "units in the last place until they do",
    )


def _add_boolean(commands):
    command = _add_pair_command(
        commands, "boolean", _run_boolean,
        "union, intersection and differences of two closed meshes",
        "Intersects two closed meshes once and writes the blocks asked for, and result.json with "
        "their volumes, areas, face counts and components.",
    )
    _add_boolean_options(command)


def _add_boolean_options(command):
    command.add_argument(
        "--only", type=_block_names, default=DEFAULT_BLOCKS, metavar="BLOCK,...",
        help=f"of {', '.join(BLOCKS)} (default: all but the last)",
    )
    command.add_argument(
        "--format", choices=FORMATS, default="ply",
        help="of the blocks (default: ply, binary); what is read back has the bits certified",
    )
    _add_filter_option(
        command, "merge_fragments", "--no-merge-fragments", action="store_false",
        help="keep cuts that separate nothing in a block: blocks that touch then have the same "
        "faces there",
    )
    _add_filter_option(
        command, "merge_coplanar", "--merge-coplanar", action="store_true",
        help="merge neighbouring faces that are exactly coplanar, and drop collinear vertices",
    )
    _add_filter_option(
        command, "weld_non_manifold", "--weld-non-manifold", action="store_true",
        help="where a block meets itself keep one vertex instead of copies (edges with four faces)",
    )
    _add_certify(command)


def _add_split(commands):
    command = _add_pair_command(
        commands, "split", _run_split,
        "every piece that two meshes, open or closed, cut each other into",
        "Intersects two meshes, open or closed, and writes the sub-surfaces of each and the closed "
        "sub-blocks that they bound, as PLY files whose faces have colours and the numbers "
        "source_mesh, source_face, sub_surface, block_front, block_back and sub_block; and "
        "result.json with areas and volumes.",
    )
    command.add_argument(
        "--only", type=_piece_names, default=PIECES, metavar="PIECES,...",
        help=f"of {', '.join(PIECES)} (default: all)",
    )
    _add_filter_option(
        command, "separate_layers", "--separate", action="store_true",
        help="a file for each piece, if there are at most --max-files",
    )
    _add_filter_option(
        command, "max_layers", "--max-files", type=int, default=64, metavar="N",
        help="more pieces than this go into one file a kind (default: 64)",
    )
    _add_certify(command)


def _add_curves(commands):
    _add_pair_command(
        commands, "curves", _run_curves,
        "the lines in which two meshes meet, as polylines",
        "Intersects two meshes, open or closed, and writes curves.obj, a file of vertices and "
        "edges, and result.json with the kind, the length and the sub-surfaces of each loop.",
    )


def _add_batch(commands):
    command = _add_command(
        commands, "batch", run_batch_command,
        "the command boolean on every pair of a table, on many processes or a cluster",
        "Does what the command boolean does for each row of a CSV table, in DIR/<name>/, and "
        "writes DIR/results.csv, a row a job. A job that is refused, crashes or takes too long is "
        "reported, and the others go on. The same command again does what is not done, and what "
        "has changed. Exit status: 0 all done, 1 the table is unreadable or the cluster is not "
        "there, 2 usage, 3 some jobs failed, 130 interrupted.",
    )
    command.add_argument(
        "table", type=pathlib.Path, metavar="JOBS.csv",
        help="columns first, second (mesh files, relative to the table) and, where wanted, name, "
        "first_transform, second_transform (12 or 16 numbers, row by row), blocks",
    )
    _add_boolean_options(command)
    command.add_argument(
        "--workers", type=_count, metavar="N", help="processes on this machine (default: a core "
        "each, which then have one thread each unless OMP_NUM_THREADS says otherwise)",
    )
    command.add_argument(
        "--timeout", type=_seconds, metavar="SECONDS", help="give up on a job after this time",
    )
    command.add_argument(
        "--memory", type=_bytes, metavar="SIZE",
        help="the address space that a process may have, as 4G or 800M",
    )
    command.add_argument(
        "--scheduler", metavar="ADDRESS", help="run the jobs on this Dask cluster instead, as "
        "tcp://host:8786; needs indexboolean[dask], and files that its workers see by the same "
        "paths",
    )


def _count(text):
    count = int(text)
    if count < 1:
        raise argparse.ArgumentTypeError(f"{text} is not 1 or more")
    return count


def _length(text):
    """The text itself, if it is a length or a percentage; lengths_of makes a number of it."""
    number = float(text[:-1] if text.endswith("%") else text)
    if not 0 <= number < float("inf"):
        raise argparse.ArgumentTypeError(f"{text} is no length")
    return text


def _seconds(text):
    seconds = float(text)
    if not 0 < seconds < float("inf"):
        raise argparse.ArgumentTypeError(f"{text} is no positive number")
    return seconds


def _bytes(text):
    match = re.fullmatch(r"([1-9]\d*)([KMGT])", text.upper())
    if not match:
        raise argparse.ArgumentTypeError(f"{text!r} is no size such as 4G or 800M")
    if importlib.util.find_spec("resource") is None:
        raise argparse.ArgumentTypeError("this system cannot cap the memory of a process")
    return int(match[1]) << {"K": 10, "M": 20, "G": 30, "T": 40}[match[2]]


def _block_names(text):
    return _names(text, "block", BLOCKS)


def _piece_names(text):
    return _names(text, "kind of pieces", PIECES)


def _names(text, what, known):
    names = text.split(",")
    for name in names:
        if name not in known:
            raise argparse.ArgumentTypeError(f"no {what} {name!r}; there are {', '.join(known)}")
    return names


def _run_boolean(options):
    def run(job, **parameters):
        return run_boolean_job(job, options.only, options.format, **parameters)

    return _run_job(options, run, lambda result: _print_blocks(result, options.only))


def _run_split(options):
    def run(job, **parameters):
        return run_split_job(job, options.only, **parameters)

    return _run_job(options, run, _print_pieces)


def _run_curves(options):
    return _run_job(options, run_curves_job, _print_curves)


def _run_job(options, run, print_result):
    """Calls run(job, **parameters), prints what it logs and its result; returns the exit status."""
    parameters = {name: getattr(options, name) for name in options.filter_options}
    # A console on a descriptor of its own: the host's calls borrow the process's standard error.
    with os.fdopen(os.dup(2), "w") as stderr:
        console = Console(file=stderr, soft_wrap=True, highlight=False)
        try:
            with _progress_bar(console) as on_progress:
                job = Job(options.first, options.second, options.folder, on_progress)
                result, messages = run(job, **parameters)
        except (HostError, JobError, MemoryError, OSError) as error:
            console.print(f"error: {error}", style="red", markup=False)
            return 1
        for message in messages:
            console.print(message, markup=False)
    print_result(result)
    return 0


@contextlib.contextmanager
def _progress_bar(console):
    """Yields on_progress(stage, percent); draws nothing unless the console is a terminal."""
    columns = (
        TextColumn("{task.description:<24}"), BarColumn(), TaskProgressColumn(),
        TimeElapsedColumn(),
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


def _print_table(table, result, remark=""):
    console = Console(soft_wrap=True, highlight=False)
    console.print(table)
    console.print(
        f"{result['seconds_core']:.3f} seconds for the core, {result['seconds_total']:.3f} with "
        f"the layers{remark}"
    )


def _print_blocks(result, blocks):
    table = new_table("block", "faces", "volume", "area", "components", "closed")
    for block in BLOCKS:
        if block in blocks:
            table.add_row(
                block,
                str(result[f"{block}_faces"]),
                f"{result[f'{block}_volume']:.9g}",
                f"{result[f'{block}_area']:.9g}",
                str(result[f"{block}_components"]),
                "yes" if result[f"{block}_closed"] else "NO",
            )
    residual = result["volume_law_residual"]
    _print_table(table, result, f"; volume law residual {residual:.1g}")


def _print_pieces(result):
    table = new_table("pieces", "number", "area", "volume")
    for kind in PIECES:
        volume = f"{result[f'{kind}_volumes'].sum():.9g}" if kind == "sub_blocks" else ""
        area = f"{result[f'{kind}_areas'].sum():.9g}"
        table.add_row(kind, str(result[kind]), area, volume)
    _print_table(table, result)


def _print_curves(result):
    table = new_table("kind", "loops", "length")
    for number, kind in enumerate(LOOP_KINDS):
        lengths = result["loop_lengths"][result["loop_kinds"] == number]
        table.add_row(kind, str(len(lengths)), f"{lengths.sum():.9g}")
    _print_table(table, result)
