# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The sample meshes are what their catalogue says, and the filter does to them what it says."""

import json
import subprocess
import sys

import numpy as np
import pytest

import contact_filter
import mesh_laws
import sample_catalogue
from run_boolean import BLOCKS, run_boolean

CATALOGUE = json.loads((sample_catalogue.FOLDER / "catalogue.json").read_text(encoding="utf-8"))
MESHES = {mesh["file"]: mesh for mesh in CATALOGUE["meshes"]}
PAIRS = {pair["name"]: pair for pair in CATALOGUE["pairs"]}
# The surfaces of these pairs do not meet in a special way.
GENERAL_PAIRS = [name for name, pair in PAIRS.items() if pair["contact"] != "degenerate"]
DEGENERATE_PAIRS = [name for name, pair in PAIRS.items() if pair["contact"] == "degenerate"]


def operands_of(pair):
    operands = [sample_catalogue.sample(pair[side][: -len(".ply")]) for side in ("first", "second")]
    return (*operands[0], *operands[1])


def test_scriptMakesTheSameBytes(tmp_path):
    script = sample_catalogue.FOLDER / "make_samples.py"
    subprocess.run([sys.executable, str(script), str(tmp_path)], check=True)
    made = {path.name: path.read_bytes() for path in tmp_path.iterdir()}
    kept = {path.name: path.read_bytes() for path in sample_catalogue.FOLDER.glob("*.ply")}
    assert sorted(made) == sorted(kept) == sorted(MESHES)
    for name, data in kept.items():
        assert made[name] == data, f"{name} is not what the script makes"
        assert len(data) < 300_000, f"{name} is too large for a sample"


def test_readmeTablesAreTheCatalogue():
    readme = (sample_catalogue.FOLDER / "README.md").read_text(encoding="utf-8")
    tables = readme.split(sample_catalogue.TABLES_MARK)[1]
    assert tables.strip() == sample_catalogue.tables(CATALOGUE).strip()


@pytest.mark.parametrize("name", MESHES)
def test_meshIsAsCatalogued(name):
    assert sample_catalogue.measure_mesh(name[: -len(".ply")]) == MESHES[name]


@pytest.mark.parametrize("name", MESHES)
def test_meshIsAClosedManifold(name):
    vertices, faces = sample_catalogue.sample(name[: -len(".ply")])
    assert mesh_laws.unmatched_edges(vertices, faces) == 0
    assert mesh_laws.is_edge_manifold(faces)
    assert len(mesh_laws.welded(vertices, faces)[0]) == len(vertices)
    assert len(mesh_laws.zero_area_faces(vertices, faces)) == 0
    # The plain volume that the other tests use, against the exact one.
    assert mesh_laws.volume(vertices, faces) == pytest.approx(MESHES[name]["volume"], rel=1e-15)


@pytest.mark.parametrize("name", PAIRS)
def test_bothOraclesFindTheCataloguedBlocks(name):
    for entry in sample_catalogue.measure_pair(name):
        assert sample_catalogue.disagreement(PAIRS[name], entry) < 1e-12


@pytest.mark.parametrize("name", PAIRS)
def test_contactIsAsCatalogued(name):
    operands = operands_of(PAIRS[name])
    corners = [operands[0][operands[1]], operands[2][operands[3]]]
    pairs = contact_filter.overlapping_boxes(*corners)
    sides = contact_filter.vertex_plane_sides(pairs, *corners)
    edges = contact_filter.edge_edge_sides(pairs, *corners)
    apart = np.zeros(len(pairs), dtype=bool)
    for side in sides:
        apart |= np.all(side > 0, axis=1) | np.all(side < 0, axis=1)
    signs = np.concatenate([*sides, edges], axis=1)[~apart]
    found = "generic" if np.all(signs != 0) else "degenerate"
    assert PAIRS[name]["contact"] == (found if len(signs) else "none")


@pytest.mark.parametrize("name", GENERAL_PAIRS)
def test_blocksAreAsCatalogued(name):
    pair = PAIRS[name]
    blocks = run_boolean(*operands_of(pair))
    scale = sum(MESHES[pair[side]]["volume"] for side in ("first", "second"))
    for block in BLOCKS:
        vertices, faces = blocks[block]
        expected = pair["blocks"][block]
        assert mesh_laws.unmatched_edges(vertices, faces) == 0
        assert len(mesh_laws.zero_area_faces(vertices, faces)) == 0
        found = mesh_laws.volume(vertices, faces)
        assert abs(found - expected["volume"]) <= 1e-12 * scale, block
        assert abs(blocks["result"][f"{block}_volume"] - found) <= 1e-12 * scale, block
        assert mesh_laws.component_count(faces, len(vertices)) == expected["components"], block
        assert blocks["result"][f"{block}_components"] == expected["components"], block
        assert mesh_laws.genus(faces, len(vertices)) == expected["genus"], block


@pytest.mark.parametrize("name", DEGENERATE_PAIRS)
def test_degenerateContactIsAnsweredRightly(name):
    pair = PAIRS[name]
    blocks = run_boolean(*operands_of(pair))
    scale = sum(MESHES[pair[side]]["volume"] for side in ("first", "second"))
    for block in BLOCKS:
        vertices, faces = blocks[block]
        assert mesh_laws.unmatched_edges(vertices, faces) == 0
        assert len(mesh_laws.zero_area_faces(vertices, faces)) == 0
        found = mesh_laws.volume(vertices, faces)
        assert abs(found - pair["blocks"][block]["volume"]) <= 1e-12 * scale, block
