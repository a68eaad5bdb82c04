# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the documents claim of the code: stages in order, links and commands that exist."""

import re
import subprocess
import sys
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
    known = (
        "vcg_ext/", "filter_indexboolean/", "tests/", "tools/", "bench/", "sample_meshes/", "docs/",
        "python/",
    )
    named = re.findall(r"`([\w./-]+)[^`]*`", page.read_text())
    missing = [n for n in named if n.startswith(known) and not (ROOT / n).exists()]
    assert not missing


def test_picturesAreSmall():
    pictures = list((ROOT / "docs").glob("*.png"))
    assert pictures and all(picture.stat().st_size < 300_000 for picture in pictures)


def test_readmeExampleRuns(tmp_path):
    code = (ROOT / "README.md").read_text().split("```python\n")[1].split("```")[0]
    (tmp_path / "sample_meshes").symlink_to(ROOT / "sample_meshes")
    (tmp_path / "out").mkdir()
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=tmp_path, capture_output=True, text=True, timeout=120
    )
    assert done.returncode == 0, done.stderr
    volume, residual = done.stdout.split()[-2:]
    assert float(volume) == pytest.approx(3.151693102184, rel=1e-11)
    assert float(residual) < 1e-12
    assert (tmp_path / "out" / "difference.ply").stat().st_size > 0
