# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""in: mesh files; out: their sub-surfaces, sub-blocks and clips as PLY files, and result.json."""

from .job import LayersJob

SUB_SURFACES = ("sub_surfaces_first", "sub_surfaces_second")  # of two files
SUB_SURFACES_OF_LIST = "sub_surfaces"  # of each file of a list; of two files, of both
SUB_BLOCKS = "sub_blocks"
PIECES = (*SUB_SURFACES, SUB_BLOCKS)
PIECES_OF_LIST = (SUB_SURFACES_OF_LIST, SUB_BLOCKS)
CLIPS = (
    "first_inside_second", "first_outside_second", "second_inside_first", "second_outside_first",
)
_NUMBERS = ("source_mesh", "source_face", "sub_surface", "block_front", "block_back")


class ListJob(LayersJob):
    """The files, each once, as the list of layers of a filter, numbered from 0 on.

    files are pathlib.Path; the first two, if there are two, are first_mesh and second_mesh, too.
    """

    def __init__(self, files, folder, on_progress):
        each = {}
        for file in files:
            each.setdefault(file.resolve(), file)
        numbered = {str(number): file for number, file in enumerate(each.values())}
        super().__init__(numbered, folder, on_progress)

    def run(self, filter_name, **parameters):
        """Runs the filter on the list; returns (its result map, the messages that it logged)."""
        first, second = self.operands[0], self.operands[:2][-1]
        layers = ",".join(map(str, self.operands))
        return super().run(
            filter_name, first_mesh=first, second_mesh=second, layers=layers, **parameters
        )


def run_split_job(job, pieces, clips=(), **parameters):
    """Writes folder/<kind>.ply for each of pieces and clips, then folder/result.json.

    With separate_layers, as long as max_layers allows it, a file for each piece:
    <kind>_<number>.ply. job is a Job or a ListJob; parameters are those of the filter that are not
    named here. Returns (the filter's result map, the messages that it logged). Raises as Job.
    """
    parameters.update((name, name in pieces) for name in (*PIECES, SUB_SURFACES_OF_LIST))
    parameters.update((clip, clip in clips) for clip in CLIPS)
    result, messages = job.run("generate_index_boolean_split", **parameters)
    files = {kind: _save_pieces(job, kind, result) for kind in kinds_of(result)}
    for clip in clips:
        files[clip] = f"{clip}.ply"
        job.save_with_numbers(result[f"{clip}_layer"], files[clip], _NUMBERS)
    job.write_record(files, result)
    return result, messages


def kinds_of(result, also_without_layers=False):
    """The kinds of pieces of a split, as its result map names them, in their order.

    Those that have layers, or all.
    """
    operands = range(result["operands"]) if "operands" in result else ("first", "second")
    kinds = [*(f"sub_surfaces_{operand}" for operand in operands), SUB_BLOCKS]
    return [kind for kind in kinds if also_without_layers or f"{kind}_layers" in result]


def _save_pieces(job, kind, result):
    """Writes the layers of one kind of pieces; returns the name of the file, or their list."""
    names = _NUMBERS + (("sub_block",) if kind == SUB_BLOCKS else ())
    layers = [int(layer) for layer in result[f"{kind}_layers"]]
    if len(layers) == 1:
        file = f"{kind}.ply"
        job.save_with_numbers(layers[0], file, names)
        return file
    files = [f"{kind}_{number}.ply" for number in range(len(layers))]
    for layer, file in zip(layers, files):
        job.save_with_numbers(layer, file, names)
    return files
