# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Chains with merged walls, beside Manifold's of the same operands.

out: merged_steps(kind, seed, steps, scalar, tolerance), manifold_steps(kind, seed, steps, scalar);
each yields what a step has made. Guarantee: both are given the same operands, stored alike.
"""

from dataclasses import dataclass

import numpy as np
import pymeshlab

import chain_kinds
import mesh_laws
import oracles
from run_boolean import BLOCKS, run_boolean

SHARE = 1e-12  # of the operands' diagonal, in doubles
FLOAT_ULPS = 4  # at the largest coordinate, in floats


@dataclass(frozen=True)
class MergedStep:
    number: int
    mesh: tuple
    values: dict  # of the result map, by what follows the block's name
    tolerance: float
    unmerged_volume: float  # of the same operands' result without a tolerance; None if not asked


def as_stored(mesh, scalar):
    """The mesh as a host has it that stores the scalar, host or float."""
    return mesh if scalar == "host" else (mesh[0].astype(np.float32).astype(np.float64), mesh[1])


def tolerance_of(operands, scalar):
    """What rounding alone does to walls, and little more."""
    points = np.concatenate([points for points, _ in operands])
    if scalar == "float":
        return FLOAT_ULPS * float(np.spacing(np.float32(np.abs(points).max())))
    return SHARE * float(np.linalg.norm(points.max(axis=0) - points.min(axis=0)))


def one_block(operands, operation, scalar, tolerance):
    """(the block's mesh, its values in the result map)"""
    made = run_boolean(
        *operands[0], *operands[1], certify_as=scalar,
        merge_tolerance=pymeshlab.PureValue(tolerance), **{b: b == operation for b in BLOCKS},
    )
    values = {
        key.removeprefix(f"{operation}_"): value for key, value in made["result"].items()
        if key.startswith(operation)
    }
    return made[operation], values


def merged_steps(kind, seed, steps, scalar="host", with_unmerged=True):
    """Each step of a chain whose walls are merged."""
    chain = chain_kinds.make_chain(kind, seed, steps)
    mesh = as_stored(chain.start, scalar)
    for number, step in enumerate(chain.steps, 1):
        operands = mesh, as_stored(step.operand, scalar)
        tolerance = tolerance_of(operands, scalar)
        volume = None
        if with_unmerged:
            volume = one_block(operands, step.operation, scalar, 0)[1]["volume"]
        mesh, values = one_block(operands, step.operation, scalar, tolerance)
        yield MergedStep(number, mesh, values, tolerance, volume)


def manifold_steps(kind, seed, steps, scalar="host"):
    """The faces of Manifold's result after each step; it is given its own results as stored."""
    chain = chain_kinds.make_chain(kind, seed, steps)
    mesh = as_stored(chain.start, scalar)
    for step in chain.steps:
        blocks = oracles.manifold_blocks(*mesh, *as_stored(step.operand, scalar))
        mesh = as_stored(blocks[step.operation], scalar)
        yield len(mesh[1])


def allowed_volume(step):
    """How far the volume may be from that of the unmerged result."""
    return step.tolerance * mesh_laws.area(*step.mesh)
