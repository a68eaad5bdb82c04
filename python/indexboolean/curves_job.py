# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""in: two mesh files; out: their intersection curve as an OBJ file with edges, and result.json."""

LOOP_KINDS = ("open", "hard_closed", "soft_closed")


def run_curves_job(job, **parameters):
    """Writes folder/curves.obj and folder/result.json, which lists the loops.

    parameters are those of the filter. Returns (the filter's result map, the messages that it
    logged). Raises as Job.
    """
    result, messages = job.run("generate_index_boolean_curves", **parameters)
    job.save(result["curves_layer"], "curves.obj", save_vertex_normal=False)
    job.write_record({"curves": "curves.obj"}, {**result, "loops": loops_of(result)})
    return result, messages


def loops_of(result):
    """The loops of a result map of the filter: the kind, the length, the sub-surfaces at it."""
    loops = [
        {"kind": LOOP_KINDS[int(kind)], "length": length}
        for kind, length in zip(result["loop_kinds"], result["loop_lengths"].tolist())
    ]
    for operand in ("first", "second"):
        key = f"loops_at_sub_surfaces_{operand}"
        for loop in loops:
            loop[f"sub_surfaces_{operand}"] = []
        pairs = zip(result[f"{key}_loop"], result[f"{key}_sub_surface"])
        for loop, sub_surface in pairs:
            loops[int(loop)][f"sub_surfaces_{operand}"].append(int(sub_surface))
    return loops
