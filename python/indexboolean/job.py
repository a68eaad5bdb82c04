# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What all commands share: mesh files in, a filter's run, files and a record out."""

import json
import math

import numpy as np

from .exact_text import write_exact_coordinates
from .host_call import host_call
from .host_words import in_words_of_the_command_line
from .plugin import LENGTHS, load_plugin
from .ply_file import write_ply, write_ply_columns


class JobError(Exception):
    """A file that is not there or cannot be written."""


class Refusal(JobError):
    """A file that cannot be read, or operands that the filter refuses."""


class LayersJob:
    """A document with the meshes of files, and the folder that the results go to.

    files is a dict of pathlib.Path by the names that the record has for them; its order is that of
    the layers, whose ids are `operands`. folder is a pathlib.Path; on_progress is that of
    host_call; transforms are the 16 numbers, row by row, of the matrix of each mesh, or None; or
    all None. Raises HostError, JobError, MemoryError or OSError.
    """

    def __init__(self, files, folder, on_progress, transforms=None):
        load_plugin()
        import pymeshlab

        self.meshes = pymeshlab.MeshSet()
        self.files = {name: str(path) for name, path in files.items()}
        self._folder = folder
        self._on_progress = on_progress
        self.operands = [
            self._load(path, transform)
            for path, transform in zip(files.values(), transforms or [None] * len(files))
        ]
        folder.mkdir(parents=True, exist_ok=True)

    def run(self, filter_name, **parameters):
        """Runs the filter; returns (its result map, the messages that it logged)."""
        import pymeshlab

        parameters = self._with_lengths(parameters)
        self.meshes.set_verbosity(True)
        try:
            outcome = host_call(
                lambda: self.meshes.apply_filter(filter_name, **parameters), self._on_progress
            )
        except pymeshlab.PyMeshLabException as error:
            _, _, refusal = str(error).partition("Details: ")  # after the host's own opening
            raise _refusal(in_words_of_the_command_line(refusal or str(error))) from error
        self.meshes.set_verbosity(False)
        return outcome

    def _with_lengths(self, parameters):
        """The parameters with lengths for texts: 1e-6, or 0.1% of the operands' diagonal."""
        import pymeshlab

        lengths = {}
        for name in LENGTHS & parameters.keys():
            text = parameters[name]
            number = float(text.rstrip("%"))
            if text.endswith("%"):
                number *= self._diagonal() / 100
            lengths[name] = pymeshlab.PureValue(number)
        return {**parameters, **lengths}

    def _diagonal(self):
        """Of the box around all operands, as their matrices place them."""
        places = [self.meshes.mesh(layer).transformed_vertex_matrix() for layer in self.operands]
        places = np.concatenate([p for p in places if len(p) > 0] or [np.zeros((1, 3))])
        return float(np.linalg.norm(places.max(axis=0) - places.min(axis=0)))

    def save(self, layer, name, **parameters):
        """Writes the layer of that id as folder/name."""
        import pymeshlab

        path = self._folder / name
        self.meshes.set_current_mesh(layer)
        mesh = self.meshes.current_mesh()
        if path.suffix == ".obj" and mesh.face_number() + mesh.edge_number() == 0:
            path.write_text("# empty\n")  # the host refuses to write an OBJ file of nothing
            return
        self._on_progress(f"writing {path.name}", 100)
        try:
            host_call(
                lambda: self.meshes.save_current_mesh(str(path), **parameters), self._on_progress
            )
        except pymeshlab.PyMeshLabException as error:
            raise JobError(f"{path} cannot be written: {error}") from error
        if path.suffix in (".obj", ".off"):
            write_exact_coordinates(path, mesh.vertex_matrix())

    def save_with_numbers(self, layer, name, numbers):
        """Writes the layer as a PLY file whose faces have colours and the attributes named."""
        mesh = self.meshes.mesh(layer)
        self._on_progress(f"writing {name}", 100)
        write_ply(
            self._folder / name, mesh.vertex_matrix(), mesh.face_matrix(),
            (mesh.face_color_matrix() * 255).round(),
            {number: mesh.face_custom_scalar_attribute_array(number) for number in numbers},
        )

    def save_with_distances(self, layer, name, columns_of):
        """Writes the layer, with its matrix applied, as a PLY file.

        columns_of(mesh) gives {name: numbers} of its vertices, and the same of its faces.
        """
        mesh = self.meshes.mesh(layer)
        self._on_progress(f"writing {name}", 100)
        write_ply_columns(
            self._folder / name, mesh.transformed_vertex_matrix(), mesh.face_matrix(),
            *columns_of(mesh),
        )

    def mesh_of(self, layer):
        """The layer of that id."""
        return self.meshes.mesh(layer)

    @property
    def folder(self):
        """Where files go."""
        return self._folder

    def write_record(self, files, record):
        """Writes folder/result.json: the operands' files, those written, and the record."""
        record = {**self._operands_record(), "files": files, **record}
        text = json.dumps(_json_value(record), indent="\t", allow_nan=False)
        (self._folder / "result.json").write_text(text + "\n")

    def _operands_record(self):
        return {"operand_files": self.files}

    def _load(self, path, transform):
        """The layer id of the file's mesh; the parts of a file of several meshes become one."""
        import pymeshlab

        if not path.exists() or path.is_dir():
            raise JobError(f"{path} is not a file")
        self._on_progress(f"reading {path.name}", 0)
        before = self.meshes.mesh_number()
        try:
            host_call(lambda: self.meshes.load_new_mesh(str(path)), self._on_progress)
            if self.meshes.mesh_number() > before + 1:
                parts = pymeshlab.MeshSet()
                parts.load_new_mesh(str(path))
                parts.generate_by_merging_visible_meshes(mergevertices=False)
                self.meshes.add_mesh(parts.current_mesh(), path.name)
        except pymeshlab.PyMeshLabException as error:
            raise _refusal(f"{path} cannot be read: {error}") from error
        if transform is not None:
            matrix = np.reshape(transform, (4, 4))
            self.meshes.set_matrix(transformmatrix=matrix, freeze=False)
        return self.meshes.current_mesh_id()


class Job(LayersJob):
    """The same with two files, the first_mesh and the second_mesh of a filter."""

    def __init__(self, first, second, folder, on_progress, transforms=(None, None)):
        super().__init__({"first": first, "second": second}, folder, on_progress, transforms)

    def run(self, filter_name, **parameters):
        """Runs the filter on both meshes; returns (its result map, the messages that it logged)."""
        first, second = self.operands
        return super().run(filter_name, first_mesh=first, second_mesh=second, **parameters)

    def _operands_record(self):
        return self.files


def _refusal(sentence):
    """The host and the filter say only in words that memory ran out."""
    out_of_memory = "bad_alloc" in sentence or "not enough memory" in sentence
    return MemoryError(sentence) if out_of_memory else Refusal(sentence)


def _json_value(value):
    """The value with lists for arrays.

    JSON has no infinities: a volume beyond the range of double is the string "inf" or "-inf", and
    what is no number, such as the mean of no values, "nan".
    """
    if isinstance(value, dict):
        return {key: _json_value(item) for key, item in value.items()}
    if hasattr(value, "tolist"):  # an array
        value = value.tolist()
    if isinstance(value, list):
        return [_json_value(item) for item in value]
    return str(value) if isinstance(value, float) and not math.isfinite(value) else value
