# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""readme_benchmark.py: writes README.md's extract of the tables that docs/benchmark.md holds.

in: the part of docs/benchmark.md between <!-- measured --> and its end; out: README.md
with, between <!-- benchmark --> and its end, its first paragraph and the rows of CASES. So figures
are written by hand, or by another script, in one place. tests/python/test_docs.py compares both.
"""

from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
PAGE, README = ROOT / "docs" / "benchmark.md", ROOT / "README.md"
CASES = ("sphere ∪ sphere", "armadillo − bunny100k", "908460 − 73416", "terrain cut by sheet")


def part(text, name):
    """(what comes before, the part itself, what comes after) between the comments of that name."""
    start, end = f"<!-- {name} -->\n", f"<!-- /{name} -->"
    before, found, rest = text.partition(start)
    inside, closed, after = rest.partition(end)
    if not found or not closed:
        raise ValueError(f"there is no {start.strip()} … {end}")
    return before + start, inside, end + after


def extract(measured):
    """The first paragraph, and each table with the rows of CASES alone."""
    paragraphs = measured.strip().split("\n\n")
    tables = [lines for text in paragraphs if (lines := text.splitlines())[0].startswith("|")]
    kept = [
        [*lines[:2], *(line for line in lines[2:] if line.strip("| ").startswith(CASES))]
        for lines in tables
    ]
    shown = ["\n".join(lines) for lines in kept if len(lines) > 2]
    return "\n\n".join([paragraphs[0], *shown]) + "\n"


def readme_with_extract():
    """README.md as it ought to be."""
    _, measured, _ = part(PAGE.read_text(encoding="utf-8"), "measured")
    before, _, after = part(README.read_text(encoding="utf-8"), "benchmark")
    return before + extract(measured) + after


if __name__ == "__main__":
    README.write_text(readme_with_extract(), encoding="utf-8")
