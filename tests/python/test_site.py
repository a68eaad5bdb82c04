# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""tools/site: every page of the repository is in the site, and broken links end it."""

import re
import shutil
import subprocess
import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

import pytest

ROOT = Path(__file__).resolve().parents[2]


def build(checkout, site):
    return subprocess.run(
        [checkout / "tools/site", site], capture_output=True, text=True, timeout=300
    )


class Page(HTMLParser):
    """The links and the anchors of one page."""

    def __init__(self, path):
        super().__init__()
        self.links, self.anchors = [], set()
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.anchors |= {attributes.get("id"), attributes.get("name")}
        for key in ("href", "src"):
            if attributes.get(key):
                self.links.append(attributes[key])


@pytest.fixture(scope="module")
def site(tmp_path_factory):
    folder = tmp_path_factory.mktemp("site")
    done = build(ROOT, folder)
    assert done.returncode == 0, done.stdout + done.stderr
    return folder


def test_everyPageIsThere(site):
    sources = [*ROOT.glob("*.md"), *(ROOT / "docs").glob("*.md")]
    for source in sources:
        page = site / source.relative_to(ROOT).with_suffix(".html")
        title = re.search(r"<title>(.*?)</title>", page.read_text(encoding="utf-8"), re.S)[1]
        heading = re.search(r"^# (.*)$", source.read_text(encoding="utf-8"), re.M)[1]
        words = set(re.findall(r"[A-Za-z]{4,}", heading.replace("`", "")))
        assert words and words <= set(re.findall(r"[A-Za-z]{4,}", title)), source.name


def test_linksWithinTheSiteLeadToPagesAndHeadings(site):
    pages = {path: Page(path) for path in site.rglob("*.html") if path.name != "404.html"}
    checked = 0
    for path, page in pages.items():
        for link in page.links:
            parts = urlsplit(link)
            if parts.scheme or parts.netloc:
                continue
            target = (path.parent / unquote(parts.path)).resolve() if parts.path else path
            target = target / "index.html" if target.is_dir() else target
            assert target.exists(), f"{path.name}: {link}"
            if parts.fragment and target in pages:
                assert unquote(parts.fragment) in pages[target].anchors, f"{path.name}: {link}"
            checked += 1
    assert checked > 200


def test_nothingIsFetchedFromElsewhere(site):
    for path in site.rglob("*.html"):
        text = path.read_text(encoding="utf-8")
        fetched = re.findall(r'<(?:script|img|link rel="stylesheet")[^>]*(?:src|href)="http', text)
        assert not fetched, path.name


@pytest.mark.parametrize(
    "link", ["[x](docs/nowhere.md)", "[x](docs/split.md#nowhere)", "![x](docs/nowhere.png)"]
)
def test_brokenLinkEndsTheBuild(tmp_path, link):
    checkout = tmp_path / "checkout"
    folders = ("docs", "tools", "bench", "sample_meshes", "vcg_ext", "filter_indexboolean")
    for folder in folders:
        shutil.copytree(ROOT / folder, checkout / folder, ignore=shutil.ignore_patterns("*.ply"))
    files = ("LICENSE", "CITATION.cff", "CMakeLists.txt")
    for file in (*ROOT.glob("*.md"), *(ROOT / name for name in files)):
        shutil.copy(file, checkout)
    (checkout / ".venv").symlink_to(Path(sys.prefix))
    with open(checkout / "README.md", "a") as readme:
        readme.write(f"\n{link}\n")
    done = build(checkout, tmp_path / "site")
    assert done.returncode != 0
    assert "nowhere" in done.stdout + done.stderr
