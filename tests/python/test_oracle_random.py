# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""2000 random pairs of small closed meshes: all four blocks against manifold3d, laws, membership.

Seeds are fixed; a failure names the seed, and shapes.generic_pair(seed) makes the pair again.
"""

import numpy as np
import pytest

import mesh_laws
import oracles
import shapes
from run_boolean import BLOCKS, SWAPPED_BLOCKS, run_boolean
from seed_batches import check_batch

BATCHES = 20
PAIRS_PER_BATCH = 100
# Every n-th pair also goes through the slower checks.
MEMBERSHIP_STRIDE = 5
INVARIANCE_STRIDE = 5
MEMBERSHIP_POINTS = 24

TRUTH = {
    "union": lambda a, b: a | b,
    "intersection": lambda a, b: a & b,
    "first_minus_second": lambda a, b: a & ~b,
    "second_minus_first": lambda a, b: ~a & b,
}


def check_surface(mesh, block):
    vertices, faces = mesh
    assert mesh_laws.unmatched_edges(vertices, faces) == 0, f"{block} is not closed"
    assert len(mesh_laws.zero_area_faces(vertices, faces)) == 0, f"{block} has zero-area faces"
    assert len(np.unique(faces)) == len(vertices), f"{block} has unreferenced vertices"


def check_laws(volumes, first_volume, second_volume):
    scale = first_volume + second_volume
    union_law = volumes["union"] + volumes["intersection"] - scale
    first_law = volumes["first_minus_second"] + volumes["intersection"] - first_volume
    second_law = volumes["second_minus_first"] + volumes["intersection"] - second_volume
    residual = max(abs(union_law), abs(first_law), abs(second_law)) / scale
    assert residual <= 1e-12, f"volume law residual {residual}"


def check_result_map(result, blocks, scale):
    for block in BLOCKS:
        vertices, faces = blocks[block]
        assert result[f"{block}_closed"], f"{block} is reported open"
        assert result[f"{block}_faces"] == len(faces), f"{block}: reported faces"
        found = mesh_laws.component_count(faces, len(vertices))
        assert result[f"{block}_components"] == found, f"{block}: reported components"
        difference = abs(result[f"{block}_volume"] - mesh_laws.volume(vertices, faces))
        assert difference <= 1e-12 * scale, f"{block}: reported volume"


def check_against_oracle(blocks, operands, scale):
    expected = oracles.manifold_blocks(*operands)
    area_scale = mesh_laws.area(*operands[:2]) + mesh_laws.area(*operands[2:])
    for block in BLOCKS:
        found, other = blocks[block], expected[block]
        difference = mesh_laws.volume(*found) - mesh_laws.volume(*other)
        assert abs(difference) <= 1e-9 * scale, f"{block}: volume differs by {difference}"
        difference = mesh_laws.area(*found) - mesh_laws.area(*other)
        assert abs(difference) <= 1e-9 * area_scale, f"{block}: area differs by {difference}"
        euler = mesh_laws.euler_number(found[1]), mesh_laws.euler_number(other[1])
        assert euler[0] == euler[1], f"{block}: Euler number, manifold3d's: {euler}"


def check_membership(blocks, operands, seed):
    """inside(A op B, p) == inside(A, p) op inside(B, p) at random points, by rays."""
    rng = np.random.default_rng([seed, 1])
    union = blocks["union"][0]
    points = rng.uniform(union.min(axis=0), union.max(axis=0), (MEMBERSHIP_POINTS, 3))
    in_first, decided = mesh_laws.winding_numbers(points, *operands[:2])
    in_second, decided_too = mesh_laws.winding_numbers(points, *operands[2:])
    decided &= decided_too
    for block in BLOCKS:
        number, decided_too = mesh_laws.winding_numbers(points, *blocks[block])
        usable = decided & decided_too
        assert usable.mean() > 0.9, "too few points that rays can decide"
        expected = TRUTH[block](in_first >= 1, in_second >= 1).astype(np.int64)
        wrong = np.flatnonzero(usable & (number != expected))
        assert len(wrong) == 0, f"{block}: membership of {points[wrong].tolist()}"


def check_invariance(blocks, operands, seed):
    """Operands swapped and shuffled: the same sets of triangles."""
    rng = np.random.default_rng([seed, 2])
    first, second = (shapes.shuffled(*mesh, rng) for mesh in (operands[:2], operands[2:]))
    other = run_boolean(*second, *first)
    for block, swapped in zip(BLOCKS, SWAPPED_BLOCKS):
        same = np.array_equal(
            mesh_laws.triangle_set(*blocks[block]), mesh_laws.triangle_set(*other[swapped])
        )
        assert same, f"{block} differs after a swap and a shuffle"


def check_pair(seed):
    operands = shapes.generic_pair(seed)
    blocks = run_boolean(*operands)
    first_volume = mesh_laws.volume(*operands[:2])
    second_volume = mesh_laws.volume(*operands[2:])
    scale = first_volume + second_volume
    for block in BLOCKS:
        check_surface(blocks[block], block)
    volumes = oracles.volumes({block: blocks[block] for block in BLOCKS})
    check_laws(volumes, first_volume, second_volume)
    check_result_map(blocks["result"], blocks, scale)
    check_against_oracle(blocks, operands, scale)
    if seed % MEMBERSHIP_STRIDE == 0:
        check_membership(blocks, operands, seed)
    if seed % INVARIANCE_STRIDE == 1:
        check_invariance(blocks, operands, seed)


@pytest.mark.parametrize("batch", range(BATCHES))
def test_blocksOfGenericPairsAreRight(batch):
    check_batch(batch, PAIRS_PER_BATCH, check_pair)


def test_operandsAreClosedAndEmbedded():
    for seed in range(0, BATCHES * PAIRS_PER_BATCH, 40):
        operands = shapes.generic_pair(seed)
        for mesh in (operands[:2], operands[2:]):
            check_surface(mesh, f"an operand of seed {seed}")
            assert oracles.is_embedded(*mesh), f"an operand of seed {seed} meets itself"


def test_pairsCoverCrossingNestedAndApart():
    crossing = nested = apart = 0
    for seed in range(0, BATCHES * PAIRS_PER_BATCH, 20):
        operands = shapes.generic_pair(seed)
        volumes = oracles.volumes(oracles.manifold_blocks(*operands))
        smaller = min(mesh_laws.volume(*operands[:2]), mesh_laws.volume(*operands[2:]))
        share = volumes["intersection"] / smaller
        apart += share == 0
        nested += share > 1 - 1e-12
        crossing += 0 < share < 1 - 1e-12
    assert crossing >= 50 and nested >= 3 and apart >= 3, (crossing, nested, apart)
