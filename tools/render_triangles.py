# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""render_triangles.py BEFORE [NOW]: docs/triangles.svg, two faces that are cut, as they were
triangulated before edges were flipped to be Delaunay, and as they are now: the lid of a plate from
which cylinders are subtracted, and a face of a torus from which another is subtracted.

in: the plugins' files. BEFORE is of the commit before 9498caf, which `tools/same_results 9498caf~1`
builds in out/guard/tree; NOW is the package's, if it is not given. Each runs in a process of its
own, since the host loads one plugin only.
"""

import pathlib
import subprocess
import sys
import tempfile

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path.append(str(ROOT / "tests" / "python"))

import fold_pairs  # noqa: E402
import judges  # noqa: E402
from plain_solids import box, joined, make_samples, shifted  # noqa: E402

FILE = ROOT / "docs" / "triangles.svg"
WIDTH, DEPTH, LID = 4.0, 3.0, 0.5
HOLES = [(0.8, 0.8, 0.45), (2.3, 0.7, 0.3), (3.3, 1.1, 0.5), (1.6, 1.9, 0.55), (3.0, 2.4, 0.3)]
TORUS_FACE = 489  # of the first torus
THIN = 1.0  # degrees; triangles with smaller angles are red
RED, BLUE = (0.93, 0.45, 0.4), (0.80, 0.88, 0.96)
NEAR = 1e-9  # a vertex of a result lies in a face if it is no farther away


def plate_and_cylinders():
    """Both operands, and the corners of what is drawn: of a triangle that contains the lid."""
    cylinders = [
        shifted(make_samples.cylinder(32, radius, 1.0), (x, y, 0)) for x, y, radius in HOLES
    ]
    plate = box((0, 0, -LID), (WIDTH, DEPTH, LID))
    return plate, joined(*cylinders), np.array([(0, 0, LID), (9, 0, LID), (0, 9, LID)])


def tori():
    """Both operands, and the corners of the face that is drawn."""
    first, second = fold_pairs.load_pair("torus, torus moved")
    return first, second, first[0][first[1][TORUS_FACE]]


CUTS = (plate_and_cylinders, tori)


def save_differences(plugin, folder):
    """In a process of its own: what a plugin makes of A − B."""
    import pymeshlab

    pymeshlab.load_plugin(plugin)
    for cut in CUTS:
        document = pymeshlab.MeshSet()
        for mesh in cut()[:2]:
            document.add_mesh(pymeshlab.Mesh(*mesh))
        result = document.apply_filter("generate_index_boolean", first_mesh=0, second_mesh=1)
        made = document.mesh(int(result["first_minus_second_layer"]))
        path = pathlib.Path(folder) / f"{cut.__name__}.npz"
        np.savez(path, points=made.vertex_matrix(), faces=made.face_matrix())


def pieces_of(face, points, faces):
    """The triangles that lie in a face, in coordinates of its plane (k x 3 x 2), and which of them
    are needles, and their smallest angles."""
    across = (face[1] - face[0]) / np.linalg.norm(face[1] - face[0])
    normal = np.cross(across, face[2] - face[0])
    normal /= np.linalg.norm(normal)
    axes = np.stack([across, np.cross(normal, across)], axis=1)
    corners = points - face[0]
    edges = (face - face[0]) @ axes
    inside = np.abs(corners @ normal) < NEAR
    for start, end in zip(edges, np.roll(edges, -1, axis=0)):
        inwards = np.array([start[1] - end[1], end[0] - start[0]])
        inside &= (corners @ axes - start) @ inwards > -NEAR
    chosen = faces[inside[faces].all(axis=1)]
    needles = [judges.needles(points, triangle[None]) == 1 for triangle in chosen]
    return (corners @ axes)[chosen], np.array(needles), judges.smallest_angles(points, chosen)


def draw(axes, title, triangles, needles, angles):
    """A panel: the triangles, thin ones in red, needles, which have no width, as red lines."""
    from matplotlib.collections import PolyCollection

    colours = np.where((angles < THIN)[:, None], RED, BLUE)
    width = 0.3 if len(triangles) > 99 else 1
    axes.add_collection(
        PolyCollection(triangles, facecolors=colours, edgecolors="black", linewidths=width)
    )
    if len(triangles) < 99:
        for needle in triangles[needles]:
            axes.plot(*needle.T, color="red", linewidth=2.5, marker="o", markersize=5)
    counted = f"{np.count_nonzero(angles < THIN)} of {len(angles)} below {THIN:g}°"
    axes.set_title(f"{title}: {counted}, the smallest {angles.min():.2g}°", fontsize=10)
    axes.set_aspect("equal")
    axes.autoscale_view()
    axes.axis("off")


def main(before, now):
    from matplotlib import pyplot

    pyplot.rcParams["svg.hashsalt"] = "triangles"
    figure, panels = pyplot.subplots(
        2, 2, figsize=(9, 6), layout="constrained", height_ratios=(3, 2)
    )
    for column, (title, plugin) in enumerate((("before", before), ("now", now))):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([sys.executable, __file__, "--save", plugin, folder], check=True)
            for row, cut in enumerate(CUTS):
                with np.load(pathlib.Path(folder) / f"{cut.__name__}.npz") as made:
                    pieces = pieces_of(cut()[2], made["points"], made["faces"])
                draw(panels[row, column], title, *pieces)
    figure.savefig(FILE, metadata={"Date": None})
    return figure


if __name__ == "__main__":
    if sys.argv[1] == "--save":
        save_differences(*sys.argv[2:])
    else:
        from indexboolean.plugin import plugin_path

        main(sys.argv[1], sys.argv[2] if len(sys.argv) > 2 else plugin_path())
