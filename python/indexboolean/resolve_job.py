# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""in: a mesh file; out: the same mesh without self-intersections, and result.json."""


def run_resolve_job(job, file_format, **parameters):
    """Writes folder/resolved.<file_format>, then folder/result.json.

    job is a LayersJob with one file. parameters are those of the filter that are not named here.
    Returns (the filter's result map, the messages that it logged). Raises as LayersJob.
    """
    parameters.setdefault("certify_as", "float" if file_format == "stl" else "host")
    layer, = job.operands
    result, messages = job.run("generate_index_boolean_resolve", mesh=layer, **parameters)
    file = f"resolved.{file_format}"
    job.save(result["resolved_layer"], file)
    job.write_record({"resolved": file}, result)
    return result, messages
