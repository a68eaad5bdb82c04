# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the plugin is, and how pymeshlab comes to know it."""

import importlib.metadata
import os
import pathlib
import sys

from .host_lock import host_lock

# The host loads plugins that were built for its own version and scalar only.
_HOST_VERSION = "2025.7"
_FILTERS = (
    "generate_index_boolean", "generate_index_boolean_split", "generate_index_boolean_curves",
    "generate_index_boolean_expression", "generate_index_boolean_resolve",
    "compute_index_boolean_distance", "compute_index_boolean_implicit",
)
# The filters' parameters that are lengths, which the host takes as objects of its own.
LENGTHS = {"weld_distance", "merge_tolerance", "max_distance"}


class HostError(ImportError):
    """pymeshlab is absent, cannot be imported, or is not the version that the plugin is for."""


def plugin_path():
    """The plugin's file as a string, for pymeshlab.load_plugin or MeshLab's plugin dialog."""
    name = "filter_indexboolean.dll" if os.name == "nt" else "libfilter_indexboolean.so"
    return str(pathlib.Path(__file__).with_name(name))


def load_plugin():
    """Makes the filters of the plugin methods of pymeshlab.MeshSet; a second call does nothing.

    Raises HostError with a sentence that says what to install.
    """
    with host_lock():
        pymeshlab = _import_host()
        if not set(_FILTERS) <= set(pymeshlab.filter_list()):
            if sys.platform == "darwin":
                _require_one_folder(pymeshlab)
            pymeshlab.load_plugin(plugin_path())
        for name in _FILTERS:
            if not hasattr(pymeshlab.MeshSet, name):
                setattr(pymeshlab.MeshSet, name, pymeshlab.bind_function(name))


def _require_one_folder(pymeshlab):
    """On macOS the plugin finds the host's libraries by their place as seen from its own."""
    ours, theirs = (
        pathlib.Path(path).resolve().parents[1] for path in (plugin_path(), pymeshlab.__file__)
    )
    if ours != theirs:
        raise HostError(
            f"indexboolean is installed in {ours}, pymeshlab in {theirs}; on macOS both must be in "
            "one environment: make one by python -m venv, and install both with its pip"
        )


def _import_host():
    remedy = f'python -m pip install "pymeshlab=={_HOST_VERSION}.*"'
    try:
        version = importlib.metadata.version("pymeshlab")
    except importlib.metadata.PackageNotFoundError:
        raise HostError(f"pymeshlab is not installed; install it by: {remedy}") from None
    if version.split(".")[:2] != _HOST_VERSION.split("."):
        raise HostError(
            f"pymeshlab {version} is installed, but this plugin is built for pymeshlab "
            f"{_HOST_VERSION}; install that by: {remedy}"
        )
    try:
        import pymeshlab
    except ImportError as error:
        raise HostError(
            f"pymeshlab {version} cannot be imported: {error}; it needs the system's OpenGL "
            "library (Debian: libgl1)"
        ) from error
    return pymeshlab
