# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""in: two mesh files and a set of blocks; out: one file per block and result.json."""

import json
import math

from .host_call import host_call
from .plugin import load_plugin

BLOCKS = (
    "union",
    "intersection",
    "first_minus_second",
    "second_minus_first",
    "symmetric_difference",
)
DEFAULT_BLOCKS = BLOCKS[:4]
FORMATS = ("ply", "obj", "off", "stl")


class JobError(Exception):
    """A file that cannot be read or written, or operands that the filter refuses."""


def run_boolean_job(first, second, folder, blocks, file_format, on_progress, **parameters):
    """Writes folder/<block>.<file_format> for each of blocks, then folder/result.json.

    first, second and folder are pathlib.Path; on_progress is that of host_call; parameters are
    those of the filter that are not named here. Returns (the filter's result map, the messages that
    it logged). Raises HostError, JobError or OSError.
    """
    load_plugin()
    import pymeshlab

    meshes = pymeshlab.MeshSet()
    operands = [_load(meshes, path, on_progress) for path in (first, second)]
    folder.mkdir(parents=True, exist_ok=True)

    parameters.update((block, block in blocks) for block in BLOCKS)
    meshes.set_verbosity(True)
    try:
        result, messages = host_call(
            lambda: meshes.generate_index_boolean(
                first_mesh=operands[0], second_mesh=operands[1], **parameters
            ),
            on_progress,
        )
    except pymeshlab.PyMeshLabException as error:
        _, _, refusal = str(error).partition("Details: ")  # after the host's own opening
        raise JobError(refusal or str(error)) from error

    meshes.set_verbosity(False)
    files = {block: f"{block}.{file_format}" for block in BLOCKS if block in blocks}
    for block, file in files.items():
        _save(meshes, result[f"{block}_layer"], folder / file, on_progress)
    _write_record(folder / "result.json", first, second, files, result)
    return result, messages


def _load(meshes, path, on_progress):
    """The layer id of the file's mesh; the parts of a file of several meshes become one layer."""
    import pymeshlab

    if not path.exists() or path.is_dir():
        raise JobError(f"{path} is not a file")
    on_progress(f"reading {path.name}", 0)
    before = meshes.mesh_number()
    try:
        host_call(lambda: meshes.load_new_mesh(str(path)), on_progress)
        if meshes.mesh_number() > before + 1:
            parts = pymeshlab.MeshSet()
            parts.load_new_mesh(str(path))
            parts.generate_by_merging_visible_meshes(mergevertices=False)
            meshes.add_mesh(parts.current_mesh(), path.name)
    except pymeshlab.PyMeshLabException as error:
        raise JobError(f"{path} cannot be read: {error}") from error
    return meshes.current_mesh_id()


def _save(meshes, layer, path, on_progress):
    import pymeshlab

    meshes.set_current_mesh(layer)
    if path.suffix == ".obj" and meshes.current_mesh().face_number() == 0:
        path.write_text("# an empty block\n")  # the host refuses to write an OBJ file of nothing
        return
    on_progress(f"writing {path.name}", 100)
    try:
        host_call(lambda: meshes.save_current_mesh(str(path)), on_progress)
    except pymeshlab.PyMeshLabException as error:
        raise JobError(f"{path} cannot be written: {error}") from error


def _write_record(path, first, second, files, result):
    record = {"first": str(first), "second": str(second), "files": files}
    record.update((key, _json_value(value)) for key, value in result.items())
    path.write_text(json.dumps(record, indent="\t", allow_nan=False) + "\n")


def _json_value(value):
    """JSON has no infinities: a volume beyond the range of double is the string "inf" or "-inf"."""
    return str(value) if isinstance(value, float) and not math.isfinite(value) else value
