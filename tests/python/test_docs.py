# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the documents claim of the code: stages in order, links and commands that exist."""

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PAGES = [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]


def stage_table():
    text = (ROOT / "docs" / "architecture.md").read_text()
    table = text.split("<!-- stages -->")[1].split("<!-- /stages -->")[0]
    rows = [line.split("|") for line in table.strip().splitlines()[2:]]
    return [(row[1].strip(), row[2].strip(" `")) for row in rows]


def test_stage_table_has_the_drivers_stages_in_the_drivers_order():
    driver = (ROOT / "vcg_ext" / "index_boolean.cpp").read_text()
    run = re.findall(r'stages\.run\("(\w+)"', driver)
    assert [stage for stage, _ in stage_table()] == [*run, "audit"]


def test_every_stage_is_a_file_pair():
    for _, name in stage_table():
        assert (ROOT / "vcg_ext" / f"{name}.h").is_file(), name
        assert (ROOT / "vcg_ext" / f"{name}.cpp").is_file(), name


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_links_lead_to_files(page):
    links = re.findall(r"\]\((?!https?:|#)([^)#]+)", page.read_text())
    missing = [link for link in links if not (page.parent / link).exists()]
    assert not missing


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_paths_named_in_code_style_exist(page):
    known = ("vcg_ext/", "tests/", "tools/", "bench/", "sample_meshes/", "docs/", "python/")
    named = re.findall(r"`([\w./-]+)[^`]*`", page.read_text())
    missing = [n for n in named if n.startswith(known) and not (ROOT / n).exists()]
    assert not missing
