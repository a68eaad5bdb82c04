# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A user of MeshLab's window: each filter is found, its dialog applied, its layers saved.

INDEXBOOLEAN_GUI_TREE names the Debian tree that tools/gui_tree has made; else this is skipped.
INDEXBOOLEAN_GUI_PICTURES may name a folder that the documents' pictures are then written to.
"""

import contextlib
import os
import shutil
import subprocess
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pymeshlab
import pytest

import gui_driver
import meshlabserver
import sample_catalogue
from conftest import document
from core_blocks import core_in_float, expect_equal, expect_saved_edges, expect_saved_in_float
from placements import read_mesh
from run_boolean import BLOCKS
from split_run import Split

if "INDEXBOOLEAN_GUI_TREE" not in os.environ:
    pytest.skip("slow: tools/test --long runs it, as root", allow_module_level=True)

TREE = Path(os.environ["INDEXBOOLEAN_GUI_TREE"])
NAMES = ("bumpy_sphere", "ribbed_torus")
LABELS = dict(
    zip(
        BLOCKS,
        (
            "bumpy_sphere union ribbed_torus",
            "bumpy_sphere intersection ribbed_torus",
            "bumpy_sphere minus ribbed_torus",
            "ribbed_torus minus bumpy_sphere",
        ),
    )
)
PIECES = (
    "bumpy_sphere cut by ribbed_torus",
    "ribbed_torus cut by bumpy_sphere",
    "bumpy_sphere blocks ribbed_torus",
)
CURVES = "bumpy_sphere curves ribbed_torus"


class Filter(NamedTuple):
    """How a user finds a filter, and the layers that it adds, if any."""

    words: str  # that are searched for
    title: str  # of its dialog, how it begins
    labels: tuple


FILTERS = {
    "generate_index_boolean": Filter(
        "index boolean union", "Index Boolean: Union", tuple(LABELS.values())
    ),
    "generate_index_boolean_split": Filter(
        "index boolean split", "Index Boolean: Split", PIECES
    ),
    "generate_index_boolean_curves": Filter(
        "index boolean curves", "Index Boolean: Intersection Curves", (CURVES,)
    ),
    "generate_index_boolean_expression": Filter(
        "index boolean expression", "Index Boolean: Expression", ("union(visible)",)
    ),
    "generate_index_boolean_resolve": Filter(
        "index boolean resolve", "Index Boolean: Resolve", (f"{NAMES[1]} resolved",)
    ),
}
BOOLEAN, SPLIT, CURVE, EXPRESSION, RESOLVE = FILTERS.values()
MEASURES = {
    "compute_index_boolean_distance": Filter(
        "index boolean signed distance", "Index Boolean: Signed Distance", ()
    ),
    "compute_index_boolean_implicit": Filter(
        "index boolean implicit", "Index Boolean: Implicit Function", ()
    ),
}


def picture(screen, name):
    if folder := os.environ.get("INDEXBOOLEAN_GUI_PICTURES"):
        screen.save_picture(Path(folder) / name)


def fresh_folder(path):
    shutil.rmtree(path, ignore_errors=True)
    path.mkdir(parents=True)
    for name in NAMES:
        shutil.copy(sample_catalogue.FOLDER / f"{name}.ply", path)
    return path


def write_with_a_hole(path):
    vertices, faces = sample_catalogue.sample(NAMES[0])
    middle = vertices[faces].mean(axis=1)
    meshes = pymeshlab.MeshSet()
    meshes.add_mesh(pymeshlab.Mesh(vertices, faces[middle[:, 2] < 0.7 * middle[:, 2].max()]))
    meshes.save_current_mesh(str(path))


def install_for_window_2025():
    subprocess.run(
        [gui_driver.ROOT / "tools/install_gui"], check=True,
        env={**os.environ, "XDG_DATA_HOME": str(TREE / "root/.local/share")},
    )


def window_2025(screen, folder, log, *names):
    """The program in the tree, with files of the folder (a part of the tree) opened."""
    start = f"cd /{folder.relative_to(TREE)} && exec meshlab {' '.join(names)}"
    environment = {"HOME": "/root", "LD_LIBRARY_PATH": "/usr/lib/x86_64-linux-gnu/meshlab"}
    return gui_driver.running(
        screen, "2025.07", ["chroot", TREE, "sh", "-c", start], folder, log, environment
    )


def open_both(meshlab):
    meshlab.wait_for_log("Opened mesh", count=2)
    meshlab.fill_screen()


def show_menu(meshlab):
    """The Filters menu with the submenu that has the filter."""
    screen = meshlab.screen
    screen.click(meshlab.main, 113, 10)
    screen.click(meshlab.main, 250, 149)
    picture(screen, "gui_menu.png")
    screen.keys("Escape", "Escape")


def show_only(meshlab, shown, count, picture_name):
    """Hides all layers but one."""
    for position in set(range(count)) - {shown}:
        meshlab.hide_layer(position)
    picture(meshlab.screen, picture_name)


def apply(meshlab, chosen, dialog_picture):
    meshlab.search_filter(chosen.words)
    meshlab.open_found_filter(chosen.title)
    picture(meshlab.screen, dialog_picture)
    meshlab.apply_filter()
    meshlab.close_dialog()
    for label in chosen.labels:
        assert len(meshlab.logged(f'"{label}": ')) == 1


@contextlib.contextmanager
def both_samples_opened(tmp_path):
    """(MeshLab 2025.07 with two layers, the folder that it is started in)"""
    folder = fresh_folder(TREE / "srv/test")
    install_for_window_2025()
    files = [f"{name}.ply" for name in NAMES]
    with gui_driver.screen() as screen, window_2025(
        screen, folder, tmp_path / "log", *files
    ) as meshlab:
        open_both(meshlab)
        yield meshlab, folder


def samples():
    return [sample_catalogue.sample(name) for name in NAMES]


def expect_project(folder, chosen):
    """The saved project has the operands, unchanged, and the filter's layers."""
    project = (folder / "result.mlp").read_text()
    assert project.count("<MLMesh ") == len(NAMES) + len(chosen.labels)
    assert all(f'label="{label}"' in project for label in chosen.labels)
    for name, (vertices, faces) in zip(NAMES, samples()):
        saved = read_mesh(folder / f"{name}.ply")
        assert (saved[0] == vertices).all() and (saved[1] == faces).all(), "an operand was changed"


def face_colours(path):
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(str(path))
    return meshes.current_mesh().face_color_matrix()


def test_everyFilterIsTriedInTheWindow():
    names = [name for name in pymeshlab.filter_list() if "_index_boolean" in name]
    assert sorted(names) == sorted({**FILTERS, **MEASURES})


def test_window2025AddsTheFourBlocks(tmp_path):
    with both_samples_opened(tmp_path) as (meshlab, folder):
        show_menu(meshlab)
        apply(meshlab, BOOLEAN, "gui_dialog.png")
        meshlab.save_project_and_all_layers("/srv/test/result.mlp")
        show_only(meshlab, 4, 6, "gui_result.png")
    expect_project(folder, BOOLEAN)
    core, _ = core_in_float(samples(), tmp_path)
    expect_equal(
        {block: read_mesh(folder / f"{label}.ply") for block, label in LABELS.items()}, core
    )


def test_window2025AddsSubSurfacesAndSubBlocksWithTheirColours(tmp_path):
    with both_samples_opened(tmp_path) as (meshlab, folder):
        apply(meshlab, SPLIT, "gui_split_dialog.png")
        meshlab.save_project_and_all_layers("/srv/test/result.mlp")
        show_only(meshlab, 4, 5, "gui_split_result.png")
    expect_project(folder, SPLIT)
    in_double = Split(*samples())
    for label, kind in zip(PIECES, ("sub_surfaces_first", "sub_surfaces_second", "sub_blocks")):
        path = folder / f"{label}.ply"
        layer = in_double.mesh_set.mesh(in_double.result[f"{kind}_layer"])
        expect_saved_in_float(path, layer)
        colours = face_colours(path)
        assert np.array_equal(colours, layer.face_color_matrix())
        assert len(np.unique(colours, axis=0)) == in_double.result[kind]


def test_window2025AddsTheCurvesAsEdges(tmp_path):
    with both_samples_opened(tmp_path) as (meshlab, folder):
        apply(meshlab, CURVE, "gui_curves_dialog.png")
        meshlab.save_project_and_all_layers("/srv/test/result.mlp")
        meshlab.save_current_layer("/srv/test/curves.obj")
        meshlab.hide_layer(0)
        picture(meshlab.screen, "gui_curves_result.png")
    expect_project(folder, CURVE)
    in_double = document(*samples())
    added = in_double.generate_index_boolean_curves()
    layer = in_double.mesh(added["curves_layer"])
    expect_saved_in_float(folder / f"{CURVES}.ply", layer)
    expect_saved_edges(folder / "curves.obj", layer)


def test_window2025UnitesWhatIsVisible(tmp_path):
    with both_samples_opened(tmp_path) as (meshlab, folder):
        apply(meshlab, EXPRESSION, "gui_expression_dialog.png")
        meshlab.save_project_and_all_layers("/srv/test/result.mlp")
        show_only(meshlab, 2, 3, "gui_expression_result.png")
    expect_project(folder, EXPRESSION)
    core, _ = core_in_float(samples(), tmp_path)
    _, faces = read_mesh(folder / "union(visible).ply")
    assert len(faces) == len(core["union"][1])


def test_window2025ResolvesTheCurrentLayer(tmp_path):
    with both_samples_opened(tmp_path) as (meshlab, folder):
        apply(meshlab, RESOLVE, "gui_resolve_dialog.png")
        meshlab.save_project_and_all_layers("/srv/test/result.mlp")
    expect_project(folder, RESOLVE)
    vertices, faces = read_mesh(folder / f"{RESOLVE.labels[0]}.ply")
    assert len(faces) == len(samples()[1][1])  # it does not meet itself


@pytest.mark.parametrize("name", MEASURES)
def test_window2025MeasuresOnTheLayersThemselves(tmp_path, name):
    with both_samples_opened(tmp_path) as (meshlab, folder):
        kind = name.removeprefix("compute_index_boolean_")
        apply(meshlab, MEASURES[name], f"gui_{kind}_dialog.png")
        picture(meshlab.screen, f"gui_{kind}_result.png")
        meshlab.choose_layer(0)
        meshlab.save_current_layer("/srv/test/measured.ply")
        meshlab.save_project_and_all_layers("/srv/test/result.mlp")
    expect_project(folder, MEASURES[name])  # no layer is new, and places are as they were
    in_double = document(*samples())
    getattr(in_double, name)()
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(str(folder / "measured.ply"))
    assert np.allclose(
        meshes.current_mesh().vertex_scalar_array(), in_double.mesh(0).vertex_scalar_array(),
        rtol=0, atol=1e-6,
    )


def test_window2025SaysWhyItRefusesALayerAndGoesOn(tmp_path):
    folder = fresh_folder(TREE / "srv/test")
    write_with_a_hole(folder / "open.ply")
    install_for_window_2025()
    with gui_driver.screen() as screen, window_2025(
        screen, folder, tmp_path / "log", "open.ply", f"{NAMES[1]}.ply"
    ) as meshlab:
        open_both(meshlab)
        meshlab.search_filter(BOOLEAN.words)
        meshlab.open_found_filter(BOOLEAN.title)
        meshlab.press_apply_and_confirm_message()
        meshlab.wait_for_log('Layer "open.ply" (id 0) is not closed')
        meshlab.close_dialog()
        meshlab.choose_layer(0)
        picture(screen, "gui_refusal.png")
        assert meshlab.process.poll() is None


@pytest.mark.skipif(not meshlabserver.is_debian_12(), reason="only Debian 12 has MeshLab 2020.09")
@pytest.mark.parametrize("name", [*FILTERS, *MEASURES])
def test_window2020FindsAndAppliesTheSameFilter(tmp_path, name):
    folder = fresh_folder(tmp_path / "test")
    program = meshlabserver.install(tmp_path / "prefix").with_name("meshlab")
    command = [program, *(f"{sample}.ply" for sample in NAMES)]
    with gui_driver.screen() as screen, gui_driver.running(
        screen, "2020.09", command, folder, tmp_path / "log"
    ) as meshlab:
        open_both(meshlab)
        kind = name.removeprefix("generate_index_boolean").replace("compute_index_boolean", "")
        apply(meshlab, {**FILTERS, **MEASURES}[name], f"gui_2020{kind}_dialog.png")
        picture(screen, f"gui_2020{kind}_result.png")
