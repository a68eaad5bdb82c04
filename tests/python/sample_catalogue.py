# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The catalogue of sample_meshes/: why each mesh is kept, and what is expected of it.

As a program it measures the meshes and, by both oracles, the blocks of each pair, and writes
catalogue.json and the tables of README.md. Guarantee: a mesh's volume is the exact one, rounded
once; a block's figures are written only if the oracles agree.
"""

import json
from fractions import Fraction
from pathlib import Path

import mesh_laws
import oracles
from placements import read_mesh

FOLDER = Path(__file__).resolve().parents[2] / "sample_meshes"
TABLES_MARK = "<!-- tables: written by tests/python/sample_catalogue.py -->\n"
BLOCK_TITLES = {
    "union": "A ∪ B",
    "intersection": "A ∩ B",
    "first_minus_second": "A − B",
    "second_minus_first": "B − A",
}

REASONS = {
    "bumpy_sphere": "a solid with waves in all directions",
    "ribbed_torus": "genus 1, ribs that wind round the tube",
    "nested_outer": "an ellipsoid around nested_inner",
    "nested_inner": "a small torus that meets nothing",
    "two_balls": "one operand of two components",
    "hollow_ball": "a cavity: the inner component is inside out, as it must be",
    "bar": "long thin walls; meets both balls, and runs through the cavity",
    "wide_cylinder": "long thin walls",
    "narrow_cylinder": "crosses the wide one: two hard-closed loops",
    "statue": "a figure, arms akimbo: genus 3, features of many sizes",
    "wavy_cutter": "a thin solid sheet that cuts the statue in many places",
    "cylinder_along_x": "the paper's cylinders: equal radii, every rib meets a rib",
    "cylinder_along_y": "its mirror image",
    "torus_about_z": "the paper's tori: same inner radius, four common vertices",
    "torus_about_x": "its mirror image",
}

# name: first, second, contact. Generic contact: no vertex on a face, no two edges that meet.
PAIRS = {
    "general": ("bumpy_sphere", "ribbed_torus", "generic"),
    "nested": ("nested_outer", "nested_inner", "none"),
    "components": ("two_balls", "bar", "generic"),
    "cavity": ("hollow_ball", "bar", "generic"),
    "crossing_cylinders": ("wide_cylinder", "narrow_cylinder", "generic"),
    "statue": ("statue", "wavy_cutter", "generic"),
    "equal_cylinders": ("cylinder_along_x", "cylinder_along_y", "degenerate"),
    "equal_tori": ("torus_about_z", "torus_about_x", "degenerate"),
}


def sample(name):
    """The arrays of a sample mesh."""
    return read_mesh(FOLDER / f"{name}.ply")


def exact_volume(vertices, faces):
    """The volume of a mesh on the samples' grid, rounded once."""
    scaled = vertices * 2.0**20
    integers = [[int(x) for x in row] for row in scaled]
    assert (scaled == integers).all(), "a coordinate is no multiple of 2^-20"
    six_volumes = 0
    for face in faces.tolist():
        (ax, ay, az), (bx, by, bz), (cx, cy, cz) = (integers[corner] for corner in face)
        six_volumes += ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz)
        six_volumes += az * (bx * cy - by * cx)
    return float(Fraction(six_volumes, 6 * 2**60))


def measure_mesh(name):
    """One entry of the catalogue's meshes."""
    vertices, faces = sample(name)
    return {
        "file": f"{name}.ply",
        "why": REASONS[name],
        "vertices": len(vertices),
        "faces": len(faces),
        "components": mesh_laws.component_count(faces, len(vertices)),
        "genus": mesh_laws.genus(faces, len(vertices)),
        "volume": exact_volume(vertices, faces),
        "licence": "CC0-1.0",
    }


def measure_block(mesh, with_topology):
    """Volume and, where the contact leaves no choice of copies, components and genus."""
    vertices, faces = mesh
    figures = {"volume": mesh_laws.volume(vertices, faces)}
    if with_topology:
        figures["components"] = mesh_laws.component_count(faces, len(vertices))
        figures["genus"] = mesh_laws.genus(faces, len(vertices))
    return figures


def measure_pair(name):
    """One entry of the catalogue's pairs by each oracle: (libigl's, manifold3d's)."""
    first, second, contact = PAIRS[name]
    operands = (*sample(first), *sample(second))
    entries = []
    for blocks in (oracles.libigl_blocks(*operands), oracles.manifold_blocks(*operands)):
        entries.append(
            {
                "name": name,
                "first": f"{first}.ply",
                "second": f"{second}.ply",
                "contact": contact,
                "blocks": {
                    block: measure_block(mesh, contact != "degenerate")
                    for block, mesh in blocks.items()
                },
            }
        )
    return tuple(entries)


def disagreement(entry, other):
    """The largest difference of two entries' volumes relative to V(A) + V(B).

    Infinite where components or genus differ. V(A) + V(B) = V(union) + V(intersection).
    """
    blocks, others = entry["blocks"], other["blocks"]
    scale = blocks["union"]["volume"] + blocks["intersection"]["volume"]
    worst = 0.0
    for block, figures in blocks.items():
        worst = max(worst, abs(figures["volume"] - others[block]["volume"]) / scale)
        if any(figures.get(key) != others[block].get(key) for key in ("components", "genus")):
            return float("inf")
    return worst


def measure():
    """The whole catalogue. Raises ValueError where the oracles disagree."""
    pairs = []
    for name in PAIRS:
        entry, other = measure_pair(name)
        if disagreement(entry, other) > 1e-12:
            raise ValueError(f"the oracles disagree on {name}: {entry} and {other}")
        pairs.append(entry)
    return {"meshes": [measure_mesh(name) for name in REASONS], "pairs": pairs}


def tables(catalogue):
    """The catalogue as Markdown tables."""
    lines = [
        "| file | why kept | faces | components | genus | volume | licence |",
        "|---|---|---|---|---|---|---|",
    ]
    for mesh in catalogue["meshes"]:
        lines.append(
            "| {file} | {why} | {faces} | {components} | {genus} | {volume:.12f} | {licence} |"
            .format(**mesh)
        )
    lines += [
        "",
        "| pair | A | B | contact | " + " | ".join(BLOCK_TITLES.values()) + " |",
        "|---|---|---|---|" + "---|" * len(BLOCK_TITLES),
    ]
    for pair in catalogue["pairs"]:
        cells = [pair["name"], pair["first"], pair["second"], pair["contact"]]
        for block in BLOCK_TITLES:
            cells.append("{volume:.12f}".format(**pair["blocks"][block]))
            if "components" in pair["blocks"][block]:
                cells[-1] += " ({components}, {genus})".format(**pair["blocks"][block])
        lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n"


def main():
    catalogue = measure()
    text = json.dumps(catalogue, indent=1, ensure_ascii=False) + "\n"
    (FOLDER / "catalogue.json").write_text(text, encoding="utf-8")
    readme = FOLDER / "README.md"
    opening = readme.read_text(encoding="utf-8").split(TABLES_MARK)[0]
    readme.write_text(opening + TABLES_MARK + "\n" + tables(catalogue), encoding="utf-8")


if __name__ == "__main__":
    main()
