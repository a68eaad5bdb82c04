# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The signed distance from a mesh at any points: arrays in, arrays out.

The functions are those that the plugin's library exports (filter_indexboolean/runs/
distance_functions.h), called through ctypes, which lets other threads of Python run meanwhile.
"""

import ctypes
import functools
import weakref

import numpy as np

from .plugin import load_plugin, plugin_path

SELF_INTERSECTIONS = ("resolve", "trust", "refuse")
WINDING_RULES = ("nonzero", "positive", "odd")
_MOST = 2**31 - 1  # faces and vertices
_RELATIVE_ERROR = 2.0**-45


class _Surface(ctypes.Structure):
    _fields_ = [
        ("points", ctypes.c_void_p), ("point_count", ctypes.c_int64),
        ("triangles", ctypes.c_void_p), ("triangle_count", ctypes.c_int64),
        ("is_signed", ctypes.c_int32), ("self_intersections", ctypes.c_int32),
        ("winding_rule", ctypes.c_int32), ("threads", ctypes.c_int32),
    ]


class _Report(ctypes.Structure):
    _fields_ = [
        ("is_closed", ctypes.c_int32), ("is_resolved", ctypes.c_int32),
        ("was_inside_out", ctypes.c_int32), ("self_intersecting_faces", ctypes.c_int64),
        ("volume", ctypes.c_double), ("seconds", ctypes.c_double),
        ("error", ctypes.c_double),
    ]


class _Distances(ctypes.Structure):
    _fields_ = [(name, ctypes.c_void_p) for name in (
        "distance", "gradient", "face", "closest", "sign",
    )]


class SignedDistance:
    """A mesh as an implicit function: negative inside, 0 on the surface, positive outside.

    mesh: a pair (n x 3 vertices, m x 3 indices); a pymeshlab.Mesh, whose matrix is applied; or
    anything with the attributes `vertices` and `faces`, as trimesh has it. It is copied, and its
    search tree is built once.

    signed=False: distances without a sign, to all faces as they are. self_intersections
    ("resolve", "trust", "refuse") and winding_rule ("nonzero", "positive", "odd") as in the
    filters. threads: 0 as many as there are (OMP_NUM_THREADS).

    An object may be called from several threads at once. Attributes: is_closed (the sign is that
    of the winding number, exactly; else of the side of the nearest feature), is_resolved,
    was_inside_out, self_intersecting_faces, volume, seconds.

    Raises ValueError with a sentence if the mesh cannot be used, MemoryError, HostError.
    """

    def __init__(
        self, mesh, *, signed=True, self_intersections="resolve", winding_rule="nonzero", threads=0,
    ):
        vertices, faces = _arrays_of(mesh)
        surface = _Surface(
            vertices.ctypes.data, len(vertices), faces.ctypes.data, len(faces), bool(signed),
            _number_of("self_intersections", self_intersections, SELF_INTERSECTIONS),
            _number_of("winding_rule", winding_rule, WINDING_RULES), threads,
        )
        report, message = _Report(), ctypes.create_string_buffer(1000)
        library = _library()
        self._handle = library.indexBooleanDistanceNew(
            ctypes.byref(surface), ctypes.byref(report), message, len(message)
        )
        if not self._handle:
            sentence = message.value.decode(errors="replace")
            raise (MemoryError if "memory" in sentence else ValueError)(f"the mesh {sentence}")
        weakref.finalize(self, library.indexBooleanDistanceFree, self._handle)
        self.is_closed = bool(report.is_closed)
        self.is_resolved = bool(report.is_resolved)
        self.was_inside_out = bool(report.was_inside_out)
        self.self_intersecting_faces = report.self_intersecting_faces
        self.volume = report.volume
        self.seconds = report.seconds
        self._error = report.error

    def __call__(self, points, *, max_distance=np.inf, negate=False):
        """(distance, gradient, face) of n x 3 points: arrays of n, n x 3 and n.

        Distances beyond max_distance and of points that are not finite are NaN, as is their
        gradient, and their face is -1. negate: positive inside.
        """
        distance, gradient, face, _, _ = self._sample(points, max_distance, negate)
        return distance, gradient, face

    def closest(self, points, *, max_distance=np.inf):
        """(closest point, face) of n x 3 points: arrays of n x 3 and n; NaN and -1 as above."""
        _, _, face, closest, _ = self._sample(points, max_distance, False)
        return closest, face

    def sign(self, points):
        """-1 inside, 0 on the surface, 1 outside, of n x 3 points; 0 of what is not finite."""
        return self._sample(points, np.inf, False)[4]

    def error_bound(self, distance):
        """No distance of this size (a number or an array) is farther from the true one."""
        return self._error + _RELATIVE_ERROR * np.abs(distance)

    def _sample(self, points, max_distance, negate):
        points = np.ascontiguousarray(points, dtype=np.float64)
        if points.ndim != 2 or points.shape[1] != 3:
            raise ValueError(f"points are n x 3 numbers, not {points.shape}")
        if not max_distance >= 0:
            raise ValueError(f"max_distance is {max_distance}, not 0 or more")
        count = len(points)
        arrays = (
            np.empty(count), np.empty((count, 3)), np.empty(count, dtype=np.int64),
            np.empty((count, 3)), np.empty(count, dtype=np.int8),
        )
        out = _Distances(*(array.ctypes.data for array in arrays))
        if _library().indexBooleanDistanceSample(
            self._handle, points.ctypes.data, count, max_distance, bool(negate), ctypes.byref(out)
        ):
            raise MemoryError("not enough memory for the distances")
        return arrays


@functools.lru_cache(maxsize=None)
def _library():
    """The plugin's library; the host, whose libraries it needs, is loaded first."""
    load_plugin()
    library = ctypes.CDLL(plugin_path())
    library.indexBooleanDistanceNew.restype = ctypes.c_void_p
    library.indexBooleanDistanceNew.argtypes = [
        ctypes.POINTER(_Surface), ctypes.POINTER(_Report), ctypes.c_char_p, ctypes.c_int64,
    ]
    library.indexBooleanDistanceSample.restype = ctypes.c_int32
    library.indexBooleanDistanceSample.argtypes = [
        ctypes.c_void_p, ctypes.c_void_p, ctypes.c_int64, ctypes.c_double, ctypes.c_int32,
        ctypes.POINTER(_Distances),
    ]
    library.indexBooleanDistanceFree.restype = None
    library.indexBooleanDistanceFree.argtypes = [ctypes.c_void_p]
    return library


def _number_of(name, word, words):
    if word not in words:
        raise ValueError(f"{name} is {word!r}; there are {', '.join(words)}")
    return words.index(word)


def _arrays_of(mesh):
    """The vertices and faces of any mesh as contiguous arrays."""
    if hasattr(mesh, "vertex_matrix"):
        vertices = mesh.transformed_vertex_matrix()
        faces = mesh.face_matrix()
    elif hasattr(mesh, "vertices"):
        vertices, faces = mesh.vertices, mesh.faces
    else:
        vertices, faces = mesh
    vertices = np.ascontiguousarray(vertices, dtype=np.float64)
    faces = np.asarray(faces)
    if faces.size == 0:
        faces = np.empty((0, 3), dtype=np.int32)
    for name, array in (("vertices", vertices), ("faces", faces)):
        if array.ndim != 2 or array.shape[1] != 3:
            raise ValueError(f"{name} are n x 3 numbers, not {array.shape}")
    if not np.issubdtype(faces.dtype, np.integer):
        raise ValueError(f"faces are indices, not {faces.dtype}")
    if max(len(vertices), len(faces)) > _MOST or faces.max(initial=0) > _MOST:
        raise ValueError("the mesh is too large: there may be 2^31 - 1 vertices and faces")
    return vertices, np.ascontiguousarray(faces, dtype=np.int32)
