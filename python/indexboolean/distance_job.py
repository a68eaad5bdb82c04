# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""in: two mesh files; out: both with their distances from each other, as PLY files with a property
for each number, and result.json; on request a picture and a histogram.
"""

import numpy as np

from .job import JobError
from .ply_file import colour_columns

STATISTICS = ("min", "max", "mean", "rms", "mean_absolute", "beyond")
SIDES = ("first", "second")


def run_distance_job(job, plot=False, **parameters):
    """Writes folder/first.ply, second.ply (unless it was not measured) and result.json.

    plot: distance.png and histogram.png, too. parameters are those of the filter. Returns (the
    filter's result map, the messages that it logged). Raises as Job.
    """
    result, messages = job.run(
        "compute_index_boolean_distance", direction=True, closest=True, **parameters
    )
    files = {side: f"{side}.ply" for side in SIDES if f"min_{side}" in result}
    for layer, side in zip(job.operands, SIDES):
        if side in files:
            job.save_with_distances(layer, files[side], lambda mesh: _columns(mesh, parameters))
    if plot:
        files.update(_draw(job, result, parameters))
    job.write_record(files, result)
    return result, messages


def _columns(mesh, parameters):
    """What was measured at vertices and at faces, by the properties' names."""
    both = []
    for kind in ("vertex", "face"):
        columns = {}
        if parameters.get(f"at_{'vertices' if kind == 'vertex' else 'faces'}", True):
            scalar = getattr(mesh, f"{kind}_custom_scalar_attribute_array")
            point = getattr(mesh, f"{kind}_custom_point_attribute_matrix")
            columns["distance"] = np.array(scalar("distance"))
            for name, start in (("distance_direction", "direction"), ("closest_point", "closest")):
                columns.update(zip((f"{start}_{axis}" for axis in "xyz"), point(name).T))
            columns["closest_face"] = scalar("closest_face").astype("<i4")
            if parameters.get("color", True):
                colours = (getattr(mesh, f"{kind}_color_matrix")() * 255).round()
                columns.update(colour_columns(colours))
        both.append(columns)
    return both


def _draw(job, result, parameters):
    """Draws the meshes and the histogram; returns the files' names."""
    try:
        from .distance_plot import draw_histogram, draw_meshes
    except ImportError as error:
        raise JobError(
            f"--plot needs pyvista, which cannot be imported ({error}); install it by: "
            'python -m pip install "indexboolean[plot]"'
        ) from error
    kind = "vertex" if parameters.get("at_vertices", True) else "face"
    meshes = {}
    for layer, side in zip(job.operands, SIDES):
        if f"min_{side}" in result:
            mesh = job.mesh_of(layer)
            values = np.array(getattr(mesh, f"{kind}_custom_scalar_attribute_array")("distance"))
            meshes[side] = (mesh.transformed_vertex_matrix(), mesh.face_matrix(), values)
    draw_meshes(meshes, kind, job.folder / "distance.png")
    draw_histogram(meshes, job.folder / "histogram.png")
    return {"picture": "distance.png", "histogram": "histogram.png"}
