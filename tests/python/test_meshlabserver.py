# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The old host in float: the same blocks as pymeshlab's and the core's, and failures that are told.

All coordinates of the operands are floats, so that every host is given the same.
"""

import re
import xml.etree.ElementTree as ElementTree

import numpy as np
import pymeshlab
import pytest

import mesh_laws
import meshlabserver
import sample_catalogue
from conftest import box, document, sphere
from core_blocks import (
    core_in_float,
    expect_equal,
    expect_rounded,
    expect_saved_edges,
    expect_saved_in_float,
)
from placements import read_mesh
from run_boolean import BLOCKS, run_boolean

if not meshlabserver.is_debian_12():
    pytest.skip("only Debian 12 has meshlabserver 2020.09", allow_module_level=True)

EXAMPLE = meshlabserver.EXAMPLES / "generate_index_boolean.mlx"


@pytest.fixture(scope="module")
def program(tmp_path_factory):
    return meshlabserver.install(tmp_path_factory.mktemp("meshlab-2020.09"))


def sample_paths(*names):
    return [sample_catalogue.FOLDER / f"{name}.ply" for name in names]


def saved(mesh, path):
    mesh_set = pymeshlab.MeshSet()
    mesh_set.add_mesh(pymeshlab.Mesh(*mesh))
    mesh_set.save_current_mesh(str(path))
    return path


def server_blocks(program, files, folder):
    """The four blocks that the example script makes of two files."""
    paths = {block: folder / f"{block}.ply" for block in BLOCKS}
    done = meshlabserver.run(program, files, EXAMPLE, enumerate(paths.values(), start=2))
    assert done.returncode == 0, done.stdout + done.stderr
    nothing = (np.zeros((0, 3)), np.zeros((0, 3), np.int64))
    return {
        block: nothing if b"element vertex 0\n" in path.read_bytes() else read_mesh(path)
        for block, path in paths.items()
    }


@pytest.mark.parametrize("pair", sample_catalogue.PAIRS)
def test_blocksAreThoseOfTheCoreInFloatAndOfPymeshlab(program, tmp_path, pair):
    first, second, _ = sample_catalogue.PAIRS[pair]
    operands = [sample_catalogue.sample(name) for name in (first, second)]
    core, cleaned = core_in_float(operands, tmp_path)
    blocks = server_blocks(program, sample_paths(first, second), tmp_path)
    expect_equal(blocks, core)

    in_double = run_boolean(*operands[0], *operands[1])
    assert cleaned == 0 and in_double["result"]["zero_area_faces_removed"] == 0
    for block in BLOCKS:
        # Diagonals are chosen for the places as stored, so they may be others in float.
        (vertices, faces), (exact, as_many) = blocks[block], in_double[block]
        assert len(faces) == len(as_many), block
        expect_rounded(vertices, exact)


def test_wallsNearerThanFloatsAreAsTheCoreHasThem(program, tmp_path):
    (vertices, faces), angle = sphere(), 1e-7
    x, y, _ = vertices.T
    turned = vertices + angle * np.stack([y, -x, np.ones(len(vertices))], 1)
    operands = [
        (points.astype(np.float32).astype(np.float64), faces) for points in (vertices, turned)
    ]
    core, _ = core_in_float(operands, tmp_path)
    files = [saved(mesh, tmp_path / f"{k}.ply") for k, mesh in enumerate(operands)]
    blocks = server_blocks(program, files, tmp_path)
    expect_equal(blocks, core)
    for block, (vertices, faces) in blocks.items():
        assert len(faces) > 0 and mesh_laws.unmatched_edges(vertices, faces) == 0, block
        assert len(mesh_laws.zero_area_faces(vertices, faces)) == 0, block


def edited_example(tmp_path, *changes):
    """The example script with some parameters' values changed."""
    text = EXAMPLE.read_text()
    for name, value in changes:
        text, count = re.subn(rf'(name="{name}" value=)"[^"]*"', rf'\1"{value}"', text)
        assert count == 1
    script = tmp_path / "edited.mlx"
    script.write_text(text)
    return script


@pytest.mark.parametrize(
    "changes, sentence",
    [
        ([("second_mesh", 0)], '"bar.ply" (id 0) is given as both first_mesh and second_mesh'),
        ([("octree_max_depth", 77)], "octree_max_depth is 77. Choose a number from 1 to 20."),
        ([(block, "false") for block in BLOCKS], "No block is asked for."),
    ],
    ids=["same_layer", "out_of_range", "nothing_asked"],
)
def test_refusalEndsWith255AndItsSentenceInTheLog(program, tmp_path, changes, sentence):
    script, output = edited_example(tmp_path, *changes), tmp_path / "none.ply"
    done = meshlabserver.run(program, sample_paths("bar", "two_balls"), script, [(0, output)])
    assert done.returncode == 255
    logged = [line for line in done.stderr.splitlines() if line.startswith("LOG")]
    assert any(sentence in line for line in logged)
    assert not output.exists()


def test_openLayerIsRefusedWithWhatToDo(program, tmp_path):
    vertices, faces = box((0, 0, 0), (1, 1, 1))
    files = [saved((vertices, faces[:-1]), tmp_path / "open.ply"), *sample_paths("bar")]
    done = meshlabserver.run(program, files, EXAMPLE)
    assert done.returncode == 255
    assert re.search(r'LOG: .*"open.ply" \(id 0\) .*generate_index_boolean_split', done.stderr)


@pytest.mark.parametrize("names", [(), ("bar",)], ids=["none", "one"])
def test_tooFewMeshesEndWith255(program, names):
    done = meshlabserver.run(program, sample_paths(*names), EXAMPLE)
    assert done.returncode == 255, done.stderr


def script_parameters(script):
    """(the filter's name, {parameter: value}) of a script with one filter."""
    (filter_element,) = ElementTree.parse(script).getroot().iter("filter")
    values = {p.get("name"): p.get("value") for p in filter_element.iter("Param")}
    return filter_element.get("name"), values


def plugin_filters():
    return [name for name in pymeshlab.filter_list() if "_index_boolean" in name]


# What the examples give: layers, and an expression over them.
GIVEN = {
    "first_mesh", "second_mesh", "points_mesh", "reference_mesh", "mesh", "expression",
}


def script_value(default):
    """A parameter's default as scripts have it."""
    return f"{default:g}" if isinstance(default, float) else str(default).lower()


def test_everyFilterHasAnExampleThatListsItsParametersAtTheirDefaults(plugin):
    filters = plugin_filters()
    assert filters
    meshes = document(box((0, 0, 0), (1, 1, 1)))
    for name in filters:
        defaults = meshes.filter_parameter_values(name)
        _, values = script_parameters(meshlabserver.EXAMPLES / f"{name}.mlx")
        assert list(values) == list(defaults), name
        for parameter in values.keys() - GIVEN:
            assert values[parameter] == script_value(defaults[parameter]), parameter


def applied_in_pymeshlab(files, script):
    """The document with the layers, those of the files first."""
    meshes = pymeshlab.MeshSet()
    for file in files:
        meshes.load_new_mesh(str(file))
    meshes.load_filter_script(str(script))
    meshes.apply_filter_script()
    return meshes


@pytest.mark.parametrize(
    "script", sorted(meshlabserver.EXAMPLES.glob("compute_*.mlx")), ids=lambda script: script.stem
)
def test_exampleMeasuresTheSameInBothHosts(program, tmp_path, script):
    files = sample_paths("bumpy_sphere", "ribbed_torus")
    meshes = applied_in_pymeshlab(files, script)
    path = tmp_path / "first.ply"
    done = meshlabserver.run(program, files, script, [(0, path)], mask=("vq", "fq"))
    assert done.returncode == 0, done.stderr
    saved_meshes = pymeshlab.MeshSet()
    saved_meshes.load_new_mesh(str(path))
    found, expected = saved_meshes.current_mesh(), meshes.mesh(0)
    assert np.ptp(expected.vertex_scalar_array()) > 0.1
    assert np.allclose(
        found.vertex_scalar_array(), expected.vertex_scalar_array(), rtol=0, atol=1e-6
    )


@pytest.mark.parametrize(
    "script", sorted(meshlabserver.EXAMPLES.glob("generate_*.mlx")), ids=lambda script: script.stem
)
def test_exampleGivesTheSameLayersInBothHosts(program, tmp_path, script):
    files = sample_paths("bumpy_sphere", "ribbed_torus")
    meshes = applied_in_pymeshlab(files, script)
    assert meshes.mesh_number() > 2
    paths = [(k, tmp_path / f"{k}.ply") for k in range(meshes.mesh_number())]
    has_edges = script.stem == "generate_index_boolean_curves"
    edge_paths = [(2, tmp_path / "2.obj")] if has_edges else []
    done = meshlabserver.run(program, files, script, paths + edge_paths)
    assert done.returncode == 0, done.stderr
    for (_, path), layer in zip(paths, meshes):
        assert layer.vertex_number() > 0
        expect_saved_in_float(path, layer)
    for k, path in edge_paths:
        expect_saved_edges(path, meshes.mesh(k))
