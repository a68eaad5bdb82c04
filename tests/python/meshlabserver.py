# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""meshlabserver 2020.09 with the plugin, in a private tree, on a screen of its own.

in: mesh files, a filter script, which layers to save where; out: how the program ended.
"""

import os
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PLUGIN = ROOT / "build/release/hosts/meshlab-2020.09/libfilter_indexboolean.so"
EXAMPLES = ROOT / "docs" / "examples"


def is_debian_12():
    """Whether the system's package meshlab is version 2020.09, which tools/setup installs."""
    release = Path("/etc/os-release")
    return release.is_file() and "VERSION_CODENAME=bookworm" in release.read_text()


def install(prefix):
    """The program, in a tree made by tools/install_meshlab_2020."""
    assert PLUGIN.is_file(), f"{PLUGIN} is not built"
    subprocess.run(
        [ROOT / "tools/install_meshlab_2020", prefix, PLUGIN], check=True, capture_output=True
    )
    return Path(prefix) / "bin/meshlabserver"


def run(program, files, script, saved=(), mask=()):
    """Loads files, applies the script, saves layers; saved: pairs of a layer's place and a path.

    mask: what is saved besides, as vq and fq for qualities.
    """
    command = ["xvfb-run", "-a", "-s", "-screen 0 1280x1024x24", program]
    for file in files:
        command += ["-i", file]
    command += ["-s", script]
    for layer, path in saved:
        command += ["-o", path, "-l", layer, *(["-m", *mask] if mask else [])]
    return subprocess.run(
        [str(word) for word in command], capture_output=True, text=True, timeout=120,
        env={**os.environ, "LC_ALL": "C.UTF-8"},
    )
