# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How Sphinx makes the site of the repository's Markdown files; tools/site calls it."""

import re
from pathlib import Path

project = "Index Boolean"
author = "The Index Boolean authors"
copyright = "2026 The Index Boolean authors; GPL-3.0-or-later"
_cmake = (Path(__file__).resolve().parents[2] / "CMakeLists.txt").read_text(encoding="utf-8")
version = release = re.search(r"VERSION (\d+\.\d+\.\d+)", _cmake)[1]

extensions = ["myst_parser"]
root_doc = "index"
html_theme = "furo"
html_copy_source = False
# Headings have the anchors that they have where the repository is read.
myst_heading_anchors = 4
