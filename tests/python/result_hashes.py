# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A hash of each layer that a plugin makes: two builds with the same list give the same bytes.

in: the plugin's file; out: on standard output a line "case filter variant layer hash" for each new
layer of each run of result_cases.py, for each run's result map without the seconds, and for each
refusal its message and the selection that it leaves. The order is always the same. Where a case
ends the process its last line says so ("case - - ended status_N"); the others run in a new process.
"""

import argparse
import concurrent.futures
import hashlib
import os
import subprocess
import sys
import threading

import numpy as np
import pymeshlab

import result_cases

# Methods of pymeshlab.Mesh, with the method that tells whether there is anything to read.
ARRAYS = {
    "vertex_matrix": None,
    "face_matrix": None,
    "edge_matrix": None,
    "transform_matrix": None,
    "vertex_normal_matrix": None,
    "face_normal_matrix": None,
    "vertex_selection_array": None,
    "face_selection_array": None,
    "vertex_color_array": "has_vertex_color",
    "face_color_array": "has_face_color",
    "vertex_scalar_array": "has_vertex_scalar",
    "face_scalar_array": "has_face_scalar",
    "vertex_tex_coord_matrix": "has_vertex_tex_coord",
    "wedge_tex_coord_matrix": "has_wedge_tex_coord",
    "vertex_curvature_principal_dir1_matrix": None,
    "vertex_curvature_principal_dir2_matrix": None,
}
# pymeshlab does not list them: those of the filters, and those of carried.py.
ATTRIBUTES = {
    "vertex_custom_scalar_attribute_array": (
        "source_mesh", "source_vertex", "loop", "loop_kind", "source_face_first",
        "source_face_second", "heat",
    ),
    "vertex_custom_point_attribute_matrix": ("flow",),
    "face_custom_scalar_attribute_array": (
        "source_mesh", "source_face", "sub_surface", "block_front", "block_back", "sub_block",
        "part",
    ),
    "face_custom_point_attribute_matrix": ("axis",),
}
END_OF_CASE = ""


# --- what is hashed -------------------------------------------------------------------------------


def hash_of(named):
    """One hash over names and values: arrays by their bytes, all else by its text."""
    digest = hashlib.sha256()
    for name, value in named:
        if isinstance(value, np.ndarray):
            digest.update(f"{name} {value.dtype} {value.shape} ".encode())
            digest.update(np.ascontiguousarray(value).tobytes())
        else:
            text = value.hex() if isinstance(value, float) else repr(value)
            digest.update(f"{name} {text} ".encode())
    return digest.hexdigest()


def contents_of(mesh):
    """All that a layer carries and pymeshlab shows: (name, value) each."""
    for name, has in ARRAYS.items():
        if has is None or getattr(mesh, has)():
            yield from _value(name, getattr(mesh, name))
    for reader, attributes in ATTRIBUTES.items():
        for attribute in attributes:
            yield from _value(f"{reader} {attribute}", getattr(mesh, reader), attribute)
    yield from _polygons(mesh)
    yield "textures", sorted(mesh.textures())


def _value(name, reader, *arguments):
    """The one value that the reader gives, or nothing: the layer has it not."""
    try:
        yield name, reader(*arguments)
    except (pymeshlab.MissingComponentException, pymeshlab.PyMeshLabException):
        pass


def _polygons(mesh):
    """Triangles joined by faux edges, as one array of sizes and one of corners."""
    polygons = mesh.polygonal_face_list() if mesh.face_number() else []
    yield "polygon sizes", np.array([len(corners) for corners in polygons])
    yield "polygon corners", np.concatenate(polygons) if polygons else None


def selections_of(mesh_set):
    """What is selected in all layers."""
    for mesh in mesh_set:
        yield "vertices", mesh.vertex_selection_array()
        yield "faces", mesh.face_selection_array()


def run_lines(make_document, filter_name, parameters):
    """(layer, hash) for all that one run on a new document delivers."""
    mesh_set = make_document()
    operands = mesh_set.mesh_number()
    try:
        result = mesh_set.apply_filter(filter_name, first_mesh=0, second_mesh=1, **parameters)
    except pymeshlab.PyMeshLabException as refusal:
        lines = [("refusal", hash_of([("message", str(refusal))]))]
        lines.append(("selection", hash_of(selections_of(mesh_set))))
        # pymeshlab writes to the log of a refused document until another call: docs/hosts.md.
        pymeshlab.MeshSet().create_cube()
        return lines
    exact = [(key, result[key]) for key in sorted(result) if not key.startswith("seconds_")]
    lines = [("result", hash_of(exact))]
    for mesh in list(mesh_set)[operands:]:
        lines.append((mesh.label().replace(" ", "_"), hash_of(contents_of(mesh))))
    return lines


def case_lines(name):
    """The lines of all runs of a case, one by one."""
    make_document = result_cases.loaded(name)
    for filter_name, variant, parameters in result_cases.runs_of(name):
        for layer, digest in run_lines(make_document, filter_name, parameters):
            yield f"{name} {filter_name} {variant} {layer} {digest}"


# --- processes ------------------------------------------------------------------------------------


def serve(plugin):
    """A worker: names of cases from standard input, lines and an empty one to standard output.

    Another empty one says that the plugin is loaded.
    """
    answers = os.fdopen(os.dup(1), "w", buffering=1)
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)  # the host writes there, too
    pymeshlab.load_plugin(plugin)
    print(END_OF_CASE, file=answers)
    for name in sys.stdin:
        for line in case_lines(name.strip()):
            print(line, file=answers)
        print(END_OF_CASE, file=answers)


class Worker:
    """A process that runs cases; another one takes its place if one has ended it."""

    def __init__(self, plugin):
        self.command = [sys.executable, __file__, plugin, "--worker"]
        self.process = None

    def lines_of(self, name):
        """The lines of a case, with a last one on how the process ended if it did."""
        if self.process is None:
            self._start()
        print(name, file=self.process.stdin, flush=True)
        lines, complete = self._answer()
        return lines if complete else [*lines, f"{name} - - ended status_{self.close()}"]

    def _start(self):
        self.process = subprocess.Popen(
            self.command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, bufsize=1
        )
        if not self._answer()[1]:
            raise RuntimeError(f"pymeshlab does not load {self.command[2]}: status {self.close()}")

    def _answer(self):
        """(Lines up to an empty one, whether that came.)"""
        lines = []
        for line in self.process.stdout:
            if line == END_OF_CASE + "\n":
                return lines, True
            lines.append(line.rstrip("\n"))
        return lines, False

    def close(self):
        """Ends the process; its exit status."""
        process, self.process = self.process, None
        if process is None:
            return 0
        process.stdin.close()
        process.stdout.close()
        return process.wait()


def all_lines(plugin, names, jobs):
    """The lines of the cases in their order, from that many processes."""
    own, workers = threading.local(), []

    def lines_of(name):
        if not hasattr(own, "worker"):
            own.worker = Worker(plugin)
            workers.append(own.worker)
        return own.worker.lines_of(name)

    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        for lines in pool.map(lines_of, names):
            yield from lines
    for worker in workers:
        worker.close()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("plugin", help="libfilter_indexboolean.so of a build for pymeshlab")
    parser.add_argument("--cases", default="", help="only cases whose name contains this")
    parser.add_argument("--jobs", type=int, default=2, help="processes")
    parser.add_argument("--worker", action="store_true", help=argparse.SUPPRESS)
    args = parser.parse_args()
    if args.worker:
        serve(args.plugin)
        return
    # Threads that wait would take the time of the other process.
    os.environ.setdefault("OMP_WAIT_POLICY", "passive")
    names = [name for name in result_cases.case_names() if args.cases in name]
    for line in all_lines(args.plugin, names, args.jobs):
        print(line, flush=True)


if __name__ == "__main__":
    main()
