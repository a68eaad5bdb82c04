# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""1000 random pairs of surfaces, open ones among them: pieces and volumes against libigl's cells.

Seeds are fixed; a failure names the seed, and random_pair(seed) makes the pair again.
"""

import numpy as np
import pytest

import mesh_laws
import oracles
import shapes
from open_shapes import bumpy_sheet, flipped
from seed_batches import check_batch
from split_run import Split, check_laws

BATCHES = 10
PAIRS_PER_BATCH = 100
LAWS_STRIDE = 5


def opened(mesh, rng):
    """The part of a mesh on one side of a random plane, by whole faces."""
    vertices, faces = mesh
    heights = vertices[faces].mean(axis=1) @ rng.normal(size=3)
    kept = heights < np.quantile(heights, rng.uniform(0.3, 0.95))
    return mesh_laws.welded(vertices, faces[kept])


def with_faces_turned(mesh, rng):
    """The same surface with some faces seen from the other side."""
    vertices, faces = mesh
    faces = faces.copy()
    turned = rng.random(len(faces)) < 0.3
    faces[turned] = faces[turned][:, ::-1]
    return vertices, faces


def random_surface(rng):
    """A sheet, an open part of a solid, or a solid."""
    draw = rng.random()
    if draw < 0.4:
        steps = int(rng.integers(1, 9))
        sheet = bumpy_sheet(rng.normal(size=3), rng.normal() / 5, rng.uniform(0.3, 1.6), steps, 0.1)
        return flipped(*sheet) if rng.random() < 0.5 else sheet
    solid = shapes.placed(shapes.random_operand(rng), rng)
    if draw < 0.7:
        return opened(solid, rng)
    return solid


def random_pair(seed):
    """Two surfaces: crossing in general position, at times apart or nested."""
    rng = np.random.default_rng([seed, 7])
    first = shapes.placed(random_surface(rng), rng)
    shift = rng.normal(size=3) * rng.uniform(0, 0.7)
    second = shapes.placed(random_surface(rng), rng, rng.choice([0.3, 0.7, 1.0, 1.3]), shift)
    return first, second


def check_pair(seed):
    first, second = random_pair(seed)
    split = Split(first, second)
    *patches, volumes = oracles.libigl_cells(*first, *second)
    assert list(split.counts()) == [*patches, len(volumes)], (
        f"{split.counts()}, libigl: {patches}, {len(volumes)}"
    )
    scale = max(volumes.sum(), 1e-3)
    difference = np.abs(np.sort(volumes) - split.volumes()).max(initial=0)
    assert difference <= 1e-9 * scale, f"volumes differ by {difference}"
    if seed % LAWS_STRIDE == 0:
        check_laws(split)


@pytest.mark.parametrize("batch", range(BATCHES))
def test_piecesOfRandomPairsAreLibigls(batch):
    check_batch(batch, PAIRS_PER_BATCH, check_pair)


def test_facesTurnedHereAndThereChangeNoBlock():
    for seed in range(0, 200, 10):
        first, second = random_pair(seed)
        rng = np.random.default_rng([seed, 8])
        turned = Split(with_faces_turned(first, rng), second)
        assert turned.counts() == Split(first, second).counts(), f"seed {seed}"
        assert turned.volumes() == pytest.approx(Split(first, second).volumes(), rel=1e-9)


def test_pairsCoverOpenClosedCuttingAndNot():
    kinds = {(False, False): 0, (False, True): 0, (True, False): 0, (True, True): 0}
    cut = blocks = 0
    for seed in range(0, BATCHES * PAIRS_PER_BATCH, 10):
        first, second = random_pair(seed)
        kinds[tuple(mesh_laws.unmatched_edges(*mesh) == 0 for mesh in (first, second))] += 1
        counts = Split(first, second).counts()
        cut += counts[0] + counts[1] > 2
        blocks += counts[2] > 0
    assert min(kinds.values()) >= 5, kinds
    assert cut >= 30 and blocks >= 30, (cut, blocks)
