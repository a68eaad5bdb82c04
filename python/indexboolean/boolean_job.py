# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""in: two mesh files and a set of blocks; out: one file per block and result.json."""

BLOCKS = (
    "union",
    "intersection",
    "first_minus_second",
    "second_minus_first",
    "symmetric_difference",
)
DEFAULT_BLOCKS = BLOCKS[:4]
FORMATS = ("ply", "obj", "off", "stl")


def run_boolean_job(job, blocks, file_format, **parameters):
    """Writes folder/<block>.<file_format> for each of blocks, then folder/result.json.

    parameters are those of the filter that are not named here. Returns (the filter's result map,
    the messages that it logged). Raises as Job.
    """
    parameters.update((block, block in blocks) for block in BLOCKS)
    # A certificate is of the numbers as they are kept: those of STL have single precision.
    parameters.setdefault("certify_as", "float" if file_format == "stl" else "host")
    result, messages = job.run("generate_index_boolean", **parameters)
    files = {block: f"{block}.{file_format}" for block in BLOCKS if block in blocks}
    for block, file in files.items():
        job.save(result[f"{block}_layer"], file)
    job.write_record(files, result)
    return result, messages
