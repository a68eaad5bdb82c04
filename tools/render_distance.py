# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""render_distance.py: the picture of docs/distance.md, docs/distance.png: two sample meshes in the
colours of their distances from each other, as the command `distance --plot` draws them.
"""

import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path.append(str(ROOT / "tests" / "python"))

from indexboolean import SignedDistance  # noqa: E402
from indexboolean.distance_plot import draw_meshes  # noqa: E402
from sample_catalogue import sample  # noqa: E402


def main():
    first, second = sample("bumpy_sphere"), sample("ribbed_torus")
    meshes = {}
    for side, mesh, other in (("first", first, second), ("second", second, first)):
        distance, _, _ = SignedDistance(other)(mesh[0])
        meshes[side] = (*mesh, distance)
    draw_meshes(meshes, "vertex", ROOT / "docs" / "distance.png")


if __name__ == "__main__":
    main()
