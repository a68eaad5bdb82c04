# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A user of MeshLab's window: the filter is found, its dialog applied, its layers saved.

INDEXBOOLEAN_GUI_TREE names the Debian tree that tools/gui_tree has made; else this is skipped.
INDEXBOOLEAN_GUI_PICTURES may name a folder that the documents' pictures are then written to.
"""

import os
import shutil
import subprocess
from pathlib import Path

import pymeshlab
import pytest

import gui_driver
import meshlabserver
import sample_catalogue
from core_blocks import core_in_float, expect_equal
from placements import read_mesh
from run_boolean import BLOCKS

if "INDEXBOOLEAN_GUI_TREE" not in os.environ:
    pytest.skip("slow: tools/test --long runs it, as root", allow_module_level=True)

TREE = Path(os.environ["INDEXBOOLEAN_GUI_TREE"])
TITLE = "Index Boolean: Union"
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


def show_menu(meshlab):
    """The Filters menu with the submenu that has the filter."""
    screen = meshlab.screen
    screen.click(meshlab.main, 113, 10)
    screen.click(meshlab.main, 250, 149)
    picture(screen, "gui_menu.png")
    screen.keys("Escape", "Escape")


def show_one_block(meshlab):
    """Hides all layers but the first difference."""
    for position in (0, 1, 2, 3, 5):
        meshlab.screen.click(meshlab.main, 876, meshlab.layer_row(position))
    picture(meshlab.screen, "gui_result.png")


def apply_boolean(meshlab, dialog_picture):
    meshlab.search_filter("index boolean union")
    meshlab.open_found_filter(TITLE)
    picture(meshlab.screen, dialog_picture)
    meshlab.apply_filter()
    meshlab.close_dialog()
    for label in LABELS.values():
        assert len(meshlab.logged(f'"{label}": ')) == 1


def expect_saved_blocks(folder, tmp_path):
    """The folder holds the four blocks, as the core's float run gives them, and both layers."""
    operands = [sample_catalogue.sample(name) for name in NAMES]
    core, _ = core_in_float(operands, tmp_path)
    expect_equal(
        {block: read_mesh(folder / f"{label}.ply") for block, label in LABELS.items()}, core
    )
    for name, (vertices, faces) in zip(NAMES, operands):
        saved = read_mesh(folder / f"{name}.ply")
        assert (saved[0] == vertices).all() and (saved[1] == faces).all(), "an operand was changed"


def test_window2025FindsAppliesAndSavesFourLayers(tmp_path):
    folder = fresh_folder(TREE / "root/test")
    install_for_window_2025()
    files = [f"{name}.ply" for name in NAMES]
    with gui_driver.screen() as screen, window_2025(
        screen, folder, tmp_path / "log", *files
    ) as meshlab:
        open_both(meshlab)
        show_menu(meshlab)
        apply_boolean(meshlab, "gui_dialog.png")
        meshlab.save_project_and_all_layers("/root/test/result.mlp")
        show_one_block(meshlab)
    project = (folder / "result.mlp").read_text()
    assert project.count("<MLMesh ") == 6
    assert all(f'label="{label}"' in project for label in LABELS.values())
    expect_saved_blocks(folder, tmp_path)


def test_window2025SaysWhyItRefusesALayerAndGoesOn(tmp_path):
    folder = fresh_folder(TREE / "root/test")
    write_with_a_hole(folder / "open.ply")
    install_for_window_2025()
    with gui_driver.screen() as screen, window_2025(
        screen, folder, tmp_path / "log", "open.ply", f"{NAMES[1]}.ply"
    ) as meshlab:
        open_both(meshlab)
        meshlab.search_filter("index boolean union")
        meshlab.open_found_filter(TITLE)
        meshlab.press_apply_and_confirm_message()
        meshlab.wait_for_log('Layer "open.ply" (id 0) is not closed')
        meshlab.close_dialog()
        screen.click(meshlab.main, 960, meshlab.layer_row(0))
        picture(screen, "gui_refusal.png")
        assert meshlab.process.poll() is None


@pytest.mark.skipif(not meshlabserver.is_debian_12(), reason="only Debian 12 has MeshLab 2020.09")
def test_window2020FindsAndAppliesTheSameFilter(tmp_path):
    folder = fresh_folder(tmp_path / "test")
    program = meshlabserver.install(tmp_path / "prefix").with_name("meshlab")
    command = [program, *(f"{name}.ply" for name in NAMES)]
    with gui_driver.screen() as screen, gui_driver.running(
        screen, "2020.09", command, folder, tmp_path / "log"
    ) as meshlab:
        open_both(meshlab)
        apply_boolean(meshlab, "gui_2020_dialog.png")
        picture(screen, "gui_2020_result.png")
