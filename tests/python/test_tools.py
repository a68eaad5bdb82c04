# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What tools/gui_tree says where it cannot make its tree: the truth."""

import os
import shutil
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
COMMANDS = ("sh", "realpath", "dirname", "grep", "nproc", "mkdir", "rm", "tail", "head", "sed")


@pytest.fixture
def commands(tmp_path):
    """A folder with what the script calls, but for debootstrap and apt."""
    folder = tmp_path / "bin"
    folder.mkdir()
    for name in COMMANDS:
        (folder / name).symlink_to(shutil.which(name))
    return folder


def make_tree(commands, tree):
    environment = {**os.environ, "PATH": str(commands)}
    return subprocess.run(
        [ROOT / "tools/gui_tree", tree], capture_output=True, text=True, env=environment,
        timeout=60,
    )


def test_guiTreeNamesThePackageThatIsAbsent(commands, tmp_path):
    done = make_tree(commands, tmp_path / "tree")
    assert done.returncode == 1
    assert "debootstrap is absent" in done.stderr
    assert "moved on" not in done.stderr


def test_guiTreeStopsAtTheFirstStepThatFails(commands, tmp_path):
    """It went on and blamed Debian for having moved on."""
    for name, status in (("debootstrap", 3), ("apt-get", 0), ("chroot", 0)):
        script = f"#!/bin/sh\necho {name} >> {tmp_path}/called\nexit {status}\n"
        (commands / name).write_text(script)
        (commands / name).chmod(0o755)
    done = make_tree(commands, tmp_path / "tree")
    assert done.returncode == 1
    assert "could not be made" in done.stderr
    assert "moved on" not in done.stderr
    assert "chroot" not in (tmp_path / "called").read_text()
    assert not (tmp_path / "tree/done").exists()
