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
from .distance_job import SIDES, STATISTICS, run_distance_job
from .evaluate_job import run_evaluate_job
from .expression_text import check_operand_name
from .job import Job, JobError, LayersJob
from .plugin import HostError
from .printed_table import new_table
from .resolve_job import run_resolve_job
from .split_job import (
    CLIPS, PIECES, PIECES_OF_LIST, SUB_SURFACES, SUB_SURFACES_OF_LIST, ListJob, kinds_of,
    run_split_job,
)


_CLIP_WORDS = {"-".join(clip.split("_")[:2]): clip for clip in CLIPS}  # "first-inside", ...


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
    _add_evaluate(commands)
    _add_resolve(commands)
    _add_distance(commands)
    _add_batch(commands)
    return parser


_ALL_COMMANDS = (
    "Any format that MeshLab reads. OMP_NUM_THREADS limits the threads. Exit status: 0 done, 1 "
    "refused or unreadable input, 2 usage, 130 interrupted."
)


def _add_pair_command(commands, name, run, text, description, nargs=None):
    """A command on two mesh files, with the options that all commands have."""
    command = _add_command(commands, name, run, text, f"{description} {_ALL_COMMANDS}")
    command.add_argument("first", type=pathlib.Path, metavar="A", help="a mesh file", nargs=nargs)
    command.add_argument(
        "second", type=pathlib.Path, metavar="B", help="another mesh file", nargs=nargs
    )
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


def _add_merge_tolerance(command):
    _add_filter_option(
        command, "merge_tolerance", "--merge-tolerance", type=_length, default="0",
        metavar="LENGTH",
        help="connected faces of a result that lie within this of one plane become one polygon, "
        "chains of edges around it that lie within it of a line one edge: a length, as 1e-12, or a "
        "share of the diagonal of the box around all meshes, as 1e-10%% (default: 0)",
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
    _add_block_options(command)


def _add_block_options(command):
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
    _add_merge_tolerance(command)
    _add_filter_option(
        command, "weld_non_manifold", "--weld-non-manifold", action="store_true",
        help="where a block meets itself keep one vertex instead of copies (edges with four faces)",
    )
    _add_certify(command)


def _add_split(commands):
    command = _add_pair_command(
        commands, "split", _run_split,
        "every piece that meshes, open or closed, cut each other into",
        "Intersects two meshes or, with --layers, any number of them, open or closed, and writes "
        "the sub-surfaces of each and the closed sub-blocks that they bound, as PLY files whose "
        "faces have colours and the numbers source_mesh, source_face, sub_surface, block_front, "
        "block_back and sub_block; and result.json with areas and volumes.",
        nargs="?",
    )
    command.add_argument(
        "--layers", type=pathlib.Path, nargs="+", default=(), metavar="FILE",
        help="more mesh files, all of which cut each other, A and B too if they are given; pieces "
        "then have the numbers of the files, from 0, in place of first and second",
    )
    command.add_argument(
        "--only", type=_piece_names, metavar="PIECES,...",
        help=f"of {', '.join(PIECES)}, with --layers of {', '.join(PIECES_OF_LIST)}; or none "
        "(default: all)",
    )
    command.add_argument(
        "--clip", type=_clip_names, default=(), metavar="CLIP,...",
        help="what of one of the first two meshes, open or closed, lies inside the other, closed "
        f"one, or outside: of {', '.join(_CLIP_WORDS)}; writes DIR/first_inside_second.ply and so "
        "on",
    )
    command.set_defaults(refuse=command.error)
    _add_filter_option(
        command, "separate_layers", "--separate", action="store_true",
        help="a file for each piece, if there are at most --max-files",
    )
    _add_filter_option(
        command, "max_layers", "--max-files", type=int, default=64, metavar="N",
        help="more pieces than this go into one file a kind (default: 64)",
    )
    _add_merge_tolerance(command)
    _add_certify(command)


def _add_curves(commands):
    _add_pair_command(
        commands, "curves", _run_curves,
        "the lines in which two meshes meet, as polylines",
        "Intersects two meshes, open or closed, and writes curves.obj, a file of vertices and "
        "edges, and result.json with the kind, the length and the sub-surfaces of each loop.",
    )


def _add_evaluate(commands):
    command = _add_command(
        commands, "evaluate", _run_evaluate, "an expression over any number of closed meshes",
        "Intersects any number of closed meshes once and writes DIR/<name> for each statement of "
        "an expression over them, result_<k> for the k-th, from 0 on, if it has no name; and "
        "result.json with their volumes, areas, face counts and components. "
        "In the expression a file is its name, or its place, from 0 on; visible and all are all "
        f"files. {_ALL_COMMANDS}",
    )
    command.add_argument(
        "expression", metavar="EXPR",
        help='as "a - b" or "walls = a - b; rest = at_least(2, all) - walls"; the filter\'s help '
        "has the grammar",
    )
    command.add_argument(
        "operands", nargs="+", type=_named_file, metavar="NAME=FILE",
        help="a mesh file, and its name in the expression",
    )
    _add_block_options(command)


def _add_resolve(commands):
    command = _add_command(
        commands, "resolve", _run_resolve, "a closed mesh without its self-intersections",
        "Writes the boundary of what the winding rule calls inside a mesh, and result.json. "
        f"{_ALL_COMMANDS}",
    )
    command.add_argument("mesh", type=pathlib.Path, metavar="A", help="a mesh file")
    _add_filter_option(
        command, "outer_hull", "--outer-hull", action="store_true",
        help="inside is all that cannot be reached from outside: cavities are filled",
    )
    _add_block_options(command)


def _add_distance(commands):
    command = _add_pair_command(
        commands, "distance", _run_distance,
        "the signed distances of two meshes from each other",
        "Measures the distances of the vertices and face centres of each mesh from the other, "
        "negative inside, and writes first.ply and second.ply, with the properties distance, "
        "direction_x, _y, _z, closest_x, _y, _z and closest_face of vertices and faces, and "
        "result.json with minimum, maximum, mean, root mean square and the Hausdorff distance. A "
        "may be a cloud of points.",
    )
    command.add_argument(
        "--plot", action="store_true",
        help="distance.png, both meshes in colours, and histogram.png; needs indexboolean[plot]",
    )
    _add_filter_option(
        command, "signed", "--unsigned", action="store_false",
        help="distances without sign, to all faces as they are",
    )
    _add_filter_option(
        command, "negate", "--negate", action="store_true", help="positive inside",
    )
    _add_filter_option(
        command, "both_ways", "--one-way", action="store_false",
        help="the distances of A from B only",
    )
    _add_filter_option(
        command, "max_distance", "--max-distance", type=_length, default="0", metavar="LENGTH",
        help="do not measure what is farther away: its distance is no number, and it is counted",
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
        "first_transform, second_transform (12 or 16 numbers, row by row), blocks, job (boolean, "
        "or distance: what the command distance does)",
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


def _named_file(text):
    name, separator, file = text.partition("=")
    if not separator or not file:
        raise argparse.ArgumentTypeError(f"{text!r} is not NAME=FILE")
    try:
        check_operand_name(name)
    except ValueError as error:
        raise argparse.ArgumentTypeError(str(error)) from error
    return name, pathlib.Path(file)


def _block_names(text):
    return _names(text, "block", BLOCKS)


def _piece_names(text):
    return () if text == "none" else _names(
        text, "kind of pieces", (*PIECES, SUB_SURFACES_OF_LIST)
    )


def _clip_names(text):
    return [_CLIP_WORDS[word] for word in _names(text, "clip", tuple(_CLIP_WORDS))]


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
    pieces = _split_pieces(options)

    def run(job, **parameters):
        return run_split_job(job, pieces, options.clip, **parameters)

    def new_job(on_progress):
        files = [options.first, options.second, *options.layers]
        return ListJob([file for file in files if file], options.folder, on_progress)

    return _run_job(
        options, run, lambda result: _print_pieces(result, options.clip),
        new_job if options.layers else None,
    )


def _split_pieces(options):
    """The kinds of pieces that are asked for. Ends the program if the options do not fit."""
    given = [path for path in (options.first, options.second) if path is not None]
    known = PIECES_OF_LIST if options.layers else (*PIECES, SUB_SURFACES_OF_LIST)
    pieces = known if options.only is None else options.only
    problem = None
    if not options.layers and len(given) < 2:
        problem = "two mesh files are needed, or --layers"
    if options.clip and len({*given, *options.layers}) < 2:
        problem = "--clip needs two mesh files"
    for piece in pieces:
        if piece not in known:
            problem = f"--only {piece} does not go with --layers: take {', '.join(known)}"
    if not pieces and not options.clip:
        problem = "--only none needs --clip"
    if problem:
        options.refuse(problem)
    if not options.layers and SUB_SURFACES_OF_LIST in pieces:
        pieces = (*pieces, *SUB_SURFACES)
    return pieces


def _run_curves(options):
    return _run_job(options, run_curves_job, _print_curves)


def _run_evaluate(options):
    files = dict(options.operands)
    if len(files) < len(options.operands):
        print("error: two files have one name", file=sys.stderr)
        return 2

    def run(job, **parameters):
        return run_evaluate_job(job, options.expression, options.format, **parameters)

    return _run_job(
        options, run,
        lambda result: _print_results(result, [f"result_{k}" for k in range(result["results"])]),
        lambda on_progress: LayersJob(files, options.folder, on_progress),
    )


def _run_resolve(options):
    def run(job, **parameters):
        return run_resolve_job(job, options.format, **parameters)

    return _run_job(
        options, run, lambda result: _print_results(result, ["resolved"]),
        lambda on_progress: LayersJob({"mesh": options.mesh}, options.folder, on_progress),
    )


def _run_distance(options):
    def run(job, **parameters):
        return run_distance_job(job, options.plot, **parameters)

    return _run_job(options, run, _print_distances)


def _run_job(options, run, print_result, new_job=None):
    """Calls run(job, **parameters), prints what it logs and its result; returns the exit status.

    new_job(on_progress) makes the job; by default that of the files first and second.
    """
    parameters = {name: getattr(options, name) for name in options.filter_options}
    # A console on a descriptor of its own: the host's calls borrow the process's standard error.
    with os.fdopen(os.dup(2), "w") as stderr:
        console = Console(file=stderr, soft_wrap=True, highlight=False)
        try:
            with _progress_bar(console) as on_progress:
                job = new_job(on_progress) if new_job else Job(
                    options.first, options.second, options.folder, on_progress
                )
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
    _print_results(result, [block for block in BLOCKS if block in blocks])


def _print_results(result, names):
    table = new_table("block", "faces", "volume", "area", "components", "closed")
    for block in names:
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


def _print_pieces(result, clips):
    table = new_table("pieces", "number", "area", "volume")
    for kind in kinds_of(result, also_without_layers=True):
        volume = f"{result[f'{kind}_volumes'].sum():.9g}" if kind == "sub_blocks" else ""
        area = f"{result[f'{kind}_areas'].sum():.9g}"
        table.add_row(kind, str(result[kind]), area, volume)
    for clip in clips:
        table.add_row(clip, "", f"{result[f'{clip}_area']:.9g}", "")
    _print_table(table, result)


def _print_curves(result):
    table = new_table("kind", "loops", "length")
    for number, kind in enumerate(LOOP_KINDS):
        lengths = result["loop_lengths"][result["loop_kinds"] == number]
        table.add_row(kind, str(len(lengths)), f"{lengths.sum():.9g}")
    _print_table(table, result)


def _print_distances(result):
    table = new_table("distances of", *STATISTICS)
    for side in SIDES:
        if f"min_{side}" in result:
            table.add_row(side, *(f"{result[f'{name}_{side}']:.9g}" for name in STATISTICS))
    console = Console(soft_wrap=True, highlight=False)
    console.print(table)
    if "hausdorff" in result:
        console.print(f"Hausdorff distance of the points measured: {result['hausdorff']:.9g}")
    console.print(
        f"{result['seconds_build']:.3f} seconds for the trees, {result['seconds_query']:.3f} for "
        "the distances"
    )
