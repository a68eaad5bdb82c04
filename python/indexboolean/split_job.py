# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""in: two mesh files; out: their sub-surfaces and sub-blocks as PLY files, and result.json."""

PIECES = ("sub_surfaces_first", "sub_surfaces_second", "sub_blocks")
_NUMBERS = ("source_mesh", "source_face", "sub_surface", "block_front", "block_back")


def run_split_job(job, pieces, **parameters):
    """Writes folder/<kind>.ply for each of pieces, then folder/result.json.

    With separate_layers, as long as max_layers allows it, a file for each piece:
    <kind>_<number>.ply. parameters are those of the filter that are not named here. Returns (the
    filter's result map, the messages that it logged). Raises as Job.
    """
    parameters.update((kind, kind in pieces) for kind in PIECES)
    result, messages = job.run("generate_index_boolean_split", **parameters)
    files = {}
    for kind in PIECES:
        if kind in pieces:
            names = _NUMBERS + (("sub_block",) if kind == "sub_blocks" else ())
            files[kind] = _save(job, kind, result, names)
    job.write_record(files, result)
    return result, messages


def _save(job, kind, result, names):
    """Writes the layers of one kind of pieces; returns the name of the file, or their list."""
    layers = [int(layer) for layer in result[f"{kind}_layers"]]
    if len(layers) == 1:
        file = f"{kind}.ply"
        job.save_with_numbers(layers[0], file, names)
        return file
    files = [f"{kind}_{number}.ply" for number in range(len(layers))]
    for layer, file in zip(layers, files):
        job.save_with_numbers(layer, file, names)
    return files
