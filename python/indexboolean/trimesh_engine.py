# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""An engine of trimesh.boolean: trimesh.boolean.union([a, b], engine="indexboolean")."""

from .mesh_calls import boolean, evaluate, resolve

NAME = "indexboolean"


def register_trimesh_engine():
    """Makes "indexboolean" an engine of trimesh.boolean and of the methods of meshes.

    A second call does nothing. Raises ImportError if trimesh is not installed, or has no table of
    engines.
    """
    import trimesh

    try:
        engines = trimesh.boolean._engines
        available = trimesh.boolean.engines_available
    except AttributeError:
        raise ImportError(
            f"trimesh {trimesh.__version__} has no table of engines; indexboolean.boolean works "
            "with any version"
        ) from None
    engines[NAME] = _engine
    available.add(NAME)


def _engine(meshes, operation, check_volume=True, **options):
    """What trimesh calls; options are those of indexboolean.evaluate.

    check_volume is trimesh's: whether to look for what is no solid. That is always done, and by
    what is accepted (docs/boolean.md), not by is_volume.
    """
    meshes = list(meshes)
    if not meshes:
        raise ValueError(f"there is no mesh; {operation} takes a list of one or more")
    if operation == "difference" and len(meshes) < 2:
        raise ValueError("a difference is of two meshes or more")
    if len(meshes) == 1:
        return resolve(meshes[0], **options)
    if len(meshes) == 2:
        return boolean(*meshes, operation, **options)
    operands = {f"mesh_{number}": mesh for number, mesh in enumerate(meshes)}
    return evaluate(f"{operation}({', '.join(operands)})", operands, **options)
